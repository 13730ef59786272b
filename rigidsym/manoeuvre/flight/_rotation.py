"""Fast quaternion and cross products of single vectors for the simulation loop."""

from collections.abc import Sequence

import numpy as np

from rigidsym.quaternions import conjugate, product

Numbers = np.ndarray | Sequence[float]


def matrix(q: Numbers) -> np.ndarray:
    """Return the rotation matrix, body to inertial, of a unit quaternion.

    The matrix has the shape (3, 3), the quaternion (4,).
    """
    a, b, c, d = map(float, q)
    return np.array(
        [
            [1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)],
        ]
    )


def relative(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the relative rotation conj(p) q, from the axes of q to those of p.

    Quaternions have the shape (..., 4).
    """
    return product(conjugate(p), q)


def angle(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the angle between two attitudes in rad, accurately even for small angles.

    Attitudes have the shape (..., 4).
    """
    error = relative(p, q)
    return 2 * np.arctan2(np.linalg.norm(error[..., 1:], axis=-1), np.abs(error[..., 0]))


def cross(a: Numbers, b: Numbers) -> np.ndarray:
    """Return the cross product a x b of two vectors (3,).

    `numpy.cross` takes ten times as long.
    """
    a0, a1, a2 = map(float, a)
    b0, b1, b2 = map(float, b)
    return np.array([a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0])
