"""Angles in which others give attitudes."""

import numpy as np

from rigidsym.quaternions import product


def euler_313(angles: np.ndarray) -> np.ndarray:
    """Quaternions (N, 4) of R = Rz(a) Rx(b) Rz(c), body to inertial, of (N, 3) angles in rad.

    >>> euler_313(np.array([[np.pi / 2, 0.0, np.pi / 2]])).round(12)
    array([[0., 0., 0., 1.]])
    """
    first, second, third = (_about(k, x) for k, x in zip((3, 1, 3), angles.T, strict=True))
    return product(product(first, second), third)


def _about(axis: int, angle: np.ndarray) -> np.ndarray:
    found = np.zeros((len(angle), 4))
    found[:, 0], found[:, axis] = np.cos(angle / 2), np.sin(angle / 2)
    return found
