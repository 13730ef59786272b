"""Derivation steps on named matrices: coordinates, products and determinants."""

from collections.abc import Sequence
from typing import Any

import sympy
from sympy import (
    Determinant,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    MatrixExpr,
    MatrixSymbol,
    Poly,
    ZeroMatrix,
)

from rigidsym.proof.algebra._builder import Source
from rigidsym.proof.algebra._computation import Computation, plain
from rigidsym.proof.steps._matrices import SIZE
from rigidsym.proof.steps._record import Step, StepError
from rigidsym.proof.steps._scope import Scope


def coordinates(
    scope: Scope,
    fact_id: str,
    expression: MatrixExpr,
    basis: Sequence[MatrixExpr],
    why: str,
    source: Source = (),
) -> Step:
    """Find the coordinates of a matrix expression in an orthogonal basis.

    They are the coefficients x_k of expression = sum x_k B_k.
    They are computed by traces.  The kernel expands the expression and decides the equation entry
    by entry.  Raises StepError if the expression is not in the span.
    """
    whole = scope.explicit(expression)
    found = tuple(tidy(scope, _coordinate(whole, scope.explicit(b))) for b in basis)
    pairs = zip(found, basis, strict=True)
    terms = [b if x == 1 else MatMul(x, b) for x, b in pairs if x != 0]
    right = MatAdd(*terms, evaluate=False) if terms else ZeroMatrix(SIZE, SIZE)
    origin = Computation(found, ("coordinates",))
    fact = scope.decide_matrices(fact_id, expression, right, source, origin)
    return scope.note("coordinates", why, found, [(expression, right)], fact)


def _coordinate(value: ImmutableMatrix, direction: ImmutableMatrix) -> sympy.Expr:
    """Return the coordinate of a matrix in the direction of a basis matrix.

    It is tr(B* X) / tr(B* B), which is real in the real span of the basis.
    """
    return sympy.expand((direction.H * value).trace() / (direction.H * direction).trace())


def tidy(scope: Scope, expression: sympy.Expr) -> sympy.Expr:
    """Simplify an expression, using functions of whole angles where possible.

    It is reduced by the relations, and its factors are collected.
    """
    if not expression.is_real and expression.has(sympy.I):
        real = sympy.expand(expression)
        if real.coeff(sympy.I) != 0:
            raise StepError(f"coordinates: {real} is not real")
    whole = double(scope, expression)
    return scope.reduced(whole)


def double(scope: Scope, expression: sympy.Expr) -> sympy.Expr:
    """Replace squares and products of half-angle functions by whole-angle functions.

    cos(x/2)^2 becomes (1 + cos x)/2, and so on. Other terms leave the expression unchanged.
    """
    named = scope.dictionary.named(expression)
    for cosine, sine, whole_cosine, whole_sine in _pairs(scope):
        if not named.free_symbols & {cosine, sine}:
            continue
        terms = Poly(named, cosine, sine).terms()
        if any(sum(powers) not in (0, 2) for powers, _ in terms):
            return expression
        values = {
            (0, 0): sympy.S.One,
            (2, 0): (1 + whole_cosine) / 2,
            (0, 2): (1 - whole_cosine) / 2,
            (1, 1): whole_sine / 2,
        }
        named = sympy.expand(sum(values[powers] * factor for powers, factor in terms))
    return scope.dictionary.meant(named)


def _pairs(scope: Scope) -> list[tuple[sympy.Symbol, ...]]:
    """Return the names of cos x, sin x, cos 2x and sin 2x for each x where all four have names."""
    names = scope.dictionary.names
    found = []
    for function, cosine in names.items():
        angle = function.args[0]
        doubled = [f(2 * angle) for f in (sympy.cos, sympy.sin)]
        if isinstance(function, sympy.cos) and all(f in names for f in doubled):
            found.append((cosine, names[sympy.sin(angle)], *(names[f] for f in doubled)))
    return found


def multiply(
    scope: Scope,
    fact_id: str,
    left: MatrixExpr,
    right: MatrixExpr | Computation,
    why: str,
    source: Source = (),
) -> Step:
    """Prove an equation between expressions in named matrices by multiplying them out.

    The kernel multiplies.
    """
    origin = right if isinstance(right, Computation) else None
    value: Any = plain(right)
    fact = scope.decide_matrices(fact_id, left, value, source, origin)
    return scope.note("multiply", why, value, [(left, value)], fact)


def determinant(
    scope: Scope, fact_id: str, name: MatrixSymbol, why: str, source: Source = ()
) -> Step:
    """Compute the determinant of a named matrix.

    It has to be real.
    """
    value = tidy(scope, scope.explicit(name).det(method="berkowitz"))
    real, imaginary = scope.determinant(name)
    parts: list[tuple[str, sympy.Expr | str]] = [(real, value)]
    parts += [(imaginary, "0")] if imaginary else []
    fact = scope.decide(fact_id, parts, source, Computation(value, ("determinant",)))
    return scope.note("multiply", why, value, [(Determinant(name), value)], fact)
