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
# # 5. Edges
#
# Elliptic functions have two limits, $m\to1$ and $m\to0$, and a rigid body visits both. On the
# **separatrix** ($m=1$) a body that spins about its middle axis turns over once, in infinite time.
# Near the separatrix it turns over again and again: the cosmonaut Vladimir Dzhanibekov saw a wing
# nut flip in this way in orbit. A **symmetric body** ($m=0$) precesses evenly, as every thrown
# plate shows. In pure **spin**, for a **sphere** and at **rest**, the rates are constant.
#
# Programs fail in these cases: they divide $0/0$, lose $1-m$ in rounding, or take a wrong branch.
# Here no limit is taken. Each case is *decided in exact arithmetic*, and each has its own proved
# closed form.
#
# | | |
# |---|---|
# | chapters used | `regimes`, `edges`, `theta_edges`, `steady` |
# | before this | [4. No more sign functions](04_no_sign_functions.ipynb) |

# %%
from fractions import Fraction

import matplotlib.pyplot as plt
import numpy as np

from rigidsym import Regime, TorqueFreeMotion
from rigidsym.precise import PreciseMotion
from rigidsym.proof.kernel import Grade
from rigidsym.view.scenes import momentum_sphere, tumbling_body
from support import derived, grades, show, table

BLUE, RED, GREEN, PINK, BROWN = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#806000"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}

ledger = derived("regimes")  # and all chapters before it

# %% [markdown]
# ## A map of all motions
#
# Order the moments, $c_1\ge c_2\ge c_3>0$, and decide one after the other: Is the body turning? Are
# moments equal? What are the signs of
#
# $$E_1=2Hc_1-K^2,\qquad E_3=K^2-2Hc_3,\qquad E_2=K^2-2Hc_2\,?$$
#
# Every number is either positive, zero or negative, so the answers split *all* bodies and *all*
# motions into leaves that do not overlap. The ledger has this as a fact.

# %%
whole = ledger.facts["sorted_body.cases"]
proved = {
    leaf: [f"`{x.id}`" for x in ledger.facts.values() if x.context == leaf] for leaf in whole.rhs
}
table({"leaf": leaf, "what is proved of it": ", ".join(ids)} for leaf, ids in proved.items())

# %% [markdown]
# `motion.regime` decides the same signs in rational arithmetic. A float is taken at its exact
# binary value and a string at its exact decimal value. On the edge this makes a difference: with
# these decimals the motion *is* on the separatrix; with the nearest doubles, which differ in the
# seventeenth digit, it is not.

# %%
by_decimals = TorqueFreeMotion(("0.1", "0.2", "0.225"), ("0.3", "0.2", "0.4"))
by_doubles = TorqueFreeMotion((0.1, 0.2, 0.225), (0.3, 0.2, 0.4))


def excess(motion):
    """K^2 - 2 H c_b, exactly."""
    c, w = motion.exact["inertia"], motion.exact["omega0"]
    return sum(c[k] * (c[k] - sorted(c)[1]) * w[k] ** 2 for k in range(3))


table(
    {"numbers are": name, "$K^2-2Hc_b$": f"{float(excess(m)):.1e}", "regime": str(m.regime)}
    for name, m in (("decimals", by_decimals), ("doubles", by_doubles))
)

# %% [markdown]
# ## The separatrix
#
# With $m=1$ Jacobi's functions are $\mathrm{sn}=\tanh$,
# $\mathrm{cn}=\mathrm{dn}=\operatorname{sech}$:
#
# $$\Omega_a=\sigma A_a\operatorname{sech}u,\qquad\Omega_b=\chi A_b\tanh u,\qquad
# \Omega_d=\chi\tau A_d\operatorname{sech}u,\qquad u=\lambda t+u_0 .$$
#
# In the remote past the body spins about one end of its middle axis, in the remote future about the
# other. The context `separatrix` is shown to be a *model* of the regular form, so everything proved
# for the regular form holds here.

# %%
show(ledger, "separatrix.models_regular", "separatrix.middle_axis", "separatrix.euler")

# %% [markdown]
# The attitude is elementary, too. It consists of two complex numbers,
#
# $$\bar q_0+i\sigma\bar q_a=\frac{e^{i\Lambda t}}{N}\cos z,\qquad
# \bar q_b+i\epsilon\sigma\bar q_d=-\chi\,\frac{e^{i\Lambda t}}{N}\sin z,\qquad
# z=\rho\beta+iu_1,$$
#
# the cosine and the sine of an angle with constant real part. ([Notebook
# 6](06_theta_functions.ipynb) explains this form.) The facts rest on no assumption; their grade is
# PROVED.

# %%
show(ledger, "separatrix_form.models_theta_form", "separatrix_form.solution")

# %% [markdown]
# ### The picture
#
# On the momentum sphere the separatrix consists of two circles that cross at the ends of the middle
# axis. They separate four families of polhodes. A momentum *on* a circle moves from one crossing
# towards the other and takes infinite time.

# %%
flip = TorqueFreeMotion((1, 2, 2.25), (0.75, -0.5, 1))
momentum_sphere(flip, family=3).show()

# %% [markdown]
# ### The closed form at work
#
# An illustration: the two formulas above in NumPy, next to the generated code. The constants of the
# motion are evaluated from the ledger's formulas, to thirty digits.

# %%
GIVEN = ("inertia", "omega0", "attitude0")


def constants(motion, *names):
    """Constants of the regular form, as doubles."""
    known = PreciseMotion(*(motion.exact[name] for name in GIVEN))
    return known.polhode, [float(x) for x in known.constants(names, 30).values()]


axes, (K, A_a, A_d, mu, phase, psi_0) = constants(flip, "K", "A_a", "A_d", "mu", "phase", "psi_0")
c = np.array([float(x) for x in flip.exact["inertia"]])
a, b, d = axes.axes
t = np.linspace(0, 16, 1601)
tan_beta = c[d] * A_d / (K + c[a] * A_a)  # x where root_k = 1
Lambda = psi_0 / 2 + axes.rho * mu * tan_beta  # zeta = x
z = axes.rho * np.arctan(tan_beta) + 1j * (mu * t + phase)
turn = np.exp(1j * Lambda * t)
first, second = turn * np.cos(z), -axes.chi * turn * np.sin(z)
N = np.sqrt(np.abs(first) ** 2 + np.abs(second) ** 2)
closed = np.zeros((t.size, 4))
closed[:, 0], closed[:, a + 1] = first.real / N, axes.sigma * first.imag / N
closed[:, b + 1], closed[:, d + 1] = second.real / N, axes.epsilon * axes.sigma * second.imag / N


# %%
def product(p, q):
    """Quaternions, scalar first, row by row."""
    a, b, u, v = p[..., :1], q[..., :1], p[..., 1:], q[..., 1:]
    scalar = a * b - np.sum(u * v, axis=-1, keepdims=True)
    return np.concatenate([scalar, a * v + b * u + np.cross(u, v)], axis=-1)


CONJUGATE = np.array([1, -1, -1, -1])


def rotated(q, vector):
    """Body vector into space."""
    pure = np.concatenate([[0], vector])
    return product(product(q, pure), CONJUGATE * q)[..., 1:]


q_flip, omega_flip = flip(t)
front = product(q_flip[0], CONJUGATE * closed[0])  # (37)
apart = np.max(np.abs(product(front, closed) - q_flip))
print("closed form and module agree to 1e-14:", bool(apart < 1e-14))

# %% [markdown]
# ### Why integrators fail here
#
# Neighbouring motions leave the separatrix like $e^{\lambda t}$. A step-by-step integrator makes an
# error of $10^{-16}$ in its first step and then follows a neighbouring motion, so after
# $t\approx37/\lambda$ its result is wrong in the first digit. Below: the exact motion, and the
# classical Runge-Kutta method with 20 steps a second.

# %%
h, steps = 0.05, 4000
w = np.array([float(x) for x in flip.exact["omega0"]])


def euler(w):
    return np.cross(c * w, w) / c


path = [w]
for _ in range(steps):
    k1 = euler(w)
    k2 = euler(w + h / 2 * k1)
    k3 = euler(w + h / 2 * k2)
    k4 = euler(w + h * k3)
    w = w + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    path.append(w)
times = h * np.arange(steps + 1)
stepped, exact = np.array(path), flip(times)[1]

figure, (top, bottom) = plt.subplots(2, sharex=True, figsize=(8, 4.6), layout="constrained")
top.plot(times, exact[:, b], color=BLUE, lw=2.2, label="closed form")
top.plot(times, stepped[:, b], color=RED, lw=1.2, ls="--", label="Runge-Kutta, $h=0.05$ s")
top.set(
    ylabel=r"$\Omega_b$ (rad/s)", title="A separatrix motion: one flip, says the exact solution"
)
top.legend(loc="center left", bbox_to_anchor=(0.07, 0.4))
gap = np.linalg.norm(stepped - exact, axis=1)
bottom.semilogy(times[1:], gap[1:], color=RED, label="difference of the rates")
lam = constants(flip, "lambda_")[1][0]
bottom.semilogy(
    times, 3e-17 * np.exp(lam * times), color="#999999", ls=":", label=r"$\sim e^{\lambda t}$"
)
bottom.set(xlabel="time (s)", ylabel="rad/s", ylim=(1e-12, 1e1))
bottom.legend(loc="lower right")
plt.show()

# %% [markdown]
# ## Dzhanibekov's flip
#
# Now take a motion near the edge: a body spins about its middle axis with a small rate across it.
# The rates are periodic again, with $T=4K(m)/\lambda$, and as $m_1=1-m\to0$ the quarter period
# grows like a logarithm, $K(m)\approx\frac12\ln(16/m_1)$: the body hangs about the middle axis for
# a long time and then turns over quickly.

# %%
nut = ("0.6", "1", "1.4")  # kg m^2; any body with three different moments will do
pushes = [Fraction(1, 10**k) for k in (1, 2, 4, 8)]
times = np.linspace(0, 120, 4801)
figure, rows = plt.subplots(4, sharex=True, figsize=(8, 5.4), layout="constrained")
for row, push, colour in zip(rows, pushes, (BLUE, GREEN, PINK, RED), strict=True):
    one = TorqueFreeMotion(nut, (0, 1, push))
    row.plot(times, one(times)[1][:, 1], color=colour, lw=1.5)
    row.set_title(f"push {float(push):g} rad/s: {one.regime}", loc="left", fontsize=9)
    row.set(ylim=(-1.25, 1.25), yticks=(-1, 0, 1), xlim=(0, 120))
rows[-1].set_xlabel("time (s)")
figure.supylabel("rate about the middle axis (rad/s)", fontsize=9)
plt.show()

# %% [markdown]
# A push that is a hundred times smaller delays the flip by the same number of seconds each time.
# Exact inputs allow pushes down to $10^{-100}$ rad/s:

# %%
exponents = np.array([1, 2, 4, 8, 16, 30, 50, 75, 100])
flips = []
for k in exponents:
    _, (m_1, lam) = constants(
        TorqueFreeMotion(nut, (0, 1, Fraction(1, 10 ** int(k)))), "m_1", "lambda_"
    )
    arithmetic, geometric = 1.0, np.sqrt(m_1)
    for _ in range(12):
        arithmetic, geometric = (arithmetic + geometric) / 2, np.sqrt(arithmetic * geometric)
    flips.append(np.pi / arithmetic / lam)  # T/2 = 2 K(m)/lambda, and K = pi/(2 agm)

figure, axis = plt.subplots(figsize=(6.4, 3), layout="constrained")
axis.plot(exponents, flips, "o", color=BLUE, label="$2K(m)/\\lambda$")
slope = 2 * np.log(10) / lam
axis.plot(
    exponents, flips[-1] + slope * (exponents - 100), color="#999999", lw=1, label="a logarithm"
)
axis.set(xlabel=r"$-\log_{10}$ of the push in rad/s", ylabel="from flip to flip (s)")
axis.legend()
plt.show()

# %% [markdown]
# The next picture shows the body in space, with the path of the end of its middle axis. Move the
# slider, or press ▶. The momentum (dashed) is constant; the body turns over.

# %%
seen = TorqueFreeMotion(nut, (0, 1, Fraction(1, 100)))
tumbling_body(seen, np.round(np.linspace(0, 40, 81), 6)).show()

# %% [markdown]
# ## Symmetric bodies
#
# Where $c_b=c_d$ the modulus vanishes: $\mathrm{sn}=\sin$, $\mathrm{cn}=\cos$, $\mathrm{dn}=1$. The
# body turns about its axis at a constant rate, and the axis moves on a cone around the momentum at
# a constant rate.

# %%
show(
    ledger,
    "symmetric.models_regular",
    "symmetric.body",
    "symmetric.rate",
    "symmetric_form.solution",
)

# %% [markdown]
# ### Feynman's plate
#
# Somebody threw a plate in the cafeteria at Cornell; Feynman saw it wobble, and worked out that
# for a slight wobble the medallion goes round *half* as fast as the wobble. With $c=(1,1,2)$, a
# flat disc, `symmetric.rate` gives $\lambda=(c_a-c_d)\,\Omega_a/c_d=\Omega_a$: that is how fast
# the rates turn in the body. In space, the axis goes round with $K/c_d$, nearly $2\Omega_a$.

# %%
plate = TorqueFreeMotion((1, 1, 2), ("0.6", 0, 6))
t = np.linspace(
    0, 2 * np.pi / 6, 721
)  # one turn of the plate about its axis, as the body counts it
q, _ = plate(t)
M = rotated(q[0], np.array([1, 1, 2]) * plate(0.0)[1])
K = np.linalg.norm(M)
# Look along the momentum.
e3 = M / K
e1 = np.cross([0, 1, 0], e3)
e1 /= np.linalg.norm(e1)
e2 = np.cross(e3, e1)
axis_end, rim = rotated(q, np.array([0, 0, 1.0])), rotated(q, np.array([1.0, 0, 0]))

figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.4), layout="constrained")
left.plot(axis_end @ e1, axis_end @ e2, color=BLUE)
left.plot(*(axis_end[:1] @ np.stack([e1, e2]).T).T, "o", color=BLUE)
left.set(aspect="equal", xlabel="across the momentum", ylabel="across, the other way")
left.set_title("end of the plate's axis (radii)")
wobble = np.unwrap(np.arctan2(axis_end @ e2, axis_end @ e1))
medallion = np.unwrap(np.arctan2(rim @ e2, rim @ e1))
right.plot(t, (wobble - wobble[0]) / (2 * np.pi), color=BLUE, label="the wobble")
right.plot(t, (medallion - medallion[0]) / (2 * np.pi), color=RED, label="the medallion")
right.set(xlabel="time (s)", ylabel="turns in space", title="Two turns to one")
right.legend()
plt.show()

# %% [markdown]
# ## Spin, sphere, rest
#
# In the remaining leaves $M=c\,\Omega$ for one moment $c$: momentum and rates are parallel, the
# rates are constant by Euler's equations, and the attitude is one exponential,
#
# $$q(t)=q(0)\left(\cos\tfrac{|\Omega|t}2,\ \frac{\Omega}{|\Omega|}\sin\tfrac{|\Omega|t}2\right).$$
#
# The regular form is not used for these; it would be $0/0$ in $E_a/E_d$. By the map above, these
# are all the leaves with constant rates. In each of them the kernel shows that some square is both
# $\ge0$ and $\le0$.

# %%
show(ledger, "steady.solution", "spin_2.parallel", "spherical.moments")

# %% [markdown]
# Pure spin about the *middle* axis is one of them. It is an unstable equilibrium: with exactly that
# spin the body keeps it for all time; with $10^{-100}$ rad/s added it flips after some minutes, as
# in the figure above. One motion of each leaf:

# %%
tour = {
    "the paper's spacecraft": (("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")),
    "the same, spun up about axis 3": (("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.2")),
    "the flip above": ((1, 2, "2.25"), ("0.75", "-0.5", 1)),
    "the plate": ((1, 1, 2), ("0.6", 0, 6)),
    "the plate, about its diameter": ((1, 1, 2), ("0.6", "0.3", 0)),
    "the nut about its middle axis": (nut, (0, 1, 0)),
    "the same with a push": (nut, (0, 1, "1e-100")),
    "a ball": ((1, 1, 1), (1, 2, 3)),
    "a body on a shelf": ((1, 2, "2.5"), (0, 0, 0)),
}
found = {name: TorqueFreeMotion(*given).regime for name, given in tour.items()}
table({"motion": name, "regime": str(regime)} for name, regime in found.items())

# %% [markdown]
# ## Across the edges
#
# The closed forms of neighbouring leaves must agree at the boundary. An illustration: the state at
# $t=10$ s for $\Omega_d(0)$ ever closer to the separatrix value, from both sides. The difference
# from the separatrix motion's state falls in proportion, down to the last digit asked for.

# %%
figure, axis = plt.subplots(figsize=(6.4, 3), layout="constrained")
here = np.concatenate(flip.precise(10, digits=60))
distances = [Fraction(1, 10**k) for k in range(2, 41, 2)]
for sign, colour, marker in ((1, BLUE, "o"), (-1, RED, "x")):
    gaps, regimes = [], set()
    for distance in distances:
        near = TorqueFreeMotion((1, 2, "2.25"), ("0.75", "-0.5", 1 + sign * distance))
        regimes.add(near.regime)
        there = np.concatenate(near.precise(10, digits=60))
        gaps.append(max(abs(float(x)) for x in there - here))
    assert len(regimes) == 1
    assert Regime.SEPARATRIX not in regimes
    assert np.all(np.array(gaps) < 1e4 * np.array([float(x) for x in distances]))
    axis.loglog([float(x) for x in distances], gaps, marker, color=colour, label=str(*regimes))
axis.set(xlabel=r"distance of $\Omega_d(0)$ from the separatrix (rad/s)")
axis.set(ylabel="difference of the states (largest component)")
axis.invert_xaxis()
axis.legend(fontsize=8)
plt.show()

# %% [markdown]
# ## What we have
#
# * All bodies and motions fall into fourteen leaves, exactly one for each: a fact with a
#   certificate.
# * On the separatrix and for symmetric bodies the regular form holds and becomes elementary,
#   including the attitude; both edges are proved without any assumption.
# * Where the rates are constant, the attitude is one exponential.
# * Decisions are made on exact numbers, so a motion is on an edge if and only if its exact inputs
#   are.
#
# [Notebook 6](06_theta_functions.ipynb) explains the cosines and sines of *complex* angles on the
# separatrix.

# %% tags=["hide-cell"]
on_separatrix = [
    f"separatrix_form.{name}" for name in ("solution", "qbar_0", "qbar_a", "qbar_b", "qbar_d")
]
edge = [f"symmetric_form.{name}" for name in ("solution", "qbar_0", "qbar_a", "qbar_b", "qbar_d")]
parallel = [name for name in ledger.facts if name.endswith(".parallel")]
spin = TorqueFreeMotion(nut, (0, 1, 0))
turnovers = [np.count_nonzero(np.diff(np.sign(rates[:, b]))) for rates in (exact, stepped)]
assert whole.kind == "partition"
assert len(whole.rhs) == 14
assert grades(ledger, "sorted_body.cases", "sorted_body.differences") == {Grade.PROVED}
assert by_decimals.regime == Regime.SEPARATRIX
assert excess(by_decimals) == 0
assert by_doubles.regime != Regime.SEPARATRIX
assert 0 < abs(excess(by_doubles)) < 1e-16
assert grades(ledger, *on_separatrix, "separatrix_form.W", "separatrix_form.T1_re") == {
    Grade.PROVED
}
assert grades(ledger, "separatrix.euler", "separatrix_integral.j") == {Grade.PROVED}
assert flip.regime == Regime.SEPARATRIX
assert apart < 1e-14
assert turnovers[0] == 1 < turnovers[1]
assert grades(ledger, "period.duration", "regular.m_1") == {Grade.PROVED}
assert grades(ledger, "period_functions.duration") == {Grade.PROVED}
assert np.allclose(np.diff(flips)[2:], slope * np.diff(exponents)[2:], rtol=1e-6)
assert grades(ledger, *edge, "symmetric.euler", "symmetric.rate") == {Grade.PROVED}
assert grades(ledger, "oblate_motion.edge", "prolate_motion.edge") == {Grade.PROVED}
assert plate.regime == Regime.SYMMETRIC
assert abs((wobble[-1] - wobble[0]) / t[-1] - K / 1) < 1e-9  # K/c_d
assert abs((wobble[-1] - wobble[0]) / (medallion[-1] - medallion[0]) - 2) < 0.02
assert len(parallel) == 7
assert grades(ledger, "steady.euler", "steady.norm", "steady.solution", *parallel) == {Grade.PROVED}
assert set(found.values()) == set(Regime)  # every regime is on the tour
assert np.array_equal(spin(1e9)[1], [0, 1, 0])
leaves = ["largest", "smallest", "separatrix_motion", "oblate_motion", "prolate_motion"]
assert set(leaves) < set(whole.rhs)
assert grades(ledger, *(f"{leaf}.squares" for leaf in leaves)) == {Grade.PROVED}
