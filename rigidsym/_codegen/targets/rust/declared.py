"""Routines for Rust, in which every statement that declares a name is marked.

A local name that equals that of a named number is changed: in a pattern, Rust would take it for
the number.
"""

import ast
from collections.abc import Iterator, Sequence
from copy import copy
from dataclasses import replace

from rigidsym._codegen.routines import (
    Program,
    Routine,
    Scope,
    Type,
    copied,
    declaration,
    parts,
)

LET = "let"


def declared(program: Program) -> Program:
    """Mark results of calls that are new names, and declare those among others before."""
    routines = {}
    for name, one in program.routines.items():
        own = _renamed(one, program)
        routines[name] = replace(own, body=tuple(_block(own.body, Scope(own, program))))
    return replace(program, routines=routines)


def _renamed(one: Routine, program: Program) -> Routine:
    """Give the names of a routine that are those of numbers, too, an end of their own."""
    stored = (x.id for x in parts(one.body) if isinstance(x, ast.Name) and type(x.ctx) is ast.Store)
    taken = {*stored, *one.parameters} & program.numbers.keys()
    if not taken:
        return one
    body = tuple(map(copied, one.body))
    for node in parts(body):
        if isinstance(node, ast.Name) and node.id in taken:
            node.id += "_"
    given = {f"{x}_" if x in taken else x: type_ for x, type_ in one.parameters.items()}
    return replace(one, body=body, parameters=given)


def _block(body: Sequence[ast.stmt], scope: Scope) -> list[ast.stmt]:
    outside, found = dict(scope.types), []
    for statement in body:
        known = set(scope.types)
        scope.declare(statement)
        found += map(ast.fix_missing_locations, _changed(statement, scope, known))
    scope.types = outside
    return found


def _changed(node: ast.stmt, scope: Scope, known: set[str]) -> Iterator[ast.stmt]:
    node = copy(node)
    match node:
        case ast.If():
            node.body, node.orelse = _block(node.body, scope), _block(node.orelse, scope)
        case ast.For():
            node.body = _block(node.body, scope)
        case ast.Assign(targets=[ast.Tuple(elts=targets)]):
            names = [x.id for x in targets if isinstance(x, ast.Name) and x.id not in known]
            if len(names) == len(targets):
                node.type_comment = LET
            else:
                yield from (declaration(name, scope.types[name].name, None) for name in names)
    yield node


def is_zero_at_first(type_: Type) -> bool:
    """Return True for what is declared as zero, and not only before it is set."""
    return bool(type_.shape) or type_.is_object
