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
# # 1. The paper, line by line
#
# A tennis racket that is thrown with a spin about its middle axis flips over again and again,
# although no torque acts on it. The paper behind this project gives that motion in closed form. It
# puts Euler's equations into a **Lax pair** on the group $SU(2)$, turns the angular momentum onto
# one fixed axis, and is left with a single integral, an elliptic integral of the third kind.
#
# This page goes through every numbered equation. For each of them it shows
#
# * the equation **exactly as printed**, misprints kept;
# * a **verdict**, and the hypotheses under which it holds;
# * where the print is wrong: what the derivation puts **in its place**, and an exact
#   **counterexample**, a point with rational coordinates at which both sides differ;
# * the names of the **facts** that the verdict rests on. Each fact is an identity, or the
#   refutation of one. A small kernel has decided it, and decides it once more below;
# * the **line as derived**, from the basis (4) and the kinetic energy on, without the print. In
#   most lines SymPy finds the right-hand side; the others state what is to be shown, such as
#   $\dot M=[M,\Omega]$. The kernel decides both.
#
# Only the prose on this page is typed by hand. Equations, verdicts and counterexamples come from
# `rigidsym.proof.paper` and from the ledger of facts; `rigidsym errata` prints the same in a
# terminal. The lines come from a derivation that runs in a cell below. The next notebooks go
# through it step by step: [from the Lax pair to $KA_1$](02_from_lax_pair_to_k_a1.ipynb) and [the
# $\phi_1$ integral and $\Pi$](03_the_phi1_integral_and_pi.ipynb).

# %% [markdown]
# ## The meaning of a verdict
#
# A *context* lists assumptions: some quantities, the relations they satisfy
# ($\mathrm{cn}^2+\mathrm{sn}^2=1$), how they move
# ($\dot{\mathrm{sn}}=\xi\,\mathrm{cn}\,\mathrm{dn}$), and which quantities are not zero. A *fact*
# is a statement in a context, with a grade. `PROVED` means that left side minus right side is a
# combination of the relations; the factors of that combination are kept as a *certificate*. Anyone
# can check the fact by multiplying them out, and need not trust the programs that found them.
# `ENCLOSED` is weaker: a result quoted from the literature, tested with rigorous interval
# arithmetic.
#
# In the next cell, a fresh kernel checks every fact of the ledger in this way.

# %%
from collections import Counter

from rigidsym.proof.derivation import derive
from rigidsym.proof.paper import Ruling
from support import grades, judged, sealed, table
from support.steps import Setting, display

ledger, verdict = sealed(), judged()

count = Counter(v.ruling for v in verdict.values())
display(table({"verdict": str(ruling), "printed lines": count[ruling]} for ruling in Ruling))

# %% [markdown]
# *Holds*: true as printed. *Holds if*: true under hypotheses that the paper does not state.
# *Misprint*: refuted as printed, and proved when mended. *Ambiguous*: the words can be read in
# several ways, of which some hold and some fail.

# %% [markdown]
# ## The derivation
#
# The next cell runs the chapters of `derivations` that compute: from the basis (4) and the
# Lagrangian to Theorem 1. All choices are in the `Setting`; `Setting()` has the paper's. **Change
# it and run on**: with `Setting(sequence=(3, 1, 3), axis=3)` or `Setting(sign=-1)`, all lines below
# are those of another derivation. The verdicts do not change, because they are about the printed
# equations.

# %%
setting = Setting()

derivation = derive(setting=setting)
table(
    {
        "chapter": chapter.name,
        "": chapter.title,
        "lines": len(chapter.facts),
        "computed": chapter.standings["computed"],
    }
    for chapter in derivation.chapters
)

# %%
chapters = {chapter.name: chapter.steps for chapter in derivation.chapters}
shown, told = [], []


def pages(*numbers, chapter=""):
    """Show the verdicts on some equations, then the lines of a chapter about them, each once."""
    for number in numbers:
        display(verdict[number])
    shown.extend(numbers)
    for step in chapters.get(chapter, ()):
        if {*step.source} & {*numbers} and step not in told:
            told.append(step)
            display(step)


# %% [markdown]
# ## Rotations as unit quaternions: (1) to (4)
#
# A rotation is stored as a $2\times2$ matrix $R$ in $SU(2)$. Such a matrix is a unit quaternion in
# another notation: four real numbers whose squares add up to one. The basis $A_1,A_2,A_3$ of the
# Lie algebra is scaled by $\tfrac12$ so that the bracket of two matrices is the cross product of
# two vectors. Everything below can therefore be read as mechanics in $\mathbb R^3$.

# %%
pages("1", "2", "3", "4", chapter="lie_algebra")

# %% [markdown]
# ## Euler's equations and what they conserve: (5) and (6)
#
# In body axes, the derivative of each rate is a multiple of the product of the other two. Energy
# $H$ and momentum $K$ are constant; the curve $\Omega(t)$ therefore runs along the intersection of
# an ellipsoid with a sphere of momenta, and everything that follows uses these two numbers.

# %%
pages("5", "6", chapter="euler_lax")

# %% [markdown]
# ## The Lax pair: (7) to (9)
#
# $\dot M=[M,\Omega]$ is Euler's equations written as a matrix equation. Its solution is a
# *conjugation* $M(t)=R^{-1}M(0)R$: in space the momentum is constant. Here the first hypothesis is
# needed. $RMR^{-1}$ is constant for every motion, but the constant is $M(0)$ only where $R(0)$ and
# $M(0)$ commute. The paper considers motions that start at $R(0)=e$; the counterexample starts
# elsewhere.

# %%
pages("7", "8", "9", chapter="euler_lax")

# %% [markdown]
# ## Lemma 1, one rate alone: (10) to (12)
#
# By (6) the square of $\dot\Omega_i$ is a quadratic polynomial in $\Omega_i^2$, with roots $s_i$
# and $s_j$: this is the differential equation of Jacobi's $\mathrm{sn}$. The paper's roots are
# those of a polynomial in $\Omega_i^2$, while its formulas divide by $c_i$ as if they were roots in
# $(c_i\Omega_i)^2$. **Only one of these can be right.** The error is large: with moments of inertia
# near $0.01\ \mathrm{kg\,m^2}$ the printed rates are a hundred times too large.
#
# Two repairs are possible: drop $c_i$ wherever it divides a root, line by line, or move a single
# $c_i^2$ in (14), which mends all the lines at once. The second is the smaller one.

# %%
pages("Lemma 1", "10", "11", "footnote 1", chapter="lemma1")

# %%
pages("12", "footnote 2", chapter="lemma1")

# %% [markdown]
# ## The constants of Lemma 1: (13) to (15)
#
# The polynomial (14) and its roots (13) are right, as a polynomial in $\Omega_i^2$, for bodies with
# three different moments of inertia. If two of them are equal, $\alpha=0$ and there is no quadratic
# to solve.

# %%
pages("13", "14", "15", chapter="lemma1")

# %% [markdown]
# ## Which sign? Remark 1, (16) and (17)
#
# $\mathrm{sn}$ takes each value twice in a period, once going up and once going down. An inverse
# function cannot tell these apart, so the formula needs a sign: the one that gives
# $\dot\Omega_i(0)$ the sign that follows from Euler's equations.

# %%
pages("Remark 1", "16", "17", chapter="lemma1")

# %% [markdown]
# ## Theorem 1, the attitude: (18) and (19)
#
# The quaternion is built from half angles of $\phi_1,\phi_2,\phi_3$. The products in (18) are
# right. The error is in the half angle of $\phi_3$: $y^\star=y/(1+\sqrt{1+y^2})$ is
# $\tan(\phi_3/2)$ only for angles between $-\pi/2$ and $\pi/2$, that is while $c_3\Omega_3>0$. No
# choice of *constant* signs $S_i$ takes the formula past a zero of $\Omega_3$, and $\Omega_3$ has
# two zeros in every period, unless the body circulates about axis 3.

# %%
pages("Theorem 1", "18", "19", chapter="theorem1")

# %% [markdown]
# ## The third kind: (20) and (21)
#
# The characteristic $n$ of $\Pi(n;\vartheta|m)$ has the same error as Lemma 1: the two kinds of
# roots are confused.

# %%
pages("20", "21", chapter="winding")

# %% [markdown]
# ## Signs again: Remark 2 and footnote 3
#
# $S_1S_2$ has to be the sign of $c_3\Omega_3$ and has to change with it; at each change, $\phi_1$
# has to jump by $\pi$. This has nothing to do with the orientation of a frame, which does not
# depend on the signs.

# %%
pages("Remark 2", "footnote 3")

# %% [markdown]
# ## The proof, first half: (22) to (29)
#
# Choose the frame in space so that the momentum lies along $A_1$. The momentum in the body then
# determines two of the three angles without any integration. [Notebook
# 2](02_from_lax_pair_to_k_a1.ipynb) goes through this step by step.

# %%
pages("22", "23", "24", "25", "26", chapter="conjugacy")

# %%
pages("27", "28", "29", chapter="conjugacy")

# %% [markdown]
# ## The proof, second half: (30) to (36)
#
# The third angle is an integral, which [notebook 3](03_the_phi1_integral_and_pi.ipynb) derives.
# There are two misprints here. (35) and (36) have $\mu^2$ for $\mu$, a modulus where the rest of
# the paper has a parameter. (36) has $\dot\phi_1$ for $\phi_1$ on its left side.

# %%
pages("R^-1 dR/dt", "30", "31", "32", "33", chapter="kinematics")

# %%
pages("34", "35", "36", chapter="phi1_integral")

# %% [markdown]
# ## Any initial attitude: Remark 3 and (37)

# %%
pages("Remark 3", "37")

# %% [markdown]
# ## The misprints on one page
#
# A search tried small edits of every refuted line: a sign, an index, a power, a factor. The last
# column shows what it found and the kernel then proved, written with the names of the contexts.

# %%
misprints = [v for v in verdict.values() if v.ruling == Ruling.MISPRINT]
display(
    table(
        {
            "": f"({v.equation.number})" if v.equation.number[0].isdigit() else v.equation.number,
            "in its place": f"${v.equation.repair}$",
            "found by search": "<br>".join(f"`{text}`" for text in v.repairs),
        }
        for v in misprints
    )
)

# %% [markdown]
# Every printed line has appeared on this page once, and none is open. Every fact that a verdict
# rests on is proved in the ledger that was replayed at the top. (The last cell, folded, checks
# that.)

# %% tags=["hide-cell"]
assert sorted(shown) == sorted(verdict)
assert all(v.ruling != Ruling.OPEN for v in verdict.values())
rested_on = [name for v in verdict.values() for name in v.facts()]
assert grades(ledger, *rested_on) == {"PROVED"}
assert all(v.counterexample for v in misprints)
# The derivation has lines of its own for all but (17) and (37), and all of its lines are proved.
steps = [step for chapter in chapters.values() for step in chapter]
assert {step.fact.grade for step in steps} == {"PROVED"}
assert {*map(str, range(1, 37))} - {"17"} <= {number for step in told for number in step.source}
