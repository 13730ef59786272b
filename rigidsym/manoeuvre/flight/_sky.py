"""Models of the orbit, the Sun, the rotating Earth and its magnetic field.

Sources of constants: WGS 84 (mu, radius, rotation); IAU 2012 and 2015 resolutions (astronomical
unit, radius and irradiance of the Sun).
"""

import math
import warnings
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from datetime import datetime

import erfa
import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight._settings import Orbit
from rigidsym.splitting import KeplerOrbit

DAY = 86400.0
MU = 3.986004418e14
"Gravitational parameter of the Earth, m^3/s^2."
RADIUS = 6378137.0
"Radius of the Earth, taken as a sphere of its equator's radius, m."
ROTATION = 7.292115e-5
"Rate of the Earth about its axis, rad/s."
ASTRONOMICAL_UNIT = 149597870700.0
SUN_RADIUS = 6.957e8
SUNLIGHT = 1361.0 / 299792458.0
"Pressure of sunlight on what absorbs it, at one astronomical unit, N/m^2."


class Path:
    """A circular Kepler orbit in inertial axes."""

    def __init__(self, orbit: Orbit) -> None:
        node, tilt, self._start = (
            math.radians(x) for x in (orbit.node, orbit.inclination, orbit.latitude_argument)
        )
        self.radius = RADIUS + 1e3 * orbit.altitude
        "From the Earth's middle, m."
        circle = KeplerOrbit(MU, self.radius, inclination=tilt, node=node)
        self.mean_motion = circle.mean_motion
        "rad/s."
        self._ascending, self._highest = (self.radius * axis for axis in circle.axes)

    def __call__(self, t: float) -> tuple[np.ndarray, np.ndarray]:
        """Return the position (m) and velocity (m/s) at a time in s."""
        along = self._start + self.mean_motion * t
        cosine, sine = math.cos(along), math.sin(along)
        position = cosine * self._ascending + sine * self._highest
        return position, self.mean_motion * (cosine * self._highest - sine * self._ascending)


def sunlit(position: Sequence[float], sun: Sequence[float]) -> float:
    """Return the visible share of the Sun's disc outside of the Earth's conical shadow.

    position, sun: (3,) from the Earth's middle, m.  Montenbruck and Gill, Satellite Orbits,
    section 3.4.2: a, b are the apparent radii of Sun and Earth, c the angle between their middles.
    """
    away = [s - p for s, p in zip(sun, position, strict=True)]
    distance, radius = math.hypot(*away), math.hypot(*position)
    cosine = -sum(p * s for p, s in zip(position, away, strict=True)) / (distance * radius)
    # Close to the surface rounding may bring the position below it.
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


def terrestrial_time(epoch: datetime, t: np.ndarray) -> tuple[float, np.ndarray]:
    """Return two-part Julian dates in terrestrial time (TT) for times after an epoch.

    Times t (N,) are in s; the epoch is in UTC.
    """
    with _unwarned():
        first, second = erfa.utctai(*_utc(epoch))
    return erfa.taitt(first, second + np.asarray(t) / DAY)


def _utc(epoch: datetime) -> tuple[float, float]:
    seconds = epoch.second + 1e-6 * epoch.microsecond
    date = (epoch.year, epoch.month, epoch.day, epoch.hour, epoch.minute, seconds)
    with _unwarned():
        return erfa.dtf2d("UTC", *date)


@contextmanager
def _unwarned() -> Generator[None]:
    """Silence warnings about dates for which leap seconds or the Sun are uncertain."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", erfa.ErfaWarning)
        yield


def sun_position(epoch: datetime, t: np.ndarray) -> np.ndarray:
    """Return geocentric positions of the Sun in inertial axes.

    Positions (N, 3) are in m, times t (N,) in s.

    The aberration of its light, 20 arc seconds, is left out.
    """
    with _unwarned():
        heliocentric, _ = erfa.epv00(*terrestrial_time(epoch, t))
    return -ASTRONOMICAL_UNIT * heliocentric["p"]


def earth_turn(epoch: datetime, t: np.ndarray) -> np.ndarray:
    """Return the rotation matrices (N, 3, 3) from inertial to Earth-fixed axes.

    They are of precession, nutation and the Earth's angle.  UT1 is taken as UTC (15 arc seconds at
    most) and the polar motion (half of one) as none.
    """
    whole, part = _utc(epoch)
    universal = (whole, part + np.asarray(t) / DAY)
    return erfa.c2t06a(*terrestrial_time(epoch, t), *universal, 0.0, 0.0)


def magnetic_field(epoch: datetime, t: np.ndarray, position: np.ndarray) -> np.ndarray:
    """Return the Earth's magnetic field by the IGRF model, in inertial axes.

    Fields (N, 3) are in T, inertial positions (N, 3) in m.

    Raises InputError for an epoch that the field's coefficients do not cover.
    """
    import ppigrf

    instant = epoch.replace(tzinfo=None)
    covered = ppigrf.ppigrf.read_shc()[0].index
    if not covered[0] <= instant <= covered[-1]:
        years = f"from {covered[0].year} to {covered[-1].year}"
        raise InputError("orbit.epoch", epoch.isoformat(), f"the Earth's field is known {years}")
    turn = earth_turn(epoch, t)
    fixed = np.einsum("nij,nj->ni", turn, position)
    radius = np.linalg.norm(fixed, axis=1)
    colatitude = np.arccos(fixed[:, 2] / radius)
    longitude = np.arctan2(fixed[:, 1], fixed[:, 0])
    parts = ppigrf.igrf_gc(radius / 1e3, np.degrees(colatitude), np.degrees(longitude), instant)
    local = 1e-9 * np.stack([part[0] for part in parts], axis=1)
    axes = _local_axes(colatitude, longitude)
    return np.einsum("nji,nj->ni", turn, np.einsum("nkj,nk->nj", axes, local))


def _local_axes(colatitude: np.ndarray, longitude: np.ndarray) -> np.ndarray:
    """Return unit vectors upwards, southwards and eastwards in Earth-fixed axes.

    They are the rows of matrices (N, 3, 3).
    """
    c, s = np.cos(colatitude), np.sin(colatitude)
    cosine, sine, none = np.cos(longitude), np.sin(longitude), np.zeros_like(longitude)
    rows = ((s * cosine, s * sine, c), (c * cosine, c * sine, -s), (-sine, cosine, none))
    return np.moveaxis(np.array(rows), -1, 0)
