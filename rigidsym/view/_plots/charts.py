"""Line charts, residual plots, and plots of distributions over cases."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from rigidsym.view._plots.figure import blank, defaults, legend, svg, tidy
from rigidsym.view._style import AXES, BLUE, MARK, ORANGE, SERIES, TIME_AXIS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class Panel:
    """Line chart of several series over the same abscissae.

    A line leaves out values that are None.  With `log`, both axes are logarithmic.  `colours`
    repeat where there are more lines.  With `marked`, each value is a dot.
    """

    title: str
    x_label: str
    y_label: str
    x: Sequence[float]
    lines: Mapping[str, Sequence[float | None]]
    log: bool = False
    colours: Sequence[str] = SERIES
    marked: bool = False


@defaults()
def panels_svg(panels: Sequence[Panel]) -> str:
    """Draw line charts below each other, and return them as one SVG document."""
    figure = blank("drawing", 10.0, 3.2 * len(panels))
    for axes, panel in zip(figure.subplots(len(panels), squeeze=False)[:, 0], panels, strict=True):
        for k, (name, values) in enumerate(panel.lines.items()):
            points = [(x, y) for x, y in zip(panel.x, values, strict=True) if y is not None]
            axes.plot(
                *zip(*points, strict=True) if points else ((), ()),
                color=panel.colours[k % len(panel.colours)],
                label=name,
                linewidth=1.5,
                marker="o" if panel.marked else "",
                markersize=4,
                gid=f"line {panel.title}: {name}",
            )
        axes.set(title=panel.title, xlabel=panel.x_label, ylabel=panel.y_label)
        if panel.log:
            axes.set(xscale="log", yscale="log")
        tidy(axes)
        legend(axes)
    return svg(figure, {"svg.fonttype": "none"})


@defaults()
def residuals(panels: Sequence[tuple[str, np.ndarray, np.ndarray, Sequence[int]]]) -> "Figure":
    """Plot the residuals of a fit, with a panel for each set of observations.

    A panel is a title, times (N,), residuals (N, k) in units of their errors, and the indices of
    outliers, which get a ring around the largest residual.
    """
    figure = blank("drawing", 8.0, 1.0 + 2.0 * len(panels))
    every = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, (title, times, values, outliers) in zip(every, panels, strict=True):
        axes.axhspan(-1, 1, color="0.5", alpha=0.15, linewidth=0)
        for k, column in enumerate(values.T):
            axes.plot(times, column, "o", markersize=3.5, color=AXES[k % 3], label=str(k + 1))
        for index in outliers:
            worst = values[index, np.argmax(np.abs(values[index]))]
            axes.plot(times[index], worst, "o", markersize=11, fillstyle="none", color=MARK)
        axes.set_ylabel(f"{title}\n(standard deviations)")
        tidy(axes)
        legend(axes)
    every[-1].set_xlabel(TIME_AXIS)
    return figure


class Spread(NamedTuple):
    """Distribution of a quantity over cases, in named rows.

    With `ratio`, the axis is logarithmic and has a line at 1."""

    title: str
    label: str
    rows: Mapping[str, Sequence[float]]
    ratio: bool


@defaults()
def spreads(panels: Sequence[Spread], case: str, one: str) -> "Figure":
    """Plot distributions as a dot for each case and a bar at the median.

    A legend is below.  The legend explains a dot by `case`, and the line at a ratio of 1 by `one`.
    A panel with the same rows as the one before it repeats no names.
    """
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

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
            # The labels are 1, 2, 5 and their decades, not powers.
            axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axes.xaxis.set_minor_formatter(NullFormatter())
        else:
            axes.set_xlim(left=0)
    dot = Line2D([], [], marker="o", color=BLUE, markersize=4, linestyle="none", label=case)
    bar = Line2D([], [], marker="|", color=ORANGE, markersize=12, linestyle="none", label="median")
    bar.set_markeredgewidth(2)
    unit = Line2D([], [], color="0.4", linewidth=1.0, linestyle=":", label=one)
    figure.legend(
        handles=[dot, bar, unit], loc="outside lower center", ncols=3, frameon=False, fontsize=9
    )
    return figure


def _dots(axes: "Axes", rows: Mapping[str, Sequence[float]]) -> None:
    """Draw the values of each named row as dots, with a bar at the median.

    The first row is on top.
    """
    for place, values in enumerate(rows.values()):
        offsets = 0.5 * (np.arange(len(values)) + 0.5) / len(values) - 0.25
        axes.plot(values, place + offsets, "o", color=BLUE, markersize=3, alpha=0.7)
        axes.vlines(np.median(values), place - 0.35, place + 0.35, color=ORANGE, lw=2)
    axes.set_yticks(range(len(rows)), [*rows], fontsize=9)
    axes.invert_yaxis()
    axes.grid(axis="x", alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
