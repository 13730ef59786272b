"""Routines for C, where a function with several results writes them through pointers.

A routine of the interface returns its first result; pairs are set part by part.
"""

import ast
from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import replace

from rigidsym._codegen.routines import Program, Routine, Type, annotation


def with_pointers(program: Program) -> Program:
    """Replace results that are tuples by parameters that are written to."""
    changed = {name: _head(one) for name, one in program.routines.items()}
    return replace(
        program,
        routines={
            name: replace(changed[name], body=tuple(_Body(one, program).statements()))
            for name, one in program.routines.items()
        },
    )


def _outputs(one: Routine) -> list[tuple[str, Type]]:
    """Return the parameters through which a routine writes results."""
    if len(one.results) < 2:
        return []
    names = one.names or _returned(one)
    kinds = [replace(type_, is_out=True) for type_ in one.results]
    if one.is_public:
        return list(zip(names, kinds, strict=True))[1:]
    return [(f"{name}_out", type_) for name, type_ in zip(names, kinds, strict=True)]


def _returned(one: Routine) -> tuple[str, ...]:
    """Return names for the values of a routine: those that it returns, or numbers."""
    names = [f"result_{k}" for k in range(1, len(one.results) + 1)]
    for statement in one.statements():
        match statement:
            case ast.Return(value=ast.Tuple(elts=parts)):
                for k, part in enumerate(parts):
                    if isinstance(part, ast.Name) and part.id not in names:
                        names[k] = part.id
    return tuple(names)


def _head(one: Routine) -> Routine:
    outputs = _outputs(one)
    if not outputs:
        return one
    results = one.results[:1] if one.is_public else ()
    return replace(one, parameters={**one.parameters, **dict(outputs)}, results=results)


class _Body:
    """Statements of a routine, changed to those of C."""

    def __init__(self, one: Routine, program: Program) -> None:
        self.one, self.program = one, program
        self.outputs = _outputs(one)
        # Local names that equal that of a result, which is a pointer now: they are renamed.
        self.taken = {name for name, _ in self.outputs}

    def statements(self) -> list[ast.stmt]:
        """Return all statements."""
        found = list(self._block(self.one.body, set()))
        match found[-1:]:
            case [ast.Return(value=None)]:
                found.pop()
        if self.taken:
            found = [_Apart(self.taken).visit(part) for part in found]
        return found

    def _block(self, body: Sequence[ast.stmt], known: set[str]) -> Iterator[ast.stmt]:
        known = set(known)
        for statement in body:
            changed = list(self._changed(statement, known))
            for name, one in (("note", changed[0]), ("let", changed[-1])):
                if value := getattr(statement, name, None):
                    setattr(one, name, value)
            yield from changed

    def _changed(self, node: ast.stmt, known: set[str]) -> Iterator[ast.stmt]:
        match node:
            case ast.AnnAssign(target=ast.Name(id=name)):
                known.add(name)
                yield node
            case ast.If() | ast.For():
                whole = copy(node)
                whole.body = list(self._block(node.body, known))
                whole.orelse = list(self._block(node.orelse, known))
                yield whole
            case ast.Return(value=ast.Tuple(elts=parts)):
                own = parts[1:] if self.one.is_public else parts
                for part, (name, _) in zip(own, self.outputs, strict=True):
                    yield from _set(ast.Name(f"*{name}", ast.Store()), part)
                yield ast.Return(parts[0] if self.one.is_public else None)
            case ast.Return(value=ast.Call(func=ast.Name(id="pair")) as value):
                yield ast.AnnAssign(ast.Name("result", ast.Store()), annotation("pair"), value, 1)
                yield ast.Return(ast.Name("result", ast.Load()))
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=ast.Call() as call):
                yield from self._call(targets, call, known)
            case ast.Assign(targets=[target], value=value):
                yield from _set(target, value)
            case other:
                yield other

    def _call(self, targets: list[ast.expr], call: ast.Call, known: set[str]) -> Iterator[ast.stmt]:
        called = self.program.routines[ast.unparse(call.func)]
        first = 1 if called.is_public else 0
        for k, (target, type_) in enumerate(zip(targets, called.results, strict=True)):
            if isinstance(target, ast.Name) and target.id not in known and k >= first:
                known.add(target.id)
                yield ast.AnnAssign(target, annotation(type_.name), None, 1)
        whole = ast.Call(call.func, [*call.args, *targets[first:]], [])
        if not called.is_public:
            yield ast.Expr(whole)
        elif isinstance(targets[0], ast.Name) and targets[0].id not in known:
            known.add(targets[0].id)
            yield ast.AnnAssign(targets[0], annotation(called.results[0].name), whole, 1)
        else:
            yield ast.Assign([targets[0]], whole)


def _set(target: ast.expr, value: ast.expr) -> Iterator[ast.stmt]:
    match value:
        case ast.Call(func=ast.Name(id="pair"), args=parts):
            for half, part in zip(("hi", "lo"), parts, strict=True):
                yield ast.Assign([ast.Attribute(target, half, ast.Store())], part)
        case _:
            yield ast.Assign([target], value)


class _Apart(ast.NodeTransformer):
    """Renaming of local names that equal those of pointers."""

    def __init__(self, taken: set[str]) -> None:
        self.taken = taken

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Mark a pointer, and rename what has its name."""
        if node.id.startswith("*"):
            return ast.Name(node.id[1:], node.ctx)
        return ast.Name(f"{node.id}_found", node.ctx) if node.id in self.taken else node
