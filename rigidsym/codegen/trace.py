"""From a generated line to its equations, and back, by the map that comes with each module."""

import json
import re
from collections.abc import Collection, Iterator
from importlib import resources
from pathlib import Path

from rigidsym.codegen.lines import Place
from rigidsym.errors import InputError


class TraceError(LookupError):
    """There is nothing to be told of a line or an equation, and why."""


def _maps() -> Iterator[tuple[str, dict[int, Place], list[str]]]:
    """Every generated file of this installation with its map and its lines."""
    home = resources.files("rigidsym.generated")
    for entry in sorted(home.iterdir(), key=lambda entry: entry.name):
        if entry.name.endswith(".map.json"):
            for name, places in json.loads(entry.read_text("utf-8"))["lines"].items():
                lines = home.joinpath(name).read_text("utf-8").splitlines()
                yield name, {place["line"]: place for place in places}, lines


def origin_of_line(place: str) -> list[str]:
    """The code of FILE:LINE, its equations, and the facts, definitions and readings it is by.

    Raises TraceError where nothing derived is.
    """
    file, _, number = place.rpartition(":")
    if not file or not number.isdecimal():
        raise InputError("trace", place, "must be FILE:LINE")
    known = {name: (places, lines) for name, places, lines in _maps()}
    name, line = Path(file).name, int(number)
    if name not in known:
        raise TraceError(f"{name} is no generated file: these are {', '.join(known)}")
    places, lines = known[name]
    if not 1 <= line <= len(lines):
        raise TraceError(f"{name} has lines 1 to {len(lines)}, no line {line}")
    code = _code(lines[line - 1])
    if line not in places:
        raise TraceError(f"{name}:{line} has no equation behind it: {code or 'an empty line'}")
    found = places[line]
    equations = [f"({e})" if e[0].isdigit() else e for e in found["equations"]]
    said = {"equations": equations, "facts": [], "definitions": [], "readings": []}
    for name in found["facts"]:
        kind, _, name = name.rpartition(" ")
        said[f"{kind or 'fact'}s"].append(name)
    return [code, *(f"{what}: {', '.join(names)}" for what, names in said.items() if names)]


def lines_of_equation(number: str, printed: Collection[str] = ()) -> list[str]:
    """FILE:LINE and code for every generated line that an equation stands behind.

    printed: the numbers of the paper, which say whether there is such an equation.  Raises
    TraceError where there is no such line.
    """
    wanted = number.strip().strip("()")
    found = [
        f"{name}:{line}: {_code(lines[line - 1])}"
        for name, places, lines in _maps()
        for line, place in places.items()
        if wanted in place["equations"]
    ]
    if not found:
        raise TraceError(_missing(wanted, printed))
    return found


def _missing(number: str, printed: Collection[str]) -> str:
    """What is wrong with a number behind which there are no lines."""
    shown = f"({number})" if number[:1].isdigit() else number
    if number in printed:
        return f"no generated line rests on {shown}, which the paper prints"
    return f"{shown or 'an empty number'} is no equation of the paper, and no source of a line"


def _code(line: str) -> str:
    """A generated line without its comment, in Python or in C."""
    return re.split(r"  # | /\* ", line)[0].strip()
