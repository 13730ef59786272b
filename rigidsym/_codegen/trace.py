"""Tracing of generated lines to their facts and equations, and back.

It uses the maps of the generated modules.
"""

import json
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import NamedTuple

from rigidsym._codegen.lines import Place
from rigidsym.errors import InputError

# What the head of a module says of its lines.
_COUNTS = re.compile(r"Lines of code:(?:\n +\d+ .*)+")


class TraceError(LookupError):
    """Error for a generated line or an equation that cannot be traced."""


class _File(NamedTuple):
    """Generated file, with its lines and the map of its derived lines."""

    name: str
    counts: str
    places: Mapping[int, Place]
    lines: list[str]


def _files() -> Iterator[_File]:
    """Yield the generated files of this installation that have derived lines."""
    home = resources.files("rigidsym.generated")
    for entry in sorted(home.iterdir(), key=lambda entry: entry.name):
        if entry.name.endswith(".map.json"):
            module = json.loads(entry.read_text("utf-8"))
            heads = (
                home.joinpath(name).read_text("utf-8") for name in module["manifest"]["sha256"]
            )
            counts = next(found[0] for head in heads if (found := _COUNTS.search(head)))
            for name, places in module["lines"].items():
                lines = home.joinpath(name).read_text("utf-8").splitlines()
                by_line = {place["line"]: place for place in places}
                yield _File(name, counts, by_line, lines)


def told(place: str) -> list[str]:
    """Describe a generated line, or tell how many lines of each kind its module has.

    place: FILE:LINE or FILE.  A line is described by its code, kind, facts, definitions, readings,
    choices of signs, and equations.  Raises TraceError where nothing is derived.
    """
    file, colon, number = place.rpartition(":")
    if colon and not (file and number.isdecimal()):
        raise InputError("trace", place, "must be FILE:LINE or FILE")
    known = {file.name: file for file in _files()}
    path = Path(file if colon else place).as_posix()
    name = next((name for name in known if f"/{path}".endswith(f"/{name}")), None)
    if name is None:
        raise TraceError(f"{path} is no generated file: these are {', '.join(known)}")
    if colon:
        return _of_line(known[name], int(number))
    return known[name].counts.splitlines()


def _of_line(file: _File, line: int) -> list[str]:
    if not 1 <= line <= len(file.lines):
        raise TraceError(f"{file.name} has lines 1 to {len(file.lines)}, no line {line}")
    code = _code(file.lines[line - 1])
    if line not in file.places:
        raise TraceError(f"{file.name}:{line} is derived from nothing: {code or 'an empty line'}")
    found = file.places[line]
    equations = [f"({e})" if e[0].isdigit() else e for e in found["equations"]]
    said = {"facts": [], "definitions": [], "readings": [], "choices": [], "equations": equations}
    for fact in found["facts"]:
        kind, _, name = fact.rpartition(" ")
        said[f"{kind or 'fact'}s"].append(name)
    rows = (f"{what}: {', '.join(names)}" for what, names in said.items() if names)
    return [code, found["kind"], *rows]


def lines_of_equation(number: str, printed: Collection[str] = ()) -> list[str]:
    """List all generated lines that rest on an equation, as FILE:LINE and code.

    printed: the numbers of the paper's equations.  Raises TraceError where there is no such line.
    """
    wanted = number.strip().strip("()")
    behind: dict[str, list[str]] = {}
    for file in _files():
        for line, place in file.places.items():
            for equation in place["equations"]:
                told = f"{file.name}:{line}: {_code(file.lines[line - 1])}"
                behind.setdefault(equation, []).append(told)
    if wanted not in behind:
        raise TraceError(_missing(wanted, printed, [e for e in printed if e in behind]))
    return behind[wanted]


def _missing(number: str, printed: Collection[str], traced: Sequence[str]) -> str:
    """Return the error message for an equation that no generated line rests on."""
    shown = f"({number})" if number[:1].isdigit() else number
    if number in printed:
        others = f"; lines rest on {', '.join(traced)}"
        return f"no generated line rests on {shown}, which the paper prints{others}"
    return f"{shown or 'an empty number'} is no equation of the paper, and no source of a line"


def _code(line: str) -> str:
    """Return a generated line without its comment, in Python or in C."""
    return re.split(r"  # | /\* ", line)[0].strip()
