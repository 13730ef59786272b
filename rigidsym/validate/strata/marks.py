"""Times at the marks of a motion: where a rate goes through zero, and whole quarter periods.

A rate about the middle axis is zero where the argument of the Jacobi functions is an even number
of quarter periods K(m), and a third one where it is an odd number; the rate about the axis that
the motion circulates about never is.
"""

import math
from dataclasses import dataclass
from random import Random

from mpmath import mp, mpf

from rigidsym.motion import IDENTITY
from rigidsym.precise import PreciseMotion
from rigidsym.validate.strata import near, separatrix
from rigidsym.validate.strata.bodies import uniform
from rigidsym.validate.strata.sample import Floats, Motion, fractions
from rigidsym.validate.strata.times import MAX_ANGLE, turning

_DIGITS = 25
_BODIES = (uniform, separatrix.near, near.prolate, near.oblate)


@dataclass(frozen=True, slots=True)
class Marks:
    """The quarter period, and when the argument of the Jacobi functions was zero, both in s."""

    quarter: mpf
    origin: mpf

    def zero(self, number: int) -> mpf:
        """When the rate about the middle axis is zero, for even numbers, or the third one is."""
        with mp.workdps(_DIGITS + 5):
            return self.origin + number * self.quarter

    def multiple(self, number: int) -> mpf:
        """A whole number of quarter periods."""
        with mp.workdps(_DIGITS + 5):
            return number * self.quarter


def marks(motion: Motion) -> Marks:
    """The marks of a motion that is not steady."""
    exact = PreciseMotion(fractions(motion.inertia), fractions(motion.omega0), fractions(IDENTITY))
    known = exact.constants(("lambda_", "u", "k_c"), _DIGITS)
    with mp.workdps(_DIGITS + 5):
        argument = mp.pi / (2 * mp.agm(1, known["k_c"]))
        return Marks(argument / known["lambda_"], -known["u"] / known["lambda_"])


def body(random: Random, index: int) -> Motion:
    """Any body, or one near the separatrix or near a symmetric one; some rates begin at zero."""
    motion = _BODIES[index % len(_BODIES)](random, index // len(_BODIES))
    if index % 5:
        return motion
    omega = list(motion.omega0)
    omega[random.randrange(3)] = 0.0
    return Motion(motion.inertia, tuple(omega))


def zeros(random: Random, index: int, motion: Motion) -> Floats:
    """t = 0, and around a zero of each rate that has any: ulps away on both sides, and 1e-9.

    And on both sides of the last zero of each, where an ulp is a hundredth of a radian.
    """
    found = marks(motion)
    # The argument begins within two quarter periods of zero: these zeros are never near t = 0.
    half = int(10 ** random.uniform(0, 5)) + 1
    sign = random.choice((-1, 1))
    even, odd = found.zero(sign * 2 * half), found.zero(-sign * (2 * half + 1))
    last = [found.zero(sign * number) for number in _last_zeros(motion, found)]
    return (0.0, *_around(even), *_around(odd), *(t for zero in last for t in _next_to(zero)))


def _last_zeros(motion: Motion, found: Marks) -> tuple[int, int]:
    """The numbers of the last zeros, an even and an odd one, two periods before the end."""
    half = int(MAX_ANGLE / (turning(motion) * float(found.quarter))) // 2 - 4
    return 2 * half, 2 * half + 1


def quarters(random: Random, index: int, motion: Motion) -> Floats:
    """t = 0, and next to the first and to later multiples of the quarter period, both ways."""
    found = marks(motion)
    last = int(MAX_ANGLE / (turning(motion) * float(found.quarter)))
    numbers = [1, random.randint(2, 8), int(last ** random.random()), int(last**0.5), last]
    sign, listed = random.choice((-1, 1)), [0.0]
    for k, number in enumerate(numbers):
        listed += _next_to(found.multiple(sign * (-1) ** k * number))
    return tuple(listed)


def _next_to(time: mpf) -> tuple[float, float]:
    """The doubles on both sides of a time."""
    nearest = float(time)
    return nearest, math.nextafter(nearest, math.inf if nearest < time else -math.inf)


def _around(time: mpf) -> Floats:
    """The doubles next to a time on both sides, one further away, and 1e-9 of it away."""
    nearest, other = _next_to(time)
    further = nearest + 4 * (nearest - other)
    return nearest, other, further, nearest * (1 - 1e-9), nearest * (1 + 1e-9)
