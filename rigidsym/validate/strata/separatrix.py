"""Motions on the separatrix exactly, and at any distance from it.

With moments low < middle < high it is low (middle - low) x^2 = high (high - middle) z^2 for the
rates x and z about the outer axes, whatever the rate about the middle one.
"""

import math
from fractions import Fraction
from functools import cache
from random import Random

from rigidsym.validate.strata.bodies import body, mixed
from rigidsym.validate.strata.sample import Motion
from rigidsym.validate.strata.spread import decade, exact_decade

_MOST = 60
# The factors below leave room for products with numbers up to _MOST in 53 bits.
_BITS = 46
Point = tuple[list[int], tuple[int, int]]


@cache
def points() -> tuple[Point, ...]:
    """Every body of coprime whole moments up to _MOST, with the least whole rates x and z."""
    found = []
    for high in range(3, _MOST + 1):
        for middle in range(2, high):
            for low in range(max(1, high - middle), middle):
                slow, fast = high * (high - middle), low * (middle - low)
                common = math.gcd(slow, fast)
                x, z = math.isqrt(slow // common), math.isqrt(fast // common)
                square = (x * x, z * z) == (slow // common, fast // common)
                if square and math.gcd(low, middle, high) == 1:
                    found.append(([low, middle, high], (x, z)))
    return tuple(found)


def _exact(random: Random) -> tuple[list[float], list[float]]:
    """Doubles of many digits on the separatrix, axes by inertia."""
    whole, (x, z) = random.choice(points())
    moment, rate = ((random.getrandbits(_BITS) | 1) * 2.0**-_BITS for _ in range(2))
    middle = random.choice((0.0, 1e-3, 1.0, 1.0, 1e3)) * random.gauss(0, 1)
    return [moment * c for c in whole], [x * rate, middle, z * rate]


def exact(random: Random, index: int) -> Motion:
    """Doubles that are on the separatrix exactly."""
    return mixed(random, *_exact(random))


def beside(random: Random, index: int) -> Motion:
    """One ulp of one number away from the separatrix."""
    inertia, omega = _exact(random)
    numbers = random.choice((inertia, omega))
    k = random.choice((0, 1, 2)) if numbers is inertia else random.choice((0, 2))
    numbers[k] = math.nextafter(numbers[k], random.choice((-1, 1)) * math.inf)
    return mixed(random, inertia, omega)


def near(random: Random, index: int) -> Motion:
    """One rate is away from the separatrix by 1e-1 to 1e-16 of itself."""
    low, middle, high = sorted(body(random))
    fast = random.uniform(0.3, 1)
    slow = fast * math.sqrt(high * (high - middle) / (low * (middle - low)))
    slow *= 1 + random.choice((-1, 1)) * decade(index, 1, 16)
    return mixed(random, [low, middle, high], [slow, random.gauss(0, 1), fast])


def nearest(random: Random, index: int) -> Motion:
    """One rate is away from the separatrix by 1e-17 to 1e-250 of itself."""
    inertia, (x, z) = random.choice(points())
    distance = random.choice((-1, 1)) * exact_decade(index, 17, 250)
    middle = Fraction(random.randint(1, 999), 100)
    return mixed(random, list(map(Fraction, inertia)), [x * (1 + distance), middle, Fraction(z)])
