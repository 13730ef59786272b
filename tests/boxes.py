"""Boxes of uncertain inputs, sampled exact motions in them, and checks of enclosures."""

from fractions import Fraction
from random import Random

from flint import arb

from rigidsym import TorqueFreeMotion
from rigidsym._inputs import Uncertain, middle, radius
from rigidsym.precise._balls import working

BODY = ("0.0109", "0.04", "0.0506")
PAPER = (BODY, ("0.05", "0.03", "-0.02"))
ATTITUDE = (1, 2, -3, "0.5")


def numbers(state):
    return [*state[0], *state[1]]


def spread(value, size):
    """Return a number with an uncertainty.

    It is the number itself if the uncertainty is zero.
    """
    return Uncertain(Fraction(value), Fraction(size)) if size else Fraction(value)


def widest(values):
    return max(float(x.rad()) for x in values)


def overlap(one, other):
    return all(x.overlaps(y) for x, y in zip(one, other, strict=True))


def contain(one, other):
    return all(x.contains(y) for x, y in zip(one, other, strict=True))


def distance(one, other):
    return max(abs(x - y) for x, y in zip(one, other, strict=True))


def point_of(motion, choose):
    """Return an exact motion inside a box of uncertain inputs.

    Each number is moved from its middle by `choose()` times its radius.
    """
    given = motion.inertia, motion.omega0, motion.attitude0
    inputs = [[middle(x) + Fraction(choose()) * radius(x) for x in values] for values in given]
    return TorqueFreeMotion(*inputs, allow_nonphysical=True)


def points(motion, count, random=None):
    """Yield random motions inside a box and at its corners, in turn.

    Without a generator the first is the middle of the box.

    random: a generator to continue with.
    """
    if random is None:
        random, count = Random(3), count - 1
        yield point_of(motion, lambda: 0)
    for k in range(count):
        inside, corner = (lambda: random.uniform(-1, 1)), (lambda: random.choice((-1, 1)))
        yield point_of(motion, inside if k % 2 == 0 else corner)


def sharp(motion, time):
    return numbers(motion.enclose(time, 40, method="landen"))


def holds_points(found, motion, time):
    """Return True if balls contain the enclosures of motions sampled from a box."""
    return all(contain(found, numbers(x.enclose(time, 60))) for x in points(motion, 10))


def holds(found, motion, time, count, random=None):
    """Return True if balls contain the states of motions sampled from a box.

    Balls may be too small by twice the radii of the motions' own balls, which are the wider ones
    where all inputs that matter are exact.
    """
    with working(300):
        return all(
            (value + arb(0, 2 * true.rad())).contains(true)
            for point in points(motion, count, random)
            for value, true in zip(found, sharp(point, time), strict=True)
        )
