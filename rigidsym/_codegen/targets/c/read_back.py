"""Check of the printed C module: it is read back, and compared with its routines.

What stands outside the bodies of functions is compared word for word, bodies statement by
statement; a derived statement is the one of its assignment in the representation.
"""

import ast
import re
from collections.abc import Mapping, Sequence

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.routines import NUMBERS, Program, Routine
from rigidsym._codegen.seal.bodies import Body, check_function, check_outside
from rigidsym._codegen.targets.c import module, reader
from rigidsym._codegen.targets.c.printer import Printer
from rigidsym._codegen.targets.c.program import program
from rigidsym.errors import InputError


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
    seen: set[str] = set()
    numbers: set[str] = set()
    for file, (plain, expected) in texts.items():
        root, wanted = map(reader.parsed, (plain, expected))
        found = {name: node for name, node in reader.functions(file, root) if name in names}
        notes = {name: reader.comments(node) for name, node in reader.functions(file, wanted)}
        read = reader.numbers(root)
        check_numbers(file, read, printer.program, constants)
        numbers |= read.keys()
        check_structs(file, reader.structs(root), printer)
        check_outside(
            file,
            *(reader.without_bodies(file, text, names.keys()) for text in (plain, expected)),
        )
        for name, node in found.items():
            one = routines[names[name]]
            check_head(file, one, *reader.head(node))
            body = Body(file, plain.split("\n"), one)
            decided += body.check(reader.Reader(file, one, printer).body(node), one.body)
            if reader.comments(node) != notes.get(name):
                raise InputError(file, name, "has other comments")
        seen |= found.keys()
    for what, missing in (
        ("functions", names.keys() - seen),
        ("numbers", printer.program.numbers.keys() - numbers),
    ):
        if missing:
            raise InputError(what, ", ".join(sorted(missing)), "are not there")
    for function in functions:
        check_function(function, [one for one in routines.values() if one.prints(function)])
    return decided


def _plain(file: str, text: str, form: str) -> str:
    """Replace a form's prefix of names by the default; raise InputError for another form's."""
    found = module.plain(text, form)
    own_names = module.named(found, form).split("\n")
    for number, (line, own) in enumerate(zip(text.split("\n"), own_names, strict=True), 1):
        if line != own:
            raise InputError(f"{file}:{number}", line.strip(), "has another form's name")
    return found


def check_numbers(
    file: str, read: Mapping[str, str], of: Program, constants: tuple[Constant, ...]
) -> None:
    """Raise InputError for a named number with another value than it has.

    Those of the derivation are compared with the derivation's own.
    """
    known = {constant.name: constant for constant in constants}
    codes = {
        of.names.get(x.name, x.name): _initial(x.value)
        for one in of.enumerations.values()
        for x in one.numbers
    }
    for name, value in read.items():
        if name in known:
            hi, lo = known[name].hi, known[name].lo
            wanted = repr(hi) if lo is None else f"{{{hi!r}, {lo!r}}}"
        elif name in of.numbers:
            wanted = _initial(of.numbers[name].value)
        elif name in codes:
            wanted = codes[name]
        else:
            raise InputError(file, name, "is no number of this module")
        if value != wanted:
            raise InputError(file, f"{name} = {value[:80]}", f"is not {wanted[:80]}")


def _initial(node: ast.expr) -> str:
    """Return a value as C's initialisers have it."""
    match node:
        case ast.List(elts=parts) | ast.Call(func=ast.Name(id="pair"), args=parts):
            return f"{{{', '.join(map(_initial, parts))}}}"
        case ast.IfExp(test=test, body=one, orelse=other):
            return f"{ast.unparse(test)} ? {_initial(one)} : {_initial(other)}"
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
        kinds = {kind for kind, _ in wanted}
        pointers = {x.name for x in known[name].fields if x.type.shape == ("...",)}
        members = [x for x in read[name] if x[0] in kinds and x[1].strip("*") not in pointers]
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
