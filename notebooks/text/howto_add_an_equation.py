# ---
# jupyter:
#   jupytext:
#     cell_metadata_filter: tags,-all
#     formats: ipynb,text//py:percent
#     notebook_metadata_filter: kernelspec,jupytext,-jupytext.text_representation.jupytext_version
#     text_representation:
#       extension: .py
#       format_name: percent
#       format_version: '1.3'
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # How to add an equation
#
# This notebook decides an identity that you found, or doubt: first in a ledger of your own, and then,
# if it is worth keeping, in a chapter of `derivations`.
#
# The example is the quantity that decides the regime of a motion,
#
# $$E = K^2 - 2Hc_2 ,\qquad \dot E = 0,\qquad
# E = c_1(c_1-c_2)\,\Omega_1^2 + c_3(c_3-c_2)\,\Omega_3^2 .$$
#
# ## A context
#
# Every statement has hypotheses. A *context* names quantities, polynomials that vanish, polynomials
# that do not vanish, and time derivatives; it is composed of parts. The chapter on Euler's equations
# already has a part with a body and its rates:

# %%
from derivations import euler_lax, lie_algebra
from rigidsym.proof.algebra import LedgerBuilder, Part, extend

chapters = LedgerBuilder()
lie_algebra.derive(chapters)
euler_lax.derive(chapters)
body = chapters.ledger.contexts["body"]

builder = LedgerBuilder()
mine = Part(definitions={"E": "K_squared - 2*H*c2"}, reading={"E": "K^2 - 2 H c_2"})
builder.open(extend("mine", body, mine))
context = builder.ledger.contexts["mine"]
print("quantities:", ", ".join(context.generators))
print("not zero:  ", ", ".join(context.units))
print("D(Omega1) =", context.rates["Omega1"])

# %% [markdown]
# A context needs a *witness*, a rational point that satisfies it (an empty one would prove
# everything), and its relations have to be closed under $d/dt$. The kernel refuses others.
#
# ## A claim
#
# Both sides as text, `D(…)` for the time derivative. The kernel computes the normal form of the
# difference; the fact carries a certificate that can be checked by multiplying polynomials.

# %%
from rigidsym.proof.kernel import Grade

constant = builder.claim("mine.constant", {"D(E)": "0"}, ["15"])
form = builder.claim("mine.form", {"E": "c1*(c1 - c2)*Omega1**2 + c3*(c3 - c2)*Omega3**2"}, ["15"])
print(constant.id, constant.grade)
print(form.id, form.grade)

# %% [markdown]
# ## A wrong claim
#
# With a wrong sign, the claim is not an identity, and the kernel refuses it. *Undecided* is not
# *refuted*: the normal form may also be nonzero because a hypothesis is missing.

# %%
from rigidsym.proof.kernel import KernelError

WRONG = {"E": "c1*(c1 - c2)*Omega1**2 + c3*(c2 - c3)*Omega3**2"}
try:
    builder.claim("mine.wrong", WRONG, ["15"])
    undecided = ""
except KernelError as error:
    undecided = str(error)
print(undecided)

# %% [markdown]
# To *refute* it, give a point where both sides differ, in exact numbers. It has to satisfy the
# context, and overrides the context's witness where it says something else.

# %%
point = {"c1": "1", "c2": "2", "c3": "5/2", "Omega1": "0", "Omega2": "0", "Omega3": "1"}
not_so = builder.refute("mine.not_so", WRONG, point, ["15"])
print(not_so.id, not_so.kind, not_so.grade)

try:
    builder.refute("mine.never", {"E": "K_squared - 2*H*c2"}, point)
    disagreed = ""
except KernelError as error:
    disagreed = str(error)
print(disagreed)

# %% [markdown]
# ## Checked again
#
# A ledger is a text, and any kernel can read it. The second checker shares no code with the first.

# %%
from rigidsym.proof.checker import check
from rigidsym.proof.kernel import replay

written = builder.ledger.to_text()

# %% [markdown]
# A changed text is refused:

# %%
forged = written.replace("c3*(c3 - c2)*Omega3**2", "c3*(c3 + c2)*Omega3**2")
try:
    replay(forged)
    refused = ""
except KernelError as error:
    refused = str(error)
print(refused)

# %% [markdown]
# ## Displaying facts
#
# As mathematics, with their grades:

# %%
from rigidsym.proof.claims import claims

mine = claims(builder.ledger)
mine

# %% [markdown]
# ## Adding it to the project
#
# 1. Put `builder.open` and `builder.claim` into the chapter of `derivations` where they belong (a new
#    chapter goes into `CHAPTERS` in `derivations/__init__.py`).
# 2. If the paper prints the equation, put its LaTeX into the names of the context in its section of
#    `rigidsym/proof/paper`, by a `Sense`: the kernel then decides the print itself.
# 3. `rigidsym derive --in-place` proves everything again and seals the ledger; `rigidsym check` and
#    `rigidsym check --independent` replay it.
# 4. If numbers are to be computed with it, list it in `derivations/publish.py`.

# %% tags=["hide-cell"]
assert context.rates["Omega1"] == "Omega2*Omega3*(c2 - c3)/c1"
assert constant.grade == form.grade == Grade.PROVED
assert "undecided" in undecided
assert "mine.wrong" not in builder.ledger.facts
assert (not_so.kind, not_so.grade) == ("unequal", Grade.PROVED)
assert "agree" in disagreed
assert set(replay(written).facts) == {"mine.constant", "mine.form", "mine.not_so"}
assert check(written) == 3
assert forged != written
assert refused
assert {mine[name].grade for name in ("mine.constant", "mine.form")} == {"PROVED"}
