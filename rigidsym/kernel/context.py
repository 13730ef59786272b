"""Contexts: the hypotheses of a fact, written as a differential ring.

It is refused when its relations are not closed under d/dt (then they could hold at one instant
only) or when its rational witness does not satisfy it (then it might be empty, and everything
would be "proved" about nothing).
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from rigidsym.kernel.ring import KernelError, Ring


@dataclass(frozen=True, slots=True)
class Context:
    """generators, relations = 0, units != 0, nonnegative names >= 0  |-  ...

    `definitions` abbreviate expressions.  `rates` maps generators to time derivatives: what it does
    not name is constant, "?" says unknown, None is an instant.  `reading` proves nothing.
    """

    name: str
    generators: tuple[str, ...]
    witness: Mapping[str, str]
    units: tuple[str, ...] = ()
    definitions: Mapping[str, str] = field(default_factory=dict)
    relations: tuple[str, ...] = ()
    rates: Mapping[str, str] | None = None
    nonnegative: tuple[str, ...] = ()
    reading: Mapping[str, str] = field(default_factory=dict)

    def open(self) -> Ring:
        """The ring of this context; raises KernelError unless it is closed and inhabited."""
        names, moving = [*self.generators, *self.definitions], {*(self.rates or ())}
        ring = Ring(self.generators, self.definitions)
        if len({*names}) < len(names) or not moving <= {*ring.names} == {*self.generators}:
            raise KernelError(f"context {self.name}: a name is no name, or means two things")
        for unit in self.units:
            ring.units += (ring.read(unit).numerator,)
        ring.relations = tuple(ring.read(relation).numerator for relation in self.relations)
        if self.rates is not None:
            rates = self.rates.items()
            ring.rates = {name: None if text == "?" else ring.read(text) for name, text in rates}
        ring.names |= {name: ring.read(name) for name in self.definitions}
        self.check_point(ring, self.witness)
        for relation in ring.relations if ring.rates is not None else ():
            if ring.reduce(ring.rate(ring.element(relation)).numerator)[1]:
                raise KernelError(f"context {self.name}: {relation} = 0 is not closed under d/dt")
        return ring

    def check_point(self, ring: Ring, values: Mapping[str, str]) -> list[tuple[Any, Any]]:
        """The rational point, if it gives every generator and satisfies all hypotheses."""
        if set(values) != set(self.generators):
            wrong = sorted(set(values) ^ set(self.generators))
            raise KernelError(f"context {self.name}: a point must give each generator: {wrong}")
        number = Ring((), {}).read  # without generators only rational numbers can be read
        point = [(ring.names[n].numerator, number(v).numerator.coeff(1)) for n, v in values.items()]
        broken = [f"{unit} = 0" for unit in ring.units if not unit.evaluate(point)]
        broken += [f"{relation} != 0" for relation in ring.relations if relation.evaluate(point)]
        for name in self.nonnegative:
            element = ring.read(name)  # p/u has the sign of p*u
            if element.over(tuple(2 * power for power in element.powers)).evaluate(point) < 0:
                broken.append(f"{name} < 0")
        if broken:
            raise KernelError(f"context {self.name}: {broken[0]} at {dict(values)}")
        return point
