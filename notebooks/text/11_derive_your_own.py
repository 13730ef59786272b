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
# This notebook hands another Lagrangian to the chapters of the derivation and looks at what comes
# out, from the Lagrangian to $\dot\phi_1$ and the quartic of the elliptic curve. No result is typed
# in. [Notebook 2](02_from_lax_pair_to_k_a1.ipynb) explains each kind of line for the paper's body. At
# the end: what else can be changed, what is refused, how a step of your own is made, and how the
# motion itself is differentiated by its parameters.

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy
from scipy.integrate import solve_ivp

from derivations import rate_sensitivities as sensitivities
from rigidsym.errors import InputError
from rigidsym.proof.steps import coefficients, differentiate, solve
from support import equation, grades, sealed, show
from support.figures import curve, unit_sphere
from support.names import MOMENTA, PHI, RATES, K, R, symbol, symbols
from support.steps import KINETIC, Setting, StepError, begun, display, lines, source, step, within

# %% [markdown]
# ## Another Lagrangian
#
# A symmetric wheel along axis 1, with the constant momentum $h_1$ about its own axle, adds $h_1\Omega_1$
# to the Lagrangian. That is all we say about it. **Change this cell and run on**: put the wheel along
# another axis, take other turns, another basis. (One wheel: what several do is said below.)

# %%
setting = Setting(lagrangian=KINETIC + " + h1*Omega1")

builder = begun(setting, "lemma1")

# %% [markdown]
# The chapters have run, up to Lemma 1. The algebra is that of rotations and does not depend on the
# body. The body enters by its Lagrangian $L$ alone. The momentum is its gradient, and the energy is
# $H=\sum M_k\Omega_k-L$, from which a term linear in the rates drops out. (The wheel keeps its own
# energy, which is a constant.)

# %%
L = setting.energy()
momenta = [L.diff(rate) for rate in RATES]
energy = (sympy.Matrix(momenta).dot(sympy.Matrix(RATES)) - L).expand().factor()
display(equation("L", L), *map(equation, MOMENTA, momenta), equation("H", energy))

# %% [markdown]
# Momentum is no longer a multiple of velocity: $M=c\,\Omega+h$. But the equations of motion *in the
# momentum*, by Euler's and Poincaré's rule $\delta\Omega=\dot\eta+[\Omega,\eta]$ for a variation
# $\eta$, are those of a body without a wheel. The second line has them in the rates.

# %%
lines(builder, "variation.by_parts", "variation.euler")

# %% [markdown]
# ## The Lax pair, found and not guessed
#
# Let $M=\sum M_kA_k$, suppose any $B=\sum b_kA_k$ and ask for $\dot M=[M,B]$.

# %%
lines(builder, "partner.bracket", "partner.found")

# %% [markdown]
# The partner is the velocity $\Omega=\sum\Omega_kA_k$, up to a multiple of $M$, as for the rigid body:
# the wheel has changed $M$ and left $\Omega$ alone. So there is a Lax pair, and two quantities are
# conserved: the energy, and the spectrum of $M$, that is $K$.

# %%
lines(builder, "body.lax", "body.energy", "body.momentum")

# %% [markdown]
# All of that is one Hamiltonian flow. Functions of the momentum have the **Lie–Poisson bracket** of the
# algebra: $\{M_i,M_j\}=-\sum_kf_{ijk}M_k$ where $[A_i,A_j]=\sum_kf_{ijk}A_k$. A function $G$ has the flow
# $\dot F=\{F,G\}$. In the flow of $M_1$, and so of each momentum, $K^2$ is constant: it is a *Casimir*, whose
# bracket with everything is zero, whatever the body. $H$ tells bodies apart, and its flow is the Lax equation, wheel included:

# %%
lines(builder, "poisson1.casimir", "poisson1.energy", "flow.lax")

# %% [markdown]
# ## Conjugacy: nothing has to be done again
#
# From here on the reduction speaks of a momentum $M$ with $\dot M=[M,\Omega]$, and of a matrix with
# $\dot R=R\,\Omega$. It does not depend on how $M$ is made of $\Omega$. So these lines are the paper's,

# %%
lines(builder, "three_angles.momentum", "reduced.conjugate", "compared.phi2", "compared.phi3")

# %% [markdown]
# and the body comes back where $M$ is put in: in $\tan\phi_3$ and in $\dot\phi_1$.

# %%
lines(builder, "tangent.phi3", "rates.angles", "line32.rate")

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
# where the velocity does. These angles carry a motion:

# %%
lines(builder, "three_angle_motion.kinematics", "three_angle_motion.euler")

# %% [markdown]
# ## The quartic of its curve
#
# For the paper's body, $\dot\Omega_i^2$ is a quadratic in $\Omega_i^2$, and $\mathrm{sn}$ solves it.
# For the rate along the wheel, the same two equations eliminate the other two rates:

# %%
(wheel,) = (k for k, h in enumerate(setting.wheel()) if h != 0)
quartic = step(builder, "gyrostat.quartic")
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
lines(builder, "pencil.quartic")

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


momentum = function(momenta, *RATES)
size = float(np.linalg.norm(momentum(*START)))
H, K_squared = symbols("H K_squared")
numbers = {K: size, H: float(energy.subs(known).subs(dict(zip(RATES, START, strict=True))))}
euler = step(builder, "variation.euler")
accelerations = [euler[symbol(f"{rate_}_rate")] for rate_ in RATES]
kinematics = step(builder, "quaternions.kinematics").value
motion = function([*accelerations, *kinematics, rate.value.subs(numbers)], *RATES, *Q)

w, (nutation, pole) = 2 * setting.factor, setting.nutation(PHI[1])
inverse = np.arccos if isinstance(nutation, sympy.cos) else np.arcsin
found = (step(builder, f"compared.phi{k}").value.values() for k in (2, 3))
shares = function([x.subs(pole, 1).subs(numbers) for one in found for x in one], *MOMENTA)
attitude = function(list(within(builder, "three_angles").explicit(R)), *PHI)


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
lines(aircraft, "three_angles.momentum", "compared.phi2", "line32.by_invariants")

# %% [markdown]
# With 3-1-3 turns, the momentum onto axis 3, and the wheel along axis 2, the chapters give

# %%
other = Setting(sequence=(3, 1, 3), lagrangian=KINETIC + " + h2*Omega2")
varied_book = begun(other, "kinematics")
lines(varied_book, "three_angles.momentum", "line32.rate", "line32.by_invariants")

# %% [markdown]
# Two of the squares have gone, and a linear $\Omega_2$ has stayed: with a wheel across the axis,
# $\dot\phi_1$ is a function of two rates, and to eliminate one of them takes a square root.
#
# Two moments may be equal. About the axis of symmetry, the tilt of the axis stays and $\phi_1$ grows
# evenly; across it, the rates are a cosine and a sine:

# %%
top = Setting(sequence=(3, 1, 3), lagrangian="(c1*(Omega1**2 + Omega2**2) + c3*Omega3**2)/2")
regular = begun(top, "lemma1")
swings = "symmetric.swing", "line32.rate", "three_angle_motion.tilt", "precession.phi1"
lines(regular, *swings)

# %% [markdown]
# And the axes need not be the principal ones. With a product of inertia, $\dot\phi_1$ is the same
# quotient in the momentum $M_3$ and the rate $\Omega_3$ about the last axis; and the pencil finds the
# principal moments by itself: one factor of the quartic is the characteristic polynomial of the
# inertia tensor, whose roots they are.

# %%
tilted = Setting(sequence=(3, 1, 3), lagrangian=KINETIC + " + c12*Omega1*Omega2")
general = begun(tilted, "lemma1")
lines(general, "line32.by_invariants", "pencil.quartic")

# %% [markdown]
# With rotation matrices in the place of $SU(2)$, the chapters end in the matrix of the attitude, by the
# three angles and by the momentum $M$ in body axes:

# %%
matrices = begun(Setting(group="SO3"), "theorem1")
lines(matrices, "theorem1.matrix", "theorem1.by_momentum")

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
# ## A step of your own
#
# A body or a question beyond `Setting` needs a step or two of your own, and the steps take any
# expression of SymPy. Is $M\cdot\Omega$ conserved, too, as it is for a rigid body, where it is $2H$?
# Differentiate it in the context `body`, where the rates move by Euler's equations:

# %%
body = within(builder, "body")
twice = sum(m * rate_ for m, rate_ in zip(MOMENTA, RATES, strict=True))
differentiate(body, "body.own", twice, "M dot Omega, which the wheel makes vary", [])

# %% [markdown]
# The kernel has decided that line as it does those of the chapters. If SymPy cannot do a step, it
# says so. Here is one equation for two unknowns, in the context `velocity` of the rates of the angles:

# %%
turning = symbols("phi1_rate phi2_rate")
try:
    wanted = [(sum(turning), RATES[0])]
    solve(within(builder, "velocity"), "velocity.found", wanted, turning, "too few")
except StepError as error:
    refusals.append(str(error))
    print(error)

# %% [markdown]
# The vocabulary is in `rigidsym/proof/steps`: `vary`, `multiply`, `coordinates`, `solve`, `eliminate`,
# `differentiate`, `apart`, `integrate`, `roots`, `match`, `rewrite`. A new one is a function that finds
# something by SymPy and ends in `Scope.decide`.
#
# ## Differentiate the motion
#
# How does the motion change with the rates at $t=0$ and the moments of inertia? Fits and error bounds
# need these *sensitivities*, and the chapter `derivations/rate_sensitivities.py` computes them by
# differentiating the solution. It writes the rates by three functions of the time $t$ with two
# constants $p$ and $r$,
#
# $$\dot S=C\,D,\qquad C^2=1-p\,S^2,\qquad D^2=1-r\,S^2,\qquad S(0)=0,\quad C(0)=D(0)=1,$$
#
# which are $\mathrm{sn}(\lambda t\,|\,m)/\lambda$, $\mathrm{cn}$ and $\mathrm{dn}$ with $p=\lambda^2$ and
# $r=m\lambda^2$. (In the lines below they have the index $t$.) All else follows by the chain rule. The
# name `dx` is the change of `x`:

# %%
display(source(sensitivities.change), source(sensitivities.by_chain_rule))

# %% [markdown]
# $S$ itself changes with $p$ and $r$, although $t$ stays. Since $t$ is the integral of
# $dS/\sqrt{(1-pS^2)(1-rS^2)}$ from $0$ to $S$, its change is zero:
#
# $$0=\frac1{CD}\,\frac{\partial S}{\partial r}+\frac12F,\qquad F=\int_0^t\frac{S^2}{D^2}\,dt.$$
#
# The chapter solves this, and the relations above for the changes of $C$ and $D$:

# %%
for name, form in zip("SCD", sensitivities.ALONG_R, strict=True):
    display(equation(rf"\frac{{\partial {name}}}{{\partial r}}", form))

# %% [markdown]
# and nothing divides by $p$, $r$ or $p-r$, so symmetric bodies and the separatrix are no exceptions. ($D$ is
# positive where $0\le r\le p$, which an order of the axes gives.) Compare with a quotient of differences:

# %%
p, r, t_ = 2.0, 0.7, 0.9
S_t, C_t, D_t, F_t = symbols("S_t C_t D_t F_t")
start = [0.0, 1.0, 1.0, 0.0]


def functions(r):
    """S, C, D and F at the time t, integrated."""

    def slopes(_, y):
        S, C, D, _ = y
        return C * D, -p * S * D, -r * S * C, (S / D) ** 2

    return solve_ivp(slopes, (0, t_), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]


inputs = symbols("p r"), S_t, C_t, D_t, F_t
by_formula = sympy.lambdify(inputs, [x.value for x in sensitivities.ALONG_R])
derived = np.array(by_formula((p, r), *functions(r)))
quotients = (functions(r + 1e-4) - functions(r - 1e-4))[:3] / 2e-4
print("they agree to 1e-7:", bool(abs(derived - quotients).max() < 1e-7))

# %% [markdown]
# The ledger says that the changes `dS_t`, `dC_t` and `dD_t`, for any `dp` and `dr`, satisfy the
# variation of these equations, and that those of the rates satisfy the variation of Euler's:

# %%
ledger = sealed()
show(ledger, "varied_regular.variation", "varied.variation")

# %% tags=["hide-cell"]
assert grades(ledger, "varied_regular.variation", "varied.variation") == {"PROVED"}
assert abs(derived - quotients).max() < 1e-7
ledger = builder.ledger
assert grades(ledger, *ledger.facts) == {"PROVED"}
assert grades(varied_book.ledger, "line32.by_invariants") == {"PROVED"}
assert grades(regular.ledger, *regular.ledger.facts) == {"PROVED"}
assert grades(general.ledger, *general.ledger.facts) == {"PROVED"}
assert grades(matrices.ledger, *matrices.ledger.facts) == {"PROVED"}
derived_here = ("variation.euler", "body.lax", "partner.found", "flow.lax", "reduced.conjugate",
                "compared.phi3", "line32.by_invariants", "gyrostat.quartic", "pencil.quartic")  # fmt: skip
assert {*derived_here} <= {*ledger.facts}
assert len(refusals) == 7
assert all("\n" not in refusal for refusal in refusals)
# The illustration agrees with the facts.
assert gap < 1e-9
assert np.allclose(squares, 1e6 * np.array(polynomial(along)[0]), rtol=0, atol=1e-6 * squares.max())
assert np.ptp(np.linalg.norm(momentum(*rates), axis=0)) < 1e-10 * size
