"""All natural motions from start to target up to a given momentum."""

import numpy as np

from rigidsym.manoeuvre.directions import is_symmetry
from rigidsym.manoeuvre.problem import Problem
from rigidsym.manoeuvre.refine import refine
from rigidsym.manoeuvre.search import starts

_ARRIVED = 1e-9
_SAME = 1e-6
_MOST_SPINS = 100


def least(problem: Problem) -> float:
    """A momentum with which some motion arrives.

    Found from turns about the axis of the whole turn; where none leads to a motion it is a bound:
    that turn at constant rates has energy enough for the shortest way, and of all motions with
    an energy the one about the axis of largest moment has the largest momentum (fact
    sorted_body.most_momentum).
    """
    shortest = problem.angle * np.sqrt(problem.axis @ (problem.inertia * problem.axis))
    arrive = _distinct(problem, *refine(problem, _spins(problem, 0.0)))
    return float(min([shortest, *problem.momenta(arrive)]))


def families(problem: Problem, bound: float) -> np.ndarray:
    """All rates (N, 3) that arrive with a momentum up to `bound`, by momentum.

    Of a ring of motions of equal cost, which a turn that is a symmetry of the body has, it is one.
    Raises InputError where a needle has too many.
    """
    near = np.concatenate([_spins(problem, bound), starts(problem, bound)])
    found = _distinct(problem, *refine(problem, near))
    return found[problem.momenta(found) <= bound * (1 + _ARRIVED)]


def _spins(problem: Problem, bound: float) -> np.ndarray:
    """Turns (N, 3) about the axis of the turn, either way and with whole turns more.

    Exact where that is a principal axis, close where the body is nearly a sphere.
    """
    axes = np.eye(3) if problem.angle == 0 else problem.axis[None]
    most = min(bound // (2 * np.pi * problem.momenta(axes).min()), _MOST_SPINS)
    turns = problem.angle + 2 * np.pi * np.arange(-1 - most, 1 + most)
    return (turns[:, None, None] * axes).reshape(-1, 3)


def _distinct(problem: Problem, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Those that arrive, each once, by momentum; of motions of a ring, the first."""
    rates = rates[angles < _ARRIVED]
    order = np.argsort(problem.momenta(rates), kind="stable")
    rates = rates[order]
    compared = problem.momenta(rates)[:, None] if is_symmetry(problem) else rates
    kept: list[int] = []
    for k, value in enumerate(compared):
        apart = np.linalg.norm(compared[kept] - value, axis=-1)
        if np.all(apart > _SAME * (1 + np.linalg.norm(value))):
            kept.append(k)
    return rates[kept]
