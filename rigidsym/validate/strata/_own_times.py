"""Published motions, and functions that draw special times of a motion.

These are at zeros of rates and at quarter periods.  A rate about the middle axis is zero where the
argument of the Jacobi functions is an even number of quarter periods K(m), and a third one where it
is an odd number; the rate about the axis that the motion circulates about never is.
"""

import math
import tomllib
from fractions import Fraction
from functools import cache
from importlib import resources
from random import Random
from typing import Any

from mpmath import mp, mpf

from rigidsym.io.cases import paper_case
from rigidsym.motion import IDENTITY
from rigidsym.precise import PreciseMotion
from rigidsym.validate.strata._sample import MAX_ANGLE, Floats, Motion, fractions, late, turns

_ENOUGH = 10
_DIGITS = 25


def paper(random: Random, index: int) -> Motion:
    """Return the motion of the paper's spacecraft, with its decimals rounded to doubles."""
    exact = paper_case().motion.exact
    return Motion(*(tuple(map(float, values)) for values in exact.values()))


def paper_times(random: Random, index: int, motion: Motion) -> Floats:
    """Return every tenth of the paper's times, followed by late times."""
    return tuple(map(float, paper_case().times[::10])) + late(Random("paper"), motion, 50)


@cache
def published() -> tuple[dict[str, Any], ...]:
    """Return the motions in published.toml, with numbers as they were printed."""
    text = resources.files("rigidsym.validate.strata").joinpath("published.toml").read_text("utf-8")
    return tuple(tomllib.loads(text)["motion"])


def published_motion(random: Random, index: int) -> Motion:
    """Return the published motion with a given index.

    Decimals become doubles where these are equal.
    """
    entry = published()[index]
    exact = ([Fraction(x) for x in entry[name]] for name in ("inertia", "omega0", "attitude0"))
    return Motion(*(tuple(float(x) if Fraction(float(x)) == x else x for x in y) for y in exact))


def published_times(random: Random, index: int, motion: Motion) -> Floats:
    """Return the published times of a motion, their negatives, and late times."""
    known = {sign * float(Fraction(t)) for t in published()[index]["times"] for sign in (-1, 1)}
    listed = (0.0, *sorted(known))
    some = (listed + turns(50)(random, index, motion)[1:])[: max(len(listed), _ENOUGH)]
    return some + late(random, motion, 50)


def zeros(random: Random, index: int, motion: Motion) -> Floats:
    """Return times just before and after the zeros of body rates.

    They are one ulp to 1e-9 away.  The last zero of each rate, where an ulp is a hundredth of a
    radian, is enclosed by two more.
    """
    quarter, origin = _quarter_and_origin(motion)

    def zero(number: int) -> mpf:
        """Return a time at which a body rate is zero.

        The rate is that about the middle axis for even numbers, and that about the third axis for
        odd ones.
        """
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
    """Return times just before and after early and late multiples of the quarter period."""
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
    """Return the quarter period and the time of zero elliptic argument, both in s."""
    exact = PreciseMotion(fractions(motion.inertia), fractions(motion.omega0), fractions(IDENTITY))
    known = exact.constants(("lambda_", "u", "k_c"), _DIGITS)
    with mp.workdps(_DIGITS + 5):
        argument = mp.pi / (2 * mp.agm(1, known["k_c"]))
        return argument / known["lambda_"], -known["u"] / known["lambda_"]


def _neighbours(time: mpf) -> tuple[float, float]:
    """Return the doubles just before and after a time, the nearest first."""
    nearest = float(time)
    return nearest, math.nextafter(nearest, math.inf if nearest < time else -math.inf)
