"""Pictures of a flight: attitude, errors, rates, torques, wheels, disturbances."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.view.labels import ATTITUDE, ATTITUDE_AXIS, RATES, RATES_AXIS, TORQUE
from rigidsym.view.palette import AXES, DISTURBANCES, MARK, SCALAR
from rigidsym.view.plots import histories
from rigidsym.view.protocols import Burns, Flight

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PAPER_TORQUE = 5e-4
"The greatest torque on the axes of the paper's Figure 3, N m."

_SOURCES = {
    "drag": "air drag",
    "gravity_gradient": "gravity gradient",
    "radiation": "solar radiation",
    "dipole": "magnetic dipole",
}


@histories.defaults()
def attitude(run: Flight) -> "Figure":
    """The natural motion's quaternion, thin and dashed, and the one flown, thick."""
    figure, axes = histories.blank()
    colours = (SCALAR, *AXES)
    names = tuple(f"{q} flown" for q in ATTITUDE)
    histories.lines(axes, run.t, run.q, names, colours, **histories.FLOWN)
    names = tuple(f"{q} natural" for q in ATTITUDE)
    histories.lines(axes, run.t, run.track.q, names, colours, **histories.WANTED)
    axes.set_ylabel(ATTITUDE_AXIS)
    axes.set_ylim(-1.05, 1.05)
    return _finished(figure, axes, run)


@histories.defaults()
def error(run: Flight) -> "Figure":
    """The angle from what was to be followed."""
    figure, axes = histories.blank()
    # What is nought, as the first one is, has no place on this scale.
    angle = np.degrees(np.where(run.error > 0, run.error, np.nan))
    axes.semilogy(run.t, angle, color=MARK, linewidth=1.4)
    axes.set_ylabel("tracking error (degrees)")
    return _finished(figure, axes, run)


@histories.defaults()
def rates(run: Flight) -> "Figure":
    """Those of what was to be followed, thin and dashed, and those flown, thick."""
    figure, axes = histories.blank()
    names = tuple(f"{name} flown" for name in RATES)
    histories.lines(axes, run.t, run.omega, names, **histories.FLOWN)
    names = tuple(f"{name} wanted" for name in RATES)
    histories.lines(axes, run.t, run.reference.omega, names, **histories.WANTED)
    axes.set_ylabel(RATES_AXIS)
    return _finished(figure, axes, run)


@histories.defaults()
def torques(run: Flight) -> "Figure":
    """What the wheels exert on the body, by axis; dashed, what thrusters do."""
    figure, axes = histories.blank()
    histories.lines(axes, run.t, 1e4 * run.torque, TORQUE, linewidth=1.4)
    axes.set_ylabel("control torques ($10^{-4}$ N m)")
    if run.burns:
        t, burning = _burning(run.burns, run.t)
        names = tuple(f"{name} thrusters" for name in TORQUE)
        histories.lines(axes, t, 1e4 * burning, names, **histories.WANTED)
    elif np.max(np.abs(run.torque)) <= PAPER_TORQUE:
        axes.set_ylim(-5.2, 5.2)
        axes.set_yticks(range(-5, 6))
    return _finished(figure, axes, run)


def _burning(burns: Burns, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Corners of the torques of thrusters: times (M,), torques (M, 3)."""
    pieces = burns.pieces(float(t[0]), float(t[-1]))
    torque = np.array([burns.between(*piece) for piece in pieces])
    return np.ravel(pieces), np.repeat(torque, 2, axis=0)


@histories.defaults()
def wheels(run: Flight, rotor: float) -> "Figure":
    """What each wheel stores, and how fast one of an inertia `rotor` (kg m^2) turns."""
    figure, axes = histories.blank()
    names = tuple(f"wheel {k}" for k in (1, 2, 3))
    histories.lines(axes, run.t, 1e3 * run.wheel_momentum, names, linewidth=1.4)
    axes.set_ylabel("momentum of the wheels ($10^{-3}$ N m s)")
    turns = 1e-3 / rotor * 60 / (2 * np.pi)
    both = (lambda h: np.asarray(h) * turns, lambda n: np.asarray(n) / turns)
    speed = axes.secondary_yaxis("right", functions=both)
    speed.set_ylabel(f"speed (rpm) of a rotor of {rotor:g} kg m²")
    figure = _finished(figure, axes, run)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.06), ncols=3, frameon=False)
    return figure


@histories.defaults()
def disturbances(run: Flight) -> "Figure":
    """Size of each disturbing torque."""
    figure, axes = histories.blank()
    for name, torque in run.disturbances.items():
        size = np.linalg.norm(torque, axis=1)
        # What is nought, as sunlight is in the shadow, has no place on this scale.
        axes.semilogy(
            run.t, np.where(size > 0, size, np.nan), color=DISTURBANCES[name], label=_SOURCES[name]
        )
    axes.set_ylabel("size of the disturbing torques (N m)")
    return _finished(figure, axes, run)


def _finished(figure: "Figure", axes: "Axes", run: Flight) -> "Figure":
    if run.t[0] < run.arrival < run.t[-1]:
        histories.mark(axes, run.arrival, "target reached")
    if axes.get_legend_handles_labels()[1]:
        histories.legend(axes)
    return figure
