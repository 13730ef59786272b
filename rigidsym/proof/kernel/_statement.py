"""Contexts, which are differential rings with hypotheses, and facts about them.

A context is refused when its relations are not closed under d/dt (they could hold at one instant
only) or its rational witness does not satisfy it (it might be empty, and prove everything).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from rigidsym.proof.kernel._language import KernelError, is_name
from rigidsym.proof.kernel._ring import Element, Number, Ring, at
from rigidsym.proof.kernel._theta import Thetas

_NUMBERS = Ring((), {})  # without generators only rational numbers can be read


@dataclass(frozen=True, slots=True)
class Context:
    """A differential ring defined by named quantities and hypotheses about them.

    One may divide by units.  `witness` is a rational point, `definitions` abbreviate expressions,
    `reading` says what names stand for.  `rates` maps generators to rates: others are constant,
    "?" is unknown, None an instant.  `start` is zero at one instant; `thetas` are theta functions.
    """

    name: str
    generators: tuple[str, ...]
    witness: Mapping[str, str]
    units: tuple[str, ...] = ()  # are not zero
    definitions: Mapping[str, str] = field(default_factory=dict)
    relations: tuple[str, ...] = ()  # are zero
    rates: Mapping[str, str] | None = None
    nonnegative: tuple[str, ...] = ()  # are at least zero
    start: tuple[str, ...] = ()
    thetas: Mapping[str, str] = field(default_factory=dict)
    reading: Mapping[str, str] = field(default_factory=dict)

    def open(self) -> Ring:
        """Check the context and return its ring, or raise KernelError."""
        names = [*self.generators, *self.definitions]
        if len({*names}) < len(names) or not all(map(is_name, [self.name, *names])) or "D" in names:
            raise KernelError(f"context {self.name!a}: a name is no name, or means two things")
        if not {*(self.rates or ())} <= {*self.generators}:
            raise KernelError(f"context {self.name}: a rate of what is no generator")
        ring = Ring(self.generators, self.definitions)
        for unit in self.units:
            ring.units += (ring.read(unit).numerator,)
        ring.relations = tuple(ring.read(relation).numerator for relation in self.relations)
        if self.rates is not None:
            ring.rates = {n: None if t == "?" else ring.read(t) for n, t in self.rates.items()}
        for name in self.definitions:
            ring.read(name)
        point = self.check_point(ring, self.witness)
        if any(self.rates is None or at(ring.read(text).numerator, point) for text in self.start):
            raise KernelError(f"context {self.name}: its witness is not where it starts")
        Thetas(ring, self.thetas).check(self.rates)
        for relation in ring.relations if self.rates is not None else ():
            if ring.remainder(ring.rate(Element(relation)).numerator):
                raise KernelError(f"context {self.name}: {relation} = 0 is not closed under d/dt")
        return ring

    def check_point(self, ring: Ring, values: Mapping[str, str]) -> list[Number]:
        """Return the coordinates of a point, or raise KernelError if a hypothesis fails there."""
        if missing := sorted(values.keys() ^ {*self.generators}):
            raise KernelError(f"context {self.name}: a point must give each generator: {missing}")
        point = [_NUMBERS.read(values[x]).numerator.coeff(1) for x in reversed(self.generators)]
        broken = [f"{unit} = 0" for unit in ring.units if not at(unit, point)]
        broken += [f"{relation} != 0" for relation in ring.relations if at(relation, point)]
        for sign in map(ring.read, self.nonnegative):
            value = at(sign.over(sign.below + sign.below), point)  # p/u as p*u
            still = value or self.rates is None or not ring.remainder(ring.rate(sign).numerator)
            if value < 0 or not still:
                broken.append(f"{sign.numerator} < 0, or 0 and about to change,")
        if broken:
            raise KernelError(f"context {self.name}: {broken[0]} at {dict(values)}")
        return point

    def cases(self, name: str) -> tuple["Context", "Context", "Context"]:
        """Return the cases of this context in which a name is zero, positive or negative."""
        zero = replace(self, relations=(*self.relations, name))  # with the same witness
        nonzero = replace(self, units=(*self.units, name))
        positive = replace(nonzero, nonnegative=(*self.nonnegative, name))
        negative = replace(nonzero, nonnegative=(*self.nonnegative, f"-{name}"))
        return zero, positive, negative


class Grade(StrEnum):
    """Grade of a fact: assumed, confirmed by ball arithmetic, or proved."""

    ASSUMED = "ASSUMED"  # from worst to best
    ENCLOSED = "ENCLOSED"
    PROVED = "PROVED"


def weakest(grades: Iterable[Grade]) -> Grade:
    """Return the weakest of several grades."""
    return min(grades, key=list(Grade).index)


@dataclass(frozen=True, slots=True)
class Fact:
    """A statement in a context, trusted only after `Ledger.add` has admitted it.

    By `kind` and componentwise it states: "equal", lhs = rhs; "root", lhs = +sqrt(rhs);
    "nonnegative", lhs = rhs >= 0; "unequal", both sides differ at some point; "model", the context
    is a model of that in rhs; "partition", each of its points is in exactly one of those in rhs.
    """

    id: str
    context: str
    kind: str
    lhs: tuple[str, ...]
    rhs: tuple[str, ...]
    rule: str
    grade: Grade = Grade.PROVED
    premises: tuple[str, ...] = ()
    source: tuple[str, ...] = ()
    certificate: Mapping[str, Any] = field(default_factory=dict)
