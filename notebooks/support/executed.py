"""Which notebooks are as a fresh execution left them: `executed.json` says of what, by a digest.

The digest of a notebook is over all that its outputs depend on: its text and .ipynb, the modules
of this package and `build.py`, every file of the package and of the derivations, and the versions
of Python and of the packages that the extras `lab` and `app` bring.  A C compiler is not in it.
"""

import json
import re
import sys
from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from importlib import metadata
from pathlib import Path

from rigidsym.io._files import write_text

FOLDER = Path(__file__).resolve().parents[1]
RECORD = Path(__file__).with_name("executed.json")
# What every notebook may import, and what runs and writes them.
TOGETHER = (
    "build.py",
    *(
        f"support/{name}.py"
        for name in ("__init__", "executed", "figures", "names", "play", "steps", "water")
    ),
)
PACKAGES = ("derivations", "rigidsym")
_CORE_LAB_APP = re.compile(r"(?!rigidsym)([\w.-]+)[^;]*(; extra == ['\"](lab|app)['\"])?")


def is_current(name: str, record: Path = RECORD) -> bool:
    """Whether nothing that a notebook depends on has changed since it was executed and written."""
    return _digests(record).get(name) == digest(name)


def note(name: str, record: Path = RECORD) -> None:
    """Record that a notebook has just been written by an execution."""
    digests = {**_digests(record), name: digest(name)}
    there = {
        stem: digests[stem]
        for stem in sorted(digests)
        if (FOLDER / "text" / f"{stem}.py").is_file()
    }
    write_text(record, json.dumps(there, indent=1) + "\n")


def digest(name: str) -> str:
    """One number for all that the outputs of a notebook depend on, and for these."""
    own = sha256("\n".join(common()).encode())
    for path in (FOLDER / "text" / f"{name}.py", FOLDER / f"{name}.ipynb"):
        own.update(path.read_bytes() if path.is_file() else b"")
    return own.hexdigest()


def _digests(record: Path) -> dict[str, str]:
    return json.loads(record.read_text("utf-8")) if record.is_file() else {}


@cache
def common() -> tuple[str, ...]:
    """What all notebooks depend on, as one line a file and a package."""
    major, minor = sys.version_info[:2]
    files = (f"{path.relative_to(FOLDER.parent).as_posix()} {_of(path)}" for path in _files())
    return (f"python {major}.{minor}", *_versions(), *files)


def _of(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest()


def _files() -> Iterator[Path]:
    yield from (FOLDER / name for name in TOGETHER)
    for package in PACKAGES:
        for path in sorted((FOLDER.parent / package).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                yield path


def _versions() -> Iterator[str]:
    found = map(_CORE_LAB_APP.fullmatch, metadata.requires("rigidsym") or ())
    for name in sorted({match[1] for match in found if match}):
        yield f"{name} {_version(name)}"


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return "is not here"
