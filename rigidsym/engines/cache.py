"""Built libraries, kept in the user's cache directory from one process to the next.

A file is named by what it was built from and by the digest of its own bytes.  So it proves itself,
one move puts it there whole, and processes that build at once cannot disturb each other.
"""

import hashlib
import os
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from rigidsym.errors import InputError
from rigidsym.io.files import write_bytes

_PREFIX = "torque_free"
_SUFFIX = ".so"


class CacheError(Exception):
    """A cache that nothing can be kept in; its text is one line."""


def directory() -> Path:
    """$RIGIDSYM_CACHE, else rigidsym in $XDG_CACHE_HOME, else in the platform's place for caches.

    Raises CacheError where a user has no home.
    """
    if named := os.environ.get("RIGIDSYM_CACHE"):
        return Path(named).absolute()
    xdg = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        return (xdg if xdg.is_absolute() else platform_caches()) / "rigidsym"
    except RuntimeError:
        raise CacheError("there is no home directory for a cache") from None


def platform_caches() -> Path:
    """Where this system keeps what can be made again; raises RuntimeError without a home."""
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local"))
    return Path.home() / ".cache"


def kept(key: str) -> Iterator[Path]:
    """The files built from what `key` is the digest of."""
    with suppress(CacheError, OSError):
        yield from sorted(directory().glob(f"{_PREFIX}-{key}-*{_SUFFIX}"))


def is_whole(path: Path) -> bool:
    """True where a file's bytes have the digest in its name."""
    try:
        return path.stem.rsplit("-", 1)[1] == _digest(path.read_bytes())
    except OSError:
        return False


def keep(key: str, built: Path) -> Path:
    """Put a copy of a built library into place; raises CacheError where that fails."""
    place, data = directory(), built.read_bytes()
    try:
        return write_bytes(place / f"{_PREFIX}-{key}-{_digest(data)}{_SUFFIX}", data)
    except InputError as error:
        raise CacheError(f"cache {place} {error.rule}") from None


def drop(path: Path) -> None:
    """Remove a file that is of no use, where it can be removed."""
    with suppress(OSError):
        path.unlink(missing_ok=True)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:32]
