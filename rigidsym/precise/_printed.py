"""Exact decimal output of balls, and mpmath numbers that print only certain digits."""

from collections.abc import Iterable
from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, ROUND_CEILING, Context, Decimal
from fractions import Fraction

from flint import arb
from mpmath import mp, mpf

from rigidsym import _inputs as inputs
from rigidsym.precise._balls import dyadic

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN)
_UP = Context(prec=3, Emax=MAX_EMAX, Emin=MIN_EMIN, rounding=ROUND_CEILING)
# Digits of the middle beyond the first digit of the radius.
_ROOM = 2


def printed_ball(value: arb) -> dict[str, str]:
    """Format a ball as decimal strings `mid` and `rad` that enclose it.

    The rounding error of the middle is added to the radius.  The middle of a ball of radius 0 is
    exact.
    """
    middle, radius = dyadic(value), dyadic(value.rad())
    # A dyadic number with denominator 2^k has k decimals.
    last = _up(radius).adjusted() - _ROOM if radius else 1 - middle.denominator.bit_length()
    units = round(middle / Fraction(10) ** last)
    return _pair(str(_EXACT.scaleb(Decimal(units), last)) if units else "0", middle, radius)


def printed_rational(value: Fraction, digits: int) -> dict[str, str]:
    """Format a rational as decimal strings `mid` and `rad` that enclose it.

    `mid` is rounded to a number of digits.
    """
    return _pair(inputs.decimal(value, digits), value, Fraction(0))


def _pair(mid: str, middle: Fraction, radius: Fraction) -> dict[str, str]:
    return {"mid": mid, "rad": str(_up(radius + abs(middle - Fraction(Decimal(mid)))))}


def _up(value: Fraction) -> Decimal:
    return _UP.divide(Decimal(value.numerator), Decimal(value.denominator))


class CertainNumber(mpf):
    """An mpmath number that prints only its certain digits.

    Results computed from it are ordinary numbers, of mpmath's current precision.
    """

    __slots__ = ("digits",)
    digits: int

    def __repr__(self) -> str:
        return f"mpf('{self}')"

    def __str__(self) -> str:
        return mp.nstr(self, self.digits, strip_zeros=False)

    def __reduce__(self) -> tuple[object, ...]:
        return _made, (self.__getstate__(), self.digits)


def certain(values: Iterable[mpf], digits: int) -> list[CertainNumber]:
    """Mark mpmath numbers as having a number of certain digits, without rounding them."""
    return [_made(value.__getstate__(), digits) for value in values]


def _made(state: object, digits: int) -> CertainNumber:
    # Calling the class would round to mpmath's precision.
    number = object.__new__(CertainNumber)
    number.__setstate__(state)
    number.digits = digits
    return number
