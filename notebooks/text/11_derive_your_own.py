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
# # 11. Derive your own
#
# The paper's body is rigid and free. Yours may have a flywheel in it that spins at a constant rate: a
# **gyrostat**, as most spacecraft are that carry momentum wheels. Is there a Lax pair for it? Is the
# momentum still turned onto an axis, and is $\dot\phi_1$ still a quotient? What has become of the
# elliptic curve?
#
# One can think about that. Or one hands another Lagrangian to the derivation and looks at what
# comes out. This notebook does so, from the Lagrangian to $\dot\phi_1$ and the quartic, a step at a
# time; none of its results is typed in. [Notebook 2](02_from_lax_pair_to_k_a1.ipynb) explains each
# kind of step for the paper's body. At the end: what else can be changed, and what is refused.

# %% tags=["hide-input"]
import matplotlib.pyplot as plt
import numpy as np
import sympy
from IPython.display import display
from scipy.integrate import solve_ivp

from derivations import conjugacy, kinematics, lie_poisson
from derivations.conjugacy import PHI, K, Reduction
from derivations.euler_lax import MOMENTA, RATES, Dynamics, parameters
from derivations.kinematics import UNKNOWN, Phi1
from derivations.lie_algebra import A, Algebra, M, Omega, combination, commutator
from derivations.setting import KINETIC, Setting
from rigidsym.errors import InputError
from rigidsym.proof.algebra import Part
from rigidsym.proof.kernel import Grade
from rigidsym.proof.steps import (
    Rate,
    Scope,
    StepError,
    coefficients,
    coordinates,
    determinant,
    differentiate,
    eliminate,
    matrix,
    multiply,
    rate_of,
    rewrite,
    solve,
    solve_family,
    vary,
)
from rigidsym.proof.steps._names import symbol, symbols
from support import begun, equation, grades, step
from support.figures import curve, unit_sphere

# %% [markdown]
# ## Another Lagrangian
#
# A symmetric wheel along axis 1, with the constant momentum $h_1$ about its own axle, adds $h_1\Omega_1$
# to the Lagrangian. That is all we say about it. **Change this cell and run on**: put the wheel along
# another axis, take other turns, another basis. (One wheel: what several do is said below.)

# %%
setting = Setting(lagrangian=KINETIC + " + h1*Omega1")

builder = begun(setting, "lie_algebra")
algebra = builder.result(Algebra)
lagrangian, given = setting.energy(), parameters(setting)
display(equation("L", lagrangian))
display(step(builder, "quaternions.bracket_12"), step(builder, "quaternions.kinematics"))

# %% [markdown]
# The algebra is that of rotations and knows of no body. The body comes in by its Lagrangian, and by
# nothing else: vary it, by Euler's and Poincaré's rule $\delta\Omega=\dot\eta+[\Omega,\eta]$.

# %%
why = "vary the attitude in the Lagrangian: M' by the momenta and the rates"
varied = vary(builder, "variation", lagrangian, algebra.constants, given, why, ["5", "7"])
for name, momentum in zip(MOMENTA, varied.momenta, strict=True):
    display(equation(name, momentum))
varied.step

# %% [markdown]
# Momentum is no longer a multiple of velocity: $M=c\,\Omega+h$. But the equations *in the momentum* are
# what they were. In the rates,

# %%
unknown = symbols("Omega1_rate Omega2_rate Omega3_rate")
why = "Euler's equations: solve for the rates of the rates"
euler = solve(varied.scope, "variation.euler", varied.equations, unknown, why, ["5"])
euler

# %% [markdown]
# ## The Lax pair, found and not guessed
#
# Two quantities may be conserved: the spectrum of $M$, that is $K$, and the energy by Legendre's
# transform, from which a term linear in the rates drops out. (The wheel does keep its own energy,
# which is a constant.)

# %%
basis = dict(zip(("A1", "A2", "A3"), setting.basis(), strict=True))
free = Part(witness=dict.fromkeys(map(str, MOMENTA), "1"))
named = {**basis, "M": combination("M1 M2 M3")}
scope = Scope.open(builder, "spectrum", free, matrices=named, static=True)
why = "the spectrum of M, whose trace is zero, is in its determinant"
spectrum = determinant(scope, "spectrum.determinant", M, why, ["6", "7"])

square = sympy.expand(spectrum.value / setting.factor**2)
pairs = zip(varied.momenta, RATES, strict=True)
energy = sympy.factor(sympy.expand(sum(m * w for m, w in pairs) - lagrangian))
body = Part(
    witness={"Omega1": "1", "Omega2": "2", "Omega3": "3"},
    definitions={
        **{str(name): str(value) for name, value in zip(MOMENTA, varied.momenta, strict=True)},
        "H": str(energy),
        "K_squared": str(square),
    },
    rates={str(w): str(euler[symbol(f"{w}_rate")]) for w in RATES},
    reading={f"Omega{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
)
gaps = [name - value for name, value in zip(MOMENTA, varied.momenta, strict=True)]
velocities = sympy.solve(gaps, RATES)
builder.keep(Dynamics(given, body, varied.momenta, velocities))
display(spectrum, equation("H", energy))

# %% [markdown]
# Now suppose any $B=\sum b_kA_k$ and ask for $\dot M=[M,B]$.

# %%
unknown = symbols("b1 b2 b3")
ansatz = Part(witness={**dict.fromkeys(map(str, unknown), "1"), "b_free": "1"})
velocity = {"Omega": combination("Omega1 Omega2 Omega3")}
partner = {**named, **velocity, "B": combination("b1 b2 b3")}
scope = Scope.open(builder, "partner", given, body, ansatz, matrices=partner)
why = "which matrices B have M' = [M, B]?"
wanted = coordinates(scope, "partner.bracket", commutator(M, matrix("B")), A, why, ["7"])
equations = list(zip(wanted.value, varied.moments, strict=True))
why = "Omega, up to a multiple of M"
display(solve_family(scope, "partner.found", equations, unknown, symbol("b_free"), why, ["7"]))

# %% [markdown]
# The partner is the velocity, as for the rigid body: the wheel has changed $M$ and left $\Omega$ alone.
# So there is a Lax pair, and both quantities are conserved.

# %%
scope = Scope.open(builder, "body", given, body, matrices={**named, **velocity})
why = "the bracket of M with the velocity"
display(coordinates(scope, "body.euler", commutator(M, Omega), A, why, ["5", "7"]))
why = "M and Omega are a Lax pair"
display(multiply(scope, "body.lax", Rate(M), commutator(M, Omega), why, ["7"]))
display(differentiate(scope, "body.energy", symbol("H"), "energy is conserved", ["6", "15"]))
why = "and so is the spectrum of M"
display(differentiate(scope, "body.momentum", symbol("K_squared"), why, ["6", "7", "15"]))

# %% [markdown]
# All of that is one Hamiltonian flow. Functions of the momentum have the **Lie–Poisson bracket** of the
# algebra: $\{M_i,M_j\}=-\sum_kf_{ijk}M_k$ where $[A_i,A_j]=\sum_kf_{ijk}A_k$. A function $G$ has the flow
# $\dot F=\{F,G\}$. In the flow of $M_1$, and so of each momentum, $K^2$ is constant: it is a *Casimir*, whose
# bracket with everything is zero, whatever the body. $H$ tells bodies apart, and its flow is the Lax equation, wheel included:

# %%
lie_poisson.derive(builder)
for name in ("poisson1.casimir", "poisson1.energy", "flow.lax"):
    display(step(builder, name))

# %% [markdown]
# ## Conjugacy: nothing has to be done again
#
# From here on the reduction speaks of a momentum $M$ with $\dot M=[M,\Omega]$, and of a matrix with
# $\dot R=R\,\Omega$. It does not ask how $M$ is made of $\Omega$. So the chapters run as they are,

# %%
conjugacy.derive(builder)
kinematics.derive(builder)
for name in ("three_angles.momentum", "reduced.conjugate", "compared.phi2", "compared.phi3"):
    display(step(builder, name))

# %% [markdown]
# and the body comes back where $M$ is put in: in $\tan\phi_3$ and in $\dot\phi_1$.

# %%
for name in ("tangent.phi3", "rates.angles", "line32.rate"):
    display(step(builder, name))

# %% [markdown]
# ## The rate of $\phi_1$
#
# The last of these has two rates above and below. Eliminate their squares by $H$ and $K$:

# %%
rate = step(builder, "line32.by_invariants")
rate

# %% [markdown]
# This is (33) for a gyrostat: the numerator is the rigid body's, and the denominator is
# $K^2-M_1^2$ with $M_1=c_1\Omega_1+h_1$. It vanishes where the momentum points along the axis, and not
# where the velocity does. That these angles carry a motion was decided along the way:

# %%
display(step(builder, "three_angle_motion.kinematics"), step(builder, "three_angle_motion.euler"))

# %% [markdown]
# ## The quartic of its curve
#
# For the paper's body, $\dot\Omega_i^2$ is a quadratic in $\Omega_i^2$, and $\mathrm{sn}$ solves it.
# What is it now, for the rate along the wheel? The same two equations eliminate the other two rates:

# %%
(wheel,) = (k for k, h in enumerate(setting.wheel()) if h != 0)
H, K_squared = symbols("H K_squared")
invariants = [2 * (H - energy), K_squared - sum(m**2 for m in varied.momenta)]
others = [w**2 for k, w in enumerate(RATES) if k != wheel]
moving = Part(
    witness=body.witness,
    definitions={"H": str(energy), "K_squared": str(sympy.expand(K_squared - invariants[1]))},
    rates=body.rates,
)
scope = Scope.open(builder, "gyrostat", given, moving)
slope = scope.rate(RATES[wheel])
name, why = rate_of(RATES[wheel]) ** 2, "the rate along the wheel, squared: a quartic"
quartic = eliminate(scope, "gyrostat.quartic", slope**2, invariants, others, why, ["14"], name)
quartic

# %%
for power, coefficient in zip("43210", coefficients(quartic.value, RATES[wheel]), strict=True):
    display(equation(f"a_{power}", coefficient))

# %% [markdown]
# A quartic with all five coefficients. The odd ones have $h$ in them: with the wheel at rest, the
# quadratic in $\Omega_i^2$ is back. So the rate is an elliptic function still, but not a multiple of
# $\mathrm{sn}$; and Theorem 1 would need another table of integrals, not another idea.
#
# Which elliptic curve is it, seen without a preferred axis? The rates move where two quadrics meet,
# $2H=\dots$ and $K^2=\dots$; the determinant of their pencil, a quartic in its parameter $x$, has a
# square root with the same periods. This works for any number of wheels.

# %%
x, one = symbols("x one")


def quadric(expression):
    """The symmetric matrix of a quadric in (Omega1, Omega2, Omega3, 1)."""
    whole = sympy.Poly(sympy.expand(expression), *RATES).homogenize(one)
    return sympy.hessian(whole.as_expr(), [*RATES, one]) / 2


variable = Part(witness={"x": "1", "H": "1", "K_squared": "1"})
scope = Scope.open(builder, "pencil", given, variable, static=True)
both = quadric(-invariants[1]) - x * quadric(-invariants[0])
leibniz = (-both).applyfunc(sympy.factor).det(method="berkowitz")
why = "the determinant of the pencil of both quadrics: the quartic of the elliptic curve"
rewrite(scope, "pencil.quartic", leibniz, sympy.factor(leibniz), why, ["14"])

# %% [markdown]
# Three of its four roots would be $c_1$, $c_2$, $c_3$ for the body without a wheel, and the fourth
# $K^2/2H$: that is why the moduli of Lemma 1 need no root to be taken. A wheel along axis 1 leaves
# $c_2$ and $c_3$, and moves the other two to where a quadratic equation puts them.
#
# ## Does it fly?
#
# *An illustration in floating point.* Let SciPy integrate the equations that were found, for the
# paper's spacecraft with a wheel in it: the rates, a quaternion $\dot q$, and $\phi_1$ by its formula.
# At the end the quaternion is compared with
# $\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1)$, where $\phi_2$ and $\phi_3$ are read off the momentum.

# %%
VALUES = {"c1": 0.0109, "c2": 0.04, "c3": 0.0506, "h1": 4e-4, "h2": 4e-4, "h3": 4e-4}
START = np.array([0.05, 0.03, -0.02])
known = {symbol(name): value for name, value in VALUES.items()}
Q = symbols("q0 q1 q2 q3")


def function(expressions, *names):
    """A function of numbers from expressions of the derivation."""
    return sympy.lambdify(names, [sympy.sympify(x).subs(known) for x in expressions])


momentum = function(varied.momenta, *RATES)
size = float(np.linalg.norm(momentum(*START)))
numbers = {K: size, H: float(energy.subs(known).subs(dict(zip(RATES, START, strict=True))))}
accelerations = [euler[symbol(f"{w}_rate")] for w in RATES]
turning = builder.result(Phi1).by_invariants.subs(numbers)
motion = function([*accelerations, *algebra.kinematics, turning], *RATES, *Q)

reduction = builder.result(Reduction)
w, (nutation, pole) = 2 * setting.factor, setting.nutation(PHI[1])
inverse = np.arccos if isinstance(nutation, sympy.cos) else np.arcsin
shares = [
    *step(builder, "compared.phi2").value.values(),
    *step(builder, "compared.phi3").value.values(),
]
shares = function([x.subs(pole, 1).subs(numbers) for x in shares], *MOMENTA)
scope = Scope.open(builder, "flown", *reduction.angles, matrices=reduction.matrices, static=True)
factors = scope.explicit(matrix("R"))
attitude = function(list(factors), *PHI)


def turned(phi1, rates):
    """R by its three angles, phi2 and phi3 from the momentum."""
    along, cosine3, sine3 = shares(*momentum(*rates))
    phi2, phi3 = inverse(along), np.arctan2(sine3, cosine3)
    return np.array(attitude(phi1, phi2 / float(w), phi3 / float(w)), dtype=complex)


upper_left, upper_right = turned(0.0, START)[:2]
q = [upper_left.real, upper_left.imag, upper_right.real, upper_right.imag]
t = np.linspace(0, 120, 601)
options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14, "t_eval": t}
flown = solve_ivp(lambda _, y: motion(*y[:7]), (0, 120), [*START, *q, 0.0], **options).y
rates, end = flown[:3], flown[3:7, -1]
quaternion = np.array([end[0] + 1j * end[1], end[2] + 1j * end[3]])
by_angles = turned(flown[7, -1], rates[:, -1])[:2]
gap = min(abs(quaternion - by_angles).max(), abs(quaternion + by_angles).max())
print(f"phi1 after 120 s: {flown[7, -1]:.6f} rad")
print("q and the three turns agree to 1e-9:", bool(gap < 1e-9))

# %% tags=["hide-input"]
figure = plt.figure(figsize=(10, 4.4))
sphere = unit_sphere(figure, 121)
moments_of_inertia = symbols("c1 c2 c3")
parts = zip(MOMENTA, setting.wheel(), moments_of_inertia, strict=True)
rate_of = function([(m - h) / c for m, h, c in parts], *MOMENTA)
euler_of = function(accelerations, *RATES)
coarse = {"rtol": 1e-6, "atol": 1e-9, "t_eval": np.linspace(0, 400, 800)}
steps = np.linspace(-0.95, 0.95, 6)
seeds = [(x, s * np.sqrt(1 - x * x), 0) for x in steps for s in (1, -1)]
seeds += [(x, 0, s * np.sqrt(1 - x * x)) for x in steps[1:-1] for s in (1, -1)]
for seed in seeds:
    start = rate_of(*(size * np.array(seed)))
    found = solve_ivp(lambda _, y: euler_of(*y), (0, 400), start, **coarse).y
    curve(sphere, np.transpose(momentum(*found)) / size, color="0.65", lw=0.7)
curve(sphere, np.transpose(momentum(*rates)) / size, color="C0", lw=2.5)
sphere.set_title("the momentum in the body, $M/K$", size=11)

right = figure.add_subplot(122)
numbers[K_squared] = size**2
polynomial = function([quartic.value.subs(numbers)], RATES[wheel])
along = rates[wheel]
span = np.ptp(along)
wide = np.linspace(along.min() - 0.25 * span, along.max() + 0.25 * span, 400)
right.plot(1e3 * wide, 1e6 * polynomial(wide)[0], color="C1", label="the quartic")
squares = 1e6 * np.array(euler_of(*rates))[wheel] ** 2
right.plot(1e3 * along, squares, ".", ms=3, color="C0", label="the motion")
right.axhline(0, color="0.5", lw=0.8)
right.set(xlabel=rf"$\Omega_{wheel + 1}$ (mrad/s)", ylabel="its rate squared ($10^{-6}$ s$^{-4}$)")
right.legend(fontsize=9)
figure.tight_layout()

# %% [markdown]
# Left: motions with the same $K$, the integrated one heavy. The wheel has pushed the pattern of the
# rigid body along its axis, to where no symmetry is left between spinning one way and the other.
# Right: the motion goes to and fro between two neighbouring roots of the quartic.
#
# ## What else can be changed
#
# Everything that [`Setting`](02_from_lax_pair_to_k_a1.ipynb) has, in any combination. With the turns
# 3-2-1 of an aircraft, $\phi_2$ is found by its sine, and $\dot\phi_1$ is the same function of the
# rate about the *last* axis: all twelve sequences have the same integral.

# %%
aircraft = begun(Setting(sequence=(3, 2, 1)), "kinematics")
display(step(aircraft, "three_angles.momentum"), step(aircraft, "compared.phi2"))
display(step(aircraft, "line32.by_invariants"))

# %% [markdown]
# With 3-1-3 turns, the momentum onto axis 3, and the wheel along axis 2, the chapters give

# %%
other = Setting(sequence=(3, 1, 3), lagrangian=KINETIC + " + h2*Omega2")
varied_book = begun(other, "kinematics")
display(step(varied_book, "three_angles.momentum"))
display(step(varied_book, "line32.rate"), step(varied_book, "line32.by_invariants"))

# %% [markdown]
# Two of the squares have gone, and a linear $\Omega_2$ has stayed: with a wheel across the axis,
# $\dot\phi_1$ is a function of two rates, and to eliminate one of them takes a square root.
#
# Two moments may be equal. About the axis of symmetry, the tilt of the axis stays and $\phi_1$ grows
# evenly; across it, the rates are a cosine and a sine:

# %%
top = Setting(sequence=(3, 1, 3), lagrangian="(c1*(Omega1**2 + Omega2**2) + c3*Omega3**2)/2")
regular = begun(top, "lemma1")
display(step(regular, "symmetric.swing"), step(regular, "line32.rate"))
display(step(regular, "three_angle_motion.tilt"), step(regular, "precession.phi1"))

# %% [markdown]
# And the axes need not be the principal ones. With a product of inertia, $\dot\phi_1$ is the same
# quotient in the momentum $M_3$ and the rate $\Omega_3$ about the last axis; and the pencil finds the
# principal moments by itself: one factor of the quartic is the characteristic polynomial of the
# inertia tensor, whose roots they are.

# %%
tilted = Setting(sequence=(3, 1, 3), lagrangian=KINETIC + " + c12*Omega1*Omega2")
general = begun(tilted, "lemma1")
display(step(general, "line32.by_invariants"), step(general, "pencil.quartic"))

# %% [markdown]
# The same in a terminal, proved in the same way, and as an article with `--format latex`, `markdown`
# or `html`:
#
# ```sh
# rigidsym derive --show --lagrangian "(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2 + h1*Omega1"
# rigidsym derive --show kinematics --sequence 3-1-3 --axis 3
# rigidsym derive --format latex --sign -1 -o another.tex
# ```
#
# Nothing of that touches the sealed ledger of the project. And what is no choice is refused, in a
# line that says why. The last one is a heavy top: its potential is linear in the vertical direction
# $n$, its torque changes the momentum, and there is no axis left to turn it onto.

# %%
refused = (
    {"sequence": (1, 1, 2)},
    {"axis": 4},
    {"order": (1, 1, 2)},
    {"lagrangian": KINETIC + " + Omega1*Omega2"},
    {"lagrangian": KINETIC + " + g*Omega1"},
    {"lagrangian": KINETIC + " - g*n3"},
)
refusals = []
for choice in refused:
    try:
        Setting(**choice)
    except InputError as error:
        refusals.append(str(error))
        print(error)

# %% [markdown]
# A body beyond `Setting` needs a step or two of your own, and the steps take any expression. If SymPy
# cannot do one, it says so; if it does one wrong, the kernel does. Here the equations are too few:

# %%
scope = Scope.open(builder, "too_few", given, Part(witness=dict.fromkeys(map(str, UNKNOWN), "1")))
try:
    solve(scope, "too_few.found", [(UNKNOWN[0] + UNKNOWN[1], symbol("c1"))], UNKNOWN[:2], "too few")
except StepError as error:
    refusals.append(str(error))
    print(error)

# %% [markdown]
# The vocabulary is in `rigidsym/proof/steps`: `vary`, `multiply`, `coordinates`, `solve`, `eliminate`,
# `differentiate`, `apart`, `integrate`, `roots`, `match`, `rewrite`. A new one is a function that finds
# something by SymPy and ends in `Scope.decide`.

# %% tags=["hide-cell"]
ledger = builder.ledger
assert grades(ledger, *ledger.facts) == {Grade.PROVED}
assert grades(varied_book.ledger, "line32.by_invariants") == {Grade.PROVED}
assert grades(regular.ledger, *regular.ledger.facts) == {Grade.PROVED}
assert grades(general.ledger, *general.ledger.facts) == {Grade.PROVED}
derived_here = ("variation.euler", "body.lax", "partner.found", "flow.lax", "reduced.conjugate",
                "compared.phi3", "line32.by_invariants", "gyrostat.quartic", "pencil.quartic")  # fmt: skip
assert {*derived_here} <= {*ledger.facts}
assert len(refusals) == 7
assert all("\n" not in refusal for refusal in refusals)
# The illustration agrees with the facts.
assert gap < 1e-9
assert np.allclose(squares, 1e6 * np.array(polynomial(along)[0]), rtol=0, atol=1e-6 * squares.max())
assert np.ptp(np.linalg.norm(momentum(*rates), axis=0)) < 1e-10 * size
