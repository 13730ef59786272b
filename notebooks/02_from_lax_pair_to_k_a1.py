# ---
# jupyter:
#   jupytext:
#     cell_metadata_filter: tags,-all
#     formats: ipynb,py:percent
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
# # From the Lax pair to $KA_1$
#
# The attitude of a free body has three degrees of freedom, and one would expect three integrations.
# The paper needs one. The reason is the conservation of angular momentum *as a vector in space*: turn
# the frame so that this vector lies along an axis, and the momentum in the body hands over two of the
# three angles by mere comparison of matrices.
#
# This notebook follows equations (3) to (9) and (22) to (29). The derivation itself lives in
# `derivations/lie_algebra.py`, `euler_lax.py` and `conjugacy.py`. Here those chapters are **run**, the
# objects they work with are looked at, and each step ends by asking the ledger for the grade of the
# facts it has just earned. The verdicts on all printed lines are in
# [notebook 1](01_the_paper_line_by_line.ipynb).

# %%
import matplotlib.pyplot as plt
import numpy as np
from IPython.display import Math, display

from derivations.conjugacy import reduced_momentum, rotation
from figures import curve, label, momentum_sphere
from rigidsym.io.cases import paper_case
from rigidsym.proof.algebra import names
from rigidsym.proof.algebra.su2 import basis, combination, commutator
from rigidsym.proof.kernel import Grade
from support import derived, equation, grades, matrix, number, printed, show

ledger = derived("lie_algebra", "euler_lax", "conjugacy")
f"{len(ledger.facts)} facts in {len(ledger.contexts)} contexts"

# %% [markdown]
# ## A basis whose bracket is the cross product
#
# $SU(2)$ is the group of unit quaternions written as $2\times2$ matrices. Its Lie algebra is spanned
# by three matrices, and the factor $\tfrac12$ is chosen so that $[A_1,A_2]=A_3$ and cyclically, just
# as $e_1\times e_2=e_3$. A vector $v$ in $\mathbb R^3$ and the matrix $v_1A_1+v_2A_2+v_3A_3$ are then
# two notations for the same thing.

# %%
quaternions = ledger.rings["quaternions"]
A1, A2, A3 = basis(quaternions)
for k, A in enumerate((A1, A2, A3), start=1):
    display(equation(f"A_{k}", matrix(A)))
display(equation("[A_1, A_2]", matrix(commutator(A1, A2))))
display(show(ledger, "quaternions.brackets"))

assert grades(ledger, "quaternions.brackets", "quaternions.product") == {Grade.PROVED}

# %% [markdown]
# (The statement of that fact is a list of real equations: every complex entry is a pair, so the
# kernel never meets $\mathrm i$.)
#
# ## Euler's equations as one matrix equation
#
# Momentum and velocity in body axes are the matrices $M=\sum c_i\Omega_iA_i$ and
# $\Omega=\sum\Omega_iA_i$. Differentiate $M$ by Euler's equations, form the bracket $[M,\Omega]$, and
# compare. Both are computed below in the differential ring of the context `body`, where $D\Omega_1$
# *means* $\frac{c_2-c_3}{c_1}\Omega_2\Omega_3$.

# %%
body = ledger.rings["body"]
M = combination(names(body, "M1 M2 M3"))
Omega = combination(names(body, "Omega1 Omega2 Omega3"))
display(equation("M", matrix(M)))
display(equation(r"\dot M", matrix(M.rate())))
display(equation(r"[M,\Omega]", matrix(commutator(M, Omega))))

# %% [markdown]
# The two are the same polynomials, entry by entry. Such a pair $(M,\Omega)$ is called a **Lax
# pair**, and its gift is that the spectrum of $M$ cannot change: $\frac{d}{dt}\operatorname{tr}M^2
# =2\operatorname{tr}M[M,\Omega]=0$. For us the spectrum is $\pm\frac{\mathrm i}2K$, so this is the
# conservation of $K$. Energy is conserved as well, for another reason.

# %%
square = matrix(M @ M)
display(equation("M^2", square.applyfunc(lambda entry: entry.factor())))
display(show(ledger, "body.conserved"))

assert grades(ledger, "body.euler", "body.lax") == {Grade.PROVED}
assert grades(ledger, "body.spectrum", "body.conserved") == {Grade.PROVED}

# %% [markdown]
# ## As seen from space, the momentum stands still
#
# With the kinematics $\dot R=R\,\Omega$ of (3),
#
# $$\frac{d}{dt}\left(RMR^{-1}\right)=R\left(\Omega M+\dot M-M\Omega\right)R^{-1}
# =R\left(\dot M-[M,\Omega]\right)R^{-1}=0 .$$
#
# So $RMR^{-1}$, the momentum in space, is constant. The paper calls the constant $M(0)$. It is
# $R(0)M(0)R(0)^{-1}$; that is the same only when $R(0)$ and $M(0)$ commute, say at $R(0)=e$. The
# hypothesis is necessary, as a counterexample in rational numbers shows: *refuting* a statement
# leaves a proved fact too.

# %%
display(printed("9", "22"))
there = ledger.facts["moving_body.any_start"].certificate["point"]
display(show(ledger, "moving_body.momentum_is_constant", "moving_body.start"))
print("but not, for example, at")
print(", ".join(f"{name} = {value}" for name, value in there.items()))

assert grades(ledger, "moving_body.kinematics") == {Grade.PROVED}
assert grades(ledger, "moving_body.momentum_is_constant") == {Grade.PROVED}
assert ledger.facts["moving_body.any_start"].kind == "unequal"
assert grades(ledger, "moving_body.any_start", "identity_start.momentum") == {Grade.PROVED}

# %% [markdown]
# ## Turning the momentum onto an axis
#
# Since the momentum in space is constant, choose the axes in space so that it lies along the first
# of them: look for a solution $\bar R$ with
#
# $$\bar RM\bar R^{-1}=KA_1 .$$
#
# Any motion is a constant rotation away from such a one (37). Now write $\bar R$ as three turns,
#
# $$\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1).$$
#
# In space the first factor is a turn about the momentum itself. It commutes with $A_1$, and therefore
# drops out of $M=K\bar R^{-1}A_1\bar R$: **the momentum in the body knows $\phi_2$ and $\phi_3$, and
# nothing of $\phi_1$.** That is the whole trick.

# %%
angles = ledger.rings["three_angles"]
Rbar = rotation(angles)
display(equation(r"\bar R_{11}", number(Rbar.a)))
display(equation(r"\bar R_{12}", number(Rbar.b)))
display(show(ledger, "three_angles.stabiliser", "three_angles.momentum"))

# %% [markdown]
# The last fact says that $K\bar R^{-1}A_1\bar R$, multiplied out in half angles, is the matrix (26).
# Its left side is long, its right side is the one with double angles:

# %%
display(printed("26"))
left = (Rbar.inverse() @ basis(angles)[0] @ Rbar) * angles.read("K")
right = reduced_momentum(angles)
terms = [len(entry.numerator) for entry in left], [len(entry.numerator) for entry in right]
print("terms of the eight real entries: left", terms[0], "right", terms[1])

assert grades(ledger, "three_angles.exponential", "three_angles.stabiliser") == {Grade.PROVED}
assert grades(ledger, "three_angles.momentum", "reduced.form") == {Grade.PROVED}

# %% [markdown]
# ### How the kernel knows
#
# Not by simplifying. In the ring of six half angles the relations are $\cos^2+\sin^2-1=0$, three
# times over. The difference of both sides is divided by them, and remainder zero leaves three
# *cofactors* that prove it: the difference **is** the sum of cofactor times relation, which
# polynomial multiplication confirms. Here is one of the eight entries, the imaginary part in the
# upper left corner, $\tfrac12c_1\Omega_1$ on one side and $\tfrac12K\cos\phi_2$ on the other.

# %%
fact = ledger.facts["three_angles.momentum"]
entry = 1
difference = angles.read(fact.lhs[entry]) - angles.read(fact.rhs[entry])
cofactors = [angles.read(text).numerator for text in fact.certificate["cofactors"][entry]]
products = [c * relation for c, relation in zip(cofactors, angles.relations, strict=True)]
for k, (relation, cofactor) in enumerate(zip(angles.relations, cofactors, strict=True), start=1):
    display(equation(f"r_{k}", number(angles.element(relation))))
    display(equation(f"a_{k}", number(angles.element(cofactor))))
display(Math(r"\text{left} - \text{right} = a_1r_1 + a_2r_2 + a_3r_3"))

assert difference.numerator == sum(products)
assert len(difference.numerator) > 0

# %% [markdown]
# A claim that is not true leaves a remainder, and no cofactors can be found. The kernel then refuses
# it. *Undecided* is what it says, not *false*: only a counterexample makes a statement false.

# %%
from rigidsym.proof.algebra import Book
from rigidsym.proof.kernel import KernelError

book = Book()
book.open(ledger.contexts["three_angles"])
try:
    book.claim("three_angles.wrong", {"cos_phi2": "sin_phi2"})
except KernelError as refusal:
    print(refusal)

assert "three_angles.wrong" not in book.ledger.facts

# %% [markdown]
# ## Reading off two angles
#
# What is left is to compare (26) with $M=\sum c_i\Omega_iA_i$. The diagonal gives $\phi_2$, the rest
# gives $\phi_3$, and nothing is lost: the difference of the two matrices vanishes if and only if (27)
# and (28) hold, because its entries *are* those equations.

# %%
display(printed("27", "28", "29"))
display(show(ledger, "reduced.phi2", "reduced.phi3", "tangent.phi3"))

assert grades(ledger, "compared.entries", "reduced.phi2", "reduced.phi3") == {Grade.PROVED}
assert grades(ledger, "reduced.conjugate", "reduced.momentum", "tangent.phi3") == {Grade.PROVED}

# %% [markdown]
# (29) divides by $c_3\Omega_3=K\sin\phi_2\cos\phi_3$. The context `tangent` says so: it declares
# $\sin\phi_2$ and $\cos\phi_3$ to be units, things one may divide by. In geometry, $\phi_2$ is the
# angle between the momentum and the first body axis, a colatitude, and $\phi_3$ the longitude around
# that axis, counted from axis 3 towards axis 2. At the poles a longitude means nothing, and its
# *tangent* has a pole of its own wherever $\Omega_3$ passes zero.

# %%
ledger.contexts["tangent"].units

# %% [markdown]
# ## The same on the paper's spacecraft
#
# *An illustration in floating point, not a proof.* The momentum in the body runs along a curve, a
# **polhode**, on the sphere of radius $K$: the sphere is $K=\text{const}$, and each curve on it is
# $H=\text{const}$. The thick one is the motion of the paper's spacecraft, the dashed ones are the
# separatrices that divide circulation about the axis of smallest inertia from that about the axis
# of largest inertia.

# %%
motion = paper_case().motion
inertia = np.array(list(map(float, motion.inertia)))
t = np.linspace(0, 300, 1201)
q, omega = motion(t)
momentum = omega * inertia
K = np.linalg.norm(momentum[0])
unit = momentum / K

# %% tags=["hide-input"]
figure = plt.figure(figsize=(10, 5.2))
axes = momentum_sphere(figure, 121, motion)
axes.set_title("the momentum in the body, $M/K$", size=11)
curve(axes, unit, color="C0", lw=2.5)
start = unit[0]
curve(axes, [0 * start, start], color="C0", lw=1.5)
pole = np.eye(3)[0]
across = start - start[0] * pole
across /= np.linalg.norm(across)
angle = np.linspace(0, np.arccos(start[0]), 30)[:, None]
arc = 0.55 * (np.cos(angle) * pole + np.sin(angle) * across)
curve(axes, arc, color="C1", lw=2)
label(axes, 1.25 * arc[15], r"$\phi_2$", color="C1", size=13)
angle = np.linspace(0, np.arctan2(start[1], start[2]), 30)
arc = 0.55 * np.stack([0 * angle, np.sin(angle), np.cos(angle)], axis=1)
curve(axes, arc, color="C2", lw=2)
label(axes, 1.3 * arc[15], r"$\phi_3$", color="C2", size=13)

phi2 = np.arccos(unit[:, 0])
phi3 = np.unwrap(np.arctan2(momentum[:, 1], momentum[:, 2]))
above = figure.add_subplot(2, 2, 2)
above.plot(t, np.degrees(phi2), color="C1", label=r"$\phi_2$ (deg)")
above.plot(t, np.degrees(phi3) / 10, color="C2", label=r"$\phi_3/10$ (deg), unwrapped")
above.legend(fontsize=9)
below = figure.add_subplot(2, 2, 4, sharex=above)
tangent = momentum[:, 1] / momentum[:, 2]
below.plot(t, np.where(abs(tangent) < 12, tangent, np.nan), color="C2")
below.set(xlabel="time (s)", ylim=(-10, 10), ylabel=r"$\tan\phi_3=c_2\Omega_2/c_3\Omega_3$")
figure.tight_layout()

# %% [markdown]
# Left: the orange arc is $\phi_2$ at $t=0$, the green one $\phi_3$. Right: both angles are smooth,
# while the tangent of (29) has a pole at every zero of $\Omega_3$. To take $\phi_3$ from $y=\tan\phi_3$
# alone is to lose half of the circle, and that is where Theorem 1's signs come from.
#
# And the numbers agree with the statements: $RMR^{-1}$ stands still, and with $\phi_2$ and $\phi_3$
# from (27) and (28) the matrix $\exp(\phi_2A_2)\exp(\phi_3A_1)$ takes $M$ to $KA_1$, whatever
# $\phi_1$ is.

# %%
A = [np.array(matrix(a).tolist(), dtype=complex) for a in (A1, A2, A3)]
identity = np.eye(2)


def turn(angle, a):
    """exp(angle A), for each of many angles."""
    return np.cos(angle / 2)[:, None, None] * identity + 2 * np.sin(angle / 2)[:, None, None] * a


def conjugated(R, M):
    """R M R^-1 for unitary R."""
    return R @ M @ np.conj(np.swapaxes(R, 1, 2))


M_t = sum(momentum[:, k, None, None] * A[k] for k in range(3))
R_t = q[:, 0, None, None] * identity + 2 * sum(q[:, k + 1, None, None] * A[k] for k in range(3))
in_space = conjugated(R_t, M_t)
reduced = conjugated(turn(np.full_like(t, 0.7), A[0]) @ turn(phi2, A[1]) @ turn(phi3, A[0]), M_t)
print("R M R^-1 stands still to 1e-14 K:", bool(np.ptp(in_space, axis=0).max() < 1e-14 * K))
print("it becomes K A1 to 1e-14 K:      ", bool(abs(reduced - K * A[0]).max() < 1e-14 * K))

# %% [markdown]
# ## What has been earned
#
# Two of three angles, and no integration yet. The third is what
# [the next notebook](03_the_phi1_integral_and_pi.ipynb) is about.

# %%
steps = {
    "3": ["quaternions.kinematics", "moving_body.kinematics"],
    "7": ["body.lax", "body.euler"],
    "9": ["moving_body.momentum_is_constant", "moving_body.start"],
    "23": ["reduced.conjugate"],
    "24": ["reduced.momentum"],
    "25": ["three_angles.exponential", "three_angles.stabiliser"],
    "26": ["three_angles.momentum", "reduced.form"],
    "27": ["compared.entries", "reduced.phi2"],
    "28": ["compared.entries", "reduced.phi3"],
    "29": ["tangent.phi3"],
}
for number_, facts in steps.items():
    assert grades(ledger, *facts) == {Grade.PROVED}, number_
    assert all(number_ in ledger.facts[fact].source for fact in facts), number_
