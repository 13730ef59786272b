"""Reading of functions of arrays back as the routines that they print."""

import ast
from collections.abc import Iterable, Iterator
from typing import Any

from rigidsym._codegen.routines import (
    BOOL,
    Program,
    Routine,
    Scope,
    copied,
    statement,
    type_of_annotation,
)
from rigidsym._codegen.seal.bodies import Raised
from rigidsym._codegen.targets.numpy.printer import CALLS, fresh
from rigidsym.errors import InputError

# Of several routines that one function is, the first.
_CALLED = {text: name for name, text in reversed(CALLS.items()) if not name.startswith("dd_")}


def wanted_of(one: Routine) -> list[ast.stmt]:
    """Return the statements of a routine without types, and with operations of pairs."""
    return list(_wanted(map(copied, one.body), fresh(one)))


def _wanted(body: Iterable[ast.stmt], own: set[str]) -> Iterator[ast.stmt]:
    for part in body:
        match part:
            case ast.AnnAssign(target=target, annotation=kind, value=None):
                if shape := type_of_annotation(kind).shape:
                    yield statement(f"{ast.unparse(target)} = [None] * {shape[0]}")
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                yield _assigned(target, _Alike().visit(Raised().visit(value)))
            case ast.AugAssign(target=target, op=op, value=value):
                changed = _Alike().visit(Raised().visit(value))
                if ast.unparse(target) in own:
                    yield ast.AugAssign(target, op, changed)
                else:
                    yield _assigned(target, ast.BinOp(target, op, changed))
            case ast.For() | ast.If():
                head = "test" if isinstance(part, ast.If) else "iter"
                setattr(part, head, _Alike().visit(Raised().visit(getattr(part, head))))
                part.body, part.orelse = (list(_wanted(x, own)) for x in (part.body, part.orelse))
                yield part
            case _:
                yield _Alike().visit(Raised().visit(part))


def _assigned(target: ast.expr, value: ast.expr) -> ast.stmt:
    return ast.fix_missing_locations(ast.Assign([target], value, lineno=1))


class _Alike(ast.NodeTransformer):
    """Replacement of routines that are the same for arrays by one of them."""

    def visit_Call(self, node: ast.Call) -> ast.Call:
        """Replace the name of a function by that which is read."""
        self.generic_visit(node)
        name = ast.unparse(node.func)
        return ast.Call(_name(_CALLED.get(CALLS.get(name, ""), name)), node.args, [])


def _name(name: str) -> ast.Name:
    return ast.Name(name, ast.Load())


def read_routine(
    file: str, node: ast.FunctionDef, one: Routine, program: Program
) -> list[ast.stmt]:
    """Read the statements of a function.

    Raises InputError for what no routine has.
    """
    scope = Scope(one, program)
    for part in one.statements():
        scope.declare(part)
    try:
        return list(_Read(scope).block(node.body[1:]))
    except (ValueError, KeyError) as error:
        raise InputError(f"{file}:{node.lineno}", node.name, f"is no routine: {error}") from None


class _Read(ast.NodeTransformer):
    """Change of a function of arrays to a routine of one body."""

    def __init__(self, scope: Scope) -> None:
        self.scope = scope

    def block(self, body: Iterable[ast.stmt]) -> Iterator[ast.stmt]:
        """Read statements; each knows its line."""
        for part in body:
            match part:
                case ast.Assign(
                    targets=[target],
                    value=ast.Call(
                        func=ast.Name(id="_only"),
                        args=[test, ast.Name(id=called), values, ast.Tuple(elts=given)],
                    ),
                ) if _same(target, values):
                    call = ast.Call(_name(called), given, [])
                    inner = ast.Assign([target], self.visit(call), lineno=part.lineno)
                    yield ast.If(self.visit(test), [inner], [], lineno=part.lineno)
                case ast.For() | ast.If():
                    head = "test" if isinstance(part, ast.If) else "iter"
                    setattr(part, head, self.visit(getattr(part, head)))
                    part.body, part.orelse = (
                        list(self.block(lines)) for lines in (part.body, part.orelse)
                    )
                    yield part
                case ast.Assign() | ast.AugAssign() | ast.Return():
                    yield self.visit(part)
                case _:
                    raise ValueError(f"{ast.unparse(part)[:80]}: is no statement of a routine")

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Read choices, elements and calls."""
        if node.keywords:
            raise ValueError(f"{ast.unparse(node)[:80]}: a keyword")
        name, given = ast.unparse(node.func), [self.visit(x) for x in node.args]
        match name, given:
            case "_where", [test, body, other]:
                return ast.IfExp(test, body, other)
            case "_taken", [array, place]:
                return ast.Subscript(array, place, ast.Load())
            case "_paired", [ast.Call() as call]:
                return call
            case "_DoubleDouble", [one]:
                return one
            case "_DoubleDouble", [_, _]:
                return ast.Call(_name("pair"), given, [])
        if name not in _CALLED and name != "range" and not name.startswith("_"):
            raise ValueError(f"{name}: is called and not known")
        return ast.Call(_name(_CALLED.get(name, name.removeprefix("_"))), given, [])

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Read limits, which are in capitals."""
        is_limit = node.id.isupper() and node.id.lower() in self.scope.program.numbers
        return _name(node.id.lower()) if is_limit and node.id not in self.scope.types else node

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        """Read halves of pairs, and infinity."""
        if ast.unparse(node) == "math.inf":
            return _name("inf")
        return ast.Attribute(self.visit(node.value), node.attr, ast.Load())

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        """Read a test for finite numbers, and for those that are none."""
        left, right = self.visit(node.left), [self.visit(x) for x in node.comparators]
        match node.ops, left, right:
            case [ast.Lt()], ast.Call(func=ast.Name(id="abs"), args=given), [ast.Name(id="inf")]:
                return ast.Call(_name("isfinite"), given, [])
            case [ast.NotEq()], _, [other] if _same(left, other):
                return ast.Call(_name("isnan"), [left], [])
        return ast.Compare(left, node.ops, right)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        """Read conditions, and numbers of 64 bits, which products and shifts may exceed."""
        match node.op, node.left, node.right:
            case ast.BitAnd(), ast.BinOp(op=ast.Mult() | ast.LShift()) as inner, ast.Name(
                id="_MASK"
            ):
                return ast.BinOp(self.visit(inner.left), inner.op, self.visit(inner.right))
        left, right = self.visit(node.left), self.visit(node.right)
        type_ = self.scope.of(left)
        match node.op, right:
            case ast.BitXor(), ast.Constant(value=True):
                return ast.UnaryOp(ast.Not(), left)
            case ((ast.Mult() | ast.LShift()), _) if type_.name == "bits":
                raise ValueError(f"{ast.unparse(node)[:80]}: more than 64 bits")
        if isinstance(node.op, ast.BitAnd | ast.BitOr) and type_ == BOOL == self.scope.of(right):
            kind: Any = ast.And() if isinstance(node.op, ast.BitAnd) else ast.Or()
            match left, node.left:
                case ast.BoolOp(op=op, values=values), ast.BinOp() if type(op) is type(kind):
                    return ast.BoolOp(kind, [*values, right])
            return ast.BoolOp(kind, [left, right])
        return ast.BinOp(left, node.op, right)


def _same(one: ast.expr, other: ast.expr) -> bool:
    return ast.unparse(one) == ast.unparse(other)
