"""All natural motions from start to target up to a given momentum."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._problem import Problem
from rigidsym.manoeuvre._refine import newton, refine, smallness
from rigidsym.manoeuvre._search import starts

# Misses of motions that arrive, rad: at once, or where a further step is next to nothing.
_ARRIVED, _NEARLY = 1e-12, 1e-9
_SAME = 1e-6
_ROUNDING = 1e-9
# As many as a plan can have: there may be no other motions.
_MOST_SPINS = 1000
# Whole turns of the two shortest spins, one either way round.
_LESS_THAN_ONE = (-1, 0)


def least(problem: Problem) -> float:
    """Return a momentum with which some motion arrives.

    It is found from turns about the axis of the whole turn; where none arrives it is a bound:
    that turn at constant rates has enough energy for the shortest way, and of all motions with
    an energy the one about the axis of largest moment has the largest momentum (fact
    sorted_body.most_momentum).
    """
    shortest = problem.angle * np.sqrt(problem.axis @ (problem.inertia * problem.axis))
    arrive = _distinct(problem, *_shortest(problem))
    return float(min([shortest, *problem.momenta(arrive)]))


def families(problem: Problem, bound: float) -> np.ndarray:
    """Return all rates (N, 3) that arrive with a momentum up to `bound`, sorted by momentum.

    A one-parameter family, of a turn that is a symmetry of the body, is represented by one motion.
    Raises TooManyError where there are too many to search.
    """
    turn = 2 * np.pi * problem.momenta(_axes(problem)).min()
    most = int(min(bound // turn, _MOST_SPINS))
    longer = _spins(problem, [*range(-1 - most, -1), *range(1, 1 + most)])
    near = np.concatenate([longer, starts(problem, bound)])
    refined = zip(_shortest(problem), refine(problem, near), strict=True)
    found = _distinct(problem, *map(np.concatenate, refined))
    return found[problem.momenta(found) <= bound * (1 + _ROUNDING)]


@lru_cache(1)
def _shortest(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    """Return the refined spins of less than a turn, cached for both callers."""
    return refine(problem, _spins(problem, _LESS_THAN_ONE))


def _spins(problem: Problem, whole: Sequence[int]) -> np.ndarray:
    """Return rates (N, 3) of spins that make the turn and a number of whole turns.

    They arrive where that is a principal axis, and nearly where the body is nearly a sphere.
    """
    turns = problem.angle + 2 * np.pi * np.array(whole, float)
    return (turns[:, None, None] * _axes(problem)).reshape(-1, 3)


def _axes(problem: Problem) -> np.ndarray:
    return np.eye(3) if problem.angle == 0 else problem.axis[None]


def _distinct(problem: Problem, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Return the distinct rates that arrive, sorted by momentum, one of each family."""
    # Of equal ones the one that arrives best is kept.
    order = np.argsort(angles, kind="stable")
    rates = rates[order][_arrive(problem, rates[order], angles[order])]
    compared = problem.momenta(rates)[:, None] if is_symmetry(problem) else rates
    kept: list[int] = []
    for k, value in enumerate(compared):
        apart = np.linalg.norm(compared[kept] - value, axis=-1)
        if np.all(apart > _SAME * (1 + np.linalg.norm(value))):
            kept.append(k)
    found = rates[kept]
    return found[np.argsort(problem.momenta(found), kind="stable")]


def _arrive(problem: Problem, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Return True for each motion (N,) that arrives.

    Close to the separatrix doubles miss by more than rounding, but rates hardly differ from those
    that arrive; where misses hardly depend on the rates it is the other way round.
    """
    arrive = angles <= _ARRIVED * smallness(rates)
    nearly = np.flatnonzero(~arrive & (angles < _NEARLY))
    if nearly.size:
        near = rates[nearly]
        step = np.linalg.norm(newton(near, *problem.slopes(near)), axis=1)
        arrive[nearly] = step < _SAME * smallness(near)
    return arrive
