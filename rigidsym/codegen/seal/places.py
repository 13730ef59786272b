"""The map says of every derived line what the line's own comment says."""

import re
from collections.abc import Mapping

from rigidsym.codegen.generate import Generated
from rigidsym.codegen.ir import KINDS
from rigidsym.codegen.lines import Place, note
from rigidsym.errors import InputError

_NOTE = re.compile(rf"(?:  # | /\* )((?:{'|'.join(KINDS)})\b.*?)(?: \*/)?$")


def check(generated: Generated) -> None:
    """Raises InputError, naming the line, where the map and the text differ."""
    for name, text in generated.files.items():
        told = {place["line"]: place for place in generated.map.get(name, ())}
        _check(name, text.split("\n"), told)


def _check(file: str, lines: list[str], told: Mapping[int, Place]) -> None:
    noted = {number: _note(line) for number, line in enumerate(lines, 1) if _note(line)}
    for number in sorted({*noted, *told}):
        place = told.get(number)
        said = note(place["kind"], place["facts"], place["equations"]) if place else "no line"
        if said != noted.get(number, ""):
            raise InputError(f"{file}:{number}", said, f"the line says {noted.get(number)}")


def _note(line: str) -> str:
    """What is said behind a line of code."""
    found = _NOTE.search(line)
    return found[1] if found else ""
