"""Generation of the files of a numeric module."""

import hashlib
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import TypedDict

from rigidsym._codegen.forms import THETA, checked, key
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.lines import Place
from rigidsym._codegen.targets import builder, format_of
from rigidsym.io._files import write_all
from rigidsym.solution import Solution, sealed

_INCLUDE = re.compile(r'^#include "(.+)"$', re.MULTILINE)


class Manifest(TypedDict):
    """Manifest of a generated module: its key, its digest, and the digests of its files."""

    target: str
    digest: str
    sha256: dict[str, str]


@dataclass(frozen=True, slots=True)
class Generated:
    """Generated module: files by name, the map from lines to equations, and a manifest."""

    files: Mapping[str, str]
    map: Mapping[str, list[Place]]
    manifest: Manifest

    def __repr__(self) -> str:
        sizes = (f"{name} ({text.count(chr(10))} lines)" for name, text in self.files.items())
        target, digest = self.manifest["target"], self.manifest["digest"]
        return f"<Generated for {target}: {', '.join(sizes)}, digest {digest[:12]}>"

    def texts(self) -> dict[str, str]:
        """Return the text of each file by its name, including the map from lines to equations."""
        stem = str(self.manifest["target"])
        described = {"manifest": self.manifest, "lines": self.map}
        return {**self.files, f"{stem}.map.json": json.dumps(described, indent=1) + "\n"}

    def write(self, directory: str | Path) -> list[Path]:
        """Write all files to a directory, and return their paths."""
        return write_all(Path(directory), self.texts())

    def single_file(self) -> "Generated":
        """Return the module with the header that forms share written into its C source.

        The module is then one header and one source.  Modules without such a header are unchanged.
        """
        files, places = {**self.files}, {**self.map}
        for name, text in self.files.items():
            for found in _INCLUDE.finditer(text):
                if found[1] not in files or PurePath(found[1]).stem == PurePath(name).stem:
                    continue
                included = files.pop(found[1]).strip()
                files[name] = text.replace(found[0], included)
                place, more = text.count("\n", 0, found.end()), included.count("\n")
                places[name] = [
                    {**one, "line": one["line"] + more if one["line"] > place else one["line"]}
                    for one in places[name]
                ]
        return Generated(files, places, {**self.manifest, "sha256": _digests(files)})


def _digests(files: Mapping[str, str]) -> dict[str, str]:
    return {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}


def generate(target: str, solution: Solution | None = None, form: str = THETA) -> Generated:
    """Generate the numeric module of a target, for example "c".

    solution: the formulas to print, by default those of the sealed ledger.  form: the form of the
    solution, "theta", "pi" or "step".  Raises InputError (a ValueError) for an unknown target or
    form.
    """
    build, binary = builder(target), format_of(target)
    module = build(functions(solution or sealed(), checked(form), binary), constants(binary), form)
    manifest: Manifest = {
        "target": key(target, form),
        "digest": module.digest,
        "sha256": _digests(module.files),
    }
    return Generated(module.files, module.places(), manifest)
