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
# # How to validate my integrator
#
# You have an integrator, for attitude or for everything, and rigid body motion without torque is
# the one case where the truth is known. Here it is put through the strata on which this project
# measures itself: Runge and Kutta's method of order four with equal steps, as found in many
# simulators.

# %%
import matplotlib.pyplot as plt
import numpy as np

from rigidsym.validate.measure import ULP, measure
from rigidsym.validate.oracle import enclose
from rigidsym.validate.peers.equations import rates
from rigidsym.validate.peers.start import Start, both_ways
from rigidsym.validate.strata import STRATA, draw
from support import table

# %% [markdown]
# ## A wrapper
#
# What is measured has a method `plan` (one motion, from doubles) and `states` (quaternions, scalar
# first, body to inertial, and body rates, at any times). `reach` is the largest $|\omega_0 t|$ in
# radians it is to be asked for, `sheets` whether its quaternion is continuous, sign included.
#
# `Start` checks and normalises what is given; `both_ways` asks for times that leave zero, each
# farther than the one before, so that an integrator need not care about order and sign. `rates` are
# the right sides of the equations of motion; use your own, they are what you want to test.

# %%
REACH = 30.0  # rad


class RK4:
    """The classical method, in equal steps of at most so many radians from time to time."""

    name, version = "my rk4", "1"
    reach, sheets = REACH, True

    def __init__(self, step, right_side=rates):
        self.step, self.right_side = step, right_side

    def plan(self, inertia, omega0, attitude0):
        """One motion."""
        return Start(inertia, omega0, attitude0)

    def states(self, plan, t):
        """(q, omega), (N, 4) and (N, 3)."""
        return both_ways(plan, t, lambda times: self._follow(plan, times))

    def _follow(self, plan, times):
        y, now, rows = np.array(plan.state), 0.0, []
        rate = np.linalg.norm(plan.omega0) or 1.0
        for time in times:
            count = max(1, int(np.ceil(abs(time - now) * rate / self.step)))
            for _ in range(count):
                y = self._stepped(y, (time - now) / count, plan.inertia)
            now = time
            rows.append(y)
        return np.array(rows)

    def _stepped(self, y, h, inertia):
        def f(y):
            return np.array(self.right_side(y.tolist(), inertia))

        k1 = f(y)
        k2 = f(y + h / 2 * k1)
        k3 = f(y + h / 2 * k2)
        k4 = f(y + h * k3)
        return y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


# %% [markdown]
# ## One case
#
# `draw` a case, `enclose` its true states to twenty digits and more, `measure`. The result has the
# errors by measure, at the case's times, in units of $2^{-53}$.

# %%
SEED = 1


def measured(integrator, stratum, index=0):
    """The errors of an integrator in one case, within its reach."""
    truth = enclose(draw(stratum, index, SEED), digits=30)
    return measure(truth.within(integrator.reach), integrator)


found = measured(RK4(step=0.05), "paper")
angle = found["angle"]
print("measures:", ", ".join(found))
print(f"{len(angle.times)} states, worst about 1e{round(np.log10(angle.units.max() * ULP))} rad")
assert len(angle.times) > 3
assert 1e-9 < angle.units.max() * ULP < 1e-3

# %% [markdown]
# ## Is its order what I think?
#
# Halve the step, and a method of order four should be sixteen times as good. A mistake in the right
# sides shows at once, too: here, quaternion and rates multiplied in the wrong order (the rates
# taken as inertial ones), which is the most frequent mistake of all.

# %%
steps = 0.31 / 2.0 ** np.arange(5)


def wrong_order(y, c):
    """As `rates`, with (0, omega) q for q (0, omega)."""
    q0, q1, q2, q3, w1, w2, w3 = y
    cross = (w2 * q3 - w3 * q2, w3 * q1 - w1 * q3, w1 * q2 - w2 * q1)
    vector = [(q0 * w + x) / 2 for w, x in zip((w1, w2, w3), cross, strict=True)]
    return [-(q1 * w1 + q2 * w2 + q3 * w3) / 2, *vector, *rates(y, c)[4:]]


errors = {
    name: [measured(RK4(h, f), "paper")["angle"].units.max() * ULP for h in steps]
    for name, f in (("as it should be", rates), ("(0, ω) q for q (0, ω)", wrong_order))
}
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, values in errors.items():
    axes.loglog(steps, values, "o-", label=name)
axes.loglog(steps, errors["as it should be"][0] * (steps / steps[0]) ** 4, "k:", label="order four")
axes.set_xlabel("step (rad)")
axes.set_ylabel("worst angle (rad)")
axes.set_title("RK4 on the paper's spacecraft")
axes.grid(alpha=0.3)
axes.legend()

order = np.polyfit(np.log(steps), np.log(errors["as it should be"]), 1)[0]
assert abs(order - 4) < 0.2
assert min(errors["(0, ω) q for q (0, ω)"]) > 0.1

# %% [markdown]
# ## All over the place
#
# An integrator that is good on one spacecraft may be bad on another. The strata go where motions
# are difficult; `STRATA` has 36. Here are five, three cases of each:

# %%
SOME = ("uniform", "near oblate", "near separatrix", "rod", "small scales")
integrator = RK4(step=0.05)
worst = {
    name: [
        max(measured(integrator, name, k)[m].units.max() * ULP for k in range(3))
        for m in ("angle", "norm", "energy")
    ]
    for name in SOME
}
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
rows = np.arange(len(SOME))
for values, mark, label in zip(
    np.transpose(list(worst.values())), "osv",
    ("angle (rad)", "| |q| - 1 |", "drift of H, relative"), strict=True,
):  # fmt: skip
    axes.semilogx(values, rows, mark, label=label)
axes.set_yticks(rows, SOME)
axes.invert_yaxis()
axes.set_xlabel("worst error")
axes.set_title("RK4, steps of 0.05 rad, up to 30 rad")
axes.grid(alpha=0.3)
axes.legend(fontsize=8)
assert all(1e-12 < angle < 0.1 for angle, _, _ in worst.values())
table({"stratum": name, "covers": STRATA[name].about} for name in SOME)

# %% [markdown]
# Read the three marks together. Energy that is kept well says little about the attitude; length
# that is lost says that the quaternion should be normalised. Where an error is large, look at the
# *condition number* in `measured(…)["angle"].condition`: if that is large too, the problem is hard
# for everybody who rounds, and not your fault.
#
# ## The closed form under the same eyes

# %%
from rigidsym import engines

exact = engines.exactly("numpy")
closed = [
    measure(enclose(draw(name, k, SEED), digits=30), exact)["angle"].units.max() * ULP
    for name in SOME
    for k in range(3)
]
print("all within 2e-15 rad:", max(closed) < 2e-15)
assert max(closed) < 2e-15

# %% [markdown]
# To have your integrator in `rigidsym validate --peer NAME` and its report, put the class into
# `rigidsym/validate/peers` and its name into the table there. SciPy's `DOP853` and `LSODA`,
# `heyoka` and `orekit` are in it already: they are good examples to begin with.
