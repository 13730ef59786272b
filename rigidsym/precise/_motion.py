"""States of one motion to any number of certain digits.

Invariants, the parameter m and the regime of exact inputs are computed exactly.  All further
numbers are Arb's balls, at a working precision that rises until the balls are small enough.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from itertools import chain
from typing import Any

from flint import arb
from mpmath import mp, mpf

from rigidsym.errors import written
from rigidsym.precise import _worker as worker
from rigidsym.precise._balls import (
    GUARD_BITS,
    AdaptivePrecision,
    ball,
    bits_of,
    has_digits,
    is_within,
    to_mpf,
    working,
)
from rigidsym.precise._evaluation import Evaluation, Request, Sensitive, State
from rigidsym.precise._floating import Estimates, theta_form, third_kind_form
from rigidsym.precise._functions import METHODS
from rigidsym.precise._regime import MotionInputs
from rigidsym.precise._theorem1 import Theorem1

__all__ = ["ESTIMATED", "METHODS", "PreciseMotion"]

# The last precisions for which a motion keeps its constants.
KEPT = 4
# Methods of numbers whose errors are estimated: the computations at two precisions.
ESTIMATED = {"mpmath": (third_kind_form, theta_form), "theorem1": (Theorem1, Theorem1)}
# (q, omega) as mpf numbers.
DecimalState = tuple[list[mpf], list[mpf]]


@dataclass(frozen=True)
class PreciseMotion(MotionInputs):
    """A torque-free motion whose states are computed to any number of digits."""

    method: str = "theta"

    def states(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[DecimalState]:
        """Yield attitude and rates at each time as mpf numbers with certain digits.

        Each number has `digits` of them.

        Raises PrecisionError where `max_seconds` for all times are over.
        """
        precision = AdaptivePrecision(digits, has_digits, max_seconds)
        for time in times:
            settled = [_settled(value) for value in chain(*self.read(precision, time))]
            yield settled[:4], settled[4:]

    def enclosures(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """Yield attitude and rates at each time as balls of limited radius.

        The radius is at most 10^-digits max(1, |value|).
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            yield self.read(precision, time)

    def read(self, precision: AdaptivePrecision, time: Fraction) -> State:
        """Return attitude and rates at one time as balls that have the requested digits."""
        read = precision.read_uncertain if self.is_uncertain else precision.read
        found = read(partial(self.numbers, time), f"t = {written(time)}")
        return found[:4], found[4:]

    def sensitivities(
        self,
        times: Sequence[Fraction],
        digits: int,
        max_seconds: float | None = None,
        enough: Callable[[arb, int], bool] = is_within,
    ) -> Iterator[list[arb]]:
        """Yield the state and its sensitivities at each time as balls.

        A row has (q, omega) and the numbers of `columns.listed`.

        Raises InputError where inputs are uncertain, and PrecisionError where `max_seconds` for all
        times are over.
        """
        precision = AdaptivePrecision(digits, enough, max_seconds)
        for time in times:
            numbers = partial(self.numbers, Sensitive(time))
            yield precision.read(numbers, f"t = {written(time)}")

    def decimal_sensitivities(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[list[mpf]]:
        """Yield the state and its sensitivities at each time as mpf numbers with certain digits.

        Each number has `digits` of them.
        """
        for row in self.sensitivities(times, digits, max_seconds, has_digits):
            yield list(map(_settled, row))

    def start(self, digits: int) -> list[float]:
        """Return the attitude at t = 0, normalised and rounded to doubles."""
        bits = bits_of(digits) + GUARD_BITS
        with working(bits):
            return [float(x) for x in self._at(bits).start[0]]

    def constants(self, names: Sequence[str], digits: int) -> dict[str, mpf]:
        """Return constants of the motion by name, with `digits` digits each.

        They exist where the rates change.
        """
        precision = AdaptivePrecision(digits, has_digits, None)
        found = precision.read(partial(self.numbers, tuple(names)), "constants")
        return dict(zip(names, map(_settled, found), strict=True))

    def numbers(self, request: Request, bits: int, end: float | None) -> list[arb]:
        """Return the requested numbers as balls at a working precision.

        Long evaluations run in a worker process.  Raises TimeoutError where the clock passes `end`.
        """
        kind = Estimates if self.method in ESTIMATED else METHODS[self.method]
        if bits <= kind.quick_bits:
            return self.numbers_here(request, bits)
        return worker.numbers(self.numbers_here, request, bits, end=end)

    def numbers_here(self, request: Request, bits: int) -> list[arb]:
        """Compute the numbers of a request in this process."""
        with working(bits):
            return self._at(bits).numbers(request)

    def _at(self, bits: int) -> Evaluation[arb] | Estimates:
        """Return the evaluation of the motion at a working precision.

        The last few are cached.
        """
        kept = self._kept
        if bits not in kept:
            while len(kept) >= KEPT:
                del kept[next(iter(kept))]
            if self.method in ESTIMATED:
                kept[bits] = Estimates(self, bits, *ESTIMATED[self.method])
            else:
                kept[bits] = Evaluation(self, METHODS[self.method]().table(), ball)
        return kept[bits]

    @cached_property
    def _kept(self) -> dict[int, Evaluation[arb] | Estimates]:
        return {}

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the motion by its inputs alone.

        A process that gets equal inputs again keeps their constants.
        """
        return _unpickled, (self.inertia, self.omega0, self.attitude0, self.method)


@lru_cache(maxsize=2)
def _unpickled(*given: Any) -> PreciseMotion:
    return PreciseMotion(*given)


def _settled(value: arb) -> mpf:
    return mp.zero if value.contains(0) else to_mpf(value)
