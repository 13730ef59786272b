"""Polynomials for sin(pi f) and cos(pi f) with a proved bound for what they leave out.

|f| is at most 1/2 + 2^-7: at |rate t| = 2^46 what rounding leaves of a reduced angle is up to 2^-7.
In z = f^2:

    sin(pi f) = f (pi + z S(z)),    cos(pi f) = 1 + z C(z)

pi is carried as two doubles.  The coefficients interpolate at Chebyshev's points; each is rounded
to a double; the others are found after the first was, and make up for its rounding.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import factorial

import mpmath
from flint import arb
from mpmath import mpf

from rigidsym.codegen.special_functions.polynomials import DIGITS, distance, interpolated

_FARTHEST = Fraction(65, 128)
_RANGE = Fraction(0), _FARTHEST**2


@cache
def sine_coefficients(count: int) -> tuple[float, ...]:
    """The doubles S_0 ... of S, `count` of them."""
    return _fitted(lambda z: _sine_ratio(z) - mpmath.pi, count)


@cache
def cosine_coefficients(count: int) -> tuple[float, ...]:
    """The doubles C_0 ... of C, `count` of them."""
    return _fitted(lambda z: mpmath.cos(mpmath.pi * mpmath.sqrt(z)) - 1, count)


def _sine_ratio(z: mpf) -> mpf:
    f = mpmath.sqrt(z)
    return mpmath.sin(mpmath.pi * f) / f


def _fitted(function: Callable[[mpf], mpf], count: int) -> tuple[float, ...]:
    """Coefficients of a polynomial p with z p(z) near the function."""
    with mpmath.workdps(DIGITS):
        first = float(interpolated(lambda z: function(z) / z, *_RANGE, count)[0])
        rest = interpolated(lambda z: (function(z) / z - first) / z, *_RANGE, count - 1)
        return (first, *map(float, rest))


def sine_bound(coefficients: Sequence[float]) -> float:
    """A bound for |f (pi + z S(z)) - sin(pi f)|."""
    return distance(coefficients, lambda k: _taylor(2 * k + 3), *_RANGE, weight=_sine_weight)


def cosine_bound(coefficients: Sequence[float]) -> float:
    """A bound for |1 + z C(z) - cos(pi f)|."""
    return distance(coefficients, lambda k: _taylor(2 * k + 2), *_RANGE)


def _sine_weight(z: arb) -> arb:
    return abs(z) * _FARTHEST.numerator / _FARTHEST.denominator


def _taylor(power: int) -> arb:
    return (-1) ** (power // 2) * arb.pi() ** power / factorial(power)
