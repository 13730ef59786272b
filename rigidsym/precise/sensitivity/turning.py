"""What the turn since t = 0 changes by, seen in the body: there no wide number meets another.

The columns of numbers are those of `Columns.turned`, seen in space, where all that the rates leave
open is turned by what the attitude does.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb

from rigidsym.precise.sensitivity.columns import KINDS, NUMBERS, Columns, Named
from rigidsym.solution.formulas import sequence

TURN = [f"q{k}" for k in range(4)]
RATES = [f"Omega{k}" for k in NUMBERS]


@dataclass(frozen=True)
class Turning:
    """What the rates of a motion at a time leave to find: what its turn changes by.

    directions: how much of each input there is in each direction (m), by the names of inputs.
    """

    columns: Columns
    t: Any
    rates: Mapping[str, Any]
    directions: Mapping[str, Sequence[arb]]

    def of(self, turn: Sequence[Any]) -> list[list[Any]]:
        """Rows (4, m), the turn being a quaternion (4)."""
        rotation = self.columns.rotation(turn)
        known = {**rotation, **self._given}
        found = []
        for change, momentum in self._changes:
            seen = {
                f"l{i}": combined(momentum, [rotation[f"R{k}{i}"] for k in NUMBERS])
                for i in NUMBERS
            }
            column = sequence("turned_body").evaluate(
                {**known, **change, **seen}, self.columns.functions
            )
            found.append([column[f"d{x}"] for x in TURN])
        return [list(row) for row in zip(*found, strict=True)]

    @property
    def of_rates(self) -> list[list[Any]]:
        """Rows (3, m) of the rates."""
        return [[change[f"d{x}"] for change, _ in self._changes] for x in RATES]

    @cached_property
    def _given(self) -> Named:
        known: Named = {"K": self.columns.begun["K_squared"].sqrt()}
        for k, c in enumerate(self.columns.inertia, 1):
            known |= {f"c{k}": c, f"Omega{k}": self.rates[f"Omega{k}"]}
        return known

    @cached_property
    def _changes(self) -> list[tuple[Named, list[Any]]]:
        """Along each direction what does not hang on the turn, and the momentum at t = 0 (3)."""
        return [self._change(parts) for parts in zip(*self.directions.values(), strict=True)]

    def _change(self, parts: Sequence[arb]) -> tuple[Named, list[Any]]:
        """A rate or a moment about axis k moves the momentum along that axis."""
        share = dict(zip(self.directions, parts, strict=True))
        change: Named = {}
        ways = {
            way: combined(parts, [self.rates[f"{parameter}_by_{name}"] for name in share])
            for way, parameter in (("k", "p"), ("r", "apart"))
        }
        for x in RATES:
            values = [self.rates[f"{x}_at_{name}"] for name in share]
            change[f"d{x}"] = (
                combined(parts, values)
                + ways["k"] * self.rates[f"{x}_k"]
                - ways["r"] * self.rates[f"{x}_r"]
            )
        momentum, along = [], []
        for k, (c, w) in enumerate(zip(self.columns.inertia, self.columns.omega0, strict=True), 1):
            by_rate, by_moment = (share.get(f"{x}{k}", arb(0)) for x in KINDS)
            change[f"dc{k}"] = by_moment
            momentum.append(combined([by_rate, by_moment], [c, w]))
            excess = self.rates[f"excess{k}"] / -2
            along.append(combined([by_rate * self.t, by_moment], [c * w, excess]))
        return {**change, "s": combined([arb(1)] * 3, along)}, momentum


def combined(parts: Sequence[Any], values: Sequence[Any]) -> Any:
    """Return the linear combination of the values."""
    terms = [x * part for part, x in zip(parts, values, strict=True) if not _is_zero(part)]
    return sum(terms[1:], terms[0]) if terms else 0


def _is_zero(value: Any) -> bool:
    return not value if isinstance(value, int) else isinstance(value, arb) and value.is_zero()
