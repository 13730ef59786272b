"""Polynomial approximation of e^x for x <= 0, with a proved error bound.

    e^x = 2^n e^r,    n = the whole number nearest to x/log 2,    r = x - n log 2
    e^r = 1 + (r + r^2 (1/2 + r E(r))),    |r| <= 0.3467

log 2 is carried as two doubles, the first so short that n times it is exact for |n| < 2^20.
The coefficients of E interpolate at Chebyshev's points; they are rounded to doubles.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from math import factorial

import mpmath
from flint import arb

from rigidsym._codegen.ir import Constant, Function, let
from rigidsym._codegen.special_functions.polynomials import DIGITS, distance, fitted, horner

TERMS = 9
# 2^-1022 is e^-708.4: where x is below this, 0 is the answer.
_LEAST = -708.0
_RANGE = Fraction(-3467, 10_000), Fraction(3467, 10_000)
_SHORT = 32
_NAMES = [f"exponential_{k}" for k in range(TERMS)]


def function() -> Function:
    """Build the function that computes e^x for x <= 0 without branches.

    Loops that call it can be vectorised.
    """
    lets = (
        let("bounded = choose(least, x, x, least)", "DLMF 4.8"),
        let("n = nearest(bounded*log_2_inverse)", "DLMF 4.8"),
        let("r = (bounded - n*log_2_short) - n*log_2_rest", "DLMF 4.2.19"),
        let(f"rest = {horner('r', _NAMES)}", "DLMF 4.2.19"),
        let("grown = 1 + (r + r*r*(half + r*rest))", "DLMF 4.2.19"),
        let("value = choose(least, x, power_of_two(n)*grown, 0)", "DLMF 4.8"),
    )
    return Function("_exponential", "e^x for x <= 0.", ("x",), lets, ("value",))


def constants() -> list[Constant]:
    """Return the named constants of the exponential: coefficients, and log 2 in two parts."""
    with mpmath.workdps(DIGITS):
        short = mpmath.floor(mpmath.ln2 * 2**_SHORT) / 2**_SHORT
        numbers = {
            "least": (_LEAST, "e^x is taken for 0 below it"),
            "log_2_inverse": (float(1 / mpmath.ln2), "1/log 2"),
            "log_2_short": (float(short), "log 2, its first digits"),
            "log_2_rest": (float(mpmath.ln2 - short), "log 2, the others"),
            "half": (0.5, "1/2"),
        }
    terms = zip(_NAMES, coefficients(TERMS), strict=True)
    numbers |= {name: (term, f"e^r, r^{k + 3}") for k, (name, term) in enumerate(terms)}
    return [Constant(name, value, None, meaning) for name, (value, meaning) in numbers.items()]


@cache
def coefficients(count: int) -> tuple[float, ...]:
    """Return the coefficients of the polynomial E in the approximation of e^r.

    They are `count` doubles, lowest first.
    """

    def tail(r: mpmath.mpf) -> mpmath.mpf:
        return sum(r**n / mpmath.factorial(n + 3) for n in range(60))

    with mpmath.workdps(DIGITS):
        return tuple(map(float, fitted(tail, *_RANGE, count)))


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
