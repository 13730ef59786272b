"""Check of the printed C module: it is read back, and compared with its routines.

What stands outside the bodies of functions is compared word for word, bodies statement by
statement; a derived statement is the one of its assignment in the representation.
"""

import ast
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function, Let, is_extended
from rigidsym._codegen.lines import comment
from rigidsym._codegen.passes import fuse, unfused
from rigidsym._codegen.routines import (
    KINDS,
    NUMBERS,
    Program,
    Routine,
    copied,
    is_same,
    let_of,
    syntax,
)
from rigidsym._codegen.seal.equality import DIFFERS, is_equal
from rigidsym._codegen.targets.c import module, reader
from rigidsym._codegen.targets.c.printer import Printer
from rigidsym._codegen.targets.c.program import program
from rigidsym.errors import InputError
from rigidsym.language._expression import Call, Expression, children, rebuild

_SYMBOLS: dict[str, type[ast.operator]] = {
    **{"add": ast.Add, "sub": ast.Sub},
    **{"mul": ast.Mult, "div": ast.Div},
}
_OF_PAIRS = {
    **{"sqrt": "sqrt", "size": "abs", "choose": "choose", "rounded": "rounded"},
    **{"exponent": "exponent", "mantissa": "mantissa"},
}


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed C files against their routines, and return the number of derived lines.

    Raises InputError for a statement that differs, and for other text that does.
    """
    made = program(functions, constants, form)
    wanted, _ = module.printed(made, form)
    check_names(files, wanted)
    texts = {}
    for file, text in files.items():
        plain, expected = text, wanted[file]
        if file != module.ARITHMETIC:
            digest = header.digest_in(file, text)
            plain = header.unsealed(text, key("c", form), digest)
            plain, expected = _plain(file, plain, form), module.plain(expected, form)
        texts[file] = plain, expected
    return compared(texts, module.Files(made, form).printer, functions, constants)


def check_names(files: Mapping[str, str], wanted: Mapping[str, str]) -> None:
    """Raise InputError for other files than wanted."""
    if files.keys() != wanted.keys():
        raise InputError("files", ", ".join(files), f"are not {', '.join(wanted)}")


def compared(
    texts: Mapping[str, tuple[str, str]],
    printer: Printer,
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
) -> int:
    """Compare texts with what they should be, and return the number of derived lines.

    texts: both of each file, with names and words of the default form.  Raises InputError for a
    statement that differs, and for other text that does.
    """
    routines, decided = printer.program.routines, 0
    names = {printer.function_name(one): one for one in routines}
    for file, (plain, expected) in texts.items():
        root = reader.parsed(plain)
        found = dict(reader.functions(file, root))
        check_numbers(file, reader.numbers(root), printer.program, constants)
        check_structs(file, reader.structs(root), printer)
        _check_outside(file, plain, expected)
        for name, node in found.items():
            body = node.child_by_field_name("body")
            if name in names and body is not None:
                one = routines[names[name]]
                check_head(file, one, *reader.head(node))
                extended = one.function.all_extended() if one.function else frozenset()
                reads = reader.Reader(file, one, printer)
                lines = _Lines(file, plain.split("\n"), reads, one, extended)
                decided += lines.check(lines.reader.block(body), one.body)
    for function in functions:
        _check_function(function, [one for one in routines.values() if one.prints(function)])
    return decided


def _plain(file: str, text: str, form: str) -> str:
    """Replace a form's prefix of names by the default; raise InputError for another form's."""
    found = module.plain(text, form)
    own_names = module.named(found, form).split("\n")
    for number, (line, own) in enumerate(zip(text.split("\n"), own_names, strict=True), 1):
        if line != own:
            raise InputError(f"{file}:{number}", line.strip(), "has another form's name")
    return found


def _check_function(function: Function, printed: list[Routine]) -> None:
    """Raise InputError unless the statements of routines are a function's assignments."""
    for one in printed:
        assert one.function is not None
        fused = fuse(one.function)
        if tuple(filter(None, map(let_of, one.statements()))) != fused:
            raise InputError(one.name, function.name, "has other assignments")
        for let, changed in zip(function.lets, fused, strict=True):
            if not is_equal(unfused(changed.expression), let.expression):
                raise InputError(function.name, changed, f"{let}: not what was fused")


def check_numbers(
    file: str, read: Mapping[str, str], of: Program, constants: tuple[Constant, ...]
) -> None:
    """Raise InputError for a named number with another value than it has.

    Those of the derivation are compared with the derivation's own.
    """
    known = {constant.name: constant for constant in constants}
    for name, value in read.items():
        if name in known:
            hi, lo = known[name].hi, known[name].lo
            wanted = repr(hi) if lo is None else f"{{{hi!r}, {lo!r}}}"
        elif name in of.numbers:
            wanted = _initial(of.numbers[name].value)
        else:
            continue
        if value != wanted:
            raise InputError(file, f"{name} = {value[:80]}", f"is not {wanted[:80]}")


def _initial(node: ast.expr) -> str:
    """Return a value as C's initialisers have it."""
    match node:
        case ast.List(elts=parts) | ast.Call(func=ast.Name(id="pair"), args=parts):
            return f"{{{', '.join(map(_initial, parts))}}}"
        case ast.Constant(value=str(text)):
            return '"' + text.replace('"', '\\"') + '"'
    return ast.unparse(node)


def check_structs(
    file: str, read: Mapping[str, Sequence[tuple[str, str]]], printer: Printer
) -> None:
    """Raise InputError for a struct with other members than it has."""
    known = {printer.type_name(name): one for name, one in printer.program.structs.items()}
    for name in read.keys() & known.keys():
        wanted = [
            (printer.type_name(x.type.name), x.name + "".join(f"[{k}]" for k in x.type.shape))
            for x in known[name].fields
            if x.type.name in (*NUMBERS, "pair") and x.type.shape != ("...",)
        ]
        members = [one for one in read[name] if one in wanted]
        if members != wanted:
            raise InputError(file, name, "has other members, or in another order")


def check_head(file: str, one: Routine, kind: str, parameters: Sequence[str]) -> None:
    """Raise InputError for a function with other parameters, or another value, than its routine."""
    wanted = [
        (name, not (x.is_out or x.is_number or (x.name in ("pair", "exact") and not x.shape)))
        for name, x in one.parameters.items()
    ]
    read = [
        (re.split(r"[ *(]", re.sub(r"\)?\[.*", "", text))[-1], text.startswith("const "))
        for text in parameters
    ]
    if read != wanted or (kind == "void") != (not one.results):
        raise InputError(file, f"{one.name}({', '.join(parameters)})"[:120], "has another head")


def _check_outside(file: str, text: str, wanted: str) -> None:
    """Raise InputError for the first line outside the bodies of functions that differs."""
    lines = (reader.without_bodies(file, x) for x in (text, wanted))
    for (number, line), (_, other) in zip_longest(*lines, fillvalue=(0, "the end of the file")):
        if line != other:
            rule = f"is not {other.strip()[:80] or 'an empty line'}"
            raise InputError(f"{file}:{number}", line.strip() or "an empty line", rule)


@dataclass(frozen=True, slots=True)
class _Lines:
    """Lines of a function's body, compared with the statements of its routine."""

    file: str
    text: list[str]
    reader: reader.Reader
    one: Routine
    extended: frozenset[str]

    def check(self, read: Sequence[ast.stmt], wanted: Sequence[ast.stmt]) -> int:
        """Compare statements, and return the number of derived ones.

        Raises InputError for the first that differs.
        """
        decided = 0
        for one, other in zip_longest(read, [x for x in wanted if not isinstance(x, ast.Pass)]):
            place = f"{self.file}:{one.lineno}" if one else f"{self.file}: {self.one.name}"
            if one is None or other is None or type(one) is not type(other):
                raise InputError(place, _said(one), f"is not {_said(other)}")
            if isinstance(one, ast.If | ast.For) and isinstance(other, ast.If | ast.For):
                for name in ("test",) if isinstance(one, ast.If) else ("target", "iter"):
                    self._check_same(place, getattr(one, name), getattr(other, name, None))
                decided += self.check(one.body, other.body)
                decided += self.check(one.orelse, other.orelse)
                continue
            self._check_same(place, one, other)
            if let := let_of(other):
                self._check_derived(place, one, let)
                decided += 1
        return decided

    def _check_same(self, place: str, read: ast.AST, wanted: ast.AST | None) -> None:
        if not is_same(read, wanted):
            raise InputError(place, _said(read), f"is not {_said(wanted)}: {DIFFERS}")

    def _check_derived(self, place: str, read: ast.stmt, let: Let) -> None:
        """Raise InputError unless a statement, and its comment, are those of an assignment."""
        wanted = syntax(_without_rounding(let.expression, self.extended))
        match read:
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                targets: list[ast.expr] = [target]
            case ast.Expr(value=ast.Call(func=called, args=given)):
                count = len(given) - len(let.targets)
                targets, value = given[count:], ast.Call(called, given[:count], [])
            case _:
                raise InputError(place, _said(read), f"sets no name: {let}")
        names = tuple(target.id for target in targets if isinstance(target, ast.Name))
        # The statement was compared as it is before.
        if names != let.targets or not is_same(_Raised().visit(value), wanted):
            raise InputError(place, _said(read), f"{let}: {DIFFERS}")
        _, _, note = self.text[read.lineno - 1].partition("; /* ")
        if note.removesuffix(" */") != comment(let):
            raise InputError(place, f"{let} /* {note}", f"is by {comment(let)}")


def _without_rounding(expression: Expression, extended: frozenset[str]) -> Expression:
    """Drop the rounding of what is a double already."""
    parts = tuple(_without_rounding(part, extended) for part in children(expression))
    match rebuild(expression, parts):
        case Call("rounded", (part,)) if not is_extended(part, extended):
            return part
        case other:
            return other


class _Raised(ast.NodeTransformer):
    """Operations in place of calls of the functions for extended numbers."""

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Replace a call whose name begins with that of a kind of numbers."""
        self.generic_visit(node)
        kind, _, verb = ast.unparse(node.func).partition("_")
        operation, _, _ = verb.partition("_")
        if kind not in KINDS:
            return node
        if operation in _SYMBOLS:
            left, right = node.args
            return ast.BinOp(left, _SYMBOLS[operation](), right)
        if verb == "of":
            return node.args[0]
        if verb == "neg":
            return ast.UnaryOp(ast.USub(), node.args[0])
        return ast.Call(ast.Name(_OF_PAIRS[verb], ast.Load()), node.args, [])


def _said(node: ast.AST | None) -> str:
    """Return the text of a statement or an expression, in one line."""
    if node is None:
        return "the end"
    return " ".join(ast.unparse(ast.fix_missing_locations(copied(node))).split())[:160]
