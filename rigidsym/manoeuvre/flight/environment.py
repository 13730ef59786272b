"""What surrounds the spacecraft along its orbit, and the torques that this makes."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import earth, sky, torques
from rigidsym.manoeuvre.flight.atmosphere import density
from rigidsym.manoeuvre.flight.box import Box
from rigidsym.manoeuvre.flight.rotation import matrix
from rigidsym.manoeuvre.flight.settings import Flight
from rigidsym.splitting import Tide

GRID = 10.0
"Seconds between the places at which the field and the Sun are computed; splines between them."


@dataclass(frozen=True, slots=True)
class Surroundings:
    """At one time: vectors (3,) in body axes."""

    position: np.ndarray
    "From the Earth's middle, m."
    wind: np.ndarray
    "Velocity through the air that turns with the Earth, m/s."
    sun: np.ndarray
    "To the Sun, m."
    field: np.ndarray
    "Of the Earth, T."
    lit: float
    "Share of the Sun that is seen."


Torque = Callable[[Surroundings], np.ndarray]


class Environment:
    """The disturbances of a flight from `begin` (s) on that are switched on, as torques by name.

    It is a torque for `rigidsym.integrate`, too, over the length of the flight.
    """

    def __init__(self, flight: Flight, inertia: np.ndarray, begin: float = 0.0) -> None:
        self._begin, self._end = begin, float(flight.run.length)
        self._path = earth.Path(flight.orbit)
        self._sky = _sky(flight, self._path, begin)
        self.torques = _torques(flight, inertia)

    def at(self, t: float, q: np.ndarray) -> Surroundings:
        """At time t (s) for a spacecraft of attitude q (4,)."""
        position, velocity = self._path(t)
        sun, field = self._sky(t)
        x, y, _ = place = position.tolist()
        wind = velocity - earth.ROTATION * np.array([-y, x, 0.0])
        body = np.array([position, wind, sun - position, field]) @ matrix(q)
        return Surroundings(*body, earth.sunlit(place, sun.tolist()))

    def total(self, t: float, q: np.ndarray) -> np.ndarray:
        """The sum of the torques (3,), N m, in body axes."""
        if not self.torques:
            return np.zeros(3)
        here = self.at(t, q)
        return np.sum([torque(here) for torque in self.torques.values()], axis=0)

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """The sum of the torques on spacecraft of attitudes q (..., 4) at a time (s): (..., 3).

        Raises InputError for a time outside of the flight, where nothing is known of the sky.
        """
        if not self._begin <= t <= self._end:
            rule = f"must be of the flight, {self._begin:g} to {self._end:g} s"
            raise InputError("t", t, rule)
        found = [self.total(t, attitude) for attitude in q.reshape(-1, 4)]
        return np.reshape(found, omega.shape)

    def each(self, t: np.ndarray, q: np.ndarray) -> dict[str, np.ndarray]:
        """Every torque (N, 3) by name along times (N,) and attitudes (N, 4)."""
        places = [self.at(*state) for state in zip(t, q, strict=True)] if self.torques else []
        return {
            name: np.array([torque(place) for place in places])
            for name, torque in self.torques.items()
        }


def _sky(flight: Flight, path: earth.Path, begin: float) -> CubicSpline:
    """The Sun's position (m) and the Earth's field (T), inertial, (2, 3) at a time in s."""
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
    air, tide = density(flight.orbit.altitude), Tide(earth.MU, inertia)
    known: dict[str, Torque] = {
        "drag": lambda here: torques.drag(box, here.wind, air, craft.drag_coefficient),
        "gravity_gradient": lambda here: tide(here.position),
        "radiation": lambda here: torques.radiation(
            box, here.sun, here.lit, craft.specular, craft.diffuse
        ),
        "dipole": lambda here: torques.dipole(craft.dipole, here.field),
    }
    return {name: torque for name, torque in known.items() if getattr(on, name)}
