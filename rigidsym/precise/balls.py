"""Arb's balls as numbers: a precision that is always given back, and what is certain of a ball.

FLINT has one working precision for the whole process, so work at another one holds a lock: threads
of this project take turns, and processes do not mind.
"""

import os
from collections.abc import Generator
from contextlib import contextmanager
from fractions import Fraction
from math import ceil, log2
from threading import RLock
from typing import Any

from flint import arb, ctx, fmpq
from mpmath import mp

from rigidsym.inputs import Uncertain, is_uncertain

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


def ball(value: Any) -> arb:
    """The ball of an exact or uncertain number, at the working precision."""
    if isinstance(value, Uncertain):
        return ball(value.middle) + arb(0, ball(value.radius).upper())
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    return arb(value)


def difference(x: Any, y: Any) -> arb:
    """x - y; exactly zero where exact numbers agree."""
    return ball(x) - ball(y) if is_uncertain(x, y) else ball(x - y)


def dyadic(value: Any) -> Fraction:
    """The rational that the middle of a ball is."""
    mantissa, exponent = map(int, value.mid().man_exp())
    return mantissa * Fraction(2) ** exponent


def power(x: Any, exponent: int) -> Any:
    """An integer power of an exact number or a ball, whose square is not negative around zero.

    By products: FLINT's power of a ball centred at zero is no number.
    """
    square = x * x
    if isinstance(x, arb) and x.contains(0):
        square = square.nonnegative_part()
    value = x if exponent % 2 else 1
    for _ in range(exponent // 2):
        value *= square
    return value


def is_within(value: arb, digits: int) -> bool:
    """Whether the radius is at most 10^-digits of max(1, |value|)."""
    return bool(value.rad() * arb(10) ** digits <= value.abs_lower().max(1))


def has_digits(value: arb, digits: int) -> bool:
    """Whether so many significant digits are certain, up to one unit in the last."""
    if value.contains(0):
        return bool(value.abs_upper() < ZERO)
    return bool(value.rad() * arb(10) ** digits <= value.abs_lower())


def to_mpf(value: arb) -> Any:
    """The midpoint as an mpf, not rounded."""
    return mp.make_mpf(value.mid()._mpf_)
