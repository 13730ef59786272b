"""Curves and surfaces that pictures share, as arrays (N, 3)."""

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product

import numpy as np

from rigidsym.view.protocols import Motion
from rigidsym.view.times import once

DIGITS = 11
CIRCLE = 97
DENSE = 12


def moments(motion: Motion) -> np.ndarray:
    """The principal moments, kg m^2."""
    return np.array([float(x) for x in motion.exact["inertia"]])


def momentum(motion: Motion) -> np.ndarray:
    """The angular momentum at t = 0 in body axes, kg m^2/s."""
    return moments(motion) * [float(x) for x in motion.exact["omega0"]]


def polhode(motion: Motion, count: int) -> np.ndarray:
    """The body rates all around the polhode (count, 3), rad/s; one point where constant."""
    if motion.regime.steady:
        return motion([0.0])[1]
    rates = motion(np.linspace(*once(motion), DENSE * count + 1))[1]
    # Near the separatrix almost all times are spent at two points: steps are equal in length.
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(rates, axis=0), axis=1))])
    return rates[np.searchsorted(along, np.linspace(0, along[-1], count))]


def upright(vector: np.ndarray) -> np.ndarray:
    """The quaternion of the shortest rotation that takes a vector to the third axis."""
    x, y, z = vector / np.linalg.norm(vector)
    if z < -1 + 1e-12:
        return np.array([0.0, 1.0, 0.0, 0.0])
    found = np.array([1 + z, y, -x, 0.0])
    return found / np.linalg.norm(found)


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


def members(motion: Motion, size: float, count: int) -> Iterator[Motion]:
    """Motions of the same body and |M|, `count` about each end of the outer axes.

    They start between axis and separatrix, in the plane of the axes of largest and least inertia.
    """
    inertia = motion.exact["inertia"]
    d, _, a = sorted(range(3), key=inertia.__getitem__)
    circles = separatrix(inertia, size)
    if not circles:
        return
    quarter = circles[0][len(circles[0]) // 4]
    edge = math.atan2(abs(quarter[d]), abs(quarter[a]))
    for sign, axis, share in product((1, -1), (0.0, math.pi / 2), range(1, count + 1)):
        angle = axis + (edge - axis) * share / (count + 0.4)
        start = np.zeros(3)
        start[a], start[d] = sign * size * math.cos(angle), sign * size * math.sin(angle)
        if axis != edge:
            omega = (start / moments(motion)).tolist()
            yield motion.replace(omega0=omega)


def rounded(values: np.ndarray) -> np.ndarray:
    """Eleven digits of the largest: what is drawn must not depend on the machine."""
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if not size:
        return np.asarray(values, dtype=float)
    digits = DIGITS - 1 - math.floor(math.log10(size))
    return np.round(values, digits) + 0.0
