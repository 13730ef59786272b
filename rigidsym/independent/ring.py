"""Q[generators] with the units inverted: fractions of FLINT polynomials, never cancelled.

A denominator is always a product of declared units, because `Ring.inverse` makes no other.
Monomials are ordered lexicographically, later generators larger, as ledgers are written for.
"""

import re
from dataclasses import dataclass
from math import comb
from operator import add, mul, sub

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from rigidsym.independent.records import Refused

_TOKEN = re.compile(r" *(0|[1-9][0-9]*|[A-Za-z_][A-Za-z_0-9]*|\*\*|[-+*/()])")
_BINDS = {"+": 1, "-": 1, "*": 2, "/": 2, "**": 3}


@dataclass(frozen=True, slots=True, eq=False)
class Quotient:
    """above / below."""

    above: fmpq_mpoly
    below: fmpq_mpoly

    def __add__(self, other: "Quotient") -> "Quotient":
        if self.below == other.below:
            return Quotient(self.above + other.above, self.below)
        lift = other.below / self.below.gcd(other.below)
        below = self.below * lift
        return Quotient(self.above * lift + other.above * (below / other.below), below)

    def __neg__(self) -> "Quotient":
        return Quotient(-self.above, self.below)

    def __sub__(self, other: "Quotient") -> "Quotient":
        return self + -other

    def __mul__(self, other: "Quotient") -> "Quotient":
        return Quotient(self.above * other.above, self.below * other.below)

    def __pow__(self, exponent: int) -> "Quotient":
        terms = max(len(self.above), len(self.below), 1)
        if not 1 <= exponent <= 64 or comb(terms + exponent - 1, exponent) > 100_000:
            raise Refused(f"power {exponent} of {terms} terms: too large, or not from 1 to 64")
        return Quotient(self.above**exponent, self.below**exponent)


class Ring:
    """The arithmetic of a context: what names mean, what may be divided by, what vanishes."""

    def __init__(self, generators: list[str], definitions: dict[str, str]) -> None:
        self.polynomials = fmpq_mpoly_ctx.get(generators[::-1], "lex")
        self.one = self.polynomials.constant(1)
        self.values = {str(gen): self.over_one(gen) for gen in self.polynomials.gens()}
        self.unread = dict(definitions)
        self.units: list[fmpq_mpoly] = []
        self.relations: list[fmpq_mpoly] = []
        self.rates: dict[str, Quotient | None] | None = None

    def over_one(self, polynomial: fmpq_mpoly) -> Quotient:
        """A polynomial as a quotient."""
        return Quotient(polynomial, self.one)

    def read(self, text: str) -> Quotient:
        """The value of an expression, all of it."""
        if text.startswith(" ") or _TOKEN.sub("", text).strip(" "):
            raise Refused(f"{text!r:.80} is not made of what expressions are made of")
        tokens = ["", *reversed(_TOKEN.findall(text))]
        value = self._read(tokens)
        return self._after(tokens, "", value)

    def _read(self, tokens: list[str], binding: int = 0) -> Quotient:
        """Read on, up to an operator that binds no tighter than the one before."""
        value = self._operand(tokens)
        while _BINDS.get(tokens[-1], 0) > binding:
            match operator := tokens.pop():
                case "**" if tokens[-1].isdigit() and tokens[-2] != "**":
                    value = value ** int(tokens.pop())
                case "/":
                    value *= self.inverse(self._read(tokens, _BINDS["/"]))
                case "+" | "-" | "*":
                    operation = {"+": add, "-": sub, "*": mul}[operator]
                    value = operation(value, self._read(tokens, _BINDS[operator]))
                case _:
                    raise Refused("an exponent is not written as an integer")
        return value

    def _operand(self, tokens: list[str]) -> Quotient:
        token = tokens.pop()
        if token == "-":  # takes the whole power after it: -x**2 is -(x**2)
            return -self._read(tokens, _BINDS["*"])
        if token == "(":
            return self._after(tokens, ")", self._read(tokens))
        if token == "D" and tokens[-1] == "(":
            return self.rate(self._operand(tokens))
        if token.isdigit():
            return self.over_one(self.polynomials.constant(int(token)))
        return self.value(token)

    def _after(self, tokens: list[str], end: str, value: Quotient) -> Quotient:
        if (token := tokens.pop()) != end:
            raise Refused(f"{token!r} stands where {end!r} is due")
        return value

    def value(self, name: str) -> Quotient:
        """What a name means.  A definition is read once; inside itself it means nothing."""
        if name not in self.values:
            if name not in self.unread:
                raise Refused(f"{name!r} has no meaning here")
            self.values[name] = self.read(self.unread.pop(name))
        return self.values[name]

    def inverse(self, quotient: Quotient) -> Quotient:
        """1/quotient, if its numerator, as it is or modulo the relations, is invertible."""
        for above in (quotient.above, self.remainder(quotient.above)):
            if scale := self.scale(above):
                return Quotient(quotient.below / scale, above / scale)
        raise Refused("a division by what is not a product of units")

    def scale(self, polynomial: fmpq_mpoly) -> fmpq:
        """The number c if the polynomial is c times a product of units, else 0."""
        for unit in self.units:
            while not polynomial.is_constant() and not unit.is_constant():
                quotient, rest = divmod(polynomial, unit)
                if rest:
                    break
                polynomial = quotient
        constant = polynomial and polynomial.is_constant()
        return polynomial.leading_coefficient() if constant else fmpq(0)

    def remainder(self, polynomial: fmpq_mpoly) -> fmpq_mpoly:
        """The polynomial divided by each relation in turn until none changes it.

        It ends, since a change replaces a monomial by smaller ones; 0 proves ideal membership.
        """
        previous = None
        while polynomial != previous:
            previous = polynomial
            for relation in filter(None, reversed(self.relations)):
                polynomial = polynomial % relation
        return polynomial

    def rate(self, quotient: Quotient) -> Quotient:
        """D(a/b): the sum over the generators x of (a_x b - a b_x)/b**2 D(x)."""
        if self.rates is None:
            raise Refused("this context has no time derivative")
        (above, below), total = (quotient.above, quotient.below), self.over_one(self.one * 0)
        for name, rate in self.rates.items():
            if slope := above.derivative(name) * below - above * below.derivative(name):
                if rate is None:
                    raise Refused(f"D({name}) is not known")
                total += Quotient(slope, below**2) * rate
        return total
