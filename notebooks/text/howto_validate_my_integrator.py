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
# # How to validate my integrator
#
# Torque-free rigid-body motion is a test case with known exact states. This notebook measures an
# integrator on the strata that this project uses for itself. The example is the Runge–Kutta method of
# order four with equal steps, as found in many simulators.
#
# ## A function
#
# `examine` takes a function of the principal moments of inertia, the body rates and the attitude at
# $t = 0$, and times. It returns quaternions, scalar first, body to inertial, and body rates. All times
# have the same sign and increase in size, so that an integrator can step from one to the next.

# %%
import matplotlib.pyplot as plt
import numpy as np

from rigidsym.validate import STRATA, draw, examine, measure_case


def rates(y, c):
    """The equations of motion; y is the quaternion, then the rates."""
    (q0, *q), w = y[:4], y[4:]
    turning = np.array([-np.dot(q, w), *(q0 * w + np.cross(q, w))]) / 2
    return np.concatenate([turning, np.cross(c * w, w) / c])


def rk4(step, right_side=rates):
    """The classical method, in equal steps of at most so many radians from time to time."""

    def my_rk4(inertia, omega0, attitude0, times):
        y, now, rows = np.concatenate([attitude0, omega0]), 0.0, []
        rate = np.linalg.norm(omega0) or 1.0
        for time in times:
            count = max(1, int(np.ceil(abs(time - now) * rate / step)))
            for _ in range(count):
                y = stepped(lambda y: right_side(y, inertia), y, (time - now) / count)
            now = time
            rows.append(y)
        return np.array(rows)[:, :4], np.array(rows)[:, 4:]

    return my_rk4


def stepped(f, y, h):
    k1 = f(y)
    k2 = f(y + h / 2 * k1)
    k3 = f(y + h / 2 * k2)
    k4 = f(y + h * k3)
    return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


# %% [markdown]
# ## One call
#
# `examine` draws cases, encloses their true states, calls the function and reports its errors. Each
# stratum covers a difficult kind of motion; `STRATA` has all of them, and by default all those whose inputs
# are doubles are used. `reach` is the largest $|\omega_0 t|$ in radians at which the function is called.

# %%
REACH = 30.0  # rad
SOME = ("uniform", "near oblate", "near separatrix", "small scales")
mine = rk4(step=0.05)
report = examine(mine, strata=SOME, cases=2, reach=REACH)
report

# %% [markdown]
# The bounds are those of the generated modules, $2\cdot 10^{-15}$ rad, which no method of order four with
# such steps can keep; therefore the report says "not passed". It has the errors by stratum and measure, in
# radians or relative:

# %%
measures = {"angle": "angle (rad)", "norm": "| |q| - 1 |", "energy": "drift of H, relative"}
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
for (measure, label), mark in zip(measures.items(), "osv", strict=True):
    worst = report.by_stratum(measure)
    axes.semilogx([worst[name].error for name in SOME], range(len(SOME)), mark, label=label)
axes.set_yticks(range(len(SOME)), SOME)
axes.invert_yaxis()
axes.set_xlabel("worst error")
axes.set_title("RK4, steps of 0.05 rad, up to 30 rad")
axes.grid(alpha=0.3)
axes.legend(fontsize=8)
for name in SOME:
    print(f"{name}: {STRATA[name].about}")

# %% [markdown]
# Read the three measures together. A small error of the energy says little about the attitude. An error of
# the length says that the quaternion should be normalised. If an error is large, look at the *condition
# number* beside it: if that is large too, any method that rounds its inputs has such an error. The report
# also has case and time; `draw` draws the case again, and `measure_case` measures it alone. Here is a
# body that is nearly a rod:

# %%
worst = examine(mine, strata=["rod"], cases=2, reach=REACH).by_stratum()["rod"]
print(f"condition number: about 1e{round(np.log10(worst.condition))}")
sample = draw(*worst.case, seed=1)
print("moments:", ", ".join(f"{moment:.2g}" for moment in sorted(sample.inertia)))
finer = measure_case(sample, 40, {"finer": rk4(step=0.01)}).errors["finer"]["angle"]
print("finer steps help:", bool(finer.values.max() < 1e-6))

# %% [markdown]
# ## Checking the order
#
# With half the step, a method of order four should have a sixteenth of the error. Mistakes in the
# equations show at once, too: here quaternion and rates are multiplied in the wrong order (the rates
# are taken as inertial ones), which is the most frequent mistake.

# %%
steps = 0.31 / 2.0 ** np.arange(5)


def wrong_order(y, c):
    """As `rates`, with (0, omega) q for q (0, omega)."""
    (q0, *q), w = y[:4], y[4:]
    turning = np.array([-np.dot(q, w), *(q0 * w - np.cross(q, w))]) / 2
    return np.concatenate([turning, rates(y, c)[4:]])


def angle(integrator):
    return examine(integrator, strata=["paper"], reach=REACH).by_stratum()["paper"].error


errors = {
    name: [angle(rk4(step, right_side)) for step in steps]
    for name, right_side in (("as it should be", rates), ("(0, ω) q for q (0, ω)", wrong_order))
}
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, values in errors.items():
    axes.loglog(steps, values, "o-", label=name)
axes.loglog(steps, errors["as it should be"][0] * (steps / steps[0]) ** 4, "k:", label="order four")
axes.set_xticks(steps, [f"{step:.2g}" for step in steps])
axes.minorticks_off()
axes.set_xlabel("step (rad)")
axes.set_ylabel("worst angle (rad)")
axes.set_title("RK4 on the paper's spacecraft")
axes.grid(alpha=0.3)
axes.legend()

order = np.polyfit(np.log(steps), np.log(errors["as it should be"]), 1)[0]

# %% [markdown]
# ## Exceptions and NaN
#
# If an integrator raises an exception, or returns NaN or a wrong shape, its error there is infinite, and
# the report continues. The complaints have the messages:

# %%
CASES = 1


def transposed(inertia, omega0, attitude0, times):
    q, omega = mine(inertia, omega0, attitude0, times)
    return q.T, omega.T


broken = examine(transposed, strata=["spin"], cases=CASES, reach=REACH)
print(*broken.complaints, sep="\n")

# %% [markdown]
# ## The closed form
#
# It takes no steps and computes any time: all strata, including the longest times.

# %%
import rigidsym


def closed_form(inertia, omega0, attitude0, times):
    return rigidsym.TorqueFreeMotion(inertia, omega0, attitude0)(times)


closed = examine(closed_form, cases=1, reach=np.inf)
print("passed:", closed.passed, "on", len(closed.campaign.strata), "strata")

# %% [markdown]
# `report.to_markdown()` and `report.to_json()` are the whole of a report as text. Other programs,
# such as SciPy's `DOP853` and `LSODA`, `heyoka` and `orekit`, are measured in the same way by
# `rigidsym validate --peer NAME`; what has more to say than a function, such as that its
# quaternions have no sheet, is an object with the methods of `rigidsym.validate.Peer`.

# %% tags=["hide-cell"]
assert not report.passed
assert all(1e-12 < found.error < 1e-3 for found in report.by_stratum().values())
assert worst.condition > 1e12
assert finer.values.max() > 1e-4
assert abs(order - 4) < 0.2
assert min(errors["(0, ω) q for q (0, ω)"]) > 0.1
assert "must be" in broken.complaints[0]
assert closed.passed
assert max(found.error for found in closed.by_stratum().values()) < 2e-15
