"""Where axes of the body are hardly told: what they do to quantities along them beyond first order.

A turn theta of the principal axes makes theta x omega of rates along them, which linear errors
have, and theta x (theta x omega) / 2, which they have not; turns go with each other as theta_j
theta_k / 2.  Axes of nearly equal moments may be off by a radian, where the second is no less.
"""

import numpy as np

# How often the errors themselves their products may be, before those are not what there is.
_MOST = 2.0


def is_bent(sigma: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """Which of the errors (12,) of turn, rates, moments and axes are less than what errors of the
    axes, 1 rad at most, make of omega (3,) and of each other in second order."""
    axes = np.minimum(np.nan_to_num(sigma[9:], nan=1.0), 1.0)
    turns = (np.prod(axes) / np.maximum(axes, np.finfo(float).tiny)) / 2
    speed = np.abs(omega)
    others = np.sum(axes**2) - axes**2
    rates = (axes * (axes @ speed - axes * speed) + others * speed) / 2
    return np.concatenate([turns, rates, np.zeros(3), turns]) > _MOST * sigma
