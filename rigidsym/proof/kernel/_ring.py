"""Differential rings: polynomial fractions whose denominators are products of units."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from math import comb, prod
from operator import or_
from typing import Any, TypeAlias

from sympy.polys.domains import QQ
from sympy.polys.monomials import monomial_divides
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyElement, xring

from rigidsym.proof.kernel._language import KernelError, Tree, parse

Number: TypeAlias = Any  # a rational number, of the class that SymPy computes with here


def at(polynomial: PolyElement, point: Sequence[Number]) -> Number:
    """Evaluate a polynomial at a point, given in the order of its ring's generators."""
    return sum(x * prod(map(pow, point, powers)) for powers, x in polynomial.items())


def _times(one: PolyElement, other: PolyElement) -> PolyElement:
    """Multiply polynomials, of which one often has a single term."""
    few, many = (one, other) if len(one) < len(other) else (other, one)
    return many.mul_term(*few.items()) if len(few) == 1 else many * few


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """A polynomial fraction whose denominator is a product of units."""

    numerator: PolyElement
    below: Counter[PolyElement] = field(default_factory=Counter)  # how often each unit divides

    def over(self, below: Counter[PolyElement]) -> PolyElement:
        """Return the numerator of this element over a larger denominator."""
        if below == self.below:
            return self.numerator
        return reduce(_times, (below - self.below).elements(), self.numerator)

    def __add__(self, *others: "Element") -> "Element":
        below = reduce(or_, [x.below for x in others if x.below], self.below)
        return Element(sum([x.over(below) for x in others], self.over(below)), below)

    def __neg__(self) -> "Element":
        return Element(-self.numerator, self.below)

    def __sub__(self, other: "Element") -> "Element":
        return self + -other

    def __mul__(self, other: "Element") -> "Element":
        below = self.below + other.below if self.below else other.below
        return Element(_times(self.numerator, other.numerator), below)

    def __pow__(self, exponent: int) -> "Element":
        terms = max(len(self.numerator), 1)
        if not 1 <= exponent <= 64 or comb(terms + exponent - 1, exponent) > 100_000:
            raise KernelError(f"power {exponent} of {terms} terms: too large, or not from 1 to 64")
        below = Counter({unit: exponent * power for unit, power in self.below.items()})
        return Element(self.numerator**exponent, below)


class Ring:
    """Differential ring of a context: Q[generators] localised at its units.

    Later generators are larger (lexicographic order): a relation that introduces a root or a
    function value leads with it, and division by the relations is the normal form.  D is d/dt.
    """

    def __init__(self, generators: tuple[str, ...], definitions: Mapping[str, str]) -> None:
        self.poly, gens = xring(generators[::-1], QQ, lex)
        self.places = {name: place for place, name in enumerate(generators[::-1])}
        self.unread = dict(definitions)
        self.units: tuple[PolyElement, ...] = ()
        self.relations: tuple[PolyElement, ...] = ()
        self.rates: dict[str, Element | None] | None = None
        self.values = dict[Tree, Element](zip(self.places, map(Element, gens), strict=True))

    def inverse(self, element: Element) -> Element:
        """Return the reciprocal of an element whose numerator is a product of units."""
        below, rest = self._factors(element.numerator)
        if not rest.is_ground:
            below, rest = self._factors(self.remainder(element.numerator))
        if not rest or not rest.is_ground:
            raise KernelError(f"1/({element.numerator!s:.99}): no product of the declared units")
        return Element(Element(self.poly(1 / rest.LC)).over(element.below), below)

    def _factors(self, polynomial: PolyElement) -> tuple[Counter[PolyElement], PolyElement]:
        """Return how often each unit divides a polynomial, and the remaining factor."""
        found, rest = Counter[PolyElement](), polynomial
        for unit in self.units:
            while not unit.is_ground and monomial_divides(unit.LM, rest.LM):
                quotient, over = rest.div(unit)
                if over:
                    break
                rest, found[unit] = quotient, found[unit] + 1
        return found, rest

    def remainder(self, polynomial: PolyElement, *given: PolyElement) -> PolyElement:
        """Reduce a polynomial modulo the relations and further polynomials that vanish."""
        return polynomial.rem([*given, *self.relations])  # 0 proves that it vanishes, too

    def rate(self, element: Element) -> Element:
        """Return the time derivative of an element."""
        if self.rates is None:
            raise KernelError(f"D({element.numerator}): this context has no time derivative")
        total = Element(self.poly(0))
        for name, rate in self.rates.items():
            if slope := element.numerator.diff(self.places[name]):
                if rate is None:
                    raise KernelError(f"D({name}) is not known in this context")
                total += Element(slope) * rate
        for unit, power in element.below.items():  # D(1/u**k) = -k D(u)/u / u**k
            total -= Element(element.numerator * power, Counter([unit])) * self.rate(Element(unit))
        return total * Element(self.poly(1), element.below)

    def read(self, text: str) -> Element:
        """Parse an expression and return its ring element, or raise KernelError."""
        return self.value(parse(text))

    def value(self, tree: Tree) -> Element:
        """Return the ring element of a syntax tree, from a cache if possible."""
        if (known := self.values.get(tree)) is None:
            known = self.values[tree] = self._value(tree)
        return known

    def _value(self, tree: Tree) -> Element:
        match tree:
            case int():
                return Element(self.poly(tree))
            case str():  # a definition is read once: inside itself it means nothing
                if tree not in self.unread:
                    raise KernelError(f"{tree!r} has no meaning here")
                return self.read(self.unread.pop(tree))
            case ("-", operand):
                return -self.value(operand)
            case ("/", operand):
                return self.inverse(self.value(operand))
            case ("D", "(", argument):
                return self.rate(self.value(argument))
            case (function, "(", *_):
                raise KernelError(f"{function}(...) has no meaning here, or not of so many")
            case (base, "**", int(exponent)):
                return self.value(base) ** exponent
        signed = zip(tree[1::2], tree[2::2], strict=True)
        terms = [self.value((sign, x) if sign in ("-", "/") else x) for sign, x in signed]
        first = self.value(tree[0])
        return first.__add__(*terms) if tree[1] in ("+", "-") else prod(terms, start=first)
