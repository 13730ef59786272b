"""Rational functions: SymPy's expressions, factored and cancelled by FLINT.

The results are those of `sympy.factor` and `sympy.cancel`, in a fraction of the time.
"""

from collections.abc import Iterable, Iterator
from functools import lru_cache
from math import gcd, lcm
from typing import TypeAlias

import sympy
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx
from sympy import Add, Expr, Function, Integer, Mul, Poly, Pow, Rational, Symbol

Ratio: TypeAlias = tuple[fmpq_mpoly, fmpq_mpoly]


def factor(value: Expr) -> Expr:
    """Return a rational function of names with its numerator and denominator factored."""
    if not (names := _names(value)):
        return sympy.factor(value)
    number, factors = Rational(1), []
    for side, sign in zip(_ratio(value, names), (1, -1), strict=True):
        content, found = side.factor()
        number *= Rational(int(content.p), int(content.q)) ** sign
        factors += [_expression(x, names) ** (sign * power) for x, power in found]
    product = Mul(*factors)
    # SymPy multiplies a number into a sum, but for a factor of a product.
    return Mul(number, product, evaluate=abs(number) == 1 or not product.is_Add)


def cancel(value: Expr) -> Expr:
    """Return a rational function of names as one fraction in lowest terms, multiplied out."""
    if not (names := _names(value)):
        return sympy.cancel(value)
    return _quotient(*_ratio(value, names), names)


def root(value: Expr, name: Expr) -> Expr | None:
    """Return where a rational function is zero, if its numerator is linear in a name."""
    names = _names(value)
    if name not in names:
        return None
    above, place = _ratio(value, names)[0], [*names].index(name)
    slope = above.derivative(place)
    if not slope or slope.derivative(place):
        return None
    start = above - slope * names[name]
    common = slope.gcd(start)
    return _quotient(-start / common, slope / common, names)


def _names(value: Expr) -> dict[Expr, fmpq_mpoly]:
    """Return the variables of names and functions, in SymPy's order; none, if there is more."""
    try:
        return _variables(frozenset(_leaves(value)))
    except TypeError:
        return {}


def _leaves(value: sympy.Basic) -> Iterator[Expr]:
    match value:
        case Symbol() | Function():
            yield value
        case Add() | Mul():
            for part in value.args:
                yield from _leaves(part)
        case Pow(exp=Integer()):
            yield from _leaves(value.base)
        case Rational():
            pass
        case _:
            raise TypeError(f"{value}: no rational function")


@lru_cache(maxsize=1024)
def _variables(names: frozenset[Expr]) -> dict[Expr, fmpq_mpoly]:
    if not names:
        return {}
    ordered = Poly(Add(*names)).gens
    if {*ordered} != names:  # such as powers of exp(x)
        return {}
    context = fmpq_mpoly_ctx.get([f"x{k}" for k in range(len(ordered))], "lex")
    return dict(zip(ordered, context.gens(), strict=True))


def _ratio(value: sympy.Basic, names: dict[Expr, fmpq_mpoly]) -> Ratio:
    """Return numerator and denominator of a rational function, without a common factor."""
    match value:
        case Symbol() | Function():
            return names[value], names[value] ** 0
        case Rational():
            one = next(iter(names.values())) ** 0
            return one * int(value.p), one * int(value.q)
        case Pow():
            above, below = _ratio(value.base, names)
            if value.exp < 0:
                above, below = below, above
            return above ** abs(int(value.exp)), below ** abs(int(value.exp))
    parts = [_ratio(x, names) for x in value.args]
    above, below = parts[0]
    for up, down in parts[1:]:
        if isinstance(value, Mul):
            above, below = above * up, below * down
        elif below == down:
            above += up
        else:
            above, below = above * down + up * below, below * down
    if below.is_constant():
        return above, below
    common = above.gcd(below)
    return above / common, below / common


def _quotient(above: fmpq_mpoly, below: fmpq_mpoly, names: dict[Expr, fmpq_mpoly]) -> Expr:
    """Return a fraction in lowest terms with whole coefficients, the first one below positive."""
    scales = [lcm(*(int(x.q) for x in side.coeffs())) for side in (above, below)]
    above, below = above * scales[0], below * scales[1]
    common = fmpq(gcd(*(int(x.p) for side in (above, below) for x in side.coeffs())))
    if below.leading_coefficient() < 0:
        common = -common
    ratio = _expression(above / common, names) / _expression(below / common, names)
    return Rational(scales[1], scales[0]) * ratio


def _expression(polynomial: fmpq_mpoly, names: Iterable[Expr]) -> Expr:
    terms = polynomial.to_dict().items()
    products = ((x, zip(names, powers, strict=True)) for powers, x in terms)
    return Add(
        *(Mul(Rational(int(x.p), int(x.q)), *(n**k for n, k in y if k)) for x, y in products)
    )
