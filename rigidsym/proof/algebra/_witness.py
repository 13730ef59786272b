"""Search for a rational point of a context, where all its hypotheses hold.

Nothing here is trusted: the kernel checks the point, which shows that the context is not empty.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from math import prod
from typing import TypeAlias

from flint import fmpq
from sympy.polys.rings import PolyElement

from rigidsym.proof.algebra._normal_form import factors
from rigidsym.proof.kernel import Context, KernelError, Ring

# Numbers to try.  Most relations are conics, which contain 0, 1 or sides of right triangles.
NUMBERS = "1 2 3 0 1/2 4 -1 3/5 4/5 3/4 5/4 5 1/3 1/4 -2 3/2 2/3 9/4 4/3 5/3"
STEPS = 2_000


VALUES = tuple(map(fmpq, NUMBERS.split()))
Places: TypeAlias = frozenset[int]
# A rational number, and the powers of generators, by their places.
Term: TypeAlias = tuple[fmpq, tuple[tuple[int, int], ...]]


def witness(context: Context, ring: Ring, *nonzero: PolyElement) -> dict[str, str]:
    """Return a rational point of a context, with the values that its witness prefers if possible.

    Further polynomials in its ring are not zero there.

    Generators get values in their order.  A relation decides the value of its last generator: a
    rational root, if its degree is 1 or 2.  Where no value is possible, the search returns to the
    last of the generators that are in conflict.
    Raises KernelError if it finds no point in `STEPS` steps.
    """
    size = len(context.generators)
    closing: list[list[_Hypothesis]] = [[] for _ in range(size)]
    for hypothesis in _hypotheses(context, ring, *nonzero):
        if hypothesis.places:
            closing[max(hypothesis.places)].append(hypothesis)
    preferred = [
        [fmpq(context.witness[x])] if x in context.witness else [] for x in context.generators
    ]
    values: list[fmpq] = []
    tried: list[Iterator[fmpq]] = []
    conflicts: list[Places] = []
    for _ in range(STEPS):
        here = len(values)
        if here == size:
            return dict(zip(context.generators, map(str, values), strict=True))
        if here == len(tried):
            choices, conflict = _choices(closing[here], values, preferred[here])
            tried.append(choices)
            conflicts.append(conflict)
        if (value := next(tried[here], None)) is not None:
            values.append(value)
            broken = (x.places for x in closing[here] if not x.holds(values))
            if (conflict := next(broken, None)) is not None:
                conflicts[here] |= conflict
                values.pop()
            continue
        conflict = conflicts[here] - {here}
        if not conflict:
            break
        back = max(conflict)
        del values[back:], tried[back + 1 :], conflicts[back + 1 :]
        conflicts[back] |= conflict
    raise KernelError(f"no witness of {context.name} found: prefer values of single names")


@dataclass(frozen=True, slots=True)
class _Hypothesis:
    """A polynomial that is zero, nonzero, positive or at least zero."""

    kind: str
    terms: tuple[Term, ...]
    places: Places

    def holds(self, values: list[fmpq]) -> bool:
        """Return whether the hypothesis holds at a point."""
        value = sum(prod((values[k] ** n for k, n in x), start=c) for c, x in self.terms)
        return {"=": value == 0, "!=": value != 0, ">": value > 0, ">=": value >= 0}[self.kind]

    def roots(self, values: list[fmpq]) -> list[fmpq] | None:
        """Return the values of the next generator that make the polynomial zero, larger ones first.

        Return None if they are all values, or the degree is more than 2.
        """
        last, sums = len(values), dict.fromkeys(range(3), fmpq(0))
        for number, powers in self.terms:
            degree = next((n for k, n in powers if k == last), 0)
            known = (values[k] ** n for k, n in powers if k != last)
            sums[degree] = sums.get(degree, fmpq(0)) + prod(known, start=number)
        c, b, a, *more = sums.values()
        if any(more) or not (a or b or c):
            return None
        if not a:
            return [-c / b] if b else []
        square = b**2 - 4 * a * c
        if square < 0:
            return []
        root = fmpq(square.p.isqrt(), square.q.isqrt())
        roots = {(-b + root) / (2 * a), (-b - root) / (2 * a)}
        return sorted(roots, reverse=True) if root**2 == square else []


def _hypotheses(context: Context, ring: Ring, *nonzero: PolyElement) -> Iterator[_Hypothesis]:
    """Yield the hypotheses of a context, as polynomials in its generators."""
    for zero in chain(ring.relations, (ring.read(x).numerator for x in context.start)):
        yield _hypothesis("=", zero)
    for factor in dict.fromkeys(chain.from_iterable(map(factors, (*ring.units, *nonzero)))):
        yield _hypothesis("!=", factor)
    for sign in map(ring.read, context.nonnegative):
        # What is zero has to stay zero.
        still = ring.rates is None or not ring.remainder(ring.rate(sign).numerator)
        yield _hypothesis(">=" if still else ">", sign.over(sign.below + sign.below))


def _hypothesis(kind: str, polynomial: PolyElement) -> _Hypothesis:
    last = polynomial.ring.ngens - 1
    terms = tuple(
        (
            fmpq(int(x.numerator), int(x.denominator)),
            tuple((last - k, power) for k, power in enumerate(powers) if power),
        )
        for powers, x in polynomial.items()
    )
    return _Hypothesis(kind, terms, frozenset(k for _, powers in terms for k, _ in powers))


def _choices(
    hypotheses: Iterable[_Hypothesis], values: list[fmpq], preferred: list[fmpq]
) -> tuple[Iterator[fmpq], Places]:
    """Return values for the next generator, and the places of those that restrict them."""
    for hypothesis in hypotheses:
        if hypothesis.kind == "=" and (roots := hypothesis.roots(values)) is not None:
            first = [x for x in preferred if x in roots]
            return iter(dict.fromkeys((*first, *roots))), hypothesis.places
    return iter(dict.fromkeys((*preferred, *VALUES))), frozenset()
