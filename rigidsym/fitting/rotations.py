"""Derivatives of rotation vectors: how products of rotations move their logarithms.

Source: Chirikjian, Stochastic Models, Information Theory, and Lie Groups 2 (2012), section 10.3.
"""

import numpy as np

from rigidsym.quaternions import cross_matrices, inverse_left_jacobian

# Below it series of three terms are right to rounding.
_SMALL = 1e-2


def left_jacobian(vector: np.ndarray) -> np.ndarray:
    """J (3, 3) with exp(vector + d) = exp(J d) exp(vector), to first order in d."""
    square = float(vector @ vector)
    turn = cross_matrices(vector)
    return np.eye(3) + _versine(square) * turn + _defect(square) * turn @ turn


def inverse_right_jacobian(vectors: np.ndarray) -> np.ndarray:
    """J (..., 3, 3) with log(exp(vector) exp(d)) = vector + J d, to first order in d.

    Not beyond a whole turn, where the logarithm is not smooth.
    """
    return np.swapaxes(inverse_left_jacobian(vectors), -1, -2)


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
