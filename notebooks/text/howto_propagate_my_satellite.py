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
# # How to propagate my satellite
#
# From an inertia tensor, body rates from a gyro and an attitude, this notebook computes the attitude
# at later times, without torques.

# %%
import matplotlib.pyplot as plt
import numpy as np

import rigidsym

INERTIA = np.array([[0.0401, 0.0012, -0.0003], [0.0012, 0.0389, 0.0008], [-0.0003, 0.0008, 0.0112]])
RATES = np.array([0.03, -0.02, 0.05])  # rad/s, in the satellite's axes
ATTITUDE = (1, 0, 0, 0)  # scalar first, satellite's axes to inertial axes

# %% [markdown]
# ## Principal axes
#
# `rigidsym` works in principal axes, where the inertia is three numbers. `principal_axes` finds
# them; if your inertia is diagonal already, skip this.

# %%
body = rigidsym.principal_axes(INERTIA)
print("principal moments (kg m^2):", np.round(body.moments, 4))

# %% [markdown]
# The columns of `body.matrix` are the principal axes in the satellite's, right-handed, and
# `body.quaternion` is the same rotation, principal to satellite axes. `to_principal` turns rates
# and attitude into what a motion takes.

# %%
motion = rigidsym.TorqueFreeMotion(body.moments, *body.to_principal(RATES, ATTITUDE))
print(motion.regime)

# %% [markdown]
# ## States
#
# One call for all times, in seconds; any times, in any order, of any sign. `from_principal` goes
# back to the satellite's own axes:

# %%
t = np.linspace(0, 600, 1201)
q, rates = body.from_principal(*motion(t))

# %% [markdown]
# SciPy's `Rotation` does the rest. By default its quaternions are scalar *last*.

# %%
from scipy.spatial.transform import Rotation

attitude = Rotation.from_quat(q, scalar_first=True)  # satellite's axes to inertial axes

figure, (upper, lower) = plt.subplots(2, figsize=(7, 5), sharex=True, layout="constrained")
upper.plot(t, rates, label=["x", "y", "z"])
upper.set_ylabel("body rates (rad/s)")
upper.legend(loc="center left", bbox_to_anchor=(1, 0.5))
antenna = attitude.apply([0, 0, 1])
pointing = np.degrees(np.arccos(np.clip(antenna @ antenna[0], -1, 1)))
lower.plot(t, pointing, color="black")
lower.set_ylabel("antenna off its start (deg)")
lower.set_xlabel("t (s)")
for panel in (upper, lower):
    panel.grid(alpha=0.3)

momentum = attitude.apply(rates @ INERTIA)

# %% [markdown]
# The assertion is a useful check: the angular momentum in space, from *your* tensor and *your* axes, is
# constant to rounding. With wrong axes or quaternion conventions it would not be.
#
# ## Many at once
#
# One call also computes a batch of bodies, rates or attitudes; leading shapes broadcast. Here are a
# thousand samples of an uncertain gyro, ten minutes later:

# %%
drawn = RATES + np.random.default_rng(1).normal(0, 1e-5, (1000, 3))
omega0, attitude0 = body.to_principal(drawn, ATTITUDE)
states = rigidsym.propagate(body.moments, omega0, [600.0], attitude0=attitude0)
q_later, _ = body.from_principal(*states)
later = Rotation.from_quat(q_later[:, 0], scalar_first=True)
spread = np.degrees((attitude[-1].inv() * later).magnitude())
print(f"half of them are within {np.median(spread):.1f} degrees")

# %% [markdown]
# ## From the command line
#
# The same from a file, without Python, as CSV, JSON or NPZ:
#
# ```
# $ cat satellite.toml
# inertia = [0.0112, 0.0383, 0.0407]   # kg m^2, principal; strings are exact decimals
# omega0 = [0.05, 0.03, -0.02]         # rad/s
# times = [0, 60, 120]                 # s
#
# $ rigidsym propagate satellite.toml -o states.csv
# ```
#
# Python reads the same files:

# %% tags=["hide-cell"]
assert np.allclose(body.matrix @ np.diag(body.moments) @ body.matrix.T, INERTIA)
assert np.isclose(np.linalg.det(body.matrix), 1)
assert motion.regime in (rigidsym.Regime.LARGEST, rigidsym.Regime.SMALLEST)
assert q.shape == (1201, 4)
assert np.allclose(q[0], ATTITUDE)
assert np.allclose(rates[0], RATES)
assert np.ptp(momentum, axis=0).max() < 1e-15
assert q_later.shape == (1000, 1, 4)
assert 0.1 < np.median(spread) < 10
from rigidsym.io.cases import parse_case

case = parse_case("""
inertia = [0.0112, 0.0383, 0.0407]
omega0 = [0.05, 0.03, -0.02]
times = [0, 60, 120]
""")
q, omega = case.motion([float(time) for time in case.times])
assert q.shape == (3, 4)
