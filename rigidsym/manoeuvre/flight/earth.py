"""Numbers of the Earth and the Sun, and the orbit around the one in the light of the other.

Sources: WGS 84 (mu, radius, rotation); IAU 2012 and 2015 resolutions (astronomical unit, radius and
irradiance of the Sun).
"""

import math
from collections.abc import Sequence

import numpy as np

from rigidsym.manoeuvre.flight.settings import Orbit

MU = 3.986004418e14
"Gravitational parameter of the Earth, m^3/s^2."
RADIUS = 6378137.0
"Of the Earth, taken as a sphere of its equator's radius, m."
ROTATION = 7.292115e-5
"Of the Earth about its axis, rad/s."
ASTRONOMICAL_UNIT = 149597870700.0
SUN_RADIUS = 6.957e8
SUNLIGHT = 1361.0 / 299792458.0
"Pressure of sunlight on what absorbs it, at one astronomical unit, N/m^2."


class Path:
    """Position and velocity on a circular orbit of Kepler, inertial."""

    def __init__(self, orbit: Orbit) -> None:
        node, tilt, self._start = np.radians(
            [orbit.node, orbit.inclination, orbit.latitude_argument]
        )
        self.radius = RADIUS + 1e3 * orbit.altitude
        "From the Earth's middle, m."
        self.mean_motion = math.sqrt(MU / self.radius**3)
        "rad/s."
        ascending = [np.cos(node), np.sin(node), 0.0]
        highest = [-np.sin(node) * np.cos(tilt), np.cos(node) * np.cos(tilt), np.sin(tilt)]
        self._ascending = self.radius * np.array(ascending)
        self._highest = self.radius * np.array(highest)

    def __call__(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Position (m) and velocity (m/s), (3,) each, at a time in s."""
        along = self._start + self.mean_motion * t
        cosine, sine = math.cos(along), math.sin(along)
        position = cosine * self._ascending + sine * self._highest
        return position, self.mean_motion * (cosine * self._highest - sine * self._ascending)


def sunlit(position: Sequence[float], sun: Sequence[float]) -> float:
    """Share of the Sun's disc that the Earth leaves visible: a conical shadow.

    position, sun: (3,) from the Earth's middle, m.  Montenbruck and Gill, Satellite Orbits,
    section 3.4.2: a, b are the apparent radii of Sun and Earth, c is what parts their middles.
    """
    away = [s - p for s, p in zip(sun, position, strict=True)]
    distance, radius = math.hypot(*away), math.hypot(*position)
    cosine = -sum(p * s for p, s in zip(position, away, strict=True)) / (distance * radius)
    # Close to the surface the position may be rounded to below it.
    a, b = math.asin(SUN_RADIUS / distance), math.asin(min(1.0, RADIUS / radius))
    c = _arccos(cosine)
    if c >= a + b:
        return 1.0
    if c <= abs(a - b):
        return 0.0 if a <= b else 1 - (b / a) ** 2
    x = (c**2 + a**2 - b**2) / (2 * c)
    y = math.sqrt(max(a**2 - x**2, 0.0))
    hidden = a**2 * _arccos(x / a) + b**2 * _arccos((c - x) / b) - c * y
    return 1 - hidden / (math.pi * a**2)


def _arccos(x: float) -> float:
    return math.acos(max(-1.0, min(1.0, x)))
