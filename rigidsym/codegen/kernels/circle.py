"""Polynomials for sin(pi f) and cos(pi f), |f| <= 1/2, with a proved bound for what they leave out.

In z = f^2, over 0 <= z <= 1/4:

    sin(pi f) = f (pi + z S(z)),    cos(pi f) = 1 + z C(z)

pi is carried as two doubles.  The coefficients interpolate at Chebyshev's points;
each is rounded to a double; the others are found after the first was, and make up for its rounding.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import factorial, inf, nextafter
from typing import Any

import mpmath
from flint import arb, ctx, fmpq

_DIGITS = 60
_PIECES = 64
_REACH = Fraction(1, 4)


@cache
def sine_coefficients(count: int) -> tuple[float, ...]:
    """The doubles S_0 ... of S, `count` of them."""
    return _fitted(lambda z: _sine_ratio(z) - mpmath.pi, count)


@cache
def cosine_coefficients(count: int) -> tuple[float, ...]:
    """The doubles C_0 ... of C, `count` of them."""
    return _fitted(lambda z: mpmath.cos(mpmath.pi * mpmath.sqrt(z)) - 1, count)


def _sine_ratio(z: mpmath.mpf) -> mpmath.mpf:
    f = mpmath.sqrt(z)
    return mpmath.sin(mpmath.pi * f) / f


def _fitted(function: Callable[[Any], Any], count: int) -> tuple[float, ...]:
    """Coefficients of a polynomial p with z p(z) near the function on [0, 1/4]."""
    with mpmath.workdps(_DIGITS):
        first = float(_interpolated(lambda z: function(z) / z, count)[0])
        rest = _interpolated(lambda z: (function(z) / z - first) / z, count - 1)
        return (first, *map(float, rest))


def _interpolated(function: Callable[[Any], Any], count: int) -> list[Any]:
    """The coefficients of the polynomial through the function at Chebyshev's points."""
    reach = mpmath.mpf(_REACH.numerator) / _REACH.denominator
    rows, values = mpmath.matrix(count), mpmath.matrix(count, 1)
    for k in range(count):
        z = reach * (1 - mpmath.cos(mpmath.pi * (2 * k + 1) / (2 * count))) / 2
        values[k] = function(z)
        for j in range(count):
            rows[k, j] = z**j
    return list(mpmath.lu_solve(rows, values))


def sine_bound(coefficients: Sequence[float]) -> float:
    """A bound for |f (pi + z S(z)) - sin(pi f)| over |f| <= 1/2, by Taylor series over pieces."""
    terms = [Fraction(0), *map(Fraction, coefficients)]
    return _bound(terms, lambda k: _taylor(2 * k + 1) if k else arb(0)) / 2


def cosine_bound(coefficients: Sequence[float]) -> float:
    """A bound for |1 + z C(z) - cos(pi f)| over |f| <= 1/2."""
    terms = [Fraction(0), *map(Fraction, coefficients)]
    return _bound(terms, lambda k: _taylor(2 * k) if k else arb(0))


def _taylor(power: int) -> arb:
    return (-1) ** (power // 2) * arb.pi() ** power / factorial(power)


def _bound(terms: Sequence[Fraction], taylor) -> float:
    """sup |sum (terms_k - taylor_k) z^k| over [0, 1/4]; what Taylor leaves out is added."""
    before = ctx.prec
    ctx.prec = 300
    try:
        from flint import arb_poly

        length = 30
        difference = arb_poly(
            [
                (arb(fmpq(terms[k].numerator, terms[k].denominator)) if k < len(terms) else 0)
                - taylor(k)
                for k in range(length)
            ]
        )
        radius = arb(fmpq(1, 8 * _PIECES))
        worst = arb(0)
        for piece in range(_PIECES):
            middle = arb(fmpq(2 * piece + 1, 8 * _PIECES))
            shifted = difference(arb_poly([middle, 1]))
            size = sum((abs(shifted[j]) * radius**j for j in range(length)), arb(0))
            worst = max(worst, size.upper(), key=float)
        rest = 2 * abs(taylor(length)) * arb(fmpq(1, 4)) ** length
        return nextafter(float((worst + rest).upper()), inf)
    finally:
        ctx.prec = before
