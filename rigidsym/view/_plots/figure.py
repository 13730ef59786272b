"""Figures of matplotlib, apart from pyplot and its state: made, drawn over time, and written.

Functions that make figures are decorated by `defaults()`, so that the user's matplotlibrc has no
effect.  `rendered` and `svg` write the same bytes on each run and on each processor.
"""

import io
import re
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypedDict, Unpack

import numpy as np

from rigidsym.errors import package
from rigidsym.view._style import AXES, TIME_AXIS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Figure
    from matplotlib.typing import RcKeyType

DECIMALS = 2
"Decimals of coordinates in an SVG; further digits depend on the processor."


class Style(TypedDict, total=False):
    """Style of a line: its width in points, and its dashes."""

    linewidth: float
    linestyle: tuple[int, tuple[int, int]]


FLOWN: Style = {"linewidth": 2.0}
WANTED: Style = {"linewidth": 1.0, "linestyle": (0, (5, 3))}


@contextmanager
def defaults(settings: Mapping["RcKeyType", object] | None = None) -> Generator[None]:
    """Draw with matplotlib's own settings and these, whatever the user's matplotlibrc says.

    Artists read some settings when they are made and others when they are drawn, so figures have
    to be made and saved inside.
    """
    import matplotlib

    # The backend does not affect what is drawn here, and once set it stays.
    own = {key: x for key, x in matplotlib.rcParamsDefault.items() if key != "backend"}
    with matplotlib.rc_context({**own, **(settings or {})}):
        yield


def blank(user: str, width: float, height: float) -> "Figure":
    """Return an empty figure of a size in inches.

    Raises ImportError in the name of `user` without matplotlib.
    """
    base = package("matplotlib.figure", user).Figure

    class Picture(base):
        """A figure that shows itself as PNG."""

        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            with defaults():
                self.savefig(buffer, format="png", dpi=130)
            return buffer.getvalue()

    with defaults():
        return Picture(figsize=(width, height), layout="constrained")


@defaults()
def history(height: float = 4.2) -> tuple["Figure", "Axes"]:
    """Return an empty figure and its axes over time."""
    figure = blank("drawing", 8.0, height)
    axes = figure.add_subplot()
    axes.set_xlabel(TIME_AXIS)
    # The margin keeps events at the first time apart from the axis.
    axes.margins(x=0.01)
    axes.locator_params(axis="x", nbins=10, steps=[1, 2, 5, 10])
    tidy(axes)
    return figure, axes


def tidy(axes: "Axes") -> None:
    """Give axes a faint grid, and no frame above and on the right."""
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def lines(
    axes: "Axes",
    t: np.ndarray,
    values: np.ndarray,
    labels: tuple[str, ...],
    colours: tuple[str, ...] = AXES,
    **style: Unpack[Style],
) -> None:
    """Draw a line for each column of values (N, k); the legend leaves out an empty label."""
    for column, label, colour in zip(values.T, labels, colours, strict=True):
        axes.plot(t, column, color=colour, label=label or None, **style)


def legend(axes: "Axes") -> None:
    """Add a legend beside the plot, where it hides nothing."""
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def mark(axes: "Axes", t: float, text: str) -> None:
    """Draw a dotted line at a time, with a text above."""
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
    """Return the contents of files by suffix: SVG and PNG."""
    buffer = io.BytesIO()
    with defaults():
        figure.savefig(buffer, format="png", dpi=150, metadata={"Software": None})
    return {"svg": svg(figure).encode(), "png": buffer.getvalue()}


def svg(figure: "Figure", settings: Mapping["RcKeyType", object] | None = None) -> str:
    """Return a figure as SVG, without dates, random names, or digits that a processor decides."""
    buffer = io.StringIO()
    with defaults({"svg.hashsalt": "rigidsym", **(settings or {})}):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    text = re.sub(
        r"-?\d+\.\d{3,}(?![\d.]|e)",
        lambda found: (
            f"{round(float(found[0]), DECIMALS) + 0.0:g}"
            if abs(float(found[0])) < 1e4
            else found[0]
        ),
        buffer.getvalue(),
    )
    # Names are hashes of coordinates before they were rounded.
    names = dict.fromkeys(re.findall(r'id="([a-zA-Z][0-9a-f]{10})"', text))
    for k, name in enumerate(names):
        text = text.replace(name, f"n{k}")
    return text
