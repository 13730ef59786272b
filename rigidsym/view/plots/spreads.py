"""The spread of costs over manoeuvres, and of the optimiser's iterations, in one picture."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.manoeuvre.comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre.comparison.record import Record
from rigidsym.manoeuvre.comparison.statistics import least
from rigidsym.view.plots import histories as drawing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SHOWN = Task(Model.THRUSTERS, Cost.FUEL)


@drawing.defaults()
def picture(records: Sequence[Record]) -> "Figure":
    """A dot for each manoeuvre, a bar at the median: costs by method, iterations by guess."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 4.6), layout="constrained")
    panels = figure.subplots(1, 3)
    for axes, model in zip(panels, reversed(Model), strict=False):
        _dots(axes, _costs(records, model))
        axes.set_title(f"flown with {model}", fontsize=10)
        axes.set_xlabel("torque integral over the least fuel")
        axes.set_xscale("log")
        axes.axvline(1.0, color="0.4", linewidth=1.0, linestyle=":")
        _plain_ticks(axes)
    _dots(panels[2], _iterations(records))
    panels[2].set_title(f"optimal control: {_SHOWN.name}", fontsize=10)
    panels[2].set_xlabel("iterations of IPOPT")
    panels[2].set_xlim(left=0)
    return figure


def _costs(records: Sequence[Record], model: Model) -> Mapping[str, list[float]]:
    return {
        method: [
            record.flown[model.value][method].torque_integral / least(record, model, limited=True)
            for record in records
        ]
        for method in records[0].flown[model.value]
    }


def _iterations(records: Sequence[Record]) -> Mapping[str, list[float]]:
    solved = [record.solved[_SHOWN.name].attempts for record in records]
    return {
        f"{guess},\n{setting}": [float(one[setting][guess].iterations) for one in solved]
        for setting, guesses in solved[0].items()
        for guess in guesses
    }


def _dots(axes: Any, rows: Mapping[str, list[float]]) -> None:
    """A row for each name, the first on top; dots are spread a little, in the order of cases."""
    for place, values in enumerate(rows.values()):
        offsets = 0.5 * (np.arange(len(values)) + 0.5) / len(values) - 0.25
        axes.plot(values, place + offsets, "o", color=drawing.AXES[0], markersize=3, alpha=0.7)
        axes.vlines(np.median(values), place - 0.35, place + 0.35, color=drawing.AXES[1], lw=2)
    axes.set_yticks(range(len(rows)), [*rows], fontsize=9)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def _plain_ticks(axes: Any) -> None:
    """1, 2, 5 and their decades, not powers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
