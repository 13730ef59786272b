"""Steps over named matrices: coordinates in a basis, and what a product multiplies out to."""

from collections.abc import Sequence

import sympy
from sympy import (
    Determinant,
    Eq,
    ImmutableMatrix,
    MatAdd,
    MatMul,
    MatrixExpr,
    MatrixSymbol,
    Poly,
    ZeroMatrix,
)

from rigidsym.proof.steps.desk import Desk
from rigidsym.proof.steps.record import Step, StepError


def coordinates(
    desk: Desk,
    fact_id: str,
    expression: MatrixExpr,
    basis: Sequence[MatrixExpr],
    why: str,
    source: Sequence[str] = (),
) -> Step:
    """expression = sum x_k B_k: the x_k, by the traces of an orthogonal basis.

    The kernel multiplies the expression and decides the equation entry by entry.  Raises StepError
    where the expression is not in the span.
    """
    whole = desk.explicit(expression)
    found = tuple(tidy(desk, _coordinate(whole, desk.explicit(b))) for b in basis)
    pairs = zip(found, basis, strict=True)
    terms = [b if x == 1 else MatMul(x, b) for x, b in pairs if x != 0]
    right = MatAdd(*terms, evaluate=False) if terms else ZeroMatrix(2, 2)
    fact = desk.decide_matrices(fact_id, expression, right, source)
    shown = Eq(expression, right, evaluate=False)
    return desk.note(Step("coordinates", why, found, (shown,), fact, source=tuple(source)))


def _coordinate(value: ImmutableMatrix, direction: ImmutableMatrix) -> sympy.Expr:
    """tr(B* X) / tr(B* B), which is real for what is in the real span of an orthogonal basis."""
    return sympy.expand((direction.H * value).trace() / (direction.H * direction).trace())


def tidy(desk: Desk, expression: sympy.Expr) -> sympy.Expr:
    """The same in whole angles where it can be, modulo the relations, its factors collected."""
    if not expression.is_real and expression.has(sympy.I):
        real = sympy.expand(expression)
        if real.coeff(sympy.I) != 0:
            raise StepError(f"coordinates: {real} is not real")
    whole = double(desk, expression)
    return desk.reduced(whole)


def double(desk: Desk, expression: sympy.Expr) -> sympy.Expr:
    """cos(x/2)^2 = (1 + cos x)/2 and so on, where every half angle comes twice."""
    named = desk.dictionary.named(expression)
    for cosine, sine, whole_cosine, whole_sine in _pairs(desk):
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
    return desk.dictionary.meant(named)


def _pairs(desk: Desk) -> list[tuple[sympy.Symbol, ...]]:
    """The generators cos, sin of angles, with the names that have the doubled angle."""
    names = desk.dictionary.names
    found = []
    for function, cosine in names.items():
        angle = function.args[0]
        doubled = [f(2 * angle) for f in (sympy.cos, sympy.sin)]
        if isinstance(function, sympy.cos) and all(f in names for f in doubled):
            found.append((cosine, names[sympy.sin(angle)], *(names[f] for f in doubled)))
    return found


def multiply(
    desk: Desk,
    fact_id: str,
    left: MatrixExpr,
    right: MatrixExpr,
    why: str,
    source: Sequence[str] = (),
) -> Step:
    """left = right, two expressions in named matrices: both multiplied out by the kernel."""
    fact = desk.decide_matrices(fact_id, left, right, source)
    shown = Eq(left, right, evaluate=False)
    return desk.note(Step("multiply", why, right, (shown,), fact, source=tuple(source)))


def determinant(
    desk: Desk, fact_id: str, name: MatrixSymbol, why: str, source: Sequence[str] = ()
) -> Step:
    """det of a named matrix, as a real expression."""
    value = tidy(desk, desk.explicit(name).det(method="berkowitz"))
    real, imaginary = desk.determinant(name)
    parts: list[tuple[str, sympy.Expr | str]] = [(real, value)]
    parts += [(imaginary, "0")] if imaginary else []
    fact = desk.decide(fact_id, parts, source)
    shown = Eq(Determinant(name), value, evaluate=False)
    return desk.note(Step("multiply", why, value, (shown,), fact, source=tuple(source)))
