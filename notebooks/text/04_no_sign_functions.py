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
# # 4. No more sign functions
#
# Theorem 1 of the paper writes the attitude of a free rigid body with four half-angle functions
# $F_1,\dots,F_4$. Each of them has a sign $S_i=\pm1$ that is chosen once, at $t=0$. In this
# notebook we follow the paper's own spacecraft until the attitude computed in this way **jumps**,
# and we find the line that makes it jump. Then we write the same solution in a form that has no
# signs to choose, no square root that changes branch and no denominator that vanishes: the *regular
# form*, from which every number in this project is computed.
#
# | | |
# |---|---|
# | chapters used | `theorem1`, `equivalence`, `attitude`, `regular_form`, `regimes` |
# | mathematics needed | quaternions or Euler angles, and a first course in rigid body mechanics |
# | units | body rates $\Omega_i$ in rad/s, moments $c_i$ in kg m² |
# | quaternions | scalar first, from body to inertial axes, $\dot q=\tfrac12\,q\,(0,\Omega)$ |

# %%
import matplotlib.pyplot as plt
import numpy as np
import sympy
from IPython.display import display

import rigidsym
from derivations import attitude, regular_form
from rigidsym.io.cases import paper_case
from rigidsym.quaternions import conjugate, product, rotated
from support import equation, grades, sealed, show
from support.names import read, symbol, symbols
from support.steps import source

BLUE, RED, GREEN, PINK, BROWN = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#806000"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}
ledger = sealed()

# %% [markdown]
# Framed statements are facts of the project's ledger, with their names. The cell above had a fresh
# kernel check their certificates once more. The formulas of the regular form are those of the
# chapters, which compute them with SymPy from the energy.

# %% [markdown]
# ## The printed formulas
#
# Three turns, (25), take the momentum $M$ in body axes to $K A_1$:
#
# $$\bar R=e^{\phi_1A_1}\,e^{\phi_2A_2}\,e^{\phi_3A_1},\qquad
# \cos\phi_2=\frac{c_1\Omega_1}{K}=x,\qquad \tan\phi_3=\frac{c_2\Omega_2}{c_3\Omega_3}=y .$$
#
# As a quaternion this is (18), and it needs $\cos$ and $\sin$ of $\phi_2/2$ and $\phi_3/2$.
# Equation (19) makes these from $x$ and $y$:
#
# $$F_1=S_1\sqrt{\tfrac{1+x}2},\qquad F_2=S_2\sqrt{\tfrac{1-x}2},\qquad
# F_3=\frac{S_3}{\sqrt{1+y^{\star2}}},\qquad F_4=\frac{S_4\,y^\star}{\sqrt{1+y^{\star2}}},$$
#
# $$y^\star=\frac{y}{1+\sqrt{1+y^2}},\qquad S_i=\pm1 .$$
#
# Remark 2 adds that the $S_i=\pm1$ are *constants*, set by the motion at $t=0$.
#
# The formula of $y^\star$ is the textbook formula $\tan\frac\phi2=\frac{\tan\phi}{1+\sec\phi}$ with
# $\sec\phi_3$ replaced by $+\sqrt{1+\tan^2\phi_3}$. This replacement is right only where
# $\cos\phi_3>0$, that is, where $c_3\Omega_3>0$.

# %%
phi3 = np.linspace(-np.pi, np.pi, 1602)[1:-1]
y = np.tan(phi3)
y_star = y / (1 + np.sqrt(1 + y**2))
y_star[np.abs(np.diff(y_star, prepend=y_star[0])) > 1] = np.nan

figure, axis = plt.subplots(figsize=(7, 3.2), layout="constrained")
for side in (-1, 1):
    axis.axvspan(side * 90, side * 180, color="#f3f3f3", zorder=0)
axis.plot(np.degrees(phi3), np.tan(phi3 / 2), color=BLUE, lw=1.6, label=r"$\tan(\phi_3/2)$")
axis.plot(np.degrees(phi3), y_star, color=RED, lw=2, ls="--", label=r"$y^\star$ of (19)")
axis.set(ylim=(-4, 4), xlim=(-180, 180), xticks=range(-180, 181, 45))
axis.set(xlabel=r"$\phi_3$ (degrees)", ylabel="dimensionless")
axis.set_title(r"The half-angle step; shaded: $c_3\Omega_3<0$")
axis.legend(loc="upper left")
plt.show()

# %% [markdown]
# Where does the wrong half come from? $\tau=\tan\frac{\phi_3}2$ satisfies $y=2\tau/(1-\tau^2)$, a
# quadratic equation with *two* roots. (19) takes the same root at all times, but the sign of
# $\cos\phi_3$ decides which root is right.

# %%
y_, tau = symbols("y tau")
sympy.solve(sympy.Eq(y_, 2 * tau / (1 - tau**2)), tau)

# %% [markdown]
# In the shaded half the printed step gives $-\cot(\phi_3/2)$ instead of $\tan(\phi_3/2)$. The
# kernel refutes it there, and gives an exact point where the equation
# $y^\star\cos\frac{\phi_3}2=\sin\frac{\phi_3}2$ fails. (The context `half_angle_right` assumes
# $c_3\Omega_3>0$ and `half_angle_left` the opposite; `half_angle_step` assumes neither.)

# %%
steps = ("half_angle_right.tangent", "half_angle_left.cotangent", "printed_star.print_theorem_1")
show(ledger, *steps)

# %% [markdown]
# ## The paper's spacecraft, half a turn later
#
# Now a numerical illustration. The rates of the motion come from the project's generated code, so
# no integration error enters below. From them we compute $x$, $y$ and, by Gauss's quadrature of
# (33),
#
# $$\phi_1=\int_0^t K\,\frac{2H-c_1\Omega_1^2}{K^2-(c_1\Omega_1)^2}\,dt .$$

# %%
motion = paper_case().motion
c = np.array([float(x) for x in motion.inertia])
t = np.linspace(0, 180, 1801)
q, omega = motion(t)
momentum = c * omega
size, H2 = np.linalg.norm(momentum[0]), c @ omega[0] ** 2


def integral(rate):
    """The integral from t[0] to each t of a function of the rates, by ten Gauss points a step."""
    nodes, weights = np.polynomial.legendre.leggauss(10)
    step = t[1] - t[0]
    inside = t[:-1, None] + step * (nodes + 1) / 2
    values = rate(motion(inside.ravel())[1]).reshape(inside.shape)
    return np.concatenate([[0], np.cumsum(values @ weights * step / 2)])


phi1 = integral(lambda w: size * (H2 - c[0] * w[:, 0] ** 2) / (size**2 - (c[0] * w[:, 0]) ** 2))
print(motion.regime)

# %% [markdown]
# Theorem 1 in a few lines: (18), (19) and the pull-back (37), $q=q(0)\,\bar q(0)^{-1}\bar q$. The
# signs are an argument, so that we can vary them.

# %%
start = q[0]


def pulled_back(qbar):
    """(37)"""
    return product(product(start, conjugate(qbar[0])), qbar)


def theorem_1(S2, phi1, y_star):
    """(18) with (19); S1 = S3 = S4 = 1."""
    x = momentum[:, 0] / size
    F1, F2 = np.sqrt((1 + x) / 2), S2 * np.sqrt((1 - x) / 2)
    F3, F4 = 1 / np.sqrt(1 + y_star**2), y_star / np.sqrt(1 + y_star**2)
    cosine, sine = np.cos(phi1 / 2), np.sin(phi1 / 2)
    columns = (
        F1 * (cosine * F3 - sine * F4),
        F1 * (sine * F3 + cosine * F4),
        F2 * (cosine * F3 + sine * F4),
        F2 * (sine * F3 - cosine * F4),
    )
    return pulled_back(np.stack(columns, axis=-1))


def angle_between(p, q):
    """Rotation angle from one attitude to the other, in degrees; blind to the sign of either."""
    gap = product(conjugate(p), q)
    return np.degrees(2 * np.arctan2(np.linalg.norm(gap[..., 1:], axis=-1), np.abs(gap[..., 0])))


# %% [markdown]
# First exactly as printed. At $t=0$ the spacecraft has $\Omega_3<0$, and there
# $S_1S_2=\operatorname{sgn}(c_3\Omega_3)=-1$ gives the right momentum (`matched_signs.side`). So
# far Remark 2 is right. Then the motion goes on.

# %%
y = momentum[:, 1] / momentum[:, 2]
y_star = y / (1 + np.sqrt(1 + y**2))
side = np.sign(omega[:, 2])
constant = theorem_1(side[0], phi1, y_star)

crossings = np.flatnonzero(np.diff(side)) + 1
figure, (top, middle, bottom) = plt.subplots(3, sharex=True, figsize=(8, 7), layout="constrained")
for k, colour in enumerate((BLUE, GREEN, RED)):
    top.plot(t, 1e3 * omega[:, k], color=colour, label=rf"$\Omega_{k + 1}$")
top.set(ylabel="body rates (mrad/s)", title="The paper's spacecraft: rates")
top.legend(loc="center left", bbox_to_anchor=(1, 0.5))
broken = np.insert(constant, crossings, np.nan, axis=0)
for k, colour in enumerate((BLUE, GREEN, RED, BROWN)):
    middle.plot(t, q[:, k], color=colour, lw=3.5, alpha=0.25)
    middle.plot(np.insert(t, crossings, np.nan), broken[:, k], color=colour, lw=1.1)
    middle.plot([], [], color=colour, label=f"$q_{k}$")
middle.set(ylabel="components (dimensionless)")
middle.set_title("Attitude: broad, the smooth solution; thin, Theorem 1 with constant signs")
middle.legend(loc="center left", bbox_to_anchor=(1, 0.5))
bottom.plot(t, angle_between(q, constant), color=RED, lw=1.5)
bottom.set(ylabel="angle (degrees)", xlabel="time (s)", title="Rotation angle between the two")
bottom.set(ylim=(-5, 190), yticks=range(0, 181, 45), xlim=(0, 180))
for axis in (top, middle, bottom):
    for k in crossings:
        axis.axvline(t[k], color="#999999", lw=0.8, ls=":")
plt.show()

# %% [markdown]
# At each zero of $\Omega_3$ (dotted) the printed attitude jumps by half a turn, although the
# spacecraft's attitude is smooth there. When $\Omega_3$ is negative again, the formula is right
# again (as a rotation: the quaternion has the other sign).
#
# Suppose that $S_2$ changes sign with $\Omega_3$. Then the momentum is right at all times, but by
# `crossing.turned` **$\phi_1$ has to jump by $\pi$** at every crossing; otherwise the attitude is
# wrong by half a turn about the momentum. The right column of the next figure distinguishes the two
# kinds of half turn: in space, the momentum must not move.

# %%
following = theorem_1(side, phi1, y_star)
jumps = np.zeros_like(t)
jumps[crossings] = np.pi * np.sign(y_star[crossings - 1])
jumping = theorem_1(side, phi1 + np.cumsum(jumps), y_star)
mended = theorem_1(1, phi1, y / (1 + side * np.sqrt(1 + y**2)))


def momentum_drift(candidate):
    """By what angle the momentum in space has left its direction, in degrees: it must not."""
    there = rotated(candidate, momentum / size)
    across = np.linalg.norm(np.cross(there, there[0]), axis=1)
    return np.degrees(np.arctan2(across, there @ there[0]))


cases = {
    "as printed: constant signs": (constant, RED),
    r"$S_2$ follows $\Omega_3$": (following, PINK),
    r"and $\phi_1$ jumps by $\pi$": (jumping, GREEN),
    r"$y^\star=y/(1+\mathrm{sgn}(c_3\Omega_3)\sqrt{1+y^2})$": (mended, BLUE),
}
figure, axes = plt.subplots(4, 2, sharex=True, figsize=(8.4, 5.4), layout="constrained")
for row, (label, (candidate, colour)) in zip(axes, cases.items(), strict=True):
    row[0].plot(t, angle_between(q, candidate), color=colour, lw=2)
    row[1].plot(t, momentum_drift(candidate), color=colour, lw=2)
    row[0].set_title(label, loc="left", fontsize=9)
    for axis in row:
        axis.set(ylim=(-15, 195), yticks=(0, 90, 180), xlim=(0, 180))
axes[0, 1].set_title("angle of $RMR^{-1}$ from where it was", loc="left", fontsize=9)
for axis in axes[-1]:
    axis.set_xlabel("time (s)")
figure.supylabel("left: angle from the true attitude; right: momentum's (degrees)", fontsize=9)
plt.show()

# %% [markdown]
# The last row is the smallest repair of the print: the sign of $c_3\Omega_3$ goes before the square
# root. It gives the right rotation. But it still is a *sign function*: its denominator vanishes
# where $\phi_3=\pi$ (`half_turn.denominator`), the quaternion changes its sign there, and a
# programmer has to decide what `sgn(0)` should be.
#
# ## The idea of the regular form
#
# Insert a factor and its inverse into (25):
#
# $$e^{\phi_1A_1}e^{\phi_2A_2}e^{\phi_3A_1}
# =e^{(\phi_1+\phi_3)A_1}\cdot\underbrace{e^{-\phi_3A_1}e^{\phi_2A_2}e^{\phi_3A_1}}_{S}.$$
#
# $S$ turns by $\phi_2$ about an axis perpendicular to $e_1$, and it takes $M$ to $KA_1$: it is the
# **shortest rotation** that does so. It does not depend on how angles are measured around the axis,
# so it has no jump, and it can be written without any angle. What remains is one angle
# $\psi=\phi_1+\phi_3$ about the momentum.
#
# ## The regular form, computed
#
# The chapter `derivations/attitude.py` computes this form for *any* order of the axes and *all*
# signs at once. It calls the axes by what they do: $a$ is the axis which the momentum circulates
# about, $b$ the middle axis, $d$ the third. $\epsilon$ is $+1$ if $(a,b,d)$ is right-handed and
# $-1$ if not, and $\sigma$ is the sign of $\Omega_a$. The chapter begins with the energy alone.
# Its gradient is the momentum, and $\dot M=M\times\Omega$ are Euler's equations:

# %%
display(equation("H", attitude.ENERGY))
for name, form in attitude.GRADIENT.items():
    display(equation(name, form))
for axis, form in zip("abd", attitude.EULER.values(), strict=True):
    display(equation(rf"\dot\Omega_{axis}", form))

# %% [markdown]
# For two unit vectors $m$ and $n$, as quaternions, $1-nm$ is the rotation that takes $m$ to $n$ along
# the shortest way, times a number. Here $m=M/K$ and $n=\sigma e_a$, and the chapter multiplies
# $K-\sigma e_aM$ out, of the length $\nu$:

# %%
for name, form in zip(("s_0", "s_a", "s_b", "s_d"), attitude.UNSCALED, strict=True):
    display(equation(rf"\nu\,{name}", form))
display(equation(r"\nu^2", attitude.NU_SQUARED))

# %% [markdown]
# So $S=(s_0,s_a,s_b,s_d)$ has no component along $a$, and $\sigma M_a=|M_a|$ is never negative.
#
# $\psi$ follows from the kinematics. With $\bar R=\exp(\frac\psi2\sigma e_a)\,S$, the angular velocity
# $\bar R^{-1}\dot{\bar R}=\Omega$ has two parts: $\dot\psi$ times $M/K$, the direction in the body
# which the first factor turns about, and $S^{-1}\dot S$. The component along $a$ is one linear
# equation for $\dot\psi$. These are the chapter's own lines (`times` multiplies quaternions, `rate`
# differentiates by Euler's equations, `unsigned` puts $\epsilon^2=\sigma^2=1$):

# %%
source(attitude.turning_rate)

# %%
equation(symbol("psi_rate"), attitude.PSI_RATE)

# %% [markdown]
# In (33) the denominator is $K^2-(c_1\Omega_1)^2$, which vanishes when the body spins about axis 1.
# Here it is $K+|M_a|$, which is at least $K$ for every motion.
#
# On a globe, $\phi_1$ and $\phi_3$ are two longitudes. Longitudes change fast near the pole,
# although the ground there is not special. Their sum is smooth across the pole, like the direction
# of a vector that is carried along the shortest way.

# %%
show(ledger, "attitude.solution", "both_forms.turn", "both_forms.quaternion")

# %% [markdown]
# `attitude.solution` is the whole claim: the four components have unit norm and satisfy $\dot
# q=\frac12q\,(0,\Omega)$ for *any* order of the axes, either handedness $\epsilon$, either sense
# $\sigma$. The `both_forms` facts say that this is the same solution as that of Theorem 1.

# %% [markdown]
# ### The pole, in numbers
#
# To see the difference, let the spacecraft spin about axis 1 with a smaller and smaller wobble. By
# (33), $\dot\phi_1$ is a mean of $K/c_2$ and $K/c_3$ with weights that depend on the longitude of
# the momentum. However small the wobble, $\dot\phi_1$ oscillates between the same two values; at
# the pole itself it is $0/0$. $\dot\psi$ becomes constant.

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.2), layout="constrained")
times = np.linspace(0, 120, 1201)
for wobble, colour in ((2e-2, BLUE), (5e-3, GREEN), (1e-12, RED)):
    _, w = rigidsym.TorqueFreeMotion(motion.inertia, (0.1, wobble, 0))(times)
    k, h2 = np.linalg.norm(c * w[0]), c @ w[0] ** 2
    across = (c[1] * w[:, 1]) ** 2 + (c[2] * w[:, 2]) ** 2
    left.plot(times, k * (c[1] * w[:, 1] ** 2 + c[2] * w[:, 2] ** 2) / across, color=colour)
    label = rf"$\Omega_2(0)={wobble:g}$ rad/s"
    psi_rate = (h2 + k * np.abs(w[:, 0])) / (k + c[0] * np.abs(w[:, 0]))
    right.plot(times, 1e3 * psi_rate, color=colour, label=label)
left.set(xlabel="time (s)", ylabel=r"$\dot\phi_1$ (rad/s)", title=r"(32): the longitude's rate")
right.set(xlabel="time (s)", ylabel=r"$\dot\psi$ (mrad/s)", title="the regular form")
right.ticklabel_format(useOffset=False)
right.legend(loc="center right")
plt.show()

# %% [markdown]
# ## Rates for every order of the axes
#
# The paper's Lemma 1 needs a case distinction by moduli and signs, and on the circulation axis its
# constants are complex. The regular form has the same three formulas for all motions:
#
# $$\Omega_a=\sigma A_a\,\mathrm{dn},\qquad \Omega_b=\chi A_b\,\mathrm{sn},\qquad
# \Omega_d=\chi\tau A_d\,\mathrm{cn}\qquad\text{of}\ (u\,|\,m),\quad \dot u=\lambda>0,\quad
# 0\le m\le1 .$$
#
# $b$ is the middle axis; $a$ is the axis of largest inertia if $K^2\ge2Hc_b$ and that of smallest
# inertia otherwise; $d$ is the third axis. $\chi$ and $\tau$ are signs like $\sigma$. Since
# $\mathrm{dn}>0$, $\Omega_a$ never changes sign, so $\sigma$ is a constant *by the choice of the
# axis*. The chapter `derivations/regular_form.py` puts this ansatz into $2H$ and $K^2$, which are
# constant: their coefficients of $\mathrm{sn}^2$ have to vanish.

# %%
for name, (constant_term, coefficient) in {
    "2H": (regular_form.ENERGY_0, regular_form.ENERGY_2),
    "K^2": (regular_form.SIZE_0, regular_form.SIZE_2),
}.items():
    display(equation(name, constant_term), equation("0", coefficient))

# %% [markdown]
# Four linear equations give the squares of the amplitudes and $m$; Euler's equation for $\Omega_d$
# gives $\lambda$. In the ledger they are these facts, where $c_{ab}=c_a-c_b$ and so on, and
# $m_1=1-m$:

# %%
names = ("A_a", "A_b", "A_d", "lambda_", "m", "m_1")
show(ledger, *(f"regular.{name}" for name in names))

# %% [markdown]
# Here $E_x=\pm(2Hc_x-K^2)$, written in the rates. $E_a$ and $E_d$ are sums of terms of one sign, so
# that nothing cancels; $E_b$ is a difference, and its sign tells the two circulations apart. The
# radicands are nonnegative and $0\le m\le1$: the chapter on regimes splits all bodies and motions
# by signs into leaves, and proves this leaf by leaf. (There the axes are numbered by size, $c_1\ge
# c_2\ge c_3$, and $c_{12}=c_1-c_2$ and so on.)

# %%
show(ledger, "regular.E_a", "regular.E_b", "regular.E_d", "largest.squares")

# %% [markdown]
# ### A picture of all motions
#
# On the sphere of momenta of length $K$, each motion runs along a closed curve, a *polhode*. Here
# are polhodes of the spacecraft, coloured by the axis $a$ that they circle, with the separatrix
# between them; the heavy one is the paper's motion. The thin green arcs are its shortest rotations
# $S$: from where the momentum is to the pole $\sigma e_a$. Theorem 1 measures angles around axis 1
# for all polhodes; the regular form uses for each polhode the pole inside it. (Drag to turn the
# sphere.)

# %%
from rigidsym.view.scenes import momentum_sphere

scene = momentum_sphere(motion, family=3)
pole = np.array([1.0, 0, 0])
gap, arcs = np.full((1, 3), np.nan), []
for direction in momentum[0:1650:66] / size:  # one period
    reach = np.arccos(direction @ pole)
    share = np.linspace(0, 1, 9)[:, None]
    arcs += [np.sin((1 - share) * reach) * direction + np.sin(share * reach) * pole, gap]
    arcs[-2] *= size / np.sin(reach)
x, y, z = np.round(1e6 * np.concatenate(arcs)).T / 1e6
style = {"color": GREEN, "width": 2}
scene.add_scatter3d(x=x, y=y, z=z, mode="lines", name="shortest rotations", line=style)
scene.show()

# %% [markdown]
# ## The regular form at work
#
# The same spacecraft, computed by the two lines above: $\dot\psi$ by quadrature, $S$ by its
# formula, then (37). No sign has to be chosen, and none changes.

# %%
a, b, d = 0, 1, 2  # circulation about axis 1, and (1, 2, 3) is right-handed
sigma = np.sign(omega[0, a])
psi = integral(lambda w: (H2 + size * np.abs(w[:, a])) / (size + c[a] * np.abs(w[:, a])))
turn = np.stack([np.cos(psi / 2), sigma * np.sin(psi / 2), 0 * psi, 0 * psi], axis=-1)
nu = np.sqrt(2 * size * (size + sigma * momentum[:, a]))
shortest = np.stack(
    [size + sigma * momentum[:, a], 0 * psi, sigma * momentum[:, d], -sigma * momentum[:, b]], -1
)
regular = pulled_back(product(turn, shortest / nu[:, None]))

phi3 = np.unwrap(np.arctan2(momentum[:, 1], momentum[:, 2]))
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.2), layout="constrained")
left.plot(t, phi1, color=RED, label=r"$\phi_1$")
left.plot(t, phi3 - phi3[0], color=GREEN, label=r"$\phi_3-\phi_3(0)$")
left.plot(t, psi, color=BLUE, lw=2, label=r"$\psi$, their sum")
left.set(xlabel="time (s)", ylabel="angle (rad)", title="Two longitudes and their sum")
left.legend()
half = slice(crossings[0], crossings[1] + 1)  # half a period of the rates
angles = {r"$\phi_1$": (phi1, RED), r"$\phi_3$": (phi3, GREEN), r"$\psi$": (psi, BLUE)}
for label, (angle, colour) in angles.items():
    rate = (angle[half][-1] - angle[half][0]) / (t[half][-1] - t[half][0])
    right.plot(t, angle - angle[half][0] - rate * (t - t[half][0]), color=colour, label=label)
right.set(xlabel="time (s)", ylabel="angle (rad)", title="less what is linear in time")
right.legend(loc="center left", bbox_to_anchor=(1, 0.5))
plt.show()

# %% [markdown]
# An angle minus its mean rate times $t$ is periodic and, for $\psi$, small: some hundredths of a
# radian here. [Notebook 6](06_theta_functions.ipynb) finds the mean rate in closed form.

# %% [markdown]
# ## All orders, all signs
#
# Six orders of the axes times eight signs of the rates: 48 motions, among them both circulations
# about either sense of each axis. The generated code is made from the formulas above; here it is
# compared with the same solution at thirty digits. (This is an illustration; the full campaign is
# `rigidsym validate`.)

# %%
from itertools import permutations
from itertools import product as every

worst, seen = 0.0, set()
for order in permutations(range(3)):
    for signs in every((1, -1), repeat=3):
        body = tuple(motion.inertia[k] for k in order)
        rates = tuple(s * motion.omega0[k] for s, k in zip(signs, order, strict=True))
        one = rigidsym.TorqueFreeMotion(body, rates)
        exact = np.array(one.precise(180, digits=30)[0], dtype=float)
        worst = max(worst, np.linalg.norm(one(180.0)[0] - exact))
        seen.add((one.regime, order.index(0), bool(rates[order.index(0)] > 0)))
print(f"{len(seen)} kinds of motion; worst error below 1e-14: {worst < 1e-14}")

# %% [markdown]
# ## What we have
#
# * The printed step from $y$ to $y^\star$ holds only where $c_3\Omega_3>0$; no constant signs carry
#   Theorem 1 past a zero of $\Omega_3$. Both are refutations with exact points.
# * $\bar R=\exp(\frac\psi2\sigma e_a)\cdot S$ is the same solution without sign functions. Its only
#   denominators are $K$, $K+|M_a|$ and $\nu$, which vanish for no motion.
# * Three formulas with $\mathrm{dn},\mathrm{sn},\mathrm{cn}$ serve both circulations, all orders
#   and signs.
#
# The [next notebook](05_edges.ipynb) treats the boundaries: $m=1$, $m=0$, and bodies at rest.

# %% tags=["hide-cell"]
# The formulas of the chapters are those that the ledger says.
psi_rate = read(ledger.contexts["attitude"].definitions["psi_rate"])
assert sympy.cancel(psi_rate - attitude.PSI_RATE.value) == 0
quoted = (
    *("attitude.nu", "attitude.solution", "both_forms.turn", "both_forms.quaternion"),
    *("printed_star.print_theorem_1", "half_angle_step.mended", "half_turn.denominator"),
    *("half_angle_right.tangent", "half_angle_left.cotangent"),
    *("crossing.print_theorem_1", "crossing.turned"),
    *("printed_19_any_outer.print_19", "matched_signs.side", "matched_signs.momentum"),
    *(f"regular.{name}" for name in ("euler", "differences", *names)),
    *("largest.squares", "smallest.squares", "sorted_body.cases"),
)
assert grades(ledger, *quoted) == {"PROVED"}
refuted = {
    "printed_star.print_theorem_1",
    "crossing.print_theorem_1",
    "printed_19_any_outer.print_19",
}
assert {name for name in quoted if ledger.facts[name].kind == "unequal"} == refuted
assert ledger.facts["both_forms.models_attitude"].kind == "model"
assert len(ledger.facts["sorted_body.cases"].rhs) == 14, "leaves of the tree of regimes"
# What is divided by, in all of the chapter on the attitude:
divisors = {"c_a", "c_b", "c_d", "K", "K + sigma*c_a*Omega_a", "nu"}
assert set(ledger.contexts["attitude"].units) == divisors
# The illustrations agree with the facts.
assert np.max(angle_between(q, mended)) < 1e-5 > np.max(angle_between(q, jumping))
assert np.min(angle_between(q, following)[side > 0]) > 179.99
assert np.min(angle_between(q, constant)[side > 0]) > 179.99
assert np.max(momentum_drift(constant)) > 90
assert np.max(momentum_drift(following)) < 1e-5
assert np.max(np.abs(psi - (phi1 + phi3 - phi3[0]))) < 1e-9  # both_forms.turn
assert np.max(np.abs(regular - q)) < 1e-12  # the same sheet of the double cover, too
assert np.max(np.linalg.norm(np.diff(regular, axis=0), axis=1)) < 1e-2  # no jump anywhere
assert len(seen) == 6
assert worst < 1e-14
