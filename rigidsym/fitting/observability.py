"""What the observations tell and what they do not: covariance, and directions nothing tells.

Errors are linear ones, of the derivatives at the minimum, in natural sizes: 1 rad, the rates as
they are, the moments as they are.  They are looked at once more where they lead: one and two of
them to both sides along each of their principal axes, and half the natural size along what is not
told.  Where they are more than twice as large there, in any direction, the larger ones count: what
the observations tell is what they tell wherever the motion may be.  Directions in which errors
reach their natural size are null directions, and a parameter that has a part in them is
unobservable.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

# Where errors are looked at again: in units of those told, and of natural sizes.
_REACH, _HALF = (-2.0, -1.0, 1.0, 2.0), (-0.5, 0.5)
# By how much they have to be larger there.
_LARGER = 2.0
# Of natural sizes: errors as large as that, but for rounding.
_NATURAL = 0.999


@dataclass(frozen=True, slots=True)
class Observability:
    """Of p parameters: errors are combinations of `told` (p, a), independent and of size one, and
    of `blind` (p, b), which nothing tells, at their natural size; null (b, p): the unit directions
    of these, in units of the natural sizes; bent (c, p): those in which errors are larger than
    linear ones.

    At the minimum: residuals (M,), and an orthonormal basis `moved` (M, k) of what the parameters
    move them by more than errors do.
    """

    told: np.ndarray
    blind: np.ndarray
    null: np.ndarray
    bent: np.ndarray
    residuals: np.ndarray
    moved: np.ndarray

    def covariance(self, rows: np.ndarray) -> np.ndarray:
        """Of quantities that go with the parameters as `rows` (k, p): (k, k).

        What the null directions would bring, at their natural size, beyond what is told makes a
        variance infinite, and its covariances no numbers.
        """
        told, blind = rows @ self.told, rows @ self.blind
        found = told @ told.T
        lost = ~(np.sum(blind**2, axis=1) <= np.diag(found))
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
    natural = problem.parameters.natural(point, problem.span)
    residuals, slopes = problem.linearised(point, problem.parameters.linear(point))
    if not np.isfinite(residuals).all() or not np.isfinite(slopes).all():
        slopes = np.zeros_like(slopes)
    here = _errors(slopes * natural)
    wide, bent = here, []
    for x in _ends(here):
        there = _slopes(problem, problem.parameters.stepped(point, natural * x))
        if there is not None:
            wide, more = _within(wide, _errors(there * natural))
            bent.append(more)
    directions, sizes, _ = np.linalg.svd(wide)
    told = sizes < _NATURAL
    moved = slopes * natural @ here
    return Observability(
        natural[:, None] * directions[:, told] * sizes[told],
        natural[:, None] * directions[:, ~told],
        directions[:, ~told].T,
        np.concatenate(bent) if bent else np.empty((0, len(natural))),
        residuals,
        moved[:, np.linalg.norm(here, axis=0) < 1],
    )


def _errors(slopes: np.ndarray) -> np.ndarray:
    """E (p, p) with the covariance E E^T, in natural sizes; its columns are principal axes, and
    those that nothing tells are of length one."""
    _, sizes, right = np.linalg.svd(np.linalg.qr(slopes, "r"), full_matrices=True)
    every = np.zeros(len(right))
    every[: len(sizes)] = sizes
    return right.T / np.maximum(every, 1.0)


def _ends(errors: np.ndarray) -> Iterator[np.ndarray]:
    """Where errors lead, in natural sizes."""
    for column in errors.T:
        for reach in _REACH if np.linalg.norm(column) < 1 else _HALF:
            yield reach * column


def _slopes(problem: Problem, point: Point) -> np.ndarray | None:
    """Of the residuals; None where the motion has no states."""
    _, found = problem.linearised(point, problem.parameters.linear(point))
    return found if np.isfinite(found).all() else None


def _within(errors: np.ndarray, others: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The least errors with both of them within, and unit directions (c, p) of what is new.

    E^-1 E' = U S V^T: in axes in which E is the unit sphere, E' is an ellipsoid of half axes S.
    """
    axes, sizes, _ = np.linalg.svd(np.linalg.solve(errors, others))
    larger = sizes > _LARGER
    wide = errors @ (axes * np.where(larger, sizes, 1.0))
    new = wide[:, larger]
    return wide, (new / np.linalg.norm(new, axis=0)).T
