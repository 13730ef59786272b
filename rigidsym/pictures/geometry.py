"""Curves and surfaces that pictures share, as arrays (N, 3)."""

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.pictures.times import once
from rigidsym.solution.polhode import Regime

if TYPE_CHECKING:
    from rigidsym.motion import TorqueFreeMotion

DIGITS = 11
CIRCLE = 97
DENSE = 12


def moments(motion: "TorqueFreeMotion") -> np.ndarray:
    """The principal moments, kg m^2."""
    return np.array([float(x) for x in motion.exact["inertia"]])


def momentum(motion: "TorqueFreeMotion") -> np.ndarray:
    """The angular momentum at t = 0 in body axes, kg m^2/s."""
    return moments(motion) * [float(x) for x in motion.exact["omega0"]]


def polhode(motion: "TorqueFreeMotion", count: int) -> np.ndarray:
    """The body rates all around the polhode (count, 3), rad/s; one point where constant."""
    if motion.regime.steady:
        return motion([0.0])[1]
    rates = motion(np.linspace(*once(motion), DENSE * count + 1))[1]
    # Near the separatrix almost all times are spent at two points: steps are equal in length.
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(rates, axis=0), axis=1))])
    return rates[np.searchsorted(along, np.linspace(0, along[-1], count))]


def rotated(q: np.ndarray, vectors: np.ndarray) -> np.ndarray:
    """Vectors (..., 3) turned by unit quaternions (..., 4), shapes broadcast."""
    scalar, axis = q[..., :1], q[..., 1:]
    twice = 2 * np.cross(axis, vectors)
    return vectors + scalar * twice + np.cross(axis, twice)


def upright(vector: np.ndarray) -> np.ndarray:
    """The quaternion of the shortest rotation that takes a vector to the third axis."""
    x, y, z = vector / np.linalg.norm(vector)
    if z < -1 + 1e-12:
        return np.array([0.0, 1.0, 0.0, 0.0])
    found = np.array([1 + z, y, -x, 0.0])
    return found / np.linalg.norm(found)


def after(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The product p q of a quaternion (4,) and quaternions (..., 4)."""
    scalar = p[0] * q[..., :1] - (q[..., 1:] @ p[1:])[..., None]
    vector = p[0] * q[..., 1:] + q[..., :1] * p[1:] + np.cross(p[1:], q[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)


def great_circles(size: float) -> list[np.ndarray]:
    """Three circles around a sphere, one about each axis."""
    angle = np.linspace(0, 2 * math.pi, CIRCLE)
    flat = size * np.stack([0 * angle, np.cos(angle), np.sin(angle)], axis=1)
    return [np.roll(flat, k, axis=1) for k in range(3)]


def separatrix(inertia: Iterable[Fraction], size: float) -> list[np.ndarray]:
    """Where K^2 = 2H c_b on the sphere |M| = K: two circles through the middle axis b.

    M_a^2 (c_a - c_b)/c_a = M_d^2 (c_b - c_d)/c_d.  Symmetric bodies have one circle, of steady
    spins about axes across their own; a sphere has none.
    """
    given = list(inertia)
    d, b, a = sorted(range(3), key=given.__getitem__)
    across = (
        math.sqrt((given[b] - given[d]) / given[d]),
        math.sqrt((given[a] - given[b]) / given[a]),
    )
    if not any(across):
        return []
    angle = np.linspace(0, 2 * math.pi, CIRCLE)
    circles = []
    for sign in (1, -1) if all(across) else (1,):
        curve = np.zeros((CIRCLE, 3))
        curve[:, b] = np.cos(angle)
        curve[:, a] = np.sin(angle) * across[0] / math.hypot(*across)
        curve[:, d] = np.sin(angle) * sign * across[1] / math.hypot(*across)
        circles.append(size * curve)
    return circles


def regime_colour(regime: Regime) -> str:
    """The colour of a regime, seen on light and on dark."""
    return {
        Regime.LARGEST: "#1f83c4",
        Regime.SMALLEST: "#e0682a",
        Regime.SEPARATRIX: "#c0399f",
        Regime.SYMMETRIC: "#139a6f",
        Regime.SPIN: "#b58a00",
        Regime.SPHERICAL: "#b58a00",
    }.get(regime, "#7f8c9b")


def rounded(values: np.ndarray) -> np.ndarray:
    """Eleven digits of the largest: what is drawn must not depend on the machine."""
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if not size:
        return np.asarray(values, dtype=float)
    digits = DIGITS - 1 - math.floor(math.log10(size))
    return np.round(values, digits) + 0.0
