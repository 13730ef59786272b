"""Pictures of flights and transfers: attitude, errors, rates, torques, wheels, disturbances."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.errors import require
from rigidsym.view._plots import figure as flat
from rigidsym.view._style import (
    ATTITUDE,
    ATTITUDE_AXIS,
    AXES,
    DISTURBANCES,
    MARK,
    RATES,
    RATES_AXIS,
    SCALAR,
    TIME_AXIS,
    TORQUE,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.manoeuvre.flight._run import Run

require("drawing", "matplotlib")

PAPER_TORQUE = 5e-4
"The greatest torque on the axes of the paper's Figure 3, N m."
MOST = 6
"Number of transfers that are drawn, the cheapest ones: more rows cannot be read."
_SAMPLES = 361

_SOURCES = {
    "drag": "air drag",
    "gravity_gradient": "gravity gradient",
    "radiation": "solar radiation",
    "dipole": "magnetic dipole",
}


@flat.defaults()
def attitude(run: "Run") -> "Figure":
    """Draw the quaternion of the natural motion, thin and dashed, and the one flown, thick."""
    figure, axes = flat.history()
    colours = (SCALAR, *AXES)
    names = tuple(f"{q} flown" for q in ATTITUDE)
    flat.lines(axes, run.t, run.q, names, colours, **flat.FLOWN)
    names = tuple(f"{q} natural" for q in ATTITUDE)
    flat.lines(axes, run.t, run.track.q, names, colours, **flat.WANTED)
    axes.set_ylabel(ATTITUDE_AXIS)
    axes.set_ylim(-1.05, 1.05)
    return _finished(figure, axes, run)


@flat.defaults()
def error(run: "Run") -> "Figure":
    """Draw the angle between the attitude flown and the reference."""
    figure, axes = flat.history()
    # Zero, as the first angle is, has no place on a logarithmic scale.
    angle = np.degrees(np.where(run.error > 0, run.error, np.nan))
    axes.semilogy(run.t, angle, color=MARK, linewidth=1.4)
    axes.set_ylabel("tracking error (degrees)")
    return _finished(figure, axes, run)


@flat.defaults()
def rates(run: "Run") -> "Figure":
    """Draw the rates of the reference, thin and dashed, and those flown, thick."""
    figure, axes = flat.history()
    names = tuple(f"{name} flown" for name in RATES)
    flat.lines(axes, run.t, run.omega, names, **flat.FLOWN)
    names = tuple(f"{name} wanted" for name in RATES)
    flat.lines(axes, run.t, run.reference.omega, names, **flat.WANTED)
    axes.set_ylabel(RATES_AXIS)
    return _finished(figure, axes, run)


@flat.defaults()
def torques(run: "Run") -> "Figure":
    """Draw the torques of the wheels on the body, by axis, and those of thrusters, dashed."""
    figure, axes = flat.history()
    flat.lines(axes, run.t, 1e4 * run.torque, TORQUE, linewidth=1.4)
    axes.set_ylabel("control torques ($10^{-4}$ N m)")
    if run.burns:
        # A torque of thrusters is constant between the ends of these pieces.
        pieces = run.burns.pieces(float(run.t[0]), float(run.t[-1]))
        burning = np.repeat([run.burns.between(*piece) for piece in pieces], 2, axis=0)
        names = tuple(f"{name} thrusters" for name in TORQUE)
        flat.lines(axes, np.ravel(pieces), 1e4 * burning, names, **flat.WANTED)
    elif np.max(np.abs(run.torque)) <= PAPER_TORQUE:
        axes.set_ylim(-5.2, 5.2)
        axes.set_yticks(range(-5, 6))
    return _finished(figure, axes, run)


@flat.defaults()
def wheels(run: "Run", rotor: float) -> "Figure":
    """Draw the momentum of each wheel, and its speed for a rotor of inertia `rotor`, kg m^2."""
    figure, axes = flat.history()
    names = tuple(f"wheel {k}" for k in (1, 2, 3))
    flat.lines(axes, run.t, 1e3 * run.wheel_momentum, names, linewidth=1.4)
    axes.set_ylabel("momentum of the wheels ($10^{-3}$ N m s)")
    turns = 1e-3 / rotor * 60 / (2 * np.pi)
    both = (lambda h: np.asarray(h) * turns, lambda n: np.asarray(n) / turns)
    speed = axes.secondary_yaxis("right", functions=both)
    speed.set_ylabel(f"speed (rpm) of a rotor of {rotor:g} kg m²")
    figure = _finished(figure, axes, run)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06), ncols=3, frameon=False)
    return figure


@flat.defaults()
def disturbances(run: "Run") -> "Figure":
    """Draw the size of each disturbing torque."""
    figure, axes = flat.history()
    for name, torque in run.disturbances.items():
        size = np.linalg.norm(torque, axis=1)
        # Zero, as of radiation in the shadow, has no place on a logarithmic scale.
        axes.semilogy(
            run.t, np.where(size > 0, size, np.nan), color=DISTURBANCES[name], label=_SOURCES[name]
        )
    axes.set_ylabel("size of the disturbing torques (N m)")
    return _finished(figure, axes, run)


def _finished(figure: "Figure", axes: "Axes", run: "Run") -> "Figure":
    if run.t[0] < run.arrival < run.t[-1]:
        flat.mark(axes, run.arrival, "target reached")
    if axes.get_legend_handles_labels()[1]:
        flat.legend(axes)
    return figure


@flat.defaults()
def transfers(several: Sequence["Transfer"]) -> "Figure":
    """Draw body rates and attitude of the first `MOST` transfers, a row each, its cost above."""
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
    flat.legend(grid[0, 0])
    flat.legend(grid[0, 1])
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
    flat.lines(axes, t, values, names, colours, linewidth=1.4)
    axes.margins(x=0.01)
    flat.tidy(axes)
