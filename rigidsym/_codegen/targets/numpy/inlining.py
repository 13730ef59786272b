"""Routines with short calls replaced by what these compute, since calls in Python are slow."""

import ast
from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import Any

from rigidsym._codegen.routines import DOUBLE, PAIR, Program, Routine, Type, copied, declaration


def flattened(one: Routine, program: Program) -> Routine:
    """Replace the pairs between the lines of an operation by their halves.

    The calls that compute these are replaced by their lines.
    """
    if one.results not in ((PAIR,), (DOUBLE,)):
        return one
    flat = _Flat(program)
    values = flat.result(one, {}, "")
    if isinstance(values, tuple):
        values = ast.Call(ast.Name("pair", ast.Load()), list(values), [])
    return replace(one, body=tuple(_nested([*flat.lines, ast.Return(values)])))


def _nested(lines: list[ast.stmt]) -> Iterator[ast.stmt]:
    """Write values that are used once where they are used, so that no array is kept for them."""
    every = [node for line in lines for node in ast.walk(line)]
    used = Counter(x.id for x in every if isinstance(x, ast.Name))
    changing = {ast.unparse(x.target) for x in every if isinstance(x, ast.AugAssign)}
    known: dict[str, Any] = {}
    for line in lines:
        changed = _Known(known).visit(line)
        match changed:
            # Once here, and once where it is used.
            case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value) if used[
                name
            ] == 2 and changing.isdisjoint(map(ast.unparse, ast.walk(value))):
                known[name] = value
            case _:
                yield changed


def inlined(one: Routine, program: Program, apart: Collection[str]) -> Routine:
    """Replace calls of routines that are one expression by this, where arguments are simple.

    apart: the names of those to call.
    """
    change = _Inlined(program, apart)
    body = tuple(ast.fix_missing_locations(change.visit(part)) for part in map(copied, one.body))
    return replace(one, body=body)


class _Inlined(ast.NodeTransformer):
    """Replacement of calls by the one expression that a routine returns."""

    def __init__(self, program: Program, apart: Collection[str]) -> None:
        self.program, self.apart = program, apart

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Replace a call whose arguments may be computed more than once."""
        self.generic_visit(node)
        one = self.program.routines.get(ast.unparse(node.func))
        if one is None or one.name in self.apart or "inline" not in one.decorators:
            return node
        match one.body:
            case (ast.Return(value=ast.expr() as value),) if len(one.results) == 1:
                if all(map(_is_simple, node.args)):
                    known = dict(zip(one.parameters, node.args, strict=True))
                    return self.visit(_Known(known).visit(copied(value)))
        return node


def _is_simple(node: ast.expr) -> bool:
    """Return True for names, numbers, halves and elements of these at fixed places."""
    match node:
        case ast.Attribute(value=value) | ast.Subscript(value=value, slice=ast.Constant()):
            return _is_simple(value)
    return isinstance(node, ast.Name | ast.Constant)


class _Flat:
    """Lines of an operation on pairs, without pairs."""

    def __init__(self, program: Program) -> None:
        self.program, self.lines = program, list[ast.stmt]()

    def result(self, one: Routine, known: dict[str, Any], prefix: str) -> Any:
        """Add the lines of a routine, and return the halves of its result.

        known: the values of its parameters, and of its names so far.
        """
        for statement in one.body:
            match statement:
                case ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as value):
                    found = self._value(value, known, f"{prefix}{name}_")
                    if isinstance(found, tuple):
                        ends = zip(("hi", "lo"), found, strict=True)
                        known[name] = tuple(
                            self._kept(x, f"{prefix}{name}_{end}") for end, x in ends
                        )
                    else:
                        self.lines.append(declaration(f"{prefix}{name}", "double", found))
                        known[name] = ast.Name(f"{prefix}{name}", ast.Load())
                case ast.AugAssign(target=ast.Name(id=name), op=op, value=value):
                    value = _Known(known).visit(copied(value))
                    self.lines.append(ast.AugAssign(known[name], op, value))
                case ast.Return(value=ast.expr() as value):
                    return self._value(value, known, f"{prefix}r_")
        raise ValueError(f"{one.name}: returns nothing")

    def _value(self, node: ast.expr, known: dict[str, Any], prefix: str) -> Any:
        match node:
            case ast.Call(func=ast.Name(id="product_error"), args=parts):
                split = ast.Name("split_product_error", ast.Load())
                return self._value(ast.Call(split, parts, []), known, prefix)
            case ast.Call(func=ast.Name(id="pair"), args=parts):
                ends = zip(("hi", "lo"), parts, strict=True)
                return tuple(self._value(part, known, f"{prefix}{end}_") for end, part in ends)
            case ast.Call(func=ast.Name(id=name), args=parts) if self._is_flat(name):
                one = self.program.routines[name]
                given = {
                    parameter: self._argument(part, type_, known, f"{prefix}{parameter}")
                    for part, (parameter, type_) in zip(parts, one.parameters.items(), strict=True)
                }
                return self.result(one, given, prefix)
        return _Known(known).visit(copied(node))

    def _is_flat(self, name: str) -> bool:
        one = self.program.routines.get(name)
        return one is not None and one.results in ((PAIR,), (DOUBLE,))

    def _argument(self, node: ast.expr, type_: Type, known: dict[str, Any], name: str) -> Any:
        if isinstance(node, ast.Name) and type_.is_pair:
            return known.get(node.id, node)
        return self._kept(_Known(known).visit(copied(node)), name)

    def _kept(self, node: ast.expr, name: str) -> ast.expr:
        """Give a value a name, unless it has one."""
        if isinstance(node, ast.Name | ast.Attribute):
            return node
        self.lines.append(declaration(name, "double", node))
        return ast.Name(name, ast.Load())


class _Known(ast.NodeTransformer):
    """Replacement of names by their values, and of the halves of pairs by these."""

    def __init__(self, known: dict[str, Any]) -> None:
        self.known = known

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a name whose value is known."""
        return self.known.get(node.id, node)

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        """Replace a half of a pair."""
        match node.value:
            case ast.Name(id=name) if isinstance(self.known.get(name), tuple):
                return self.known[name][("hi", "lo").index(node.attr)]
        return ast.Attribute(self.visit(node.value), node.attr, ast.Load())
