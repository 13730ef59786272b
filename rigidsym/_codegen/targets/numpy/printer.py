"""Printer of decisions as Python functions over NumPy arrays, where a number is one of each body.

The same functions take floats.  A choice computes both values, and takes one for each body.
"""

import ast
from collections.abc import Iterable, Iterator
from typing import Any

from rigidsym._codegen.routines import Program, Routine, Scope, Type

# Functions of the module, by the primitives and operations that they are.
_CALLS = {
    **{"sqrt": "_sqrt", "dd_sqrt": "_sqrt", "dd_size": "abs", "dd_rounded": "_rounded"},
    **{"choose": "_choose", "dd_choose": "_choose", "pair": "_DoubleDouble"},
    **{"dd_of": "_DoubleDouble", "two_sum": "_two_sum_pair", "two_product": "_two_product"},
    **{"product_error": "_product_error", "exponent": "_power", "ldexp": "_ldexp"},
    **{"bits_of": "_bits_of", "from_bits": "_from_bits", "abs": "abs"},
}
# What the module computes with in a way of its own.
_OWN = {"split_product_error"}
_OPERATIONS = {"add": ast.Add, "sub": ast.Sub, "mul": ast.Mult, "div": ast.Div}
_CONDITIONS = {"isfinite": "abs({}) < math.inf", "isnan": "{0} != {0}"}


def decisions(program: Program, roots: Iterable[str]) -> Iterator[str]:
    """Yield the text of decisions that a runtime calls, each after what it calls itself."""
    wanted, queue = set[str](), [*roots]
    while queue:
        name = queue.pop()
        if name not in wanted | _CALLS.keys() and not name.startswith("dd_"):
            wanted.add(name)
            queue += program.routines[name].calls() & program.routines.keys() - _OWN
    for name, one in program.in_order().routines.items():
        if name in wanted:
            yield _Printed(one, program).text()


class _Printed(ast.NodeTransformer):
    """Change of a decision to a function of arrays."""

    def __init__(self, one: Routine, program: Program) -> None:
        self.one, self.program, self.scope = one, program, Scope(one, program)

    def text(self) -> str:
        """Return the text of the function."""
        body = [line for part in self.one.body for line in self._lines(part, "    ")]
        head = f"def _{self.one.name}({', '.join(self.one.parameters)}):"
        words = [f"    {line}".rstrip() for line in f'"""{self.one.summary}'.splitlines()]
        words[-1] += '"""' if len(words) == 1 else '\n    """'
        return "\n".join([head, *words, *body])

    def _lines(self, node: ast.stmt, indent: str) -> Iterator[str]:
        self.scope.declare(node)
        match node:
            case ast.For():
                yield f"{indent}for {ast.unparse(node.target)} in {ast.unparse(node.iter)}:"
                for part in node.body:
                    yield from self._lines(part, f"{indent}    ")
            case ast.AnnAssign(target=target, value=None):
                # Elements are set one by one.
                if shape := self.scope.of(target).shape:
                    yield f"{indent}{ast.unparse(target)} = [None] * {shape[0]}"
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield f"{indent}{ast.unparse(target)} = {self._value(value)}"
            case ast.Assign(targets=[target], value=value):
                yield f"{indent}{ast.unparse(target).strip('()')} = {self._value(value)}"
            case ast.AugAssign(target=target, op=op, value=value):
                # Not in place: the array may be a caller's.
                whole = ast.BinOp(target, op, value)
                yield f"{indent}{ast.unparse(target)} = {self._value(whole)}"
            case ast.Return(value=ast.Tuple(elts=parts)):
                yield f"{indent}return {', '.join(map(self._value, parts))}"
            case ast.Return(value=ast.expr() as value):
                yield f"{indent}return {self._value(value)}"
            case _:
                raise ValueError(f"{self.one.name}: {ast.unparse(node)}: is no line of a decision")

    def _value(self, node: ast.expr) -> str:
        return ast.unparse(self.visit(node))

    def _type(self, node: ast.expr) -> Type:
        return self.scope.of(node)

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Write limits in capitals."""
        if node.id in self.program.numbers and node.id not in self.one.parameters:
            return ast.Name(node.id.upper(), node.ctx)
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        """Select the element of each body where the place differs between bodies."""
        value, place = self.visit(node.value), self.visit(node.slice)
        if self._type(node.slice).name == "int" and not isinstance(node.slice, ast.Constant):
            return _call("_taken", value, place)
        return ast.Subscript(value, place, node.ctx)

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Compute both values."""
        return _call("_where", *map(self.visit, (node.test, node.body, node.orelse)))

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Combine conditions element by element."""
        operation: Any = ast.BitAnd() if isinstance(node.op, ast.And) else ast.BitOr()
        first, *others = map(self.visit, node.values)
        for other in others:
            first = ast.BinOp(first, operation, other)
        return first

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """Negate conditions element by element."""
        operand = self.visit(node.operand)
        if isinstance(node.op, ast.Not):
            return ast.BinOp(operand, ast.BitXor(), ast.Constant(True))
        return ast.UnaryOp(node.op, operand)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        """Keep 64 bits of what may have more."""
        changed = ast.BinOp(self.visit(node.left), node.op, self.visit(node.right))
        if isinstance(node.op, ast.Mult | ast.LShift) and self._type(node).name == "bits":
            return ast.BinOp(changed, ast.BitAnd(), ast.Name("_MASK", ast.Load()))
        return changed

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Call what the module has."""
        name, given = ast.unparse(node.func), [self.visit(one) for one in node.args]
        kind, _, verb = name.partition("_")
        operation = verb.partition("_")[0]
        if kind == "dd" and operation in _OPERATIONS:
            return ast.BinOp(given[0], _OPERATIONS[operation](), given[1])
        if name == "dd_neg":
            return ast.UnaryOp(ast.USub(), given[0])
        if name in _CONDITIONS:
            text = _CONDITIONS[name].format(ast.unparse(given[0]))
            return ast.parse(text, mode="eval").body
        if name in _CALLS or name == "range":
            return _call(_CALLS.get(name, name), *given)
        if name not in self.program.routines:
            raise ValueError(f"{self.one.name}: {name}: the module has no such function")
        return _call(f"_{name}", *given)


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])
