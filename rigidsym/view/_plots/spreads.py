"""Distributions of figures over cases, of several things side by side."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.view._plots.figure import defaults
from rigidsym.view._style import BLUE, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class Panel:
    """Rows of figures by name, one figure a case; `ratio` marks 1 on a logarithmic axis.

    A panel with the same rows as the one before it repeats no names.
    """

    title: str
    label: str
    rows: Mapping[str, Sequence[float]]
    ratio: bool


@defaults()
def spreads(panels: Sequence[Panel], case: str, one: str) -> "Figure":
    """Draw a dot for each case and a bar at the median, with a legend below.

    The legend explains a dot by `case`, and the line at a ratio of 1 by `one`.
    """
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
    """Draw a row for each name, the first on top, its dots offset in the order of cases."""
    for place, values in enumerate(rows.values()):
        offsets = 0.5 * (np.arange(len(values)) + 0.5) / len(values) - 0.25
        axes.plot(values, place + offsets, "o", color=BLUE, markersize=3, alpha=0.7)
        axes.vlines(np.median(values), place - 0.35, place + 0.35, color=ORANGE, lw=2)
    axes.set_yticks(range(len(rows)), [*rows], fontsize=9)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def _plain_ticks(axes: "Axes") -> None:
    """Label 1, 2, 5 and their decades, not powers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
