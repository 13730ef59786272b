"""The environment of a spacecraft in orbit, and its disturbance torques.

Torques are in N m, all vectors (3,) in body axes.  Sources: Markley and Crassidis, Fundamentals of
Spacecraft Attitude Determination and Control, section 3.3.6; Wertz, Spacecraft Attitude
Determination and Control, section 17.2; for the atmosphere Vallado, Fundamentals of Astrodynamics
and Applications, 4th edition, table 8-4 (CIRA-72 with an exospheric temperature of 1000 K from
500 km on).
"""

import math
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import _sky as sky
from rigidsym.manoeuvre.flight._rotation import cross, matrix
from rigidsym.manoeuvre.flight._settings import Flight, Triple
from rigidsym.splitting import Tide

GRID = 10.0
"Seconds between the times at which the field and the Sun are computed; splines between them."

# Base height (km), density there (kg/m^3), scale height (km).
LAYERS = (
    (0.0, 1.225, 7.249),
    (25.0, 3.899e-2, 6.349),
    (30.0, 1.774e-2, 6.682),
    (40.0, 3.972e-3, 7.554),
    (50.0, 1.057e-3, 8.382),
    (60.0, 3.206e-4, 7.714),
    (70.0, 8.770e-5, 6.549),
    (80.0, 1.905e-5, 5.799),
    (90.0, 3.396e-6, 5.382),
    (100.0, 5.297e-7, 5.877),
    (110.0, 9.661e-8, 7.263),
    (120.0, 2.438e-8, 9.473),
    (130.0, 8.484e-9, 12.636),
    (140.0, 3.845e-9, 16.149),
    (150.0, 2.070e-9, 22.523),
    (180.0, 5.464e-10, 29.740),
    (200.0, 2.789e-10, 37.105),
    (250.0, 7.248e-11, 45.546),
    (300.0, 2.418e-11, 53.628),
    (350.0, 9.518e-12, 53.298),
    (400.0, 3.725e-12, 58.515),
    (450.0, 1.585e-12, 60.828),
    (500.0, 6.967e-13, 63.822),
    (600.0, 1.454e-13, 71.835),
    (700.0, 3.614e-14, 88.667),
    (800.0, 1.170e-14, 124.64),
    (900.0, 5.245e-15, 181.05),
    (1000.0, 3.019e-15, 268.00),
)


def density(altitude: float) -> float:
    """Return the air density in kg/m^3 at an altitude in km.

    The altitude must be above zero.

    >>> density(600.0)
    1.454e-13
    """
    layer = bisect_right(LAYERS, altitude, key=lambda entry: entry[0]) - 1
    base, at_base, scale = LAYERS[max(layer, 0)]
    return at_base * math.exp((base - altitude) / scale)


class Box:
    """A box-shaped spacecraft of six flat panels.

    size: its edges along the body axes, m.  offset: its middle from the centre of mass, m.
    """

    def __init__(self, size: Triple, offset: Triple) -> None:
        x, y, z = size
        self._half = 0.5 * np.array(size)
        self._areas = np.array([y * z, z * x, x * y])
        self._offset = np.array(offset)

    def facing(self, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the three faces of the box that look towards a unit vector (3,).

        There is a row for each axis.

        These are their areas as seen from there (3,) in m^2, the cosines to their normals (3,), and
        the signs (3,) of these normals along the axes.
        """
        signs = np.where(direction >= 0, 1.0, -1.0)
        cosines = signs * direction
        return self._areas * cosines, cosines, signs

    def torque(self, forces: np.ndarray, signs: np.ndarray) -> np.ndarray:
        """Return the total torque of forces (3, 3) that act at the centres of three faces.

        The faces are given by their normals.
        """
        total = forces[0] + forces[1] + forces[2]
        arms = (signs * self._half)[:, None] * forces
        # The sum of e_k x (row k): the antisymmetric part.
        (_, xy, xz), (yx, _, yz), (zx, zy, _) = arms.tolist()
        return cross(self._offset, total) + np.array([yz - zy, zx - xz, xy - yx])


def dipole(moment: Triple, field: np.ndarray) -> np.ndarray:
    """Return the torque m x B on a dipole (A m^2) in a magnetic field (T)."""
    return cross(moment, field)


def drag(box: Box, wind: np.ndarray, air: float, coefficient: float) -> np.ndarray:
    """Return the torque of air drag on a box.

    The box has the velocity `wind` (m/s) through air of the given density (kg/m^3).

    Each face that meets the air feels -1/2 rho C |v| v times its area as the air sees it.  The
    spacecraft's own turning adds nothing that matters to the velocity of its faces.
    """
    speed = math.hypot(*wind)
    seen, _, signs = box.facing(wind / speed)
    pressure = -0.5 * air * coefficient * speed * wind
    return box.torque(np.outer(seen, pressure), signs)


def radiation(box: Box, sun: np.ndarray, lit: float, specular: float, diffuse: float) -> np.ndarray:
    """Return the torque of solar radiation pressure on a box.

    `sun` points to the Sun (m).

    lit: the visible share of the Sun.  Each face feels -P A cos ((1 - specular) s + 2 (specular cos
    + diffuse / 3) n), with s towards the Sun and n its normal (Markley and Crassidis, section
    3.3.6.4).
    """
    if lit == 0.0:
        return np.zeros(3)
    distance = math.hypot(*sun)
    pressure = lit * sky.SUNLIGHT * (sky.ASTRONOMICAL_UNIT / distance) ** 2
    direction = sun / distance
    seen, cosines, signs = box.facing(direction)
    normals = np.eye(3) * signs * 2 * (specular * cosines + diffuse / 3)
    forces = -pressure * seen[:, None] * ((1 - specular) * direction + normals)
    return box.torque(forces, signs)


@dataclass(frozen=True, slots=True)
class Surroundings:
    """The environment of a spacecraft at one time.

    Vectors (3,) are in body axes.
    """

    position: np.ndarray
    "From the Earth's middle, m."
    wind: np.ndarray
    "Velocity through the air that turns with the Earth, m/s."
    sun: np.ndarray
    "To the Sun, m."
    field: np.ndarray
    "Of the Earth, T."
    lit: float
    "The visible share of the Sun."


Torque = Callable[[Surroundings], np.ndarray]


class Environment:
    """Environment of a flight, with the disturbance torques that are switched on.

    `torques` has them by name.

    It is a torque for `rigidsym.integrate`, too, over the length of the flight.

    Parameters
    ----------
    flight : Flight
        Orbit, spacecraft, and which disturbances act.
    inertia : array (3,)
        Principal moments, kg m^2.
    begin : float
        First time of the flight, s.
    """

    def __init__(self, flight: Flight, inertia: np.ndarray, begin: float = 0.0) -> None:
        self._begin, self._end = begin, float(flight.run.length)
        self._path = sky.Path(flight.orbit)
        self._sky = _sky(flight, self._path, begin)
        self.torques = _torques(flight, inertia)

    def at(self, t: float, q: np.ndarray) -> Surroundings:
        """Return the environment at time t (s) of a spacecraft of attitude q (4,)."""
        position, velocity = self._path(t)
        sun, field = self._sky(t)
        x, y, _ = place = position.tolist()
        wind = velocity - sky.ROTATION * np.array([-y, x, 0.0])
        body = np.array([position, wind, sun - position, field]) @ matrix(q)
        return Surroundings(*body, sky.sunlit(place, sun.tolist()))

    def total(self, t: float, q: np.ndarray) -> np.ndarray:
        """Return the sum of all disturbance torques (3,) in body axes, in N m."""
        if not self.torques:
            return np.zeros(3)
        here = self.at(t, q)
        return np.sum([torque(here) for torque in self.torques.values()], axis=0)

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the sum of all disturbance torques at a time for one or more attitudes.

        Attitudes have the shape (..., 4), torques (..., 3).

        Raises InputError for a time outside of the flight, for which the sky was not computed.
        """
        if not self._begin <= t <= self._end:
            rule = f"must be of the flight, {self._begin:g} to {self._end:g} s"
            raise InputError("t", t, rule)
        found = [self.total(t, attitude) for attitude in q.reshape(-1, 4)]
        return np.reshape(found, omega.shape)

    def each(self, t: np.ndarray, q: np.ndarray) -> dict[str, np.ndarray]:
        """Return each disturbance torque by name along a flight.

        Torques have the shape (N, 3), times (N,), attitudes (N, 4).
        """
        places = [self.at(*state) for state in zip(t, q, strict=True)] if self.torques else []
        return {
            name: np.array([torque(place) for place in places])
            for name, torque in self.torques.items()
        }


def _sky(flight: Flight, path: sky.Path, begin: float) -> CubicSpline:
    """Return a spline of the Sun's position and the Earth's magnetic field over the flight.

    At a time in s, it has the inertial vectors (2, 3), in m and T.
    """
    count = max(4, int(np.ceil((float(flight.run.length) - begin) / GRID)) + 1)
    t = begin + GRID * np.arange(count)
    position = np.array([path(time)[0] for time in t.tolist()])
    sun = sky.sun_position(flight.orbit.epoch, t)
    field = np.zeros_like(position)
    if flight.disturbances.dipole:
        field = sky.magnetic_field(flight.orbit.epoch, t, position)
    return CubicSpline(t, np.stack([sun, field], axis=1))


def _torques(flight: Flight, inertia: np.ndarray) -> dict[str, Torque]:
    craft, on = flight.spacecraft, flight.disturbances
    box = Box(craft.size, craft.offset)
    air, tide = density(flight.orbit.altitude), Tide(sky.MU, inertia)
    known: dict[str, Torque] = {
        "drag": lambda here: drag(box, here.wind, air, craft.drag_coefficient),
        "gravity_gradient": lambda here: tide(here.position),
        "radiation": lambda here: radiation(box, here.sun, here.lit, craft.specular, craft.diffuse),
        "dipole": lambda here: dipole(craft.dipole, here.field),
    }
    return {name: torque for name, torque in known.items() if getattr(on, name)}
