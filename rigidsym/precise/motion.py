"""States of one motion to any number of digits, each of them certain.

Inputs are exact rationals, and the invariants, the parameter m and the regime are computed
exactly; all that follows is done with Arb's balls, at a working precision that rises until the
balls are small enough.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from flint import arb
from mpmath import mp

from rigidsym.inputs import is_uncertain
from rigidsym.precise.balls import bits_of, has_digits, is_within, to_mpf, working
from rigidsym.precise.carlson import Carlson
from rigidsym.precise.evaluation import Evaluation, State
from rigidsym.precise.ladder import GUARD_BITS, Ladder
from rigidsym.precise.landen import Landen
from rigidsym.precise.quadrature import Quadrature
from rigidsym.precise.theta import Theta
from rigidsym.precise.uncertain import classify_uncertain
from rigidsym.solution.polhode import Polhode

# How many precisions a motion keeps its constants for.
KEPT = 4
METHODS = {"theta": Theta, "carlson": Carlson, "landen": Landen, "quadrature": Quadrature}


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
        return is_uncertain(*self.inertia, *self.omega0, *self.attitude0)

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
            return [float(x) for x in self._at(bits_of(digits) + GUARD_BITS).start[0]]

    def constants(self, names: Sequence[str], digits: int) -> dict[str, Any]:
        """Constants of the motion by name, `digits` digits each; the rates must not be constant."""
        ladder = Ladder(self._at, digits, has_digits, None)
        numbers = ladder.read(lambda e: [e.constant(name) for name in names], "constants")
        return dict(zip(names, map(_settled, numbers), strict=True))

    def _numbers(
        self,
        times: Sequence[Fraction],
        digits: int,
        enough: Callable[[arb, int], bool],
        max_seconds: float | None,
    ) -> Iterator[list[arb]]:
        ladder = Ladder(self._at, digits, enough, max_seconds)
        read = ladder.read_uncertain if self._is_uncertain else ladder.read
        for time in times:
            yield read(lambda e, t=time: [*chain(*e.state(t))], f"t = {time}")

    def _at(self, bits: int) -> Evaluation:
        """The formulas at the working precision, whose bits these are; the last few are kept."""
        kept = self._kept
        if bits not in kept:
            while len(kept) >= KEPT:
                del kept[next(iter(kept))]
            kept[bits] = Evaluation(self, METHODS[self.method]().table())
        return kept[bits]

    @cached_property
    def _kept(self) -> dict[int, Evaluation]:
        return {}

    def __reduce__(self) -> tuple[Any, ...]:
        """What it was made from: balls do not travel."""
        return PreciseMotion, (self.inertia, self.omega0, self.attitude0, self.method)


def _settled(value: arb) -> Any:
    return mp.zero if value.contains(0) else to_mpf(value)
