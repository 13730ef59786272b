"""Normal forms, and the cofactors that prove them: found here, multiplied out by the kernel."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import groupby
from operator import mul
from typing import TypeAlias

from sympy.polys.rings import PolyElement

from rigidsym.proof.kernel import Ring

Divided: TypeAlias = tuple[list[PolyElement], PolyElement]


def quotients(polynomial: PolyElement, divisors: Sequence[PolyElement]) -> Divided:
    """Cofactors of the divisors, and the remainder of plain division by them in turn."""
    if not divisors or not polynomial:
        return [polynomial.ring.zero] * len(divisors), polynomial
    return polynomial.div(list(divisors))


def divide(ring: Ring, polynomial: PolyElement) -> Divided:
    """Cofactors and remainder by a context's relations; remainder 0 means that it vanishes there.

    Where plain division leaves a remainder, each relation is first reduced by those before it: one
    that another can reduce may hide that the remainder is zero.  That makes no Groebner basis, so
    a remainder is no proof of anything.
    """
    cofactors, remainder = quotients(polynomial, ring.relations)
    basis, origins = _reduced(ring)
    if not remainder or basis == ring.relations:
        return cofactors, remainder
    parts, remainder = polynomial.div(list(basis))
    return _combined(parts, origins, cofactors), remainder


def nested(polynomial: PolyElement) -> str:
    """A polynomial by powers of one generator after the other: half as long as all its terms.

    >>> from sympy import QQ, ring
    >>> _, x, y = ring("x, y", QQ)
    >>> nested(x**2*y + x**2/2 - 3*x*y**2 - 3*x*y + y)
    'x**2*(y + 1/2) + x*y*(-3*y - 3) + y'
    """
    if len(polynomial) < 2:
        return str(polynomial)
    ring, monomials = polynomial.ring, polynomial.monoms()
    common = tuple(map(min, *monomials))
    if any(common):
        factor = ring.from_dict({common: ring.domain.one})
        return f"{factor}*({nested(polynomial.exquo(factor))})"
    first = next(k for k, powers in enumerate(zip(*monomials, strict=True)) if any(powers))
    parts = groupby(polynomial.terms(), key=lambda term: term[0][first])
    return " + ".join(nested(ring.from_dict(dict(part))) for _, part in parts).replace("+ -", "- ")


@lru_cache(maxsize=128)
def _reduced(ring: Ring) -> tuple[tuple[PolyElement, ...], list[list[PolyElement]]]:
    """The relations, each reduced by those before it, and the cofactors that give them."""
    basis: list[PolyElement] = []
    origins: list[list[PolyElement]] = []
    for k, relation in enumerate(ring.relations):
        parts, reduced = quotients(relation, basis)
        itself = [ring.poly(int(j == k)) for j in range(len(ring.relations))]
        known = _combined(parts, origins, itself)
        if reduced:
            basis.append(reduced)
            origins.append([x - y for x, y in zip(itself, known, strict=True)])
    return tuple(basis), origins


def _combined(
    parts: list[PolyElement], rows: list[list[PolyElement]], like: list[PolyElement]
) -> list[PolyElement]:
    """The sum of part * row, entry by entry; `like` gives the zeros where there is no row."""
    total = [0 * entry for entry in like]
    for part, row in zip(parts, rows, strict=True):
        total = [x + y for x, y in zip(total, map(mul, [part] * len(row), row), strict=True)]
    return total
