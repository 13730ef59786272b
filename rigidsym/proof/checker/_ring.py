"""Differential rings of polynomial fractions, computed with FLINT.

Fractions are never cancelled.
A denominator is always a product of declared units, because `Ring.inverse` makes no other.
Monomials are ordered lexicographically, later generators larger, as ledgers are written for.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import comb

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from rigidsym.proof.checker._language import Language
from rigidsym.proof.checker._records import Refused


@dataclass(frozen=True, slots=True, eq=False)
class Quotient:
    """A fraction of two polynomials, above / below."""

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


class Ring(Language[Quotient]):
    """Differential ring of a context, with its names, units and relations."""

    def __init__(self, generators: list[str], definitions: dict[str, str]) -> None:
        self.polynomials = fmpq_mpoly_ctx.get(generators[::-1], "lex")
        self.one = self.polynomials.constant(1)
        self.values = {str(gen): self.over_one(gen) for gen in self.polynomials.gens()}
        self.unread = dict(definitions)
        self.units: list[fmpq_mpoly] = []
        self.relations: list[fmpq_mpoly] = []
        self.rates: dict[str, Quotient | None] | None = None

    def over_one(self, polynomial: fmpq_mpoly) -> Quotient:
        """Return a polynomial as a fraction with denominator 1."""
        return Quotient(polynomial, self.one)

    def number(self, number: int) -> Quotient:
        """Return a natural number as a fraction."""
        return self.over_one(self.polynomials.constant(number))

    def call(self, function: str, arguments: list[Quotient]) -> Quotient:
        """Evaluate D(x), the time derivative of a fraction.

        Raises Refused for any other function.
        """
        if function != "D" or len(arguments) != 1:
            raise Refused(f"{function} of {len(arguments)} is no function here")
        return self.rate(arguments[0])

    def combine(self, operator: str, left: Quotient, right: Quotient) -> Quotient:
        """Return the sum, difference, product or quotient of two fractions.

        Raises Refused if a divisor has no inverse.
        """
        if operator == "/":
            return left * self.inverse(right)
        return super().combine(operator, left, right)

    def name(self, name: str) -> Quotient:
        """Return the value of a name as a fraction.

        Raises Refused for a name inside its own definition.
        """
        if name not in self.values:
            if name not in self.unread:
                raise Refused(f"{name!r} has no meaning here")
            self.values[name] = self.read(self.unread.pop(name))
        return self.values[name]

    def inverse(self, quotient: Quotient) -> Quotient:
        """Return the reciprocal of a fraction.

        Raises Refused unless the numerator is a product of units.
        The numerator may be reduced by the relations for that.
        """
        above = quotient.above
        if not (scale := self.scale(above)):
            above = self.remainder(above)
            scale = self.scale(above)
        if not scale:
            raise Refused("a division by what is not a product of units")
        return Quotient(quotient.below / scale, above / scale)

    def scale(self, polynomial: fmpq_mpoly) -> fmpq:
        """Return c if a polynomial is c times a product of units, else 0."""
        for unit in self.units:
            while not polynomial.is_constant() and not unit.is_constant():
                quotient, rest = divmod(polynomial, unit)
                if rest:
                    break
                polynomial = quotient
        constant = polynomial and polynomial.is_constant()
        return polynomial.leading_coefficient() if constant else fmpq(0)

    def remainder(self, polynomial: fmpq_mpoly, given: Sequence[fmpq_mpoly] = ()) -> fmpq_mpoly:
        """Reduce a polynomial modulo the relations and further polynomials that vanish.

        The reduction is repeated until nothing changes.
        This ends, since a change replaces a monomial by smaller ones; 0 proves ideal membership.
        The remainder depends on the order of the divisors, so both orders are used.
        """
        divisors = [*filter(None, self.relations), *filter(None, given)]
        rest = _divided(polynomial, divisors)
        return rest and _divided(_divided(polynomial, divisors[::-1]), divisors)

    def rate(self, quotient: Quotient) -> Quotient:
        """Return the time derivative of a fraction.

        D(a/b) is the sum of (a_x b - a b_x)/b**2 D(x) over all generators x.
        """
        if self.rates is None:
            raise Refused("this context has no time derivative")
        (above, below), total = (quotient.above, quotient.below), self.over_one(self.one * 0)
        for name, rate in self.rates.items():
            up, down = above.derivative(name), below.derivative(name)
            if (up or down) and (slope := up * below - above * down):
                if rate is None:
                    raise Refused(f"D({name}) is not known")
                total += Quotient(slope, below**2) * rate
        return total


def _divided(polynomial: fmpq_mpoly, divisors: Sequence[fmpq_mpoly]) -> fmpq_mpoly:
    previous = None
    while polynomial != previous:
        previous = polynomial
        for divisor in divisors:
            polynomial = polynomial % divisor
    return polynomial
