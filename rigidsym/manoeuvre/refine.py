"""From rates that nearly arrive to rates that do, by Gauss-Newton with exact derivatives."""

import numpy as np

from rigidsym.manoeuvre.problem import Problem

_ROUNDS = 12
_ROUNDING, _LEAST = 3e-15, 3e-16
# States are right to some 1e-16, be turns as small as they may.
_SMALLEST = 1e-3
# Where motions come in one-parameter families the derivatives have rank two.
_SINGULAR = 1e-9
_LONGEST = 0.3
_SHORTER = (1.0, 0.3, 0.1, 0.01)


def refine(
    problem: Problem, rates: np.ndarray, rounds: int = _ROUNDS, enough: float = 1.0
) -> tuple[np.ndarray, np.ndarray]:
    """Rates (N, 3) nearer to arrival, and by what angles (N,) they still miss, rad.

    Steps are cut until they help; rates that none helps stay where they are.
    enough: of the angle by which doubles miss at most where they can arrive; 0 for the least.
    """
    rates = rates.copy()
    # Slopes at the rates to be tried cost less than they would in a call of their own.
    misses, slopes = problem.slopes(rates)
    angles = np.linalg.norm(misses, axis=1)
    going = np.flatnonzero(angles > enough * _rounding(rates))
    for _ in range(rounds):
        if not going.size:
            break
        step = newton(rates[going], misses[going], slopes[going])
        helped = np.zeros(len(going), dtype=bool)
        for share in _SHORTER:
            rest = np.flatnonzero(~helped)
            if not rest.size or (share < 1 and np.all(angles[going[rest]] < _SINGULAR)):
                break
            row = going[rest]
            tried = rates[row] + share * step[rest]
            missed, sloped = problem.slopes(tried)
            found = np.linalg.norm(missed, axis=1)
            better = found < angles[row]
            row, helped[rest] = row[better], better
            rates[row], angles[row] = tried[better], found[better]
            misses[row], slopes[row] = missed[better], sloped[better]
        going = going[helped]
        going = going[angles[going] > enough * _rounding(rates[going])]
    return rates, angles


def smallness(rates: np.ndarray) -> np.ndarray:
    """Of motions with rates (N, 3), (N,): small turns are to arrive to as many digits as others."""
    return np.clip(np.linalg.norm(rates, axis=1), _SMALLEST, 1.0)


def _rounding(rates: np.ndarray) -> np.ndarray:
    return np.maximum(_ROUNDING * smallness(rates), _LEAST)


def newton(rates: np.ndarray, misses: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Steps (N, 3) to arrival, of least length, and no longer than a part of the rates.

    Of rates (N, 3), by what they miss (N, 3), and what that changes by with them (N, 3, 3).  None
    where misses grow faster with the rates than binary64 can say.
    """
    known = np.asarray(np.all(np.isfinite(slopes), axis=(1, 2)))
    left, sizes, right = np.linalg.svd(np.where(known[:, None, None], slopes, np.eye(3)))
    # Along a one-parameter family, which misses by rounding alone, there is next to no step.
    inverse = known[:, None] * sizes / np.maximum(sizes, _SINGULAR * sizes[:, :1]) ** 2
    across = np.nan_to_num(misses)[:, None] @ left * inverse[:, None]
    step = -(across @ right)[:, 0]
    length = np.linalg.norm(step, axis=1)
    longest = _LONGEST * (1 + np.linalg.norm(rates, axis=1))
    return step * np.minimum(1, longest / np.maximum(length, longest))[:, None]


def polished(problem: Problem, rates: np.ndarray) -> np.ndarray:
    """Rates (3,) as near to arrival as doubles bring them."""
    return refine(problem, rates[None], enough=0.0)[0][0]
