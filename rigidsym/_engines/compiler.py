"""Search for the system's C compiler, and compilation of a shared library."""

import os
import shlex
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

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
_LIBRARIES = ("-lm",)
_OUTPUT = "torque_free.so"


class CompilerError(Exception):
    """Missing or failing compiler; the message is one line."""


@dataclass(frozen=True, slots=True)
class Compiler:
    """Command of a C compiler and the text of its --version."""

    command: tuple[str, ...]
    version: str


def find() -> Compiler:
    """Return the compiler in $CC, or the first of cc, gcc and clang on the path."""
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
    raise CompilerError(f"no C compiler found ({wanted})")


def compile_library(
    compiler: Compiler, sources: Mapping[str, str], directory: Path, flags: tuple[str, ...] = FLAGS
) -> Path:
    """Compile sources into a shared library in an empty directory, and return its path."""
    for name, text in sources.items():
        (directory / name).write_text(text, encoding="utf-8")
    units = [name for name in sources if name.endswith(".c")]
    done = _compile(compiler, flags, units, directory)
    if done.returncode:
        # Compilers for other machines than x86 do not know these flags.
        portable = tuple(flag for flag in flags if flag not in NATIVE)
        done = _compile(compiler, portable, units, directory)
    if done.returncode:
        lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        errors = [line for line in lines if "error" in line.lower()]
        reason = next(iter(errors + lines), f"exit status {done.returncode}")
        raise CompilerError(f"{compiler.command[0]} failed: {reason}")
    built = directory / _OUTPUT
    if not built.is_file():
        raise CompilerError(f"{compiler.command[0]} wrote no library")
    return built


def _compile(
    compiler: Compiler, flags: tuple[str, ...], units: list[str], directory: Path
) -> subprocess.CompletedProcess[str]:
    tail = ("-o", _OUTPUT, *units, *_LIBRARIES)
    return _run([*compiler.command, *flags, *tail], directory)


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
