"""A spacecraft that follows a torque-free motion in closed loop, with disturbances.

Conventions are those of the project: quaternions scalar first, body to inertial; vectors of the
spacecraft in its body axes; SI units.  The inertial frame is the geocentric celestial one (its
third axis is the Earth's, to a tenth of a degree).
"""

from rigidsym.errors import require

require("flying a manoeuvre", "scipy", "erfa", "ppigrf", "pydantic")

from rigidsym.manoeuvre.flight._environment import Environment  # noqa: E402
from rigidsym.manoeuvre.flight._fly import fly  # noqa: E402
from rigidsym.manoeuvre.flight._run import Run  # noqa: E402
from rigidsym.manoeuvre.flight._settings import Flight, read  # noqa: E402

__all__ = ["Environment", "Flight", "Run", "fly", "read"]
