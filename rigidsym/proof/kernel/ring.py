"""Elements of a differential ring: a polynomial over a product of declared units; D is d/dt."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import comb, prod
from operator import add, mul, sub, truediv
from typing import Any, TypeAlias

from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, PolyRing

from rigidsym.proof.kernel.language import KernelError, Tree, parse

Divided: TypeAlias = tuple[list[PolyElement], PolyElement]  # cofactors and remainder
Number: TypeAlias = Any  # a rational number, of the class that SymPy computes with here
_ARITHMETIC: dict[Any, Any] = {"+": add, "-": sub, "*": mul, "/": truediv}


def at(polynomial: PolyElement, point: Sequence[Number]) -> Number:
    """The value at a rational point, given in the order of the ring's generators."""
    return sum(x * prod(map(pow, point, powers)) for powers, x in polynomial.terms())


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """numerator / product of units**powers, in one `Ring`."""

    ring: "Ring"
    numerator: PolyElement
    powers: tuple[int, ...]

    def over(self, powers: tuple[int, ...]) -> PolyElement:
        """The numerator this element has when written over a larger denominator."""
        gaps = zip(self.ring.units, map(sub, powers, self.powers), strict=True)
        return prod((unit**gap for unit, gap in gaps if gap), start=self.numerator)

    def __add__(self, other: "Element | PolyElement | int") -> "Element":
        other = self.ring.element(other)
        powers = tuple(map(max, self.powers, other.powers))
        return Element(self.ring, self.over(powers) + other.over(powers), powers)

    def __mul__(self, other: "Element | PolyElement | int") -> "Element":
        other = self.ring.element(other)
        powers = tuple(map(add, self.powers, other.powers))
        return Element(self.ring, self.numerator * other.numerator, powers)

    def __sub__(self, other: "Element | PolyElement | int") -> "Element":
        return self + self.ring.element(other) * -1

    def __truediv__(self, other: "Element | PolyElement | int") -> "Element":
        return self * self.ring.inverse(self.ring.element(other))

    def __pow__(self, exponent: int) -> "Element":
        terms = max(len(self.numerator), 1)
        if not 1 <= exponent <= 64 or comb(terms + exponent - 1, exponent) > 100_000:
            raise KernelError(f"power {exponent} of {terms} terms: too large, or not from 1 to 64")
        powers = tuple(exponent * power for power in self.powers)
        return Element(self.ring, self.numerator**exponent, powers)

    __radd__, __rmul__ = __add__, __mul__


class Ring:
    """Q[generators] localised at the units, with the names and the derivation of a context.

    Later generators are larger (lexicographic order): a relation that introduces a root or a
    function value leads with it, and division by the relations is the normal form.
    """

    def __init__(self, generators: tuple[str, ...], definitions: Mapping[str, str]) -> None:
        self.poly = PolyRing(generators[::-1], QQ, lex)
        self.unread = dict(definitions)
        self.units: tuple[PolyElement, ...] = ()
        self.relations: tuple[PolyElement, ...] = ()
        self.rates: dict[str, Element | None] | None = None
        self.names = {str(generator): self.element(generator) for generator in self.poly.gens}

    def element(self, value: Element | PolyElement | Number | int) -> Element:
        """Coerce a number, a polynomial, or an element made before all units were declared."""
        ready = isinstance(value, Element)
        numerator, powers = (value.numerator, value.powers) if ready else (self.poly(value), ())
        return Element(self, numerator, powers + (0,) * (len(self.units) - len(powers)))

    def inverse(self, element: Element) -> Element:
        """1/element; refused unless its numerator is a number times a product of units."""
        powers, rest = self._factors(element.numerator)
        if not rest.is_ground:
            powers, rest = self._factors(self.reduce(element.numerator)[1])
        if not rest or not rest.is_ground:
            raise KernelError(f"1/({element.numerator!s:.99}): no product of the declared units")
        return Element(self, self.element(1 / rest.LC).over(element.powers), powers)

    def _factors(self, polynomial: PolyElement) -> tuple[tuple[int, ...], PolyElement]:
        """The powers of units that divide a polynomial, and what is left."""
        powers = [0] * len(self.units)
        for k, unit in enumerate(self.units):
            while not polynomial.is_ground and not unit.is_ground:
                quotient, rest = polynomial.div(unit)
                if rest:
                    break
                polynomial, powers[k] = quotient, powers[k] + 1
        return tuple(powers), polynomial

    def reduce(self, polynomial: PolyElement, *given: PolyElement) -> Divided:
        """Cofactors and remainder of division by the relations; remainder 0 proves membership."""
        divisors = [*given, *self.relations]
        if not divisors or not polynomial:
            return [self.poly(0)] * len(divisors), polynomial
        return polynomial.div(divisors)

    def rate(self, element: Element) -> Element:
        """D(p / prod u**k) = (D(p) - p sum k D(u)/u) / prod u**k"""
        if self.rates is None:
            raise KernelError(f"D({element.numerator}): this context has no time derivative")
        total = self.element(0)
        for name, rate in self.rates.items():
            if slope := element.numerator.diff(self.names[name].numerator):
                if rate is None:
                    raise KernelError(f"D({name}) is not known in this context")
                total += self.element(slope) * rate
        for unit, power in zip(map(self.element, self.units), element.powers, strict=True):
            if power:
                total -= self.rate(unit) * element.numerator * power / unit
        return total * Element(self, self.poly(1), element.powers)

    def name(self, name: str) -> Element:
        """A generator, or what a definition abbreviates; inside itself it means nothing."""
        if name not in self.names:
            if name not in self.unread:
                raise KernelError(f"{name!r} has no meaning here")
            self.names[name] = self.read(self.unread.pop(name))
        return self.element(self.names[name])

    def read(self, text: str) -> Element:
        """What an expression means: names are known, divisions are covered by the units."""
        return self._value(parse(text))

    def _value(self, tree: Tree) -> Element:
        match tree:
            case int():
                return self.element(tree)
            case str():
                return self.name(tree)
            case ("-", operand):
                return self._value(operand) * -1
            case ("D", "(", argument):
                return self.rate(self._value(argument))
            case (function, "(", *_):
                raise KernelError(f"{function}(...) has no meaning here, or not of so many")
            case (base, "**", int(exponent)):
                return self._value(base) ** exponent
        total = self._value(tree[0])
        for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
            total = _ARITHMETIC[operator](total, self._value(operand))
        return total
