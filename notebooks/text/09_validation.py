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
# # 9. Validation
#
# A test at one random point accepts $\sqrt{x^2} = x$. Closed forms of rigid-body motion fail in narrow
# regions: near the separatrix, at nearly equal moments, where a rate changes its sign, after many
# periods. Therefore the generated modules are measured in *strata*, families of motions in each of these
# regions, against rigorous enclosures. This notebook reads the report.

# %%
import matplotlib.pyplot as plt
import numpy as np

from rigidsym.validate import validate
from support import table

report = validate(["numpy", "c"], cases=4, seed=1)
states = sum(report.tally.states.values())
print(f"{len(report.campaign.strata)} strata, {states} states of each module")
print("within all bounds:", report.passed)

# %% [markdown]
# (On the command line: `rigidsym validate --cases 4`, with `-o DIR` for a page to look at. A
# release is measured with far more cases; a case is drawn from seed, stratum and index alone, so
# any of them can be drawn again.)
#
# ## Strata
#
# A few of them, with their descriptions:

# %%
from rigidsym.validate.strata import STRATA

SOME = (
    "uniform",
    "near separatrix",
    "nearest separatrix",
    "nearest sphere",
    "near spin, middle",
    "longest times",
    "branch switch",
    "zeros of the rates",
)
table({"stratum": f"**{name}**", "covers": STRATA[name].about} for name in SOME)

# %% [markdown]
# The second assertion matters: a stratum that tested nothing *fails*.
#
# ## Measures
#
# Each state is measured in several ways, in units of $2^{-53} \approx 1.1\cdot10^{-16}$, the
# rounding of a single double. Each measure has a documented bound:

# %%
from rigidsym.validate._bounds import BOUNDS, MEANINGS, ULP

meanings = {name: text.replace("|", "&#124;") for name, text in MEANINGS.items()}
table(
    {"measure": name, "is": meanings[name], "bound": f"{b:.0e}", "in units": round(b / ULP, 1)}
    for name, b in BOUNDS.items()
)

# %% [markdown]
# The *angle* says most: it is the rotation from the true attitude, on the right sheet of the
# double cover (a quaternion of the wrong sign is $2\pi$ off). And since the truth comes in Arb's
# balls, the radius is added to what is measured: a pass is a statement with a bound, not an
# impression.
#
# Here is the whole campaign in one picture, the worst angle of every stratum:

# %%
strata = report.campaign.strata
figure, axes = plt.subplots(figsize=(7.5, 8), layout="constrained")
rows = np.arange(len(strata))
for target, mark in (("numpy", "o"), ("c", "x")):
    worst = report.tally.view(target, "angle", "stratum")
    axes.plot([worst[name].worst for name in strata], rows, mark, label=target)
axes.axvline(BOUNDS["angle"] / ULP, color="grey", linestyle=":", label="bound: 2e-15 rad")
axes.set_yticks(rows, strata, fontsize=8)
axes.invert_yaxis()
axes.set_xlim(0, None)
axes.set_xlabel(r"worst rotation angle ($2^{-53}$ rad)")
axes.set_title("Worst of every stratum")
axes.grid(alpha=0.3)
axes.legend(loc="center right", bbox_to_anchor=(0.95, 0.5))
plt.show()

# %% [markdown]
# No stratum stands out, and that is the point: the separatrix, the sphere and $2^{46}$ radians cost
# no more than an ordinary tumble.
#
# ## Is the problem hard, or the program bad?
#
# Near the separatrix, or after a long time, a state depends violently on its inputs. The *condition
# number* says how much: a relative change of $\varepsilon$ in inertia, rates and time turns the
# attitude by about $\kappa\,\varepsilon$. Any program that *rounds its inputs*, or its constants,
# must expect errors of $\kappa\cdot2^{-53}$; textbooks call that backward stable and are content.
#
# Here the inputs mean their exact values, so there is nothing to be lenient about. The report keeps
# the worst error by decades of $\kappa$:

# %%
worst = report.tally.view("c", "angle", "condition")
decades = sorted(float(part) for part in worst if part not in ("0", "inf"))
units = [worst[f"1e{round(np.log10(d)):+d}"].worst for d in decades]

figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.loglog(decades, units, "o", label="generated C")
axes.loglog(
    decades, np.maximum(decades, 1), color="#d55e00", label="what backward stability allows"
)
axes.axhline(BOUNDS["angle"] / ULP, color="grey", linestyle=":", label="documented bound")
axes.set_ylim(0.5, 1e10)
axes.set_xlabel("condition number of the attitude (rad)")
axes.set_ylabel(r"worst angle ($2^{-53}$ rad)")
axes.set_title("Errors do not grow with the condition number")
axes.grid(alpha=0.3)
axes.legend()
plt.show()

# %% [markdown]
# ## One case in detail
#
# `rigidsym validate --case "near separatrix:2"` measures one case alone, and so does this cell. The
# *reference* is its enclosure.

# %%
from rigidsym.validate._finding import measure_case
from rigidsym.validate.strata import draw

sample = draw("near separatrix", 2, seed=1)
finding = measure_case(sample, digits=40, implementations=["numpy", "peer dop853"])
reference = finding.reference
print("regime:                      ", reference.regime)
print(f"distance from the separatrix: {reference.distance:.0e}")
print(f"radius of the truth:          below {1e-39:.0e}")

# %% [markdown]
# `peer dop853` is SciPy's integrator at the tightest tolerance it takes, measured beside the module
# on the same case, at the times within its reach:

# %%
figure, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
for name, mark in (("numpy", "o"), ("peer dop853", "s")):
    angle = finding.errors[name]["angle"]
    axes.loglog(np.abs(angle.times)[1:], angle.units[1:] * ULP, mark, markersize=4, label=name)
angle = finding.errors["numpy"]["angle"]
order = np.argsort(np.abs(angle.times))[1:]
axes.loglog(
    np.abs(angle.times)[order], angle.condition[order] * ULP,
    color="grey", linewidth=1, label=r"condition $\times\ 2^{-53}$",
)  # fmt: skip
axes.axhline(BOUNDS["angle"], color="grey", linestyle=":", label="bound of the module")
axes.set_ylim(1e-18, 10)
axes.set_xlabel("|t| (s)")
axes.set_ylabel("angle from the true attitude (rad)")
axes.set_title(f"{sample.stratum}, case {sample.index}")
axes.grid(alpha=0.3)
axes.legend(fontsize=8)
plt.show()

# %% [markdown]
# The integrator is good: its errors follow the grey line, so they are about as large as those of a change in
# the last digits of the inputs. The closed form still stays at the bottom, for the exact inputs.
#
# ## Peers side by side
#
# The same comparison by stratum. Peers have no documented bound here; the report only states their errors.

# %%
AMONG = ("paper", "uniform", "symmetric", "near separatrix", "long times")
beside = validate(["numpy"], cases=2, peers=["dop853"], strata=AMONG)
worst = {name: beside.tally.view(name, "angle", "stratum") for name in ("numpy", "peer dop853")}


def digits(cell):
    """Return how many decimal digits of the attitude are right, where rounding does not decide."""
    found = int(-np.log10(cell.worst * ULP))
    return found if found > 2 else "fewer than 3"


table(
    {
        "stratum": name,
        "digits right: numpy": digits(worst["numpy"][name]),
        "DOP853": digits(worst["peer dop853"][name]),
    }
    for name in beside.campaign.strata
)

# %% [markdown]
# Other peers are `heyoka`, `orekit` and `lsoda` (extra `bench`). For an integrator of your own, see
# [validate my integrator](howto_validate_my_integrator.ipynb).
#
# ## Does it detect faults?
#
# A validation that has never failed has not been tested. Therefore faults are put into the code: small
# changes of what it is printed from, each wrong only in some motions or at some times, for instance a constant
# off by $10^{-12}$, a dropped last term of a series, a forgotten winding. Some are written by hand; others
# are drawn from the derived lines, as one change in the tree of a formula.

# %%
from collections import Counter

from rigidsym.validate.faults import all_faults

faults = all_faults()
kinds = Counter(fault.kind for fault in faults)
print(f"{len(faults)} faults of {len(kinds)} kinds")
fault = next(f for f in faults if f.line == "numpy: the last term of theta_1 dropped, circular")
print(f"{fault.line}: {fault.place}\n    {fault.old}\n    {fault.new}")

# %% [markdown]
# That term is the smallest of its series: in most motions it is far below rounding. These strata detect
# it:

# %%
from rigidsym.validate.faults._detection import first, mutated_engine, references

engine = mutated_engine(fault)
notices = {
    name: first(engine, references(name, cases=6, digits=40, seed=1))
    for name in ("paper", "uniform", "symmetric", "branch switch")
}
table(
    {
        "stratum": name,
        "notices": "no" if notice is None else f"yes, in case {notice.index}",
        "by": "" if notice is None else ", ".join(notice.measures),
    }
    for name, notice in notices.items()
)

# %% [markdown]
# It is the stratum made for this: there the module changes from one series to the other, and both are least
# accurate. `rigidsym validate --faults` measures all faults in all strata; some stratum detects each.
#
# ## Checking the oracle
#
# The oracle evaluates the proved formulas in balls. If it had the same error as the modules, nothing above
# would show it. Therefore Taylor series of the equations of motion, without elliptic functions, check one
# case in 128, the first of every stratum among them. The report has the largest difference, in parts of
# $10^{-20}$:

# %%
agreement = {name: report.agreement(name) for name in report.campaign.strata}
print("the oracles agree to 1e-20 in every stratum:", max(agreement.values()) <= 1)

# %% tags=["hide-cell"]
assert report.passed
assert not report.complaints
assert set(SOME) <= set(report.campaign.strata)
assert all(report.tally.cases[name] > 0 for name in report.campaign.strata)
assert BOUNDS["angle"] == 2e-15
assert all(report.share(target, name) <= 1 for target in ("numpy", "c") for name in strata)
assert max(decades) >= 1e15
assert max(units) <= BOUNDS["angle"] / ULP
assert 0 < reference.distance < 1e-7
assert reference.radius < 1e-39
assert finding.share("numpy") <= 1
assert finding.share("peer dop853") > 1e6
assert beside.passed
assert all(beside.share("peer dop853", name) > beside.share("numpy", name) for name in AMONG)
assert {fault.target for fault in faults} >= {
    "numpy",
    "c",
    "numpy-pi",
    "c-pi",
    "numpy-step",
    "c-step",
}
assert notices["paper"] is None
assert notices["branch switch"] is not None
assert len(agreement) == len(STRATA)
assert max(agreement.values()) <= 1
