"""Expressions of formulas and of generated code as small immutable trees.

The text form is Python's own, so `parse` and `to_text` are inverse to each other and a formula
printed into a generated Python module can be read back and compared.
"""

import ast
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

_SYMBOL: dict[type, str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**"}
_BINDING = {"+": 1, "-": 1, "*": 2, "/": 2, "neg": 3, "**": 4}


@dataclass(frozen=True, slots=True)
class Number:
    """An integer constant."""

    value: int


@dataclass(frozen=True, slots=True)
class Name:
    """A variable, identified by its name."""

    name: str


@dataclass(frozen=True, slots=True)
class Operation:
    """A binary operation in an expression.

    The operator is one of + - * / **.
    """

    operator: str
    left: "Expression"
    right: "Expression"


@dataclass(frozen=True, slots=True)
class Call:
    """A function call in an expression.

    Negation is a call of `neg`.
    """

    function: str
    arguments: tuple["Expression", ...]


Expression = Number | Name | Operation | Call


def parse(text: str) -> Expression:
    """Parse an expression written in Python syntax.

    Raises ValueError for anything else.
    """
    return _parse(ast.parse(text, mode="eval").body)


def _parse(node: ast.expr) -> Expression:
    match node:
        case ast.Constant(value=int(value)):
            return Number(value)
        case ast.Name(id=name):
            return Name(name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return Call("neg", (_parse(operand),))
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _SYMBOL:
            return Operation(_SYMBOL[type(op)], _parse(left), _parse(right))
        case ast.Call(func=ast.Name(id=function), args=arguments, keywords=[]):
            return Call(function, tuple(map(_parse, arguments)))
    raise ValueError(f"{ast.unparse(node)}: not part of an expression")


def to_text(
    expression: Expression, rename: Mapping[str, str] | None = None, *, real: bool = False
) -> str:
    """Return an expression as Python source, with no more parentheses than needed.

    `rename` maps function names.  `real` writes integers with a decimal point, as C needs them.
    """
    return _print(expression, rename or {}, ".0" if real else "")[0]


def _print(expression: Expression, rename: Mapping[str, str], point: str) -> tuple[str, int]:
    match expression:
        case Number(value):
            return f"{value}{point}", 5
        case Name(name):
            return name, 5
        case Call("neg", (operand,)):
            return f"-{_within(operand, 3, rename, point)}", _BINDING["neg"]
        case Call(function, arguments):
            inside = ", ".join(_print(a, rename, point)[0] for a in arguments)
            return f"{rename.get(function, function)}({inside})", 5
        case Operation(symbol, left, right):
            bound = _BINDING[symbol]
            tight = symbol == "**"
            before = _within(left, bound + tight, rename, point)
            after = _within(right, bound + (not tight), rename, point)
            return f"{before}{symbol}{after}" if tight else f"{before} {symbol} {after}", bound
    raise TypeError(f"{expression!r} is not an expression")


def _within(expression: Expression, bound: int, rename: Mapping[str, str], point: str) -> str:
    text, own = _print(expression, rename, point)
    return text if own >= bound else f"({text})"


def children(expression: Expression) -> tuple[Expression, ...]:
    """Return the operands of an operation or the arguments of a call.

    Numbers and names have none.
    """
    if isinstance(expression, Operation):
        return expression.left, expression.right
    return expression.arguments if isinstance(expression, Call) else ()


def rebuild(expression: Expression, parts: tuple[Expression, ...]) -> Expression:
    """Return a copy of an expression node with new children."""
    if isinstance(expression, Operation):
        return Operation(expression.operator, *parts)
    return Call(expression.function, parts) if isinstance(expression, Call) else expression


def put(expression: Expression, meaning: Mapping[str, Expression]) -> Expression:
    """Substitute expressions for names, all simultaneously."""
    if isinstance(expression, Name):
        return meaning.get(expression.name, expression)
    return rebuild(expression, tuple(put(part, meaning) for part in children(expression)))


def names(expression: Expression) -> Iterator[str]:
    """Yield the names in an expression from left to right, repetitions included."""
    # Nested generators would take the time of all levels for each name.
    waiting = [expression]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Name):
            yield part.name
        else:
            waiting += children(part)[::-1]


def by_products(expression: Expression) -> Expression:
    """Replace each power `x**n` in an expression by the call `power(x, n)`."""
    parts = tuple(map(by_products, children(expression)))
    if isinstance(expression, Operation) and expression.operator == "**":
        return Call("power", parts)
    return rebuild(expression, parts)


def complement(parameter: Expression) -> Expression:
    """Return the complement 1 - m of a parameter m.

    Where m is written 1 - x, the complement is x.
    """
    match parameter:
        case Operation("-", Number(1), right):
            return right
    return Operation("-", Number(1), parameter)
