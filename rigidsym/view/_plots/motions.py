"""Plots of motions, transfers and flights."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym._inputs import Times
from rigidsym.view import _geometry as geometry
from rigidsym.view import _style as style
from rigidsym.view._plots import figure as flat
from rigidsym.view._style import AXES, RATES, TORQUE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d import Axes3D

    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.manoeuvre.flight._run import Run
    from rigidsym.motion import TorqueFreeMotion

SAMPLES, AROUND = 801, 401
"Times of the lines, and points of the polhode."
MOST, TRANSFER_SAMPLES = 6, 361
"Number of transfers that are drawn, since more rows cannot be read, and times of each."
PAPER_TORQUE = 5e-4
"The greatest torque on the axes of the paper's Figure 3, N m."
_FOUR = (style.SCALAR, *AXES)
_SOURCES = {
    "drag": "air drag",
    "gravity_gradient": "gravity gradient",
    "radiation": "solar radiation",
    "dipole": "magnetic dipole",
}
_DASHED: dict[str, Any] = {"linewidth": 1.0, "linestyle": (0, (5, 3))}


def plot(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Plot the body rates, the attitude and the momentum sphere of a motion."""
    figure = flat.blank("plot", 10.5, 5.2)
    t = geometry.chosen(motion, times, SAMPLES)
    q, omega = motion(t)
    layout = figure.add_gridspec(2, 2, width_ratios=(1.25, 1))
    rates = figure.add_subplot(layout[0, 0])
    attitude = figure.add_subplot(layout[1, 0], sharex=rates)
    _state(rates, attitude, t, q, omega, 0.0)
    for axes in (rates, attitude):
        flat.legend(axes)
    rates.set_ylabel(style.RATES_AXIS)
    attitude.set_ylabel(style.ATTITUDE_AXIS)
    rates.tick_params(labelbottom=False)
    attitude.set_xlabel(style.TIME_AXIS)
    attitude.set_ylim(-1.08, 1.08)
    _sphere(figure.add_subplot(layout[:, 1], projection="3d"), motion, omega)
    figure.suptitle(str(motion.regime), fontsize=11)
    return figure


def _state(
    rates: "Axes", attitude: "Axes", t: np.ndarray, q: np.ndarray, omega: np.ndarray, margin: float
) -> None:
    """Plot body rates and attitude over time."""
    flat.lines(rates, t, omega, RATES)
    flat.lines(attitude, t, q, style.ATTITUDE, _FOUR)
    for axes in (rates, attitude):
        axes.margins(x=margin)
        flat.tidy(axes)


def _sphere(axes: "Axes3D", motion: "TorqueFreeMotion", omega: np.ndarray) -> None:
    """Draw the momentum sphere with the separatrix and the polhode of a motion.

    The polhode is thin, its part within the times thick, with a dot at the first time.  For a body
    at rest the axes are drawn alone, of unit length.
    """
    inertia = geometry.moments(motion)
    size = float(np.linalg.norm(geometry.momentum(motion)))
    radius = size or 1.0
    for circle in geometry.great_circles(radius):
        axes.plot(*circle.T, color="#8888", linewidth=0.6)
    if size:
        dashed = {"color": geometry.SEPARATRIX, "linewidth": 0.9, "linestyle": "--"}
        for circle in geometry.separatrix(motion.exact["inertia"], radius):
            axes.plot(*circle.T, label="separatrix", **dashed)
        whole, run = inertia * geometry.polhode(motion, AROUND), inertia * omega
        colour = geometry.REGIMES[motion.regime]
        axes.plot(*whole.T, color=colour, linewidth=1.0, alpha=0.55)
        axes.plot(*run.T, color=colour, linewidth=2.0, label="polhode")
        axes.plot(*run[:1].T, "o", color=colour, markersize=5, label="first time")
    for tip, name, colour in zip(1.2 * radius * np.eye(3), style.MOMENTUM, AXES, strict=True):
        axes.plot(*zip(np.zeros(3), tip, strict=True), color=colour, linewidth=1.2)
        axes.text(*(1.1 * tip), name, color=colour, ha="center", va="center")
    for limits in (axes.set_xlim, axes.set_ylim, axes.set_zlim):
        limits(-radius, radius)
    axes.set_box_aspect((1, 1, 1), zoom=1.1)
    axes.view_init(elev=22, azim=38)
    axes.set_axis_off()
    handles, labels = axes.get_legend_handles_labels()
    # Each label is listed once.
    if named := dict(zip(labels, handles, strict=True)):
        axes.legend(named.values(), named, loc="lower center", ncols=3, frameon=False, fontsize=9)
    axes.set_title(f"momentum sphere, body axes\n|M| = {size:.4g} kg m²/s", fontsize=10, y=1.06)


@flat.defaults()
def transfers(several: Sequence["Transfer"]) -> "Figure":
    """Plot body rates and attitude of several transfers, with a row for each.

    Only the first `MOST` transfers are drawn.
    """
    shown = several[:MOST]
    figure = flat.blank("drawing", 10.5, 0.9 + 2.1 * len(shown))
    grid = figure.subplots(len(shown), 2, sharex=True, sharey="col", squeeze=False)
    for k, (one, (rates, attitude)) in enumerate(zip(shown, grid, strict=True), 1):
        t = np.linspace(0, one.duration, TRANSFER_SAMPLES)
        _state(rates, attitude, t, *one.motion(t), 0.01)
        title = f"transfer {k}: {one.cost:.4g} N m s, {one.motion.regime}"
        rates.set_title(title, loc="left", fontsize=10)
        rates.set_ylabel(style.RATES_AXIS, fontsize=9)
        attitude.set_ylabel(style.ATTITUDE_AXIS, fontsize=9)
    for above, below in zip(grid[0], grid[-1], strict=True):
        flat.legend(above)
        below.set_xlabel(style.TIME_AXIS)
    return figure


@flat.defaults()
def attitude(run: "Run") -> "Figure":
    """Plot the attitude quaternions of a flight and of the torque-free motion that it follows.

    Those of the torque-free motion are dashed.
    """
    figure, axes = flat.history(style.ATTITUDE_AXIS)
    _both(axes, run.t, (run.q, run.track.q), style.ATTITUDE, "natural", _FOUR)
    axes.set_ylim(-1.05, 1.05)
    return _finished(figure, axes, run)


@flat.defaults()
def rates(run: "Run") -> "Figure":
    """Plot the body rates of a flight and of its reference.

    Those of the reference are dashed.
    """
    figure, axes = flat.history(style.RATES_AXIS)
    _both(axes, run.t, (run.omega, run.reference.omega), RATES, "wanted", AXES)
    return _finished(figure, axes, run)


def _both(
    axes: "Axes",
    t: np.ndarray,
    values: tuple[np.ndarray, np.ndarray],
    names: Sequence[str],
    other: str,
    colours: Sequence[str],
) -> None:
    """Plot a flight's values as solid lines, and the values it should follow as dashed lines."""
    flown, wanted = values
    flat.lines(axes, t, flown, [f"{x} flown" for x in names], colours, linewidth=2.0)
    flat.lines(axes, t, wanted, [f"{x} {other}" for x in names], colours, **_DASHED)


@flat.defaults()
def error(run: "Run") -> "Figure":
    """Plot the angle between the attitude of a flight and its reference over time."""
    figure, axes = flat.history("tracking error (degrees)")
    # Zero, as the first angle is, has no place on a logarithmic scale.
    angle = np.degrees(np.where(run.error > 0, run.error, np.nan))
    axes.semilogy(run.t, angle, color=style.MARK, linewidth=1.4)
    return _finished(figure, axes, run)


@flat.defaults()
def torques(run: "Run") -> "Figure":
    """Plot the torques of wheels and thrusters on the body during a flight.

    Those of the thrusters are dashed.
    """
    figure, axes = flat.history("control torques ($10^{-4}$ N m)")
    flat.lines(axes, run.t, 1e4 * run.torque, TORQUE)
    if run.burns:
        # A torque of thrusters is constant between the ends of these pieces.
        pieces = run.burns.pieces(float(run.t[0]), float(run.t[-1]))
        burning = np.repeat([run.burns.between(*piece) for piece in pieces], 2, axis=0)
        names = [f"{name} thrusters" for name in TORQUE]
        flat.lines(axes, np.ravel(pieces), 1e4 * burning, names, **_DASHED)
    elif np.max(np.abs(run.torque)) <= PAPER_TORQUE:
        axes.set_ylim(-5.2, 5.2)
        axes.set_yticks(range(-5, 6))
    return _finished(figure, axes, run)


@flat.defaults()
def wheels(run: "Run", rotor: float) -> "Figure":
    """Plot the angular momentum and the speed of each wheel during a flight.

    rotor: the inertia of a wheel's rotor, kg m^2.
    """
    figure, axes = flat.history("momentum of the wheels ($10^{-3}$ N m s)")
    flat.lines(axes, run.t, 1e3 * run.wheel_momentum, ("wheel 1", "wheel 2", "wheel 3"))
    turns = 1e-3 / rotor * 60 / (2 * np.pi)
    both = (lambda h: np.asarray(h) * turns, lambda n: np.asarray(n) / turns)
    speed = axes.secondary_yaxis("right", functions=both)
    speed.set_ylabel(f"speed (rpm) of a rotor of {rotor:g} kg m²")
    figure = _finished(figure, axes, run)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06), ncols=3, frameon=False)
    return figure


@flat.defaults()
def disturbances(run: "Run") -> "Figure":
    """Plot the magnitude of each disturbing torque during a flight."""
    figure, axes = flat.history("size of the disturbing torques (N m)")
    for name, torque in run.disturbances.items():
        size = np.linalg.norm(torque, axis=1)
        # Zero, as of radiation in the shadow, has no place on a logarithmic scale.
        known = np.where(size > 0, size, np.nan)
        axes.semilogy(run.t, known, color=style.DISTURBANCES[name], label=_SOURCES[name])
    return _finished(figure, axes, run)


def _finished(figure: "Figure", axes: "Axes", run: "Run") -> "Figure":
    """Add the time of arrival and a legend to a plot of a flight."""
    if run.t[0] < run.arrival < run.t[-1]:
        axes.axvline(run.arrival, color="0.4", linewidth=1.0, linestyle=":")
        axes.annotate(
            "target reached",
            (run.arrival, 1.0),
            xytext=(0, 4),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
            ha="center",
            fontsize=9,
            color="0.3",
        )
    if axes.get_legend_handles_labels()[1]:
        flat.legend(axes)
    return figure
