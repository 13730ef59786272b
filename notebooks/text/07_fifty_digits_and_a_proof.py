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
# # 7. Fifty digits and a proof
#
# A flight computer needs sixteen digits. Whoever wants to *know* whether those sixteen are right
# needs more, and needs to be certain of them. This notebook asks for the same state in three ways:
#
# | call | gives | promises |
# |---|---|---|
# | `motion(t)` | doubles | angles to $2\cdot10^{-15}$ rad, as measured |
# | `motion.precise(t, digits)` | mpmath numbers | every digit asked for |
# | `motion.enclose(t, digits)` | balls | the true value lies inside |
#
# and then looks at what stands behind the promises: four ways to the same number, a
# ledger of proofs, and a decision about the kind of motion that is made without rounding at all.

# %%
import flint
import matplotlib.pyplot as plt
import mpmath
import numpy as np

import rigidsym

inertia, omega0 = ("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")
motion = rigidsym.TorqueFreeMotion(inertia, omega0)

q, omega = motion.precise("180", digits=50)
print("\n".join(mpmath.nstr(x, 50) for x in (*q, *omega)))

# %% [markdown]
# That is the paper's small spacecraft after three minutes: the quaternion (scalar first, body to
# inertial), then the body rates in rad/s.
#
# mpmath shows, and computes with, as many digits as its global precision says, fifteen unless it is
# told otherwise; the numbers themselves have all fifty. Hence `nstr(x, 50)` above, and `workdps`
# around arithmetic:

# %%
with mpmath.workdps(60):
    length = mpmath.sqrt(mpmath.fdot(q, q))
print(f"|q| = {mpmath.nstr(length, 50, strip_zeros=False)}")

# %% [markdown]
# ## Exact inputs
#
# Fifty digits of a result are useless if the inputs are known to sixteen. A Python float `0.0109` is not
# 0.0109, but the nearest binary fraction:
#
# $$0.0109 \approx \frac{1570855550026829}{2^{57}} .$$
#
# Therefore floats mean their exact binary value, and strings, `Fraction` and `Decimal` are taken
# literally. The two inputs have two results, which differ from about the seventeenth digit on:

# %%
as_floats = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
as_strings = motion

for name, asked in (("floats ", as_floats), ("strings", as_strings)):
    print(name, mpmath.nstr(asked.precise(180, digits=30)[0][0], 30))

by_spelling = abs(as_floats.precise(180, digits=30)[0] - as_strings.precise(180, digits=30)[0])

# %% [markdown]
# ## Balls
#
# A *ball* is a midpoint and a radius. Arb, the library underneath, computes with balls so that the
# true result is inside whenever the true arguments were: each operation adds what it may have
# rounded away. No error analysis is needed, and no luck. If a ball comes out too wide, the whole
# computation is repeated with more bits.

# %%
q_balls, omega_balls = motion.enclose("180", digits=50)
for ball in q_balls:
    print(ball.str(55, radius=True))

# %% [markdown]
# What can one do with balls that one cannot do with numbers? *Refute.* Physics says that the
# momentum in space stays what it was,
#
# $$\boldsymbol L_{\text{space}}(t) = R(t)\,(c_1\Omega_1, c_2\Omega_2, c_3\Omega_3)^{\mathsf T} =
# \text{const},$$
#
# and so does the energy. If the rates, or the direction of the momentum in the body, were wrong by
# as little as $10^{-48}$, there would be differences below whose balls are *without* zero. (The
# turn $\psi$ about the momentum leaves it where it is. Its turn comes in the next section.)

# %%
DIGITS = 50


def in_space(q, body):
    """A vector in body axes, in inertial axes: for numbers of any kind."""
    q0, *v = q
    cross = [v[k - 2] * body[k - 1] - v[k - 1] * body[k - 2] for k in range(3)]
    twice = [v[k - 2] * cross[k - 1] - v[k - 1] * cross[k - 2] for k in range(3)]
    return [body[k] + 2 * q0 * cross[k] + 2 * twice[k] for k in range(3)]


def invariants(t):
    """Momentum in space (kg m^2/s), and twice the energy (J), as balls."""
    q, omega = motion.enclose(t, DIGITS)
    body = [c * w for c, w in zip(moments, omega, strict=True)]
    return [*in_space(q, body), sum(m * w for m, w in zip(body, omega, strict=True))]


with flint.ctx.workdps(DIGITS + 10):
    moments = [flint.arb(c) for c in inertia]
    before, after = invariants(0), invariants("180")
    changes = [y - x for x, y in zip(before, after, strict=True)]
    for name, change in zip(("L1", "L2", "L3", "2H"), changes, strict=True):
        print(f"change of {name}: within {change.str(3, radius=True)}")
    assert all(change.contains(0) and change.rad() < flint.arb("1e-50") for change in changes)

# %% [markdown]
# ## Four methods, and a fifth
#
# Conservation says nothing about $\psi$, and a program that agrees with itself proves little. There
# are four ways to the attitude in this project. Each finds the turn about the momentum by a formula
# of its own; Jacobi's functions have three, since the last takes them from the second:
#
# * **theta**: $q_0 + i\sigma q_a = e^{i\Lambda t}\,\vartheta_4(v - i\rho b\,|\,q^2)/N$, two theta
#   functions; the default;
# * **carlson**: Jacobi's functions by inverting $R_F$, the elliptic integral of the third kind as
#   Carlson's $R_J$;
# * **landen**: Landen's and Gauss's descents to where trigonometry is near enough, with a bound for
#   what is left out;
# * **quadrature**: Jacobi's functions as in *carlson*, but $\psi$ from an integral
#   $\int\sin^2\varphi\,/\,\bigl((1 - n\sin^2\varphi)\,\Delta\bigr)\,d\varphi$ that is evaluated as
#   such, by rigorous quadrature.
#
# Each must return balls that overlap with those of all others.

# %%
METHODS = ("theta", "carlson", "landen", "quadrature")
states = {name: [*np.concatenate(motion.enclose("180", 50, method=name))] for name in METHODS}
for name, state in states.items():
    print(f"{name:10}", state[0].str(50))

# %% [markdown]
# And the width of the balls is what was asked for, by every method, however many digits that is.

# %%
digits = np.arange(10, 201, 10)


def widest(method, digits):
    """The largest radius among the quaternion's balls, as a power of ten."""
    q, _ = motion.enclose("180", digits, method=method)
    return np.log10(max(float(x.rad()) for x in q))


exponents = {name: [widest(name, int(d)) for d in digits] for name in METHODS}

figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.plot(digits, -digits, color="black", linewidth=1, label="asked for")
for name, mark in zip(METHODS, "osv^", strict=True):
    axes.plot(digits, exponents[name], mark, markersize=4, label=name)
axes.set_xlabel("digits asked for")
axes.set_ylabel(r"$\log_{10}$ of the largest radius")
axes.set_title("Radius of the quaternion's balls at t = 180 s")
axes.grid(alpha=0.3)
axes.legend()
plt.show()

# %% [markdown]
# The fifth method uses no elliptic functions: Taylor series of the equations of motion (3) and (5), step by
# step. It is slow, and its numbers have no error bounds, but it shares nothing with the other four except
# the physics.

# %%
from fractions import Fraction

from rigidsym.precise._taylor import integrate

q_series, omega_series = integrate(*motion.exact.values(), Fraction(180), digits=30)
q_theta, omega_theta = motion.precise("180", digits=40)
with mpmath.workdps(50):
    apart = max(
        abs(x - y)
        for x, y in zip((*q_series, *omega_series), (*q_theta, *omega_theta), strict=True)
    )
print("theta functions and Taylor series agree to 30 digits:", bool(apart < 1e-30))

# %% [markdown]
# ## The edge that floating point cannot see
#
# On the *separatrix*, $K^2 = 2Hc_b$, the body neither circulates about its largest nor about its
# smallest axis. Which motion it is depends on the sign of
#
# $$E_b = K^2 - 2Hc_b = c_a(c_a-c_b)\,\Omega_a^2 - c_d(c_b-c_d)\,\Omega_d^2 ,$$
#
# and rounding may decide it wrongly. The inputs are rational numbers, so this sign is found in
# rational arithmetic. Move one rate by one part in $10^{30}$, and the answer changes:

# %%
edge = rigidsym.TorqueFreeMotion((1, 2, "2.25"), ("0.75", "0.5", "1"))
beside = rigidsym.TorqueFreeMotion(
    (1, 2, "2.25"), ("0.75", "0.5", "1.000000000000000000000000000001")
)
below = rigidsym.TorqueFreeMotion(
    (1, 2, "2.25"), ("0.75", "0.5", "0.999999999999999999999999999999")
)
for name, case in (("1 - 1e-30", below), ("1", edge), ("1 + 1e-30", beside)):
    print(f"omega0[2] = {name:9}: {case.regime}")

# %% [markdown]
# How much does this matter? Neighbouring motions fly apart like $e^{\lambda t}$, where
# $\lambda^2 = (c_a - c_b)(K^2 - 2Hc_d)/(c_a c_b c_d)$. Below, the motions that differ by $10^{-30}$
# at the start, computed to fifty digits:

# %%
times = range(0, 241, 4)
on_edge = edge.precise(times, digits=50)[0]
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
angles = {}
for name, case, line in ((r"$+10^{-30}$", beside, "-"), (r"$-10^{-30}$", below, "--")):
    with mpmath.workdps(50):
        chords = [mpmath.norm(list(x)) for x in case.precise(times, digits=50)[0] - on_edge]
        angles[name] = np.array([float(4 * mpmath.asin(chord / 2)) for chord in chords])
    axes.semilogy(times[1:], angles[name][1:], line, label=name)
axes.axhline(2e-15, color="grey", linewidth=1, linestyle=":", label=r"$2\cdot10^{-15}$ rad")
axes.set_xlabel("t (s)")
axes.set_ylabel("angle from the separatrix motion (rad)")
axes.set_title("One part in $10^{30}$, some minutes later")
axes.grid(alpha=0.3)
axes.legend()

lambda_ = np.sqrt((2.25 - 2) * (6.625 - 3.3125) / (2.25 * 2 * 1))
slopes = [np.log(found[30] / found[10]) / (times[30] - times[10]) for found in angles.values()]

# %% [markdown]
# The double precision module carries what decides the regime in extended precision, so it follows
# the separatrix too, where the distance from it *is* zero:

# %%
q_double = edge(100.0)[0]
q_exact = edge.precise(100, digits=40)[0]
with mpmath.workdps(40):
    chord = mpmath.norm([mpmath.mpf(float(x)) - y for x, y in zip(q_double, q_exact, strict=True)])
    angle = 4 * mpmath.asin(chord / 2)
print("after 100 s, right to 2e-15 rad:", bool(angle < 2e-15))

# %% [markdown]
# ## Uncertain inputs
#
# Real moments of inertia have a tolerance. `enclose` accepts it, and returns balls that contain the states
# of *all* bodies within the tolerance. The enclosure stays rigorous and nearly as narrow as possible,
# because it uses the derivatives of the state by all inputs.

# %%
tolerance = "1e-6"
uncertain = rigidsym.TorqueFreeMotion((f"0.0109 +/- {tolerance}", "0.04", "0.0506"), omega0)
heavier = rigidsym.TorqueFreeMotion(("0.010901", "0.04", "0.0506"), omega0)

times = [str(t) for t in (1, 3, 10, 30, 100, 300, 1000)]
radii = [max(float(x.rad()) for x in state) for state in uncertain.enclose(times)[0]]
difference = heavier.precise(times)[0] - motion.precise(times)[0]
effect = np.max(np.abs(difference.astype(float)), axis=1)

figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
seconds = [float(t) for t in times]
axes.loglog(seconds, radii, "o-", label="radius of the balls: a guarantee")
axes.loglog(seconds, effect, "s-", label="effect of 1e-6 kg m² more: an example")
axes.set_xlabel("t (s)")
axes.set_ylabel("in a quaternion's component")
axes.set_title("Moment of inertia uncertain by one part in ten thousand")
axes.grid(alpha=0.3)
axes.legend()

inside = zip(uncertain.enclose(times)[0].flat, heavier.precise(times)[0].flat, strict=True)

# %% [markdown]
# If the tolerance reaches across a separatrix, even the kind of motion is uncertain. `regime` then raises
# an error that names the accuracy that would be needed. `enclose` still works, because its formulas do not
# depend on the regime:

# %%
vague = rigidsym.TorqueFreeMotion(("1 +/- 0.01", 2, "2.25"), ("0.75", "0.5", "1.001"))
try:
    vague.regime
except rigidsym.InputError as error:
    print(error)
    refused = error
print("rates after 3 s:", *vague.enclose(3)[1])

# %% [markdown]
# ## The proof
#
# Balls make sure that a formula is *evaluated* rightly. That it is the right formula is another
# matter, and settled once for all bodies and all times: every formula is a *fact* in a ledger, with
# a certificate that a small kernel can check again by nothing but polynomial multiplication. Here
# is the whole ledger, replayed in a fresh kernel:

# %%
from collections import Counter

from rigidsym.proof.kernel import Grade
from support import sealed, show

ledger = sealed()
grades = Counter(fact.grade for fact in ledger.facts.values())
print(", ".join(f"{count} facts {grade}" for grade, count in grades.most_common()))

# %% [markdown]
# Which of them stand behind the digits above? The ledger *publishes* sequences, lists of formulas in
# the order of evaluation; the numbers come from these and from nothing else. An entry is a
# proved fact, a *definition*, which says what a symbol is short for, or a *reading*, which says
# what standard function it stands for, as that of `T4_re` in the context `theta_form` does.

# %%
sequences = ledger.published["sequences"]
used = [*sequences["constants"], *sequences["theta"], *sequences["theta_state"]]
facts = [entry["fact"] for entry in used if "fact" in entry]
defined = [entry for entry in used if "definition" in entry]
readings = [entry for entry in used if "reading" in entry]
print(f"{len(facts)} facts, {len(defined)} definitions, {len(readings)} readings")

# %% [markdown]
# Four of them, and the fact that crowns them: the quaternion built from theta functions is of unit
# length and satisfies $\dot q = \tfrac12\,q\otimes(0,\Omega)$, for every body and every motion of
# its context.

# %%
CROWN = "theta_form.solution"
show(ledger, "theta_form.qbar_0", "theta_form.phase", "descended.psi_0", "regular.E_b", CROWN)

# %% [markdown]
# Two things are still trusted: that the contexts mean what their `reading` says, and that Arb balls contain
# the true values. One classical identity, of the complete $\Pi$, is graded ENCLOSED, not PROVED, because it
# was only compared with balls, not derived; no digit rests on it.
#
# An independent checker, which shares no code with the kernel, reads the same ledger:

# %%
from rigidsym.io.ledger import ledger_text
from rigidsym.proof.checker import check

accepted = check(ledger_text())
print(f"{accepted} facts accepted by the independent checker")

# %% [markdown]
# On the command line the same things are `rigidsym propagate paper --digits 50`, `rigidsym
# propagate paper --enclose --method carlson`, `rigidsym methods` (which also measures what each
# method costs), `rigidsym check` and `rigidsym check --independent`.

# %% tags=["hide-cell"]
assert abs(mpmath.fdot(q, q) - 1) < 1e-14
assert abs(length - 1) < mpmath.mpf(10) ** -49
assert as_floats.exact["inertia"][0].denominator == 2**57
assert 0 < max(by_spelling) < 1e-14
assert all(ball.rad() < flint.arb("1e-50") for ball in (*q_balls, *omega_balls))
assert all(
    x.overlaps(y)
    for one in states.values()
    for other in states.values()
    for x, y in zip(one, other, strict=True)
)
assert all(np.all(np.array(found) <= -digits) for found in exponents.values())
assert apart < 1e-30
assert edge.regime == rigidsym.Regime.SEPARATRIX
assert (below.regime, beside.regime) == (rigidsym.Regime.SMALLEST, rigidsym.Regime.LARGEST)
assert np.allclose(slopes, lambda_, rtol=0.01)
assert all(found[1] < 1e-28 and found.max() > 1 for found in angles.values())
assert angle < 2e-15
assert all(ball.contains(flint.arb(str(x))) for ball, x in inside)
assert refused.field == "inertia"
assert set(grades) == {Grade.PROVED, Grade.ENCLOSED}
assert all(ledger.facts[name].grade == Grade.PROVED for name in facts)
assert {entry["context"] for entry in (*defined, *readings)} <= set(ledger.contexts)
assert ledger.facts[CROWN].grade == Grade.PROVED
assert accepted == len(ledger.facts)
