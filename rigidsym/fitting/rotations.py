"""Derivatives of rotation vectors: how products of rotations move their logarithms.

Source: Chirikjian, Stochastic Models, Information Theory, and Lie Groups 2 (2012), section 10.3.
"""

import numpy as np

# Below it series of three terms are right to rounding.
_SMALL = 1e-2


def cross(vectors: np.ndarray) -> np.ndarray:
    """The matrices (..., 3, 3) that take x to vector x x, of vectors (..., 3)."""
    x, y, z = np.moveaxis(vectors, -1, 0)
    zero = np.zeros_like(x)
    rows = [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def matrices(q: np.ndarray) -> np.ndarray:
    """Rotation matrices (..., 3, 3) of unit quaternions (..., 4)."""
    turn = cross(q[..., 1:])
    return np.eye(3) + 2 * q[..., :1, None] * turn + 2 * turn @ turn


def left_jacobian(vector: np.ndarray) -> np.ndarray:
    """J (3, 3) with exp(vector + d) = exp(J d) exp(vector), to first order in d."""
    square = float(vector @ vector)
    turn = cross(vector)
    return np.eye(3) + _versine(square) * turn + _defect(square) * turn @ turn


def inverse_right_jacobian(vectors: np.ndarray) -> np.ndarray:
    """J (..., 3, 3) with log(exp(vector) exp(d)) = vector + J d, to first order in d.

    Not beyond a whole turn, where the logarithm is not smooth.
    """
    square = np.sum(vectors**2, axis=-1)[..., None, None]
    small = square < _SMALL
    half = np.sqrt(np.where(small, 1.0, square)) / 2
    exact = (1 - half * np.cos(half) / np.sin(half)) / (4 * half**2)
    series = 1 / 12 + square / 720 + square**2 / 30240
    turn = cross(vectors)
    return np.eye(3) + turn / 2 + np.where(small, series, exact) * turn @ turn


def _versine(square: float) -> float:
    """(1 - cos a)/a^2 of a^2."""
    if square < _SMALL:
        return 1 / 2 - square / 24 + square**2 / 720
    return (1 - np.cos(np.sqrt(square))) / square


def _defect(square: float) -> float:
    """(a - sin a)/a^3 of a^2."""
    if square < _SMALL:
        return 1 / 6 - square / 120 + square**2 / 5040
    angle = np.sqrt(square)
    return (angle - np.sin(angle)) / (angle * square)
