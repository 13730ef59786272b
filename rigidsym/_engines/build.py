"""The compiled C library for this machine, built once and cached.

The user's cache directory keeps built libraries.  The name of a file has the digest of what it was
built from and of its own bytes, so that a damaged file is noticed.  One move puts it there whole,
and processes that build at once cannot disturb each other.
"""

import hashlib
import json
import os
import platform
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from importlib import resources
from pathlib import Path

from rigidsym._engines.compiler import FLAGS, Compiler, CompilerError, compile_library, find
from rigidsym._engines.library import Library, LibraryError, check_arithmetic, load
from rigidsym.errors import InputError
from rigidsym.io._files import write_bytes

# The C module of each engine that runs one.
FILES = {
    "c": ("torque_free.h", "torque_free.c"),
    "c-pi": ("torque_free_pi.h", "torque_free_pi.c"),
    "c-step": ("torque_free_step.h", "torque_free_step.c"),
}
_PREFIX, _SUFFIX = "torque_free", ".so"
# The fields that tell processors apart in /proc/cpuinfo, on x86 and on ARM.
_PROCESSOR = {"model name", "flags", "Features", "CPU implementer", "CPU architecture", "CPU part"}


def library(remarks: list[str], engine: str = "c") -> Library:
    """Load the C library of an engine, or build it; append warnings to `remarks`.

    Raises CompilerError and LibraryError where there can be no library.
    """
    sources, compiler = package_sources(engine), find()
    determining = [dict(sources), FLAGS, compiler.command, compiler.version, processor()]
    key = hashlib.sha256(json.dumps(determining).encode()).hexdigest()[:32]
    found = _cached(sources, key, remarks) or _built(sources, compiler, key, remarks)
    check_arithmetic(found)
    return found


def package_sources(engine: str = "c") -> Mapping[str, str]:
    """Return the C sources of an engine by file name."""
    package = resources.files("rigidsym.generated")
    return {name: package.joinpath(name).read_text(encoding="utf-8") for name in FILES[engine]}


def processor() -> list[str]:
    """Return lines that identify the processor, on which `-march=native` depends."""
    found = [platform.machine()]
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                # The first processor stands for all of them.
                if not line.strip():
                    break
                if line.partition(":")[0].strip() in _PROCESSOR:
                    found.append(line.strip())
    except OSError:
        found.append(platform.processor())
    return found


def _cached(sources: Mapping[str, str], key: str, remarks: list[str]) -> Library | None:
    cached: list[Path] = []
    with suppress(CacheError, OSError):
        cached = sorted(cache_directory().glob(f"{_PREFIX}-{key}-*{_SUFFIX}"))
    for path in cached:
        try:
            if not is_whole(path):
                raise LibraryError(f"{path} is damaged")
            return load(path, sources)
        except LibraryError as error:
            remarks.append(f"engine: {error}: it is built again")
            _drop(path)
    return None


def _built(sources: Mapping[str, str], compiler: Compiler, key: str, remarks: list[str]) -> Library:
    """Compile a library and, if possible, put it into the cache."""
    try:
        with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
            built = compile_library(compiler, sources, Path(work))
            try:
                return _keep_and_load(sources, key, built)
            except (CacheError, LibraryError) as error:
                found = load(built, sources)
                remarks.append(f"engine: {error}: the library serves this process only")
                return found
    except OSError as error:
        raise CompilerError(f"there is no place to compile in ({error})") from None


def _keep_and_load(sources: Mapping[str, str], key: str, built: Path) -> Library:
    path = _keep(key, built)
    try:
        return load(path, sources)
    except LibraryError:
        _drop(path)
        raise


class CacheError(Exception):
    """Cache directory that cannot be used; the message is one line."""


def cache_directory() -> Path:
    """Return the cache directory: $RIGIDSYM_CACHE, or `rigidsym` in the platform's cache.

    Raises CacheError where a user has no home.
    """
    if named := os.environ.get("RIGIDSYM_CACHE"):
        return Path(named).absolute()
    xdg = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        if xdg.is_absolute():
            return xdg / "rigidsym"
        if sys.platform == "darwin":
            return Path.home() / "Library" / "Caches" / "rigidsym"
        if sys.platform == "win32":
            local = os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")
            return Path(local) / "rigidsym"
        return Path.home() / ".cache" / "rigidsym"
    except RuntimeError:
        raise CacheError("there is no home directory for a cache") from None


def is_whole(path: Path) -> bool:
    """Return True if the digest of a file is the one in its name."""
    try:
        return path.stem.rsplit("-", 1)[1] == _digest(path.read_bytes())
    except OSError:
        return False


def _keep(key: str, built: Path) -> Path:
    """Copy a built library to the cache; raise CacheError on failure."""
    place, data = cache_directory(), built.read_bytes()
    try:
        return write_bytes(place / f"{_PREFIX}-{key}-{_digest(data)}{_SUFFIX}", data)
    except InputError as error:
        raise CacheError(f"cache {place} {error.rule}") from None


def _drop(path: Path) -> None:
    """Remove a file if possible."""
    with suppress(OSError):
        path.unlink(missing_ok=True)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:32]
