"""Conversions of Arb's balls, tests of their accuracy, and adaptive working precision.

FLINT has one working precision for the whole process.  Work at another precision holds a lock, so
threads of this project take turns; processes are independent.
"""

import os
from bisect import bisect
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager, suppress
from fractions import Fraction
from functools import lru_cache
from math import ceil, log2
from threading import RLock
from time import perf_counter

from flint import arb, ctx, fmpq, fmpz
from mpmath import mp, mpf

from rigidsym._inputs import Number, Uncertain
from rigidsym.errors import PrecisionError

# Bits beyond those of the digits; rounds before giving up.
GUARD_BITS = 40
MOST_ROUNDS = 24
# Where time is limited the precision rises from here, so that some digits are reached.
FIRST_BITS = 256
# Uncertain inputs are given up whose balls are infinite at this precision or that of the digits.
MOST_BITS = 2**12
TOO_UNCERTAIN = "the inputs are too uncertain to say anything"
# Returns balls at a number of bits; raises TimeoutError where the clock passes the limit, if any.
Numbers = Callable[[int, float | None], list[arb]]
# A ball can be made of any of these.
Quantity = Number | int | arb

_lock = RLock()
BITS_PER_DIGIT = log2(10)
# A ball around zero below this counts as zero when digits are counted.
ZERO = arb(2) ** -4000


@contextmanager
def working(bits: int) -> Generator[None]:
    """Set Arb's working precision to a number of bits within a `with` block."""
    with _lock, ctx.workprec(bits):
        yield


def _renew() -> None:
    """Replace the lock of the working precision in a forked process.

    A thread that held it does not exist there.
    """
    global _lock
    _lock = RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew)


def bits_of(digits: int) -> int:
    """Return the number of bits that a number of decimal digits needs."""
    return ceil(digits * BITS_PER_DIGIT)


def ball(value: Quantity) -> arb:
    """Convert an exact or uncertain number to a ball at the working precision."""
    if isinstance(value, Uncertain):
        return ball(value.middle) + arb(0, ball(value.radius).upper())
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    return arb(value)


def difference(x: Number, y: Number) -> arb:
    """Return the difference x - y as a ball.

    It is exactly zero for equal exact numbers.
    """
    if isinstance(x, Uncertain) or isinstance(y, Uncertain):
        return ball(x) - ball(y)
    return ball(x - y)


def dyadic(value: arb) -> Fraction:
    """Return the midpoint of a ball as a fraction."""
    mantissa, exponent = map(int, value.mid().man_exp())
    return mantissa * Fraction(2) ** exponent


def unit(quaternion: Sequence[arb]) -> list[arb]:
    """Normalise a quaternion of balls and restrict its components to [-1, 1]."""
    length = sum((power(x, 2) for x in quaternion), arb(0)).sqrt()
    return [(x / length).intersection(arb(0, 1)) for x in quaternion]


def intersection(one: arb, other: arb) -> arb:
    """Return the intersection of two balls.

    This is the finite one if the other is not finite, and the first of disjoint ones.
    """
    if not other.is_finite() or not one.overlaps(other):
        return one
    return one.intersection(other) if one.is_finite() else other


def power(x: arb, exponent: int) -> arb:
    """Compute a nonnegative integer power of a ball by repeated multiplication.

    Even powers are not negative.  FLINT's own power of a ball centred at zero is no number.
    """
    square = x * x
    if x.contains(0):
        square = square.nonnegative_part()
    value = x if exponent % 2 else arb(1)
    for _ in range(exponent // 2):
        value *= square
    return value


def is_within(value: arb, digits: int) -> bool:
    """Return True if the radius of a ball is at most 10^-digits max(1, |value|)."""
    over = value.rad() * _power_of_ten(digits)
    return bool(over <= 1) or bool(over <= value.abs_lower())


@lru_cache
def _power_of_ten(digits: int) -> arb:
    """Return 10^digits as an exact ball, at any working precision."""
    return arb(10**digits)


def has_digits(value: arb, digits: int) -> bool:
    """Return True if a ball determines a number of significant digits.

    The last digit may be off by one.
    """
    if value.contains(0):
        return bool(value.abs_upper() < ZERO)
    return bool(value.rad() * arb(10) ** digits <= value.abs_lower())


def to_mpf(value: arb) -> mpf:
    """Convert the midpoint of a ball to an mpf, without rounding."""
    return mp.make_mpf(value.mid()._mpf_)


def of_mpf(value: mpf) -> arb:
    """Convert an mpf to a ball of radius 0, without rounding."""
    sign, mantissa, exponent, _ = value._mpf_
    return arb((fmpz(-mantissa if sign else mantissa), fmpz(exponent)))


class TooUncertainError(PrecisionError):
    """Error for inputs so uncertain that no precision gives an enclosure."""


class AdaptivePrecision:
    """A loop that raises the working precision until balls are small enough."""

    def __init__(
        self, digits: int, enough: Callable[[arb, int], bool], max_seconds: float | None
    ) -> None:
        self.digits, self.enough = digits, enough
        self.end = None if max_seconds is None else perf_counter() + max_seconds
        whole = bits_of(digits) + GUARD_BITS
        self.bits = whole if self.end is None else min(whole, FIRST_BITS)

    def read(self, numbers: Numbers, name: str) -> list[arb]:
        """Evaluate numbers at rising precision until all of them have enough digits."""
        found = [arb.nan()]
        with suppress(TimeoutError):
            for _ in range(MOST_ROUNDS):
                self.check()
                found = numbers(self.bits, self.end)
                with working(self.bits):
                    missing = max(self._missing(value) for value in found)
                if not missing:
                    return found
                needed = self.bits + missing + GUARD_BITS // 2
                self.bits = needed if self.end is None else min(needed, 4 * self.bits)

        def is_beyond(digits: int) -> bool:
            return not all(self.enough(value, digits) for value in found)

        with working(self.bits):
            reached = max(bisect(range(self.digits + 1), 0, key=is_beyond) - 1, 0)
        raise PrecisionError(f"{name}: {reached} of {self.digits} digits were reached")

    def read_uncertain(self, numbers: Numbers, name: str) -> list[arb]:
        """Evaluate numbers of uncertain inputs at rising precision until they stop improving."""
        widest, most = None, max(MOST_BITS, 2 * self.bits)
        with suppress(TimeoutError):
            while self.bits <= most:
                self.check()
                found = numbers(self.bits, self.end)
                if all(value.is_finite() for value in found):
                    radius = max(float(value.rad()) for value in found)
                    if widest is not None and radius >= widest / 2:
                        self.bits //= 2  # enough for the next call
                        return found
                    widest = radius
                self.bits *= 2
            if widest is None:
                raise TooUncertainError(f"{name}: {TOO_UNCERTAIN}")
        known = "nothing was reached" if widest is None else f"a radius of {widest:.2g} was reached"
        raise PrecisionError(f"{name}: {known}")

    def check(self) -> None:
        """Raise TimeoutError if the time limit has passed."""
        if self.end is not None and perf_counter() >= self.end:
            raise TimeoutError

    def _missing(self, value: arb) -> int:
        """Estimate how many more bits of precision a number needs.

        Return 0 if it has enough digits.
        """
        if self.enough(value, self.digits):
            return 0
        if not value.is_finite() or value.contains(0):
            return max(self.bits, bits_of(self.digits))
        return max(8, bits_of(self.digits) + 2 - value.rel_accuracy_bits())
