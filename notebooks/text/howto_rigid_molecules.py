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
# # How to move rigid molecules
#
# In molecular dynamics, rigid molecules turn freely between kicks by the forces, a thousand times per
# picosecond. `rigidsym.step` computes this free turn for many bodies at once: it is exact, takes any
# moments of inertia, and has no state between calls. This notebook applies it to liquid water and
# compares it with NO_SQUISH ([Miller et al.](site/pages/bibliography.md#miller-et-al)), which LAMMPS and
# others use: rotations about one principal axis after the other, which approximate the free turn to
# second order in the step.
#
# ## A box of water
#
# The imported module has 64 SPC/E molecules in a periodic cube, and forces with a smooth cut-off, so that
# only the integrator changes the energy. A molecule is flat: its largest moment is the sum of the other
# two. Units are nm, ps and u; a step accepts any consistent units.

# %%
from inspect import getsource

import matplotlib.pyplot as plt
import numpy as np

from rigidsym.splitting import METHODS
from support import water
from support.water import INERTIA, THERMAL, VERLET, Box

box = Box(edge=4)
liquid = box.settled(picoseconds=2)
print(f"{box.count} molecules in a cube of {box.length:.2f} nm, moments", INERTIA.round(4))

# %% [markdown]
# ## A step
#
# A step of molecular dynamics consists of kicks by the forces, which change velocities and rates, and
# drifts, in which centres move straight and molecules turn freely. Torques and rates are in body axes.
# Verlet's method is half a kick, a drift, half a kick.

# %%
print(getsource(water.advance))
print("VERLET =", VERLET)

# %% [markdown]
# `turn` is `rigidsym.step` with `engine="c"`, or another function of moments, attitudes (N, 4),
# rates (N, 3) and a time. Without forces the two differ clearly:

# %%
turns = {"rigidsym.step": water.exact, "NO_SQUISH": water.no_squish}
wrong = {}
for name, turn in turns.items():
    q, omega = liquid.q, liquid.omega
    for _ in range(250):
        q, omega = turn(INERTIA, q, omega, 0.004)
    before, after = (np.sum(INERTIA * w**2, axis=1) for w in (liquid.omega, omega))
    wrong[name] = np.max(np.abs(after / before - 1))
    kept = "kept" if wrong[name] < 1e-13 else f"wrong by up to {wrong[name]:.0e}"
    print(f"{name:13} energy of rotation after 1 ps in steps of 4 fs: {kept}")

# %% [markdown]
# ## Energy against step
#
# With forces, from the same liquid, a straight line is fitted to the energy per molecule in kT. Its slope
# is the drift; the root mean square about it is the fluctuation. Runs with short steps last half a
# picosecond, those with long steps three, in which a drift begins to show; bars are its standard error.

# %%
FEMTOSECOND = 1e-3  # ps


def measured(turn, fs, picoseconds, parts=VERLET, evaluations=1):
    """A run from the liquid; steps have so many evaluations of the forces, fs apart."""
    h = evaluations * fs * FEMTOSECOND
    every, steps = max(1, round(0.008 / h)), round(picoseconds / h)
    energies = water.run(box, liquid.copy(), parts, h, steps, turn, every)
    return water.kept(energies / (box.count * THERMAL), every * h)


long = {
    name: {fs: measured(turn, fs, picoseconds=3) for fs in (6, 7, 8, 9)}
    for name, turn in turns.items()
}
short = {
    name: {fs: measured(turn, fs, picoseconds=0.5) for fs in (1, 2, 4)}
    for name, turn in turns.items()
}

# %% [markdown]
# The cost is the evaluations of the forces, so a method with several kicks per step takes longer steps
# at the same cost. SABA2 has two kicks; the method of Blanes and Moan of order four has six. It keeps its
# order only with exact drifts: rotations about one axis after the other reduce it to two.

# %%
finer = {}
for method, name in (("saba2", "rigidsym.step"), ("bm4", "rigidsym.step"), ("bm4", "NO_SQUISH")):
    parts, evaluations = water.scheme(METHODS[method]), len(METHODS[method].kicks)
    finer[method, name] = {
        fs: measured(turns[name], fs, 0.5, parts, evaluations) for fs in (1, 1.5, 2)
    }

verlet = {("verlet", name): short[name] | long[name] for name in turns}
scatter = {
    key: {fs: row.scatter for fs, row in rows.items()} for key, rows in (verlet | finer).items()
}
print("root mean square with the forces each femtosecond:")
for (method, name), values in scatter.items():
    print(f"{method:6} {name:13} {values[1]:.0e} kT")

# %% tags=["hide-input"]
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
for (name, rows), style, offset in zip(long.items(), ("o-", "s--"), (-0.04, 0.04), strict=True):
    at = np.array([*rows]) + offset
    drifts, errors = [row.drift for row in rows.values()], [row.error for row in rows.values()]
    left.errorbar(at, drifts, errors, fmt=style, ms=4, capsize=3, label=f"Verlet, {name}")
left.axhline(0, color="0.6", lw=0.8)
left.set_yscale("symlog", linthresh=10)
left.set_xticks([6, 7, 8, 9])
left.set(xlabel="step, fs", ylabel="drift of a molecule's energy, kT/ns")
left.legend(fontsize=8)
for (method, name), values in scatter.items():
    style = "s--" if name == "NO_SQUISH" else "o-"
    right.loglog([*values], [*values.values()], style, ms=4, label=f"{method}, {name}")
right.set(xlabel="time between evaluations of the forces, fs", ylabel="root mean square, kT")
right.set_xticks([1, 2, 4, 8], ["1", "2", "4", "8"])
right.grid(alpha=0.3)
right.legend(fontsize=8)
right.minorticks_off()

# %% [markdown]
# * **Verlet's method** in liquid water is equally good with either turn. The change of the torques, as
#   molecules swing in their cages, limits the step. Over 20 ps neither drifts measurably up to 5 fs; with
#   steps of 8 fs both, and LAMMPS, drift by 40 kT/ns. The exact turn costs less and removes one error.
# * **`saba2`** keeps the energy twice as well at the same cost, up to 3 fs between evaluations.
# * **`bm4`** with exact turns is best for small energy errors, at 1 fs and less between evaluations: more
#   than ten times as good as Verlet's method, and several times as good as `bm4` with NO_SQUISH.
# * **Long steps with weak forces**: molecules turn far between kicks, and the free turn is most of the
#   motion; see [integrate under a torque](howto_integrate_under_a_torque.ipynb).
#
# The table over 20 ps, with LAMMPS in it, is on the page [under a
# torque](site/pages/torques.md#molecules). Linear molecules have a moment that is zero, and are
# refused.

# %% tags=["hide-cell"]
assert wrong["rigidsym.step"] < 1e-13
assert wrong["NO_SQUISH"] > 1e-4
exact, squished = (scatter["verlet", name] for name in turns)
assert all(0.7 < exact[fs] / squished[fs] < 1.4 for fs in (1, 2))
assert 3 < exact[2] / exact[1] < 5  # order two
assert all(abs(rows[6].drift) < 20 for rows in long.values())
assert all(rows[9].drift > 50 for rows in long.values())
assert scatter["bm4", "rigidsym.step"][1] < exact[1] / 15
assert scatter["bm4", "rigidsym.step"][1] < scatter["bm4", "NO_SQUISH"][1] / 2
assert scatter["saba2", "rigidsym.step"][1] < exact[1] / 1.5
