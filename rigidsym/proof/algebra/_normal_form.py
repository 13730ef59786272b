"""Normal forms of polynomials modulo a context's relations, with cofactors as proof.

FLINT divides to find the cofactors; the kernel multiplies to check them.
"""

from collections.abc import Sequence
from functools import lru_cache
from itertools import groupby
from operator import mul, sub
from typing import TypeAlias

from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy.polys.rings import PolyElement, PolyRing

from rigidsym.proof.kernel import Ring
from rigidsym.proof.kernel._ring import Number

Divided: TypeAlias = tuple[list[PolyElement], PolyElement]
Term: TypeAlias = tuple[tuple[int, ...], Number]


def quotients(polynomial: PolyElement, divisors: Sequence[PolyElement]) -> Divided:
    """Return the cofactors and the remainder of a polynomial divided by several polynomials.

    Each term, also of intermediate results, is divided by the first divisor whose leading term
    divides it.  All terms divisible by the leading term of one divisor are divided together.
    """
    ring = polynomial.ring
    if not divisors or not polynomial:
        return [ring.zero] * len(divisors), polynomial
    rest, waiting = _to_flint(polynomial), [*map(_head_and_tail, divisors)]
    found, place = [rest.context().constant(0)] * len(divisors), 0
    while place < len(divisors):
        head, tail = waiting[place]
        quotient, rest = divmod(rest, head)
        rest -= quotient * tail
        found[place] += quotient
        place = 0 if quotient else place + 1
    return [_from_flint(ring, each) for each in found], _from_flint(ring, rest)


@lru_cache(maxsize=4096)
def _head_and_tail(divisor: PolyElement) -> tuple[fmpq_mpoly, fmpq_mpoly]:
    head = divisor.leading_term()
    return _to_flint(head), _to_flint(divisor - head)


def _to_flint(polynomial: PolyElement) -> fmpq_mpoly:
    terms = {powers: fmpq(int(x.numerator), int(x.denominator)) for powers, x in polynomial.items()}
    return fmpq_mpoly_ctx.get(_names(polynomial.ring), "lex").from_dict(terms)


@lru_cache(maxsize=512)
def _names(ring: PolyRing) -> tuple[str, ...]:
    return tuple(map(str, ring.symbols))


def _from_flint(ring: PolyRing, polynomial: fmpq_mpoly) -> PolyElement:
    number = ring.domain
    terms = {powers: number(int(x.p), int(x.q)) for powers, x in polynomial.to_dict().items()}
    return ring.from_dict(terms)


def factors(polynomial: PolyElement) -> list[PolyElement]:
    """Return the different factors of a polynomial, in a fixed order."""
    found = (_from_flint(polynomial.ring, x) for x, _ in _to_flint(polynomial).factor()[1])
    return sorted(found, key=str)


def divide(ring: Ring, polynomial: PolyElement) -> Divided:
    """Return the cofactors and the remainder of a polynomial divided by a context's relations.

    A remainder of 0 proves that the polynomial vanishes.
    If plain division leaves a remainder, each relation is first reduced by those before it, and
    the division repeated.  The relations are then still no Groebner basis, so a nonzero remainder
    proves nothing.
    """
    cofactors, remainder = quotients(polynomial, ring.relations)
    basis, origins = _reduced(ring)
    if not remainder or basis == ring.relations:
        return cofactors, remainder
    parts, remainder = quotients(polynomial, basis)
    return _combined(parts, origins, cofactors), remainder


def nested(polynomial: PolyElement) -> str:
    """Print a polynomial in nested form, which is about half as long as the expanded form.

    >>> from sympy import QQ, ring
    >>> _, x, y = ring("x, y", QQ)
    >>> nested(x**2*y + x**2/2 - 3*x*y**2 - 3*x*y + y)
    'x**2*(y + 1/2) + x*y*(-3*y - 3) + y'
    """
    return _nested(sorted(polynomial.items(), reverse=True), _names(polynomial.ring))


def _nested(terms: list[Term], names: Sequence[str]) -> str:
    if len(terms) < 2:
        return _product(*terms[0], names) if terms else "0"
    common = tuple(map(min, *(powers for powers, _ in terms)))
    if any(common):
        rest = [(tuple(map(sub, powers, common)), x) for powers, x in terms]
        return f"{_product(common, 1, names)}*({_nested(rest, names)})"
    first = next(k for k in range(len(names)) if any(powers[k] for powers, _ in terms))
    parts = groupby(terms, key=lambda term: term[0][first])
    return " + ".join(_nested([*part], names) for _, part in parts).replace("+ -", "- ")


def _product(powers: tuple[int, ...], number: Number, names: Sequence[str]) -> str:
    """Return one term of a polynomial as text, without a factor 1."""
    factors = [x if k == 1 else f"{x}**{k}" for x, k in zip(names, powers, strict=True) if k]
    if not factors or number not in (1, -1):
        return "*".join([str(number), *factors])
    return "-" * (number == -1) + "*".join(factors)


@lru_cache(maxsize=128)
def _reduced(ring: Ring) -> tuple[tuple[PolyElement, ...], list[list[PolyElement]]]:
    """Reduce each relation of a context by the relations before it.

    Returns the reduced relations that are not zero, and for each its cofactors in the original
    relations.
    """
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
    """Return the linear combination of rows of polynomials with polynomial coefficients.

    `like` has as many entries as a row, for the case that there is none.
    """
    total = [0 * entry for entry in like]
    for part, row in zip(parts, rows, strict=True):
        total = [x + y for x, y in zip(total, map(mul, [part] * len(row), row), strict=True)]
    return total
