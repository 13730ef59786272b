"""Expressions of the NumPy module read back: operators, and calls of what the module has."""

import ast
from collections.abc import Collection

from rigidsym.errors import InputError
from rigidsym.language.expression import (
    Call,
    Expression,
    Operation,
    children,
    parse,
    rebuild,
)

# What hand-written functions, and one of Python's, compute; `_horner` is a polynomial.
_CALLED = {
    **{"abs": "size", "_sqrt": "sqrt", "_choose": "choose", "_rounded": "rounded"},
    **{"_exponent": "exponent", "_mantissa": "mantissa", "_exp": "exp", "_nearest": "nearest"},
    **{"_alternating": "alternating", "_product_error": "product_error"},
}


def read(place: str, node: ast.expr, known: Collection[str]) -> Expression:
    """An expression, which may call what is written by hand and the functions that are known.

    Raises InputError, naming the place, for what is no expression of this module.
    """
    _check(place, node, {*_CALLED, "_horner", *known})
    try:
        return _read(parse(ast.unparse(node)))
    except ValueError as error:
        raise InputError(place, ast.unparse(node), str(error)) from None


def _check(place: str, node: ast.expr, known: set[str]) -> None:
    """Calls are of known functions: `neg`, which the parser has for a sign, is none."""
    for part in ast.walk(node):
        if isinstance(part, ast.Call) and ast.unparse(part.func) not in known:
            raise InputError(place, ast.unparse(part), "calls what is not known")


def _read(expression: Expression) -> Expression:
    match rebuild(expression, tuple(map(_read, children(expression)))):
        case Call("_horner", (variable, *coefficients)):
            return _nested(variable, tuple(coefficients))
        case Call(function, arguments):
            return Call(_CALLED.get(function, function), arguments)
        case other:
            return other


def _nested(variable: Expression, coefficients: tuple[Expression, ...]) -> Expression:
    """c_0 + x*(c_1 + x*(c_2 + ...))."""
    first, *rest = coefficients
    if not rest:
        return first
    return Operation("+", first, Operation("*", variable, _nested(variable, tuple(rest))))
