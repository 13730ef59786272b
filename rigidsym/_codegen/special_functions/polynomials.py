"""Polynomials: printing, near-minimax coefficients, and proved error bounds."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from math import inf, nextafter

import mpmath
from flint import arb, arb_poly, ctx, fmpq
from mpmath import mpf

DIGITS = 60
_BITS = 300
_PIECES = 64


def linear(terms: Mapping[str, int]) -> str:
    """Format a linear combination of names with integer coefficients.

    The name "1" stands for the number.

    >>> linear({"1": 1, "a": -4, "b": 1, "c": 0})
    '1 - 4*a + b'
    """
    text = ""
    for name, factor in terms.items():
        if not factor:
            continue
        size = abs(factor)
        term = str(size) if name == "1" else name if size == 1 else f"{size}*{name}"
        if text:
            text += f" {'-' if factor < 0 else '+'} {term}"
        else:
            text = f"-{term}" if factor < 0 else term
    return text or "0"


def horner(variable: str, coefficients: Sequence[str]) -> str:
    """Format a polynomial in Horner's nested form.

    Coefficients are given as text, lowest first.

    >>> horner("x", ["a", "b", "c"])
    'a + x*(b + x*c)'
    """
    first, *rest = coefficients
    if not rest:
        return first
    inner = horner(variable, rest)
    return f"{first} + {variable}*({inner})" if len(rest) > 1 else f"{first} + {variable}*{inner}"


def fitted(
    function: Callable[[mpf], mpf], least: Fraction, most: Fraction, count: int
) -> list[mpf]:
    """Interpolate a function by a polynomial at Chebyshev's points.

    Returns the coefficients, lowest first.
    """
    ends = [mpmath.mpf(x.numerator) / x.denominator for x in (least, most)]
    return mpmath.chebyfit(function, ends, count)[::-1]


def distance(
    terms: Sequence[float],
    series: Callable[[int], arb],
    least: Fraction,
    most: Fraction,
    *,
    length: int = 30,
    weight: Callable[[arb], arb] = abs,
) -> float:
    """Bound the weighted distance between a polynomial and a power series on an interval.

    The result bounds weight(x) |sum terms_k x^k - sum series(k) x^k| over [least, most].

    `weight` takes a ball of x.  Terms of the series fall by half at least from `length` on; the
    rest is expanded about the middles of pieces, in balls.
    """
    with ctx.workprec(_BITS):
        exact = [ball(Fraction(term)) for term in terms] + [arb(0)] * (length - len(terms))
        difference = arb_poly([term - series(k) for k, term in enumerate(exact)])
        width = (most - least) / _PIECES
        worst = arb(0)
        for piece in range(_PIECES):
            middle, radius = ball(least + (piece + Fraction(1, 2)) * width), ball(width / 2)
            shifted = difference(arb_poly([middle, 1]))
            size = sum((abs(shifted[j]) * radius**j for j in range(length)), arb(0))
            rest = 2 * abs(series(length)) * (abs(middle) + radius) ** length
            around = middle + radius * arb(0, 1)
            worst = max(worst, ((size + rest) * weight(around)).upper(), key=float)
        return nextafter(float(worst.upper()), inf)


def ball(value: Fraction) -> arb:
    """Convert a rational number to a ball of Arb's interval arithmetic."""
    return arb(fmpq(value.numerator, value.denominator))
