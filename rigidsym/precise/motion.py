"""States of one motion to any number of digits, each of them certain.

Inputs are exact rationals, and the invariants, the parameter m and the regime are computed
exactly; all that follows is done with Arb's balls, at a working precision that rises until the
balls are small enough.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import chain

from flint import arb
from mpmath import mp, mpf

from rigidsym import inputs
from rigidsym.errors import written
from rigidsym.inputs import Number
from rigidsym.precise import apart
from rigidsym.precise.adaptive import GUARD_BITS, AdaptivePrecision
from rigidsym.precise.apart import Asked, Sensitive
from rigidsym.precise.balls import ball, bits_of, has_digits, is_within, to_mpf, working
from rigidsym.precise.carlson import Carlson
from rigidsym.precise.estimates import ByMpmath, ByTheorem1, Estimates
from rigidsym.precise.evaluation import Evaluation, State
from rigidsym.precise.landen import Landen
from rigidsym.precise.quadrature import Quadrature
from rigidsym.precise.theta import Theta
from rigidsym.precise.uncertain import classify_uncertain
from rigidsym.solution.polhode import Polhode

# How many precisions a motion keeps its constants for.
KEPT = 4
# By balls, which contain the true values, and by numbers whose errors are estimated.
METHODS = {"theta": Theta, "carlson": Carlson, "landen": Landen, "quadrature": Quadrature}
ESTIMATED = {"mpmath": ByMpmath, "theorem1": ByTheorem1}
# Inertia, omega0 and attitude0.
Inputs = tuple[tuple[Fraction, ...], tuple[Fraction, ...], tuple[Fraction, ...]]
# (q, omega) as mpf numbers.
DecimalState = tuple[list[mpf], list[mpf]]


@dataclass(frozen=True)
class PreciseMotion:
    """A motion: inertia (3), body rates (3), attitude (4), rationals or uncertain numbers."""

    inertia: tuple[Number, ...]
    omega0: tuple[Number, ...]
    attitude0: tuple[Number, ...]
    method: str = "theta"

    @cached_property
    def polhode(self) -> Polhode:
        """Regime and axes, decided exactly; InputError where uncertainty leaves them open."""
        return classify_uncertain(self.inertia, self.omega0)

    @property
    def exact(self) -> Inputs:
        """Inertia, omega0 and attitude0; InputError where one is uncertain."""
        given = {"inertia": self.inertia, "omega0": self.omega0, "attitude0": self.attitude0}
        inertia, omega0, attitude0 = (inputs.certain(*named) for named in given.items())
        return inertia, omega0, attitude0

    @property
    def _is_uncertain(self) -> bool:
        return inputs.is_uncertain(*self.inertia, *self.omega0, *self.attitude0)

    def states(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[DecimalState]:
        """(q, omega) at each time as mpf numbers, `digits` significant digits of each certain.

        Raises PrecisionError where `max_seconds` for them all are over.
        """
        precision = AdaptivePrecision(digits, has_digits, max_seconds)
        for time in times:
            settled = [_settled(value) for value in chain(*self.read(precision, time))]
            yield settled[:4], settled[4:]

    def enclosures(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[State]:
        """(q, omega) at each time as balls, of radius at most 10^-digits max(1, |value|)."""
        precision = AdaptivePrecision(digits, is_within, max_seconds)
        for time in times:
            yield self.read(precision, time)

    def read(self, precision: AdaptivePrecision, time: Fraction) -> State:
        """(q, omega) at one time as balls, as good as they are wanted."""
        read = precision.read_uncertain if self._is_uncertain else precision.read
        found = read(partial(self.numbers, time), f"t = {written(time)}")
        return found[:4], found[4:]

    def sensitivities(
        self,
        times: Sequence[Fraction],
        digits: int,
        max_seconds: float | None = None,
        enough: Callable[[arb, int], bool] = is_within,
    ) -> Iterator[list[arb]]:
        """At each time (q, omega) and what `sensitivity.point.listed` lists, as good as `enough`
        says.

        Raises InputError where inputs are uncertain, and PrecisionError where `max_seconds` for all
        times are over.
        """
        precision = AdaptivePrecision(digits, enough, max_seconds)
        for time in times:
            asked = Sensitive(time)
            yield precision.read(partial(self.numbers, asked), f"t = {written(time)}")

    def decimal_sensitivities(
        self, times: Sequence[Fraction], digits: int, max_seconds: float | None = None
    ) -> Iterator[list[mpf]]:
        """The same as mpf numbers, `digits` significant digits of each certain."""
        for row in self.sensitivities(times, digits, max_seconds, has_digits):
            yield list(map(_settled, row))

    def start(self, digits: int) -> list[float]:
        """The attitude at t = 0, normalised and rounded to doubles."""
        with working(bits_of(digits) + GUARD_BITS):
            return [float(x) for x in self._at(bits_of(digits) + GUARD_BITS).start[0]]

    def constants(self, names: Sequence[str], digits: int) -> dict[str, mpf]:
        """Constants of the motion by name, `digits` digits each; the rates must not be constant."""
        precision = AdaptivePrecision(digits, has_digits, None)
        found = precision.read(partial(self.numbers, tuple(names)), "constants")
        return dict(zip(names, map(_settled, found), strict=True))

    def numbers(self, asked: Asked, bits: int, end: float | None) -> list[arb]:
        """What is asked, from balls of so many bits; TimeoutError where the clock passes `end`.

        What may take long is computed by a process that can be ended.
        """
        if bits <= {**METHODS, **ESTIMATED}[self.method].quick_bits:
            return self.numbers_here(asked, bits)
        return apart.numbers(self, asked, bits, end)

    def numbers_here(self, asked: Asked, bits: int) -> list[arb]:
        """The seven numbers of the state at a time, or constants by their names."""
        with working(bits):
            return self._at(bits).numbers(asked)

    def _at(self, bits: int) -> Evaluation[arb] | Estimates:
        """The formulas at the working precision, whose bits these are; the last few are kept."""
        kept = self._kept
        if bits not in kept:
            while len(kept) >= KEPT:
                del kept[next(iter(kept))]
            kept[bits] = self._evaluation(bits)
        return kept[bits]

    def _evaluation(self, bits: int) -> Evaluation[arb] | Estimates:
        if self.method in ESTIMATED:
            return ESTIMATED[self.method](self, bits)
        return Evaluation(self, METHODS[self.method]().table(), ball)

    @cached_property
    def _kept(self) -> dict[int, Evaluation[arb] | Estimates]:
        return {}

    def __reduce__(self) -> tuple[type["PreciseMotion"], tuple[tuple[Number, ...] | str, ...]]:
        """What it was made from: balls do not travel."""
        return PreciseMotion, (self.inertia, self.omega0, self.attitude0, self.method)


def _settled(value: arb) -> mpf:
    return mp.zero if value.contains(0) else to_mpf(value)
