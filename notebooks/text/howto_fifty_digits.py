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
# # How to get fifty digits
#
# Use `precise` and `enclose` for reference solutions.

# %%
import mpmath

import rigidsym

motion = rigidsym.TorqueFreeMotion(
    ("0.0109", "0.04", "0.0506"),  # kg m^2
    ("0.05", "0.03", "-0.02"),  # rad/s
)
q, omega = motion.precise("180", digits=50)
for name, value in zip(("q0", "q1", "q2", "q3"), q, strict=True):
    print(name, mpmath.nstr(value, 50))

# %% [markdown]
# Four rules:
#
# * **Give numbers as strings** (or `Fraction`, `Decimal`): `"0.0109"` is 109/10000, the float
#   `0.0109` is a binary fraction near it, and taken as exactly that. Times too: `"0.1"`.
# * **Print with `mpmath.nstr(value, 50)`**: `print(value)` shows fifteen digits.
# * **Compute under `mpmath.workdps`**: mpmath rounds every operation to its own precision.
# * **Use `enclose` for a rigorous error bound**: it returns balls that contain the true values.

# %%
with mpmath.workdps(60):
    pointing = 2 * mpmath.acos(q[0])
    length = mpmath.sqrt(mpmath.fdot(q, q))
print("turned by", mpmath.nstr(pointing, 50), "rad")

q_ball, omega_ball = motion.enclose("180", digits=50)
print(q_ball[0].str(52))

# %% [markdown]
# Compare with another method; each has its own formula for the turn about the momentum:

# %% [markdown]
# A thousand digits and large times are possible, too. To limit the time, use `max_seconds=5`, which
# raises `rigidsym.PrecisionError` after 5 s.

# %%
q_many, _ = motion.precise("1e15", digits=1000)
digits = mpmath.nstr(q_many[0], 1000)
print(f"{digits[:40]}...")

# %% [markdown]
# On the command line, into a file:
#
# ```
# rigidsym propagate satellite.toml --digits 50 -o states.csv
# rigidsym propagate satellite.toml --digits 50 --enclose --format json
# ```
#
# [Fifty digits and a proof](07_fifty_digits_and_a_proof.ipynb) explains why the digits are correct.

# %% tags=["hide-cell"]
assert abs(length - 1) < mpmath.mpf("1e-49")
assert float(q_ball[0].rad()) < 1e-50
assert all(abs(float(ball) - float(x)) < 1e-15 for ball, x in zip(q_ball, q, strict=True))
for method in ("theta", "carlson", "landen", "quadrature"):
    other = motion.precise("180", digits=50, method=method)[0]
    with mpmath.workdps(60):
        assert max(abs(x - y) for x, y in zip(q, other, strict=True)) < mpmath.mpf("1e-49")
assert len(digits) > 1000
