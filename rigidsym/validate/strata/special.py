"""Numbers people type, and numbers at the ends of what doubles and quaternions can be."""

import math
from itertools import product
from random import Random

from rigidsym.validate.strata.bodies import mixed, rates, uniform
from rigidsym.validate.strata.sample import Motion
from rigidsym.validate.strata.spread import spread

BODIES = (
    *((1, 1, 1), (1, 1, 2), (1, 2, 2), (1, 2, 3), (2, 3, 4), (2, 3, 5), (3, 4, 5)),
    *((2, 4, 4), (4, 4, 8), (4, 5, 9), (4, 8, 9), (5, 8, 12), (16, 16, 1), (7, 7, 7)),
)
RATES = (1.0, -0.0, -1.0, 2.0, 0.5, 3.0)
VALUES = tuple(product(BODIES, product(RATES, repeat=3)))
# Coprime to the number of values, so that it visits them all, and neighbours are far apart.
_STRIDE = 1237

_UNITS = tuple(
    tuple(sign if k == place else 0.0 for k in range(4)) for place in range(4) for sign in (1, -1)
)
_MORE = ((1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), (1.0, 1e-150, 0.0, -0.0), (-1e-20, 1, 1, 1))
_LENGTHS = (1.0, 1e-150, 1e150, 3.0, 1e-300, 1e300)
ATTITUDES = tuple(
    tuple(float(length * x) for x in direction)
    for length in _LENGTHS
    for direction in (*_UNITS, *_MORE)
)


def values(random: Random, index: int) -> Motion:
    """Small whole moments and simple rates, equal ones, zeros and negative zeros among them."""
    inertia, omega = VALUES[index * _STRIDE % len(VALUES)]
    return Motion(tuple(map(float, inertia)), omega)


def attitudes(random: Random, index: int) -> Motion:
    """Quaternions of half turns and no turns, of lengths from 1e-300 to 1e300."""
    motion = uniform(random, index)
    return Motion(motion.inertia, motion.omega0, ATTITUDES[index * 31 % len(ATTITUDES)])


def extreme_scales(random: Random, index: int) -> Motion:
    """Moments that begin at the least subnormal and end near the largest double, fast and slow."""
    whole, _ = VALUES[random.randrange(len(VALUES))]
    exponent = round(spread(index, -1074, 1018))
    inertia = [math.ldexp(x, exponent) for x in whole]
    scale = 10.0 ** spread(index, -298, 297, base=3)
    omega = [scale * x for x in rates(random)]
    return mixed(random, inertia, omega)
