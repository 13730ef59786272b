"""States of one motion to any number of digits, each of them certain.

Inputs are exact rationals, and the invariants, the parameter m and the regime are computed
exactly; all that follows is done with Arb's balls, at a working precision that rises until the
balls are small enough.
"""

from bisect import bisect
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from time import perf_counter
from typing import Any

from flint import arb
from mpmath import mp

from rigidsym.errors import PrecisionError
from rigidsym.inputs import Uncertain
from rigidsym.precise.balls import ball, bits_of, has_digits, is_within, to_mpf, working
from rigidsym.precise.carlson import Carlson
from rigidsym.precise.evaluation import Evaluation, Given, State
from rigidsym.precise.landen import Landen
from rigidsym.precise.quadrature import Quadrature
from rigidsym.precise.theta import Theta
from rigidsym.precise.uncertain import classify_uncertain
from rigidsym.solution.polhode import Polhode

METHODS = {"theta": Theta, "carlson": Carlson, "landen": Landen, "quadrature": Quadrature}
GUARD_BITS = 40
MOST_ROUNDS = 24
# Where time is limited precision rises from here, so that something is known when it is over.
FIRST_BITS = 256
# Uncertain inputs that say nothing at this precision, or at that of the digits, never do.
MOST_BITS = 2**14


@dataclass(frozen=True)
class PreciseMotion:
    """A motion: inertia (3), body rates (3), attitude (4), rationals or uncertain numbers."""

    inertia: tuple[Any, ...]
    omega0: tuple[Any, ...]
    attitude0: tuple[Any, ...]
    method: str = "theta"

    @cached_property
    def polhode(self) -> Polhode:
        """Regime and axes, decided exactly; InputError where uncertainty leaves them open."""
        return classify_uncertain(self.inertia, self.omega0)

    @property
    def _is_uncertain(self) -> bool:
        given = (*self.inertia, *self.omega0, *self.attitude0)
        return any(isinstance(value, Uncertain) for value in given)

    def states(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """(q, omega) at each time as mpf numbers, `digits` significant digits of each certain.

        Raises PrecisionError where `max_seconds` for them all are over.
        """
        for numbers in self._numbers(times, digits, has_digits, max_seconds):
            settled = [_settled(value) for value in numbers]
            yield settled[:4], settled[4:]

    def enclosures(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """(q, omega) at each time as balls, of radius at most 10^-digits max(1, |value|)."""
        for numbers in self._numbers(times, digits, is_within, max_seconds):
            yield numbers[:4], numbers[4:]

    def start(self, digits: int) -> list[float]:
        """The attitude at t = 0, normalised and rounded to doubles."""
        with working(bits_of(digits) + GUARD_BITS):
            return [float(x) for x in self._evaluation().start[0]]

    def constants(self, names: Sequence[str], digits: int) -> dict[str, Any]:
        """Constants of the motion by name, `digits` digits each; the rates must not be constant."""
        ladder = Ladder(self._evaluation, digits, has_digits, None)
        numbers = ladder.read(lambda e: [e.constant(name) for name in names], "constants")
        return dict(zip(names, map(_settled, numbers), strict=True))

    def _numbers(
        self,
        times: Sequence[Fraction],
        digits: int,
        enough: Callable[[arb, int], bool],
        max_seconds: float | None,
    ) -> Iterator[list[arb]]:
        ladder = Ladder(self._evaluation, digits, enough, max_seconds)
        read = ladder.read_uncertain if self._is_uncertain else ladder.read
        for time in times:
            yield read(lambda e, t=time: [*chain(*e.state(t))], f"t = {time}")

    def _evaluation(self) -> Evaluation:
        given = Given(self.inertia, self.omega0, self.attitude0, self.polhode)
        return Evaluation(given, ball, METHODS[self.method]().table())


class Ladder:
    """Working precisions that rise until balls are small enough; what they cost is kept."""

    def __init__(
        self,
        evaluation: Callable[[], Evaluation],
        digits: int,
        enough: Callable[[arb, int], bool],
        max_seconds: float | None,
    ) -> None:
        self.evaluation, self.digits, self.enough = evaluation, digits, enough
        self.end = None if max_seconds is None else perf_counter() + max_seconds
        whole = bits_of(digits) + GUARD_BITS
        self.bits = whole if self.end is None else min(whole, FIRST_BITS)
        self.known: dict[int, Evaluation] = {}

    def read(self, numbers: Callable[[Evaluation], list[arb]], what: str) -> list[arb]:
        """The numbers, at the first precision at which all have enough digits."""
        found = [arb.nan()]
        for _ in range(MOST_ROUNDS):
            if self._is_over():
                break
            with working(self.bits):
                found = numbers(self._known())
                missing = max(self._missing(value) for value in found)
            if not missing:
                return found
            needed = self.bits + missing + GUARD_BITS // 2
            self.bits = needed if self.end is None else min(needed, 4 * self.bits)
        raise PrecisionError(f"{what}: {self._reached(found)} of {self.digits} digits were reached")

    def read_uncertain(self, numbers: Callable[[Evaluation], list[arb]], what: str) -> list[arb]:
        """The numbers, when twice the precision does not make the balls smaller any more."""
        widest, most = None, max(MOST_BITS, 2 * self.bits)
        while self.bits <= most and not self._is_over():
            with working(self.bits):
                found = numbers(self._known())
            if all(value.is_finite() for value in found):
                radius = max(float(value.rad()) for value in found)
                if widest is not None and radius >= widest / 2:
                    self.bits //= 2  # for the next time: this was enough
                    return found
                widest = radius
            self.bits *= 2
        if widest is not None:
            raise PrecisionError(f"{what}: a radius of {widest:.2g} was reached")
        raise PrecisionError(f"{what}: the inputs are too uncertain to say anything")

    def _known(self) -> Evaluation:
        if self.bits not in self.known:
            self.known[self.bits] = self.evaluation()
        return self.known[self.bits]

    def _reached(self, found: Sequence[arb]) -> int:
        """How many digits all numbers have."""

        def is_beyond(digits: int) -> bool:
            return not all(self.enough(value, digits) for value in found)

        with working(self.bits):
            return max(bisect(range(self.digits + 1), 0, key=is_beyond) - 1, 0)

    def _is_over(self) -> bool:
        return self.end is not None and perf_counter() >= self.end

    def _missing(self, value: arb) -> int:
        """About how many bits more a number needs: 0 where it is good, as many again for none."""
        if self.enough(value, self.digits):
            return 0
        if not value.is_finite() or value.contains(0):
            return max(self.bits, bits_of(self.digits))
        return max(8, bits_of(self.digits) + 2 - value.rel_accuracy_bits())


def _settled(value: arb) -> Any:
    return mp.zero if value.contains(0) else to_mpf(value)
