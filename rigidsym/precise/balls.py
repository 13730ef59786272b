"""Arb's balls as numbers: a precision that is always given back, and what is certain of a ball.

FLINT has one working precision for the whole process, so work at another one holds a lock: threads
of this project take turns, and processes do not mind.
"""

import os
from collections.abc import Generator
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache
from math import ceil, log2
from threading import RLock

from flint import arb, ctx, fmpq, fmpz
from mpmath import mp, mpf

from rigidsym.inputs import Number, Uncertain

# What a ball is made of.
Quantity = Number | int | arb


_lock = RLock()
BITS_PER_DIGIT = log2(10)
# A ball around zero that has shrunk below 2^-4000 is taken for zero where digits are counted.
ZERO = arb(2) ** -4000


@contextmanager
def working(bits: int) -> Generator[None]:
    """Work at a precision of so many bits, and leave the one that was found."""
    with _lock, ctx.workprec(bits):
        yield


def _renew() -> None:
    """A child of fork has one thread, and nobody to release a lock that another one held."""
    global _lock
    _lock = RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew)


def bits_of(digits: int) -> int:
    """Bits that hold so many decimal digits."""
    return ceil(digits * BITS_PER_DIGIT)


def ball(value: Quantity) -> arb:
    """The ball of an exact or uncertain number, at the working precision."""
    if isinstance(value, Uncertain):
        return ball(value.middle) + arb(0, ball(value.radius).upper())
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    return arb(value)


def difference(x: Number, y: Number) -> arb:
    """x - y; exactly zero where exact numbers agree."""
    if isinstance(x, Uncertain) or isinstance(y, Uncertain):
        return ball(x) - ball(y)
    return ball(x - y)


def dyadic(value: arb) -> Fraction:
    """The rational that the middle of a ball is."""
    mantissa, exponent = map(int, value.mid().man_exp())
    return mantissa * Fraction(2) ** exponent


def meeting(one: arb, other: arb) -> arb:
    """What two balls have in common; the one that is finite, and the first where they are apart."""
    if not other.is_finite() or not one.overlaps(other):
        return one
    return one.intersection(other) if one.is_finite() else other


def power(x: arb, exponent: int) -> arb:
    """An integer power of a ball, whose square is not negative around zero.

    By products: FLINT's power of a ball centred at zero is no number.
    """
    square = x * x
    if x.contains(0):
        square = square.nonnegative_part()
    value = x if exponent % 2 else arb(1)
    for _ in range(exponent // 2):
        value *= square
    return value


def is_within(value: arb, digits: int) -> bool:
    """Whether the radius is at most 10^-digits of max(1, |value|)."""
    over = value.rad() * _power_of_ten(digits)
    return bool(over <= 1) or bool(over <= value.abs_lower())


@lru_cache
def _power_of_ten(digits: int) -> arb:
    """Exactly, at any working precision."""
    return arb(10**digits)


def has_digits(value: arb, digits: int) -> bool:
    """Whether so many significant digits are certain, up to one unit in the last."""
    if value.contains(0):
        return bool(value.abs_upper() < ZERO)
    return bool(value.rad() * arb(10) ** digits <= value.abs_lower())


def to_mpf(value: arb) -> mpf:
    """The midpoint as an mpf, not rounded."""
    return mp.make_mpf(value.mid()._mpf_)


def of_mpf(value: mpf) -> arb:
    """The ball of radius 0 around an mpf, not rounded."""
    sign, mantissa, exponent, _ = value._mpf_
    return arb((fmpz(-mantissa if sign else mantissa), fmpz(exponent)))
