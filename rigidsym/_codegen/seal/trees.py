"""Modules read back from the syntax trees of languages with the operators of C.

Input: files, and the routines that they print.  Output: the number of derived lines.
"""

import ast
from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import ClassVar

from tree_sitter import Language, Node, Parser

from rigidsym._codegen import header
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.lines import Module
from rigidsym._codegen.printer import COMPARISONS, OPERATIONS
from rigidsym._codegen.routines import Program, is_same, numbered
from rigidsym._codegen.routines import parts as nodes
from rigidsym._codegen.seal.bodies import Body, check_function, check_outside
from rigidsym._codegen.seal.equality import DIFFERS
from rigidsym.errors import InputError

OPERATED = {text: kind for kind, (text, _) in OPERATIONS.items() if kind is not ast.FloorDiv}
_LOGICAL: dict[str, type[ast.boolop]] = {"&&": ast.And, "||": ast.Or}
_BLOCKS = ("block", "statement_block", "compound_statement")
_COMMENTS = ("block_comment", "line_comment", "comment")
# The head of a function, a struct or a number, as words and trees.
Definition = Sequence[str | ast.AST]


def check_files(
    files: Mapping[str, str],
    wanted: Module,
    of: str,
    made: Program,
    given: tuple[tuple[Function, ...], tuple[Constant, ...]],
    reader: "type[Reader]",
) -> int:
    """Check printed files against their program, and return the number of derived lines.

    wanted: the module as it is printed; its one file with derived lines has the program.  of: its
    key.  given: the functions and constants that it is of.  Raises InputError for a statement or a
    definition that differs, and for other text that does.
    """
    functions, constants = given
    if files.keys() != wanted.files.keys():
        raise InputError("files", ", ".join(files), f"are not {', '.join(wanted.files)}")
    (source,), decided = wanted.lets, 0
    digest = header.digest_in(source, files[source])
    texts = {name: header.unsealed(text, of, digest) for name, text in files.items()}
    for name, text in texts.items():
        both = text, header.unsealed(wanted.files[name], of, wanted.digest)
        known = made.routines if name == source else {}
        check_outside(name, *([*_outside(reader.bodies(name, x, known), x)] for x in both))
    own, lines = reader(source), texts[source].split("\n")
    check_definitions(own, texts[source], made, constants)
    for name, node in own.bodies(source, texts[source], made.routines):
        body = Body(source, lines, made.routines[name], own.plain)
        decided += body.check(list(own.block(node)), made.routines[name].body)
    for function in functions:
        check_function(function, [x for x in made.routines.values() if x.prints(function)])
    return decided


def check_definitions(
    reader: "Reader", text: str, made: Program, constants: tuple[Constant, ...]
) -> None:
    """Compare heads of functions, structs and numbers of a text with those of its program.

    Numbers of the derivation are compared with the derivation's own.  Raises InputError for the
    first definition that differs, stands there twice, or is missing.
    """
    numbers = {x.name: numbered(x) for x in constants if x.name in made.numbers}
    wanted = dict(reader.wanted(replace(made, numbers=made.numbers | numbers)))
    missing = {*wanted}
    for name, line, read in reader.definitions(text, wanted):
        both = [[_plain(x, reader) for x in one] for one in (read, wanted[name])]
        if name not in missing or not is_same(*both):
            found = ", ".join(x if isinstance(x, str) else ast.unparse(x) for x in read)
            raise InputError(f"{reader.file}:{line}", f"{name}: {found}"[:120], DIFFERS)
        missing.remove(name)
    if missing:
        raise InputError(reader.file, ", ".join(sorted(missing))[:200], "is not there")


def _plain(part: str | ast.AST, reader: "Reader") -> str | ast.AST:
    """Return a part of a definition as the language says it."""
    if isinstance(part, str):
        return part
    # A negative constant is read as an operation.
    part = ast.parse(ast.unparse(part), mode="eval").body
    for node in nodes([part]):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            for word, other in reader.words.items():
                node.value = node.value.replace(word, other)
    return reader.plain(part)


def _outside(bodies: Iterator[tuple[str, Node]], text: str) -> Iterator[tuple[int, str]]:
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


class BodyReader:
    """Reader of the bodies of functions, which refuses what is not in its tables.

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
        if node.type not in _BLOCKS:
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


@cache
def _parser(reader: "type[Reader]") -> Parser:
    return Parser(Language(reader.grammar()))


class Reader(BodyReader, ABC):
    """Abstract reader of functions, structs and numbers.

    language: its name.  grammar: that of tree-sitter.  function: the node of a function.  words:
    replacements in texts.
    """

    language: ClassVar[str]
    grammar: ClassVar[Callable[[], object]]
    function: ClassVar[str]
    words: ClassVar[Mapping[str, str]]

    @abstractmethod
    def wanted(self, made: Program) -> Iterator[tuple[str, Definition]]:
        """Yield the names of a program's functions, structs and numbers with their definitions."""

    @abstractmethod
    def defined(self, node: Node, name: str) -> Definition:
        """Read the definition of a name."""

    @classmethod
    def name_of(cls, node: Node) -> str:
        """Return the name that a node defines, if any."""
        return text_of(node.child_by_field_name("name"))

    @classmethod
    def items(cls, text: str) -> Iterator[Node]:
        """Parse a text, and yield its definitions without the word that exports them."""
        for node in _parser(cls).parse(text.encode()).root_node.named_children:
            yield node.named_children[0] if node.type == "export_statement" else node

    @classmethod
    def bodies(cls, file: str, text: str, names: Collection[str]) -> Iterator[tuple[str, Node]]:
        """Yield the names and bodies of the functions that print routines."""
        for node in cls.items(text) if names else ():
            name = cls.name_of(node)
            if node.type == cls.function and name in names:
                if node.has_error:
                    place = f"{file}:{node.start_point.row + 1}"
                    raise InputError(place, name, f"is no {cls.language}")
                yield name, child(node, "body")

    def definitions(
        self, text: str, names: Collection[str]
    ) -> Iterator[tuple[str, int, Definition]]:
        """Yield the definitions of names in a text, with the numbers of their lines."""
        for node in self.items(text):
            if (name := self.name_of(node)) in names:
                yield name, node.start_point.row + 1, self.defined(node, name)
