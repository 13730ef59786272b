"""Pictures of a flight: attitude, control torques, disturbances."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.view.labels import ATTITUDE, ATTITUDE_AXIS, TORQUE
from rigidsym.view.palette import AXES, DISTURBANCES, SCALAR
from rigidsym.view.plots import histories
from rigidsym.view.protocols import Flight

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
def torques(run: Flight) -> "Figure":
    """What the wheels exert on the body, by axis."""
    figure, axes = histories.blank()
    names = TORQUE
    histories.lines(axes, run.t, 1e4 * run.torque, names, linewidth=1.4)
    axes.set_ylabel("control torques ($10^{-4}$ N m)")
    if np.max(np.abs(run.torque)) <= PAPER_TORQUE:
        axes.set_ylim(-5.2, 5.2)
        axes.set_yticks(range(-5, 6))
    return _finished(figure, axes, run)


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
    if axes.lines:
        histories.legend(axes)
    return figure
