"""Routines for languages without types, in which structs are objects.

Declarations are `x: let = ...`, or `x: const = ...` if x never changes.  Structs and arrays are
made with zeros, by `new_<struct>()`, and copied by `assign(to, from)` and `copy(to, from, count)`.
Conversions to doubles are dropped, and bits are cut off at 64 by `cut(...)`.
"""

import ast
from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import replace

from rigidsym._codegen.printer import set_again
from rigidsym._codegen.routines import Program, Routine, Scope, Struct, Type, annotation

# Operations that may leave more than 64 bits.
_WIDENING = (ast.Mult, ast.LShift)
LET = "let"
# Functions that are one without types.
_SAME = {"dd_pair": "pair", "size": "int"}


def with_objects(program: Program) -> Program:
    """Replace what depends on types by calls, and types by `let` and `const`."""
    changed = {name: _Body(one, program).routine() for name, one in program.routines.items()}
    return replace(program, routines=changed)


def zero(type_: Type) -> ast.expr:
    """Return zeros of a type."""
    if type_.shape:
        return ast.List([zero(type_.element())] * int(type_.shape[0]), ast.Load())
    if type_.name == "union":
        keys: list[ast.expr | None] = [ast.Constant(name) for name in type_.members]
        return ast.Dict(keys, [_call(f"new_{name}") for name in type_.members])
    if type_.is_object:
        return _call(f"new_{type_.name}")
    if type_.is_pair:
        return ast.Name("ZERO", ast.Load())
    return ast.Constant(False if type_.name == "bool" else 0)


def members(struct: Struct) -> ast.Dict:
    """Return the members of a struct with zeros."""
    names: list[ast.expr | None] = [ast.Constant(x.name) for x in struct.fields]
    return ast.Dict(names, [zero(x.type) for x in struct.fields])


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])


class _Body(ast.NodeTransformer):
    """Statements of a routine, changed so that they need no types."""

    def __init__(self, one: Routine, program: Program) -> None:
        self.one, self.scope, self.changing = one, Scope(one, program), set_again(one, program)

    def routine(self) -> Routine:
        """Return the routine with all its statements changed."""
        return replace(self.one, body=tuple(self._block(self.one.body)))

    def _block(self, body: Sequence[ast.stmt]) -> list[ast.stmt]:
        outside, found = dict(self.scope.types), []
        for statement in body:
            known = set(self.scope.types)
            self.scope.declare(statement)
            changed = list(self._changed(statement, known))
            for name, one in (("note", changed[0]), ("let", changed[-1])):
                if value := getattr(statement, name, None):
                    setattr(one, name, value)
            found += map(ast.fix_missing_locations, changed)
        self.scope.types = outside
        return found

    def _changed(self, node: ast.stmt, known: set[str]) -> Iterator[ast.stmt]:
        node = copy(node)
        match node:
            case ast.If():
                node.test = self.visit(node.test)
                node.body, node.orelse = self._block(node.body), self._block(node.orelse)
                yield node
            case ast.For():
                node.iter, node.body = self.visit(node.iter), self._block(node.body)
                yield node
            case ast.AnnAssign(target=ast.Name(id=name), value=value):
                yield self._declared(name, value)
            case ast.Assign(targets=[ast.Tuple(elts=targets) as target], value=value):
                names = [x.id for x in targets if isinstance(x, ast.Name)]
                new = [name for name in names if name not in known]
                whole = ast.Assign([self.visit(target)], self.visit(value))
                if len(new) == len(targets):
                    whole.type_comment = LET
                else:
                    yield from (_declaration(name, None, LET) for name in new)
                yield whole
            case ast.Assign(targets=[target], value=value):
                type_, to, value = self.scope.of(target), self.visit(target), self.visit(value)
                if type_.shape:
                    yield ast.Expr(_call("copy", to, value, ast.Constant(int(type_.shape[0]))))
                elif type_.is_object:
                    yield ast.Expr(_call("assign", to, value))
                else:
                    yield ast.Assign([to], value)
            case ast.Expr(value=ast.Call(func=ast.Name(id="cleared"), args=[struct])):
                new_one = _call(f"new_{self.scope.of(struct).name}")
                yield ast.Expr(_call("assign", self.visit(struct), new_one))
            case other:
                self.generic_visit(other)
                yield other

    def _declared(self, name: str, value: ast.expr | None) -> ast.stmt:
        type_ = self.scope.types[name]
        is_whole = bool(type_.shape) or type_.is_object
        if value is not None:
            value = self.visit(value)
            if type_.is_object and not isinstance(value, ast.Call):
                value = _call("assign", zero(type_), value)
        elif is_whole:
            value = zero(type_)
        is_kept = value is not None and (is_whole or name not in self.changing)
        return _declaration(name, value, "const" if is_kept else LET)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        """Cut bits off at 64, and fractions of whole numbers."""
        kind = self.scope.of(node).name
        left, right = self.visit(node.left), self.visit(node.right)
        if isinstance(node.op, ast.FloorDiv):
            return _call("int", ast.BinOp(left, ast.Div(), right))
        if kind != "bits":
            return ast.BinOp(left, node.op, right)
        whole = ast.BinOp(_big(left), node.op, _big(right))
        if self.scope.of(node.right).name != "bits" and not isinstance(right, ast.Constant):
            whole.right = _call("bits", right)
        return _call("cut", whole) if isinstance(node.op, _WIDENING) else whole

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        """Return an element of an array of arrays as one of an array's element."""
        array = self.visit(node.value)
        match node.slice:
            case ast.Slice(lower=None):
                return array
            case ast.Slice(lower=ast.expr() as first):
                place: ast.expr = ast.Slice(self.visit(first), None, None)
            case ast.Tuple(elts=[*rows, last]):
                for row in rows:
                    array = ast.Subscript(array, self.visit(row), ast.Load())
                place = self.visit(last)
            case other:
                place = self.visit(other)
        return ast.Subscript(array, place, node.ctx)

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Drop conversions to doubles, and call by one name what is one function."""
        match node:
            case ast.Call(func=ast.Name(id="double"), args=[value]):
                return self.visit(value)
            case ast.Call(func=ast.Name(id=name), args=given):
                return _call(_SAME.get(name, name), *map(self.visit, given))
        raise ValueError(f"{ast.unparse(node)}: structs have no functions")


def _big(node: ast.expr) -> ast.expr:
    """Return a constant as one of 64 bits; other expressions unchanged."""
    match node:
        case ast.Constant(value=int(value)):
            return ast.Constant(value, kind="n")
    return node


def _declaration(name: str, value: ast.expr | None, word: str) -> ast.AnnAssign:
    return ast.AnnAssign(ast.Name(name, ast.Store()), annotation(word), value, simple=1)
