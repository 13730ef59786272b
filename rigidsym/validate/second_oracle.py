"""The second oracle: Taylor series of the equations of motion, which know no elliptic function."""

import math
from fractions import Fraction

from rigidsym import inputs
from rigidsym.precise.balls import ball, bits_of, working
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.taylor import integrate
from rigidsym.validate.oracle import decades_below_one

# Digits asked of the series, and what they have to agree to, of 1 or of |omega0|.
DIGITS, AGREEMENT = 20, 1e-20
# How far they go, rad: their cost grows with it.
REACH = 1.0
# Two cases in so many are checked: the first two of each stratum, which are its ends, among them.
SHARE = 256


def disagreement(motion: PreciseMotion, backwards: bool) -> float:
    """The largest difference of a number from its ball after REACH radians, over AGREEMENT."""
    inertia, omega0, attitude0 = motion.exact
    rate = math.hypot(*map(float, omega0)) or 1.0
    time = Fraction(-REACH / rate if backwards else REACH / rate)
    series = integrate(inertia, omega0, attitude0, time, DIGITS)
    digits = DIGITS + decades_below_one(omega0)
    ((q, omega),) = motion.enclosures([time], digits)
    with working(bits_of(2 * digits)):
        sizes = (1, ball(Fraction(rate)))
        differences = [
            abs(balls - ball(inputs.exact("series", x))) / size
            for part, numbers, size in zip((q, omega), series, sizes, strict=True)
            for balls, x in zip(part, numbers, strict=True)
        ]
        found = [float(x.upper()) for x in differences]
    return math.inf if any(map(math.isnan, found)) else max(found) / AGREEMENT


def is_due(index: int) -> bool:
    """Whether a case of a stratum is one that is checked."""
    return index % SHARE in (0, 1)
