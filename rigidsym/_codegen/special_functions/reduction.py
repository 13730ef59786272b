"""Reduction of angles that grow with time, and polynomials for sine and cosine."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import factorial

import mpmath
from flint import arb
from mpmath import mpf

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import EXACT_DIFFERENCE, EXACT_PRODUCT, EXACT_SUM, Constant, Let, let
from rigidsym._codegen.special_functions.polynomials import DIGITS, distance, fitted, horner

# What whole half turns do to sine and cosine; the sign they leave.
TURNS = "DLMF 4.16"
_FARTHEST = Fraction(65, 128)
_RANGE = Fraction(0), _FARTHEST**2


def constants(binary: Format = BINARY64) -> list[Constant]:
    """Return the named coefficients of the polynomials for sine and cosine."""
    series = (
        ("sine", sine_coefficients(binary.trigonometric, binary), "sin(pi f)/f"),
        ("cosine", cosine_coefficients(binary.trigonometric, binary), "cos(pi f)"),
    )
    return [
        Constant(f"{name}_{k}", value, None, f"{meaning}, z^{k + 1}")
        for name, values, meaning in series
        for k, value in enumerate(values)
    ]


def product(
    name: str, factor: str, of: str = "t", *, extra: str = "", later: bool = True
) -> list[Let]:
    """Return assignments for a product of extended numbers, as a double and its error.

    name + name_error = (factor_hi + factor_lo) (of + of_lo) + extra, without of_lo unless `later`.
    """
    terms = [f"{factor}_lo*{of}", f"{factor}_hi*{of}_lo" if later else "", extra]
    small = " + (".join(filter(None, terms))
    small += ")" * small.count("(")
    return [
        let(f"{name} = {factor}_hi*{of}", EXACT_PRODUCT),
        let(f"{name}_error = product_error({factor}_hi, {of}, {name}) + ({small})", EXACT_PRODUCT),
    ]


def total(name: str, one: str, other: str) -> list[Let]:
    """Return assignments for the sum of two doubles and its exact rounding error.

    name + name_error = one + other (Knuth's sum of two).
    """
    lost = f"({one} - ({name} - {name}_other)) + ({other} - {name}_other)"
    return [
        let(f"{name} = {one} + {other}", EXACT_SUM),
        let(f"{name}_other = {name} - {one}", EXACT_SUM),
        let(f"{name}_error = {lost}", EXACT_SUM),
    ]


def whole(name: str, value: str) -> list[Let]:
    """Return assignments for the whole number nearest to a value, and the remainder.

    The remainder is exact.
    """
    return [
        let(f"{name}_whole = nearest({value})", TURNS),
        let(f"{name}_rest = {value} - {name}_whole", TURNS, EXACT_DIFFERENCE),
    ]


def sine(half_turns: str, sign: str, sine: str) -> list[Let]:
    """Return assignments for the sine of pi times half_turns, multiplied by a sign."""
    square = f"{half_turns}_square"
    return [_square(square, half_turns), _sine(square, half_turns, sign, sine, BINARY64)]


def sine_and_cosine(
    angle: str,
    half_turns: str,
    whole: str,
    sine: str,
    cosine: str,
    binary: Format = BINARY64,
) -> list[Let]:
    """Return assignments for the sine and cosine of an angle in half turns.

    half_turns: what is left of the angle after subtraction of a whole number.  whole: that number.
    """
    square, sign = f"{angle}_square", f"{angle}_sign"
    terms = [f"cosine_{k}" for k in range(binary.trigonometric)]
    return [
        _square(square, half_turns),
        let(f"{sign} = alternating({whole})", TURNS),
        _sine(square, half_turns, sign, sine, binary),
        let(f"{cosine} = {sign}*(1 + {square}*({horner(square, terms)}))", "DLMF 4.19.2"),
    ]


def _square(square: str, half_turns: str) -> Let:
    return let(f"{square} = {half_turns}*{half_turns}", "DLMF 4.19.1", "DLMF 4.19.2")


def _sine(square: str, half_turns: str, sign: str, sine: str, binary: Format) -> Let:
    terms = [f"sine_{k}" for k in range(binary.trigonometric)]
    return let(
        f"{sine} = {sign}*({half_turns}*pi_hi"
        f" + {half_turns}*(pi_lo + {square}*({horner(square, terms)})))",
        "DLMF 4.19.1",
    )


@cache
def sine_coefficients(count: int, binary: Format = BINARY64) -> tuple[float, ...]:
    """Return the coefficients of S in the approximation sin(pi f) = f (pi + z S(z)), z = f^2.

    They are `count` numbers of a format, lowest first.
    """
    return _near(lambda z: mpmath.pi * (mpmath.sincpi(mpmath.sqrt(z)) - 1), count, binary)


@cache
def cosine_coefficients(count: int, binary: Format = BINARY64) -> tuple[float, ...]:
    """Return the coefficients of C in the approximation cos(pi f) = 1 + z C(z), z = f^2.

    They are `count` numbers of a format, lowest first.
    """
    return _near(lambda z: mpmath.cos(mpmath.pi * mpmath.sqrt(z)) - 1, count, binary)


def _near(function: Callable[[mpf], mpf], count: int, binary: Format) -> tuple[float, ...]:
    """Fit a polynomial p such that z p(z) approximates a function of z.

    Returns the coefficients.
    """
    with mpmath.workdps(DIGITS):
        first = binary.rounded(fitted(lambda z: function(z) / z, *_RANGE, count)[0])
        rest = fitted(lambda z: (function(z) / z - first) / z, *_RANGE, count - 1)
        return (first, *map(binary.rounded, rest))


def sine_bound(coefficients: Sequence[float]) -> float:
    """Bound the error of the polynomial for the sine, |f (pi + z S(z)) - sin(pi f)|."""
    return distance(
        coefficients,
        lambda k: _taylor(2 * k + 3),
        *_RANGE,
        weight=lambda z: abs(z) * _FARTHEST.numerator / _FARTHEST.denominator,
    )


def cosine_bound(coefficients: Sequence[float]) -> float:
    """Bound the error of the polynomial for the cosine, |1 + z C(z) - cos(pi f)|."""
    return distance(coefficients, lambda k: _taylor(2 * k + 2), *_RANGE)


def _taylor(power: int) -> arb:
    return (-1) ** (power // 2) * arb.pi() ** power / factorial(power)
