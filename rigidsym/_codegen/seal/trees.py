"""Modules read back from the syntax trees of languages with the operators of C.

Input: files, and the routines that they print.  Output: the number of derived lines.
"""

import ast
from collections.abc import Callable, Iterator, Mapping
from typing import ClassVar

from tree_sitter import Node

from rigidsym._codegen import header
from rigidsym._codegen.ir import Function
from rigidsym._codegen.lines import Module
from rigidsym._codegen.printer import COMPARISONS, OPERATIONS
from rigidsym._codegen.routines import Routine
from rigidsym._codegen.seal.bodies import Body, check_function, check_outside
from rigidsym.errors import InputError

OPERATED = {text: kind for kind, (text, _) in OPERATIONS.items() if kind is not ast.FloorDiv}
_LOGICAL: dict[str, type[ast.boolop]] = {"&&": ast.And, "||": ast.Or}
_COMMENTS = ("block_comment", "line_comment", "comment")
# Names and bodies of the functions in a text that print routines.
Bodies = Callable[[str, str, Mapping[str, Routine]], Iterator[tuple[str, Node]]]


def check_files(
    files: Mapping[str, str],
    wanted: Module,
    of: str,
    routines: Mapping[str, Routine],
    functions: tuple[Function, ...],
    bodies: Bodies,
    reader: "Callable[[str], Reader]",
) -> int:
    """Check printed files against their routines, and return the number of derived lines.

    wanted: the module as it is printed; its one file with derived lines has the routines.  of: its
    key.  Raises InputError for a statement that differs, and for other text that does.
    """
    if files.keys() != wanted.files.keys():
        raise InputError("files", ", ".join(files), f"are not {', '.join(wanted.files)}")
    (source,), decided = wanted.lets, 0
    digest = header.digest_in(source, files[source])
    texts = {name: header.unsealed(text, of, digest) for name, text in files.items()}
    for name, text in texts.items():
        both = text, header.unsealed(wanted.files[name], of, wanted.digest)
        lines = ([*_outside(bodies(name, x, routines) if name == source else (), x)] for x in both)
        check_outside(name, *lines)
    for name, node in bodies(source, texts[source], routines):
        own = reader(source)
        body = Body(source, texts[source].split("\n"), routines[name], own.plain)
        decided += body.check(list(own.block(node)), routines[name].body)
    for function in functions:
        check_function(function, [one for one in routines.values() if one.prints(function)])
    return decided


def _outside(
    bodies: Iterator[tuple[str, Node]] | tuple[()], text: str
) -> Iterator[tuple[int, str]]:
    """Yield the lines outside the bodies of routines, with their numbers."""
    inside = {
        number
        for _, body in bodies
        for number in range(body.start_point.row + 2, body.end_point.row + 1)
    }
    lines = enumerate(text.split("\n"), 1)
    yield from ((number, line) for number, line in lines if number not in inside)


def text_of(node: Node | None) -> str:
    """Return the text of a node, none for no node."""
    return node.text.decode() if node is not None and node.text is not None else ""


def child(node: Node, name: str) -> Node:
    """Return the child of a node in a field.

    Raises InputError where there is none.
    """
    found = node.child_by_field_name(name)
    if found is None:
        raise InputError("text", text_of(node)[:60], f"has no {name}")
    return found


def parts(node: Node) -> list[Node]:
    """Return the named children of a node without comments."""
    return [one for one in node.named_children if one.type not in _COMMENTS]


def call(name: str, *given: ast.expr) -> ast.Call:
    """Return a call of a function by its name."""
    return ast.Call(ast.Name(name, ast.Load()), list(given), [])


class Reader:
    """Reader of the bodies of functions; what is not in its tables is refused.

    A subclass adds the nodes of its language to the tables of statements and expressions.
    compared: the comparisons by their symbols.
    """

    compared: ClassVar[Mapping[str, type]] = {
        text: kind for kind, text in COMPARISONS.items() if kind not in (ast.Is, ast.IsNot)
    }

    def __init__(self, file: str) -> None:
        self.file = file
        self.statements: dict[str, Callable[[Node], ast.stmt]] = {}
        self.expressions: dict[str, Callable[[Node], ast.expr]] = {
            "binary_expression": self._operation,
            "parenthesized_expression": lambda node: self.read(*parts(node)),
        }

    def plain(self, node: ast.AST) -> ast.AST:
        """Return a tree that is equal where the language says the same."""
        return node

    def refusal(self, node: Node) -> InputError:
        """Return the error for a node that no routine has."""
        place = f"{self.file}:{node.start_point.row + 1}"
        return InputError(place, text_of(node)[:80], f"is nothing that a routine has ({node.type})")

    def block(self, node: Node) -> Iterator[ast.stmt]:
        """Read the statements of a block; each knows its line."""
        if node.type not in ("block", "statement_block"):
            raise self.refusal(node)
        for one in parts(node):
            inner = parts(one)[0] if one.type == "expression_statement" else one
            if inner.type not in self.statements:
                raise self.refusal(one)
            statement = self.statements[inner.type](inner)
            statement.lineno = one.start_point.row + 1
            yield statement

    def read(self, node: Node) -> ast.expr:
        """Read an expression."""
        if node.type not in self.expressions:
            raise self.refusal(node)
        return self.expressions[node.type](node)

    def several(self, node: Node) -> ast.expr:
        """Read values that stand together."""
        return ast.Tuple([*map(self.read, parts(node))], ast.Load())

    def choice_of_blocks(self, node: Node) -> ast.If:
        """Read an `if` with all its branches."""
        test = self.read(child(node, "condition"))
        then, rest = list(self.block(child(node, "consequence"))), []
        if other := node.child_by_field_name("alternative"):
            (inner,) = parts(other)
            if inner.type == node.type:
                rest = [self.choice_of_blocks(inner)]
                rest[0].lineno = inner.start_point.row + 1
            else:
                rest = list(self.block(inner))
        return ast.If(test, then, rest)

    def assignment(self, node: Node) -> ast.stmt:
        """Read an assignment to a place."""
        value = self.read(child(node, "right"))
        return ast.Assign([self.read(child(node, "left"))], value, lineno=1)

    def change(self, node: Node) -> ast.stmt:
        """Read an assignment that is an operation, too."""
        target, symbol = self.read(child(node, "left")), text_of(child(node, "operator"))
        kind = OPERATED.get(symbol.removesuffix("="))
        if kind is None or not isinstance(target, ast.Name | ast.Attribute | ast.Subscript):
            raise self.refusal(node)
        return ast.AugAssign(target, kind(), self.read(child(node, "right")))

    def _operation(self, node: Node) -> ast.expr:
        left, right = child(node, "left"), child(node, "right")
        symbol, one, other = text_of(child(node, "operator")), self.read(left), self.read(right)
        if symbol in _LOGICAL:
            kind = _LOGICAL[symbol]
            match one:
                case ast.BoolOp(op=op, values=values) if type(op) is kind and (
                    left.type == "binary_expression"
                ):
                    return ast.BoolOp(op, [*values, other])
            return ast.BoolOp(kind(), [one, other])
        if symbol in self.compared:
            is_none = isinstance(other, ast.Constant) and other.value is None
            kinds = {ast.Eq: ast.Is, ast.NotEq: ast.IsNot} if is_none else {}
            found = self.compared[symbol]
            return ast.Compare(one, [kinds.get(found, found)()], [other])
        if symbol not in OPERATED:
            raise self.refusal(node)
        return ast.BinOp(one, OPERATED[symbol](), other)
