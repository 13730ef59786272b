"""Interactive pictures of motions in three dimensions, by plotly.

plotly belongs to the extra `lab`, and is imported when a picture is drawn.  All numbers come from
calls of `TorqueFreeMotion`; lengths and times are in SI units.
"""

from rigidsym.view.scenes._body import sphere_and_body, tumbling_body
from rigidsym.view.scenes._poinsot import rolling_ellipsoid
from rigidsym.view.scenes._sphere import momentum_sphere

__all__ = ["momentum_sphere", "rolling_ellipsoid", "sphere_and_body", "tumbling_body"]
