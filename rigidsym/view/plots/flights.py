"""Pictures of a flight: attitude, control torques, disturbances."""

from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.view.plots import histories as drawing
from rigidsym.view.protocols import Flight

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PAPER_TORQUE = 5e-4
"The greatest torque on the axes of the paper's Figure 3, N m."

_SOURCES = {
    "drag": ("air drag", "#0072b2"),
    "gravity_gradient": ("gravity gradient", "#009e73"),
    "radiation": ("solar radiation", "#e69f00"),
    "dipole": ("magnetic dipole", "#cc79a7"),
}


@drawing.defaults()
def attitude(run: Flight) -> "Figure":
    """The natural motion's quaternion, thin and dashed, and the one flown, thick."""
    figure, axes = drawing.blank()
    colours = (drawing.SCALAR, *drawing.AXES)
    names = tuple(f"$q_{k}$ flown" for k in range(4))
    drawing.lines(axes, run.t, run.q, names, colours, **drawing.FLOWN)
    names = tuple(f"$q_{k}$ natural" for k in range(4))
    drawing.lines(axes, run.t, run.track.q, names, colours, **drawing.WANTED)
    axes.set_ylabel("attitude, body to inertial")
    axes.set_ylim(-1.05, 1.05)
    return _finished(figure, axes, run)


@drawing.defaults()
def torques(run: Flight) -> "Figure":
    """What the wheels exert on the body, by axis."""
    figure, axes = drawing.blank()
    names = tuple(f"$N_{{c{k}}}$" for k in (1, 2, 3))
    drawing.lines(axes, run.t, 1e4 * run.torque, names, linewidth=1.4)
    axes.set_ylabel("control torques ($10^{-4}$ N m)")
    if np.max(np.abs(run.torque)) <= PAPER_TORQUE:
        axes.set_ylim(-5.2, 5.2)
        axes.set_yticks(range(-5, 6))
    return _finished(figure, axes, run)


@drawing.defaults()
def disturbances(run: Flight) -> "Figure":
    """Size of each disturbing torque."""
    figure, axes = drawing.blank()
    for name, torque in run.disturbances.items():
        label, colour = _SOURCES[name]
        size = np.linalg.norm(torque, axis=1)
        # What is nought, as sunlight is in the shadow, has no place on this scale.
        axes.semilogy(run.t, np.where(size > 0, size, np.nan), color=colour, label=label)
    axes.set_ylabel("size of the disturbing torques (N m)")
    return _finished(figure, axes, run)


def _finished(figure: "Figure", axes: Any, run: Flight) -> "Figure":
    if run.t[0] < run.arrival < run.t[-1]:
        drawing.mark(axes, run.arrival, "target reached")
    if axes.lines:
        drawing.legend(axes)
    return figure
