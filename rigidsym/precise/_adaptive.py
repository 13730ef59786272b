"""Working precisions that rise until the digits are certain, or time or inputs allow no more."""

from bisect import bisect
from collections.abc import Callable, Sequence
from contextlib import suppress
from time import perf_counter

from flint import arb

from rigidsym.errors import PrecisionError
from rigidsym.precise._balls import bits_of, working

# Bits beyond those of the digits; rounds before giving up.
GUARD_BITS = 40
MOST_ROUNDS = 24
# Where time is limited the precision rises from here, so that some digits are reached.
FIRST_BITS = 256
# Uncertain inputs are given up whose balls are infinite at this precision or that of the digits.
MOST_BITS = 2**12
TOO_UNCERTAIN = "the inputs are too uncertain to say anything"


# Returns balls at so many bits; raises TimeoutError where the clock passes the limit, if any.
Numbers = Callable[[int, float | None], list[arb]]


class TooUncertainError(PrecisionError):
    """The formulas give no enclosure at any precision."""


class AdaptivePrecision:
    """Working precisions that rise until balls are small enough (Ziv's loop)."""

    def __init__(
        self, digits: int, enough: Callable[[arb, int], bool], max_seconds: float | None
    ) -> None:
        self.digits, self.enough = digits, enough
        self.end = None if max_seconds is None else perf_counter() + max_seconds
        whole = bits_of(digits) + GUARD_BITS
        self.bits = whole if self.end is None else min(whole, FIRST_BITS)

    def read(self, numbers: Numbers, name: str) -> list[arb]:
        """Return the numbers at the first precision at which all have enough digits."""
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
        raise PrecisionError(f"{name}: {self._reached(found)} of {self.digits} digits were reached")

    def read_uncertain(self, numbers: Numbers, name: str) -> list[arb]:
        """Return the numbers at a precision whose double makes the balls no smaller."""
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

    def _reached(self, found: Sequence[arb]) -> int:
        """Return the number of digits that all numbers have."""

        def is_beyond(digits: int) -> bool:
            return not all(self.enough(value, digits) for value in found)

        with working(self.bits):
            return max(bisect(range(self.digits + 1), 0, key=is_beyond) - 1, 0)

    def check(self) -> None:
        """Raise TimeoutError where the time is over."""
        if self.end is not None and perf_counter() >= self.end:
            raise TimeoutError

    def _missing(self, value: arb) -> int:
        """Return about how many more bits a number needs: 0 if good, twice as many if infinite."""
        if self.enough(value, self.digits):
            return 0
        if not value.is_finite() or value.contains(0):
            return max(self.bits, bits_of(self.digits))
        return max(8, bits_of(self.digits) + 2 - value.rel_accuracy_bits())
