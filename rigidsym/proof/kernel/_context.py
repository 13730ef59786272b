"""Contexts: differential rings with hypotheses.

A context is refused when its relations are not closed under d/dt (they could hold at one instant
only) or its rational witness does not satisfy it (it might be empty, and prove everything).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from rigidsym.proof.kernel._language import KernelError, is_name, parse
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

    def ring(self, *more: str) -> Ring:
        """Return the ring of this context, with further generators, or raise KernelError."""
        ring = Ring((*self.generators, *more), self.definitions)
        names = [*self.generators, *more, *self.definitions]
        if len({*names}) < len(names) or not all(map(is_name, names)) or "D" in names:
            raise KernelError("a name is no name, or means two things")
        for unit in self.units:
            ring.units += (ring.read(unit).numerator,)
        ring.relations = tuple(ring.read(relation).numerator for relation in self.relations)
        if self.rates is not None:
            ring.rates = {n: None if t == "?" else ring.read(t) for n, t in self.rates.items()}
        return ring

    def open(self) -> Ring:
        """Check the context and return its ring, or raise KernelError."""
        if not {*(self.rates or ())} <= {*self.generators}:
            raise KernelError("a rate of what is no generator")
        ring = self.ring()
        for name in self.definitions:
            ring.read(name)
        point = self.check_point(ring, self.witness)
        if any(self.rates is None or at(ring.read(text).numerator, point) for text in self.start):
            raise KernelError("its witness is not where it starts")
        if self.thetas:
            Thetas(self.ring("I"), self.thetas).check()
        for relation in ring.relations if self.rates is not None else ():
            if ring.remainder(ring.rate(Element(relation)).numerator):
                raise KernelError(f"{relation} = 0 is not closed under d/dt")
        return ring

    def check_point(self, ring: Ring, values: Mapping[str, str]) -> list[Number]:
        """Return the coordinates of a point, or raise KernelError if a hypothesis fails there."""
        if missing := sorted(values.keys() ^ {*self.generators}):
            raise KernelError(f"a point must give each generator: {missing}")
        point = [_NUMBERS.read(values[x]).numerator.coeff(1) for x in reversed(self.generators)]
        broken = [f"{unit} = 0" for unit in ring.units if not at(unit, point)]
        broken += [f"{relation} != 0" for relation in ring.relations if at(relation, point)]
        for sign in map(ring.read, self.nonnegative):
            value = at(sign.over(sign.below + sign.below), point)  # p/u as p*u
            still = value or self.rates is None or not ring.remainder(ring.rate(sign).numerator)
            if value < 0 or not still:
                broken.append(f"{sign.numerator} < 0, or 0 and about to change,")
        if broken:
            raise KernelError(f"{broken[0]} at {dict(values)}")
        return point

    def check_signs(self, texts: Iterable[str]) -> None:
        """Raise KernelError unless all expressions are visibly nonnegative."""
        waiting, seen = [*map(parse, texts)], {*map(parse, self.nonnegative)}
        while waiting:
            if (tree := waiting.pop()) in seen or isinstance(tree, int):
                continue
            seen.add(tree)
            match tree:  # nonnegative names, combined by +, *, / or even powers
                case str() if tree in self.definitions:
                    waiting.append(parse(self.definitions[tree]))
                case (base, "**", int(exponent)):
                    waiting += [base] if exponent % 2 else []
                case (*front, "+" | "*" | "/", last):
                    waiting += [tuple(front) if len(front) > 1 else front[0], last]
                case _:
                    raise KernelError(f"{tree} >= 0 is not visible in {self.name}")

    def said(self) -> dict[str, str]:
        """Return the definitions and known time derivatives of the context as expressions."""
        rates = {} if self.rates is None else dict.fromkeys(self.generators, "0") | {**self.rates}
        known = {f"D({name})": text for name, text in rates.items() if text != "?"}
        return {**self.definitions, **known}

    def cases(self, name: str) -> "tuple[Context, ...]":
        """Return the cases of this context in which a name is zero, positive or negative."""
        nonzero = replace(self, units=(*self.units, name))
        signs = [replace(nonzero, nonnegative=(*self.nonnegative, x)) for x in (name, f"-{name}")]
        return replace(self, relations=(*self.relations, name)), *signs  # with the same witness
