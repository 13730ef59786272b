"""The table of all strata, and the functions that draw their motions.

A nearly symmetric body circulates about one of its two similar axes only where it hardly turns
about the third; in some cases it does that little, by the root of what the moments differ by.

With moments low < middle < high a motion is on the separatrix where
low (middle - low) x^2 = high (high - middle) z^2, for the rates x and z about the outer axes and
any rate about the middle one.
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from random import Random
from typing import Any

from rigidsym.validate.strata import _own_times as own_times
from rigidsym.validate.strata._sample import (
    MAX_ANGLE,
    Body,
    Motion,
    Numbers,
    Stratum,
    decade,
    exact_decade,
    spread,
    turns,
)

ORDERS = tuple(permutations(range(3)))
SIGNS = tuple(product((1, -1), repeat=3))


# Any motion


def body(random: Random) -> list[float]:
    """Draw random principal moments that a rigid body can have."""
    x, y, z = (random.uniform(0.05, 1) for _ in range(3))
    return [y + z, z + x, x + y]


def rates(random: Random) -> list[float]:
    """Draw three random body rates."""
    return [random.gauss(0, 1) for _ in range(3)]


def decimals(random: Random) -> list[Fraction]:
    """Draw three random decimals with exact values."""
    return [Fraction(random.choice((-1, 1)) * random.randint(1, 999), 1000) for _ in range(3)]


def mixed(
    random: Random, inertia: Sequence[float | Fraction], omega: Sequence[float | Fraction]
) -> Motion:
    """Permute the axes of a motion at random, with random signs of its rates."""
    return _ordered(inertia, omega, random.choice(ORDERS), random.choice(SIGNS))


def _ordered(
    inertia: Sequence[float | Fraction],
    omega: Sequence[float | Fraction],
    order: Sequence[int],
    signs: Sequence[int],
) -> Motion:
    flipped = tuple(sign * omega[k] for sign, k in zip(signs, order, strict=True))
    return Motion(tuple(inertia[k] for k in order), flipped)


def uniform(random: Random, index: int) -> Motion:
    """Draw a motion with a random body and random rates."""
    return mixed(random, body(random), rates(random))


def every_order_and_sign(random: Random, index: int) -> Motion:
    """Draw motions with each of the 48 orders of axes and signs of rates in turn."""
    order = index % len(ORDERS)
    sign = (index // len(ORDERS) + order) % len(SIGNS)
    positive = [random.uniform(0.1, 1) for _ in range(3)]
    return _ordered(sorted(body(random)), positive, ORDERS[order], SIGNS[sign])


def rest(random: Random, index: int) -> Motion:
    """Draw a motion of a random body at rest."""
    return Motion(tuple(body(random)), (0.0, 0.0, 0.0))


def scaled(inertia: float, rate: float) -> Body:
    """Return a function that draws random motions and scales their inertia and rates."""

    def draw(random: Random, index: int) -> Motion:
        motion = uniform(random, index)
        moments: Numbers = tuple(inertia * x for x in motion.inertia)
        return Motion(moments, tuple(rate * x for x in motion.omega0))

    return draw


def any_scale(random: Random, index: int) -> Motion:
    """Draw a motion with moments and rates of extremely different scales.

    Moments are scaled by 1e-200 to 1e200, and rates by 1e-250 to 1e250.
    """
    inertia = 10.0 ** spread(index, -200, 200)
    rate = 10.0 ** spread(index, 250, -250, base=3)
    return scaled(inertia, rate)(random, index)


# At an edge

# The rates of a symmetric body that are not zero; its last axis is that of symmetry.
PATTERNS = ((1, 1, 1), (1, 0, 1), (0, 1, 1), (1, 1, 0), (0, 0, 1), (1, 0, 0))
_GRID = 2.0**-40


def symmetric(random: Random, index: int) -> Motion:
    """Draw a motion of a symmetric body, prolate or oblate in turn.

    Some rates are often zero.
    """
    third = random.uniform(0.1, 0.99) if index % 2 else random.uniform(1.01, 2)
    pattern = PATTERNS[index // 4 % len(PATTERNS)] if index // 2 % 2 else PATTERNS[0]
    omega = [x * some for x, some in zip(rates(random), pattern, strict=True)]
    size = random.uniform(0.5, 1)
    # Twice an exact half is the whole, so that a disc stays flat and no flatter.
    return mixed(random, [size, size, min(size * third, 2 * size)], omega)


def sphere(random: Random, index: int) -> Motion:
    """Draw a motion of a body with three equal moments."""
    return Motion((random.uniform(0.1, 2),) * 3, tuple(rates(random)))


def flat(random: Random, index: int) -> Motion:
    """Draw a motion of a flat body, two of whose moments add up exactly to the third."""
    x, y = (random.randint(2**35, 2**40) * _GRID for _ in range(2))
    return mixed(random, [x, y, x + y], rates(random))


def spin(random: Random, index: int) -> Motion:
    """Draw a spin of a random body about one axis, each axis in turn."""
    omega = [0.0, 0.0, 0.0]
    omega[index % 3] = random.gauss(0, 1)
    return mixed(random, sorted(body(random)), omega)


# Near an edge, over as many decades as doubles or exact decimals have

# 1 + 10^-15.6 is the double after 1.
_LAST = 15.6
# The least share of a rate whose square still keeps the separatrix as far as the modules follow.
_FAINTEST = Fraction(1, 10**125)


def near_prolate(random: Random, index: int) -> Motion:
    """Draw a motion of a nearly prolate body.

    The relative difference of its larger moments is 1e-1 to 2e-16.
    """
    split = decade(index, 1, _LAST)
    lone, *others = rates(random)
    lone *= random.choice((1, 1, math.sqrt(split)))
    return mixed(random, [random.uniform(0.15, 0.95), 1.0, 1 + split], [lone, *others])


def near_oblate(random: Random, index: int) -> Motion:
    """Draw a motion of a nearly oblate body.

    The relative difference of its smaller moments is 1e-1 to 2e-16.
    """
    split = decade(index, 1, _LAST)
    *others, lone = rates(random)
    lone *= random.choice((1, 1, math.sqrt(split)))
    return mixed(random, [1.0, 1 + split, random.uniform(1.15, 2)], [*others, lone])


def near_sphere(random: Random, index: int) -> Motion:
    """Draw a motion of a nearly spherical body.

    The relative differences of its moments are 1e-1 to 2e-16.
    """
    size = decade(index, 1, 15)
    return mixed(random, [1 + size * random.uniform(-1, 1) for _ in range(3)], rates(random))


def nearest_symmetric(random: Random, index: int) -> Motion:
    """Draw a motion of a body so nearly symmetric that doubles cannot represent it.

    Two moments differ by a power of ten from 1e-17 to 1e-300.
    """
    third = random.choice((random.randint(15, 95), random.randint(115, 200)))
    split = exact_decade(index, 17, 300)
    *others, lone = decimals(random)
    lone *= random.choice((1, 1, max(_FAINTEST, exact_decade(index, 9, 150))))
    inertia = _sized(random, [Fraction(1), 1 + split, Fraction(third, 100)])
    return mixed(random, inertia, [*others, lone])


def nearest_sphere(random: Random, index: int) -> Motion:
    """Draw a motion of a body so nearly spherical that doubles cannot represent it.

    Its moments differ by multiples of a power of ten, 1e-17 to 1e-250.
    """
    step = exact_decade(index, 17, 250)
    inertia = _sized(random, [1 + k * step for k in random.sample(range(-9, 10), 3)])
    return mixed(random, inertia, decimals(random))


def exact_decimals(random: Random, index: int) -> Motion:
    """Draw a motion whose inputs are exact decimals.

    Moments differ by 1e-2 to 1e-19, or the motion is on the separatrix.
    """
    if index % 3 == 0:
        inertia = [Fraction(x, 10) for x in (4, 5, 9)]
        omega = [Fraction(3, 10), Fraction(random.randint(-99, 99), 100), Fraction(1, 10)]
    else:
        step = exact_decade(index, 2, 19)
        inertia = _sized(random, [1 + random.randint(-9, 9) * step for _ in range(3)])
        omega = decimals(random)
    return mixed(random, inertia, omega)


def _sized(random: Random, inertia: list[Fraction]) -> list[Fraction]:
    """Multiply moments by a random decimal.

    No difference of them is then a sum of two doubles.
    """
    size = Fraction(random.randint(1, 999), 1000)
    return [size * moment for moment in inertia]


def near_spin(axis: int, last: float) -> Body:
    """Return a function that draws slightly tilted spins about one axis.

    The tilt is 1e-1 to 10^-last.
    """

    def draw(random: Random, index: int) -> Motion:
        tilt = decade(index, 1, last)
        first = random.uniform(0.1, 1)
        second = random.choice((1, 1, 1, 0)) * random.uniform(0.1, 1)
        omega = random.sample((tilt * first, tilt * second), 2)
        omega.insert(axis, random.uniform(0.3, 3))
        return mixed(random, sorted(body(random)), omega)

    return draw


def rod(random: Random, index: int) -> Motion:
    """Draw a motion of a rod, one moment of which is far smaller than the others.

    It is 1e-1 to 1e-15 of them.
    """
    thin = decade(index, 1, 15)
    inertia = [thin, 1.0, 1 + thin * random.uniform(0.1, 0.9)]
    return mixed(random, inertia, rates(random))


def needle(random: Random, index: int) -> Motion:
    """Draw a motion of an extremely thin rod in exact decimals.

    One moment is 1e-1 to 1e-59 of the others.
    """
    thin = exact_decade(index, 1, 59)
    inertia = [thin, Fraction(1), 1 + thin * Fraction(random.randint(1, 10), 10)]
    return mixed(random, _sized(random, inertia), rates(random))


# On the separatrix, and at any distance from it

_MOST = 60
# The factors below leave room for products with numbers up to _MOST in 53 bits.
_BITS = 46
Point = tuple[list[int], tuple[int, int]]


@cache
def points() -> tuple[Point, ...]:
    """Return motions exactly on the separatrix, by whole-number moments and rates.

    Moments are coprime and at most _MOST; the rates x, z are the least that are whole.
    """
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


def _on_separatrix(random: Random) -> tuple[list[float], list[float]]:
    """Draw moments and rates as doubles that are exactly on the separatrix.

    Axes are sorted by inertia.
    """
    whole, (x, z) = random.choice(points())
    moment, rate = ((random.getrandbits(_BITS) | 1) * 2.0**-_BITS for _ in range(2))
    middle = random.choice((0.0, 1e-3, 1.0, 1.0, 1e3)) * random.gauss(0, 1)
    return [moment * c for c in whole], [x * rate, middle, z * rate]


def separatrix(random: Random, index: int) -> Motion:
    """Draw a motion that is exactly on the separatrix and whose inputs are doubles."""
    return mixed(random, *_on_separatrix(random))


def beside_separatrix(random: Random, index: int) -> Motion:
    """Draw a motion one ulp beside the separatrix.

    One number of a motion on the separatrix is changed.
    """
    inertia, omega = _on_separatrix(random)
    numbers = random.choice((inertia, omega))
    k = random.choice((0, 1, 2)) if numbers is inertia else random.choice((0, 2))
    numbers[k] = math.nextafter(numbers[k], random.choice((-1, 1)) * math.inf)
    return mixed(random, inertia, omega)


def near_separatrix(random: Random, index: int) -> Motion:
    """Draw a motion near the separatrix.

    One rate is off the separatrix by 1e-1 to 1e-16 of itself.
    """
    low, middle, high = sorted(body(random))
    fast = random.uniform(0.3, 1)
    slow = fast * math.sqrt(high * (high - middle) / (low * (middle - low)))
    slow *= 1 + random.choice((-1, 1)) * decade(index, 1, 16)
    return mixed(random, [low, middle, high], [slow, random.gauss(0, 1), fast])


def nearest_separatrix(random: Random, index: int) -> Motion:
    """Draw a motion so near the separatrix that doubles cannot represent it.

    One rate is off the separatrix by 1e-17 to 1e-250 of itself.
    """
    inertia, (x, z) = random.choice(points())
    distance = random.choice((-1, 1)) * exact_decade(index, 17, 250)
    middle = Fraction(random.randint(1, 999), 100)
    return mixed(random, list(map(Fraction, inertia)), [x * (1 + distance), middle, Fraction(z)])


def branch_switch(random: Random, index: int) -> Motion:
    """Draw a motion near the switch between the two kinds of series in numeric modules.

    Its k_1^2 is near 1/2. k_1 is the modulus after one Landen step.  The modules use circular
    series up to k_1^2 = 1/2 and hyperbolic ones beyond: the truncation errors of both are largest
    there.
    """
    c_a, c_b, c_d = moments = sorted(body(random), reverse=random.choice((True, False)))
    k_1 = math.sqrt((1 + random.choice((-1, 1)) * decade(index, 0.5, 16)) / 2)
    # The rates are A dn, B sn and D cn, with A = 1.
    m = 1 - ((1 - k_1) / (1 + k_1)) ** 2
    size_d = math.sqrt(m * c_a * (c_a - c_b) / (c_d * (c_b - c_d)))
    size_b = size_d * math.sqrt(c_d * (c_a - c_d) / (c_b * (c_a - c_b)))
    sn, cn = math.sin(phase := random.uniform(-math.pi, math.pi)), math.cos(phase)
    return mixed(random, moments, [math.sqrt(1 - m * sn * sn), size_b * sn, size_d * cn])


def with_quarter_periods(random: Random, index: int) -> Motion:
    """Draw a motion to be tested at its quarter periods.

    The body is any one or nearly symmetric, or the motion is near the separatrix.  Some rates start
    at 0.
    """
    bodies = uniform, near_separatrix, near_prolate, near_oblate
    motion = bodies[index % len(bodies)](random, index // len(bodies))
    if index % 5:
        return motion
    omega = list(motion.omega0)
    omega[random.randrange(3)] = 0.0
    return Motion(motion.inertia, tuple(omega))


# Numbers people type, and numbers at the ends of what doubles and quaternions can be

BODIES = (
    *((1, 1, 1), (1, 1, 2), (1, 2, 2), (1, 2, 3), (2, 3, 4), (2, 3, 5), (3, 4, 5)),
    *((2, 4, 4), (4, 4, 8), (4, 5, 9), (4, 8, 9), (5, 8, 12), (16, 16, 1), (7, 7, 7)),
)
VALUES = tuple(product(BODIES, product((1.0, -0.0, -1.0, 2.0, 0.5, 3.0), repeat=3)))
# Coprime to the number of values, so that it visits them all, and neighbours are far apart.
_STRIDE = 1237

_UNITS = tuple(
    tuple(sign if k == place else 0.0 for k in range(4)) for place in range(4) for sign in (1, -1)
)
_MORE = ((1.0, 1.0, 0.0, 0.0), (1.0, 1.0, 1.0, 1.0), (1.0, 1e-150, 0.0, -0.0), (-1e-20, 1, 1, 1))
ATTITUDES = tuple(
    tuple(float(length * x) for x in direction)
    for length in (1.0, 1e-150, 1e150, 3.0, 1e-300, 1e300)
    for direction in (*_UNITS, *_MORE)
)


def special_values(random: Random, index: int) -> Motion:
    """Draw a motion with small whole moments and simple rates.

    There are equal ones, zeros and negative zeros among them.
    """
    inertia, omega = VALUES[index * _STRIDE % len(VALUES)]
    return Motion(tuple(map(float, inertia)), omega)


def special_attitudes(random: Random, index: int) -> Motion:
    """Draw a motion with a special initial attitude, such as half a turn.

    Attitudes are no turn or half a turn, with quaternions of any length.
    """
    motion = uniform(random, index)
    return Motion(motion.inertia, motion.omega0, ATTITUDES[index * 31 % len(ATTITUDES)])


def extreme_scales(random: Random, index: int) -> Motion:
    """Draw a motion with moments and rates up to the limits of doubles.

    Moments are whole numbers times powers of two.
    """
    whole, _ = VALUES[random.randrange(len(VALUES))]
    exponent = round(spread(index, -1074, 1018))
    inertia = [math.ldexp(x, exponent) for x in whole]
    scale = 10.0 ** spread(index, -298, 297, base=3)
    omega = [scale * x for x in rates(random)]
    return mixed(random, inertia, omega)


# The table of the strata: what a stratum covers, its motions, its times unless they reach 50 rad
# evenly, and the number of its cases if it is finite.

# Near the separatrix the body lingers for long before it turns over.
_TO_50, _TO_300, _TO_3000 = map(turns, (50, 300, 3000))
_TABLE: dict[str, tuple[str, Body, *tuple[Any, ...]]] = {
    "paper": ("the paper's body as doubles", own_times.paper, own_times.paper_times, 1),
    "published": (
        "motions published by others, as exact decimals, at the published times and late ones",
        own_times.published_motion,
        own_times.published_times,
        len(own_times.published()),
    ),
    "axis orders and signs": (
        "every order of the axes and every quadrant of rates",
        every_order_and_sign,
        _TO_50,
        len(ORDERS) * len(SIGNS),
    ),
    "uniform": ("any body, any rates", uniform),
    "near separatrix": ("doubles 1e-1 to 1e-16 from the separatrix", near_separatrix, _TO_300),
    "beside separatrix": ("doubles one ulp from the separatrix", beside_separatrix, _TO_300),
    "nearest separatrix": (
        "exact decimals 1e-17 to 1e-250 from the separatrix",
        nearest_separatrix,
        _TO_3000,
    ),
    "separatrix": ("doubles on the separatrix exactly", separatrix, _TO_300),
    "symmetric": ("two equal moments, both kinds, some rates zero", symmetric),
    "near prolate": ("the larger moments differ by 1e-1 to 2e-16", near_prolate),
    "near oblate": ("the smaller moments differ by 1e-1 to 2e-16", near_oblate),
    "nearest symmetric": (
        "exact decimals: two moments differ by 1e-17 to 1e-300, both kinds",
        nearest_symmetric,
    ),
    "sphere": ("three equal moments", sphere),
    "near sphere": ("moments differ by 1e-1 to 2e-16", near_sphere),
    "nearest sphere": ("exact decimals: moments differ by 1e-17 to 1e-250", nearest_sphere),
    "spin": ("spin about each axis exactly", spin),
    "near spin, largest": (
        "spin about the axis of largest inertia, tilted by 1e-1 to 1e-300",
        near_spin(2, 300),
        turns(100),
    ),
    "near spin, middle": (
        "spin about the middle axis, tilted by 1e-1 to 1e-85",
        near_spin(1, 85),
        _TO_3000,
    ),
    "near spin, smallest": (
        "spin about the axis of smallest inertia, tilted by 1e-1 to 1e-300",
        near_spin(0, 300),
        turns(100),
    ),
    "rest": ("no rates", rest),
    "flat": ("the largest moment is exactly the sum of the others", flat),
    "rod": ("one moment is 1e-1 to 1e-15 of the others", rod),
    "needle": ("exact decimals: one moment is 1e-1 to 1e-59 of the others", needle),
    "special values": (
        "small whole moments, rates equal, powers of two, zeros and negative zeros",
        special_values,
        _TO_50,
        len(VALUES),
    ),
    "special attitudes": (
        "half turns and no turns, of lengths 1e-300 to 1e300",
        special_attitudes,
        _TO_50,
        len(ATTITUDES),
    ),
    "scales": ("moments by 1e-200 to 1e200, rates by 1e-250 to 1e250", any_scale),
    "small scales": ("moments by 1e-9, rates by 1e-12", scaled(1e-9, 1e-12)),
    "large scales": ("moments by 1e12, rates by 1e6", scaled(1e12, 1e6)),
    "extreme scales": (
        "whole moments by 2^-1074 to 2^1018, rates by 1e-298 to 1e297",
        extreme_scales,
    ),
    "decimals": (
        "exact decimals: moments differ by 1e-2 to 1e-19, or a separatrix",
        exact_decimals,
        turns(100),
    ),
    "long times": ("any body, evenly up to 1e6 rad", uniform, turns(1e6)),
    "longest times": ("any body, evenly up to 2^46 rad", uniform, turns(MAX_ANGLE)),
    "near separatrix, long": (
        "doubles 1e-1 to 1e-16 from the separatrix, evenly up to 2^46 rad",
        near_separatrix,
        turns(MAX_ANGLE),
    ),
    "branch switch": (
        "k_1^2 within 3e-1 to 1e-16 of 1/2, where the series change, up to 2^46 rad",
        branch_switch,
        turns(MAX_ANGLE),
    ),
    "zeros of the rates": (
        "on both sides of a zero of each rate that has any, from 1 ulp to 1e-9 away",
        with_quarter_periods,
        own_times.zeros,
    ),
    "quarter periods": (
        "on both sides of 1, 2, ... quarter periods, up to 2^46 rad",
        with_quarter_periods,
        own_times.quarters,
    ),
}
STRATA = {
    name: Stratum(name, about, body, *(rest or [_TO_50]))
    for name, (about, body, *rest) in _TABLE.items()
}
