"""Minimisation of chi2, by batched Levenberg-Marquardt steps or by SciPy."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any, Literal

import numpy as np
from scipy.optimize import least_squares

from rigidsym.fitting._parameters import Point, joined
from rigidsym.fitting._problem import Problem

# States with sensitivities in one block: some hundred megabytes.
_BLOCK = 1 << 16
# Damping of Levenberg and Marquardt: first, its factors after bad and good steps, and its limits.
_FIRST, _MORE, _LESS, _LEAST, _MOST = 1e-2, 10.0, 0.2, 1e-10, 1e8
# The least scale of a parameter, relative to the largest diagonal entry of J^T J.
_SMALL = 1e-9
# A step that gains less of chi2, relative to 1 + chi2, is the last.
_GAIN = 1e-5
# A step changes logarithms of shapes, and turns, rad, by no more.
_LONGEST = 2.0


def chi2(problem: Problem, point: Point, robust: bool = False) -> np.ndarray:
    """Return the chi2 (B,) of motions.

    It is infinite where a motion has no states.
    """
    every = blocks(problem, point)
    return np.concatenate([_sum(problem.residuals(some), robust) for some in every])


def refine(
    problem: Problem, point: Point, rounds: int, robust: bool = False
) -> tuple[Point, np.ndarray]:
    """Move motions (B,) towards the nearest minima of chi2 by a number of steps.

    Return the motions and their chi2.

    robust: minimise sums of log(1 + r^2), which outliers influence little.
    """
    found = [_refined(problem, some, rounds, robust) for some in blocks(problem, point)]
    return joined(one for one, _ in found), np.concatenate([cost for _, cost in found])


def _refined(problem: Problem, point: Point, rounds: int, robust: bool) -> tuple[Point, np.ndarray]:
    fields = Point(*(x.copy() for x in point.parts))
    cost, matrix, slope = _normal(problem, fields, robust)
    damping = np.full(fields.count, _FIRST)
    going = np.flatnonzero(np.isfinite(cost))
    for _ in range(rounds):
        if not going.size:
            break
        step = _step(matrix[going], slope[going], damping[going])
        tried = problem.parameters.moved(fields[going], step)
        new, squares, slopes = _normal(problem, tried, robust)
        better = new < cost[going]
        row = going[better]
        gain = cost[row] - new[better]
        for old, moved in zip(fields.parts, tried.parts, strict=True):
            old[row] = moved[better]
        cost[row], matrix[row], slope[row] = new[better], squares[better], slopes[better]
        damping[going] *= np.where(better, _LESS, _MORE)
        np.maximum(damping, _LEAST, out=damping)
        still = damping[going] < _MOST
        still[better] &= gain > _GAIN * (1 + cost[row])
        going = going[still]
    return fields, cost


def _normal(
    problem: Problem, point: Point, robust: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the chi2 (B,) of motions and the normal equations of their residuals.

    These are J^T J (B, p, p) and J^T r (B, p).
    """
    residuals, slopes = problem.linearised(point, problem.parameters.derivatives(point))
    cost = _sum(residuals, robust)
    good = np.isfinite(cost) & np.isfinite(slopes).all(axis=(1, 2))
    cost[~good], residuals[~good], slopes[~good] = np.inf, 0.0, 0.0
    if robust:
        weight = 1 / np.sqrt(1 + residuals**2)
        residuals, slopes = weight * residuals, weight[..., None] * slopes
    return cost, *squared(residuals, slopes)


def squared(residuals: np.ndarray, slopes: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the normal equations J^T J and J^T r for residuals r and derivatives J.

    J^T J has the shape (B, p, p), J^T r (B, p), r (B, M).
    """
    transposed = np.swapaxes(slopes, 1, 2)
    return transposed @ slopes, (transposed @ residuals[..., None])[..., 0]


def _step(matrix: np.ndarray, slope: np.ndarray, damping: np.ndarray) -> np.ndarray:
    """Return damped Gauss-Newton steps (B, p) of limited length."""
    own = np.einsum("bii->bi", matrix)
    floor = _SMALL * np.max(own, axis=-1, keepdims=True) + np.finfo(float).tiny
    scale = np.sqrt(np.maximum(own, floor))
    scaled = matrix / (scale[:, :, None] * scale[:, None, :])
    scaled += damping[:, None, None] * np.eye(matrix.shape[-1])
    step = -np.linalg.solve(scaled, (slope / scale)[..., None])[..., 0] / scale
    angles = np.delete(step, [3, 4, 5], axis=1)
    longest = np.max(np.abs(angles), axis=1, initial=0.0)
    return step * (_LONGEST / np.maximum(longest, _LONGEST))[:, None]


def _sum(residuals: np.ndarray, robust: bool) -> np.ndarray:
    with np.errstate(invalid="ignore"):
        squares = residuals**2
        found = np.sum(np.log1p(squares) if robust else squares, axis=-1)
    return np.where(np.isfinite(found), found, np.inf)


def blocks(problem: Problem, point: Point) -> Iterator[Point]:
    """Split motions into groups whose sensitivities fit into memory."""
    size = max(1, _BLOCK // problem.times.size)
    return (point[k : k + size] for k in range(0, point.count, size))


LOSSES = ("linear", "soft_l1", "huber", "cauchy", "arctan")
_MOST_STEPS = 300
_TOLERANCES = {"xtol": 1e-10, "ftol": 1e-10, "gtol": 1e-10}
# Possible decrease of chi2 below which a point counts as a minimum although steps go on, because
# they get shorter and shorter in a curved valley.
_FALL = 0.1
# MINPACK's first step, in scales of the parameters.
_FIRST_STEP = 100.0
_NO_MINIMUM = f"no minimum within {_MOST_STEPS} steps"
_NOT_FINITE = "the motion has no states at the times of observation"


@dataclass(frozen=True, slots=True)
class Minimum:
    """A minimum of chi2, or the point at which the search for it ended.

    cost: twice the cost of SciPy, which is chi2 for the linear loss.
    """

    point: Point
    cost: float
    converged: bool
    reason: str


def minimise(
    problem: Problem, start: Point, loss: str = "linear", within: np.ndarray | None = None
) -> Minimum:
    """Find the minimum of chi2 nearest to a start.

    loss: one of `LOSSES`; with those that are not linear outliers count less, from one standard
    deviation on. within: columns (p, k) of the parameters that may move; all of them by default.
    """
    parameters = problem.parameters
    start = parameters.inner(start)
    basis = np.eye(parameters.count) if within is None else within

    @lru_cache(1)
    @np.errstate(all="ignore")
    def evaluated(z: bytes) -> tuple[np.ndarray, np.ndarray]:
        x = basis @ np.frombuffer(z)
        point = parameters.moved(start, x)
        residuals, slopes = problem.linearised(point, parameters.derivatives(point, x))
        return residuals, slopes @ basis

    origin = np.zeros(basis.shape[1])
    residuals, slopes = evaluated(origin.tobytes())
    if not np.isfinite(residuals).all():
        return Minimum(start, np.inf, False, _NOT_FINITE)
    # MINPACK's first step may go as far as 100 scales move the residuals linearly, which has to be
    # as far as their own size.
    sizes = np.linalg.norm(slopes, axis=0)
    far = max(1.0, float(np.linalg.norm(residuals)) / _FIRST_STEP)
    scale = far / np.where(sizes > 0, sizes, 1.0)

    def solved(method: Literal["lm", "trf"]) -> Any:
        """Minimise chi2 by one of SciPy's methods.

        Return None where SciPy reaches motions that have no states.
        """

        def part(k: int, may_be_infinite: bool, z: np.ndarray) -> np.ndarray:
            found = evaluated(z.tobytes())[k]
            if not (may_be_infinite or np.isfinite(found).all()):
                raise _NotFiniteError
            return found

        try:
            return least_squares(
                partial(part, 0, method == "trf"),
                origin,
                jac=partial(part, 1, False),
                method=method,
                x_scale=scale if method == "lm" else "jac",
                loss=loss,
                max_nfev=_MOST_STEPS,
                **_TOLERANCES,
            )
        except _NotFiniteError:
            return None

    # MINPACK is faster, but has no losses, needs as many residuals as parameters, and does not step
    # back from where there are no states, as the trust region does.
    plain = loss == "linear" and problem.count >= basis.shape[1]
    found = (solved("lm") if plain else None) or solved("trf")
    if found is None:
        return Minimum(start, np.inf, False, _NOT_FINITE)
    point = parameters.moved(start, basis @ found.x)
    natural = parameters.natural_sizes(point, problem.span) @ basis
    # The possible decrease of chi2 by one more Gauss-Newton step.  Directions whose errors are
    # beyond the natural sizes are left out, because valleys of chi2 are curved there.
    left, sizes, _ = np.linalg.svd(found.jac * natural, full_matrices=False)
    fall = float(np.sum((found.fun @ left[:, sizes > 1]) ** 2))
    still = found.status > 0 or fall < _FALL
    return Minimum(point, 2 * float(found.cost), still, "a minimum" if still else _NO_MINIMUM)


class _NotFiniteError(ArithmeticError):
    """Error for a motion whose residuals or derivatives are not finite."""
