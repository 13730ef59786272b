"""From a start to the minimum beside it: SciPy's least squares with the derived derivatives."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from rigidsym.errors import InputError
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

LOSSES = ("linear", "soft_l1", "huber", "cauchy", "arctan")
_MOST_STEPS = 200
_TOLERANCES = {"xtol": 1e-12, "ftol": 1e-12, "gtol": 1e-12}
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
    basis = np.eye(problem.parameters.count) if within is None else within
    seen: dict[bytes, tuple[np.ndarray, np.ndarray]] = {}

    def evaluated(z: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        key = z.tobytes()
        if key not in seen:
            seen.clear()
            x = basis @ z
            point = problem.parameters.moved(start, x)
            found, slopes = problem.linearised(point, problem.parameters.own(point, x))
            if not (np.isfinite(found).all() and np.isfinite(slopes).all()):
                raise _NotFiniteError
            seen[key] = found, slopes @ basis
        return seen[key]

    # MINPACK is the faster, but knows no losses, and needs as many residuals as parameters.
    plain = loss == "linear" and problem.count >= basis.shape[1]
    try:
        found = least_squares(
            lambda z: evaluated(z)[0],
            np.zeros(basis.shape[1]),
            jac=lambda z: evaluated(z)[1],
            method="lm" if plain else "trf",
            x_scale="jac",
            loss=loss,
            max_nfev=_MOST_STEPS,
            **_TOLERANCES,
        )
    except _NotFiniteError:
        return Local(start, np.inf, False, _NOT_FINITE)
    point = problem.parameters.moved(start, basis @ found.x)
    return Local(point, 2 * float(found.cost), found.status > 0, _reason(found.status))


class _NotFiniteError(ArithmeticError):
    """There are no states."""


def _reason(status: int) -> str:
    if status > 0:
        return "a minimum"
    return f"no minimum within {_MOST_STEPS} steps"
