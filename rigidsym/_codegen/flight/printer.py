"""Printer of C for the flight profile: C99 by the required rules of MISRA C:2012.

It differs from the C target's printer in what rules ask for: brackets around all operations within
others, whole numbers of the type of what they meet, truth values as `bool`, no `restrict`, and
assertions of preconditions at the start of functions.
"""

import ast
import re
from collections.abc import Iterator
from typing import Any

from rigidsym._codegen.lines import Lines
from rigidsym._codegen.printer import OPERATIONS
from rigidsym._codegen.routines import Number, Routine, Type
from rigidsym._codegen.targets.c.printer import Printer

# Operators bind less than this; a sign or a call binds as much, or more.
_UNARY = 11
_UNSIGNED = ("size", "bits")


class FlightPrinter(Printer):
    """Printer of a program's structs, numbers and routines for the flight profile."""

    def type_name(self, name: str) -> str:
        """Return the name of a type in C."""
        return "bool" if name == "bool" else super().type_name(name)

    def declared(self, name: str, type_: Type, *, is_parameter: bool = False) -> str:
        """Return the declaration of a name, without `restrict`."""
        return super().declared(name, type_, is_parameter=is_parameter).replace("restrict ", "")

    def number(self, number: Number) -> str:
        """Print the definition of a named number or array; texts are one a line."""
        match number:
            case Number(type=Type(name="text", shape=(count,)), value=ast.List(elts=texts)):
                rows = ",\n    ".join(map(self.text, texts))
                return f"static const char *const {number.name}[{count}] = {{\n    {rows}}};"
        return super().number(number)

    def head(self, one: Routine) -> str:
        """Return the head of a routine; the compiler decides what it expands in place."""
        return super().head(one).replace("INLINED ", "")

    def _called(self, node: ast.Call, *more: Any) -> str:
        match node.func:
            case ast.Name(id="product_error"):
                node = ast.Call(ast.Name("split_product_error", ast.Load()), node.args, [])
        return super()._called(node, *more)

    def routine(self, one: Routine) -> Lines:
        """Print a routine, with assertions of its preconditions after its head."""
        plain = super().routine(one)
        asserted = [f"    require({text}, __LINE__);" for text in preconditions(one)]
        first = plain.text.index("{") + 1
        text = (*plain.text[:first], *asserted, *plain.text[first:])
        lets = {
            number + (len(asserted) if number >= first else 0): let
            for number, let in plain.lets.items()
        }
        return Lines(text, lets)

    def text(self, node: ast.expr, least: int = 0) -> str:
        """Print an expression, in brackets wherever it stands within another operation."""
        found, bound = self._expressions[type(node)](node)
        return found if bound >= _UNARY or (least == 0 and bound >= least) else f"({found})"

    def _constant(self, node: ast.Constant) -> tuple[str, int]:
        if isinstance(node.value, bool):
            return str(node.value).lower(), _UNARY + 1
        return super()._constant(node)

    def _subscript(self, node: ast.Subscript) -> tuple[str, int]:
        match node.slice:
            case ast.Slice(lower=ast.expr() as lower):
                return f"&{self.text(node.value, _UNARY)}[{self.text(lower)}]", _UNARY
        return super()._subscript(node)

    def _operand(self, node: ast.expr, other: ast.expr, least: int) -> str:
        match node:
            case ast.Constant(value=int(value)) if self.scope.of(other).name in _UNSIGNED:
                return f"{value:#x}ULL" if self.scope.of(other).name == "bits" else f"{value}u"
        return super()._operand(node, other, least)

    def _operation(self, node: ast.BinOp) -> tuple[str, int]:
        match node:
            case ast.BinOp(op=ast.LShift() | ast.RShift(), right=ast.Name() as places):
                cast = ast.Call(ast.Name("bits", ast.Load()), [places], [])
                node = ast.BinOp(node.left, node.op, cast)
        return super()._operation(node)

    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        match node.value:
            case ast.IfExp() as choice if ast.unparse(node.annotation) in ("int", "size"):
                value = _cast(choice, ast.unparse(node.annotation))
                node = ast.AnnAssign(node.target, node.annotation, value, node.simple)
        return super()._declaration(node)

    def _choice(self, node: ast.IfExp) -> tuple[str, int]:
        if self.scope.of(node).name == "int":
            return super()._choice(
                ast.IfExp(node.test, _cast(node.body, "int"), _cast(node.orelse, "int"))
            )
        return super()._choice(node)

    def _change(self, node: ast.AugAssign) -> Iterator[str]:
        symbol = OPERATIONS[type(node.op)][0]
        yield f"{self.text(node.target)} {symbol}= {self._operand(node.value, node.target, 0)};"

    def _comparison(self, node: ast.Compare) -> tuple[str, int]:
        (right,) = node.comparators
        text, bound = super()._comparison(node)
        match right:
            case ast.Constant(value=int()) if self.scope.of(node.left).name in _UNSIGNED:
                return f"{text}u", bound
        return text, bound

    def _call_alone(self, node: ast.Expr) -> Iterator[str]:
        return map(_unused, super()._call_alone(node))

    def _assignment(self, node: ast.Assign) -> Iterator[str]:
        return map(_unused, super()._assignment(node))

    def _for(self, node: ast.For) -> Iterator[Any]:
        first, *rest = super()._for(node)
        match node.iter:
            case ast.Call(args=[ast.Constant(value=int(end))]):
                name = ast.unparse(node.target)
                first = f"for (size_t {name} = 0u; {name} < {end}u; {name}++) {{"
        yield first
        yield from rest


def _cast(node: ast.expr, kind: str) -> ast.expr:
    """Make whole numbers, of which one is chosen, those of a type."""
    match node:
        case ast.Constant(value=int()):
            return ast.Call(ast.Name(kind, ast.Load()), [node], [])
        case ast.IfExp(test=test, body=body, orelse=other):
            return ast.IfExp(test, _cast(body, kind), _cast(other, kind))
    return node


def _unused(line: str) -> str:
    """Say that the value of a function of the C library is not used."""
    if not line.startswith(("memcpy(", "memset(")):
        return line
    return re.sub(r"(\d+) \* sizeof", r"\1u * sizeof", f"(void){line}")


def preconditions(one: Routine) -> Iterator[str]:
    """Yield what a routine takes for granted: pointers that point, indices within arrays."""
    if one.is_public:
        for name, type_ in one.parameters.items():
            is_pointer = type_.is_struct or bool(type_.shape) or type_.is_out
            if is_pointer and not type_.may_be_none:
                yield f"{name} != NULL"
    for name, length in _indices(one).items():
        # As an unsigned number a negative index is beyond the end, too.
        yield f"(uint32_t){name} < {length}u"


def _indices(one: Routine) -> dict[str, str]:
    """Map the parameters that are indices to the lengths of their arrays."""
    found: dict[str, str] = {}
    for node in (node for part in one.body for node in ast.walk(part)):
        match node:
            case ast.Subscript(value=ast.Name(id=array), slice=ast.Name(id=index)):
                whole, place = one.parameters.get(array), one.parameters.get(index)
                if whole and place and place.name == "int" and whole.shape[0].isdigit():
                    found[index] = whole.shape[0]
    return found
