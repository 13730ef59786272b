"""Times at which a rate goes through zero, and whole quarter periods.

A rate about the middle axis is zero where the argument of the Jacobi functions is an even number
of quarter periods K(m), and a third one where it is an odd number; the rate about the axis that
the motion circulates about never is.
"""

import math
from random import Random

from mpmath import mp, mpf

from rigidsym.motion import IDENTITY
from rigidsym.precise import PreciseMotion
from rigidsym.validate.strata import _motions as motions
from rigidsym.validate.strata._sample import MAX_ANGLE, Floats, Motion, fractions

_DIGITS = 25
_BODIES = motions.uniform, motions.near_separatrix, motions.near_prolate, motions.near_oblate


def body(random: Random, index: int) -> Motion:
    """Draw any body, or one near the separatrix or near a symmetric one; some rates start at 0."""
    motion = _BODIES[index % len(_BODIES)](random, index // len(_BODIES))
    if index % 5:
        return motion
    omega = list(motion.omega0)
    omega[random.randrange(3)] = 0.0
    return Motion(motion.inertia, tuple(omega))


def zeros(random: Random, index: int, motion: Motion) -> Floats:
    """Return t = 0, and times around a zero of each rate that has any: ulps and 1e-9 of it away.

    The last zero of each rate, where an ulp is a hundredth of a radian, is enclosed by two more.
    """
    quarter, origin = _quarter_and_origin(motion)

    def zero(number: int) -> mpf:
        """Return a zero of the rate about the middle axis (even numbers) or of the third one."""
        with mp.workdps(_DIGITS + 5):
            return origin + number * quarter

    # The argument begins within two quarter periods of zero: these zeros are never near t = 0.
    half = int(10 ** random.uniform(0, 5)) + 1
    sign = random.choice((-1, 1))
    listed = [0.0]
    for time in (zero(sign * 2 * half), zero(-sign * (2 * half + 1))):
        nearest, other = _neighbours(time)
        further = nearest + 4 * (nearest - other)
        listed += nearest, other, further, nearest * (1 - 1e-9), nearest * (1 + 1e-9)
    # Two periods before the end.
    last = 2 * (int(MAX_ANGLE / (motion.turning * float(quarter))) // 2 - 4)
    return (*listed, *_neighbours(zero(sign * last)), *_neighbours(zero(sign * (last + 1))))


def quarters(random: Random, index: int, motion: Motion) -> Floats:
    """Return t = 0, and the neighbours of early and late multiples of the quarter period."""
    quarter, _ = _quarter_and_origin(motion)
    last = int(MAX_ANGLE / (motion.turning * float(quarter)))
    numbers = [1, random.randint(2, 8), int(last ** random.random()), int(last**0.5), last]
    sign, listed = random.choice((-1, 1)), [0.0]
    for k, number in enumerate(numbers):
        with mp.workdps(_DIGITS + 5):
            time = sign * (-1) ** k * number * quarter
        listed += _neighbours(time)
    return tuple(listed)


def _quarter_and_origin(motion: Motion) -> tuple[mpf, mpf]:
    """Return the quarter period, and the time at which the argument was zero, both in s."""
    exact = PreciseMotion(fractions(motion.inertia), fractions(motion.omega0), fractions(IDENTITY))
    known = exact.constants(("lambda_", "u", "k_c"), _DIGITS)
    with mp.workdps(_DIGITS + 5):
        argument = mp.pi / (2 * mp.agm(1, known["k_c"]))
        return argument / known["lambda_"], -known["u"] / known["lambda_"]


def _neighbours(time: mpf) -> tuple[float, float]:
    """Return the doubles on both sides of a time, the nearest first."""
    nearest = float(time)
    return nearest, math.nextafter(nearest, math.inf if nearest < time else -math.inf)
