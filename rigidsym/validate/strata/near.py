"""Bodies and spins near an edge, over as many decades as doubles or exact decimals can say.

A nearly symmetric body circulates about one of its two similar axes only where it hardly turns
about the third; in some cases it does that little, by the root of what the moments differ by.
"""

import math
from fractions import Fraction
from random import Random

from rigidsym.validate.strata.bodies import body, mixed, rates
from rigidsym.validate.strata.sample import Body, Motion
from rigidsym.validate.strata.spread import decade, exact_decade

# 1 + 10^-15.6 is the double after 1.
_LAST = 15.6
# The least share of a rate whose square still keeps the separatrix as far as the modules follow.
_FAINTEST = Fraction(1, 10**125)


def prolate(random: Random, index: int) -> Motion:
    """The two larger moments differ by 1e-1 to 2e-16 of themselves."""
    split = decade(index, 1, _LAST)
    lone, *others = rates(random)
    lone *= random.choice((1, 1, math.sqrt(split)))
    return mixed(random, [random.uniform(0.15, 0.95), 1.0, 1 + split], [lone, *others])


def oblate(random: Random, index: int) -> Motion:
    """The two smaller moments differ by 1e-1 to 2e-16 of themselves."""
    split = decade(index, 1, _LAST)
    *others, lone = rates(random)
    lone *= random.choice((1, 1, math.sqrt(split)))
    return mixed(random, [1.0, 1 + split, random.uniform(1.15, 2)], [*others, lone])


def sphere(random: Random, index: int) -> Motion:
    """Moments that differ by 1e-1 to 2e-16 of themselves."""
    size = decade(index, 1, 15)
    return mixed(random, [1 + size * random.uniform(-1, 1) for _ in range(3)], rates(random))


def exactly_symmetric(random: Random, index: int) -> Motion:
    """Two moments that differ by a power of ten from 1e-17 to 1e-300, both kinds."""
    third = random.choice((random.randint(15, 95), random.randint(115, 200)))
    split = exact_decade(index, 17, 300)
    *others, lone = _decimals(random)
    lone *= random.choice((1, 1, max(_FAINTEST, exact_decade(index, 9, 150))))
    inertia = _sized(random, [Fraction(1), 1 + split, Fraction(third, 100)])
    return mixed(random, inertia, [*others, lone])


def exactly_spherical(random: Random, index: int) -> Motion:
    """Moments that differ by some powers of ten from 1e-17 to 1e-250."""
    step = exact_decade(index, 17, 250)
    inertia = _sized(random, [1 + k * step for k in random.sample(range(-9, 10), 3)])
    return mixed(random, inertia, _decimals(random))


def decimals(random: Random, index: int) -> Motion:
    """Moments that differ by 1e-2 to 1e-19, and now and then a separatrix of decimals."""
    if index % 3 == 0:
        inertia = [Fraction(x, 10) for x in (4, 5, 9)]
        omega = [Fraction(3, 10), Fraction(random.randint(-99, 99), 100), Fraction(1, 10)]
    else:
        step = exact_decade(index, 2, 19)
        inertia = _sized(random, [1 + random.randint(-9, 9) * step for _ in range(3)])
        omega = _decimals(random)
    return mixed(random, inertia, omega)


def _sized(random: Random, inertia: list[Fraction]) -> list[Fraction]:
    """The moments in other units: no sum of two doubles is what they differ by from round ones."""
    size = Fraction(random.randint(1, 999), 1000)
    return [size * moment for moment in inertia]


def _decimals(random: Random) -> list[Fraction]:
    return [Fraction(random.choice((-1, 1)) * random.randint(1, 999), 1000) for _ in range(3)]


def spin(axis: int, last: float) -> Body:
    """Spin about the axis-th smallest inertia, tilted by 1e-1 to 10^-last of itself."""

    def draw(random: Random, index: int) -> Motion:
        tilt = decade(index, 1, last)
        first, second = _some(random), random.choice((1, 1, 1, 0)) * _some(random)
        omega = random.sample((tilt * first, tilt * second), 2)
        omega.insert(axis, random.uniform(0.3, 3))
        return mixed(random, sorted(body(random)), omega)

    return draw


def _some(random: Random) -> float:
    return random.uniform(0.1, 1)


def rod(random: Random, index: int) -> Motion:
    """One moment is 1e-1 to 1e-15 of the others."""
    thin = decade(index, 1, 15)
    inertia = [thin, 1.0, 1 + thin * random.uniform(0.1, 0.9)]
    return mixed(random, inertia, rates(random))


def needle(random: Random, index: int) -> Motion:
    """One moment is 1e-1 to 1e-59 of the others, which differ by less."""
    thin = exact_decade(index, 1, 59)
    inertia = [thin, Fraction(1), 1 + thin * Fraction(random.randint(1, 10), 10)]
    return mixed(random, _sized(random, inertia), rates(random))
