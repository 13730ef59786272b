"""What the observations tell and what they do not: covariance, and directions nothing tells.

A change of the parameters by their natural size, 1 rad, the rates as they are, the moments as they
are, is told where it moves the residuals by more than their errors together.  Directions in which
it does not, by the singular values of the derivatives, are null directions: the linear errors say
nothing there, and a parameter that has a part in them is unobservable.

Linear errors are looked at once more where they lead: one and two of them to both sides along each
of their principal axes, where derivatives change their sign between these, and half the natural
size along null directions.  Where the error of a quantity is more than twice as large there, that
is its error; where it is as large as can be there, the quantity is unobservable.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from rigidsym.fitting.batch import blocks
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

_TOLD = 1.0
# Where errors are looked at again: in units of those told, and of natural sizes.
_REACH, _HALF = (1.0, 2.0), 0.5
# By how much they have to be larger there.
_LARGER = 2.0
# Of a unit direction: what of it is null somewhere.
_MOSTLY = 0.5

Rows = Callable[[Point], np.ndarray]


@dataclass(frozen=True, slots=True)
class Errors:
    """At a point, of p parameters: errors are combinations of `told` (p, a), independent and of
    size one, and of `blind` (p, b), which nothing tells, at their natural size; null (b, p): the
    unit directions, in units of the natural sizes."""

    point: Point
    natural: np.ndarray
    told: np.ndarray
    blind: np.ndarray
    null: np.ndarray

    def covariance(self, rows: np.ndarray) -> np.ndarray:
        """Of quantities that go with the parameters as `rows` (k, p): (k, k).

        What the null directions would bring, at their natural size, beyond what is told makes a
        variance infinite, and its covariances no numbers.
        """
        told, blind = rows @ self.told, rows @ self.blind
        found = told @ told.T
        lose(found, np.sum(blind**2, axis=1) > np.diag(found))
        return found

    def variance(self, rows: np.ndarray) -> np.ndarray:
        """Of rows (k, p), (k,): infinite where null directions are most of what there can be."""
        blind = np.sum((rows @ self.blind) ** 2, axis=-1)
        told = np.sum((rows @ self.told) ** 2, axis=-1)
        most = np.sum((rows * self.natural) ** 2, axis=-1)
        return np.where(blind > np.maximum(told, _MOSTLY**2 * most), np.inf, told + blind)

    def widest(self, rows: np.ndarray) -> np.ndarray:
        """Of rows (..., k, p), (..., k, k), null directions at their natural size."""
        both = rows @ np.hstack([self.told, self.blind])
        return both @ np.swapaxes(both, -2, -1)


@dataclass(frozen=True)
class Observability:
    """At a minimum: errors, residuals (M,) and their derivatives (M, p)."""

    problem: Problem
    here: Errors
    residuals: np.ndarray
    slopes: np.ndarray

    @cached_property
    def moved(self) -> np.ndarray:
        """An orthonormal basis (M, a) of what the parameters move the residuals by."""
        return self.slopes @ self.here.told

    @cached_property
    def ends(self) -> tuple[Errors, ...]:
        """Errors where those at the minimum lead, as far as there are motions: one and two of them
        to both sides, where derivatives change their sign before that, and along null directions.
        """
        told, sides = self.here.told.T, (1.0, -1.0)
        ways = np.array([side * one for side in sides for one in told]).reshape(-1, told.shape[1])
        blind = [side * _HALF * one for side in sides for one in self.here.blind.T]
        found = list(self._at([*(reach * x for reach in _REACH for x in ways), *blind]))
        start = np.linalg.det(self.moved.T @ self.moved) if len(told) else 0.0
        turned = []
        for k, way in enumerate(ways):
            volumes = [start, *(found[k + place * len(ways)][1] for place in range(len(_REACH)))]
            for (a, one), (b, other) in pairwise(zip((0.0, *_REACH), volumes, strict=True)):
                if one * other < 0:
                    turned.append((a + one / (one - other) * (b - a)) * way)
        return tuple(one for one, _ in (*found, *self._at(turned)) if one)

    def _at(self, steps: list[np.ndarray]) -> "Iterator[tuple[Errors | None, float]]":
        """Errors some steps of the parameters away, and the volume, with its sign, of what one
        error each way makes of the residuals along what it makes at the minimum; None and NaN
        where there are no states."""
        if not steps:
            return
        start = self.here.point.repeated(len(steps))
        for some in blocks(self.problem, self.problem.parameters.stepped(start, np.array(steps))):
            own = self.problem.parameters.linear(some)
            _, slopes = self.problem.linearised(some, own)
            for k, one in enumerate(slopes):
                if not np.isfinite(one).all():
                    yield None, np.nan
                    continue
                turned = self.moved.T @ one @ self.here.told
                yield _errors(self.problem, some[k], one), float(np.linalg.det(turned))

    @cached_property
    def null(self) -> np.ndarray:
        """Unit directions (k, p), orthonormal, that are null at the minimum or where errors lead.

        In units of the natural sizes.
        """
        every = np.vstack([self.here.null, *(one.null for one in self.ends)])
        _, sizes, right = np.linalg.svd(every, full_matrices=False)
        return right[sizes > _MOSTLY]

    def covariance(self, rows: Rows) -> np.ndarray:
        """Of quantities that go with the parameters at a point as its rows (k, p): (k, k)."""
        found = self.here.covariance(rows(self.here.point))
        there = (one.variance(rows(one.point)) for one in self.ends)
        return _widened(found, there)

    def widest(self, rows: Rows) -> np.ndarray:
        """The same of rows (..., k, p), null directions at their natural size."""
        found = self.here.widest(rows(self.here.point))
        there = (one.widest(rows(one.point)) for one in self.ends)
        return _widened(found, (np.einsum("...ii->...i", x) for x in there))


def observability(problem: Problem, point: Point) -> Observability:
    """At a minimum; nothing is told where the motion has no states."""
    residuals, slopes = problem.linearised(point, problem.parameters.linear(point))
    if not np.isfinite(residuals).all() or not np.isfinite(slopes).all():
        slopes = np.zeros_like(slopes)
    return Observability(problem, _errors(problem, point, slopes), residuals, slopes)


def _errors(problem: Problem, point: Point, slopes: np.ndarray) -> Errors:
    natural = problem.parameters.natural(point, problem.span)
    rows = np.vstack([slopes * natural, np.zeros((len(natural), len(natural)))])
    _, sizes, right = np.linalg.svd(np.linalg.qr(rows, "r"))
    told = sizes > _TOLD
    return Errors(
        point,
        natural,
        natural[:, None] * right[told].T / sizes[told],
        natural[:, None] * right[~told].T,
        right[~told],
    )


def _widened(covariance: np.ndarray, variances: Iterator[np.ndarray]) -> np.ndarray:
    """A covariance (..., k, k) with variances (..., k) as large as any of those that are larger by
    the square of a factor that counts.

    What is added is independent, so that no combination of quantities has a smaller variance.
    """
    own = np.einsum("...ii->...i", covariance)
    most = own.copy()
    for found in variances:
        np.fmax(most, found, out=most)
    larger = (most > _LARGER**2 * own) & (own > 0) & np.isfinite(most)
    more = np.where(larger, most, 0.0) - np.where(larger, own, 0.0)
    found = covariance + more[..., None] * np.eye(more.shape[-1])
    if found.ndim == 2:
        lose(found, np.isinf(most))
    return found


def lose(covariance: np.ndarray, lost: np.ndarray) -> None:
    """Make variances infinite, and their covariances no numbers."""
    covariance[lost] = np.nan
    covariance[:, lost] = np.nan
    covariance[lost, lost] = np.inf
