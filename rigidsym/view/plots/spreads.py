"""How much figures differ from case to case, of several things side by side."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.view.palette import BLUE, ORANGE
from rigidsym.view.plots import histories

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class Panel:
    """Rows of figures by name, one figure a case; `ratio` marks 1 on an axis of logarithms.

    A panel with the rows of the one before it has no names of its own.
    """

    title: str
    label: str
    rows: Mapping[str, Sequence[float]]
    ratio: bool


@histories.defaults()
def spreads(panels: Sequence[Panel], case: str, one: str) -> "Figure":
    """A dot for each case, a bar at the median, and below what both are: `case` says what a dot

    stands for, `one` what a ratio of 1 is."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.0, 4.9), layout="constrained")
    names: list[str] = []
    for axes, panel in zip(figure.subplots(1, len(panels)), panels, strict=True):
        _dots(axes, panel.rows)
        if names == [*panel.rows]:
            axes.set_yticklabels([])
        names = [*panel.rows]
        axes.set_title(panel.title, fontsize=10)
        axes.set_xlabel(panel.label)
        if panel.ratio:
            axes.set_xscale("log")
            axes.axvline(1.0, color="0.4", linewidth=1.0, linestyle=":")
            _plain_ticks(axes)
        else:
            axes.set_xlim(left=0)
    _explain(figure, case, one)
    return figure


def _explain(figure: "Figure", case: str, one: str) -> None:
    from matplotlib.lines import Line2D

    dot = Line2D([], [], marker="o", color=BLUE, markersize=4, linestyle="none", label=case)
    bar = Line2D([], [], marker="|", color=ORANGE, markersize=12, linestyle="none", label="median")
    bar.set_markeredgewidth(2)
    unit = Line2D([], [], color="0.4", linewidth=1.0, linestyle=":", label=one)
    figure.legend(
        handles=[dot, bar, unit], loc="outside lower center", ncols=3, frameon=False, fontsize=9
    )


def _dots(axes: "Axes", rows: Mapping[str, Sequence[float]]) -> None:
    """A row for each name, the first on top; dots are spread a little, in the order of cases."""
    for place, values in enumerate(rows.values()):
        offsets = 0.5 * (np.arange(len(values)) + 0.5) / len(values) - 0.25
        axes.plot(values, place + offsets, "o", color=BLUE, markersize=3, alpha=0.7)
        axes.vlines(np.median(values), place - 0.35, place + 0.35, color=ORANGE, lw=2)
    axes.set_yticks(range(len(rows)), [*rows], fontsize=9)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def _plain_ticks(axes: "Axes") -> None:
    """1, 2, 5 and their decades, not powers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
