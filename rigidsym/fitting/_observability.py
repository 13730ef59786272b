"""Observability of parameters: linear errors and unobservable directions.

A change of the parameters by their natural size (1 rad, the rates as they are, the moments as they
are) is observable where it moves the residuals by more than their errors together.  Directions in
which it does not, by the singular values of the derivatives, are null directions: the linear errors
say nothing there, and a parameter that has a part in them is unobservable.

The residuals are linearised again at displaced parameters, because linear errors may be too small
where the residuals are curved.  These are, along each principal axis of the errors and to both
sides: one error away, two errors away, and the point between where the volume spanned by the
derivatives passes through zero, if there is one, since a direction is unobservable there; and half
the natural size along each null direction.  Where the error of a quantity is more than twice as
large at one of them, it is used instead; where it is as large as it can be, the quantity is
unobservable.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from rigidsym.fitting._minimise import blocks
from rigidsym.fitting._parameters import Point
from rigidsym.fitting._problem import Problem

# Least singular value of an observable direction.
_DETERMINED = 1.0
# Distances at which errors are computed again: in units of the errors, and of natural sizes.
_REACH, _HALF = (1.0, 2.0), 0.5
# Factor by which errors have to be larger there to count.
_LARGER = 2.0
# Part of a unit direction that has to be null somewhere.
_MOSTLY = 0.5
# Factor by which second-order errors have to exceed linear ones to replace them.
_BENT = 2.0

Rows = Callable[[Point], np.ndarray]


@dataclass(frozen=True, slots=True)
class Errors:
    """The linear errors of p parameters at a point.

    determined (p, a): independent errors of unit size in observable directions; undetermined (p,
    b): null directions, at their natural size; null (b, p): their unit directions, in units of the
    natural sizes.
    """

    point: Point
    natural: np.ndarray
    determined: np.ndarray
    undetermined: np.ndarray
    null: np.ndarray

    def covariance(self, rows: np.ndarray) -> np.ndarray:
        """Return the covariance (k, k) of quantities that depend on the parameters.

        rows (k, p): their derivatives by the parameters.  A variance is infinite, and its
        covariances NaN, where null directions, at their natural size, contribute more than the
        determined ones.
        """
        determined, undetermined = rows @ self.determined, rows @ self.undetermined
        found = determined @ determined.T
        lose(found, np.sum(undetermined**2, axis=1) > np.diag(found))
        return found

    def variance(self, rows: np.ndarray) -> np.ndarray:
        """Return the variances (k,) of quantities with derivatives (k, p).

        They are infinite where null directions dominate.
        """
        undetermined = np.sum((rows @ self.undetermined) ** 2, axis=-1)
        determined = np.sum((rows @ self.determined) ** 2, axis=-1)
        most = np.sum((rows * self.natural) ** 2, axis=-1)
        return np.where(
            undetermined > np.maximum(determined, _MOSTLY**2 * most),
            np.inf,
            determined + undetermined,
        )

    def widest(self, rows: np.ndarray) -> np.ndarray:
        """Return covariances of quantities, with null directions counted as errors.

        Their shape is (..., k, k), for derivatives (..., k, p).
        """
        both = rows @ np.hstack([self.determined, self.undetermined])
        return both @ np.swapaxes(both, -2, -1)


@dataclass(frozen=True)
class Observability:
    """The linear errors of a fit at a minimum of chi2.

    It also has the residuals (M,) and their derivatives (M, p).
    """

    problem: Problem
    here: Errors
    residuals: np.ndarray
    slopes: np.ndarray

    @cached_property
    def basis(self) -> np.ndarray:
        """Return an orthonormal basis (M, a) of the residual changes that parameters cause."""
        return self.slopes @ self.here.determined

    @cached_property
    def displaced(self) -> tuple[Errors, ...]:
        """Return the linear errors at several points displaced from the minimum.

        The docstring of the module describes the displacements.
        """
        errors, sides = self.here.determined.T, (1.0, -1.0)
        ways = np.array([side * one for side in sides for one in errors])
        ways = ways.reshape(-1, errors.shape[1])
        null = [side * _HALF * one for side in sides for one in self.here.undetermined.T]
        found = list(self._at([*(reach * x for reach in _REACH for x in ways), *null]))
        start = np.linalg.det(self.basis.T @ self.basis) if len(errors) else 0.0
        # Zeros of the volume, by linear interpolation between points where its sign changes.
        zeros = []
        for k, way in enumerate(ways):
            volumes = [start, *(found[k + place * len(ways)][1] for place in range(len(_REACH)))]
            for (a, one), (b, other) in pairwise(zip((0.0, *_REACH), volumes, strict=True)):
                if one * other < 0:
                    zeros.append((a + one / (one - other) * (b - a)) * way)
        return tuple(one for one, _ in (*found, *self._at(zeros)) if one)

    def _at(self, steps: list[np.ndarray]) -> Iterator[tuple[Errors | None, float]]:
        """Yield the linear errors, and the volume that derivatives span, after each parameter step.

        The volume is spanned by the changes of residuals by one error each way, projected onto
        these changes at the minimum.  Without states, the errors are None and the volume is NaN.
        """
        if not steps:
            return
        start = self.here.point.repeated(len(steps))
        for some in blocks(self.problem, self.problem.parameters.stepped(start, np.array(steps))):
            own = self.problem.parameters.linear_derivatives(some)
            _, slopes = self.problem.linearised(some, own)
            for k, one in enumerate(slopes):
                if not np.isfinite(one).all():
                    yield None, np.nan
                    continue
                volume = float(np.linalg.det(self.basis.T @ one @ self.here.determined))
                yield _errors(self.problem, some[k], one), volume

    @cached_property
    def null(self) -> np.ndarray:
        """Return orthonormal directions (k, p) that are unobservable at the minimum or near it.

        They are in units of the natural sizes.
        """
        every = np.vstack([self.here.null, *(one.null for one in self.displaced)])
        _, sizes, right = np.linalg.svd(every, full_matrices=False)
        return right[sizes > _MOSTLY]

    def covariance(self, rows: Rows) -> np.ndarray:
        """Return the covariance (k, k) of quantities that depend on the parameters.

        rows: returns the derivatives (k, p) of the quantities at a point.
        """
        found = self.here.covariance(rows(self.here.point))
        there = (one.variance(rows(one.point)) for one in self.displaced)
        return _widened(found, there)

    def widest(self, rows: Rows) -> np.ndarray:
        """Return covariances (..., k, k) of quantities, with null directions counted as errors.

        rows: returns the derivatives (..., k, p) of the quantities at a point.
        """
        found = self.here.widest(rows(self.here.point))
        there = (one.widest(rows(one.point)) for one in self.displaced)
        return _widened(found, (np.einsum("...ii->...i", x) for x in there))


def observability(problem: Problem, point: Point) -> Observability:
    """Compute the linear errors and unobservable directions at a minimum of chi2.

    All directions are null directions where the motion has no states.
    """
    residuals, slopes = problem.linearised(point, problem.parameters.linear_derivatives(point))
    if not np.isfinite(residuals).all() or not np.isfinite(slopes).all():
        slopes = np.zeros_like(slopes)
    return Observability(problem, _errors(problem, point, slopes), residuals, slopes)


def _errors(problem: Problem, point: Point, slopes: np.ndarray) -> Errors:
    natural = problem.parameters.natural_sizes(point, problem.span)
    rows = np.vstack([slopes * natural, np.zeros((len(natural), len(natural)))])
    _, sizes, right = np.linalg.svd(np.linalg.qr(rows, "r"))
    determined = sizes > _DETERMINED
    return Errors(
        point,
        natural,
        natural[:, None] * right[determined].T / sizes[determined],
        natural[:, None] * right[~determined].T,
        right[~determined],
    )


def _widened(covariance: np.ndarray, variances: Iterator[np.ndarray]) -> np.ndarray:
    """Raise variances in covariance matrices wherever the given variances are much larger.

    Covariances have the shape (..., k, k), the given variances (..., k).

    The addition is independent, so that no combination of quantities has a smaller variance.
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
    """Set some variances of a covariance matrix to infinity and their covariances to NaN.

    The matrix is changed in place.
    """
    covariance[lost] = np.nan
    covariance[:, lost] = np.nan
    covariance[lost, lost] = np.inf


def is_bent(sigma: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """Return for each linear error (12,) if second-order effects of axis errors exceed it.

    sigma: of turn, rates, moments and axes; omega (3,): rates.  A turn theta of the principal axes
    changes rates along them by theta x omega, which linear errors contain, and by theta x (theta x
    omega) / 2, which they do not; turns combine as theta_j theta_k / 2.  Axes of nearly equal
    moments may be off by a radian, where the second is no less; errors of the axes are cut off at 1
    rad.
    """
    axes = np.minimum(np.nan_to_num(sigma[9:], nan=1.0), 1.0)
    turns = (np.prod(axes) / np.maximum(axes, np.finfo(float).tiny)) / 2
    speed = np.abs(omega)
    others = np.sum(axes**2) - axes**2
    rates = (axes * (axes @ speed - axes * speed) + others * speed) / 2
    return np.concatenate([turns, rates, np.zeros(3), turns]) > _BENT * sigma
