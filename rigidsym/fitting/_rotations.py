"""Rotation vectors and angles: derivatives of logarithms of products, rotations about axes.

Source: Chirikjian, Stochastic Models, Information Theory, and Lie Groups 2 (2012), section 10.3.
"""

import numpy as np

from rigidsym.quaternions import cross_matrices, inverse_left_jacobian, product

# Below it series of three terms are right to rounding.
_SMALL = 1e-2


def left_jacobian(vector: np.ndarray) -> np.ndarray:
    """Return J (3, 3) with exp(vector + d) = exp(J d) exp(vector), to first order in d."""
    square = float(vector @ vector)
    turn = cross_matrices(vector)
    if square < _SMALL:
        versine = 1 / 2 - square / 24 + square**2 / 720
        defect = 1 / 6 - square / 120 + square**2 / 5040
    else:
        angle = np.sqrt(square)
        versine = (1 - np.cos(angle)) / square
        defect = (angle - np.sin(angle)) / (angle * square)
    return np.eye(3) + versine * turn + defect * turn @ turn


def inverse_right_jacobian(vectors: np.ndarray) -> np.ndarray:
    """Return J (..., 3, 3) with log(exp(vector) exp(d)) = vector + J d, to first order in d.

    Valid up to a whole turn, where the logarithm is not smooth.
    """
    return np.swapaxes(inverse_left_jacobian(vectors), -1, -2)


def about(axis: int, angle: np.ndarray) -> np.ndarray:
    """Return quaternions (..., 4) of rotations by angles (...), rad, about one axis: 0, 1 or 2."""
    found = np.zeros((*angle.shape, 4))
    found[..., 0], found[..., 1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return found


def euler_313(angles: np.ndarray) -> np.ndarray:
    """Return quaternions (N, 4) of R = Rz(a) Rx(b) Rz(c), body to inertial, of (N, 3) angles, rad.

    >>> euler_313(np.array([[np.pi / 2, 0.0, np.pi / 2]])).round(12)
    array([[0., 0., 0., 1.]])
    """
    first, second, third = (about(k, x) for k, x in zip((2, 0, 2), angles.T, strict=True))
    return product(product(first, second), third)
