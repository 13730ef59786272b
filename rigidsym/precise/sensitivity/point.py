"""Sensitivities of one motion whose inputs are exact, at one precision."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from flint import arb

from rigidsym.precise.amplitude import Functions
from rigidsym.precise.balls import ball, power
from rigidsym.precise.sensitivity.columns import INPUTS, NUMBERS, Columns, axes_of, parameters
from rigidsym.precise.sensitivity.elapsed import elapsed
from rigidsym.precise.theta import Theta


@dataclass(frozen=True)
class Point:
    """Moments (3) and rates (3), exactly, and the unit attitude (4) at t = 0."""

    inertia: Sequence[Fraction]
    omega0: Sequence[Fraction]
    start: Sequence[arb]

    def at(self, time: Fraction, attitude: Sequence[arb]) -> list[arb]:
        """Sensitivities row by row, with the attitude then: see `listed`."""
        t = ball(time)
        if not any(self.omega0):
            return listed(self._at_rest(t, attitude))
        functions = elapsed(t, *self._parameters, self._functions)
        rates = self._columns.rates(t, functions._asdict())
        return listed({**rates, **self._columns.turned(t, rates, attitude)})

    def _at_rest(self, t: arb, attitude: Sequence[arb]) -> Mapping[str, Any]:
        """Without rates there is nothing but what begins to turn, and goes on."""
        rotation = self._columns.rotation(attitude)
        known: dict[str, Any] = dict.fromkeys(NAMES, 0)
        for i in NUMBERS:
            known[f"Omega{i}_by_Omega{i}"] = 1
            known |= {f"eta{i}_by_Omega{k}": t * rotation[f"R{i}{k}"] for k in NUMBERS}
        return known

    @cached_property
    def _functions(self) -> Functions:
        return Theta()

    @cached_property
    def _axes(self) -> Sequence[int]:
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


def _names(change: str) -> list[list[str]]:
    """Of three rows: by the small turn at t = 0, by rates and moments."""
    return [
        [*(f"{change}{i}_by_eta{k}" for k in NUMBERS), *(f"{change}{i}_by_{y}" for y in INPUTS)]
        for i in NUMBERS
    ]


BY_TIME = [f"{x}{k}_by_t" for x in ("eta", "Omega") for k in NUMBERS]
NAMES = [*(name for x in ("eta", "Omega") for row in _names(x) for name in row), *BY_TIME]
# What a small turn in space at t = 0 does: it stays, and the body does not feel it.
STAYS = {f"{x}{i}_by_eta{k}": int(x == "eta" and i == k)
         for x in ("eta", "Omega") for i in NUMBERS for k in NUMBERS}  # fmt: skip


def listed(found: Mapping[str, Any]) -> list[arb]:
    """The small turn (3, 9), the rates (3, 9), and both by the time (3 each), one after another."""
    known = {**found, **STAYS}
    return [ball(known[name]) for name in NAMES]
