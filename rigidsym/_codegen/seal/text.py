"""Checks of printed files: their text, digests, and the map of derived lines."""

import hashlib
import re

from rigidsym._codegen import header
from rigidsym._codegen.forms import split
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.generate import Generated
from rigidsym._codegen.ir import KINDS
from rigidsym._codegen.lines import note
from rigidsym._codegen.targets import format_of, reader
from rigidsym.errors import InputError
from rigidsym.solution import Solution

_NOTE = re.compile(rf"(?:  # | /\* )((?:{'|'.join(KINDS)})\b.*?)(?: \*/)?$")


def seal_text(generated: Generated, solution: Solution) -> int:
    """Check the files of a generated module by reading them back.

    Returns the number of derived lines.  Raises InputError, naming the function or line, for a line
    that differs from its let or its entry in the map, for hand-written text that differs from the
    package's, and for a digest of other files.
    """
    target, form = split(generated.manifest["target"])
    check, binary = reader(target), format_of(target)
    own = functions(solution, form, binary), constants(binary)
    decided = check(generated.files, *own, form)
    _check_digests(generated)
    _check_places(generated)
    return decided


def _check_digests(generated: Generated) -> None:
    """Raise InputError if a digest in the manifest does not match the files."""
    manifest, files = generated.manifest, dict(generated.files)
    found = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
    for name in sorted({*found, *manifest["sha256"]}):
        if found.get(name) != manifest["sha256"].get(name):
            raise InputError("sha256", name, "is not what the manifest says")
    target, digest = manifest["target"], manifest["digest"]
    unsealed = {name: header.unsealed(text, target, digest) for name, text in files.items()}
    if header.sealed(unsealed, target) != (files, digest):
        raise InputError("digest", digest, "is not that of the files")


def _check_places(generated: Generated) -> None:
    """Raise InputError for the first line whose comment differs from its entry in the map."""
    for file, text in generated.files.items():
        told = {place["line"]: place for place in generated.map.get(file, ())}
        found = {number: _NOTE.search(x) for number, x in enumerate(text.split("\n"), 1)}
        noted = {number: match[1] for number, match in found.items() if match}
        for number in sorted({*noted, *told}):
            place = told.get(number)
            said = note(place["kind"], place["facts"], place["equations"]) if place else "no line"
            if said != noted.get(number, ""):
                raise InputError(f"{file}:{number}", said, f"the line says {noted.get(number)}")
