"""Files: read with one clear line of error, written whole or not at all."""

import os
import tempfile
from pathlib import Path

from rigidsym.errors import InputError


def probe(directory: Path) -> None:
    """Raise InputError if a directory cannot be written, before work is spent."""
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=directory):
            pass
    except OSError as error:
        raise InputError("output", directory, f"cannot be written: {error.strerror}") from None


def read_text(field: str, path: str | Path) -> str:
    """Return the text of a user's file; raise InputError if it cannot be read or is not UTF-8."""
    try:
        return Path(path).read_text("utf-8")
    except OSError as error:
        raise InputError(field, path, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(field, path, "is not UTF-8 text") from None


def write_text(path: Path, text: str) -> Path:
    """Write text under a temporary name and move it into place; raise InputError on failure."""
    return write_bytes(path, text.encode("utf-8"))


def write_bytes(path: Path, data: bytes) -> Path:
    """Write bytes under a temporary name and move them into place; raise InputError on failure."""
    try:
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
    """Remove a file if it exists; raise InputError on failure."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise InputError("output", path, f"cannot be removed: {error.strerror}") from None
