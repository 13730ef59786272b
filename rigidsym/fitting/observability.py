"""What the observations tell and what they do not: covariance, and directions nothing tells.

A change of the parameters by their natural size, 1 rad, the rates as they are, the moments as they
are, is told where it moves the residuals by more than their errors together.  Directions in which
it does not, by the singular values of the derivatives, are null directions: the linear errors say
nothing there, and a parameter that has a part in them is unobservable.
"""

from dataclasses import dataclass

import numpy as np

from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

_TOLD = 1.0


@dataclass(frozen=True, slots=True)
class Observability:
    """Of p parameters: errors are combinations of `told` (p, a), independent and of size one, and
    of `blind` (p, b), which nothing tells, at their natural size; residuals (M,) and derivatives
    (M, p) at the minimum; null (b, p): the unit directions, in units of the natural sizes."""

    told: np.ndarray
    blind: np.ndarray
    null: np.ndarray
    residuals: np.ndarray
    slopes: np.ndarray

    def covariance(self, rows: np.ndarray) -> np.ndarray:
        """Of quantities that go with the parameters as `rows` (k, p): (k, k).

        What the null directions would bring, at their natural size, beyond what is told makes a
        variance infinite, and its covariances no numbers.
        """
        told, blind = rows @ self.told, rows @ self.blind
        found = told @ told.T
        lost = np.sum(blind**2, axis=1) > np.diag(found)
        found[lost] = np.nan
        found[:, lost] = np.nan
        found[lost, lost] = np.inf
        return found

    def widest(self, rows: np.ndarray) -> np.ndarray:
        """Of rows (..., k, p), (..., k, k), null directions at their natural size."""
        both = rows @ np.hstack([self.told, self.blind])
        return both @ np.swapaxes(both, -2, -1)


def observability(problem: Problem, point: Point) -> Observability:
    """At a minimum; nothing is told where the motion has no states."""
    residuals, slopes = problem.linearised(point, problem.parameters.linear(point))
    natural = problem.parameters.natural(point, problem.span)
    if not np.isfinite(residuals).all() or not np.isfinite(slopes).all():
        slopes = np.zeros_like(slopes)
    rows = np.vstack([slopes * natural, np.zeros((len(natural), len(natural)))])
    _, sizes, right = np.linalg.svd(rows, full_matrices=False)
    told = sizes > _TOLD
    return Observability(
        natural[:, None] * right[told].T / sizes[told],
        natural[:, None] * right[~told].T,
        right[~told],
        residuals,
        slopes,
    )
