"""Check of the printed C code of the profile: its functions read back as their routines."""

import re
from collections.abc import Mapping
from dataclasses import replace

from tree_sitter import Node

from rigidsym._codegen.flight.module import SOURCE, Code
from rigidsym._codegen.flight.printer import FlightPrinter, preconditions
from rigidsym._codegen.flight.program import PREFIX, names
from rigidsym._codegen.functions import constants
from rigidsym._codegen.routines import Routine
from rigidsym._codegen.seal.bodies import Body
from rigidsym._codegen.targets.c import read_back, reader
from rigidsym.errors import InputError

# Differences of the profile from the C target: patterns, and their replacements.
_OTHERWISE = (
    (r"\(void\)(memcpy|memset)\(", r"\1("),
    (r"\b(0x[0-9a-f]+)ULL\b", r"UINT64_C(\1)"),
    (r"\b(\d+)u\b", r"\1"),
    (r"\((?:int|size_t)\)(\d+)", r"\1"),
    (r"(<<|>>) \(uint64_t\)(\w+)", r"\1 \2"),
    (r"\btrue\b", "1"),
    (r"\bfalse\b", "0"),
    (r"\bbool\b", "int"),
    (r"\bsplit_product_error\((?=[^)]*\)[^;{]*;)", "product_error("),
)
_ASSERTION = re.compile(r"^    require\((.*), __LINE__\);$")


def check(code: Code) -> int:
    """Compare the text of the source with its routines, and return the number of these.

    Raises InputError for the first statement that differs.
    """
    text = code.files[SOURCE]
    printer = FlightPrinter(code.program, PREFIX, names())
    root = reader.parsed(plain(text))
    values = {name: value.replace("{ ", "{") for name, value in reader.numbers(root).items()}
    read_back.check_numbers(SOURCE, values, code.program, constants())
    read_back.check_structs(SOURCE, reader.structs(reader.parsed(text)), printer)
    routines = {printer.function_name(name): one for name, one in code.program.routines.items()}
    found = {}
    for name, node in reader.functions(SOURCE, root):
        body = node.child_by_field_name("body")
        if name not in routines or body is None:
            continue
        one = found[name] = routines[name]
        read_back.check_head(SOURCE, one, *reader.head(node))
        head = (node.text or b"")[: body.start_byte - node.start_byte].decode()
        if head.split() != plain(printer.head(one)).split():
            raise InputError(SOURCE, " ".join(head.split()), "has other types")
        check_body(text, node, one, printer)
    if missing := sorted(routines.keys() - found.keys()):
        raise InputError(SOURCE, ", ".join(missing), "are not there")
    return len(found)


def check_body(text: str, node: Node, one: Routine, printer: FlightPrinter) -> None:
    """Compare the statements and assertions of a function with its routine.

    text: what the function stands in.  Raises InputError for the first that differs.
    """
    name, body = printer.function_name(one.name), node.child_by_field_name("body")
    asserted = _assertions(text).get(name, [])
    if asserted != list(preconditions(one)) or body is None:
        raise InputError(SOURCE, name, f"asserts {asserted}")
    read = list(reader.Reader(SOURCE, one, printer).block(body))
    # Names are members of structs here: a derived line is compared as any other.
    Body(SOURCE, text.split("\n"), replace(one, function=None)).check(read, one.body)


def plain(text: str) -> str:
    """Return a text as the C target would say it, without assertions; lines keep their numbers."""
    for pattern, replacement in _OTHERWISE:
        text = re.sub(pattern, replacement, text)
    return "\n".join("" if _ASSERTION.match(line) else line for line in text.split("\n"))


def _assertions(text: str) -> Mapping[str, list[str]]:
    """Map the names of functions to the preconditions that they assert."""
    found: dict[str, list[str]] = {}
    name = ""
    for line in text.split("\n"):
        if head := re.match(r"(?!static const|typedef)\w[\w ]*?[ *](\w+)\(", line):
            name = head[1]
        elif assertion := _ASSERTION.match(line):
            found.setdefault(name, []).append(assertion[1])
    return found
