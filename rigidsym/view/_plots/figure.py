"""Functions that create, style and save matplotlib figures without pyplot.

Functions that make figures are decorated by `defaults()`, so that the user's matplotlibrc has no
effect.  `rendered` and `svg` write the same bytes on each run and on each processor.
"""

import io
import re
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.errors import package
from rigidsym.view._style import AXES, TIME_AXIS

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Figure
    from matplotlib.typing import RcKeyType

DECIMALS = 2
"Decimals of coordinates in an SVG; further digits depend on the processor."


@contextmanager
def defaults(settings: Mapping["RcKeyType", object] | None = None) -> Generator[None]:
    """Draw with matplotlib's default settings instead of the user's matplotlibrc.

    settings: changes of the defaults.  Artists read some settings when they are made and others
    when they are drawn, so figures have to be made and saved inside.
    """
    import matplotlib

    # The backend does not affect what is drawn here, and once set it stays.
    own = {key: x for key, x in matplotlib.rcParamsDefault.items() if key != "backend"}
    with matplotlib.rc_context({**own, **(settings or {})}):
        yield


def blank(user: str, width: float, height: float) -> "Figure":
    """Return an empty figure with a given size in inches.

    Raises ImportError in the name of `user` without matplotlib.
    """
    base = package("matplotlib.figure", user).Figure

    class Picture(base):
        """Matplotlib figure that a notebook displays as PNG."""

        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            with defaults():
                self.savefig(buffer, format="png", dpi=130)
            return buffer.getvalue()

    with defaults():
        return Picture(figsize=(width, height), layout="constrained")


@defaults()
def history(label: str) -> tuple["Figure", "Axes"]:
    """Return an empty figure and its axes for a plot over time.

    label: that of the axis of values.
    """
    figure = blank("drawing", 8.0, 4.2)
    axes = figure.add_subplot()
    axes.set_xlabel(TIME_AXIS)
    axes.set_ylabel(label)
    # The margin keeps events at the first time apart from the axis.
    axes.margins(x=0.01)
    axes.locator_params(axis="x", nbins=10, steps=[1, 2, 5, 10])
    tidy(axes)
    return figure, axes


def tidy(axes: "Axes") -> None:
    """Add a faint grid to axes, and remove the frame above and on the right."""
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)


def lines(
    axes: "Axes",
    t: np.ndarray,
    values: np.ndarray,
    labels: Sequence[str],
    colours: Sequence[str] = AXES,
    linewidth: float = 1.4,
    **style: Any,
) -> None:
    """Plot each column of an array as a line over time.

    The shape of values is (N, k).  Lines with no label are not in the legend.
    """
    for column, label, colour in zip(values.T, labels, colours, strict=True):
        axes.plot(t, column, color=colour, label=label or None, linewidth=linewidth, **style)


def legend(axes: "Axes") -> None:
    """Add a legend to the right of the plot."""
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def rendered(figure: "Figure") -> dict[str, bytes]:
    """Return the contents of a figure's SVG and PNG files, by suffix."""
    buffer = io.BytesIO()
    with defaults():
        figure.savefig(buffer, format="png", dpi=150, metadata={"Software": None})
    return {"svg": svg(figure).encode(), "png": buffer.getvalue()}


def files(figures: Mapping[str, "Figure"]) -> dict[str, bytes]:
    """Return the contents of the SVG and PNG files of several figures, by file name."""
    return {
        f"{name}.{suffix}": data
        for name, figure in figures.items()
        for suffix, data in rendered(figure).items()
    }


def svg(figure: "Figure", settings: Mapping["RcKeyType", object] | None = None) -> str:
    """Convert a figure to SVG with the same bytes on every run and processor."""
    buffer = io.StringIO()
    with defaults({"svg.hashsalt": "rigidsym", **(settings or {})}):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})

    def short(found: re.Match[str]) -> str:
        value = float(found[0])
        return f"{round(value, DECIMALS) + 0.0:g}" if abs(value) < 1e4 else found[0]

    # The size of letters is 1/64 of a unit of their outlines, which rounding would change.
    text = re.sub(r"(?<!scale\()-?\d+\.\d{3,}(?![\d.]|e)", short, buffer.getvalue())
    # Names are hashes of coordinates before they were rounded.
    names = dict.fromkeys(re.findall(r'id="([a-zA-Z][0-9a-f]{10})"', text))
    for k, name in enumerate(names):
        text = text.replace(name, f"n{k}")
    return text
