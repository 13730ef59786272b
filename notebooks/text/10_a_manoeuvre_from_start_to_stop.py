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
# # 10. A manoeuvre, from start to stop
#
# This is the application of the paper (section V). A spacecraft at rest in one attitude has to
# reach another. A first burst starts the rotation, the spacecraft turns freely, and a second burst
# stops it:
#
# > The methodology proposed consists of performing a parametric optimisation of the equations of the
# > analytic solution of Theorem 1 in order to find the initial angular velocities the spacecraft
# > should have in order to reach its target configuration.
#
# Three rates are unknown, and three angles are prescribed. The paper does not say more than that.
# This notebook plans such a manoeuvre, explains why *all* natural motions that reach the target can
# be found, flies it under the disturbances of a small satellite (Figures 1 to 3), and exports it to
# other programs. [How to plan within limits and fly by
# thrusters](howto_limits_and_thrusters.ipynb) goes on from here: durations, spins, half turns, burns.
#
# | | |
# |---|---|
# | chapter used | `manoeuvres`, from the sealed ledger |
# | the page beside it | [Manoeuvres](site/pages/manoeuvres.md) |
# | before this | [Code you can fly](08_code_you_can_fly.ipynb) |

# %%
import warnings
from dataclasses import replace
from fractions import Fraction

import matplotlib.pyplot as plt
import numpy as np
from IPython.display import display

import rigidsym
from rigidsym import _engines as engines
from rigidsym.manoeuvre import directions_of, solve
from rigidsym.manoeuvre._manoeuvre import open_manoeuvre
from support import grades, sealed, show, table

BLUE, RED, GREEN, PINK = "#0072b2", "#d55e00", "#009e73", "#cc79a7"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}

# Without a C compiler NumPy stands in, with a warning.
warnings.simplefilter("ignore", RuntimeWarning)
ledger = sealed()

asked, tables = open_manoeuvre("paper")
plan = solve(asked, families=4)
plan

# %% [markdown]
# `paper` is a file that comes with the package. It has the inertia, orbit, disturbances and wheels
# of the caption of Figure 3; the attitudes and the 120 s are our choice, since the paper does not
# print them. For numbers of your own, make one call, `rigidsym.plan(inertia, start, target,
# duration)`.
#
# The table is ranked by **cost**, the momentum that both bursts change. From rest to rest that is
# $|I\Omega(0)|+|I\Omega(T)|=2K$, because a free body keeps the size of its momentum.
#
# ## Why all motions can be found
#
# An optimiser in three variables finds *one* solution and cannot tell which others exist. Three
# conservation laws reduce the problem to a search in one variable.
#
# **1. The cone.** The momentum is constant in space. Its components $M$ in the body axes at the
# start therefore determine its components $N$ in the body axes at the target: the rotation $R$
# between them gives $N=R^\mathsf{T}M$. The energy is constant, too:
#
# $$M^\mathsf{T}JM=N^\mathsf{T}JN\quad\Longleftrightarrow\quad M^\mathsf{T}AM=0,\qquad
# A=RJR^\mathsf{T}-J,\qquad J=\mathrm{diag}(1/c_k).$$
#
# The trace of $A$ is zero, so this is a cone for every body and rotation. It cuts the sphere of
# directions in two closed curves.

# %%
show(ledger, "manoeuvre.cone", "manoeuvre.trace", "manoeuvre.axis")

# %%
from rigidsym.manoeuvre._problem import problem

best = plan.best
K = [transfer.momentum for transfer in plan.transfers]
posed = problem(asked.inertia, asked.start, asked.target, engines.engine("c"))
inertia = np.array([float(c) for c in asked.inertia])
R, J = posed.rotation, np.diag(1 / inertia)
A = R @ J @ R.T - J
momenta = np.array([inertia * transfer.omega0 for transfer in plan.transfers])
ends = np.array([inertia * transfer.omega1 for transfer in plan.transfers])
below, between, above = np.linalg.eigvalsh(A)
table([{"eigenvalues of $A$, 1/(kg m²)": f"{below:.3f}, {between:.3f}, {above:.3f}"}])

# %% [markdown]
# The picture shows the cone on the sphere of directions, in the body axes at the start. Every
# transfer starts at its dot on the cone and follows its polhode (thick) to the grey dot, which is
# $N$.

# %%
directions_of(plan).show()

# %% [markdown]
# **2. The transit time.** From a direction on the cone the momentum moves along its polhode; its
# position is given by the elliptic functions of [notebook 4](04_no_sign_functions.ipynb). The time
# at which it reaches $N$ is a difference of two elliptic *integrals*, plus any number of periods.
# This number is a discrete choice. Since the rates scale with time, $\Omega\mapsto s\,\Omega$ and
# $t\mapsto t/s$, the given duration determines $K$.
#
# **3. One angle remains.** When the momentum has the right direction in the body, the attitude can
# still be wrong by a rotation *about the momentum*. Let $z$ be the quaternion of this rotation, and
# let $L$ be the image of $M$ under it. The first fact says that $L=M$ only if $z$ is a rotation
# about $M$; the second gives its angle $x$ by $z_0=\cos\frac x2$ and $z\cdot M=K\sin\frac x2$.

# %%
show(ledger, "arrival.gap", "arrival.angle")

# %% [markdown]
# The angle is a function of one variable, the position on the cone. Its zeros are the motions that
# reach the target.

# %%
from rigidsym.manoeuvre._directions import arcs
from rigidsym.manoeuvre._families import families
from rigidsym.manoeuvre._search import Search

BOUND = 8.0  # of the momentum, in units of (largest moment)/duration
found = families(posed, BOUND)
cone, steps = arcs(posed), np.linspace(-32, 32, 1601)


def along(arc, turns):
    """Angles round the cone (degrees), and samples there, up to the bound."""
    search = Search(posed, cone, BOUND)
    samples = search.sample(np.full(steps.size, arc), steps, np.full(steps.size, turns))
    begin, end = np.degrees(cone.ends[arc])
    share = (end - begin) / (1 + np.exp(np.abs(steps)))
    here = samples.time <= BOUND
    return np.where(steps < 0, begin + share, end - share)[here], samples[here]


def left(samples):
    """The angle that is left (degrees), from -180 to 180, with gaps where it jumps."""
    angle = np.mod(np.degrees(2 * samples.half) + 180, 360) - 180
    angle[1:][np.abs(np.diff(angle)) > 90] = np.nan
    return angle


figure, panels = plt.subplots(2, figsize=(8.4, 5.2), sharex=True, layout="constrained")
marked = set()
for arc in range(len(cone.ends)):
    panel = panels[2 * arc // len(cone.ends)]
    for turns, colour in enumerate((BLUE, RED)):
        angles, samples = along(arc, turns)
        panel.plot(angles, left(samples), color=colour, lw=1.4)
        for rank, rates in enumerate(found, 1):
            apart = np.linalg.norm(samples.rates - rates, axis=1)
            if apart.size and apart.min() < 0.05 and rank not in marked:
                marked.add(rank)
                place = angles[apart.argmin()]
                panel.plot(place, 0, "o", color="black", markersize=4)
                offset = (4, -11) if rank % 2 else (4, 4)
                panel.annotate(str(rank), (place, 0), offset, textcoords="offset points")
for panel, curve in zip(panels, ("one curve of the cone", "the other"), strict=True):
    panel.axhline(0, color="0.3", lw=0.8)
    panel.set(xlim=(0, 360), ylim=(-185, 185), yticks=range(-180, 181, 90))
    panel.set_title(curve, loc="left", fontsize=9)
panels[1].set(xlabel="where on the cone (degrees round its axis)", xticks=range(0, 361, 30))
figure.supylabel("angle about the momentum that is left (degrees)", fontsize=9)
panels[0].plot([], [], color=BLUE, label="straight to $N$")
panels[0].plot([], [], color=RED, label="one more turn round the polhode")
panels[0].legend(loc="upper center", bbox_to_anchor=(0.62, 1.22), ncols=2)
plt.show()

# %% [markdown]
# Each dot is a natural motion that reaches the target, numbered by its cost. Lines end where a
# motion would cost more than the bound. They have gaps where $M$ and $N$ lie on opposite branches
# of a polhode, which no motion joins. They are steep close to the separatrix. The planner samples
# these curves and refines every change of sign by the Gauss-Newton method, so it finds *all*
# motions up to the bound. An independent check starts from random rates, refines them until they
# converge or fail, and finds no other motion.

# %%
from rigidsym.manoeuvre._families import refine

rng = np.random.default_rng(10)
direction = rng.normal(size=(1500, 3))
direction /= np.linalg.norm(direction, axis=1, keepdims=True)
size = BOUND * rng.random((1500, 1)) ** (1 / 3)
rates, missed = refine(posed, size * direction / posed.inertia)
arrived = rates[(missed < 1e-9) & (posed.momenta(rates) < BOUND)]
nearest = np.linalg.norm(arrived[:, None] - found, axis=2)
print(f"{len(found)} motions by the cone; by chance no other")

# %% [markdown]
# ## The gain
#
# The simplest manoeuvre turns about a fixed axis at a constant rate. Natural motions are the
# geodesics of the kinetic energy: the shortest of them needs the least energy of *all* motions
# between the two attitudes in that time, so it always needs less energy than the turn about a fixed
# axis. Here it also needs less momentum, which is the cost of the bursts.

# %%
axis_rates = posed.axis * posed.angle / best.duration
fixed_axis = 2 * np.linalg.norm(inertia * axis_rates), inertia @ axis_rates**2 / 2
least_energy = min(transfer.energy for transfer in plan.transfers)
rows = [("about a fixed axis", *fixed_axis), ("natural", best.cost, best.energy)]
table(
    {"manoeuvre": name, "cost (N m s)": f"{cost:.4e}", "energy (J)": f"{energy:.4e}"}
    for name, cost, energy in rows
)

# %% [markdown]
# The gain is four per cent; the paper expects natural motions to be "reasonably close to the
# minimum-fuel one". But the turn about a fixed axis needs a torque $\Omega\times I\Omega$ all the
# time. A spacecraft that has only thrusters, fired in two bursts, cannot fly it.
#
# ## Accuracy at the target
#
# Every transfer is checked before it is returned: its rates are exact numbers, and the proved
# solution gives the final attitude at thirty digits. Each transfer has the angle by which it misses.

# %%
residuals = [transfer.residual for transfer in plan.transfers]
print("all transfers miss by less than 1e-12 rad:", max(residuals) < 1e-12)

# %% [markdown]
# ## The flight
#
# A real flight has disturbances. We simulate the flight of the paper's Figures 2 and 3: reaction
# wheels with limits on the torque and on its rate of change, a PD controller that follows the
# natural motion and then holds the target, and an orbit at 600 km with drag, gravity gradient,
# solar radiation pressure and a residual dipole.

# %%
from rigidsym.manoeuvre._figures import Figures, euler_angles
from rigidsym.manoeuvre.flight import fly, read
from rigidsym.manoeuvre.flight._results import Tracked

flight = read(tables)
run = fly(plan.manoeuvre, flight, best)
tracked = Tracked(plan.manoeuvre, flight, best, run)
figures = Figures(tracked, euler_angles(best.motion, run.t))
tracked

# %% [markdown]
# **Figure 2** of the paper is the attitude: the natural motion is thin and dashed, the flown
# attitude is thick. The natural motion goes on after the target has been reached; the controller no
# longer follows it there. **Figure 3** is the torque of each wheel. It is close to a scheme of two
# bursts, as the paper says. A burst takes about ten seconds because of the wheels' limits.

# %%
pictures = figures.drawn()
display(pictures["figure2"], pictures["figure3"])

# %% [markdown]
# **Figure 1** is the paper's argument for quaternions: the same natural motion in Euler's angles,
# by the classical solution. The angles jump, although the attitude is smooth: as rotations they
# equal the quaternions above.

# %%
pictures["figure1"]

# %% [markdown]
# ### Free motion with wheels
#
# Between the bursts the torques in Figure 3 look like zero. The next figure enlarges them a hundred
# times, without disturbances:

# %%
calm = replace(
    flight.disturbances, drag=False, gravity_gradient=False, radiation=False, dipole=False
)
quiet = replace(flight, disturbances=calm, run=replace(flight.run, length=Fraction(119)))
still = fly(plan.manoeuvre, quiet, best)
coast = still.t > 35
gyroscopic = -np.cross(still.track.omega, inertia * still.track.omega)

figure, panel = plt.subplots(figsize=(8.4, 3.2), layout="constrained")
for k, colour in enumerate((BLUE, RED, GREEN)):
    name = f"$N_{{c{k + 1}}}$"
    panel.plot(still.t[coast], 1e6 * still.torque[coast, k], color=colour, lw=2, label=name)
    panel.plot(still.t[coast], 1e6 * gyroscopic[coast, k], color="0.2", lw=1, ls=(0, (5, 3)))
panel.lines[-1].set_label(r"$-(\Omega\times I\Omega)_k$")
panel.set(xlabel="time (s)", ylabel="control torques ($10^{-6}$ N m)")
panel.legend(loc="center left", bbox_to_anchor=(1, 0.5))
plt.show()

# %% [markdown]
# The wheels exert the gyroscopic torque of a free body, $-\Omega\times I\Omega$ (dashed). The
# reason: they started the rotation by taking up the opposite momentum, $h=-I\Omega$. Body and
# wheels together have no momentum, so there is no gyroscopic torque that moves the body along its
# polhode:
#
# $$I\dot\Omega=-\Omega\times(I\Omega+h)+N_c=N_c .$$
#
# Without control, a body whose rotation was started by wheels turns about a *fixed* axis. For
# wheels the natural motion is therefore a smooth reference, but not a torque-free one; it is
# torque-free for thrusters, whose exhaust carries the momentum away. The wheels' torque along the
# natural motion, summed over axes and time, exceeds that of a turn at constant rate about a fixed
# axis:

# %%
once = np.linspace(0, 120, 2001)
rates = best.motion(once)[1]
driven = np.abs(np.cross(rates, inertia * rates)).sum(axis=1)
natural_torque = np.abs(best.bursts).sum() + np.trapezoid(driven, once)
fixed_torque = 2 * np.abs(inertia * axis_rates).sum()
print(f"by wheels, natural motion over fixed axis: {natural_torque / fixed_torque:.2f}")

# %% [markdown]
# Over random manoeuvres the median of this ratio is 1.28. For thrusters the natural motion is the
# better choice: it is within 4 % of minimum fuel (see the [comparison](site/pages/manoeuvres.md)).
#
# ## Export
#
# Flight dynamics software reads CCSDS attitude ephemeris messages (AEM), Python code likes SciPy's
# `RotationSpline`. Both take samples of a motion. (The spline is less accurate at its ends, so it has
# some samples on both sides.)

# %%
from rigidsym.io import aem, rotation_spline, sampled

track = sampled(best.motion, np.linspace(0, 120, 121))
epoch = flight.orbit.epoch.strftime("%Y-%m-%dT%H:%M:%S")
names = {"object_name": "NANO", "object_id": "UNKNOWN", "originator": "RIGIDSYM"}
message = aem(track, epoch, creation_date=epoch, **names)
print("\n".join(f"{line:.60}" for line in message.splitlines()[:20]))

spline = rotation_spline(sampled(best.motion, np.linspace(-20, 140, 161)))
between = np.linspace(0, 120, 1201)
angles = (best.motion.rotation(between).inv() * spline(between)).magnitude()
print("spline off by less than 1e-7 rad between samples a second apart:", angles.max() < 1e-7)

# %% [markdown]
# ## Recommendations
#
# * **Thrusters**: fly the natural motion with two bursts. Choose a duration that is long compared
#   with the bursts, centre the burns, and avoid spins about the middle axis if the first burst is
#   not exact.
# * **Wheels**: usually fly a turn about a fixed axis, which needs less torque in most manoeuvres,
#   including this one. The natural motion as a reference needs a small torque all the time; feed
#   $\Omega\times h$ forward in this case.
# * **An optimiser**: to minimise fuel, start a local optimiser from the natural motion. An
#   interior-point method with its default settings hardly depends on the start. `rigidsym compare`
#   has the figures.
# * **On board**: `generate("c")` allocates no memory and needs only libm; see [C for my flight
#   code](howto_c_for_my_flight_code.ipynb). Plan on the ground, or scale a stored plan to another
#   duration by one division.
#
# On the command line the same is `rigidsym plan paper --all 4`, `rigidsym track paper` and
# `rigidsym figures`.

# %% tags=["hide-cell"]
numbers = figures.numbers()
assert np.allclose([transfer.cost for transfer in plan.transfers], 2 * np.array(K), rtol=1e-13)
assert np.all(np.diff(K) > 0)
assert max(residuals) < 1e-12
assert {transfer.motion.regime for transfer in plan.transfers} == {
    rigidsym.Regime.LARGEST,
    rigidsym.Regime.SMALLEST,
}
assert abs(np.trace(A)) < 1e-13 * np.abs(A).max()
for M, length in zip(momenta, K, strict=True):
    assert abs(M @ A @ M) < 1e-12 * length**2 * J.max()
assert np.allclose(ends, momenta @ R, rtol=0, atol=1e-12 * max(K))
assert len(marked) == len(found)
assert len(arrived) > 100
assert nearest.min(axis=1).max() < 1e-6
assert len({*nearest.argmin(axis=1)}) > len(found) / 2
assert least_energy <= fixed_axis[1]
assert best.cost < fixed_axis[0]
assert sum(numbers["jumps"].values()) > 0
assert numbers["apart"] < 1e-9
assert numbers["step"] < 1e-3
assert not tracked.missed
assert numbers["tracking"]["max"] < 2
assert max(-numbers["lowest"], numbers["highest"]) < 5e-4
assert run.momentum_defect() < 1e-13
size = np.linalg.norm(gyroscopic[coast], axis=1)
assert np.linalg.norm(still.torque - gyroscopic, axis=1)[coast].max() < 0.05 * size.max()
assert size.max() < 0.02 * numbers["highest"]
assert 1.2 < natural_torque / fixed_torque < 1.4
lines = message.partition("DATA_START")[2].partition("DATA_STOP")[0].split("\n")[1:-1]
states = np.array([line.split()[1:] for line in lines], dtype=float)
q, omega = best.motion(track.times)
assert np.abs(np.roll(states[:, :4], 1, axis=1) - q).max() < 1e-15
assert np.abs(np.radians(states[:, 4:]) - omega).max() < 1e-16
assert angles.max() < 1e-7
motion = rigidsym.TorqueFreeMotion(asked.inertia, best.rates, asked.start)
arrival, _ = motion(best.duration)
target = np.array([float(x) for x in asked.target])
assert 1 - abs(arrival @ target) < 1e-14
assert best.motion.regime == rigidsym.Regime.LARGEST
cited = ["manoeuvre.cone", "manoeuvre.trace", "manoeuvre.axis", "manoeuvre.first_burst"]
cited += ["manoeuvre.last_burst", "arrival.gap", "arrival.angle"]
assert grades(ledger, *cited) == {"PROVED"}
