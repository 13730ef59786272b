"""Rates, attitude and momentum sphere of one motion, as a matplotlib figure."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.inputs import Times
from rigidsym.solution.polhode import Regime
from rigidsym.view.geometry import (
    great_circles,
    moments,
    momentum,
    polhode,
    separatrix,
)
from rigidsym.view.labels import ATTITUDE, ATTITUDE_AXIS, MOMENTUM, RATES, RATES_AXIS, TIME_AXIS
from rigidsym.view.palette import AXES, SCALAR
from rigidsym.view.plots.figure import blank
from rigidsym.view.protocols import Motion
from rigidsym.view.regimes import REGIMES
from rigidsym.view.times import chosen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D


SAMPLES = 801
AROUND = 401
SEPARATRIX = REGIMES[Regime.SEPARATRIX]


def plot(motion: Motion, times: Times | None = None) -> "Figure":
    """Three plots: omega(t), q(t), and the momentum on its sphere in body axes."""
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
    for column, name, colour in zip(values.T, names, colours, strict=True):
        axes.plot(t, column, color=colour, linewidth=1.4, label=name)
    axes.set_ylabel(label)
    axes.margins(x=0)
    axes.grid(alpha=0.25)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)


def _sphere(axes: "Axes3D", motion: Motion, omega: np.ndarray) -> None:
    """The sphere |M| = K with its circles, the separatrix, the polhode, and what of it is run."""
    size = float(np.linalg.norm(momentum(motion)))
    # A body at rest has no such sphere: one of unit radius carries the axes.
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


def _polhode(axes: "Axes3D", motion: Motion, omega: np.ndarray) -> None:
    """All of the polhode thin, what is run through of it thick, and where that begins."""
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
