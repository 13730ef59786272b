"""Line pictures by matplotlib, the same bytes on each run: SVG and PNG.

Functions that make figures are decorated by `defaults()`: the user's matplotlibrc has no part.
"""

import io
from typing import TYPE_CHECKING, TypedDict, Unpack

import numpy as np

from rigidsym.errors import require
from rigidsym.view.labels import TIME_AXIS
from rigidsym.view.palette import AXES
from rigidsym.view.plots import figure as flat
from rigidsym.view.plots.figure import defaults

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

require("drawing", "matplotlib")


class Style(TypedDict, total=False):
    """How a line is drawn: its width, in points, and its dashes."""

    linewidth: float
    linestyle: tuple[int, tuple[int, int]]


FLOWN: Style = {"linewidth": 2.0}
WANTED: Style = {"linewidth": 1.0, "linestyle": (0, (5, 3))}


@defaults()
def blank(height: float = 4.2) -> tuple["Figure", "Axes"]:
    """A figure that shows itself in a notebook, and its axes over time."""
    figure = flat.blank("drawing", 8.0, height)
    axes = figure.add_subplot()
    axes.set_xlabel(TIME_AXIS)
    # What happens at the first time is not hidden by the axis.
    axes.margins(x=0.01)
    axes.locator_params(axis="x", nbins=10, steps=[1, 2, 5, 10])
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def lines(
    axes: "Axes",
    t: np.ndarray,
    values: np.ndarray,
    labels: tuple[str, ...],
    colours: tuple[str, ...] = AXES,
    **style: Unpack[Style],
) -> None:
    """A line for each column of values (N, k); a label that is empty is left out of the legend."""
    for column, label, colour in zip(values.T, labels, colours, strict=True):
        axes.plot(t, column, color=colour, label=label or None, **style)


def legend(axes: "Axes") -> None:
    """Beside the plot, where it hides nothing."""
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def mark(axes: "Axes", t: float, text: str) -> None:
    """A dotted line at a time, its meaning written above."""
    axes.axvline(t, color="0.4", linewidth=1.0, linestyle=":")
    axes.annotate(
        text,
        (t, 1.0),
        xytext=(0, 4),
        xycoords=("data", "axes fraction"),
        textcoords="offset points",
        ha="center",
        fontsize=9,
        color="0.3",
    )


def rendered(figure: "Figure") -> dict[str, bytes]:
    """The file contents by suffix, without dates or names that change from run to run."""
    found = {}
    kinds = {"svg": {"Date": None, "Creator": None}, "png": {"Software": None}}
    with defaults({"svg.hashsalt": "rigidsym"}):
        for suffix, metadata in kinds.items():
            buffer = io.BytesIO()
            figure.savefig(buffer, format=suffix, dpi=150, metadata=metadata)
            found[suffix] = buffer.getvalue()
    return found
