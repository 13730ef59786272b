"""Polynomial approximation of e^x for x <= 0, with a proved error bound.

    e^x = 2^n e^r,    n = the whole number nearest to x/log 2,    r = x - n log 2
    e^r = 1 + (r + r^2 (1/2 + r E(r))),    |r| <= 0.3467

log 2 is carried as two numbers, the first so short that n times it is exact.
The coefficients of E interpolate at Chebyshev's points, and are rounded.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from math import factorial

import mpmath
from flint import arb

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Constant, Function, let
from rigidsym._codegen.special_functions.polynomials import DIGITS, distance, fitted, horner

_RANGE = Fraction(-3467, 10_000), Fraction(3467, 10_000)


def function(binary: Format = BINARY64) -> Function:
    """Build the function that computes e^x for x <= 0 without branches.

    Loops that call it can be vectorised.
    """
    lets = (
        let("bounded = choose(least, x, x, least)", "DLMF 4.8"),
        let("n = nearest(bounded*log_2_inverse)", "DLMF 4.8"),
        let("r = (bounded - n*log_2_short) - n*log_2_rest", "DLMF 4.2.19"),
        let(f"rest = {horner('r', _names(binary))}", "DLMF 4.2.19"),
        let("grown = 1 + (r + r*r*(half + r*rest))", "DLMF 4.2.19"),
        let("value = choose(least, x, power_of_two(n)*grown, 0)", "DLMF 4.8"),
    )
    return Function("_exponential", "e^x for x <= 0.", ("x",), lets, ("value",))


def constants(binary: Format = BINARY64) -> list[Constant]:
    """Return the named constants of the exponential: coefficients, and log 2 in two parts."""
    with mpmath.workdps(DIGITS):
        short = mpmath.floor(mpmath.ln2 * 2**binary.log_2) / 2**binary.log_2
        numbers = {
            "least": (binary.least_exponential, "e^x is taken for 0 below it"),
            "log_2_inverse": (binary.rounded(1 / mpmath.ln2), "1/log 2"),
            "log_2_short": (float(short), "log 2, its first digits"),
            "log_2_rest": (binary.rounded(mpmath.ln2 - short), "log 2, the others"),
            "half": (0.5, "1/2"),
        }
    terms = zip(_names(binary), coefficients(binary), strict=True)
    numbers |= {name: (term, f"e^r, r^{k + 3}") for k, (name, term) in enumerate(terms)}
    return [Constant(name, value, None, meaning) for name, (value, meaning) in numbers.items()]


def _names(binary: Format) -> list[str]:
    return [f"exponential_{k}" for k in range(binary.exponential)]


@cache
def coefficients(binary: Format = BINARY64) -> tuple[float, ...]:
    """Return the coefficients of the polynomial E in the approximation of e^r, lowest first."""

    def tail(r: mpmath.mpf) -> mpmath.mpf:
        return sum(r**n / mpmath.factorial(n + 3) for n in range(60))

    with mpmath.workdps(DIGITS):
        return tuple(map(binary.rounded, fitted(tail, *_RANGE, binary.exponential)))


def bound(terms: Sequence[float]) -> float:
    """Bound the relative error of the polynomial approximation of e^r.

    It is |1 + r + r^2/2 + r^3 E(r) - e^r|/e^r.
    """
    return distance(
        terms,
        lambda k: arb(1) / factorial(k + 3),
        *_RANGE,
        weight=lambda r: abs(r) ** 3 * (-r).exp(),
    )
