"""Arb's balls: working precisions, conversions, and the digits that are certain of a ball.

FLINT has one working precision for the whole process.  Work at another precision holds a lock, so
threads of this project take turns; processes are independent.
"""

import os
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache
from math import ceil, log2
from threading import RLock

from flint import arb, ctx, fmpq, fmpz
from mpmath import mp, mpf

from rigidsym._inputs import Number, Uncertain

# A ball can be made of any of these.
Quantity = Number | int | arb

_lock = RLock()
BITS_PER_DIGIT = log2(10)
# A ball around zero below this counts as zero when digits are counted.
ZERO = arb(2) ** -4000


@contextmanager
def working(bits: int) -> Generator[None]:
    """Work at a precision of so many bits, and restore the one before."""
    with _lock, ctx.workprec(bits):
        yield


def _renew() -> None:
    """Renew the lock in a child of fork, where a thread that held it does not exist."""
    global _lock
    _lock = RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew)


def bits_of(digits: int) -> int:
    """Return the bits that hold so many decimal digits."""
    return ceil(digits * BITS_PER_DIGIT)


def ball(value: Quantity) -> arb:
    """Return the ball of an exact or uncertain number, at the working precision."""
    if isinstance(value, Uncertain):
        return ball(value.middle) + arb(0, ball(value.radius).upper())
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    return arb(value)


def difference(x: Number, y: Number) -> arb:
    """Return x - y; exactly zero where exact numbers agree."""
    if isinstance(x, Uncertain) or isinstance(y, Uncertain):
        return ball(x) - ball(y)
    return ball(x - y)


def dyadic(value: arb) -> Fraction:
    """Return the middle of a ball as a fraction."""
    mantissa, exponent = map(int, value.mid().man_exp())
    return mantissa * Fraction(2) ** exponent


def unit(quaternion: Sequence[arb]) -> list[arb]:
    """Return a quaternion divided by its norm, its components within [-1, 1]."""
    length = sum((power(x, 2) for x in quaternion), arb(0)).sqrt()
    return [(x / length).intersection(arb(0, 1)) for x in quaternion]


def intersection(one: arb, other: arb) -> arb:
    """Return the intersection of two balls; the finite one, or the first of disjoint ones."""
    if not other.is_finite() or not one.overlaps(other):
        return one
    return one.intersection(other) if one.is_finite() else other


def power(x: arb, exponent: int) -> arb:
    """Return an integer power of a ball; even powers are not negative.

    It is computed by products: FLINT's power of a ball centred at zero is no number.
    """
    square = x * x
    if x.contains(0):
        square = square.nonnegative_part()
    value = x if exponent % 2 else arb(1)
    for _ in range(exponent // 2):
        value *= square
    return value


def is_within(value: arb, digits: int) -> bool:
    """Return True if the radius is at most 10^-digits of max(1, |value|)."""
    over = value.rad() * _power_of_ten(digits)
    return bool(over <= 1) or bool(over <= value.abs_lower())


@lru_cache
def _power_of_ten(digits: int) -> arb:
    """Return 10^digits exactly, at any working precision."""
    return arb(10**digits)


def has_digits(value: arb, digits: int) -> bool:
    """Return True if so many significant digits are certain, up to one unit in the last."""
    if value.contains(0):
        return bool(value.abs_upper() < ZERO)
    return bool(value.rad() * arb(10) ** digits <= value.abs_lower())


def to_mpf(value: arb) -> mpf:
    """Return the midpoint as an mpf, not rounded."""
    return mp.make_mpf(value.mid()._mpf_)


def of_mpf(value: mpf) -> arb:
    """Return the ball of radius 0 around an mpf, not rounded."""
    sign, mantissa, exponent, _ = value._mpf_
    return arb((fmpz(-mantissa if sign else mantissa), fmpz(exponent)))
