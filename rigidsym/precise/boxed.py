"""States of all motions whose inputs lie in a box: by what its regime says, by the theorem of the
mean, and by the flow."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce

from flint import arb

from rigidsym.errors import InputError, PrecisionError, written
from rigidsym.inputs import Number
from rigidsym.precise.adaptive import AdaptivePrecision, TooUncertainError
from rigidsym.precise.balls import is_within, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.flowing import Flowing, bits_for
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.sensitivity.boxes import MeanStates

# Of the methods that know the regime, carlson leaves the smallest balls.
BY_REGIME = "carlson"
# The work of a step of the flow grows with the square of the bits, and more.
FINE = 256


@dataclass(frozen=True)
class BoxedMotion:
    """Motions: inertia (3), body rates (3), attitude (4), some of these numbers uncertain."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]

    def enclosures(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """(q, omega) at each time as balls, where all ways meet.

        The flow is left out where it would be slow and others leave little to be desired.

        Raises PrecisionError where `max_seconds` for all times are over.
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            if time == 0:
                yield self._by_flow(precision, time)
                continue
            formulas = self._by_formulas(precision, time)
            mean, is_narrow = self._by_mean_values(digits).state(time) or (None, False)
            known = [state for state in (mean, formulas) if state]
            if not (is_narrow or (formulas and self._bits(digits) > FINE)):
                known.append(self._by_flow(precision, time))
            yield reduce(_meeting, known)

    def mean_values(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """The same by the theorem of the mean alone.

        Raises PrecisionError where it says nothing.
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            with _saying(time):
                precision.check()
            found = self._by_mean_values(digits).state(time)
            if found is None:
                raise self._too_uncertain(time, digits)
            yield found[0]

    def sensitivities(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[list[arb]]:
        """At each time (q, omega) and what `sensitivity.point.listed` lists, of all motions.

        Raises PrecisionError where they are too uncertain.
        """
        states = self.enclosures(times, digits, max_seconds)
        for time, (q, omega) in zip(times, states, strict=True):
            found = self._by_mean_values(digits).sensitivities(time)
            if found is None:
                raise self._too_uncertain(time, digits)
            yield [*q, *omega, *found]

    def flows(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """The same by the flow alone."""
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            yield self._by_flow(precision, time)

    def _by_flow(self, precision: AdaptivePrecision, time: Fraction) -> State:
        with _saying(time):
            return self._flowing(precision).state(time, precision.check)

    def _by_mean_values(self, digits: int) -> MeanStates:
        bits = self._bits(digits)
        if bits not in self._means:
            self._means.clear()
            self._means[bits] = MeanStates(self.inertia, self.omega0, self.attitude0, bits)
        return self._means[bits]

    def _too_uncertain(self, time: Fraction, digits: int) -> TooUncertainError:
        reason = self._by_mean_values(digits).reason
        return TooUncertainError(f"t = {written(time)}: {reason}")

    def _by_formulas(self, precision: AdaptivePrecision, time: Fraction) -> State | None:
        """None where they do not hold for all of the box, or say nothing."""
        try:
            return self._formulas.read(precision, time) if self._formulas else None
        except TooUncertainError:
            return None

    @cached_property
    def _formulas(self) -> PreciseMotion | None:
        motion = PreciseMotion(self.inertia, self.omega0, self.attitude0, BY_REGIME)
        try:
            _ = motion.polhode
        except InputError:
            return None
        return motion

    def _flowing(self, precision: AdaptivePrecision) -> Flowing:
        """The flow at a precision for so many digits, with the steps it has made."""
        bits = self._bits(precision.digits)
        if bits not in self._kept:
            self._kept.clear()
            given = self.inertia, self.omega0, self.attitude0
            self._kept[bits] = Flowing(*given, bits, precision.check)
        return self._kept[bits]

    def _bits(self, digits: int) -> int:
        return bits_for((self.inertia, self.omega0, self.attitude0), digits)

    @cached_property
    def _kept(self) -> dict[int, Flowing]:
        return {}

    @cached_property
    def _means(self) -> dict[int, MeanStates]:
        return {}


@contextmanager
def _saying(time: Fraction) -> Generator[None]:
    """Where the time is over, at which state that was."""
    try:
        yield
    except TimeoutError:
        raise PrecisionError(f"t = {written(time)}: the time was over") from None


def _meeting(one: State, other: State) -> State:
    pairs = (zip(x, y, strict=True) for x, y in zip(one, other, strict=True))
    with working(max(value.bits() for part in (*one, *other) for value in part) + 32):
        q, omega = ([x.intersection(y) for x, y in pair] for pair in pairs)
        return q, omega
