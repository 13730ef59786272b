"""Drawings that several notebooks share, by matplotlib.  They illustrate and prove nothing.

The curves are those of `rigidsym.view._geometry`; what is here is a flat drawing that can be drawn
upon.
"""

from typing import Any

import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym.view._geometry import members, moments, momentum, polhode, separatrix
from rigidsym.view.scenes._scene import ball

# Body axes (1, 2, 3) as the picture's (z, x, y): right-handed, with axis 1 upwards.
_TURNED = [1, 2, 0]
FAMILY, AROUND = 3, 241


def curve(axes: Any, points: Any, **style: Any) -> None:
    """A curve through points (N, 3) in body axes."""
    axes.plot(*np.asarray(points).T[_TURNED], **style)


def label(axes: Any, point: Any, text: str, **style: Any) -> None:
    """A text at a point in body axes."""
    axes.text(*np.asarray(point)[_TURNED], text, ha="center", **style)


def unit_sphere(figure: Any, place: Any) -> Any:
    """The sphere of directions with body axes, axis 1 upwards; for `curve` and `label`.

    `place` says where, as `add_subplot` takes it.
    """
    axes = figure.add_subplot(place, projection="3d")
    axes.set_box_aspect((1, 1, 1), zoom=1.45)
    axes.plot_surface(*np.moveaxis(ball(31, 61), 2, 0), color="0.9", alpha=0.35, lw=0, shade=False)
    for k, axis in enumerate(np.eye(3), start=1):
        curve(axes, [0 * axis, 1.35 * axis], color="0.3", lw=1)
        label(axes, 1.45 * axis, f"axis {k}", size=9)
    axes.view_init(18, 35)
    axes.set_axis_off()
    return axes


def momentum_sphere(figure: Any, place: Any, motion: TorqueFreeMotion) -> Any:
    """The unit sphere with polhodes of a body and, dashed, the separatrices."""
    axes = unit_sphere(figure, place)
    size = float(np.linalg.norm(momentum(motion)))
    for other in members(motion, size, FAMILY):
        curve(axes, moments(motion) * polhode(other, AROUND) / size, color="0.65", lw=0.7)
    for points in separatrix(motion.exact["inertia"], 1.0):
        curve(axes, points, color="C3", lw=1, ls="--")
    return axes
