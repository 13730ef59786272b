"""The torques that disturb a spacecraft in a low orbit, N m, all vectors (3,) in body axes.

Sources: Markley and Crassidis, Fundamentals of Spacecraft Attitude Determination and Control,
section 3.3.6; Wertz, Spacecraft Attitude Determination and Control, section 17.2.
"""

import math

import numpy as np

from rigidsym.manoeuvre.flight.box import Box
from rigidsym.manoeuvre.flight.earth import ASTRONOMICAL_UNIT, SUNLIGHT
from rigidsym.manoeuvre.flight.rotation import cross
from rigidsym.manoeuvre.flight.settings import Triple


def dipole(moment: Triple, field: np.ndarray) -> np.ndarray:
    """m x B of a dipole (A m^2) in a field (T)."""
    return cross(moment, field)


def drag(box: Box, wind: np.ndarray, air: float, coefficient: float) -> np.ndarray:
    """Of a box that moves with velocity `wind` (m/s) through air of a density (kg/m^3).

    Each face that meets the air feels -1/2 rho C |v| v times its area as the air sees it.  The
    spacecraft's own turning adds nothing that matters to the velocity of its faces.
    """
    speed = math.hypot(*wind)
    seen, _, signs = box.facing(wind / speed)
    pressure = -0.5 * air * coefficient * speed * wind
    return box.torque(np.outer(seen, pressure), signs)


def radiation(box: Box, sun: np.ndarray, lit: float, specular: float, diffuse: float) -> np.ndarray:
    """Of sunlight on a box, from where `sun` (m) points; `lit` is the share of the Sun seen.

    Each face feels -P A cos (  (1 - specular) s + 2 (specular cos + diffuse / 3) n  ) with s
    towards the Sun and n its normal (Markley and Crassidis, section 3.3.6.4).
    """
    if lit == 0.0:
        return np.zeros(3)
    distance = math.hypot(*sun)
    pressure = lit * SUNLIGHT * (ASTRONOMICAL_UNIT / distance) ** 2
    direction = sun / distance
    seen, cosines, signs = box.facing(direction)
    normals = np.eye(3) * signs * 2 * (specular * cosines + diffuse / 3)
    forces = -pressure * seen[:, None] * ((1 - specular) * direction + normals)
    return box.torque(forces, signs)
