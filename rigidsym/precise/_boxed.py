"""Enclosures of all motions that start in a box of uncertain inputs.

They follow from the mean value theorem, and from Taylor series of the flow.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb

from rigidsym._inputs import is_uncertain
from rigidsym.errors import InputError, PrecisionError, written
from rigidsym.precise._balls import AdaptivePrecision, TooUncertainError, is_within, working
from rigidsym.precise._evaluation import State
from rigidsym.precise._lohner import MOST_STEPS, FlowEnclosure, bits_for
from rigidsym.precise._motion import PreciseMotion
from rigidsym.precise._regime import MotionInputs
from rigidsym.precise._sensitivity.parts import MeanStates

# Steps of the flow that take a fraction of a second.
FEW_STEPS = 100


@dataclass(frozen=True)
class BoxedMotion(MotionInputs):
    """The set of all motions whose uncertain inputs lie in a box."""

    def enclosures(
        self,
        times: Sequence[Fraction],
        digits: int,
        max_seconds: float | None = None,
        method: str | None = None,
    ) -> Iterator[State]:
        """Yield attitude and rates at each time as balls that enclose all motions.

        method: "mean", the mean value theorem alone; "flow", the flow alone; by default the best
        of both, see `_best`.  Raises PrecisionError where `max_seconds` for all times are over, and
        where the mean value theorem alone gives no enclosure.
        """
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        by = {None: self._best, "mean": self._by_mean_value, "flow": self._by_flow}[method]
        for time in times:
            try:
                found = by(precision, time)
            except TimeoutError:
                raise PrecisionError(f"t = {written(time)}: the time was over") from None
            yield found

    def sensitivities(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[list[arb]]:
        """Yield the states and sensitivities of all motions at each time as balls.

        A row has (q, omega) and the numbers of `columns.listed`.

        Raises PrecisionError where they are too uncertain.
        """
        states = self.enclosures(times, digits, max_seconds)
        for time, (q, omega) in zip(times, states, strict=True):
            found = self._mean_states(digits).sensitivities(time)
            if found is None:
                raise self._too_uncertain(time, digits)
            yield [*q, *omega, *found]

    def _best(self, precision: AdaptivePrecision, time: Fraction) -> State:
        """Return the sharpest available enclosure of the state.

        It follows from the mean value theorem, over parts of the box if necessary.

        It is intersected with the state by the flow where some part has no enclosure.  Rates that
        are constant in all of the box have formulas of their own.
        """
        mean = self._mean_states(precision.digits)
        if time == 0 or mean.holds_rest:
            return self._by_flow(precision, time)
        try:
            steady = self._steady.read(precision, time) if self._steady else None
        except TooUncertainError:  # the rates of some motion change
            steady = None
        if steady and not is_uncertain(*self.omega0, *self.attitude0):
            return steady
        state, is_found = mean.state(time, precision.check)
        if not is_found:
            state = _intersection(state, self._by_flow(precision, time, FEW_STEPS))
        return _intersection(state, steady) if steady else state

    def _by_mean_value(self, precision: AdaptivePrecision, time: Fraction) -> State:
        state, is_found = self._mean_states(precision.digits).state(time, precision.check)
        if not is_found:
            raise self._too_uncertain(time, precision.digits)
        return state

    def _by_flow(
        self, precision: AdaptivePrecision, time: Fraction, most: int = MOST_STEPS
    ) -> State:
        bits = bits_for(self, precision.digits)
        if bits not in self._flows:
            self._flows.clear()
            self._flows[bits] = FlowEnclosure(self, bits, precision.check)
        return self._flows[bits].state(time, precision.check, most)

    @cached_property
    def _steady(self) -> PreciseMotion | None:
        motion = PreciseMotion(self.inertia, self.omega0, self.attitude0)
        try:
            return motion if motion.polhode.regime.steady else None
        except InputError:
            return None

    def _mean_states(self, digits: int) -> MeanStates:
        bits = bits_for(self, digits)
        if bits not in self._means:
            self._means.clear()
            self._means[bits] = MeanStates(self.inertia, self.omega0, self.attitude0, bits)
        return self._means[bits]

    def _too_uncertain(self, time: Fraction, digits: int) -> TooUncertainError:
        return TooUncertainError(f"t = {written(time)}: {self._mean_states(digits).reason}")

    @cached_property
    def _flows(self) -> dict[int, FlowEnclosure]:
        """The enclosure by Taylor series of the flow, cached for the last precision.

        It has all steps made so far.
        """
        return {}

    @cached_property
    def _means(self) -> dict[int, MeanStates]:
        """The enclosure by the mean value theorem, cached for the last precision."""
        return {}


def _intersection(one: State, other: State) -> State:
    pairs = (zip(x, y, strict=True) for x, y in zip(one, other, strict=True))
    with working(max(value.bits() for part in (*one, *other) for value in part) + 32):
        q, omega = ([x.intersection(y) for x, y in pair] for pair in pairs)
        return q, omega
