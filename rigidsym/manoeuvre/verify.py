"""How far the derived solution at thirty digits misses the target, and rates that miss it less."""

from fractions import Fraction

import numpy as np

from rigidsym import inputs
from rigidsym.manoeuvre.manoeuvre import Manoeuvre
from rigidsym.manoeuvre.problem import Problem, between, unit
from rigidsym.manoeuvre.refine import polished
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import rotation_vectors

Rates = tuple[Fraction, ...]

DIGITS = 30
# Doubles are kept where they miss by less, rad; close to the separatrix they may be too coarse.
_ENOUGH = 1e-13
_ROUNDS = 8


def verified(problem: Problem, manoeuvre: Manoeuvre, rates: np.ndarray) -> tuple[Rates, float]:
    """Exact rates in rad/s from rates (3,) of the problem, and by what angle they miss, rad.

    Doubles where these arrive, else decimals of thirty digits.
    """
    duration = manoeuvre.duration or Fraction(1)
    rates = polished(problem, rates)
    exact = tuple(Fraction(x / float(duration)) for x in rates.tolist())
    missed = miss(manoeuvre, exact)
    for _ in range(_ROUNDS):
        if np.linalg.norm(missed) <= _ENOUGH:
            break
        rates = np.array([[float(x * duration) for x in exact]])
        slope = np.linalg.pinv(problem.slopes(rates)[1][0])
        step = [Fraction(x) / duration for x in (slope @ missed).tolist()]
        tried = tuple(_decimals(x - dx) for x, dx in zip(exact, step, strict=True))
        found = miss(manoeuvre, tried)
        if np.linalg.norm(found) >= np.linalg.norm(missed):
            break
        exact, missed = tried, found
    return exact, float(np.linalg.norm(missed))


def miss(manoeuvre: Manoeuvre, rates: Rates) -> np.ndarray:
    """From the target to where exact rates lead, by the derived solution: a rotation vector (3,),
    rad, in the body axes of the start."""
    start, target = manoeuvre.start, manoeuvre.target
    motion = TorqueFreeMotion(manoeuvre.inertia, rates, start)
    q = [inputs.exact("q", x) for x in motion.precise(manoeuvre.duration or Fraction(1), DIGITS)[0]]
    arrived, wanted = between(start, q), between(start, target)
    return rotation_vectors(unit(between(_inverse(arrived), _inverse(wanted))))


def _inverse(quaternion: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    scalar, *vector = quaternion
    return (scalar, *(-x for x in vector))


def _decimals(value: Fraction) -> Fraction:
    return Fraction(inputs.decimal(value, DIGITS))
