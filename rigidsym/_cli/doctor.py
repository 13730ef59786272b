"""Function that runs the command `doctor`, and what it finds out about an installation."""

import json
import platform
import re
import sys
from argparse import Namespace
from collections.abc import Mapping
from importlib import metadata
from typing import Any

from rigidsym._cli.output import reader_may_leave, table
from rigidsym._version import __version__

SCHEMA = "rigidsym.doctor/1"
# The C modules of the default engine: states, and steps.
_MODULES = ("c", "c-step")
_EXTRA = re.compile(r"extra == ['\"]([\w-]+)['\"]")
_REQUIREMENT = re.compile(r"([\w.-]+)(?:\[([\w,-]+)\])?")


def doctor(options: Namespace) -> int:
    """Print which engine computes and why, the compiler, extras and versions.

    Returns 1 if C's engine should be there and fails.
    """
    found = examined()
    with reader_may_leave():
        if options.json:
            print(json.dumps(found, indent=2))
        else:
            table("rigidsym doctor", ("", ""), _rows(found))
    return 1 if found["engine"]["problem"] else 0


def examined() -> dict[str, Any]:
    """Examine this installation.

    The first call on a machine may compile, for some seconds.
    """
    engine = _engine()
    return {
        "schema": SCHEMA,
        "rigidsym": __version__,
        "python": platform.python_version(),
        "platform": f"{sys.platform} {platform.machine()}",
        "engine": engine,
        "compiler": _compiler(),
        "extras": _extras(),
        "packages": _versions(),
    }


def _engine() -> dict[str, Any]:
    """Return the name of the default engine, why it is that, and its libraries.

    problem: what keeps C from computing, but for a missing compiler.
    """
    from rigidsym._engines import shipped
    from rigidsym._engines.build import CompilerError, MissingCompilerError, library
    from rigidsym._engines.library import LibraryError

    remarks: list[str] = []
    try:
        paths = [library(remarks, module).path for module in _MODULES]
    except (CompilerError, LibraryError) as error:
        missing = isinstance(error, MissingCompilerError)
        why = f"the package brings no library, and {error}" if missing else str(error)
        problem = None if missing else str(error)
        return {"name": "numpy", "why": why, "path": None, "libraries": [], "problem": problem}
    if brought := paths[0].parent == shipped.FOLDER:
        why = "the package brings its library; no compiler is needed"
    else:
        why = "compiled on this machine, and kept in the cache"
    return {
        "name": "c",
        "why": "; ".join((why, *remarks)),
        "path": shipped.code_path() if brought else "-march=native",
        "libraries": sorted({str(path) for path in paths}),
        "problem": None,
    }


def _compiler() -> dict[str, str] | None:
    """Return the command and version of the C compiler, or None without one."""
    from rigidsym._engines.build import CompilerError, find

    try:
        found = find()
    except CompilerError:
        return None
    first = next(iter(found.version.splitlines()), "")
    return {"command": " ".join(found.command), "version": first}


def _extras() -> dict[str, list[str]]:
    """Return the packages that each extra lacks, by extra."""
    needed: dict[str, set[str]] = {}
    inner: dict[str, set[str]] = {}
    for line in _requirements():
        requirement, marker = _REQUIREMENT.match(line), _EXTRA.search(line)
        if requirement is None or marker is None:
            continue
        name, others = requirement.groups()
        found = needed.setdefault(marker[1], set())
        if name == "rigidsym":
            inner.setdefault(marker[1], set()).update((others or "").split(","))
        elif "sys_platform" not in line or f"'{sys.platform}'" in line.replace('"', "'"):
            found.add(name)

    def whole(extra: str) -> set[str]:
        return needed.get(extra, set()).union(*map(whole, inner.get(extra, ())))

    return {extra: sorted(filter(_is_missing, whole(extra))) for extra in sorted(needed)}


def _versions() -> dict[str, str]:
    """Return the versions of the packages that every installation has."""
    plain = (line for line in _requirements() if not _EXTRA.search(line))
    names = sorted(found[1] for line in plain if (found := _REQUIREMENT.match(line)))
    return {name: "missing" if _is_missing(name) else metadata.version(name) for name in names}


def _requirements() -> list[str]:
    """Return the requirements of the package; none if it runs from a folder uninstalled."""
    try:
        return metadata.requires("rigidsym") or []
    except metadata.PackageNotFoundError:
        return []


def _is_missing(name: str) -> bool:
    try:
        metadata.version(name)
    except metadata.PackageNotFoundError:
        return True
    return False


def _rows(found: Mapping[str, Any]) -> list[tuple[str, str]]:
    engine, compiler = found["engine"], found["compiler"]
    told = f"{compiler['command']}: {compiler['version']}" if compiler else "none: none is needed"
    if not compiler and engine["name"] == "numpy":
        told = "none: install cc, gcc or clang, or a wheel for this platform, and C computes"
    extras = found["extras"].items()
    lacking = (f"{name} (lacks {', '.join(lacks)})" for name, lacks in extras if lacks)
    return [
        ("rigidsym", f"{found['rigidsym']}, Python {found['python']}, {found['platform']}"),
        ("engine", f'{engine["name"]} (engine="auto"): {engine["why"]}'),
        *((("code path", engine["path"]),) if engine["path"] else ()),
        *(("library", path) for path in engine["libraries"]),
        ("compiler", told),
        ("extras here", ", ".join(name for name, lacks in extras if not lacks) or "none"),
        ("extras not here", "; ".join(lacking) or "none"),
        ("packages", ", ".join(f"{name} {version}" for name, version in found["packages"].items())),
    ]
