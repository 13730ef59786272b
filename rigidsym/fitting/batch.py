"""Levenberg and Marquardt's steps for many starts at once; SciPy's one start is for the end."""

import numpy as np

from rigidsym.fitting.parameters import Point, joined
from rigidsym.fitting.problem import Problem

# States with sensitivities at a time: some hundred megabytes.
_BLOCK = 1 << 16
_FIRST, _MORE, _LESS, _LEAST, _MOST = 1e-2, 10.0, 0.2, 1e-10, 1e8
_SMALL = 1e-9
# A step that gains less of chi2 is the last.
_GAIN = 1e-5
# A step may change shapes by a factor e^2, and turn by no more rad.
_LONGEST = 2.0


def chi2(problem: Problem, point: Point, robust: bool = False) -> np.ndarray:
    """Of motions (B,); infinite where there are no states."""
    parts = [_sum(problem.residuals(some), robust) for some in blocks(problem, point)]
    return np.concatenate(parts)


def refine(
    problem: Problem, point: Point, rounds: int, robust: bool = False
) -> tuple[Point, np.ndarray]:
    """Motions (B,) nearer to the minima beside them, and their chi2.

    robust: sums of log(1 + r^2), so that outliers lead nobody astray.
    """
    found = [_refined(problem, some, rounds, robust) for some in blocks(problem, point)]
    return joined(one for one, _ in found), np.concatenate([cost for _, cost in found])


def _refined(problem: Problem, point: Point, rounds: int, robust: bool) -> tuple[Point, np.ndarray]:
    fields = Point(*(x.copy() for x in (point.attitude, point.omega, point.moments, point.mount)))
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
        for old, moved in zip(_parts(fields), _parts(tried), strict=True):
            old[row] = moved[better]
        cost[row], matrix[row], slope[row] = new[better], squares[better], slopes[better]
        damping[going] *= np.where(better, _LESS, _MORE)
        np.maximum(damping, _LEAST, out=damping)
        still = damping[going] < _MOST
        still[better] &= gain > _GAIN * (1 + cost[row])
        going = going[still]
    return fields, cost


def _parts(point: Point) -> tuple[np.ndarray, ...]:
    return point.attitude, point.omega, point.moments, point.mount


def _normal(
    problem: Problem, point: Point, robust: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """chi2 (B,), J^T J (B, p, p) and J^T r (B, p)."""
    residuals, slopes = problem.linearised(point, problem.parameters.own(point))
    cost = _sum(residuals, robust)
    good = np.isfinite(cost) & np.isfinite(slopes).all(axis=(1, 2))
    cost[~good], residuals[~good], slopes[~good] = np.inf, 0.0, 0.0
    if robust:
        weight = 1 / np.sqrt(1 + residuals**2)
        residuals, slopes = weight * residuals, weight[..., None] * slopes
    transposed = np.swapaxes(slopes, 1, 2)
    return cost, transposed @ slopes, (transposed @ residuals[..., None])[..., 0]


def _step(matrix: np.ndarray, slope: np.ndarray, damping: np.ndarray) -> np.ndarray:
    """Steps (B, p), cut where they are long."""
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


def blocks(problem: Problem, point: Point) -> list[Point]:
    """Motions (B,) in groups whose states with sensitivities fit into memory."""
    size = max(1, _BLOCK // problem.times.size)
    return [point[k : k + size] for k in range(0, point.count, size)]
