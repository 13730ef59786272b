"""Sensitivities of one motion whose inputs are exact, at one precision."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from flint import arb

from rigidsym.precise.amplitude import Functions
from rigidsym.precise.balls import ball, power
from rigidsym.precise.sensitivity.columns import INPUTS, NUMBERS, Columns, axes_of, parameters
from rigidsym.precise.sensitivity.elapsed import elapsed
from rigidsym.precise.theta import Theta

# Of the small turn in space and of the rates, three each: by the inputs, then by the time.
NAMES = [
    *(f"{x}{k}_by_{y}" for x in ("eta", "Omega") for y in INPUTS for k in NUMBERS),
    *(f"{x}{k}_by_t" for x in ("eta", "Omega") for k in NUMBERS),
]


@dataclass(frozen=True)
class Point:
    """Moments (3) and rates (3), exactly, and the unit attitude (4) at t = 0."""

    inertia: Sequence[Fraction]
    omega0: Sequence[Fraction]
    start: Sequence[arb]

    def at(self, time: Fraction, attitude: Sequence[arb]) -> list[arb]:
        """What `NAMES` names, with the attitude then."""
        t = ball(time)
        functions = elapsed(t, *self._parameters, self._functions)
        rates = self._columns.rates(t, functions._asdict())
        found = self._columns.turned(t, rates, attitude)
        return [ball(found[name]) for name in NAMES]

    @cached_property
    def _functions(self) -> Functions:
        return Theta()

    @cached_property
    def _axes(self) -> tuple[int, ...]:
        return axes_of(self.inertia, self.omega0)

    @cached_property
    def _parameters(self) -> list[arb]:
        """p, r and p - r, zero where they are."""
        return list(map(ball, parameters(self.inertia, self.omega0, self._axes)))

    @cached_property
    def _columns(self) -> Columns:
        inertia, omega0 = (list(map(ball, values)) for values in (self.inertia, self.omega0))
        is_sphere = len({*self.inertia}) == 1
        return Columns(inertia, omega0, self.start, self._axes, {"power": power}, is_sphere)
