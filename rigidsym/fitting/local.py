"""From a start to the minimum beside it: SciPy's least squares with the derived derivatives."""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from scipy.optimize import least_squares

from rigidsym.errors import InputError
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

LOSSES = ("linear", "soft_l1", "huber", "cauchy", "arctan")
_MOST_STEPS = 300
_TOLERANCES = {"xtol": 1e-10, "ftol": 1e-10, "gtol": 1e-10}
# Of chi2: what makes no difference, where steps get shorter and shorter in a bent valley.
_FALL = 0.1
# MINPACK's, in scales of the parameters.
_FIRST_STEP = 100.0
_NO_MINIMUM = f"no minimum within {_MOST_STEPS} steps"
_NOT_FINITE = "the motion has no states at the times of observation"


@dataclass(frozen=True, slots=True)
class Local:
    """A minimum, or where the search for it ended: cost is that of SciPy, chi2 where linear."""

    point: Point
    cost: float
    converged: bool
    reason: str


def checked_loss(loss: str) -> str:
    """The name of a loss; raises InputError for others."""
    if loss not in LOSSES:
        raise InputError("loss", repr(loss), f"must be one of: {', '.join(LOSSES)}")
    return loss


def local(
    problem: Problem, start: Point, loss: str = "linear", within: np.ndarray | None = None
) -> Local:
    """The minimum beside a start.

    loss: what is summed of the squares, by SciPy's names; those that are not linear let outliers
    count less, from one standard deviation on.  within: columns (p, k) of the parameters that may
    move; all of them by default.
    """
    start = problem.parameters.inner(start)
    basis = np.eye(problem.parameters.count) if within is None else within
    evaluated = _Evaluated(problem, start, basis)
    if not np.isfinite(evaluated(np.zeros(basis.shape[1]))[0]).all():
        return Local(start, np.inf, False, _NOT_FINITE)
    # MINPACK is the faster, but knows no losses, needs as many residuals as parameters, and does
    # not step back from where there are no states, as the trust region does.
    plain = loss == "linear" and problem.count >= basis.shape[1]
    found = _solved(evaluated, "lm", loss) if plain else None
    found = found or _solved(evaluated, "trf", loss)
    if found is None:
        return Local(start, np.inf, False, _NOT_FINITE)
    point = problem.parameters.moved(start, basis @ found.x)
    natural = problem.parameters.natural(point, problem.span) @ basis
    still = found.status > 0 or _left(found.fun, found.jac * natural) < _FALL
    return Local(point, 2 * float(found.cost), still, "a minimum" if still else _NO_MINIMUM)


@dataclass(slots=True)
class _Evaluated:
    """Residuals and their derivatives, kept for where they were last asked for."""

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
            own = self.problem.parameters.own(point, x)
            residuals, slopes = self.problem.linearised(point, own)
            self.at, self.found = z.tobytes(), (residuals, slopes @ self.basis)
        return self.found

    @property
    def scale(self) -> np.ndarray:
        """Of the parameters at the start: MINPACK's first step may take residuals 100 scales of
        theirs away, which has to be as far as they are."""
        residuals, slopes = self(np.zeros(self.basis.shape[1]))
        sizes = np.linalg.norm(slopes, axis=0)
        far = max(1.0, float(np.linalg.norm(residuals)) / _FIRST_STEP)
        return far / np.where(sizes > 0, sizes, 1.0)


def _solved(evaluated: _Evaluated, method: Literal["lm", "trf"], loss: str) -> Any:
    """What SciPy finds; None where it gets where there are no states."""

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
    """There are no states."""


def _left(residuals: np.ndarray, slopes: np.ndarray) -> float:
    """What chi2 would fall by in one more step of Gauss and Newton, in directions that are told.

    slopes (M, k): by parameters in their natural sizes.  Beyond those sizes errors have all there
    is within them, and valleys of chi2 bend.
    """
    left, sizes, _ = np.linalg.svd(slopes, full_matrices=False)
    return float(np.sum((residuals @ left[:, sizes > 1]) ** 2))
