"""Natural motions that a plan may choose from: rates and attitude of each, one under the other."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

import numpy as np

from rigidsym.view.labels import ATTITUDE, ATTITUDE_AXIS, RATES, RATES_AXIS, TIME_AXIS
from rigidsym.view.palette import AXES, SCALAR
from rigidsym.view.plots import figure as flat
from rigidsym.view.plots import histories
from rigidsym.view.protocols import Motion

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rigidsym.view.plots.figure import Figure

MOST = 6
"More rows cannot be read; the cheapest are shown."
_SAMPLES = 361


class Transfer(Protocol):
    """A motion that is followed for some time, at a cost."""

    @property
    def motion(self) -> Motion:
        """What it is a part of."""
        ...

    @property
    def duration(self) -> float:
        """From t = 0 on, s."""
        ...

    @property
    def cost(self) -> float:
        """Of both bursts, N m s."""
        ...


@histories.defaults()
def transfers(several: Sequence[Transfer]) -> "Figure":
    """A row for each of the first `MOST`: body rates, attitude; its cost above."""
    shown = several[:MOST]
    figure = flat.blank("drawing", 10.5, 0.9 + 2.1 * len(shown))
    grid = figure.subplots(len(shown), 2, sharex=True, sharey="col", squeeze=False)
    for k, (one, (rates, attitude)) in enumerate(zip(shown, grid, strict=True), 1):
        t = np.linspace(0, one.duration, _SAMPLES)
        q, omega = one.motion(t)
        _drawn(rates, t, omega, RATES, AXES)
        _drawn(attitude, t, q, ATTITUDE, (SCALAR, *AXES))
        rates.set_title(
            f"transfer {k}: {one.cost:.4g} N m s, {one.motion.regime}", loc="left", fontsize=10
        )
        rates.set_ylabel(RATES_AXIS, fontsize=9)
        attitude.set_ylabel(ATTITUDE_AXIS, fontsize=9)
    histories.legend(grid[0, 0])
    histories.legend(grid[0, 1])
    for axes in grid[-1]:
        axes.set_xlabel(TIME_AXIS)
    return figure


def _drawn(
    axes: "Axes",
    t: np.ndarray,
    values: np.ndarray,
    names: tuple[str, ...],
    colours: tuple[str, ...],
) -> None:
    histories.lines(axes, t, values, names, colours, linewidth=1.4)
    axes.margins(x=0.01)
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
