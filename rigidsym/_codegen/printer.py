"""Printer of routines in languages with the operators of C, by tables of the node classes of `ast`.

A target's printer is a subclass that says how the language declares, assigns, passes on and calls.
"""

import ast
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from textwrap import wrap
from typing import Any, ClassVar

from rigidsym._codegen.ir import Let
from rigidsym._codegen.lines import Lines, comment
from rigidsym._codegen.routines import Program, Routine, Scope, Type, let_of, parts

ATOM, UNARY, COMPARED, AND, OR, CHOICE = 12, 11, 7, 2, 1, 0
WIDTH = 100
COMPARISONS: dict[type, str] = {
    **{ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="},
    **{ast.Is: "==", ast.IsNot: "!="},
}
OPERATIONS: dict[type, tuple[str, int]] = {
    **{ast.Mult: ("*", 10), ast.Div: ("/", 10), ast.FloorDiv: ("/", 10), ast.Mod: ("%", 10)},
    **{ast.Add: ("+", 9), ast.Sub: ("-", 9), ast.LShift: ("<<", 8), ast.RShift: (">>", 8)},
    **{ast.BitAnd: ("&", 5), ast.BitXor: ("^", 4), ast.BitOr: ("|", 3)},
}
SIGNS: dict[type, str] = {ast.USub: "-", ast.Not: "!", ast.Invert: "~"}


class Printer(ABC):
    """Abstract printer of a program's routines.

    names: what names that the program knows are called in the language.
    """

    calls: ClassVar[Mapping[str, str]] = {}
    comparisons: ClassVar[Mapping[type, str]] = COMPARISONS
    none: ClassVar[str] = "NULL"
    # How a condition is written after `if`.
    condition: ClassVar[str] = "({})"
    # What is between the head of a routine and its first line.
    opening: ClassVar[str] = "\n{"

    def __init__(self, program: Program, names: Mapping[str, str]) -> None:
        self.program, self.names = program, names
        self._statements: dict[type, Callable[[Any], Iterator[Any]]] = {
            ast.AnnAssign: self._declaration,
            ast.Assign: self._assignment,
            ast.AugAssign: self._change,
            ast.Expr: self._call_alone,
            ast.If: self._if,
            ast.For: self._for,
            ast.Return: self._return,
            ast.Break: lambda _: iter(["break;"]),
            ast.Continue: lambda _: iter(["continue;"]),
            ast.Pass: lambda _: iter(()),
        }
        self._expressions: dict[type, Callable[[Any], tuple[str, int]]] = {
            ast.Constant: self._constant,
            ast.Name: self._name,
            ast.Attribute: self._attribute,
            ast.Subscript: self._subscript,
            ast.BinOp: self._operation,
            ast.UnaryOp: self._unary,
            ast.BoolOp: self._logical,
            ast.Compare: self._comparison,
            ast.IfExp: self._choice,
            ast.Call: self._call,
            ast.Tuple: self._several,
            ast.List: self._several,
            ast.Dict: self._members,
        }
        self.one = Routine("", "", {}, (), ())
        self.scope = Scope(self.one, program)
        self.set_again: set[str] = set()

    # --- what a language says in its own way

    @abstractmethod
    def head(self, one: Routine) -> str:
        """Return the head of a routine, to the closing bracket of its parameters."""

    @abstractmethod
    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        """Print the declaration of a name, with or without a value."""

    @abstractmethod
    def _assignment(self, node: ast.Assign) -> Iterator[str]:
        """Print an assignment to one target, or to several."""

    @abstractmethod
    def _cleared(self, struct: ast.expr) -> str:
        """Print the expression that sets all of a struct to zero."""

    @abstractmethod
    def _loop(self, name: str, first: str, end: ast.expr, step: ast.expr | None) -> str:
        """Return the head of a loop over whole numbers."""

    @abstractmethod
    def _slice(self, array: ast.expr, first: ast.expr) -> tuple[str, int]:
        """Print an array from an element on."""

    def _several(self, node: ast.Tuple | ast.List) -> tuple[str, int]:
        """Print several values together, where the language can."""
        raise ValueError(f"{ast.unparse(node)}: several values are no expression")

    def _members(self, node: ast.Dict) -> tuple[str, int]:
        """Print a struct with its members, where the language can."""
        raise ValueError(f"{ast.unparse(node)}: a struct is no expression")

    @abstractmethod
    def argument(self, node: ast.expr, type_: Type) -> str:
        """Print an argument for a parameter of some type."""

    def function_name(self, name: str) -> str:
        """Return the name of a routine in the language."""
        return name

    # --- routines

    @staticmethod
    def note(text: str) -> Iterator[str]:
        """Print a comment of any length."""
        words = " ".join(text.split())
        yield from wrap(f"/* {words} */", WIDTH, subsequent_indent="   ", break_long_words=False)

    @staticmethod
    def wrapped(begin: str, parts: Sequence[str], end: str) -> str:
        """Write a list over as many lines as it takes."""
        whole = f"{begin}{', '.join(parts)}{end}"
        if len(whole) <= WIDTH:
            return whole
        rows = [begin]
        for k, part in enumerate(parts):
            piece = part + (end if k + 1 == len(parts) else ",")
            if rows[-1].endswith("(") or len(rows[-1]) + 1 + len(piece) <= WIDTH:
                rows[-1] += piece if rows[-1].endswith("(") else f" {piece}"
            else:
                rows.append(f"    {piece}")
        return "\n".join(rows)

    def notes(self, one: Routine) -> Sequence[str]:
        """Return the comment above a routine."""
        return list(self.note(one.summary))

    def routine(self, one: Routine) -> Lines:
        """Print a routine after its comment, with the derived assignments behind its lines."""
        self.one = one
        head, notes = self.head(one), self.notes(one)
        self.scope = Scope(one, self.program)
        self.set_again = set_again(one, self.program)
        text, lets = [*notes, *f"{head}{self.opening}".split("\n")], {}
        for line, let in self._block(one.body, "    "):
            if let is not None:
                lets[len(text)] = let
            text.append(line)
        return Lines((*text, "}", ""), lets)

    # --- statements

    def _block(self, body: Sequence[ast.stmt], indent: str) -> Iterator[tuple[str, Let | None]]:
        """Print statements, with the derived assignment behind each line."""
        for statement in body:
            self.scope.declare(statement)
            let = let_of(statement)
            if words := getattr(statement, "note", ""):
                yield from ((f"{indent}{line}", None) for line in self.note(words))
            if isinstance(statement, ast.If | ast.For):
                yield from self._compound(statement, indent)
                continue
            lines = list(self._statements[type(statement)](statement))
            for line in lines[:-1]:
                yield f"{indent}{line}", None
            if lines:
                note = f" /* {comment(let)} */" if let is not None else ""
                yield f"{indent}{lines[-1]}{note}", let

    def _compound(self, statement: ast.stmt, indent: str) -> Iterator[tuple[str, Let | None]]:
        for part in self._statements[type(statement)](statement):
            if isinstance(part, str):
                yield f"{indent}{part}", None
            else:
                outside = dict(self.scope.types)
                yield from self._block(part, f"{indent}    ")
                self.scope.types = outside

    def _change(self, node: ast.AugAssign) -> Iterator[str]:
        symbol = OPERATIONS[type(node.op)][0]
        yield f"{self.text(node.target)} {symbol}= {self.text(node.value)};"

    def _call_alone(self, node: ast.Expr) -> Iterator[str]:
        match node.value:
            case ast.Call(func=ast.Name(id="cleared"), args=[struct]):
                yield f"{self._cleared(struct)};"
            case ast.Call() as call:
                yield f"{self._called(call)};"

    def _if(self, node: ast.If) -> Iterator[str | list[ast.stmt]]:
        yield f"if {self.condition.format(self.text(node.test))} {{"
        yield node.body
        rest = node.orelse
        while len(rest) == 1 and isinstance(rest[0], ast.If):
            yield f"}} else if {self.condition.format(self.text(rest[0].test))} {{"
            yield rest[0].body
            rest = rest[0].orelse
        if rest:
            yield "} else {"
            yield rest
        yield "}"

    def _for(self, node: ast.For) -> Iterator[str | list[ast.stmt]]:
        begin, end, step = _range(node)
        first = "0" if begin is None else self.text(begin)
        yield f"{self._loop(ast.unparse(node.target), first, end, step)} {{"
        yield node.body
        yield "}"

    def _return(self, node: ast.Return) -> Iterator[str]:
        yield "return;" if node.value is None else f"return {self.text(node.value)};"

    # --- expressions

    def text(self, node: ast.expr, least: int = 0) -> str:
        """Print an expression, in brackets where it binds less than `least`."""
        found, bound = self._expressions[type(node)](node)
        return found if bound >= least else f"({found})"

    def _constant(self, node: ast.Constant) -> tuple[str, int]:
        value = node.value
        if isinstance(value, bool):
            return self.truth(value), ATOM
        if isinstance(value, str):
            return '"' + value.replace('"', '\\"') + '"', ATOM
        if isinstance(value, int | float):
            return self.literal(value), ATOM if value >= 0 else UNARY
        return self.none, ATOM

    @staticmethod
    def truth(value: bool) -> str:
        """Print True or False."""
        return "true" if value else "false"

    @staticmethod
    def literal(value: float) -> str:
        """Print a number."""
        is_whole = isinstance(value, float) and value.is_integer() and abs(value) < 1e17
        return f"{int(value)}.0" if is_whole else repr(value)

    @staticmethod
    def bits(value: int) -> str:
        """Print a constant of 64 bits."""
        return f"{value:#x}"

    def _name(self, node: ast.Name) -> tuple[str, int]:
        return self.names.get(node.id, node.id), ATOM

    def _attribute(self, node: ast.Attribute) -> tuple[str, int]:
        return f"{self.text(node.value, ATOM)}.{node.attr}", ATOM

    def _subscript(self, node: ast.Subscript) -> tuple[str, int]:
        match node.slice:
            case ast.Slice(lower=None):
                return self._expressions[type(node.value)](node.value)
            case ast.Slice(lower=ast.expr() as lower):
                return self._slice(node.value, lower)
            case ast.Tuple(elts=parts):
                places = "".join(f"[{self.text(part)}]" for part in parts)
            case part:
                places = f"[{self.text(part)}]"
        return f"{self.text(node.value, ATOM)}{places}", ATOM

    def _operation(self, node: ast.BinOp) -> tuple[str, int]:
        symbol, bound = OPERATIONS[type(node.op)]
        of_bits = bound < 9
        # Compilers, and readers, ask for brackets around what stands among operations on bits.
        left = self._operand(node.left, node.right, UNARY if of_bits else bound)
        if isinstance(node.op, ast.LShift | ast.RShift):
            right = self._places(node.right)
        else:
            right = self._operand(node.right, node.left, UNARY if of_bits else bound + 1)
        return f"{left} {symbol} {right}", bound

    def _operand(self, node: ast.expr, other: ast.expr, least: int) -> str:
        match node:
            case ast.Constant(value=int(value)) if self.scope.of(other).name == "bits":
                return self.bits(value)
        return self.text(node, least)

    def _places(self, node: ast.expr) -> str:
        """Print by how many places bits are shifted."""
        return self.text(node, UNARY)

    def _unary(self, node: ast.UnaryOp) -> tuple[str, int]:
        symbol = SIGNS[type(node.op)]
        text = self.text(node.operand, UNARY)
        return f"{symbol}({text})" if text.startswith(symbol) else f"{symbol}{text}", UNARY

    def _logical(self, node: ast.BoolOp) -> tuple[str, int]:
        symbol, bound = ("&&", AND) if isinstance(node.op, ast.And) else ("||", OR)
        return f" {symbol} ".join(self.text(part, AND + 1) for part in node.values), bound

    def _comparison(self, node: ast.Compare) -> tuple[str, int]:
        (right,), (operator,) = node.comparators, node.ops
        symbol = self.comparisons[type(operator)]
        left = self.text(node.left, COMPARED + 1)
        return f"{left} {symbol} {self.text(right, COMPARED + 1)}", COMPARED

    def _choice(self, node: ast.IfExp) -> tuple[str, int]:
        test, one = self.text(node.test, CHOICE + 1), self.text(node.body, CHOICE + 1)
        return f"{test} ? {one} : {self.text(node.orelse, CHOICE + 1)}", CHOICE

    def _call(self, node: ast.Call) -> tuple[str, int]:
        return self._called(node), ATOM

    def _called(self, node: ast.Call) -> str:
        if not isinstance(node.func, ast.Name):
            given = [self.argument(one, self.scope.of(one)) for one in node.args]
            return f"{self.text(node.func)}({', '.join(given)})"
        name = node.func.id
        if name in self.program.routines:
            types = self.program.routines[name].parameters.values()
            given = [self.argument(*both) for both in zip(node.args, types, strict=True)]
            return f"{self.function_name(name)}({', '.join(given)})"
        given = [self.text(one) for one in node.args]
        return f"{self.calls.get(name, name)}({', '.join(given)})"


def _range(node: ast.For) -> tuple[ast.expr | None, ast.expr, ast.expr | None]:
    """Return begin, end and step of a loop; begin and step are None where they are not given."""
    match node.iter:
        case ast.Call(func=ast.Name(id="range"), args=[end]):
            return None, end, None
        case ast.Call(func=ast.Name(id="range"), args=[begin, end]):
            return begin, end, None
        case ast.Call(func=ast.Name(id="range"), args=[begin, end, step]):
            return begin, end, step
    raise ValueError(f"{ast.unparse(node.iter)}: a loop is over a range")


def set_again(one: Routine, program: Program) -> set[str]:
    """Return the names that are set after their declaration."""
    targets: list[ast.expr] = []
    for node in parts(one.body):
        match node:
            case ast.Assign(targets=[ast.Tuple(elts=places)]):
                targets += places
            case ast.Assign(targets=[target]) | ast.AugAssign(target=target):
                targets.append(target)
            case ast.Call(func=ast.Name(id=name), args=given) if name in program.routines:
                types = program.routines[name].parameters.values()
                targets += (x for x, type_ in zip(given, types, strict=True) if type_.is_result)
    found: set[str] = set()
    for target in targets:
        while isinstance(target, ast.Subscript | ast.Attribute):
            target = target.value
        found |= {target.id} if isinstance(target, ast.Name) else set()
    return found
