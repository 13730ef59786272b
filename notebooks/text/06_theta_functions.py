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
# # 6. Two theta functions are the whole attitude
#
# The regular form needs $\mathrm{sn}$, $\mathrm{cn}$, $\mathrm{dn}$, an incomplete integral of the
# third kind, two half angles and square roots. All of these combine into two theta functions. The
# two complex numbers that make up the attitude are
#
# $$\boxed{\;\bar q_0+i\sigma\,\bar q_a=\frac{e^{i\Lambda t}}N\,\theta_4(z\,|\,q^2),\qquad
# \bar q_b+i\epsilon\sigma\,\bar q_d=-i\chi\,\frac{e^{i\Lambda t}}N\,\theta_1(z\,|\,q^2),\qquad
# z=g\,(u_1-i\rho\beta)\;}$$
#
# with $u_1=\mu t+u_0$. The argument $z$ is a time with a constant imaginary part, and $N$ is one
# positive factor. The attitude of a tumbling body is thus two of Jacobi's theta functions on a
# horizontal line in the complex plane.
#
# That the nine entries of the *rotation matrix* are quotients of thetas is due to
# [Jacobi](site/pages/bibliography.md#jacobi); [Whittaker](site/pages/bibliography.md#whittaker),
# section 69, has them by Euler's angles. [Klein and
# Sommerfeld](site/pages/bibliography.md#klein-and-sommerfeld) write the motion of tops by the
# parameters of a rotation that are our two complex components, and
# [Kosenko](site/pages/bibliography.md#kosenko) this motion by quaternions; [van Zon and
# Schofield](site/pages/bibliography.md#van-zon-and-schofield) and [Celledoni and
# others](site/pages/bibliography.md#celledoni-et-al) compute with such forms. Here each of the two
# components is a single theta function, and these have the *square* of the usual nome, so that four
# terms of a series give double precision for every motion. Identities of thetas are cited by their
# numbers in the [DLMF](site/pages/bibliography.md#dlmf), chapters 20 and 22.
#
# | | |
# |---|---|
# | chapters used | `theta_form`, `hyperbolic_form`, `theta_edges`, `periods`, `landen_step` |
# | before this | notebooks [4](04_no_sign_functions.ipynb) and [5](05_edges.ipynb) |

# %%
import matplotlib.pyplot as plt
import numpy as np
from mpmath import nstr

from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case
from rigidsym.language._expression import to_text
from rigidsym.precise import METHODS, PreciseMotion
from rigidsym.precise._balls import ball, working
from rigidsym.proof.kernel import Grade
from rigidsym.solution import sealed
from rigidsym.solution._formulas import sequence
from support import derived, grades, show, table

BLUE, RED, GREEN, PINK, BROWN = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#806000"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}

ledger = derived("theta_edges", "hyperbolic_form", "periods")  # and all chapters before them

# %% [markdown]
# ## Theta functions
#
# A theta function is a Fourier series whose coefficients fall like a Gaussian:
#
# $$\theta_4(z\,|\,p)=1+2\sum_{n\ge1}(-1)^n\,p^{\,n^2}\cos2nz,\qquad
# \theta_1(z\,|\,p)=2\sum_{n\ge0}(-1)^n\,p^{\,(n+1/2)^2}\sin(2n+1)z .$$
#
# $p$, the *nome*, lies between 0 and 1. Such a series converges for every complex $z$: thetas are
# entire functions, without poles and without branches. As code:

# %%
TERMS = 4


def theta1(z, p, terms=TERMS):
    """2 sum (-1)^n p^((n + 1/2)^2) sin((2n + 1) z)"""
    return 2 * sum(
        (-1) ** n * p ** ((n + 0.5) ** 2) * np.sin((2 * n + 1) * z) for n in range(terms)
    )


def theta4(z, p, terms=TERMS):
    """1 + 2 sum (-1)^n p^(n^2) cos(2 n z)"""
    return 1 + 2 * sum((-1) ** n * p ** (n * n) * np.cos(2 * n * z) for n in range(1, terms))


def theta3(z, p, terms=2 * TERMS):
    """1 + 2 sum p^(n^2) cos(2 n z)"""
    return 1 + 2 * sum(p ** (n * n) * np.cos(2 * n * z) for n in range(1, terms))


table(
    {
        "nome": f"{nome}",
        r"$\theta_1(1)$": f"{theta1(1.0, nome):.6f}",
        r"$\theta_4(1)$": f"{theta4(1.0, nome):.6f}",
        r"the first term left out of $\theta_4$": f"{2 * nome**TERMS**2:.0e}",
    }
    for nome in (0.001, 0.01, 0.04)
)

# %% [markdown]
# ## The constants of the paper's spacecraft
#
# The ledger publishes *formula sequences*: proved formulas in the order in which they can be
# evaluated. The sequence `theta` leads from amplitudes to the constants of the form above. We
# evaluate it with Arb's balls at sixty digits and print the constants. (The nome of the parameter
# $m$ is `q`; that of $k_1^2$, after one step of Landen's descent, is its square, `nome_1`.)

# %%
for formula in sealed().sequences["theta"]:
    print(f"{formula.name:7} = {to_text(formula.expression)}")

# %%
names = ("A_a", "A_b", "A_d", "K", "H", "lambda_", "k_1", "m", "m_c", "mu", "phase", "psi_0")
wanted = ("nome_1", "g", "beta", "zeta", "Lambda")


def theta_constants(motion):
    """The constants of the theta form, as doubles, and its axes and signs."""
    given = [motion.exact[name] for name in ("inertia", "omega0", "attitude0")]
    precise = PreciseMotion(*given)
    polhode = precise.polhode
    signs = {name: getattr(polhode, name) for name in ("epsilon", "sigma", "rho", "chi")}
    digits = {name: nstr(value, 60) for name, value in precise.constants(names, 60).items()}
    with working(200):
        plan = {name: ball(text) for name, text in digits.items()}
        inertia = {f"c_{x}": ball(given[0][k]) for x, k in zip("abd", polhode.axes, strict=True)}
        found = sequence("theta").evaluate({**plan, **inertia, **signs}, METHODS["theta"]().table())
    doubles = {name: float(found[name]) for name in (*names, *wanted)}
    return {**doubles, **signs, "nome_m": np.sqrt(doubles["nome_1"])}, polhode


motion = paper_case().motion
constants, polhode = theta_constants(motion)
table(
    {"constant": f"`{name}`", "value": f"{constants[name]:.12g}", "what it is": text}
    for name, text in {
        "m": "parameter of the elliptic functions",
        "nome_m": "its nome $q$",
        "nome_1": "the nome $q^2$ of $k_1^2$, which the thetas here have",
        "beta": "how far off the real line, in the argument of the elliptic functions",
        "Lambda": "half the mean rate of turning about the momentum, rad/s",
        "mu": "rate of the argument, rad/s",
    }.items()
)

# %% [markdown]
# With such a nome the series converge after very few terms. The coefficients $p^{n^2}$ of
# $\theta_4$:

# %%
p = constants["nome_1"]
table({"n": n, "$p^{n^2}$": f"{p ** (n * n):.2e}"} for n in range(5))

# %% [markdown]
# ## The whole attitude, from the ledger's own text
#
# The sequence `circular_state` is the boxed formula, component by component. The last column names
# the fact that proves each line, or the context that defines the letter.

# %%
for formula in sealed().sequences["circular_state"]:
    line = f"{formula.name:6} = {to_text(formula.expression)}"
    print(f"{line:80} {formula.fact}")

# %% [markdown]
# We evaluate these lines on NumPy arrays, with the series above, and do not type them again.

# %%
functions = {"theta1": theta1, "theta3": theta3, "theta4": theta4, "I": 1j, "pi": np.pi}
functions |= {"re": np.real, "im": np.imag, "cos": np.cos, "sin": np.sin, "sqrt": np.sqrt}
identity = {"p_0": 1, "p_a": 0, "p_b": 0, "p_d": 0}


def by_thetas(motion, t):
    """All that `circular_state` computes at times t; in front of it stands what (37) asks for."""
    constants, polhode = theta_constants(motion)
    begin = sequence("circular_state").evaluate({**constants, **identity, "t": 0.0}, functions)
    q0, *vector = map(float, motion.attitude0)
    start = {"q_0": q0} | {f"q_{x}": vector[k] for x, k in zip("abd", polhode.axes, strict=True)}
    found = sequence("pull_back").evaluate({**begin, **start}, functions)
    front = {name: found[name] for name in identity}
    return sequence("circular_state").evaluate({**constants, **front, "t": t}, functions)


t = np.linspace(0, 180, 1801)
state = by_thetas(motion, t)
q = np.empty((t.size, 4))
q[:, 0] = state["q_0"]
for x, k in zip("abd", polhode.axes, strict=True):
    q[:, k + 1] = state[f"q_{x}"]

table(
    {"at 180 s": f"$q_{k}$", "by two thetas": f"{q[-1, k]:.12f}", "generated code": f"{x:.12f}"}
    for k, x in enumerate(motion(180.0)[0])
)

# %%
components = [f"theta_form.qbar_{x}" for x in "0abd"]
show(ledger, "theta_form.phase")

# %% [markdown]
# ### The proof about theta functions
#
# The proof has two parts:
#
# * In `theta_form` the letters $T_4$, $T_1$ stand for functions *defined* by the properties that
#   the proof needs: their derivatives and their quotient. The four components then satisfy $\dot
#   q=\frac12q\,(0,\Omega)$.
# * In `theta_functions` they are *declared* to be $\theta_4$ and $\theta_1$. The kernel has the
#   series, and differentiates them. A sum of products of thetas vanishes if its Fourier
#   coefficients do, and the kernel compares finitely many of these. By Riemann's relations at
#   special arguments, the theta functions have all the properties that `theta_form` assumes.

# %%
proved = [f for f in ledger.facts.values() if f.rule == "theta" and "theta_f" in f.id]
table({"law": f"`{f.id}`", "left": f"`{f.lhs[0]}`", "right": f"`{f.rhs[0]}`"} for f in proved)

# %% [markdown]
# ## The line in the complex plane
#
# The colour shows $\log_{10}|\theta|$ for both functions. Their zeros (white dots) lie on a
# lattice. The motion runs along the red line, $\operatorname{Im}z=-\rho g\beta$, at constant speed
# $g\mu$.
#
# By `theta_form.inside`, the line lies below *half* the height of the zeros of $\theta_4$:
# $1-k_1x^2=2B_a/(K+B_a)$ is positive. Therefore $\bar q_0+i\sigma\bar q_a$ never vanishes, its
# phase is a smooth angle without branches, and the series converge fast.

# %%
height = -np.log(p) / 2  # of the zeros of theta_4
b = constants["g"] * constants["beta"]
x, y = np.meshgrid(np.linspace(-np.pi, np.pi, 361), np.linspace(-1.35 * height, 1.35 * height, 241))
figure, axes = plt.subplots(1, 2, figsize=(8.6, 3.9), sharey=True, layout="constrained")
zeros = {"4": (np.pi * np.array([-1, 0, 1]), height), "1": (np.pi * np.array([-1, 0, 1]), 0)}
for axis, function, name in zip(axes, (theta4, theta1), "41", strict=True):
    level = np.log10(np.abs(function(x + 1j * y, p, 8)) + 1e-12)
    drawn = axis.contourf(
        x, y, level, levels=np.linspace(-1.6, 1.6, 17), cmap="cividis", extend="both"
    )
    axis.axhline(-polhode.rho * b, color=RED, lw=2)
    place, up = zeros[name]
    for sign in (1, -1) if up else (1,):
        axis.plot(place, np.full(3, sign * up), "o", color="white", ms=5, mec="black")
    for sign in (1, -1):
        axis.axhline(sign * height / 2, color="white", lw=0.8, ls="--")
    axis.set(xlabel="Re z", title=rf"$|\theta_{name}(z\,|\,q^2)|$", xlim=(-np.pi, np.pi))
    axis.grid(False)
axes[0].set_ylabel("Im z")
figure.colorbar(drawn, ax=axes, label=r"$\log_{10}$", ticks=np.arange(-1.6, 1.7, 0.8))
plt.show()

# %%
show(ledger, "theta_form.inside", "theta_tail.bound")

# %% [markdown]
# ## How many terms
#
# `theta_tail.bound` bounds the truncation error of a series by $2t/(1-r)$, where $t$ bounds the
# first term left out and $r$ is the ratio of the next term to it. An illustration for the
# spacecraft: the bound, and the largest truncation error of $\theta_4$ along the motion.

# %%
z = constants["g"] * (
    constants["mu"] * t + constants["phase"] - 1j * polhode.rho * constants["beta"]
)
counts = np.arange(1, 6)
terms = [2 * (-1) ** n * p ** (n * n) * np.cos(2 * n * z) for n in range(12)]
errors = [np.max(np.abs(sum(terms[n:]))) for n in counts]
first = p ** (counts**2) * np.exp(2 * counts * b)
bounds = 2 * first / (1 - p ** (2 * counts + 1) * np.exp(2 * b))

figure, axis = plt.subplots(figsize=(6.4, 3.1), layout="constrained")
axis.semilogy(counts, bounds, "o-", color="#999999", label="proved bound")
axis.semilogy(counts, errors, "x", color=BLUE, ms=8, label="left out, at most")
axis.axhline(2.0**-53, color=RED, lw=1, ls=":", label="rounding of a double")
axis.set(xlabel=r"terms of $\theta_4$ kept", ylabel="error (dimensionless)", xticks=counts)
axis.set(ylim=(1e-70, 100))
axis.legend()
plt.show()

# %% [markdown]
# ## A motion that closes, and one that does not
#
# $\theta_4$ has the period $\pi$ in $\operatorname{Re}z$, and $\theta_1$ has the period $2\pi$. So
# in a frame that turns with $\Lambda$ the two complex numbers run along *closed* curves.
#
# Their product shows this. $2\,(\bar q_0+i\sigma\bar q_a)(\bar q_b+i\epsilon\sigma\bar q_d)$ is the
# position of the end of the body axis $a$, seen along the momentum. The left picture shows that
# point for a body that tumbles more than the spacecraft does: a rosette, which in general never
# closes. The right picture shows the same point times $e^{-2i\Lambda t}$: a closed curve. The
# motion is a periodic one combined with a uniform rotation.

# %%
tumbling = TorqueFreeMotion(("0.6", "1", "1.4"), ("0.3", "1", "0.5"))
its, by = theta_constants(tumbling)
long = np.linspace(0, 100, 5001)
body = by_thetas(tumbling, long)
first = body["qbar_0"] + 1j * by.sigma * body["qbar_a"]
second = body["qbar_b"] + 1j * by.epsilon * by.sigma * body["qbar_d"]
seen = 2 * first * second
turning = np.exp(-2j * its["Lambda"] * long)

figure, (left, right) = plt.subplots(1, 2, figsize=(8, 4.1), layout="constrained")
for axis, point, title in (
    (left, seen, "in space, 100 s"),
    (right, turning * seen, r"times $e^{-2i\Lambda t}$"),
):
    axis.plot(point.real, point.imag, color=BLUE, lw=0.8)
    axis.plot(0, 0, "+", color=RED)
    axis.set(aspect="equal", xlim=(-1.05, 1.05), ylim=(-1.05, 1.05), title=title)
    axis.set(xlabel="across the momentum (axis length 1)", ylabel="across, the other way")
plt.show()

# %%
a = by.axes[0]
tilt = float(tumbling.inertia[a]) * tumbling(long)[1][:, a] / its["K"]
seen_angles = np.degrees(np.arccos([tilt.max(), tilt.min()]))
table(
    {"the axis from the momentum": which, "seen": f"{angle:.2f}°", "`nutation`": f"{told:.2f}°"}
    for which, angle, told in zip(
        ("nearest", "farthest"), seen_angles, np.degrees(tumbling.nutation), strict=True
    )
)

# %% [markdown]
# ### Periods and Montgomery's phase
#
# The rates have the period $T=4K(m)/\lambda$. In this time the attitude turns about the momentum by
# $2\Lambda T$. `solid_angle.rate` explains this angle: $\dot\psi$ is $2H/K$ minus the rate at which
# the momentum, seen from the body, sweeps solid angle around $\sigma e_a$. Integrated over a
# period, that is [Montgomery's](site/pages/bibliography.md#montgomery) formula, $2\Lambda
# T=2HT/K-\text{(solid angle)}$. (A solid angle has a sign, that of its sense: the spacecraft's is
# negative and therefore adds.)

# %%
show(ledger, "period.duration", "mean_rate.Lambda", "solid_angle.rate")

# %%
m_1 = 1 - constants["m"]
arithmetic, geometric = 1.0, np.sqrt(m_1)
for _ in range(6):
    arithmetic, geometric = (arithmetic + geometric) / 2, np.sqrt(arithmetic * geometric)
T = 2 * np.pi / arithmetic / constants["lambda_"]  # K(m) = pi/(2 agm)

# The solid angle inside the polhode, by Green: the integral of (1 - cos) d phi.
ring = np.linspace(0, T, 4001)
c = np.array([float(x) for x in motion.inertia])
M = c * motion(ring)[1] / constants["K"]
a, *across = polhode.axes
phi = np.unwrap(np.arctan2(M[:, across[1]], M[:, across[0]]))
heights = 1 - polhode.sigma * M[:, a]
solid = abs(np.sum((heights[1:] + heights[:-1]) / 2 * np.diff(phi)))
turned = 2 * constants["Lambda"] * T
table(
    {"": name, "rad": f"{value:.6f}"}
    for name, value in {
        "$2\\Lambda T$": turned,
        "$2HT/K$": 2 * constants["H"] * T / constants["K"],
        "solid angle": solid,
    }.items()
)

# %% [markdown]
# ## Near the separatrix: the other nome
#
# As $k_1\to1$ the nome of $k_1^2$ tends to 1, and the series converge slowly. Jacobi's imaginary
# transformation helps: it turns $z$ by a quarter turn and replaces the nome by that of $1-k_1^2$,
# which tends to *zero*. The form stays the same, with $\theta_2$ for $\theta_4$ and $-i\theta_1$
# for $\theta_1$. One of the two nomes is always at most $e^{-\pi}$.

# %%
STEPS = 8  # of the means, which double their digits each time


def nome(k):
    """exp(-pi K'/K), by arithmetic-geometric means."""
    means = []
    for geometric in (np.sqrt(1 - k * k), k):
        arithmetic = np.ones_like(k)
        for _ in range(STEPS):
            arithmetic, geometric = (arithmetic + geometric) / 2, np.sqrt(arithmetic * geometric)
        means.append(arithmetic)
    return np.exp(-np.pi * means[0] / means[1])


def needed(p, digits=17):
    """Terms until what is left out starts below 10^-digits; e^(2 |Im z|) is below 1/sqrt(p)."""
    n = np.arange(1, 200)[:, None]
    small = (n * n - n / 2) * np.log10(p) < -digits
    return np.argmax(small, axis=0) + 1


k = np.linspace(1e-4, 0.9999, 2000)
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.2), layout="constrained")
other = nome(np.sqrt(1 - k * k))
for p_k, colour, name in ((nome(k), BLUE, "circular form"), (other, RED, "hyperbolic form")):
    left.plot(k, p_k, color=colour, label=name)
    right.step(k, needed(p_k), color=colour, label=name)
left.axhline(np.exp(-np.pi), color="#999999", ls=":", lw=1)
left.text(0.02, np.exp(-np.pi) + 0.02, r"$e^{-\pi}$", color="#666666")
left.set(xlabel="$k_1$", ylabel="nome", ylim=(0, 0.6))
right.set(xlabel="$k_1$", ylabel="terms for 17 digits", ylim=(0, 12), yticks=range(0, 13, 2))
left.legend()
right.legend()
plt.show()

# %% [markdown]
# ### And on the edges
#
# At $k_1=1$ one term is left of each series, and the thetas are $\cos z$ and $-i\sin z$: the closed
# form of [notebook 5](05_edges.ipynb). At $k_1=0$ they are $1$ and $h\,(\sin u_1-i\rho\cos u_1)$.
# Neither needs a classical identity, so both are PROVED.

# %%
show(ledger, "separatrix_form.T1_re", "separatrix_form.T1_im", "separatrix_form.W")

# %% [markdown]
# ## Constants without loss of digits
#
# Digits are easily lost in the constants: in $q$ for small $m$, and in $\beta$ for a motion close
# to a spin. Landen's descending transformation computes them without such losses. Each step roughly
# squares the modulus, and each formula is a sum of positive terms, so no nearly equal numbers are
# subtracted.

# %%
show(ledger, "landen.k_next", "landen.complement", "landen.Y_next", "scaling.h_plus")

# %%
m = constants["m"]
modulus, complement, rows = np.sqrt(m), np.sqrt(1 - m), []
for step in range(5):
    rows.append({"step": step, "$k$": f"{modulus:.3e}"})
    modulus, complement = (
        (modulus / (1 + complement)) ** 2,
        2 * np.sqrt(complement) / (1 + complement),
    )
table(rows)

# %% [markdown]
# ## What we have
#
# * The attitude of a free rigid body is $e^{i\Lambda t}$ times $\theta_4$ and $\theta_1$ of a
#   shifted time, divided by the root of the sum of their squared moduli.
# * No sign functions, no branches, no integral of the third kind: $\Pi$ has become the phase of
#   $\theta_4$ and the constant $\Lambda$.
# * There is a circular and a hyperbolic form, and one of them always converges in four terms. The
#   generated code is made of these.
# * All of this is PROVED from the differential equations and the series of the theta functions.
#
# The next notebook evaluates the same formulas to fifty digits and more, with rigorous bounds.

# %% tags=["hide-cell"]
swept = polhode.rho * solid
hyperbolic = ["solution", "N_of_W", "qbar_0", "qbar_a", "qbar_b", "qbar_d"]
edges = [f"{edge}_form.{x}" for edge in ("separatrix", "symmetric") for x in ("solution", "qbar_0")]
landen = [name for name in ledger.facts if name.split(".")[0] in ("landen", "scaling", "unscaled")]
assert np.max(np.abs(q - motion(t)[0])) < 1e-14  # the double cover's sheet included
assert grades(ledger, *components, "theta_form.N_of_W") == {Grade.PROVED}
assert grades(ledger, "theta_form.solution", *components) == {Grade.PROVED}
assert grades(ledger, "theta_functions.solution", *(f.id for f in proved)) == {Grade.PROVED}
assert grades(ledger, "theta_form.inside", "theta_tail.bound") == {Grade.PROVED}
assert 0 < b < height / 2
assert all(error <= bound for error, bound in zip(errors, bounds, strict=True))
assert np.max(np.abs(np.abs(seen) - np.sqrt(1 - tilt**2))) < 1e-12  # its distance from the momentum
assert np.max(np.abs(np.abs(first) ** 2 + np.abs(second) ** 2 - 1)) < 1e-14
assert abs(turned - (2 * constants["H"] * T / constants["K"] - swept)) < 1e-5
assert np.max(np.abs(motion(T)[1] - motion(0.0)[1])) < 1e-14
assert abs(abs(motion(T)[0][0]) - abs(np.cos(turned / 2))) < 1e-12  # the angle of q(T)
assert grades(ledger, "mean_rate.Lambda", "period.psi", "solid_angle.rate") == {Grade.PROVED}
assert grades(ledger, "period_functions.complete") == {Grade.ENCLOSED}
assert np.max(np.minimum(needed(nome(k)), needed(other))) == 4
assert grades(ledger, *(f"hyperbolic_form.{name}" for name in hyperbolic)) == {Grade.PROVED}
assert grades(ledger, *(f"hyperbolic_functions.{name}" for name in hyperbolic)) == {Grade.PROVED}
assert grades(ledger, *edges) == {Grade.PROVED}
assert len(landen) == 19
assert grades(ledger, *landen) == {Grade.PROVED}
by_name = {formula.name: formula.fact for formula in sealed().sequences["circular_state"]}
proved = {fact for fact in by_name.values() if " " not in fact}  # not said by a context
assert {f"theta_form.qbar_{x}" for x in "0abd"} < proved
assert grades(ledger, *proved) == {Grade.PROVED}
