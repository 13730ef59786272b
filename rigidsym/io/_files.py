"""Functions that read text and TOML files and write files atomically.

Errors have one-line messages.
"""

import os
import tempfile
import tomllib
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from rigidsym.errors import InputError, nearest

# Values may be of any type.
TomlTable = Mapping[str, Any]

# Kinds of files, and of fields that one kind alone has, the command that reads it.
_KINDS = {"case", "manoeuvre", "observations"}
_READ_BY = {"omega0": "propagate", "start": "plan", "target": "plan"}
_READ_BY |= dict.fromkeys(("attitudes", "rates", "vectors"), "fit")

# By kind of file, how to get one.
_BEGIN = {
    "case": "`rigidsym init motion.toml` writes a template; `paper` is the paper's case",
    "manoeuvre": "`rigidsym init slew.toml` writes a template; `paper` is the paper's manoeuvre",
    "observations": "`rigidsym init observations.csv` writes a template",
}


def probe(directory: Path) -> None:
    """Create a directory, and raise InputError if no file can be written there."""
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=directory):
            pass
    except OSError as error:
        raise InputError("output", directory, f"cannot be written: {error.strerror}") from None


def read_text(field: str, path: str | Path, encoding: str = "utf-8", next_step: str = "") -> str:
    """Return the text of a user's file.

    Raises InputError if the file cannot be read, or does not have the encoding: next_step is then
    what to do.
    """
    try:
        return Path(path).read_text(encoding)
    except OSError as error:
        step = _BEGIN.get(field, "") if isinstance(error, FileNotFoundError) else ""
        rule = f"cannot be read: {error.strerror}"
        raise InputError(field, path, rule, next_step=step) from None
    except LookupError:
        raise InputError(
            "encoding", repr(encoding), "is no encoding of text, such as utf-8 or cp1252"
        ) from None
    except UnicodeError:
        rule = f"is not {encoding.upper()} text"
        raise InputError(field, path, rule, next_step=next_step) from None


def parse_toml(field: str, text: str) -> TomlTable:
    """Parse TOML text.

    Raises InputError if it is not TOML.
    """
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise InputError(field, "the file", f"is not TOML: {error}") from None


def subtable(field: str, value: object, known: Collection[str]) -> TomlTable:
    """Check that a TOML value is a table with known keys only, and return it.

    Raises InputError otherwise.
    """
    if not isinstance(value, Mapping):
        raise InputError(field, repr(value), f"must be a table of {', '.join(sorted(known))}")
    check_keys(field, value, known)
    return value


def check_keys(
    field: str, table: TomlTable, known: Collection[str], needed: Collection[str] = ()
) -> None:
    """Raise InputError if a TOML table has an unknown key or lacks a needed one."""
    for key in table:
        if key not in known:
            rule = f"is not one of: {', '.join(sorted(known))}"
            if field in _KINDS and (reader := _READ_BY.get(key)):
                rule += f"; `rigidsym {reader}` reads files that have it"
            near = nearest(key, known)
            raise InputError(field, key, rule, next_step=f"did you mean {near}?" if near else "")
    for key in needed:
        if key not in table:
            step = "times = [0, 10], or a table [times] with start, stop and count"
            step = step if key == "times" else ""
            raise InputError(key, "missing", f"a {field} needs it", next_step=step)


def write_text(path: Path, text: str) -> Path:
    """Write a text file atomically.

    Raises InputError if that fails.
    """
    return write_bytes(path, text.encode("utf-8"))


def write_all(directory: Path, contents: Mapping[str, str | bytes]) -> list[Path]:
    """Write several files to a directory atomically, and return their paths.

    The contents are given by file name.
    """
    return [
        write_bytes(directory / name, data.encode("utf-8") if isinstance(data, str) else data)
        for name, data in contents.items()
    ]


def write_bytes(path: Path, data: bytes) -> Path:
    """Write a binary file atomically.

    The file is written under a temporary name and then renamed; a device or a pipe, which a rename
    would replace, is written to.  Raises InputError if that fails.
    """
    try:
        if path.exists() and not (path.is_file() or path.is_dir()):
            path.write_bytes(data)
            return path
        path.parent.mkdir(parents=True, exist_ok=True)
        descriptor, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        try:
            with os.fdopen(descriptor, "wb") as file:
                file.write(data)
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(name, 0o666 & ~mask)
            os.replace(name, path)
        except BaseException:
            os.unlink(name)
            raise
    except OSError as error:
        raise InputError("output", path, f"cannot be written: {error.strerror}") from None
    return path


def remove(path: Path) -> None:
    """Remove a file if it exists.

    Raises InputError if that fails.
    """
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise InputError("output", path, f"cannot be removed: {error.strerror}") from None
