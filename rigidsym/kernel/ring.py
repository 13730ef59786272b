"""Elements of a differential ring: a polynomial over a product of declared units.

Text is Python's, cut down to names, integers, ``+ - * /``, integer powers and ``D(...)``, d/dt;
no division happens that the hypotheses do not cover.
"""

import ast
from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from operator import add, mul, sub, truediv
from typing import Any

from sympy.polys.domains import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

_BINARY: dict[type, Any] = {ast.Add: add, ast.Sub: sub, ast.Mult: mul, ast.Div: truediv}


def at(polynomial: Any, point: list[Any]) -> Any:
    """The value at a rational point, given in the order of the ring's generators."""
    return sum(x * prod(map(pow, point, powers)) for powers, x in polynomial.terms())


class KernelError(ValueError):
    """The kernel refuses: a text, context, fact or certificate breaks one of its rules."""


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """numerator / product of units**powers, in one `Ring`."""

    ring: "Ring"
    numerator: Any
    powers: tuple[int, ...]

    def over(self, powers: tuple[int, ...]) -> Any:
        """The numerator this element has when written over a larger denominator."""
        scaled = self.numerator
        for unit, gap in zip(self.ring.units, map(sub, powers, self.powers), strict=True):
            scaled = scaled * unit**gap if gap else scaled
        return scaled

    def __add__(self, other: Any) -> "Element":
        other = self.ring.element(other)
        powers = tuple(map(max, self.powers, other.powers))
        return Element(self.ring, self.over(powers) + other.over(powers), powers)

    def __mul__(self, other: Any) -> "Element":
        other = self.ring.element(other)
        powers = tuple(map(add, self.powers, other.powers))
        return Element(self.ring, self.numerator * other.numerator, powers)

    def __sub__(self, other: Any) -> "Element":
        return self + self.ring.element(other) * -1

    def __truediv__(self, other: Any) -> "Element":
        return self * self.ring.inverse(self.ring.element(other))

    def __pow__(self, exponent: int) -> "Element":
        if not 0 < exponent <= 64 or len(self.numerator) ** min(exponent, 9) > 10**6:
            raise KernelError(f"power {exponent} of {len(self.numerator)} terms: not from 1 to 64")
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
        self.definitions = definitions
        self.units: tuple[Any, ...] = ()
        self.relations: tuple[Any, ...] = ()
        self.rates: dict[str, Element | None] | None = None
        self.names = {str(generator): self.element(generator) for generator in self.poly.gens}

    def element(self, value: Any) -> Element:
        """Coerce a number, a polynomial, or an element made before all units were declared."""
        ready = isinstance(value, Element)
        numerator, powers = (value.numerator, value.powers) if ready else (self.poly(value), ())
        return Element(self, numerator, powers + (0,) * (len(self.units) - len(powers)))

    def inverse(self, element: Element) -> Element:
        """1/element; refused unless its numerator is a number times a product of units."""
        for form in (lambda polynomial: polynomial, lambda polynomial: self.reduce(polynomial)[1]):
            rest, powers = form(element.numerator), [0] * len(self.units)
            for k, unit in enumerate(self.units):
                while rest and not unit.is_ground and not (divided := rest.div(unit))[1]:
                    rest, powers[k] = divided[0], powers[k] + 1
            if rest and rest.is_ground:
                return Element(self, self.element(1 / rest.LC).over(element.powers), tuple(powers))
        raise KernelError(f"1/({element.numerator!s:.120}): not a product of the declared units")

    def reduce(self, polynomial: Any, *given: Any) -> tuple[list[Any], Any]:
        """Cofactors and remainder of division by the relations; remainder 0 proves membership."""
        divisors = [*given, *self.relations]
        if not divisors or not polynomial:
            return [self.poly(0)] * len(divisors), polynomial
        return polynomial.div(divisors)

    def rate(self, element: Element) -> Element:
        """D(p / prod u**k) = (D(p) - p sum k D(u)/u) / prod u**k"""
        total = self._rate(element.numerator)
        for unit, power in zip(self.units, element.powers, strict=True):
            if power:
                total -= self._rate(unit) * element.numerator * power / self.element(unit)
        return total * Element(self, self.poly(1), element.powers)

    def _rate(self, polynomial: Any) -> Element:
        if self.rates is None:
            raise KernelError(f"D({polynomial}): this context has no time derivative")
        total = self.element(0)
        for name, rate in self.rates.items():
            slope = polynomial.diff(self.names[name].numerator)
            if slope and rate is None:
                raise KernelError(f"D({name}) is not known in this context")
            total += self.element(slope) * rate if slope else 0
        return total

    def read(self, text: str) -> Element:
        """Parse text into an element: names known, divisions covered, and no null byte."""
        try:
            return self._read(ast.parse("?" if "\0" in text else text, mode="eval").body)
        except (SyntaxError, RecursionError, MemoryError, TypeError, UnicodeError) as error:
            raise KernelError(f"{text!r}: not an expression ({error})") from None

    def _read(self, node: ast.expr) -> Element:
        match node:
            case ast.Constant(value=int(number)) if not isinstance(number, bool):
                return self.element(number)
            case ast.Name(id=name) if name in self.names or name in self.definitions:
                if name not in self.names:
                    self.names[name] = self.read(self.definitions[name])
                return self.element(self.names[name])
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._read(operand) * -1
            case ast.BinOp(left=base, op=ast.Pow(), right=ast.Constant(value=int(exponent))):
                return self._read(base) ** exponent
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
                return _BINARY[type(op)](self._read(left), self._read(right))
            case ast.Call(func=ast.Name(id="D"), args=[argument], keywords=[]):
                return self.rate(self._read(argument))
        raise KernelError(f"{ast.unparse(node)!r} is neither a known name nor an operation")
