"""States of all motions whose inputs lie in a box: by the theorem of the mean, and by the flow."""

from collections.abc import Generator, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb

from rigidsym.errors import InputError, PrecisionError, written
from rigidsym.inputs import Number, is_uncertain
from rigidsym.precise.adaptive import AdaptivePrecision, TooUncertainError
from rigidsym.precise.balls import is_within, working
from rigidsym.precise.evaluation import State
from rigidsym.precise.flowing import MOST_STEPS, Flowing, bits_for
from rigidsym.precise.motion import PreciseMotion
from rigidsym.precise.sensitivity.boxes import MeanStates

# Steps of the flow that take a fraction of a second.
FEW_STEPS = 100


@dataclass(frozen=True)
class BoxedMotion:
    """Motions: inertia (3), body rates (3), attitude (4), some of these numbers uncertain."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]

    def enclosures(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """(q, omega) at each time as balls: by the theorem of the mean, over parts of the box
        where it has to be, and by the flow where that does not serve all of the box.  Rates that
        are constant in all of the box have formulas of their own.

        Raises PrecisionError where `max_seconds` for all times are over.
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            mean = self._by_mean_values(digits)
            if time == 0 or mean.holds_rest:
                yield self._by_flow(precision, time)
                continue
            steady = self._by_regime(precision, time)
            if steady and not is_uncertain(*self.omega0, *self.attitude0):
                yield steady
                continue
            with _saying(time):
                state, is_found = mean.state(time, precision.check)
            if not is_found:
                state = _meeting(state, self._by_flow(precision, time, FEW_STEPS))
            yield _meeting(state, steady) if steady else state

    def mean_values(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """The same by the theorem of the mean alone.

        Raises PrecisionError where it says nothing.
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            mean = self._by_mean_values(digits)
            with _saying(time):
                state, is_found = mean.state(time, precision.check)
            if not is_found:
                raise self._too_uncertain(time, digits)
            yield state

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

    def _by_flow(
        self, precision: AdaptivePrecision, time: Fraction, most: int = MOST_STEPS
    ) -> State:
        with _saying(time):
            return self._flowing(precision).state(time, precision.check, most)

    def _by_regime(self, precision: AdaptivePrecision, time: Fraction) -> State | None:
        """By the formulas of constant rates; None where they do not hold for all of the box."""
        try:
            return self._steady.read(precision, time) if self._steady else None
        except TooUncertainError:
            return None

    @cached_property
    def _steady(self) -> PreciseMotion | None:
        motion = PreciseMotion(self.inertia, self.omega0, self.attitude0)
        try:
            return motion if motion.polhode.regime.steady else None
        except InputError:
            return None

    def _by_mean_values(self, digits: int) -> MeanStates:
        bits = self._bits(digits)
        if bits not in self._means:
            self._means.clear()
            self._means[bits] = MeanStates(self.inertia, self.omega0, self.attitude0, bits)
        return self._means[bits]

    def _too_uncertain(self, time: Fraction, digits: int) -> TooUncertainError:
        reason = self._by_mean_values(digits).reason
        return TooUncertainError(f"t = {written(time)}: {reason}")

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
