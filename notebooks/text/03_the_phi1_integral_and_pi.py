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
# # 3. The $\phi_1$ integral and $\Pi$
#
# [Notebook 2](02_from_lax_pair_to_k_a1.ipynb) turned the momentum onto the axis $A_1$ and read two
# of the three angles of $\bar R=\exp(\phi_1A_1)\exp(\phi_2A_2)\exp(\phi_3A_1)$ off the momentum in
# the body. The remaining angle $\phi_1$ is the turn about the momentum itself. In terms of Euler's
# angles: $\phi_3$ is the spin of the body about its own first axis, $\phi_2$ the nutation of that
# axis, and $\phi_1$ its precession about the momentum.
#
# This notebook derives $\phi_1$, following equations (30) to (36): its rate from the kinematics,
# the rate as a function of $\Omega_1$ alone, and its integral as Legendre's integral of the third
# kind. Each cell runs a step of the derivation, as the chapters `derivations/kinematics.py`,
# `phi1_integral.py` and `winding.py` do, and shows the line that came out.

# %% tags=["hide-input"]
import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
import sympy
from IPython.display import display

from derivations import lemma1
from derivations.conjugacy import MOMENTUM, PHI, TURNING, K, Reduction, by_angles
from derivations.euler_lax import MOMENTA, RATES, Dynamics
from derivations.kinematics import BODY_RATES, UNKNOWN
from derivations.lie_algebra import A, M, Omega, R, combination, commutator
from derivations.phi1_integral import (
    AMPLITUDE,
    DN,
    FUNCTIONS,
    MU,
    SN,
    XI,
    ZETA,
    H,
    T,
    constants,
    sine,
)
from derivations.setting import Setting
from derivations.winding import INTEGRAL
from derivations.winding import TURNING as HALF_TURNS
from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.language.functions import NUMPY
from rigidsym.proof.algebra import Part
from rigidsym.proof.kernel import Grade
from rigidsym.proof.paper import verdicts
from rigidsym.proof.steps import (
    Rate,
    Scope,
    apart,
    coordinates,
    differentiate,
    eliminate,
    integrate,
    multiply,
    nonnegative,
    rate_of,
    rewrite,
    solve,
)
from rigidsym.proof.steps._names import read, symbol, symbols
from support import begun, definitions, equation, grades, lines, printed, show, step

verdict = {v.equation.number: v for v in verdicts(ledger_data(ledger_text()))}

# %% [markdown]
# ## The choices
#
# The setting is the paper's. **Change it here and run on**: `Setting(sequence=(3, 2, 1))` for other
# axes of the three turns, `Setting(sign=-1)`, `Setting(factor=1)` or `Setting(order=(2, 3, 1))` for
# another basis. (A body with wheels needs other steps, because its rate is no multiple of
# $\mathrm{sn}$; [notebook 11](11_derive_your_own.ipynb) derives one.) The builder starts where
# notebook 2 ended.

# %%
setting = Setting()

builder = begun(setting, "conjugacy")
dynamics, reduction = builder.result(Dynamics), builder.result(Reduction)
display(step(builder, "three_angles.momentum"))
display(step(builder, "compared.phi2"), step(builder, "compared.phi3"))

# %% [markdown]
# ## The angular velocity in terms of the angles
#
# Put $\bar R$ into $\bar R^{-1}\dot{\bar R}=\Omega$. In the context `turning` the rates of the
# angles are arbitrary. SymPy multiplies out in half angles, which gives about a hundred terms, and
# the kernel confirms the three coordinates to which they simplify.

# %%
parts = (MOMENTUM, TURNING, BODY_RATES, *reduction.angles)
scope = Scope.open(builder, "turning", *parts, matrices=reduction.matrices)
why = "the velocity in the body, multiplied out"
velocity = coordinates(scope, "turning.velocity", R.I * Rate(R), A, why, ["R^-1 dR/dt"])
display(velocity, printed("R^-1 dR/dt"))

# %% [markdown]
# The coordinates are the body rates. They are linear in the rates of the angles, so we solve for
# these. The paper instead multiplies (30) by a phase that makes the right side free of $\phi_3$,
# which is (31). The quotient needs $\sin\phi_2\ne0$, and the step says so.

# %%
unknown = Part(witness=dict.fromkeys(map(str, UNKNOWN), "1"), reading=TURNING.reading)
scope = Scope.open(builder, "velocity", BODY_RATES, unknown, *reduction.circles, static=True)
equations = list(zip(RATES, velocity.value, strict=True))
why = "R' = R Omega, solved for the rates of the angles"
rates = solve(scope, "rates.angles", equations, UNKNOWN, why, ["3", "30", "31"])
first, second, third = (k - 1 for k in setting.axes)
why = "phi3' without a denominator"
last = solve(scope, "velocity.phi3", [equations[first]], UNKNOWN[2:], why, ["3"])
display(rates, last)

# %% [markdown]
# Now insert the result of notebook 2: $\Omega_k=M_k/c_k$, with the momentum $M$ as a function of
# $\phi_2$ and $\phi_3$.

# %%
there = (dynamics.parameters, MOMENTUM, *reduction.circles)
body = by_angles(builder, reduction, *there)
scope = Scope.open(builder, "on_momentum", *there, body, static=True)
rate, put_in = rates[UNKNOWN[0]], {w: scope.read(body.definitions[str(w)]) for w in RATES}
named = Part(
    units=tuple(map(scope.text, scope.divisors(rate))),
    definitions={"phi1_rate": scope.text(rate)},
)
scope = Scope.open(builder, "line32", *there, named, body, static=True)
by_phi, why = scope.reduced(rate.subs(put_in)), "phi1' with the momentum put in"
rewrite(scope, "line32.by_angles", UNKNOWN[0], by_phi, why, ["32"], "substitute")

# %% [markdown]
# The expression that was $\frac00$ at the pole $\sin\phi_2=0$ now has no denominator. Since
# $\cos^2\phi_3+\sin^2\phi_3=1$, the rate $\dot\phi_1$ is a weighted mean of $K/c_2$ and $K/c_3$. It
# always lies between them, and so **$\phi_1$ always increases.**
#
# The paper goes the other way and replaces the angles by the momentum. (28) gives $\cos\phi_3$ and
# $\sin\phi_3$; the remaining $\sin^2\phi_2$ is one minus the square of $M_1/K$.

# %%
w = 2 * setting.factor
halves = [f(w * PHI[2]) for f in (sympy.cos, sympy.sin)]
gaps = [MOMENTA[k] - K * reduction.direction[k] for k in (second, third)]
(angles,) = sympy.solve(gaps, halves, dict=True)
above, below = sympy.fraction(sympy.together(rate.subs(angles)))
_, pole = setting.nutation(PHI[1])
across = (MOMENTA[second] ** 2 + MOMENTA[third] ** 2) / K**2
quotient = sympy.cancel(above / below.subs(pole**2, across))
quotient = scope.reduced(quotient.subs(dict(zip(MOMENTA, dynamics.momenta, strict=True))))
why = "phi1' with the momentum in the place of the angles"
line = rewrite(scope, "line32.rate", UNKNOWN[0], quotient, why, ["32"], "substitute")
display(line, printed("32"))

# %% [markdown]
# ## One function of time is enough
#
# The fraction contains two rates, and equation (6) gives two conserved quantities. Both are linear
# in the squares of the rates. We eliminate two of these squares, and the rate of $\phi_1$ then
# depends on the third rate alone.

# %%
squares = [RATES[second] ** 2, RATES[third] ** 2]
energy = 2 * H - 2 * read(dynamics.body.definitions["H"])
momentum = K**2 - sum(x**2 for x in dynamics.momenta)
invariants, why = [energy, momentum], "two rates eliminated by H and K"
fact, of = "line32.by_invariants", UNKNOWN[0]
one_rate = eliminate(scope, fact, line.value, invariants, squares, why, ["33"], of)
display(one_rate, printed("33"))

# %% [markdown]
# So far we know: *if* there is such a motion, its angles have these rates. The paper leaves the
# converse to the reader: if the angles have these rates,

# %%
parts = (dynamics.parameters, MOMENTUM, *reduction.angles)
text = Scope(builder, builder.ledger.contexts["turning"], {}).text
values = (by_phi, rates[UNKNOWN[1]], last[UNKNOWN[2]])
moves = Part(definitions={str(x): text(value) for x, value in zip(UNKNOWN, values, strict=True)})
matrices = {
    **reduction.matrices,
    "M": combination("M1 M2 M3"),
    "Omega": combination("Omega1 Omega2 Omega3"),
}
body = by_angles(builder, reduction, *parts)
scope = Scope.open(builder, "three_angle_motion", *parts, body, moves, matrices=matrices)
for name in UNKNOWN:
    display(equation(name, scope.read(moves.definitions[str(name)])))

# %% [markdown]
# then $\bar R$ satisfies the kinematics (3), and the body rates satisfy Euler's equations (5).

# %%
why = "angles that move so carry a motion"
display(multiply(scope, "three_angle_motion.kinematics", Rate(R), R * Omega, why, ["3", "25"]))
why = "whose rates satisfy Euler's equations"
bracket = commutator(M, Omega)
display(multiply(scope, "three_angle_motion.euler", Rate(M), bracket, why, ["5", "7"]))

# %% [markdown]
# ## Lemma 1, in brief
#
# Lemma 1 gives that one rate as a function of time. The same elimination, applied to the *square*
# of $\dot\Omega_i$, gives a polynomial in $\Omega_i^2$; its roots are (13), and an ansatz
# $\zeta\,\mathrm{sn}(\xi t+C\,|\,\mu)$ matches it in two ways. The chapter `derivations/lemma1.py`
# has these steps, for any cyclic order $(i,j,k)$ of the axes:

# %%
lemma1.derive(builder)
lines(builder, "10", "13", "14")

# %% [markdown]
# ## Partial fractions
#
# So $\Omega_1=\zeta\,\mathrm{sn}(\xi t+\gamma\,|\,\mu)$. Inserted into (33), it gives a fraction in
# $\mathrm{sn}^2$. SymPy's partial fractions split it into a constant and a multiple of
# $1/(1-n\,\mathrm{sn}^2)$. The hypothesis that this needs is shown below the line: the momentum
# must not meet axis 1.

# %%
axis = setting.axes[0]
given = (constants(axis), FUNCTIONS, sine(axis))
scope = Scope.open(builder, "sine_motion", *given, static=True)
split = apart(one_rate.value.subs(RATES[first], ZETA * SN), SN**2)
why = "with the rate put in, partial fractions in sn^2"
rewrite(scope, "sine_motion.split", one_rate.value, split, why, ["34"], "partial_fractions")

# %% [markdown]
# ## Legendre's integral of the third kind
#
# With
#
# $$\Pi(n;\vartheta\,|\,m)=\int_0^\vartheta\frac{d\theta}{(1-n\sin^2\theta)\sqrt{1-m\sin^2\theta}},
# \qquad \frac{d}{dt}\Pi(n;\mathrm{am}(\xi t+\gamma)\,|\,\mu)=\frac{\xi}{1-n\,\mathrm{sn}^2}$$
#
# the integral is a matter of looking it up. The *table* is a context with a generator `Pi` that moves by
# the right side of that second formula; what the name stands for is its *reading*, the one thing the
# kernel cannot check and a reader should. $n$ is read off the fraction above.

# %%
(fraction,) = (term for term in split.args if term.has(SN))
n = -sympy.expand(sympy.denom(fraction)).coeff(SN**2) / sympy.denom(fraction).subs(SN, 0)
table = Part(
    witness={"Pi": "0", "t": "0"},
    definitions={"n": str(n)},
    rates={"Pi": "xi/(1 - n*sn**2)", "t": "1"},
    units=("xi",),
    reading={"Pi": "elliptic_pi(n, jacobi_am(xi*t + gamma, mu), mu)", "t": "time, s"},
)
scope = Scope.open(builder, "table", *given, table)
known = {T: sympy.S.One, symbol("Pi"): XI / (1 - n * SN**2)}
why = "integrated term by term, by the table that has the rate of Pi"
integral = integrate(scope, "table.phi1", split, known, why, ["19", "36"])
display(equation("n", n), integral)

# %% [markdown]
# So $\phi_1=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta\,|\,m)+D$, as Theorem 1 has it, with
# $n=(c_1\zeta/K)^2=c_1^2s_1/K^2$. Differentiated, it is (33) again:

# %%
kappa, steady = (integral.value.coeff(symbol(name)) for name in ("Pi", "t"))
named = Part(definitions={"kappa": scope.text(kappa), "phi1": f"{scope.text(steady)}*t + kappa*Pi"})
scope = Scope.open(builder, "third_kind", *given, table, named)
slope, why = rate_of(symbol("phi1")), "so phi1 has the rate (33)"
done = rewrite(scope, "third_kind.phi1", slope, one_rate.value, why, ["19", "33"], "differentiate")
display(definitions(builder.ledger, "third_kind", "n", "kappa", "phi1"), done)

# %% [markdown]
# Theorem 1 prints $n=s_1/K^2$ and lacks the $c_1^2$:

# %%
verdict["20"]

# %% [markdown]
# ## The amplitude, and a misprint
#
# The paper takes the amplitude $\vartheta=\mathrm{am}(\xi t+\gamma\,|\,\mu)$ as its variable. Since
# $\dot\vartheta=\xi\,\mathrm{dn}$ and $\mathrm{dn}^2=1-\mu\,\mathrm{sn}^2$, there is a $\mu$ under the
# root. The paper prints $\mu^2$. That would be right if $\mu$ were the *modulus* $k$; everywhere else
# in the paper it is the *parameter* $m=k^2$, as its footnote 1 shows. A point with rational
# coordinates settles it.

# %%
scope = Scope.open(builder, "amplitude", constants(axis), FUNCTIONS, AMPLITUDE)
why = "the square of the rate of the amplitude theta"
(by_sn,) = sympy.solve(DN**2 + MU * SN**2 - 1, DN**2)
squared = rate_of(symbol("theta")) ** 2
value = XI**2 * by_sn
amplitude = rewrite(scope, "amplitude.squared", squared, value, why, ["35"], "differentiate")
display(amplitude, verdict["35"])

# %% [markdown]
# ## How $\Pi$ winds
#
# $\vartheta$ grows without bound, but tables and programs give $\Pi(n;\vartheta|m)$ only up to a
# quarter turn, or on some branch of their own. Beyond it each half turn adds the same amount,
#
# $$\Pi(n;\vartheta+k\pi\,|\,m)=2k\,\Pi(n\,|\,m)+\Pi(n;\vartheta\,|\,m).$$
#
# Algebra proves that both sides have the same derivative for $k=1$, and that the integrand has no
# pole on the way for $n<1$. At $\vartheta=-\pi/2$ they agree: from there to $\pi/2$ the integral is
# $2\Pi(n\,|\,m)$. Two functions that agree at one point and have the same derivative agree
# everywhere; this is the kernel's rule `start`. The second line is the step from $k$ half turns to
# $k+1$.

# %%
scope = Scope.open(builder, "windings", HALF_TURNS, INTEGRAL)
later, Pi, complete, n_, theta = symbols("Pi_later Pi Pi_c n theta")
rest, why = later - 2 * complete - Pi, "what half turns add grows no further"
display(differentiate(scope, "windings.slope", rest, why, ["19", "20", "21"]))
sin, cos = sympy.sin(theta), sympy.cos(theta)
path, why = 1 - n_ * sin**2, "the integral meets no pole"
form = sympy.collect(sympy.expand(path - 1 + cos**2 + sin**2), sin**2)
display(nonnegative(scope, "windings.path", path, form, why, ["19"]))
rule = {"Pi_later": "2*Pi_c + Pi", "2*k*Pi_c + Pi_later": "2*(k + 1)*Pi_c + Pi"}
builder.start("windings.rule", rule, ["19", "20", "21"])
show(builder.ledger, "windings.rule")

# %% [markdown]
# ## Seen on a motion
#
# *From here on: numerical illustrations, not proofs.* The constants of Lemma 1 are real on the
# middle axis, so we number the axes of the paper's spacecraft such that the middle axis is 1. The
# cyclic order $(2,3,1)$ of its moments and rates describes the same body and the same motion.

# %%
original = paper_case().motion
order = [(1 + k - first) % 3 for k in range(3)]
motion = TorqueFreeMotion([original.inertia[k] for k in order], [original.omega0[k] for k in order])
print("inertia:        ", *map(float, motion.inertia), "kg m^2")
print("rates at t = 0: ", *map(float, motion.omega0), "rad/s")
print(motion.regime)

mp.mp.dps = 40
INERTIA = symbols("c1 c2 c3")
body = {
    name: mp.mpf(x.numerator) / x.denominator
    for names, values in ((INERTIA, motion.exact["inertia"]), (RATES, motion.exact["omega0"]))
    for name, x in zip(names, values, strict=True)
}


def number(expression):
    """What an expression of the derivation is for this body."""
    names = sorted(expression.free_symbols, key=str)
    return sympy.lambdify(names, expression, "mpmath")(*(body[name] for name in names))


body[H] = number(read(dynamics.body.definitions["H"]))
body[K] = mp.sqrt(sum(number(m) ** 2 for m in dynamics.momenta))
body[symbol("K_squared")] = body[K] ** 2

# %% [markdown]
# The numbers of the motion come from the lines above, not from a copy of them. Of the two roots the
# smaller one is $\zeta^2$, and $\xi^2$ is $\alpha$ times the other. The start $\gamma$ follows from
# $\Omega_1(0)=\zeta\,\mathrm{sn}\,\gamma$ and the sign of $\dot\Omega_1(0)$, as in Remark 1.

# %%
cyclic = {
    symbol(f"{name}_{x}"): symbol(f"{name}{(first + k) % 3 + 1}")
    for name in ("c", "Omega")
    for k, x in enumerate("ijk")
}
lemma = builder.result(lemma1.Lemma1)
alpha = number(read(lemma.quartic.definitions["alpha"]).subs(cyclic))
roots = [number(root.subs(cyclic)) for root in step(builder, "factored.roots").value]
s1, s2 = sorted(roots)
rising = mp.sign(number(read(dynamics.body.rates[str(RATES[first])])))
body[ZETA], body[MU], body[XI] = mp.sqrt(s1), s1 / s2, rising * mp.sqrt(alpha * s2)
zeta, mu, xi = body[ZETA], body[MU], body[XI]
gamma = mp.ellipf(mp.asin(body[RATES[first]] / zeta), mu)
characteristic, factor, mean = number(n), number(kappa), number(steady)
shown = {"zeta": zeta, "xi": xi, "mu": mu, "n": characteristic, "kappa": factor}
for name, value in shown.items():
    print(f"{name:>5} = {mp.nstr(value, 12)}")


# %%
def sn(t):
    """sn(xi t + gamma | mu)"""
    return mp.ellipfun("sn", xi * t + gamma, m=mu)


def amplitude_at(t):
    """am(xi t + gamma | mu), continuous in t."""
    u = xi * t + gamma
    half_turns = mp.nint(u / (2 * mp.ellipk(mu)))
    return half_turns * mp.pi + mp.asin(mp.ellipfun("sn", u - half_turns * 2 * mp.ellipk(mu), m=mu))


def third_kind(theta):
    """Pi(n; theta | mu), wound by the rule above."""
    half_turns = mp.nint(theta / mp.pi)
    rest = mp.ellippi(characteristic, theta - half_turns * mp.pi, mu)
    return 2 * half_turns * mp.ellippi(characteristic, mu) + rest


def phi1(t):
    """The closed form, from phi1(0) = 0."""
    ends = [third_kind(amplitude_at(s)) for s in (t, 0)]
    return mean * t + factor * (ends[0] - ends[1])


of_one_rate = sympy.lambdify((RATES[first], *INERTIA, H, K), one_rate.value, "mpmath")


def phi1_rate(t):
    """The integrand of (33)."""
    return of_one_rate(zeta * sn(t), *(body[name] for name in (*INERTIA, H, K)))


times = [mp.mpf(20) * k for k in range(10)]
summed = mp.quad(phi1_rate, times)
print(f"phi1(180 s) by quadrature of (33): {mp.nstr(summed, 30)} rad")
print(f"phi1(180 s) by Pi:                 {mp.nstr(phi1(180), 30)} rad")
print("they agree to 30 digits:", bool(abs(summed - phi1(180)) < mp.mpf(10) ** -30 * abs(summed)))

# %% [markdown]
# Together with $\phi_2$ and $\phi_3$ from the momentum, and with (37), $\phi_1$ gives the same
# attitude as the generated code. (This uses continuous angles. [The next
# notebook](04_no_sign_functions.ipynb) shows how Theorem 1's own half angles fail. In another basis
# than the paper's, a quaternion has other components, so nothing is compared.)

# %%
t = np.linspace(0, 180, 61)
q, omega = motion(t)
momentum = omega * np.array(list(map(float, motion.inertia)))
with mp.workdps(20):
    outer_turn = np.array([float(phi1(mp.mpf(float(s)))) for s in t])


def along_the_motion(expression):
    """The values of a quotient of the momentum's components."""
    found = sympy.lambdify((*MOMENTA, K), expression.subs(pole, 1), "numpy")
    return found(*momentum.T, float(body[K]))


((function, value),) = step(builder, "compared.phi2").value.items()
inverse = np.arccos if isinstance(function, sympy.cos) else np.arcsin
nutation = inverse(along_the_motion(value)) / float(w)
cosine, sine = map(along_the_motion, step(builder, "compared.phi3").value.values())
spin = np.unwrap(np.arctan2(sine, cosine)) / float(w)


def product(p, q):
    """Products of quaternions, scalar first."""
    p0, p1, p2, p3 = np.moveaxis(p, -1, 0)
    q0, q1, q2, q3 = np.moveaxis(q, -1, 0)
    return np.stack(
        [
            p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
            p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
            p0 * q2 + p2 * q0 + p3 * q1 - p1 * q3,
            p0 * q3 + p3 * q0 + p1 * q2 - p2 * q1,
        ],
        axis=-1,
    )


def about(angle, axis):
    """exp(angle A_axis) as a quaternion."""
    turned = np.zeros((*np.shape(angle), 4))
    turned[..., 0], turned[..., axis] = np.cos(angle / 2), np.sin(angle / 2)
    return turned


turns = [about(*pair) for pair in zip((outer_turn, nutation, spin), setting.sequence, strict=True)]
Rbar = product(product(turns[0], turns[1]), turns[2])
pulled_back = product(Rbar[0] * [1, -1, -1, -1], Rbar)
same_basis = setting.basis() == Setting().basis()
if same_basis:
    print("the same attitude, to 1e-13:", bool(np.abs(pulled_back - q).max() < 1e-13))

# %% tags=["hide-input"]
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8))
fine = [mp.mpf(k) for k in range(0, 181, 2)]
x = np.array(list(map(float, fine)))
mp.mp.dps = 15
wave = np.array([float(phi1(s) - mean * s) for s in fine])
left.plot(x, wave, color="C0", lw=2, label=r"$\kappa\,\Pi$, wound")
branch = [mp.ellippi(characteristic, mp.asin(mp.sin(amplitude_at(s))), mu) for s in fine]
unwound = [float(factor * (value - branch[0])) for value in branch]
left.plot(x, unwound, color="C3", lw=1, ls="--", label=r"$\kappa\,\Pi$ of $\arcsin\mathrm{sn}$")
left.set(xlabel="time (s)", ylabel=r"$\phi_1$ less what is steady (rad)")
left.legend(fontsize=9)
right.plot(x, [float(phi1_rate(s)) for s in fine], color="C0", lw=2, label=r"$\dot\phi_1$")
bounds = {f"K/c_{k + 1}": float(body[K] / body[INERTIA[k]]) for k in (second, third)}
for name, value in bounds.items():
    right.axhline(value, color="0.5", lw=1, ls=":")
    right.annotate(f"${name}$", (1.02, value), xycoords=right.get_yaxis_transform(), va="center")
x = np.linspace(0, 180, 3601)
squared = NUMPY["jacobi_sn"](float(xi) * x + float(gamma), float(mu)) ** 2
printed_n = float(characteristic / body[INERTIA[first]] ** 2)
wrong = float(mean) + float(factor * xi) / (1 - printed_n * squared)
wrong = np.where(abs(wrong) < 2, wrong, np.nan)
right.plot(x, wrong, color="C3", lw=1, ls="--", label="printed $n$")
top = max(bounds.values())
right.set(xlabel="time (s)", ylabel="rad/s", ylim=(-0.5 * top, 1.5 * top))
right.legend(fontsize=9)
figure.tight_layout()

# %% [markdown]
# Left: the contribution of $\Pi$ to $\phi_1$ is a straight line with a wave on it. Without the
# winding rule, on the branch of the inverse sine, it would turn back at every quarter period.
# Right: $\dot\phi_1$ stays between $K/c_2$ and $K/c_3$. With Theorem 1's printed $n$, too large by
# $1/c_1^2=625$ for this body, $1-n\,\mathrm{sn}^2$ has zeros and the rate has poles.
#
# ## What we have
#
# We have all three angles of a motion, with one integral. [Notebook 4](04_no_sign_functions.ipynb)
# shows how Theorem 1 uses them and where its signs are wrong. The last cell, folded, checks the
# statements of this notebook. (A test elsewhere compares the facts above with those of the
# chapters.)

# %% tags=["hide-cell"]
ledger = builder.ledger
assert grades(ledger, *ledger.facts) == {Grade.PROVED}
earned = {
    "R^-1 dR/dt": ["turning.velocity"],
    "30": ["rates.angles"],
    "31": ["rates.angles"],
    "32": ["line32.by_angles", "line32.rate"],
    "33": ["line32.by_invariants", "third_kind.phi1"],
    "34": ["sine_motion.split"],
    "35": ["amplitude.squared"],
    "36": ["table.phi1"],
    "3": ["velocity.phi3", "three_angle_motion.kinematics"],
    "5": ["three_angle_motion.euler"],
    "13": ["factored.roots"],
    "14": ["eliminated.square", "axis.quartic"],
}
for number_, facts in earned.items():
    assert all(number_ in ledger.facts[fact].source for fact in facts), number_
# The illustration agrees with the facts.
assert abs(summed - phi1(180)) < mp.mpf(10) ** -13 * abs(summed)
assert not same_basis or np.abs(pulled_back - q).max() < 1e-13
assert min(bounds.values()) < float(phi1_rate(0)) < max(bounds.values())
