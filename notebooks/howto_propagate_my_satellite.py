# ---
# jupyter:
#   jupytext:
#     cell_metadata_filter: tags,-all
#     formats: ipynb,py:percent
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
# You have an inertia tensor, body rates from a gyro and an attitude, and want to know where the
# satellite points from now on, as long as nothing pushes it.

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
# `rigidsym` works in principal axes, where the inertia is three numbers. An eigenvalue problem
# finds them; the columns of `axes` are the principal axes in the satellite's, made right-handed. If
# your inertia is diagonal already, skip this.

# %%
moments, axes = np.linalg.eigh(INERTIA)
axes[:, 2] *= np.sign(np.linalg.det(axes))
assert np.allclose(axes @ np.diag(moments) @ axes.T, INERTIA)
assert np.isclose(np.linalg.det(axes), 1)
print("principal moments (kg m^2):", np.round(moments, 4))

# %% [markdown]
# The rates turn into principal axes by the transpose, and the attitude takes the constant rotation
# from principal to satellite axes along. `Rotation` from SciPy keeps quaternions scalar *last*
# unless told otherwise.

# %%
from scipy.spatial.transform import Rotation

to_satellite = Rotation.from_matrix(axes)
start = Rotation.from_quat(ATTITUDE, scalar_first=True) * to_satellite
motion = rigidsym.TorqueFreeMotion(moments, axes.T @ RATES, start.as_quat(scalar_first=True))
print(motion.regime)
assert motion.regime in (rigidsym.Regime.LARGEST, rigidsym.Regime.SMALLEST)

# %% [markdown]
# ## States
#
# One call for all times, in seconds; any times, in any order, of any sign. Then back to the
# satellite's own axes:

# %%
t = np.linspace(0, 600, 1201)
q, omega = motion(t)
attitude = motion.rotation(t) * to_satellite.inv()  # satellite's axes to inertial axes
rates = omega @ axes.T
assert q.shape == (1201, 4)
assert np.allclose(rates[0], RATES)
assert np.allclose(attitude[0].magnitude(), 0, atol=1e-7)

# %%
figure, (upper, lower) = plt.subplots(2, figsize=(7, 5), sharex=True, layout="constrained")
upper.plot(t, rates, label=["x", "y", "z"])
upper.set_ylabel("body rates (rad/s)")
upper.legend(loc="right")
antenna = attitude.apply([0, 0, 1])
pointing = np.degrees(np.arccos(np.clip(antenna @ antenna[0], -1, 1)))
lower.plot(t, pointing, color="black")
lower.set_ylabel("antenna off its start (deg)")
lower.set_xlabel("t (s)")
for panel in (upper, lower):
    panel.grid(alpha=0.3)

momentum = attitude.apply(rates @ INERTIA)
assert np.ptp(momentum, axis=0).max() < 1e-15

# %% [markdown]
# The assertion is worth a look: the angular momentum in space, from *your* tensor and *your* axes,
# is constant to rounding. If axes or quaternion conventions were mixed up, it would not be.
#
# ## Many at once
#
# A batch of bodies, rates or attitudes is one call too; leading shapes broadcast. Here a thousand
# draws of an uncertain gyro, ten minutes later:

# %%
drawn = RATES + np.random.default_rng(1).normal(0, 1e-5, (1000, 3))
q_later, _ = rigidsym.propagate(
    moments, drawn @ axes, [600.0], attitude0=start.as_quat(scalar_first=True)
)
later = Rotation.from_quat(q_later[:, 0], scalar_first=True) * to_satellite.inv()
spread = np.degrees((attitude[-1].inv() * later).magnitude())
print(f"half of them are within {np.median(spread):.1f} degrees")
assert q_later.shape == (1000, 1, 4)
assert 0.1 < np.median(spread) < 10

# %% [markdown]
# ## From the command line
#
# The same from a file, without any Python, as CSV, JSON or NPZ:
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
# What a file may hold can be read here as well:

# %%
from rigidsym.cases import parse_case

case = parse_case("""
inertia = [0.0112, 0.0383, 0.0407]
omega0 = [0.05, 0.03, -0.02]
times = [0, 60, 120]
""")
q, omega = case.motion([float(time) for time in case.times])
assert q.shape == (3, 4)
