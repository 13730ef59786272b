"""Quaternions and cross products of single vectors, fast enough for the inner loop."""

from collections.abc import Sequence

import numpy as np

from rigidsym.quaternions import conjugate, product

Numbers = np.ndarray | Sequence[float]


def matrix(q: Numbers) -> np.ndarray:
    """Return the rotation (3, 3), body to inertial, of a unit quaternion (4,)."""
    a, b, c, d = map(float, q)
    return np.array(
        [
            [1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)],
        ]
    )


def relative(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return conj(p) q, of (..., 4) each: from the axes of q to those of p."""
    return product(conjugate(p), q)


def angle(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the angle (...) between attitudes (..., 4), rad, accurate where it is small."""
    error = relative(p, q)
    return 2 * np.arctan2(np.linalg.norm(error[..., 1:], axis=-1), np.abs(error[..., 0]))


def cross(a: Numbers, b: Numbers) -> np.ndarray:
    """Return a x b, of (3,) each; numpy's takes ten times as long."""
    a0, a1, a2 = map(float, a)
    b0, b1, b2 = map(float, b)
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])
