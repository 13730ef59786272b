"""Minima of a problem: Levenberg-Marquardt steps for many starts at once, SciPy for single ones."""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from scipy.optimize import least_squares

from rigidsym.errors import InputError
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
    """Return chi2 of motions (B,); infinite where there are no states."""
    parts = [_sum(problem.residuals(some), robust) for some in blocks(problem, point)]
    return np.concatenate(parts)


def refine(
    problem: Problem, point: Point, rounds: int, robust: bool = False
) -> tuple[Point, np.ndarray]:
    """Return motions (B,) nearer to the minima beside them, and their chi2.

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
    """Return chi2 (B,), J^T J (B, p, p) and J^T r (B, p)."""
    residuals, slopes = problem.linearised(point, problem.parameters.derivatives(point))
    cost = _sum(residuals, robust)
    good = np.isfinite(cost) & np.isfinite(slopes).all(axis=(1, 2))
    cost[~good], residuals[~good], slopes[~good] = np.inf, 0.0, 0.0
    if robust:
        weight = 1 / np.sqrt(1 + residuals**2)
        residuals, slopes = weight * residuals, weight[..., None] * slopes
    transposed = np.swapaxes(slopes, 1, 2)
    return cost, transposed @ slopes, (transposed @ residuals[..., None])[..., 0]


def _step(matrix: np.ndarray, slope: np.ndarray, damping: np.ndarray) -> np.ndarray:
    """Return steps (B, p), shortened where they are long."""
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
    """Return motions (B,) in groups whose states with sensitivities fit into memory."""
    size = max(1, _BLOCK // problem.times.size)
    return [point[k : k + size] for k in range(0, point.count, size)]


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
    """A minimum, or where the search for it ended.

    cost: SciPy's, twice; it is chi2 for the linear loss.
    """

    point: Point
    cost: float
    converged: bool
    reason: str


def checked_loss(loss: str) -> str:
    """Return the name of a loss; raise InputError for others."""
    if loss not in LOSSES:
        raise InputError("loss", repr(loss), f"must be one of: {', '.join(LOSSES)}")
    return loss


def minimise(
    problem: Problem, start: Point, loss: str = "linear", within: np.ndarray | None = None
) -> Minimum:
    """Return the minimum beside a start.

    loss: SciPy's name of a function of the squares; with those that are not linear outliers count
    less, from one standard deviation on. within: columns (p, k) of the parameters that may move;
    all of them by default.
    """
    start = problem.parameters.inner(start)
    basis = np.eye(problem.parameters.count) if within is None else within
    evaluated = _Evaluated(problem, start, basis)
    if not np.isfinite(evaluated(np.zeros(basis.shape[1]))[0]).all():
        return Minimum(start, np.inf, False, _NOT_FINITE)
    # MINPACK is faster, but has no losses, needs as many residuals as parameters, and does not step
    # back from where there are no states, as the trust region does.
    plain = loss == "linear" and problem.count >= basis.shape[1]
    found = _solved(evaluated, "lm", loss) if plain else None
    found = found or _solved(evaluated, "trf", loss)
    if found is None:
        return Minimum(start, np.inf, False, _NOT_FINITE)
    point = problem.parameters.moved(start, basis @ found.x)
    natural = problem.parameters.natural_sizes(point, problem.span) @ basis
    still = found.status > 0 or _decrease(found.fun, found.jac * natural) < _FALL
    return Minimum(point, 2 * float(found.cost), still, "a minimum" if still else _NO_MINIMUM)


@dataclass(slots=True)
class _Evaluated:
    """Residuals and their derivatives, cached for the last point."""

    problem: Problem
    start: Point
    basis: np.ndarray
    at: bytes = b""
    found: tuple[np.ndarray, np.ndarray] = (np.empty(0), np.empty(0))

    @np.errstate(all="ignore")
    def __call__(self, z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if z.tobytes() != self.at:
            x = self.basis @ z
            point = self.problem.parameters.moved(self.start, x)
            own = self.problem.parameters.derivatives(point, x)
            residuals, slopes = self.problem.linearised(point, own)
            self.at, self.found = z.tobytes(), (residuals, slopes @ self.basis)
        return self.found

    @property
    def scale(self) -> np.ndarray:
        """Return the scale of the parameters at the start.

        MINPACK's first step may go as far as 100 scales move the residuals linearly, which has to
        be as far as their own size.
        """
        residuals, slopes = self(np.zeros(self.basis.shape[1]))
        sizes = np.linalg.norm(slopes, axis=0)
        far = max(1.0, float(np.linalg.norm(residuals)) / _FIRST_STEP)
        return far / np.where(sizes > 0, sizes, 1.0)


def _solved(evaluated: _Evaluated, method: Literal["lm", "trf"], loss: str) -> Any:
    """Return SciPy's result; None where it reaches motions that have no states."""

    def residuals(z: np.ndarray) -> np.ndarray:
        found, _ = evaluated(z)
        if method == "lm" and not np.isfinite(found).all():
            raise _NotFiniteError
        return found

    def slopes(z: np.ndarray) -> np.ndarray:
        _, found = evaluated(z)
        if not np.isfinite(found).all():
            raise _NotFiniteError
        return found

    try:
        return least_squares(
            residuals,
            np.zeros(evaluated.basis.shape[1]),
            jac=slopes,
            method=method,
            x_scale=evaluated.scale if method == "lm" else "jac",
            loss=loss,
            max_nfev=_MOST_STEPS,
            **_TOLERANCES,
        )
    except _NotFiniteError:
        return None


class _NotFiniteError(ArithmeticError):
    """A motion that has no states."""


def _decrease(residuals: np.ndarray, slopes: np.ndarray) -> float:
    """Return the decrease of chi2 by one more Gauss-Newton step, in observable directions.

    slopes (M, k): by parameters in their natural sizes.  Directions whose errors are beyond those
    sizes are left out, because valleys of chi2 are curved there.
    """
    left, sizes, _ = np.linalg.svd(slopes, full_matrices=False)
    return float(np.sum((residuals @ left[:, sizes > 1]) ** 2))
