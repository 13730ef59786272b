"""Bodies that can exist, of no special kind, and in any order of their axes."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import permutations, product
from random import Random

from rigidsym.validate.strata.sample import Body, Motion, Numbers
from rigidsym.validate.strata.spread import spread

ORDERS = tuple(permutations(range(3)))
SIGNS = tuple(product((1, -1), repeat=3))


def body(random: Random) -> list[float]:
    """Three moments of a positive mass distribution."""
    x, y, z = (random.uniform(0.05, 1) for _ in range(3))
    return [y + z, z + x, x + y]


def rates(random: Random) -> list[float]:
    """Any rates."""
    return [random.gauss(0, 1) for _ in range(3)]


def placed(
    inertia: Sequence[float | Fraction],
    omega: Sequence[float | Fraction],
    order: Sequence[int],
    signs: Sequence[int],
) -> Motion:
    """The motion with its axes in this order, and its rates with these signs."""
    flipped = tuple(sign * omega[k] for sign, k in zip(signs, order, strict=True))
    return Motion(tuple(inertia[k] for k in order), flipped)


def mixed(
    random: Random, inertia: Sequence[float | Fraction], omega: Sequence[float | Fraction]
) -> Motion:
    """Any order of the axes and any signs."""
    return placed(inertia, omega, random.choice(ORDERS), random.choice(SIGNS))


def uniform(random: Random, index: int) -> Motion:
    """Any body, any rates."""
    return mixed(random, body(random), rates(random))


def every_order_and_sign(random: Random, index: int) -> Motion:
    """All 48 orders of the axes and quadrants of the rates, in turn; both change at each step."""
    order = index % len(ORDERS)
    sign = (index // len(ORDERS) + order) % len(SIGNS)
    positive = [random.uniform(0.1, 1) for _ in range(3)]
    return placed(sorted(body(random)), positive, ORDERS[order], SIGNS[sign])


def rest(random: Random, index: int) -> Motion:
    """A body that does not turn."""
    return Motion(tuple(body(random)), (0.0, 0.0, 0.0))


def scaled(inertia: float, rate: float) -> Body:
    """Any body, in units of inertia and of rates."""

    def draw(random: Random, index: int) -> Motion:
        return _times(uniform(random, index), inertia, rate)

    return draw


def any_scale(random: Random, index: int) -> Motion:
    """Moments by 1e-200 to 1e200 and rates by 1e-250 to 1e250, independently."""
    inertia = 10.0 ** spread(index, -200, 200)
    rate = 10.0 ** spread(index, 250, -250, base=3)
    return _times(uniform(random, index), inertia, rate)


def _times(motion: Motion, inertia: float, rate: float) -> Motion:
    moments: Numbers = tuple(inertia * x for x in motion.inertia)
    return Motion(moments, tuple(rate * x for x in motion.omega0))
