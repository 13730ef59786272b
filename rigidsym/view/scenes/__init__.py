"""Interactive three-dimensional pictures of motions, drawn by plotly.

plotly belongs to the extra `lab`, and is imported when a picture is drawn.  All numbers come from
calls of `TorqueFreeMotion`; lengths and times are in SI units.
"""

from rigidsym.view.scenes._pictures import (
    momentum_sphere,
    rolling_ellipsoid,
    sphere_and_body,
    tumbling_body,
)

__all__ = ["momentum_sphere", "rolling_ellipsoid", "sphere_and_body", "tumbling_body"]
