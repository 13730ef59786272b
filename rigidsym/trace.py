"""From a generated line to its equations, and back, by the map that comes with each module."""

import json
import re
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from typing import Any

from rigidsym.errors import InputError


def _maps() -> Iterator[tuple[str, dict[int, Any], list[str]]]:
    """Every generated file of this installation with its map and its lines."""
    home = resources.files("rigidsym.generated")
    for entry in sorted(home.iterdir(), key=lambda entry: entry.name):
        if entry.name.endswith(".map.json"):
            for name, places in json.loads(entry.read_text("utf-8"))["lines"].items():
                lines = home.joinpath(name).read_text("utf-8").splitlines()
                yield name, {place["line"]: place for place in places}, lines


def origin_of_line(place: str) -> list[str]:
    """The code, equations and facts of FILE:LINE; empty for lines that nothing derived."""
    file, _, number = place.rpartition(":")
    if not file or not number.isdecimal():
        raise InputError("trace", place, "must be FILE:LINE")
    for name, places, lines in _maps():
        if name == Path(file).name and int(number) in places:
            found = places[int(number)]
            equations = ", ".join(f"({e})" if e[0].isdigit() else e for e in found["equations"])
            facts = ", ".join(found["facts"])
            known = {"equations": equations, "facts": facts}
            said = [f"{what}: {text}" for what, text in known.items() if text]
            return [_code(lines[int(number) - 1]), *said]
    return []


def lines_of_equation(number: str) -> list[str]:
    """FILE:LINE and code for every generated line that an equation stands behind."""
    wanted = number.strip("()")
    return [
        f"{name}:{line}: {_code(lines[line - 1])}"
        for name, places, lines in _maps()
        for line, place in places.items()
        if wanted in place["equations"]
    ]


def _code(line: str) -> str:
    """A generated line without its comment, in Python or in C."""
    return re.split(r"  # | /\* ", line)[0].strip()
