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
# # 2. From the Lax pair to $KA_1$
#
# The attitude of a free body has three degrees of freedom, so one would expect three integrations.
# The paper needs only one. The reason is the conservation of angular momentum *as a vector in
# space*: if the frame is turned so that this vector lies along an axis, two of the three angles
# follow from the momentum in the body by comparing matrices.
#
# This notebook follows the derivation of equations (3) to (9) and (22) to (29), from a basis of
# matrices and a kinetic energy. It calculates with plain SymPy where that takes a line or two. The
# framed lines are those of the chapters `derivations/lie_algebra.py`, `euler_lax.py` and
# `conjugacy.py`: SymPy finds the right-hand side of such a line, and a small kernel decides whether
# the line is true. Each shows what was done, the equation, the paper's number, what it divides by,
# and on the right the name under which the kernel keeps the fact. The verdicts on the printed lines
# are in [notebook 1](01_the_paper_line_by_line.ipynb).

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy
from IPython.display import Math, display

from rigidsym.io.cases import paper_case
from support import equation, grades, printed
from support.figures import curve, label, momentum_sphere
from support.names import MOMENTA, PHI, RATES, K, M, Omega, R, commutator
from support.steps import Rate, Setting, StepError, begun, lines, rewrite, step, within

# %% [markdown]
# ## The choices
#
# A derivation starts from choices: which axes the body is turned about, and in which order; onto
# which axis the momentum is turned; the basis of the Lie algebra; the Lagrangian. `Setting()` has
# those of the paper. **Change them here and run on**: `Setting(sequence=(3, 1, 3))` takes the Euler
# angles of celestial mechanics, `Setting(sequence=(3, 2, 1))` those of aircraft, `Setting(axis=2)`
# turns the momentum onto another axis, `Setting(sign=-1)` or `Setting(factor=1)` takes another
# basis, and `Setting(group="SO3")` rotation matrices for $SU(2)$. Everything below is computed again, including the pictures.

# %%
setting = Setting()

builder = begun(setting, "conjugacy")

# %% [markdown]
# That ran the three chapters. The *builder* has their steps and the facts of the kernel.
#
# ## A basis whose bracket is the cross product
#
# $SU(2)$ is the group of unit quaternions written as $2\times2$ matrices. Its Lie algebra is spanned
# by three matrices, and the factor $\tfrac12$ is chosen so that $[A_1,A_2]=A_3$ and cyclically, just
# as $e_1\times e_2=e_3$. A vector $v$ in $\mathbb R^3$ and the matrix $v_1A_1+v_2A_2+v_3A_3$ are then
# two notations for the same thing.

# %%
A1, A2, A3 = setting.basis()
for name, value in (("A_1", A1), ("A_2", A2), ("A_3", A3), ("A_1A_2-A_2A_1", A1 * A2 - A2 * A1)):
    display(equation(name, value))

# %% [markdown]
# The chapter multiplies two quaternions $P$ and $Q$ as matrices, where $e_0,\dots,e_3$ are
# $1,\mathrm i,\mathrm j,\mathrm k$. It reads the coordinates of each bracket off the product; these
# *structure constants* are kept, since the equations of motion are made of them. In the same way,
# $\dot R=R\,\Omega$ becomes the four rates of a quaternion, with the angular velocity
# $\Omega=\sum\Omega_kA_k$ in body axes.

# %%
lines(builder, *(fact for fact in builder.ledger.facts if fact.startswith("quaternions.")))

# %% [markdown]
# (The kernel does not trust SymPy's product. It is handed $Q\,\Omega$, entry by entry as sums of
# products, and multiplies for itself. Complex entries are pairs of real ones there, so that it never
# meets $\mathrm i$.)
#
# ## Euler's equations from the kinetic energy
#
# $L$ is the kinetic energy, and the momentum is its gradient, $M_k=\partial L/\partial\Omega_k$. The
# energy is $H=\sum M_k\Omega_k-L$.

# %%
L = setting.energy()
momenta = [L.diff(rate) for rate in RATES]
energy = (sympy.Matrix(momenta).dot(sympy.Matrix(RATES)) - L).expand().factor()
display(equation("L", L), *map(equation, MOMENTA, momenta), equation("H", energy))

# %% [markdown]
# Vary the motion: if $R$ becomes $R+\delta R$ with $\delta R=R\,\eta$, then the velocity changes by
# $\delta\Omega=\dot\eta+[\Omega,\eta]$. The change of $L$ is $\sum M_k\,\delta\Omega_k$; integrate by
# parts, and the factor of $\eta_k$ has to vanish. The structure constants enter here, so this is
# Newton's law in whatever basis was chosen.

# %%
lines(builder, "variation.by_parts", "variation.euler")

# %% [markdown]
# ## The Lax pair
#
# The three right-hand sides are the components of a bracket, so the equations of motion are one
# matrix equation, $\dot M=[M,\Omega]$ with $M=\sum M_kA_k$. In the context `body` of the chapter, the
# rates move by Euler's equations: SymPy differentiates $M$, multiplies out the bracket, and their
# difference is zero.

# %%
body = within(builder, "body")
gap = body.explicit(Rate(M)) - body.explicit(commutator(M, Omega))
gap.subs(dict(zip(MOMENTA, momenta, strict=True))).applyfunc(sympy.expand)

# %%
lines(builder, "body.euler", "body.lax")

# %% [markdown]
# Such a pair $(M,\Omega)$ is called a **Lax pair**. Its use is that the spectrum of $M$ cannot
# change: $\frac{d}{dt}\operatorname{tr}M^2=2\operatorname{tr}M[M,\Omega]=0$. $M$ has trace zero and
# the eigenvalues $\pm\sqrt{-\det M}$, multiples of $K$ with $K^2=M_1^2+M_2^2+M_3^2$. So $K$ is
# conserved. The energy is conserved as well, for another reason.

# %%
(spectrum,) = (fact for fact in builder.ledger.facts if fact.startswith("spectrum."))
lines(builder, spectrum, "body.momentum", "body.energy")

# %% [markdown]
# The partner $\Omega$ can also be found. Take any matrix $B=\sum b_kA_k$, require $\dot M=[M,B]$,
# and solve for the $b_k$. These are three linear equations, and they leave one direction free.

# %%
lines(builder, "partner.bracket", "partner.found")

# %% [markdown]
# ## In space, the momentum is constant
#
# With the kinematics $\dot R=R\,\Omega$ of (3),
#
# $$\frac{d}{dt}\left(RMR^{-1}\right)=R\left(\Omega M+\dot M-M\Omega\right)R^{-1}
# =R\left(\dot M-[M,\Omega]\right)R^{-1}=0 .$$
#
# The kernel does not trust this line; it differentiates and multiplies the four entries itself. The
# paper calls the constant $M(0)$. It is $R(0)M(0)R(0)^{-1}$, which equals $M(0)$ only if $R(0)$ and
# $M(0)$ commute, for example at $R(0)=e$. The printed equations are below the line.

# %%
display(lines(builder, "moving_body.momentum_is_constant"), printed("9", "22"))

# %% [markdown]
# ## Turning the momentum onto an axis
#
# Since the momentum in space is constant, choose the axes in space so that it lies along one of
# them, the first in the paper: look for a solution $\bar R$ with
#
# $$\bar RM\bar R^{-1}=KA_1 .$$
#
# Any motion differs from such a solution by a constant rotation (37). Now write $\bar R$ as three
# turns,
#
# $$\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1),$$
#
# called $E_1$, $E_2$ and $E_3$ here; the framed lines write $R$ for $\bar R$. From $A^2=-\frac14$
# follows $\exp(\phi A)=\cos\frac\phi2+2A\sin\frac\phi2$. (If the momentum is to be turned onto another
# axis than that of the outer turns, a constant rotation $T$ precedes them.)

# %%
angles = within(builder, "three_angles")
display(*(equation(f"E_{k}", angles.matrices[f"E{k}"]) for k in (1, 2, 3)))
display(lines(builder, "three_angles.exponential", "three_angles.inverse"))

# %% [markdown]
# In space the first factor is a turn about the momentum itself. It commutes with $A_1$, and
# therefore drops out of $M=K\bar R^{-1}A_1\bar R$: **the momentum in the body depends on $\phi_2$
# and $\phi_3$, but not on $\phi_1$.** This is the key to the method.

# %%
seen = step(builder, "three_angles.momentum")
display(lines(builder, "three_angles.stabiliser"), seen, printed("26"))

# %% [markdown]
# ### How the kernel decides
#
# The kernel does not simplify. In the ring of the cosines and sines of three angles there are three
# relations $\cos^2+\sin^2-1=0$. The kernel divides the difference of both sides by them. If the
# remainder is zero, the three quotients, called *cofactors*, prove the equation: the difference
# **is** the sum of cofactor times relation, which polynomial multiplication confirms. Here is one
# entry of the matrix equation above, with the relations $r_k$ and the cofactors $a_k$.

# %%
ring, fact = angles.ring, seen.fact
differences = [ring.read(x) - ring.read(y) for x, y in zip(fact.lhs, fact.rhs, strict=True)]
entry = next(k for k, difference in enumerate(differences) if len(difference.numerator) > 0)
cofactors = [ring.read(text).numerator for text in fact.certificate["cofactors"][entry]]
print("terms of left minus right:", len(differences[entry].numerator))
for k, (relation, cofactor) in enumerate(zip(ring.relations, cofactors, strict=True), start=1):
    display(equation(f"r_{k}", angles.read(str(relation))))
    display(equation(f"a_{k}", angles.read(str(cofactor))))
display(Math(r"\text{left} - \text{right} = a_1r_1 + a_2r_2 + a_3r_3"))

# %% [markdown]
# A claim that is not true leaves a remainder, and no cofactors can be found. The kernel then
# refuses it, and so a step in which SymPy made a mistake ends here. The kernel says *undecided*,
# not *false*: only a counterexample makes a statement false.

# %%
try:
    rewrite(angles, "three_angles.wrong", sympy.cos(PHI[1]), sympy.sin(PHI[1]), "wrong")
except StepError as refusal:
    print(refusal)

# %% [markdown]
# ## With these components, $\bar R$ turns the momentum onto the axis
#
# Insert $K$ times these coordinates for the momentum and multiply out once more: $\bar R$ turns it
# onto the axis. This is a statement about one instant; time does not occur in it.

# %%
lines(builder, "reduced.conjugate", "reduced.momentum")

# %% [markdown]
# ## Reading off two angles
#
# It remains to compare three components of the momentum with two angles. The component along the
# last axis of the sequence gives $\phi_2$; the other two are linear in $\cos\phi_3$ and
# $\sin\phi_3$ and give $\phi_3$.

# %%
w = 2 * setting.factor  # exp(phi A) turns by w phi
cosine, sine = sympy.cos(w * PHI[2]), sympy.sin(w * PHI[2])
_, second, third = (k - 1 for k in setting.axes)
sympy.solve([MOMENTA[k] - K * seen[k] for k in (second, third)], [cosine, sine])

# %% [markdown]
# No solution is lost or added: in the framed lines, the kernel has decided both directions.

# %%
phi2, phi3 = step(builder, "compared.phi2"), step(builder, "compared.phi3")
display(phi2, phi3)

# %% [markdown]
# Their quotient is (29). It also divides by $\cos\phi_3$, and it loses a sign: it gives $\phi_3$
# only up to half a turn.

# %%
display(lines(builder, "tangent.phi3"), printed("29"))

# %% [markdown]
# In geometry, $\phi_2$ is the angle between the momentum and the first body axis, a colatitude, and
# $\phi_3$ the longitude around that axis, counted from axis 3 towards axis 2. At the poles the
# longitude is undefined, and its *tangent* has a pole wherever $\Omega_3$ passes zero.
#
# ## The angles for the paper's spacecraft
#
# *An illustration in floating point, not a proof.* The momentum in the body runs along a curve, a
# **polhode**, on the sphere of radius $K$: the sphere is $K=\text{const}$, and each curve on it is
# $H=\text{const}$. The thick one is the motion of the paper's spacecraft, the dashed ones are the
# separatrices that divide circulation about the axis of smallest inertia from that about the axis
# of largest inertia. The angles are computed by the equations that `solve` has just found.

# %%
motion = paper_case().motion
inertia = np.array(list(map(float, motion.inertia)))
t = np.linspace(0, 300, 1201)
q, omega = motion(t)
momentum = omega * inertia
size = np.linalg.norm(momentum[0])
unit = momentum / size


def numbers(expressions, names, *values):
    """Expressions at arrays of values of names, one below the other in the last axis."""
    found = sympy.lambdify(names, list(expressions), "numpy")(*values)
    return np.stack(np.broadcast_arrays(*found), axis=-1)


turned = float(w)
along, across = setting.nutation(PHI[1])  # cosine and sine; for three axes, sine and cosine
inverse, equator = (np.arccos, np.pi / 2) if isinstance(along, sympy.cos) else (np.arcsin, 0.0)
inputs = (*momentum.T, size)
(colatitude,) = inverse(numbers([phi2[along]], (*MOMENTA, K), *inputs)).T
shares = [x.subs(across, 1) for x in (phi3[cosine], phi3[sine])]
longitude = numbers(shares, (*MOMENTA, K), *inputs)
longitude = np.unwrap(np.arctan2(longitude[:, 1], longitude[:, 0]))

# %% tags=["hide-input"]
figure = plt.figure(figsize=(10, 5.2))
axes = momentum_sphere(figure, 121, motion)
axes.set_title("the momentum in the body, $M/K$", size=11)
curve(axes, unit, color="C0", lw=2.5)
curve(axes, [0 * unit[0], unit[0]], color="C0", lw=1.5)
share = np.linspace(0, 1, 30)
arcs = {
    r"$\phi_2$": (share * colatitude[0], 0 * share + longitude[0], "C1"),
    r"$\phi_3$": (0 * share + equator, share * longitude[0], "C2"),
}
for name, (down, around, colour) in arcs.items():
    arc = 0.55 * numbers(seen.value, PHI[1:], down / turned, around / turned)
    curve(axes, arc, color=colour, lw=2)
    label(axes, 1.3 * arc[15], name, color=colour, size=13)

above = figure.add_subplot(2, 2, 2)
above.plot(t, np.degrees(colatitude), color="C1", label=r"$\phi_2$ (deg)")
above.plot(t, np.degrees(longitude) / 10, color="C2", label=r"$\phi_3/10$ (deg), unwrapped")
above.legend(fontsize=9)
below = figure.add_subplot(2, 2, 4, sharex=above)
slope = np.tan(longitude)
below.plot(t, np.where(abs(slope) < 12, slope, np.nan), color="C2")
below.set(xlabel="time (s)", ylim=(-10, 10), ylabel=r"$\tan\phi_3$")
figure.tight_layout()

# %% [markdown]
# Left: the orange arc is $\phi_2$ at $t=0$, the green one $\phi_3$. Right: both angles are smooth,
# while the tangent of (29) has a pole at every zero of $\Omega_3$. If $\phi_3$ is taken from
# $y=\tan\phi_3$ alone, half of the circle is lost. This is why Theorem 1 needs signs.
#
# The numbers agree with the statements: $RMR^{-1}$ is constant, and with these $\phi_2$ and
# $\phi_3$ the three turns take $M$ to $KA_1$, whatever $\phi_1$ is.

# %%
A_numbers = [np.array(a.tolist(), dtype=complex) for a in setting.basis()]
e_numbers = [np.eye(2), *(2 * np.array(a.tolist(), dtype=complex) for a in Setting().basis())]


def combined(coefficients, matrices):
    """Sums of matrices with rows of coefficients."""
    return np.einsum("nk,kij->nij", coefficients, np.array(matrices))


def conjugated(turns, matrices):
    """R M R^-1 for unitary R."""
    return turns @ matrices @ np.conj(np.swapaxes(turns, 1, 2))


in_space = conjugated(combined(q, e_numbers), combined(momentum, e_numbers[1:]))
entries = numbers(angles.explicit(R), PHI, 0 * t + 0.7, colatitude / turned, longitude / turned)
reduced = conjugated(entries.reshape(-1, *A1.shape), combined(momentum, A_numbers))
onto = size * A_numbers[setting.target - 1]
print("R M R^-1 stands still to 1e-14 K:", bool(np.ptp(in_space, axis=0).max() < 1e-14 * size))
print("it becomes K A to 1e-14 K:       ", bool(abs(reduced - onto).max() < 1e-14 * size))

# %% [markdown]
# ## What we have
#
# We have two of three angles without an integration. [The next
# notebook](03_the_phi1_integral_and_pi.ipynb) derives the third. The last cell, folded, checks the
# statements of this notebook.

# %% tags=["hide-cell"]
ledger = builder.ledger
assert grades(ledger, *ledger.facts) == {"PROVED"}
assert len(ledger.facts) == len(builder.steps) >= 20
assert "three_angles.wrong" not in ledger.facts
products = [c * relation for c, relation in zip(cofactors, ring.relations, strict=True)]
assert differences[entry].numerator == sum(products)
assert ledger.contexts["tangent"].units[-2:] == (f"{across.func}_phi2", "cos_phi3")
earned = {
    "3": ["moving_body.kinematics"],
    "4": ["quaternions.bracket_12", "quaternions.bracket_23", "quaternions.bracket_13"],
    "5": ["variation.by_parts", "variation.euler", "body.euler"],
    "6": [spectrum, "body.energy", "body.momentum"],
    "7": ["body.lax", "partner.found"],
    "9": ["moving_body.momentum_is_constant"],
    "23": ["reduced.conjugate"],
    "24": ["reduced.momentum"],
    "25": ["three_angles.exponential", "three_angles.stabiliser"],
    "26": ["three_angles.momentum"],
    "27": ["compared.phi2"],
    "28": ["compared.phi3"],
    "29": ["tangent.phi3"],
}
for number, facts in earned.items():
    assert all(number in ledger.facts[fact].source for fact in facts), number
# The illustration agrees with the facts.
assert np.ptp(in_space, axis=0).max() < 1e-14 * size
assert abs(reduced - onto).max() < 1e-14 * size
