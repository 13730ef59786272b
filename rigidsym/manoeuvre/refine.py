"""From rates that nearly arrive to rates that do: Gauss-Newton for many, SciPy for the chosen."""

import numpy as np
from scipy.optimize import least_squares

from rigidsym.manoeuvre.problem import Problem

# Central differences of this size, relative to the rates, are right to 1e-10.
_DIFFERENCE = 6e-6
# Close to the separatrix, or to a fast spin, these are as good as can be.
FINE = 1e-8
_ROUNDS = 12
_ROUNDING, _LEAST = 3e-15, 3e-16
# States are right to some 1e-16, be turns as small as they may.
_SMALLEST = 1e-3
# Where motions come in one-parameter families the derivatives have rank two.
_SINGULAR = 1e-9
_LONGEST = 0.3
_TOLERANCES = {"xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15}
_SHORTER = (1.0, 0.3, 0.1, 0.01)


def derivatives(problem: Problem, rates: np.ndarray, difference: float = _DIFFERENCE) -> np.ndarray:
    """Of where motions arrive, as rotation vectors, by their rates (N, 3): (N, 3, 3)."""
    size = difference * (1 + np.linalg.norm(rates, axis=-1))[:, None, None]
    beside = rates[:, None, :] + size * np.concatenate([np.eye(3), -np.eye(3)])
    misses = problem.misses(beside)
    return np.swapaxes((misses[:, :3] - misses[:, 3:]) / (2 * size), 1, 2)


def refine(
    problem: Problem, rates: np.ndarray, rounds: int = _ROUNDS, difference: float = _DIFFERENCE
) -> tuple[np.ndarray, np.ndarray]:
    """Rates (N, 3) nearer to arrival, and by what angles (N,) they still miss, rad.

    Steps are cut until they help; rates that none helps stay where they are.
    """
    rates = rates.copy()
    misses = problem.misses(rates)
    angles = np.linalg.norm(misses, axis=1)
    going = np.flatnonzero(angles > _enough(rates))
    for _ in range(rounds):
        if not going.size:
            break
        step = newton(problem, rates[going], misses[going], difference)
        helped = np.zeros(len(going), dtype=bool)
        for share in _SHORTER:
            rest = np.flatnonzero(~helped)
            if not rest.size or (share < 1 and np.all(angles[going[rest]] < _SINGULAR)):
                break
            row = going[rest]
            tried = rates[row] + share * step[rest]
            missed = problem.misses(tried)
            found = np.linalg.norm(missed, axis=1)
            better = found < angles[row]
            row, helped[rest] = row[better], better
            rates[row], misses[row], angles[row] = tried[better], missed[better], found[better]
        going = going[helped]
        going = going[angles[going] > _enough(rates[going])]
    return rates, angles


def smallness(rates: np.ndarray) -> np.ndarray:
    """Of motions with rates (N, 3), (N,): small turns are to arrive to as many digits as others."""
    return np.clip(np.linalg.norm(rates, axis=1), _SMALLEST, 1.0)


def _enough(rates: np.ndarray) -> np.ndarray:
    return np.maximum(_ROUNDING * smallness(rates), _LEAST)


def newton(
    problem: Problem, rates: np.ndarray, misses: np.ndarray, difference: float = FINE
) -> np.ndarray:
    """Steps (N, 3) to arrival, of least length, and no longer than a part of the rates."""
    left, sizes, right = np.linalg.svd(derivatives(problem, rates, difference))
    inverse = 1 / np.maximum(sizes, _SINGULAR * sizes[:, :1])
    step = -np.einsum("nji,nj,nkj,nk->ni", right, inverse, left, misses)
    length = np.linalg.norm(step, axis=1)
    longest = _LONGEST * (1 + np.linalg.norm(rates, axis=1))
    return step * np.minimum(1, longest / np.maximum(length, longest))[:, None]


def polished(problem: Problem, rates: np.ndarray) -> np.ndarray:
    """Rates (3,) as near to arrival as SciPy's least squares bring them."""

    def derivative(rates: np.ndarray) -> np.ndarray:
        return derivatives(problem, rates[None], FINE)[0]

    found = least_squares(problem.misses, rates, jac=derivative, method="lm", **_TOLERANCES).x
    missed = np.linalg.norm(problem.misses(np.array([rates, found])), axis=1)
    return found if missed[1] < missed[0] else rates
