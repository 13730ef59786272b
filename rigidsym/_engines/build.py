"""Compilation and caching of the C library for this machine.

A library that came with the package is used instead where there is one.  The user's cache directory
keeps built libraries.  The name of a file has the digest of what it was built from and of its own
bytes, so that a damaged file is noticed.  One move puts it there whole, and processes that build at
once cannot disturb each other.
"""

import hashlib
import json
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

from rigidsym._engines import shipped
from rigidsym._engines.library import Library, LibraryError, check_arithmetic, load
from rigidsym.errors import InputError
from rigidsym.io._files import write_bytes

NAMES = ("cc", "gcc", "clang")
# gcc prefers 256 bits where it has 512, and the loops gain a fifth by them.
NATIVE = ("-march=native", "-mprefer-vector-width=512")
# Python has checked already that a body can have its moments, or has allowed any.
ANY_MOMENTS = "-DALLOW_NONPHYSICAL"
# Contraction is off because the sources write every fused product themselves: otherwise their exact
# error terms, and with them the last digits, would depend on the compiler.
FLAGS = (
    "-std=c99",
    "-O3",
    *NATIVE,
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
    ANY_MOMENTS,
    "-fPIC",
    "-shared",
)
_OUTPUT = "torque_free.so"
_ARITHMETIC = "torque_free_arithmetic.h"
# The C module of each engine that runs one.
FILES = {
    "c": ("torque_free.h", _ARITHMETIC, "torque_free.c"),
    "c-pi": ("torque_free_pi.h", _ARITHMETIC, "torque_free_pi.c"),
    "c-step": ("torque_free_step.h", _ARITHMETIC, "torque_free_step.c"),
    "c_single": ("torque_free_single.h", "torque_free_single.c"),
    "c_single-step": ("torque_free_single_step.h", "torque_free_single_step.c"),
}
# Engines with the same bits on every processor end so.  They are not built for this processor:
# GCC 12 fuses products for it when it vectorises straight lines, contraction being off.  With -O1
# the build takes half the time of -O3.
_PORTABLE = "-portable"
PORTABLE_FLAGS = (
    *(flag for flag in FLAGS if flag not in ("-O3", *NATIVE)),
    *("-O1", "-DTORQUE_FREE_FMA=0"),
)
_PREFIX, _SUFFIX = "torque_free", ".so"
# The fields that tell processors apart in /proc/cpuinfo, on x86 and on ARM.
_PROCESSOR = {"model name", "flags", "Features", "CPU implementer", "CPU architecture", "CPU part"}


class CompilerError(Exception):
    """Error for a missing or failing C compiler.

    The message has one line.
    """


class MissingCompilerError(CompilerError):
    """Error for a machine without a C compiler."""


@dataclass(frozen=True, slots=True)
class Compiler:
    """C compiler, given by its command and version.

    version: the output of --version.
    """

    command: tuple[str, ...]
    version: str


def find() -> Compiler:
    """Find a C compiler on this machine.

    This is the one in $CC, or the first of cc, gcc and clang on the path.
    """
    given = os.environ.get("CC", "")
    try:
        named = shlex.split(given)
    except ValueError as error:
        raise CompilerError(f"CC={given} cannot be read ({error})") from None
    for name in named[:1] or NAMES:
        if path := shutil.which(name):
            command = (path, *named[1:])
            return Compiler(command, _run([*command, "--version"]).stdout)
    wanted = f"CC={named[0]}" if named else ", ".join(NAMES)
    raise MissingCompilerError(f"no C compiler found ({wanted})")


def compile_library(
    compiler: Compiler, sources: Mapping[str, str], directory: Path, flags: tuple[str, ...] = FLAGS
) -> Path:
    """Compile C sources into a shared library, and return its path.

    directory: an empty directory, in which this works.
    """
    for name, text in sources.items():
        (directory / name).write_text(text, encoding="utf-8")
    units = [name for name in sources if name.endswith(".c")]
    # Compilers for other machines than x86 do not know the flags of NATIVE.
    for some in (flags, tuple(flag for flag in flags if flag not in NATIVE)):
        command = [*compiler.command, *some, "-o", _OUTPUT, *units, "-lm"]
        done = _run(command, directory)
        if not done.returncode:
            break
    else:
        lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        errors = [line for line in lines if "error" in line.lower()]
        reason = next(iter(errors + lines), f"exit status {done.returncode}")
        raise CompilerError(f"{compiler.command[0]} failed: {reason}")
    built = directory / _OUTPUT
    if not built.is_file():
        raise CompilerError(f"{compiler.command[0]} wrote no library")
    return built


def _run(command: list[str], directory: Path | None = None) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            command,
            cwd=directory,
            env=os.environ | {"LC_ALL": "C"},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            check=False,
        )
    except OSError as error:
        raise CompilerError(f"{command[0]} cannot be run: {error.strerror}") from None


def library(remarks: list[str], engine: str = "c") -> Library:
    """Load the C library of an engine: shipped, from the cache, or built.

    Warnings are appended to `remarks`.  Raises CompilerError and LibraryError where there can be no
    library.
    """
    sources = package_sources(engine)
    broken = None
    try:
        if brought := shipped.library(engine, sources):
            check_arithmetic(brought)
            return brought
    except LibraryError as error:
        broken = error
    try:
        compiler = find()
    except MissingCompilerError as missing:
        raise broken or missing from None
    if broken:
        remarks.append(f"engine: {broken}: it is compiled")
    flags = PORTABLE_FLAGS if engine.endswith(_PORTABLE) else FLAGS
    determining = [dict(sources), flags, compiler.command, compiler.version, processor()]
    key = hashlib.sha256(json.dumps(determining).encode()).hexdigest()[:32]
    found = _cached(sources, key, remarks) or _built(sources, compiler, key, remarks, flags)
    check_arithmetic(found)
    return found


def package_sources(engine: str = "c") -> Mapping[str, str]:
    """Return the C sources of an engine by file name."""
    package = resources.files("rigidsym.generated")
    names = FILES[engine.removesuffix(_PORTABLE)]
    return {name: package.joinpath(name).read_text(encoding="utf-8") for name in names}


def processor() -> list[str]:
    """Return lines of text that identify the processor.

    The code that `-march=native` makes depends on it.
    """
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


def _built(
    sources: Mapping[str, str],
    compiler: Compiler,
    key: str,
    remarks: list[str],
    flags: tuple[str, ...],
) -> Library:
    """Compile a C library, put it into the cache if possible, and load it."""
    try:
        with tempfile.TemporaryDirectory(prefix="rigidsym-", ignore_cleanup_errors=True) as work:
            built = compile_library(compiler, sources, Path(work), flags)
            try:
                path = _keep(key, built)
                try:
                    return load(path, sources)
                except LibraryError:
                    _drop(path)
                    raise
            except (CacheError, LibraryError) as error:
                found = load(built, sources)
                remarks.append(f"engine: {error}: the library serves this process only")
                return found
    except OSError as error:
        raise CompilerError(f"there is no place to compile in ({error})") from None


class CacheError(Exception):
    """Error for a cache directory that cannot be used.

    The message has one line.
    """


def cache_directory() -> Path:
    """Return the directory in which compiled libraries are cached.

    This is $RIGIDSYM_CACHE, or `rigidsym` in the platform's cache.  Raises CacheError where a user
    has no home.
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
    """Return True if the digest of a cached file agrees with the one in its name."""
    try:
        return path.stem.rsplit("-", 1)[1] == _digest(path.read_bytes())
    except OSError:
        return False


def _keep(key: str, built: Path) -> Path:
    """Copy a compiled library to the cache.

    Raises CacheError if that fails.
    """
    place, data = cache_directory(), built.read_bytes()
    try:
        return write_bytes(place / f"{_PREFIX}-{key}-{_digest(data)}{_SUFFIX}", data)
    except InputError as error:
        raise CacheError(f"cache {place} {error.rule}") from None


def _drop(path: Path) -> None:
    """Remove a file, and ignore errors."""
    with suppress(OSError):
        path.unlink(missing_ok=True)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()[:32]
