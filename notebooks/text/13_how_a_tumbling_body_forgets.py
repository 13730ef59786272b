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
# # 13. How a tumbling body forgets
#
# An initial state is never known exactly. This notebook shows how a small initial error grows as the body
# tumbles. Free motion has no friction and no noise, so no information is lost. Still, after a while the
# prediction is useless. The derivatives of the state with respect to all inputs determine when, and in
# which direction. They have closed forms, like the motion itself: proved, generated, enclosed.
#
# | | |
# |---|---|
# | chapters used | `sensitivity_columns`, `attitude_columns`, `integral_sensitivities` |
# | the page beside it | [Sensitivities](site/pages/sensitivities.md) |

# %%
import matplotlib.pyplot as plt
import numpy as np

from rigidsym import Regime, TorqueFreeMotion

BLUE, RED, GREEN = "#0072b2", "#d55e00", "#009e73"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}

tumble = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
q, omega, S = tumble.sensitivity([0.0, 90.0, 180.0])
S.attitude.shape, S.rates.shape

# %% [markdown]
# An error of the attitude is a small turn η, a vector in space: the matrix from body to space changes by
# [η] times itself. `S.attitude` has the derivatives of η at each time, and `S.rates` those of ω. Both have
# nine columns, for the small turn at the start, for ω₀ and for the three moments.
#
# ## Slow growth: two clocks with small errors
#
# Let the initial attitude and rates be known to 1e-3 rad and 1e-5 rad/s in each axis. Along the momentum
# L, which is constant in space, the derivation gives a formula without elliptic functions:
#
# $$\eta\cdot\hat L=\eta_0\cdot\hat L+\frac{t\,\delta H}{K},\qquad\delta H=M\cdot\delta\omega_0.$$
#
# So σ_H = K σ_ω, and the error about L grows as t σ_H/K = t σ_ω, for any body and any motion. That is one
# clock. The other is the phase of ω in the body: its period also has an error, and the error of the phase
# also grows in proportion to the time. It appears in the rates, and in the tilt of the body across L.

# %%
SIGMA = np.repeat([1e-3, 1e-5], 3)
c = np.array([0.0109, 0.04, 0.0506])
M = c * tumble(0.0)[1]
K = np.linalg.norm(M)
along = M / K  # in space, too: the attitude begins as the identity
times = np.geomspace(1, 1e5, 600)
S = tumble.sensitivity(times)[2]
spread = S.attitude[..., :6] * SIGMA
about = np.linalg.norm(along @ spread, axis=-1)
across = np.linalg.norm(spread - along[:, None] * (along @ spread)[:, None], axis=(-2, -1))
rates = np.linalg.norm(S.rates[..., :6] * SIGMA, axis=(-2, -1))

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
left.loglog(times, about, color=BLUE, lw=2, label="about the momentum")
left.loglog(times, across, color=GREEN, lw=1, label="across it")
left.loglog(times, 1e-5 * times, "k:", lw=1, label=r"$t\,\sigma_H/K$")
left.set(xlabel="time (s)", ylabel="rad", title="Error of the attitude")
left.legend()
right.loglog(times, rates, color=RED, lw=1)
right.set(xlabel="time (s)", ylabel="rad/s", title="Error of the rates")
plt.show()

# %% [markdown]
# An error of the phase is a shift along the polhode, so that δω finally points along the acceleration.
# Energy and momentum are conserved: errors across the polhode stay as small as they were.

# %%
late = tumble.sensitivity([1e3, 1e4, 1e5])[2]
u, s, _ = np.linalg.svd(late.rates[..., :6] * SIGMA)
along_path = late.rates_t / np.linalg.norm(late.rates_t, axis=-1, keepdims=True)
aligned = np.abs(np.sum(u[..., 0] * along_path, axis=-1))
for t, x, (large, other, _) in zip((1e3, 1e4, 1e5), aligned, s, strict=True):
    angle = np.degrees(np.arccos(x))
    print(f"{t:.0e} s: {large:.0e} rad/s, {angle:.2f} deg off the path; across it {other:.0e}")

# %% [markdown]
# ## Fast growth: the separatrix
#
# For a body on its way to the middle axis, errors grow exponentially. The decimals below lie exactly on
# the separatrix. A small initial tilt grows as $e^{\lambda t}$, with
# $\lambda^2=(c_a-c_b)(K^2-2Hc_d)/(c_ac_bc_d)$, and an error of 1e-16, a double's last digit, is one of 1 rad
# after some $37/\lambda$ seconds.

# %%
moments, thrown = ("0.1", "0.2", "0.225"), ("0.3", "0.2", "0.4")
flip = TorqueFreeMotion(moments, thrown)
a, b, d = 0.1, 0.2, 0.225  # on the separatrix either outer axis may be a
hh, kk = (sum(m**n * w**2 for m, w in zip((a, b, d), (0.3, 0.2, 0.4), strict=True)) for n in (1, 2))
lam = np.sqrt((a - b) * (kk - hh * d) / (a * b * d))
until = np.linspace(0, 150, 601)
growth = np.linalg.norm(flip.sensitivity(until)[2].transition, 2, axis=(-2, -1))
steady = np.linalg.norm(tumble.sensitivity(until)[2].transition, 2, axis=(-2, -1))

figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
axes.semilogy(until, growth, color=RED, lw=2, label=f"{flip.regime}")
axes.semilogy(
    until, growth[-1] * np.exp(lam * (until - until[-1])), "k:", label=r"$\sim e^{\lambda t}$"
)
axes.semilogy(until, steady, color=BLUE, label=f"{tumble.regime}")
axes.set(xlabel="time (s)", title="What an error at the start is multiplied by")
axes.legend()
plt.show()
print(f"{flip.regime}, lambda = {lam:.3f}/s, a double is forgotten after {37 / lam:.0f} s")

# %% [markdown]
# To predict the blue motion for twice the time, measure the rates twice as well. For the red one, each
# additional 1/λ costs a factor e. (`rigidsym.plan` warns of manoeuvres that pass there.)
#
# State transition matrices start at any time, and multiply:

# %%
first, second = tumble.state_transition(0.0, 60.0), tumble.state_transition(60.0, 180.0)
whole = tumble.state_transition(0.0, 180.0)
print(
    "the same to 1e-13:",
    np.allclose(second @ first, whole, rtol=0, atol=1e-13 * np.max(np.abs(whole))),
)

# %% [markdown]
# ## Observability
#
# The same matrix shows which inputs can be estimated from observations. No filter can estimate a direction
# of the nine inputs that changes nothing. Below are 200 observations in ten minutes. Columns are in units
# of 1 rad, of |ω₀| and, for the moments, of each moment itself. A direction counts as observable if its
# singular value is more than 1e-9 of the largest.

# %%
watched = {
    "tumbling": tumble,
    "symmetric": TorqueFreeMotion(("0.04", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")),
    "a spin": TorqueFreeMotion(("0.0109", "0.04", "0.0506"), (0, 0, "0.05")),
}


def singular(motion, what):
    """Singular values of 200 looks at attitude or rates, and the direction of the smallest."""
    exact = {name: [float(x) for x in motion.exact[name]] for name in ("inertia", "omega0")}
    units = [1.0] * 3 + [np.linalg.norm(exact["omega0"])] * 3 + exact["inertia"]
    found = getattr(motion.sensitivity(np.linspace(0, 600, 200))[2], what) * units
    _, s, v = np.linalg.svd(found.reshape(-1, 9))
    return s / s[0], v[-1]


seen = {
    name: [int(np.sum(singular(motion, what)[0] > 1e-9)) for what in ("attitude", "rates")]
    for name, motion in watched.items()
}
for name, (attitudes, bodies) in seen.items():
    print(f"{name:10} attitudes show {attitudes} of 9, rates alone {bodies}")

# %% [markdown]
# * **The scale of inertia** is not observable: a body twice as heavy has the same free motion. For a tumbling
#   body this is the only such direction, equal relative changes of all three moments.
# * **Rates alone** do not determine the attitude: three more directions.
# * **A spin** shows no moment at all, because it is the same motion for all moments. To estimate moments, let the
#   body tumble; the less it tumbles, the larger are the errors, as the last picture shows.

# %%
hidden = singular(tumble, "attitude")[1]
print("hidden when tumbling:", np.abs(hidden / hidden[np.argmax(np.abs(hidden))]).round(6) + 0.0)

tilts = np.geomspace(1e-6, 0.3, 25)
faint = np.array(
    [
        singular(TorqueFreeMotion(c, (0.05 * np.sin(x), 0, 0.05 * np.cos(x))), "attitude")[0]
        for x in tilts
    ]
)
figure, axes = plt.subplots(figsize=(8, 3), layout="constrained")
axes.loglog(tilts, faint[:, :6], color=BLUE, lw=1)
axes.loglog(tilts, faint[:, 6:8], color=RED, lw=2)
axes.set(xlabel="tilt from a spin about the third axis (rad)", ylabel="singular values")
axes.set(title="What looks at the attitude show: blue the start, red the ratios of moments")
plt.show()

# %% [markdown]
# ## Enclosures
#
# `enclose` returns the same matrices as balls that contain the true values, and `precise` returns any number
# of digits. Here is the derivative of the small turn about the first axis of space by the first rate, rad
# per rad/s, after three minutes: thirty digits, and the double.

# %%
ball = tumble.enclose("180", digits=40, sensitivity=True)[2].attitude[0][3]
column = tumble.sensitivity(180.0)[2].attitude[:, 3]
double = column[0]
print(ball.mid().str(30, radius=False))
print(f"{double:.12f}")

# %% tags=["hide-cell"]
# What the text says.
turned = tumble.sensitivity(times)[2].attitude
line = np.concatenate([np.outer(np.ones_like(times), along), np.outer(times, M / K)], axis=1)
assert np.allclose(along @ turned[..., :6], line, rtol=1e-11, atol=1e-11)
assert np.allclose(about, np.hypot(1e-3, 1e-5 * times), rtol=1e-11)
assert aligned[0] < aligned[1] < aligned[2]
assert 1 - aligned[2] < 1e-6
assert np.allclose(s[2, 0] / s[1, 0], 10, rtol=0.02)
assert np.all(s[:, 1] < 1.1e-5)
assert flip.regime == Regime.SEPARATRIX
rise = np.log(growth[-1] / growth[-101]) / (until[-1] - until[-101])
assert abs(rise / lam - 1) < 1e-6
assert np.allclose(second @ first, whole, rtol=0, atol=1e-13 * np.max(np.abs(whole)))
assert seen == {"tumbling": [8, 5], "symmetric": [8, 5], "a spin": [6, 3]}
assert np.allclose(hidden[:6], 0, atol=1e-12)
assert np.ptp(hidden[6:]) < 1e-12
assert np.allclose(faint[1:10, 6:8] / faint[:9, 6:8], tilts[1] / tilts[0], rtol=0.02)
assert abs(double - float(ball.mid())) <= 1e-13 * np.linalg.norm(column)
