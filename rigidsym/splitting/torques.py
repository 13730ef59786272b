"""Torques that `integrate` takes, N m in body axes, of many bodies at once.

A torque is any callable of the time (s), attitudes (..., 4) and rates (..., 3) that returns
(..., 3); these are the common ones.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.quaternions import conjugate, product, rotated
from rigidsym.splitting.orbits import KeplerOrbit

Components = tuple[np.ndarray, np.ndarray, np.ndarray]
Torque = Callable[[float, np.ndarray, np.ndarray], np.ndarray]


class ConstantInBody:
    """The same in body axes: a thruster.  torque: (..., 3), N m."""

    def __init__(self, torque: ArrayLike) -> None:
        self.torque = _vectors("torque", torque)

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """N m, (..., 3)."""
        return np.broadcast_to(self.torque, omega.shape)


class ConstantInSpace:
    """The same in inertial axes.  torque: (..., 3), N m."""

    def __init__(self, torque: ArrayLike) -> None:
        self.torque = _vectors("torque", torque)

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """N m, (..., 3)."""
        return rotated(conjugate(q), np.broadcast_to(self.torque, omega.shape))


@dataclass(frozen=True, slots=True)
class Potential:
    """Of bodies whose energy depends on their attitude and the time.

    gradient: of the time (s) and attitudes (..., 4); the energy's derivatives, J, by the four
    components of the quaternion, (..., 4).  Only how the energy changes along rotations counts:
    the torque is -1/2 of the vector of conj(q) gradient, as q' = q (0, omega) / 2.
    """

    gradient: Callable[[float, np.ndarray], np.ndarray]

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """N m, (..., 3)."""
        return -0.5 * product(conjugate(q), np.asarray(self.gradient(t, q)))[..., 1:]


class GravityGradient:
    """The tide of a mass point, 3 mu / r^5  r x I r, on bodies that follow one orbit.

    inertia: (..., 3), kg m^2, about principal axes.  Hughes, Spacecraft Attitude Dynamics, 8.1.
    """

    def __init__(self, inertia: ArrayLike, orbit: KeplerOrbit) -> None:
        self.inertia, self.orbit = _vectors("inertia", inertia), orbit

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """N m, (..., 3)."""
        strength, (x, y, z) = self._seen(t, q)
        c_1, c_2, c_3 = np.moveaxis(strength * self.inertia, -1, 0)
        parts = (c_3 - c_2) * y * z, (c_1 - c_3) * z * x, (c_2 - c_1) * x * y
        return np.stack(parts, axis=-1)

    def energy(self, t: float, q: np.ndarray) -> np.ndarray:
        """What depends on the attitude of the potential energy, J, (...): that which the torque
        lowers, to the second order in the size of the body (MacCullagh's formula)."""
        strength, towards = self._seen(t, q)
        return strength / 2 * np.sum(self.inertia * np.stack(towards, axis=-1) ** 2, axis=-1)

    def _seen(self, t: float, q: np.ndarray) -> tuple[float, Components]:
        """3 mu / r^3, and the unit vector from the mass point, in body axes."""
        position = self.orbit.position(t)
        r = math.hypot(*position)
        return 3 * self.orbit.mu / r**3, _in_body(q, *(position / r))


def _in_body(q: np.ndarray, x: float, y: float, z: float) -> Components:
    """Components along the axes of bodies of one vector in space; NumPy's cross products, with
    which `rotated` does this, would take most of the time of a step of few bodies."""
    a, b, c, d = np.moveaxis(q, -1, 0)
    # The vector from the right by that of q, twice.
    u, v, w = 2 * (y * d - z * c), 2 * (z * b - x * d), 2 * (x * c - y * b)
    return x + a * u + (v * d - w * c), y + a * v + (w * b - u * d), z + a * w + (u * c - v * b)


def _vectors(field: str, value: ArrayLike) -> np.ndarray:
    array = batches.array(field, value)
    if array.shape[-1:] != (3,):
        raise InputError(field, f"an array of shape {array.shape}", "must be (..., 3)")
    return array
