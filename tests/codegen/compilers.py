"""The C compilers at hand, gcc and clang, and what they build from the C target."""

import importlib.util
import platform
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import pytest

from rigidsym import generate

SOURCES = Path(__file__).parent / "c"
STRICT = (
    *("-std=c99", "-Werror", "-Wall", "-Wextra", "-Wpedantic"),
    *("-Wconversion", "-Wshadow", "-Wdouble-promotion"),
)
OURS = ("torque_free.c",)
X86 = platform.machine() in ("x86_64", "AMD64")


@dataclass(frozen=True, slots=True)
class Compiler:
    """A command, and how it spells the processors of a build."""

    name: str
    command: tuple[str, ...]
    dashes: str = "-"

    def machine(self, name: str) -> tuple[str, ...]:
        """The flags for `native`, `x86-64` or `x86-64-v3`; none where there is no such thing."""
        if name != "native" and not X86:
            return ()
        return (f"-march={name.replace('-', self.dashes)}",)

    def run(self, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
        """What the compiler says; it need not succeed."""
        line = [*self.command, *map(str, arguments)]
        return subprocess.run(line, capture_output=True, text=True, check=False)

    def build(self, here: Path, output: str, *flags: str, sources: tuple[str, ...] = OURS) -> Path:
        """The output of our sources; they and the headers are in `here`."""
        done = self.run(*flags, *(here / name for name in sources), "-o", here / output, "-lm")
        assert done.returncode == 0, done.stderr[-4000:]
        return here / output

    def remarks(self, here: Path, output: Path, *flags: str) -> str:
        """What it says of an object that no cache can answer for."""
        fresh = f"-DFRESH={time.time_ns()}"
        done = self.run(*flags, fresh, "-c", here / OURS[0], "-o", output)
        assert done.returncode == 0, done.stderr[-4000:]
        return done.stderr


def written(here: Path) -> Path:
    """The generated files and ours, in a directory."""
    generate("c").write(here)
    for source in SOURCES.iterdir():
        shutil.copy(source, here)
    return here


@cache
def gcc() -> Compiler | None:
    """GCC, where the command is not clang under another name."""
    if shutil.which("gcc") is None:
        return None
    found = Compiler("gcc", ("gcc",))
    return None if "clang" in found.run("--version").stdout else found


@cache
def zig() -> Compiler | None:
    """The clang inside Zig, as the package ziglang brings it."""
    if importlib.util.find_spec("ziglang") is None:
        return None
    command = (sys.executable, "-m", "ziglang", "cc", "-fno-sanitize=all")
    return Compiler("clang", command, dashes="_")


@cache
def clang() -> Compiler | None:
    """The system's clang, or else the one inside Zig."""
    return Compiler("clang", ("clang",)) if shutil.which("clang") else zig()


def needed(name: str) -> Compiler:
    """A compiler by name; the test is skipped where there is none."""
    found = {"gcc": gcc, "clang": clang, "zig": zig}[name]()
    if found is None:
        pytest.skip(f"no {name} here" + (": pip install ziglang" if name != "gcc" else ""))
    return found


def for_32_bits() -> Compiler:
    """A compiler for 32-bit x86 with musl, whose programs need nothing else to run."""
    found = needed("zig")
    return replace(found, command=(*found.command, "-target", "x86-linux-musl"))
