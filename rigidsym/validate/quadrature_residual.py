"""q' = q (0, omega)/2 over short intervals: what is left of its integral, which needs no oracle."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.polynomial import legendre

# Nodes of an interval, and its length in radians: what Gauss and Lobatto's rule leaves out is below
# 1e-18 then, since the motion is analytic within 3/2 of a radian or more.  With nodes and weights
# rounded, true states have residuals of 1e-16 at most.
NODES, LENGTH = 10, 0.5
# Beyond so many radians doubles are too far apart for nodes.
MAX_ANGLE = 2.0**38


@dataclass(frozen=True, slots=True)
class Quadrature:
    """Times of the nodes (NODES,), and the weights of exactly these in an integral over time."""

    nodes: np.ndarray
    weights: np.ndarray

    @classmethod
    def over(cls, begin: float, rate: float) -> "Quadrature":
        """That of LENGTH radians at `rate` rad/s from a time, or from where doubles are dense."""
        begin = float(np.clip(begin, -MAX_ANGLE / rate, MAX_ANGLE / rate))
        nodes = begin + (_lobatto() + 1) * (LENGTH / rate / 2)
        half = (nodes[-1] - nodes[0]) / 2
        places = (nodes - nodes[0]) / half - 1
        # Times are doubles: the rule is that of where they came to lie.
        moments = np.zeros(NODES)
        moments[0] = 2
        weights = np.linalg.solve(legendre.legvander(places, NODES - 1).T, moments)
        return cls(nodes, weights * half)


def residual(quadrature: Quadrature, q: np.ndarray, omega: np.ndarray) -> float:
    """|q at the end - q at the beginning - integral of q (0, omega)/2|, of states at the nodes."""
    turned = _times_vectors(q, omega * quadrature.weights[:, None])
    return float(np.linalg.norm(q[-1] - q[0] - np.sum(turned, axis=0) / 2))


@cache
def _lobatto() -> np.ndarray:
    """Ends of [-1, 1] and zeros of the derivative of Legendre's polynomial."""
    inner = legendre.Legendre.basis(NODES - 1).deriv().roots()
    return np.concatenate([[-1.0], np.sort(inner), [1.0]])


def _times_vectors(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """q (0, v) of rows (N, 4) and (N, 3)."""
    scalar = -np.sum(q[:, 1:] * v, axis=-1, keepdims=True)
    return np.hstack([scalar, q[:, :1] * v + np.cross(q[:, 1:], v)])
