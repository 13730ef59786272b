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
# This notebook follows the derivation of $\phi_1$, equations (30) to (36): its rate from the
# kinematics, the rate as a function of $\Omega_1$ alone, and its integral as Legendre's integral of
# the third kind. It calculates with plain SymPy where that takes a few lines. The framed lines are
# those of the chapters `derivations/kinematics.py`, `phi1_integral.py`, `winding.py` and
# `lemma1.py`, which the kernel has decided.

# %%
import matplotlib.pyplot as plt
import mpmath as mp
import numpy as np
import sympy

from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case
from rigidsym.language.functions import NUMPY
from rigidsym.quaternions import conjugate, of_rotation_vectors, product
from support import definitions, grades, judged, printed, show
from support.names import MOMENTA, PHI, RATES, K, read, symbol, symbols
from support.steps import Setting, begun, display, lines, step

# %% [markdown]
# ## The choices
#
# The setting is the paper's. **Change it here and run on**: `Setting(sequence=(3, 2, 1))` for other
# axes of the three turns, `Setting(sign=-1)`, `Setting(factor=1)` or `Setting(order=(2, 3, 1))` for
# another basis, `Setting(group="SO3")` for rotation matrices. (A body with wheels needs other steps, because its rate is no multiple of
# $\mathrm{sn}$; [notebook 11](11_derive_your_own.ipynb) derives one.) The first framed lines are
# the results of notebook 2, where $R$ stands for $\bar R$.

# %%
setting = Setting()

builder = begun(setting, "lemma1")
lines(builder, "three_angles.momentum", "compared.phi2", "compared.phi3")

# %% [markdown]
# ## The angular velocity in terms of the angles
#
# Put $\bar R$ into $\bar R^{-1}\dot{\bar R}=\Omega$. The rates of the angles are arbitrary here.
# SymPy multiplies out in half angles, which gives about a hundred terms, and the kernel confirms
# the three coordinates to which they simplify. Below them is the printed equation.

# %%
display(lines(builder, "turning.velocity"), printed("R^-1 dR/dt"))

# %% [markdown]
# The coordinates are the body rates. They are linear in the rates of the angles, so they can be
# solved for these. The paper instead multiplies (30) by a phase that makes the right side free of
# $\phi_3$, which is (31). The quotient needs $\sin\phi_2\ne0$, and the line says so.

# %%
lines(builder, "rates.angles", "velocity.phi3")

# %% [markdown]
# Now insert the result of notebook 2: $\Omega_k=M_k/c_k$, and $M_k$ is $K$ times a function of
# $\phi_2$ and $\phi_3$. The expression that was $\frac00$ at the pole $\sin\phi_2=0$ has no
# denominator any more.

# %%
INERTIA = symbols("c1 c2 c3")
axes = zip(RATES, step(builder, "three_angles.momentum").value, INERTIA, strict=True)
by_angles = {rate: K * direction / c for rate, direction, c in axes}
sympy.cancel(step(builder, "rates.angles")[symbol("phi1_rate")].subs(by_angles))

# %%
lines(builder, "line32.by_angles")

# %% [markdown]
# Since $\cos^2\phi_3+\sin^2\phi_3=1$, the rate $\dot\phi_1$ is a weighted mean of $K/c_2$ and
# $K/c_3$. It always lies between them, and so **$\phi_1$ always increases.**
#
# The paper goes the other way and replaces the angles by the momentum. (28) gives $\cos\phi_3$ and
# $\sin\phi_3$; the remaining $\sin^2\phi_2$ is one minus the square of $M_1/K$.

# %%
display(lines(builder, "line32.rate"), printed("32"))

# %% [markdown]
# ## One function of time is enough
#
# The fraction contains two rates, and equation (6) gives two conserved quantities. Both are linear
# in the squares of the rates. We eliminate two of these squares, and the rate of $\phi_1$ then
# depends on the third rate alone.

# %%
H = symbol("H")
first, second, third = (k - 1 for k in setting.axes)
squares = [RATES[second] ** 2, RATES[third] ** 2]
energy = sum(c * rate**2 for c, rate in zip(INERTIA, RATES, strict=True)) - 2 * H
momentum = sum(c**2 * rate**2 for c, rate in zip(INERTIA, RATES, strict=True)) - K**2
(known,) = sympy.solve([energy, momentum], squares, dict=True)
step(builder, "line32.rate").value.subs(known).factor()

# %%
one_rate = step(builder, "line32.by_invariants")
display(one_rate, printed("33"))

# %% [markdown]
# So far we know: *if* there is such a motion, its angles have these rates. The paper leaves the
# converse to the reader. If the angles have the rates that `line32.by_angles`, `rates.angles` and
# `velocity.phi3` give, then $\bar R$ satisfies the kinematics (3), and the body rates satisfy
# Euler's equations (5):

# %%
lines(builder, "three_angle_motion.kinematics", "three_angle_motion.euler")

# %% [markdown]
# ## Lemma 1, in brief
#
# Lemma 1 gives that one rate as a function of time. The same elimination, applied to the *square*
# of $\dot\Omega_i$, gives a polynomial in $\Omega_i^2$, and its roots are (13). An ansatz
# $\zeta\,\mathrm{sn}(\xi t+C\,|\,\mu)$ matches it in two ways: $s_i$ and $s_j$ are the roots, $v$ is
# $\mathrm{sn}^2$, and $\alpha$ is the leading coefficient. $(i,j,k)$ is any cyclic order of the axes.

# %%
lines(builder, "eliminated.square", "factored.roots", "matched.amplitude", "sine.solves")

# %% [markdown]
# ## Partial fractions
#
# So $\Omega_1=\zeta\,\mathrm{sn}(\xi t+\gamma\,|\,\mu)$. Inserted into (33), it gives a fraction in
# $s=\mathrm{sn}^2$. SymPy's partial fractions split it into a constant and a multiple of
# $1/(1-n\,s)$.

# %%
s, zeta_ = symbols("s zeta")
sympy.apart(one_rate.value.subs(RATES[first], zeta_ * sympy.sqrt(s)), s)

# %% [markdown]
# The hypothesis that this needs is shown below the framed line: the momentum must not meet axis 1.

# %%
lines(builder, "sine_motion.split")

# %% [markdown]
# ## Legendre's integral of the third kind
#
# With
#
# $$\Pi(n;\vartheta\,|\,m)=\int_0^\vartheta\frac{d\theta}{(1-n\sin^2\theta)\sqrt{1-m\sin^2\theta}},
# \qquad \frac{d}{dt}\Pi(n;\mathrm{am}(\xi t+\gamma)\,|\,\mu)=\frac{\xi}{1-n\,\mathrm{sn}^2}$$
#
# the integral is a matter of looking it up. The *table* is a context with a quantity $\Pi$ that has
# the second formula as its derivative. That this quantity is Legendre's integral is the one thing
# that the kernel cannot check and a reader should. $n$ is read off the fraction above.

# %%
display(lines(builder, "table.phi1"), definitions(builder.ledger, "third_kind", "n", "kappa"))

# %% [markdown]
# So $\phi_1=\frac K{c_1}t+\kappa\,\Pi(n;\vartheta\,|\,m)+D$, as Theorem 1 has it, with
# $n=(c_1\zeta/K)^2=c_1^2s_1/K^2$. Differentiated, it is (33) again:

# %%
lines(builder, "third_kind.phi1")

# %% [markdown]
# Theorem 1 prints $n=s_1/K^2$ and lacks the $c_1^2$:

# %%
verdict = judged()
verdict["20"]

# %% [markdown]
# ## The amplitude, and a misprint
#
# The paper takes the amplitude $\vartheta=\mathrm{am}(\xi t+\gamma\,|\,\mu)$ as its variable; it is
# $\theta$ in the framed line. Since $\dot\vartheta=\xi\,\mathrm{dn}$ and
# $\mathrm{dn}^2=1-\mu\,\mathrm{sn}^2$, there is a $\mu$ under the root. The paper prints $\mu^2$. That
# would be right if $\mu$ were the *modulus* $k$; everywhere else in the paper it is the *parameter*
# $m=k^2$, as its footnote 1 shows. A point with rational coordinates settles it.

# %%
display(lines(builder, "amplitude.squared"), verdict["35"])

# %% [markdown]
# ## How $\Pi$ winds
#
# $\vartheta$ grows without bound, but tables and programs give $\Pi(n;\vartheta|m)$ only up to a
# quarter turn, or on some branch of their own. Beyond it each half turn adds the same amount, twice
# the complete integral $\Pi(n\,|\,m)$, which is $\Pi_c$ in the lines:
#
# $$\Pi(n;\vartheta+k\pi\,|\,m)=2k\,\Pi(n\,|\,m)+\Pi(n;\vartheta\,|\,m).$$
#
# Algebra proves that both sides have the same derivative for $k=1$, and that the integrand has no
# pole on the way for $n<1$. At $\vartheta=-\pi/2$ they agree: from there to $\pi/2$ the integral is
# $2\Pi(n\,|\,m)$. Two functions that agree at one point and have the same derivative agree
# everywhere; this is the kernel's rule `start`. The second line of the last fact is the step from
# $k$ half turns to $k+1$.

# %%
display(lines(builder, "windings.slope", "windings.path"), show(builder.ledger, "windings.rule"))

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
body = {
    name: mp.mpf(x.numerator) / x.denominator
    for names, values in ((INERTIA, motion.exact["inertia"]), (RATES, motion.exact["omega0"]))
    for name, x in zip(names, values, strict=True)
}


def number(expression):
    """What an expression of the derivation is for this body."""
    names = sorted(expression.free_symbols, key=str)
    return sympy.lambdify(names, expression, "mpmath")(*(body[name] for name in names))


body[H] = number(energy.subs(H, 0) / 2)
body[K] = mp.sqrt(number(momentum.subs(K, 0)))
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
contexts = builder.ledger.contexts
alpha = number(read(contexts["axis"].definitions["alpha"]).subs(cyclic))
s1, s2 = sorted(number(root.subs(cyclic)) for root in step(builder, "factored.roots").value)
rising = mp.sign(number(step(builder, "variation.euler")[symbol(f"{RATES[first]}_rate")]))
zeta, mu, xi = mp.sqrt(s1), s1 / s2, rising * mp.sqrt(alpha * s2)
body |= {symbol("zeta"): zeta, symbol("mu"): mu, symbol("xi"): xi}
gamma = mp.ellipf(mp.asin(body[RATES[first]] / zeta), mu)
phi1_found = step(builder, "table.phi1").value
factor, mean = (number(phi1_found.coeff(symbol(name))) for name in ("Pi", "t"))
characteristic = number(read(contexts["third_kind"].definitions["n"]))
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
momentum_ = omega * np.array(list(map(float, motion.inertia)))
with mp.workdps(20):
    outer_turn = np.array([float(phi1(mp.mpf(float(s)))) for s in t])


def along_the_motion(expression):
    """The values of a quotient of the momentum's components."""
    found = sympy.lambdify((*MOMENTA, K), expression.subs(across, 1), "numpy")
    return found(*momentum_.T, float(body[K]))


w = float(2 * setting.factor)  # exp(phi A) turns by w phi
_, across = setting.nutation(PHI[1])
((function, value),) = step(builder, "compared.phi2").value.items()
inverse = np.arccos if isinstance(function, sympy.cos) else np.arcsin
cosine, sine = map(along_the_motion, step(builder, "compared.phi3").value.values())
angles = w * outer_turn, inverse(along_the_motion(value)), np.unwrap(np.arctan2(sine, cosine))
turns = (np.outer(x, np.eye(3)[axis - 1]) for x, axis in zip(angles, setting.sequence, strict=True))
first_turn, second_turn, third_turn = map(of_rotation_vectors, turns)
Rbar = product(product(first_turn, second_turn), third_turn)
pulled_back = product(conjugate(Rbar[0]), Rbar)
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
# statements of this notebook.

# %% tags=["hide-cell"]
ledger = builder.ledger
assert grades(ledger, *ledger.facts) == {"PROVED"}
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
