"""The library for this machine: from the cache, or compiled and put there."""

import hashlib
import json
import platform
import tempfile
from collections.abc import Mapping
from importlib import resources
from pathlib import Path

from rigidsym.engines import cache
from rigidsym.engines.cache import CacheError
from rigidsym.engines.compiler import FLAGS, Compiler, CompilerError, compile_library, find
from rigidsym.engines.library import Library, LibraryError, check_arithmetic, load

# The C module of each engine that runs one.
FILES = {
    "c": ("torque_free.h", "torque_free.c"),
    "c-pi": ("torque_free_pi.h", "torque_free_pi.c"),
    "c-step": ("torque_free_step.h", "torque_free_step.c"),
}
# What tells processors apart in /proc/cpuinfo, on x86 and on ARM.
_TELLING = {"model name", "flags", "Features", "CPU implementer", "CPU architecture", "CPU part"}


def library(remarks: list[str], engine: str = "c") -> Library:
    """Load or build that of an engine; what the user should hear of is added to `remarks`.

    Raises CompilerError and LibraryError where there is no library to be had.
    """
    sources, compiler = package_sources(engine), find()
    key = _key(sources, compiler)
    found = _cached(sources, key, remarks) or _built(sources, compiler, key, remarks)
    check_arithmetic(found)
    return found


def package_sources(engine: str = "c") -> Mapping[str, str]:
    """The generated C module of an engine by file name."""
    package = resources.files("rigidsym.generated")
    return {name: package.joinpath(name).read_text(encoding="utf-8") for name in FILES[engine]}


def _key(sources: Mapping[str, str], compiler: Compiler) -> str:
    """A digest of all that determines a library."""
    parts = [dict(sources), FLAGS, compiler.command, compiler.version, processor()]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:32]


def processor() -> list[str]:
    """What `-march=native` depends on, as far as the system tells."""
    telling = [platform.machine()]
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            for line in file:
                # The first processor stands for all of them.
                if not line.strip():
                    break
                if line.partition(":")[0].strip() in _TELLING:
                    telling.append(line.strip())
    except OSError:
        telling.append(platform.processor())
    return telling


def _cached(sources: Mapping[str, str], key: str, remarks: list[str]) -> Library | None:
    for path in cache.kept(key):
        try:
            if not cache.is_whole(path):
                raise LibraryError(f"{path} is damaged")
            return load(path, sources)
        except LibraryError as error:
            remarks.append(f"engine: {error}: it is built again")
            cache.drop(path)
    return None


def _built(sources: Mapping[str, str], compiler: Compiler, key: str, remarks: list[str]) -> Library:
    """Compile in a temporary directory, and keep the library where that can be done."""
    try:
        with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
            built = compile_library(compiler, sources, Path(work))
            try:
                return _kept(sources, key, built)
            except (CacheError, LibraryError) as error:
                found = load(built, sources)
                remarks.append(f"engine: {error}: the library serves this process only")
                return found
    except OSError as error:
        raise CompilerError(f"there is no place to compile in ({error})") from None


def _kept(sources: Mapping[str, str], key: str, built: Path) -> Library:
    path = cache.keep(key, built)
    try:
        return load(path, sources)
    except LibraryError:
        cache.drop(path)
        raise
