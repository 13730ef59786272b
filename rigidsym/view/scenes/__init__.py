"""Pictures of motions: interactive ones in three dimensions by plotly, plots by matplotlib.

Both packages belong to the extra `lab`, and are imported when a picture is drawn.  All numbers
come from calls of `TorqueFreeMotion`; lengths and times are in SI units.
"""

from rigidsym.view.scenes.body import tumbling_body
from rigidsym.view.scenes.pair import sphere_and_body
from rigidsym.view.scenes.poinsot import rolling_ellipsoid
from rigidsym.view.scenes.sphere import momentum_sphere

__all__ = ["momentum_sphere", "rolling_ellipsoid", "sphere_and_body", "tumbling_body"]
