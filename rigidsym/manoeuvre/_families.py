"""Search for all torque-free motions from start to target up to a given momentum.

Rates that nearly arrive are refined in doubles by Gauss-Newton with exact derivatives.  The derived
solution at thirty digits verifies them, and refines them once more where doubles are too coarse.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._problem import Problem, between, unit
from rigidsym.manoeuvre._search import starts
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import rotation_vectors

Rates = tuple[Fraction, ...]

DIGITS = 30

_ROUNDS = 12
_ROUNDING, _LEAST = 3e-15, 3e-16
# States have an error of some 1e-16, however small the turn.
_SMALLEST = 1e-3
# Where motions come in one-parameter families the derivatives have rank two.
_SINGULAR = 1e-9
_LONGEST = 0.3
_SHORTER = (1.0, 0.3, 0.1, 0.01)
# Doubles are kept where they miss by less, rad; close to the separatrix they may be too coarse.
_ENOUGH = 1e-13
_PRECISE_ROUNDS = 8
# Misses of motions that arrive, rad: at once, or where a further step is next to nothing.
_ARRIVED, _NEARLY = 1e-12, 1e-9
_SAME = 1e-6
_ROOM = 1e-9
# As many as a plan can have: there may be no other motions.
_MOST_SPINS = 1000
# Whole turns of the two shortest spins, one either way round.
_LESS_THAN_ONE = (-1, 0)


def refine(
    problem: Problem, rates: np.ndarray, rounds: int = _ROUNDS, enough: float = 1.0
) -> tuple[np.ndarray, np.ndarray]:
    """Refine initial rates (N, 3) by Gauss-Newton until the motions reach the target.

    Return the rates and the angles (N,) by which they miss it, rad.

    Steps are cut until they help; rates that none helps are kept.  enough: the accepted miss, as a
    multiple of the rounding of doubles; 0 for the least.
    """
    rates = rates.copy()
    # Slopes together with misses cost less than in a call of their own.
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
    """Return factors (N,) that make angular tolerances smaller for small turns."""
    return np.clip(np.linalg.norm(rates, axis=1), _SMALLEST, 1.0)


def _rounding(rates: np.ndarray) -> np.ndarray:
    return np.maximum(_ROUNDING * smallness(rates), _LEAST)


def newton(rates: np.ndarray, misses: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Return the minimum-norm Newton steps (N, 3), limited to a fraction of the rates.

    misses (N, 3), slopes (N, 3, 3): those of the rates (N, 3) and their derivatives.  Steps are
    zero where derivatives are beyond binary64.
    """
    known = np.asarray(np.all(np.isfinite(slopes), axis=(1, 2)))
    left, sizes, right = np.linalg.svd(np.where(known[:, None, None], slopes, np.eye(3)))
    # Along a one-parameter family, where misses are rounding, steps are next to nothing.
    inverse = known[:, None] * sizes / np.maximum(sizes, _SINGULAR * sizes[:, :1]) ** 2
    across = np.nan_to_num(misses)[:, None] @ left * inverse[:, None]
    step = -(across @ right)[:, 0]
    length = np.linalg.norm(step, axis=1)
    longest = _LONGEST * (1 + np.linalg.norm(rates, axis=1))
    return step * np.minimum(1, longest / np.maximum(length, longest))[:, None]


def verified(problem: Problem, manoeuvre: Manoeuvre, rates: np.ndarray) -> tuple[Rates, float]:
    """Refine the initial rates of a motion and verify them at thirty digits.

    Return exact rates in rad/s and the angle by which they miss the target in rad.  The given
    rates (3,) are those of the dimensionless problem.

    They are doubles where these arrive, else decimals of thirty digits.
    """
    duration = manoeuvre.duration or Fraction(1)
    rates = refine(problem, rates[None], enough=0.0)[0][0]
    exact = tuple(Fraction(x / float(duration)) for x in rates.tolist())
    missed = miss(manoeuvre, exact)
    for _ in range(_PRECISE_ROUNDS):
        if np.linalg.norm(missed) <= _ENOUGH:
            break
        rates = np.array([[float(x * duration) for x in exact]])
        slope = np.linalg.pinv(problem.slopes(rates)[1][0])
        step = [Fraction(x) / duration for x in (slope @ missed).tolist()]
        tried = tuple(
            Fraction(inputs.decimal(x - dx, DIGITS)) for x, dx in zip(exact, step, strict=True)
        )
        found = miss(manoeuvre, tried)
        if np.linalg.norm(found) >= np.linalg.norm(missed):
            break
        exact, missed = tried, found
    return exact, float(np.linalg.norm(missed))


def miss(manoeuvre: Manoeuvre, rates: Rates) -> np.ndarray:
    """Return the rotation from the target to the attitude reached from exact initial rates.

    It is a rotation vector (3,), rad, in the body axes of the start.
    """
    start, target = manoeuvre.start, manoeuvre.target
    motion = TorqueFreeMotion(manoeuvre.inertia, rates, start)
    q = [inputs.exact("q", x) for x in motion.precise(manoeuvre.duration or Fraction(1), DIGITS)[0]]
    arrived, wanted = between(start, q), between(start, target)
    return rotation_vectors(unit(between(_inverse(arrived), _inverse(wanted))))


def _inverse(quaternion: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    scalar, *vector = quaternion
    return (scalar, *(-x for x in vector))


def least(problem: Problem) -> float:
    """Return an upper bound of the least momentum with which a motion reaches the target.

    It is found from turns about the axis of the whole turn; where none arrives it is a bound:
    that turn at constant rates has enough energy for the shortest way, and of all motions with
    an energy the one about the axis of largest moment has the largest momentum (fact
    sorted_body.most_momentum).
    """
    shortest = problem.angle * np.sqrt(problem.axis @ (problem.inertia * problem.axis))
    arrive = _distinct(problem, *_shortest(problem))
    return float(min([shortest, *problem.momenta(arrive)]))


def families(problem: Problem, bound: float) -> np.ndarray:
    """Return the initial rates (N, 3) of all motions to the target with momentum <= bound.

    They are sorted by momentum.

    A one-parameter family, of a turn that is a symmetry of the body, is represented by one motion.
    Raises TooManyError where there are too many to search.
    """
    turn = 2 * np.pi * problem.momenta(_axes(problem)).min()
    most = int(min(bound // turn, _MOST_SPINS))
    longer = _spins(problem, [*range(-1 - most, -1), *range(1, 1 + most)])
    near = np.concatenate([longer, starts(problem, bound)])
    refined = zip(_shortest(problem), refine(problem, near), strict=True)
    found = _distinct(problem, *map(np.concatenate, refined))
    return found[problem.momenta(found) <= bound * (1 + _ROOM)]


@lru_cache(1)
def _shortest(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    """Return the refined initial rates of spins through less than a whole turn."""
    return refine(problem, _spins(problem, _LESS_THAN_ONE))


def _spins(problem: Problem, whole: Sequence[int]) -> np.ndarray:
    """Return the rates (N, 3) of spins through the turn to the target plus whole turns.

    They arrive where that is a principal axis, and nearly where the body is nearly a sphere.
    """
    turns = problem.angle + 2 * np.pi * np.array(whole, float)
    return (turns[:, None, None] * _axes(problem)).reshape(-1, 3)


def _axes(problem: Problem) -> np.ndarray:
    return np.eye(3) if problem.angle == 0 else problem.axis[None]


def _distinct(problem: Problem, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Return the distinct motions that reach the target, sorted by momentum.

    Of each one-parameter family there is one.
    """
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
    """Return for each motion whether it reaches the target.

    The result has the shape (N,).

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
