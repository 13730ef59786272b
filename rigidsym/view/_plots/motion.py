"""Pictures of one motion: its rates, attitude and momentum sphere, and residuals of a fit."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._inputs import Times
from rigidsym.view._geometry import (
    REGIMES,
    SEPARATRIX,
    chosen,
    great_circles,
    moments,
    momentum,
    polhode,
    separatrix,
)
from rigidsym.view._plots.figure import blank, defaults, legend, lines, tidy
from rigidsym.view._style import (
    ATTITUDE,
    ATTITUDE_AXIS,
    AXES,
    MARK,
    MOMENTUM,
    RATES,
    RATES_AXIS,
    SCALAR,
    TIME_AXIS,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D

    from rigidsym.motion import TorqueFreeMotion

SAMPLES, AROUND = 801, 401
"Times of the lines, and points of the polhode."


def plot(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw omega(t), q(t), and the momentum on its sphere in body axes."""
    figure = blank("plot", 10.5, 5.2)
    t = chosen(motion, times, SAMPLES)
    q, omega = motion(t)
    layout = figure.add_gridspec(2, 2, width_ratios=(1.25, 1))
    rates = figure.add_subplot(layout[0, 0])
    attitude = figure.add_subplot(layout[1, 0], sharex=rates)
    _lines(rates, t, omega, RATES, RATES_AXIS, AXES)
    _lines(attitude, t, q, ATTITUDE, ATTITUDE_AXIS, (SCALAR, *AXES))
    rates.tick_params(labelbottom=False)
    attitude.set_xlabel(TIME_AXIS)
    attitude.set_ylim(-1.08, 1.08)
    _sphere(figure.add_subplot(layout[:, 1], projection="3d"), motion, omega)
    figure.suptitle(str(motion.regime), fontsize=11)
    return figure


def _lines(
    axes: "Axes",
    t: np.ndarray,
    values: np.ndarray,
    names: tuple[str, ...],
    label: str,
    colours: tuple[str, ...],
) -> None:
    lines(axes, t, values, names, colours, linewidth=1.4)
    axes.set_ylabel(label)
    axes.margins(x=0)
    tidy(axes)
    legend(axes)


def _sphere(axes: "Axes3D", motion: "TorqueFreeMotion", omega: np.ndarray) -> None:
    """Draw the sphere |M| = K with its circles, the separatrix and the polhode."""
    size = float(np.linalg.norm(momentum(motion)))
    # For a body at rest the axes are drawn alone, of unit length.
    radius = size or 1.0
    for circle in great_circles(radius):
        axes.plot(*circle.T, color="#8888", linewidth=0.6)
    for circle in separatrix(motion.exact["inertia"], radius) if size else []:
        (line,) = axes.plot(*circle.T, color=SEPARATRIX, linewidth=0.9, linestyle="--")
        line.set_label("separatrix")
    if size:
        _polhode(axes, motion, omega)
    _body_axes(axes, radius)
    _dress(axes, radius)
    axes.set_title(f"momentum sphere, body axes\n|M| = {size:.4g} kg m²/s", fontsize=10, y=1.06)


def _polhode(axes: "Axes3D", motion: "TorqueFreeMotion", omega: np.ndarray) -> None:
    """Draw the whole polhode thin, the part within the times thick, and its first point."""
    whole = moments(motion) * polhode(motion, AROUND)
    run = moments(motion) * omega
    colour = REGIMES[motion.regime]
    axes.plot(*whole.T, color=colour, linewidth=1.0, alpha=0.55)
    axes.plot(*run.T, color=colour, linewidth=2.0, label="polhode")
    axes.plot(*run[:1].T, "o", color=colour, markersize=5, label="first time")


def _body_axes(axes: "Axes3D", radius: float) -> None:
    for k, colour in enumerate(AXES):
        tip = np.eye(3)[k] * radius * 1.2
        axes.plot(*zip(np.zeros(3), tip, strict=True), color=colour, linewidth=1.2)
        axes.text(*(1.1 * tip), MOMENTUM[k], color=colour, ha="center", va="center")


def _dress(axes: "Axes3D", radius: float) -> None:
    axes.set_xlim(-radius, radius)
    axes.set_ylim(-radius, radius)
    axes.set_zlim(-radius, radius)
    axes.set_box_aspect((1, 1, 1), zoom=1.1)
    axes.view_init(elev=22, azim=38)
    axes.set_axis_off()
    handles, labels = axes.get_legend_handles_labels()
    named = dict(zip(labels, handles, strict=True))
    if not named:
        return
    axes.legend(named.values(), named, loc="lower center", ncols=3, frameon=False, fontsize=9)


@dataclass(frozen=True, slots=True)
class Residuals:
    """Times (N,), residuals (N, k) in units of their errors, and the indices of outliers."""

    title: str
    times: np.ndarray
    values: np.ndarray
    outliers: Sequence[int]


@defaults()
def residuals(panels: Sequence[Residuals]) -> "Figure":
    """Draw a panel for each set of observations: a dot for each number, a ring about outliers."""
    figure = blank("drawing", 8.0, 1.0 + 2.0 * len(panels))
    every = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(every, panels, strict=True):
        axes.axhspan(-1, 1, color="0.5", alpha=0.15, linewidth=0)
        for k, values in enumerate(panel.values.T):
            axes.plot(panel.times, values, "o", markersize=3.5, color=AXES[k % 3], label=str(k + 1))
        for index in panel.outliers:
            worst = np.argmax(np.abs(panel.values[index]))
            place = panel.times[index], panel.values[index, worst]
            axes.plot(*place, "o", markersize=11, fillstyle="none", color=MARK)
        axes.set_ylabel(f"{panel.title}\n(standard deviations)")
        tidy(axes)
        legend(axes)
    every[-1].set_xlabel(TIME_AXIS)
    return figure
