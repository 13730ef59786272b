"""Elliptic and hyperbolic Kepler orbits, with positions and tidal fields."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from rigidsym.errors import InputError

_ENOUGH = 1e-15
_MOST_ITERATIONS = 60


@dataclass(frozen=True, slots=True)
class KeplerOrbit:
    """Elliptic or hyperbolic orbit around a mass point.

    Parameters
    ----------
    mu : float
        Gravitational parameter, m^3/s^2.
    periapsis : float
        The least distance, m.
    eccentricity : float
        From 0 up, but not 1.
    inclination, node, argument : float
        Angles of the orbit in the inertial axes, rad.
    epoch : float
        A time at periapsis, s.

    Raises
    ------
    InputError
        For numbers that are not finite or out of range.

    Examples
    --------
    >>> orbit = KeplerOrbit(mu=3.986004418e14, periapsis=6.778e6)
    >>> orbit.position(orbit.period / 4).round(3)
    array([      0., 6778000.,       0.])
    """

    mu: float
    periapsis: float
    eccentricity: float = 0.0
    inclination: float = 0.0
    node: float = 0.0
    argument: float = 0.0
    epoch: float = 0.0

    def __post_init__(self) -> None:
        for name in self.__slots__:
            if not math.isfinite(value := getattr(self, name)):
                raise InputError(name, value, "must be finite")
        for name in ("mu", "periapsis"):
            if (value := getattr(self, name)) <= 0:
                raise InputError(name, value, "must be positive")
        if self.eccentricity < 0 or self.eccentricity == 1:
            rule = "must be at least 0, and not that of a parabola"
            raise InputError("eccentricity", self.eccentricity, rule)

    @property
    def mean_motion(self) -> float:
        """The mean motion, in rad/s.

        For a hyperbola it is computed from the absolute value of the semi-major axis.
        """
        return math.sqrt(self.mu / self._semi_major**3)

    @property
    def period(self) -> float:
        """The orbital period, in s.

        It is infinite for a hyperbola.
        """
        return 2 * math.pi / self.mean_motion if self.eccentricity < 1 else math.inf

    @property
    def axes(self) -> tuple[np.ndarray, np.ndarray]:
        """Orthonormal vectors that span the orbital plane, in inertial axes.

        The first (3,) points towards periapsis, the second one is 90 degrees ahead of it.
        """
        (c_n, s_n), (c_i, s_i), (c_w, s_w) = (
            (math.cos(x), math.sin(x)) for x in (self.node, self.inclination, self.argument)
        )
        ascending = np.array([c_n, s_n, 0.0])
        highest = np.array([-s_n * c_i, c_n * c_i, s_i])
        return c_w * ascending + s_w * highest, c_w * highest - s_w * ascending

    def position(self, t: float) -> np.ndarray:
        """Return the position relative to the mass point at a time, in m.

        It has the shape (3,) and is in inertial axes.
        """
        a, e, mean_anomaly = (
            self._semi_major,
            self.eccentricity,
            self.mean_motion * (t - self.epoch),
        )
        if e < 1:
            E = elliptic_anomaly(math.remainder(mean_anomaly, 2 * math.pi), e)
            along, across = a * (math.cos(E) - e), a * math.sqrt(1 - e * e) * math.sin(E)
        else:
            F = hyperbolic_anomaly(mean_anomaly, e)
            along, across = a * (e - math.cosh(F)), a * math.sqrt(e * e - 1) * math.sinh(F)
        return along * self.axes[0] + across * self.axes[1]

    def tide(self, t: float) -> np.ndarray:
        """Return the position at a time, scaled for the gravity gradient torque.

        It is the position relative to the mass point, scaled by sqrt(3 mu / r^5). A body's gravity
        gradient is v x I v, N m, where v are its components (3,) in body axes.
        """
        return tidal(self.mu, self.position(t))

    @property
    def numbers(self) -> np.ndarray:
        """The orbit's parameters in the order of the C struct `torque_free_orbit`.

        The array has the shape (11,).
        """
        shape = self.mean_motion, self.epoch, self.eccentricity, self._semi_major, 3 * self.mu
        return np.array([*shape, *self.axes[0], *self.axes[1]])

    @property
    def _semi_major(self) -> float:
        return self.periapsis / abs(1 - self.eccentricity)


def tidal(mu: float, position: np.ndarray) -> np.ndarray:
    """Scale a position relative to a mass point by sqrt(3 mu / r^5).

    position: (3,), m; r is its length.  With the result v, the gravity gradient of a body is v x I
    v.
    """
    r = math.hypot(*position)
    return math.sqrt(3 * mu / r) / (r * r) * position


def elliptic_anomaly(mean: float, e: float) -> float:
    """Solve Kepler's equation E - e sin E = mean for the eccentric anomaly E, in rad.

    It is required that |mean| <= pi and 0 <= e < 1.  Newton's method starts at E = pi, on the side
    of the mean anomaly, and comes down without passing the root (Charles and Tatum, Celestial
    Mechanics and Dynamical Astronomy 69, 357-372).

    >>> E = elliptic_anomaly(0.3, 0.9)
    >>> abs(E - 0.9 * math.sin(E) - 0.3) < 1e-15
    True
    """
    start = math.copysign(math.pi, mean)
    return _newton(start, lambda E: (E - e * math.sin(E) - mean) / (1 - e * math.cos(E)))


def hyperbolic_anomaly(mean: float, e: float) -> float:
    """Solve Kepler's equation e sinh F - F = mean for the hyperbolic anomaly F.

    It is required that e > 1.  Newton's method starts at asinh(mean / (e - 1)), on the far side of
    the root, and comes down without passing it.

    >>> F = hyperbolic_anomaly(0.3, 1.2)
    >>> abs(1.2 * math.sinh(F) - F - 0.3) < 1e-15
    True
    """
    start = math.asinh(mean / (e - 1))
    return _newton(start, lambda F: (e * math.sinh(F) - F - mean) / (e * math.cosh(F) - 1))


def _newton(x: float, change: Callable[[float], float]) -> float:
    """Find a root by Newton's method from a starting value.

    change: computes the step to subtract from x.
    """
    for _ in range(_MOST_ITERATIONS):
        step = change(x)
        x -= step
        if abs(step) <= _ENOUGH * abs(x):
            break
    return x
