"""Gauss's collocation: on each interval a polynomial that obeys the equations at Legendre's points.

Order 2s for s points; quadratic invariants, the length of a quaternion for one, are kept exactly.
Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, sections II.1 and IV.2.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np


@dataclass(frozen=True)
class Tableau:
    """c (s,): points in [0, 1].  a (s, s), b (s,): integrals of Lagrange's polynomials on them,
    to each point and to 1."""

    c: np.ndarray
    a: np.ndarray
    b: np.ndarray

    def __post_init__(self) -> None:
        count = len(self.c)
        if self.a.shape != (count, count) or self.b.shape != (count,):
            raise ValueError("a tableau is square, with a weight for each point")
        if not (np.allclose(self.a.sum(axis=1), self.c) and np.isclose(self.b.sum(), 1)):
            raise ValueError("a tableau integrates constants")


@cache
def gauss(points: int) -> Tableau:
    """The tableau of so many points.

    >>> gauss(1)
    Tableau(c=array([0.5]), a=array([[0.5]]), b=array([1.]))
    """
    roots, _ = np.polynomial.legendre.leggauss(points)
    c = (roots + 1) / 2
    powers = np.arange(1, points + 1)
    # Lagrange's polynomials in powers of x are the columns of the inverse.
    inverse = np.linalg.inv(np.vander(c, points, increasing=True))
    return Tableau(c, c[:, None] ** powers / powers @ inverse, 1 / powers @ inverse)
