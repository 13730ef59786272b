"""How observations lie about the motion that fits them, as a matplotlib figure."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.view.labels import TIME_AXIS
from rigidsym.view.palette import AXES, MARK
from rigidsym.view.plots.figure import blank, defaults

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True)
class Panel:
    """Times (N,), residuals (N, k) in units of their errors, and which of them are outliers."""

    title: str
    times: np.ndarray
    residuals: np.ndarray
    outliers: Sequence[int]


@defaults()
def residuals(panels: Sequence[Panel]) -> "Figure":
    """A panel for each set of observations: a dot for each number, a ring about outliers."""
    figure = blank("drawing", 8.0, 1.0 + 2.0 * len(panels))
    every = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(every, panels, strict=True):
        axes.axhspan(-1, 1, color="0.5", alpha=0.15, linewidth=0)
        for k, values in enumerate(panel.residuals.T):
            axes.plot(panel.times, values, "o", markersize=3.5, color=AXES[k % 3], label=str(k + 1))
        for index in panel.outliers:
            worst = np.argmax(np.abs(panel.residuals[index]))
            place = panel.times[index], panel.residuals[index, worst]
            axes.plot(*place, "o", markersize=11, fillstyle="none", color=MARK)
        axes.set_ylabel(f"{panel.title}\n(standard deviations)")
        axes.grid(alpha=0.25)
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    every[-1].set_xlabel(TIME_AXIS)
    return figure
