"""Arctangent and logarithm of extended numbers, by argument halving and series.

The first terms are extended numbers; the rest, below a unit in the last place of the sum, are
doubles.  What the series leave out is below the last bit of a pair: `series_tail` bounds it.
"""

from fractions import Fraction

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Constant, Function, Let, let
from rigidsym._codegen.special_functions.polynomials import horner

# tan(pi/32) and tanh(log(2)/8) are below this after the halvings.
LARGEST = Fraction(99, 1000)
ARCTAN = "DLMF 4.24.3"
LOGARITHM = "DLMF 4.38.5"


def series_tail(binary: Format = BINARY64) -> Fraction:
    """Bound the truncation error of the series for the arctangent and the logarithm.

    It is sum_{n >= terms} x^(2 n)/(2 n + 1) where x is at most LARGEST.
    """
    square, (_, terms) = LARGEST**2, binary.arctangent
    return square**terms / (2 * terms + 1) / (1 - square)


def constants(binary: Format = BINARY64) -> list[Constant]:
    """Return the named constants 1/3, 1/5, and so on, the coefficients of the series."""
    extended, terms = binary.arctangent
    found = []
    for n in range(3, 2 * terms, 2):
        high, rest = binary.pair(Fraction(1, n))
        found.append(Constant(f"over_{n}", high, rest if n <= 2 * extended + 1 else None, f"1/{n}"))
    return found


def half_turns(binary: Format = BINARY64) -> Function:
    """Build the function that computes theta/pi from the sine and cosine of theta.

    s is the sine; c is the cosine, which must not be negative.
    """
    lets = [let("t1 = s/(1 + c)", "DLMF 4.21.28")]
    lets += [let(f"t{k + 1} = t{k}/(1 + sqrt(1 + t{k}*t{k}))", "DLMF 4.21.28") for k in range(1, 4)]
    lets += _series("t4", "-", ARCTAN, binary)
    lets += [let("angle = 16*t4*series/pi", ARCTAN)]
    summary = "theta/pi where s and c >= 0 are the sine and cosine of theta."
    return Function("_half_turns", summary, ("s", "c"), tuple(lets), ("angle",), frozenset("sc"))


def logarithm(binary: Format = BINARY64) -> Function:
    """Build the function that computes log(x) for x > 0."""
    lets = [
        let("e = exponent(x)", "DLMF 4.8"),
        let("f = sqrt(mantissa(x))", "DLMF 4.8"),
        let("t4 = (f - 1)/(f + 1)", LOGARITHM),
        *_series("t4", "+", LOGARITHM, binary),
        let("log_x = e*log_2 + 4*t4*series", LOGARITHM),
    ]
    summary = "log(x) for x > 0."
    return Function("_logarithm", summary, ("x",), tuple(lets), ("log_x",), frozenset("x"))


def _series(variable: str, sign: str, source: str, binary: Format) -> list[Let]:
    """Return assignments that sum the series of the arctangent or the logarithm.

    It is 1 + z/3 + z^2/5 + ..., where z is plus or minus the square of the variable.
    """
    extended, terms = binary.arctangent
    names = [f"over_{2 * n + 1}" for n in range(1, terms)]
    return [
        let(
            f"z = {variable}*{variable}" if sign == "+" else f"z = -({variable}*{variable})", source
        ),
        let("z_d = rounded(z)", source),
        let(f"tail = {horner('z_d', names[extended:])}", source),
        let(f"series = {horner('z', ['1', *names[:extended], 'tail'])}", source),
    ]
