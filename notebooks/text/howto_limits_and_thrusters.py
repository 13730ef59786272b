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
# # How to plan within limits, and fly by thrusters
#
# [Notebook 10](10_a_manoeuvre_from_start_to_stop.ipynb) plans a manoeuvre from rest to rest and flies
# it with wheels. This page goes on from there: limits on rates and bursts, spins before and after, half
# turns about a principal axis, a controller that feeds forward, and thrusters.
#
# | | |
# |---|---|
# | the page beside it | [Manoeuvres](site/pages/manoeuvres.md) |

# %%
import warnings
from dataclasses import replace
from fractions import Fraction

import matplotlib.pyplot as plt
import mpmath
import numpy as np

import rigidsym
from rigidsym.manoeuvre import directions_of, solve
from rigidsym.manoeuvre._manoeuvre import open_manoeuvre
from support import grades, sealed, show, table

BLUE, RED, GREEN, PINK = "#0072b2", "#d55e00", "#009e73", "#cc79a7"
plt.rcParams |= {"figure.dpi": 110, "axes.grid": True, "grid.color": "#e5e5e5", "font.size": 9}
plt.rcParams |= {"axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False}

# Without a C compiler NumPy stands in, with a warning.
warnings.simplefilter("ignore", RuntimeWarning)
ledger = sealed()

asked, tables = open_manoeuvre("paper")  # the manoeuvre of notebook 10, 120 s long
best = solve(asked).best
inertia = np.array([float(c) for c in asked.inertia])
best

# %% [markdown]
# ## Durations
#
# The equations scale with time: a motion run $s$ times as fast, with rates $W=s\,\Omega$, is also a
# motion.

# %%
show(ledger, "faster.euler")

# %% [markdown]
# Half the duration gives twice the rates and twice the cost, without a new search.

# %%
ours = {"inertia": asked.inertia, "start": asked.start, "target": asked.target}
scaled = {T: rigidsym.plan(**ours, duration=T).best for T in (30, 60, 120, 240)}
table(
    {
        "duration (s)": T,
        "cost (N m s)": f"{one.cost:.5e}",
        "cost times duration": f"{one.cost * T:.6f}",
    }
    for T, one in scaled.items()
)

# %% [markdown]
# ## Limits
#
# A limit determines the duration, too. Give the spacecraft's limits without a duration, and the
# planner computes it. If both are given and do not agree, the planner raises an error.

# %%
quick = rigidsym.plan(**ours, max_rate="0.05").best
gentle = rigidsym.plan(**ours, max_burst="5e-4").best
try:
    rigidsym.plan(**ours, duration=60, max_burst="5e-4")
    refused = ""
except rigidsym.InputError as error:
    refused = error.rule
print(f"|omega| up to 0.05 rad/s: {quick.duration:.2f} s")
print(f"bursts up to 5e-4 N m s:  {gentle.duration:.2f} s")
print("both 60 s and 5e-4 N m s:", refused)

# %% [markdown]
# ## Spins
#
# With **spins** before or after (for example, if the spacecraft tumbles when the manoeuvre begins)
# costs do not scale: a burst is a difference of momenta, and the duration decides which motion is
# the cheapest. The set of motions is the same.

# %%
from rigidsym import _engines as engines
from rigidsym.manoeuvre._cheapest import Bursts
from rigidsym.manoeuvre._families import families
from rigidsym.manoeuvre._problem import problem

posed = problem(asked.inertia, asked.start, asked.target, engines.engine("c"))
found = families(posed, 8.0)  # all motions up to a momentum of 8 times (largest moment)/duration

tumbling = (0.01, 0.02, -0.01)  # rad/s
durations = np.geomspace(40, 600, 141)


def costs(spin, durations):
    """Of the motions found (N m s), a row for each duration."""
    bursts = Bursts.of(posed, rigidsym.plan(**ours, duration=120, start_spin=spin).manoeuvre)
    sizes = [bursts.sizes(found, T).sum(axis=1) / T for T in durations.tolist()]
    return inertia.max() * np.array(sizes)


figure, panels = plt.subplots(1, 2, figsize=(8.4, 3.4), sharey=True, layout="constrained")
cases = {"from rest": (0, 0, 0), "from a tumble": tumbling}
for panel, (name, spin) in zip(panels, cases.items(), strict=True):
    first = costs(spin, durations)[:, :4]
    for rank, colour in enumerate((BLUE, RED, GREEN, PINK)):
        panel.loglog(durations, first[:, rank], color=colour, label=f"motion {rank + 1}")
    panel.set(xlabel="duration (s)", title=name, xticks=(50, 100, 200, 400))
    panel.set_xticks([], minor=True)
    panel.xaxis.set_major_formatter("{x:g}")
panels[0].set_ylabel("cost (N m s)")
panels[0].legend(loc="lower left")
plt.show()

# %%
few = np.array([60.0, 120.0, 240.0])
curves = costs(tumbling, few)
planned = [rigidsym.plan(**ours, duration=T, start_spin=tumbling).best.cost for T in few.tolist()]
print("the cheapest in 60, 120 and 240 s: motions", *(curves.argmin(axis=1) + 1))

# %% [markdown]
# ## Half turns, and the middle axis
#
# Let $R$ be the rotation from the start to the target and $J=\mathrm{diag}(1/c_k)$. In notebook 10, the
# momentum $M$ of a transfer lies on the cone $M^\mathsf{T}AM=0$ with $A=RJR^\mathsf{T}-J$. A half turn
# about a principal axis is a symmetry of the body, $RJR^\mathsf{T}=J$, so $A=0$ and the cone is the
# whole sphere. The transfers then form families of equal cost along a polhode, the curve of the momentum
# in the body: if $q(t)$ is a motion, so is its product $x(t)=q(t)\,p$ with the half turn $p$. The plan
# lists one transfer of each family.

# %%
show(ledger, "manoeuvre.symmetry", "ring.euler")

# %%
AXES = {"smallest": (0, 1, 0, 0), "middle": (0, 0, 1, 0), "largest": (0, 0, 0, 1)}
flips = {
    name: rigidsym.plan(asked.inertia, (1, 0, 0, 0), target, 120, families=2)
    for name, target in AXES.items()
}
table(
    {
        "half turn about the axis of": f"{name} moment",
        "cheapest (N m s)": f"{one.best.cost:.4e}",
        "": str(one.best.motion.regime),
        "next (N m s)": f"{one.transfers[1].cost:.4e}",
    }
    for name, one in flips.items()
)

# %%
directions_of(flips["largest"]).show()

# %% [markdown]
# A spin about the axis is the cheapest. About the *middle* axis it is unstable, as [notebook
# 5](05_edges.ipynb) shows: an error of the burst grows exponentially. The next cell shows
# its effect in half a turn, for errors of one per cent of the rate in any direction:

# %%
rng = np.random.default_rng(5)


def scatter(transfer):
    """Median angle (degrees) between target and arrival, with rates wrong by one per cent."""
    wrong = rng.normal(size=(2000, 3)) * np.linalg.norm(transfer.omega0) / np.sqrt(3) / 100
    given = [float(x) for x in transfer.manoeuvre.start]
    q, _ = rigidsym.propagate(inertia, transfer.omega0 + wrong, [transfer.duration], given)
    target = np.array([float(x) for x in transfer.manoeuvre.target])
    sine = np.linalg.norm(np.minimum(*(np.abs(q[:, 0] - s * target) for s in (1, -1))), axis=1)
    return np.degrees(np.median(4 * np.arcsin(sine / 2)))


named = {f"half turn, {name} moment": one.best for name, one in flips.items()}
errors = {name: scatter(one) for name, one in {**named, "the paper's": best}.items()}
table(
    {"manoeuvre": name, "off by, median (degrees)": f"{error:.1f}"}
    for name, error in errors.items()
)

# %% [markdown]
# Over half a turn, the error about the middle axis is up to four times the error about the other
# axes.
#
# ## Fifty digits
#
# Every transfer of this page is checked at thirty digits before it is returned. The same check by hand,
# at fifty digits:

# %%
DIGITS = 50


def miss(transfer):
    """The angle between where the exact rates lead and the target (rad)."""
    asked = transfer.manoeuvre
    q, _ = transfer.motion.precise(asked.duration, DIGITS)
    with mpmath.workdps(DIGITS):
        target = [mpmath.mpf(x.numerator) / x.denominator for x in asked.target]
        unit = [x / mpmath.norm(target) for x in target]
        chords = [[x - side * y for x, y in zip(q, unit, strict=True)] for side in (1, -1)]
        return float(4 * mpmath.asin(min(map(mpmath.norm, chords)) / 2))


everything = [best, quick, gentle, *(one.best for one in flips.values())]
misses = np.array([miss(one) for one in everything])
print(f"{len(misses)} transfers miss by less than 1e-12 rad:", bool(misses.max() < 1e-12))

# %% [markdown]
# ## Wheels that feed forward
#
# Between the bursts, wheels have to exert the gyroscopic torque of a free body, as notebook 10 shows.
# With feed-forward, the controller supplies it before an error appears:

# %%
from rigidsym.manoeuvre.flight import fly, read

flight = read(tables)
run = fly(asked, flight, best)
knowing = replace(flight, controller=replace(flight.controller, feedforward=True))
told = fly(asked, knowing, best)
late = (told.t > 60) & (told.t < told.arrival)
table(
    {
        "controller": name,
        "error on the way, greatest after 60 s (degrees)": f"{np.degrees(one.error[late].max()):.3f}",
        "greatest torque there (N m)": f"{np.abs(one.torque[late]).max():.1e}",
    }
    for name, one in (("PD alone, as in the paper", run), ("PD and $\\Omega\\times h$", told))
)

# %% [markdown]
# ## Thrusters
#
# Thrusters are on or off: a burn takes as long as its impulse needs. A burn that is centred on the
# instant of the ideal burst has an error of second order in its length; a burn that begins at that
# instant is late by half its length. This flight has only the burns, no controller and no
# disturbances:

# %%
from rigidsym.manoeuvre.flight._settings import Thrusters

calm = replace(
    flight.disturbances, drag=False, gravity_gradient=False, radiation=False, dipole=False
)
quiet = replace(flight, disturbances=calm, run=replace(flight.run, length=Fraction(119)))
blind = replace(quiet, controller=replace(flight.controller, natural_frequency=0.0))
blind = replace(blind, run=replace(flight.run, length=Fraction(123), period=Fraction(1)))
burnt = {
    (torque, centred): fly(asked, replace(blind, thrusters=Thrusters(torque, 0.0, centred)), best)
    for torque in (5e-4, 1e-3, 1e-2)
    for centred in (True, False)
}
table(
    {
        "thrusters (N m)": f"{torque:g}",
        "burns (s)": ", ".join(f"{np.ptp(span, axis=1).max():.2f}" for span in one.burns.spans),
        "": "centred" if centred else "begun at the instants",
        "misses by (degrees)": f"{np.degrees(one.last_burn()['error']):.3f}",
    }
    for (torque, centred), one in burnt.items()
)

# %% [markdown]
# Disturbances have a larger effect: in two minutes without control they turn this small spacecraft
# by some degrees. Thrusters are therefore combined with wheels that remove the remaining error, or
# with a burst on the way. In a manoeuvre file this is the table `[thrusters]`, with or without
# `[controller]`.

# %% tags=["hide-cell"]
assert np.ptp([one.cost * T for T, one in scaled.items()]) < 1e-12
assert np.allclose([one.omega0 * T for T, one in scaled.items()], best.omega0 * 120, atol=1e-9)
assert abs(quick.peak_rate - 0.05) < 1e-9
assert np.isclose(np.linalg.norm(gentle.bursts, axis=1).max(), 5e-4, rtol=1e-9)
assert refused
assert np.allclose(planned, curves.min(axis=1), rtol=1e-9)
assert len({*curves.argmin(axis=1)}) == 3
assert errors["half turn, middle moment"] == max(errors.values())
assert errors["half turn, largest moment"] == min(v for k, v in errors.items() if "half" in k)
assert all(one.best.motion.regime == rigidsym.Regime.SPIN for one in flips.values())
assert misses.max() < 1e-12
assert np.allclose(misses, [one.residual for one in everything], rtol=1e-6, atol=1e-25)
missed = {key: one.last_burn()["error"] for key, one in burnt.items()}
assert missed[1e-2, True] < missed[1e-3, True] < missed[5e-4, True] < np.radians(0.2)
assert all(missed[torque, False] > 2 * missed[torque, True] for torque in (5e-4, 1e-3, 1e-2))
assert told.error[late].max() < 0.5 * run.error[late].max()
assert np.isclose(np.abs(told.torque[late]).max(), np.abs(run.torque[late]).max(), rtol=0.5)
cited = ["manoeuvre.symmetry", "faster.kinematics", "faster.euler"]
cited += ["ring.kinematics", "ring.momentum", "ring.euler"]
assert grades(ledger, *cited) == {"PROVED"}
