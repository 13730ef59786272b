"""Numbers as pairs of decimal strings, `mid` and `rad`, that still contain them."""

from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, ROUND_CEILING, Context, Decimal
from fractions import Fraction

from flint import arb

from rigidsym import inputs
from rigidsym.precise.balls import dyadic

_EXACT = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN)
_UP = Context(prec=3, Emax=MAX_EMAX, Emin=MIN_EMIN, rounding=ROUND_CEILING)
_ROOM = 2  # digits of the middle beyond the first of the radius


def printed_ball(value: arb) -> dict[str, str]:
    """A ball of Arb's: the middle rounded where the radius hides it, the radius rounded up.

    What the middle loses is added to the radius; the middle of a ball of radius 0 is exact.
    """
    middle, radius = dyadic(value), dyadic(value.rad())
    # A dyadic number with denominator 2^k has k decimals.
    last = _up(radius).adjusted() - _ROOM if radius else 1 - middle.denominator.bit_length()
    units = round(middle / Fraction(10) ** last)
    return _pair(str(_EXACT.scaleb(Decimal(units), last)) if units else "0", middle, radius)


def printed_rational(value: Fraction, digits: int) -> dict[str, str]:
    """A rational rounded to so many digits."""
    return _pair(inputs.decimal(value, digits), value, Fraction(0))


def _pair(mid: str, middle: Fraction, radius: Fraction) -> dict[str, str]:
    return {"mid": mid, "rad": str(_up(radius + abs(middle - Fraction(Decimal(mid)))))}


def _up(value: Fraction) -> Decimal:
    return _UP.divide(Decimal(value.numerator), Decimal(value.denominator))
