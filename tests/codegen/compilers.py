"""The C compilers at hand, gcc and clang, and what they build from the C target.

Objects, programs and libraries are named by a digest of all that they are made from, so that tests
share them.
"""

import fcntl
import importlib.util
import platform
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from hashlib import sha256
from pathlib import Path

import pytest

from rigidsym import generate
from rigidsym._codegen import forms

SOURCES = Path(__file__).parent / "c"
STRICT = (
    *("-std=c99", "-Werror", "-Wall", "-Wextra", "-Wpedantic"),
    *("-Wconversion", "-Wshadow", "-Wdouble-promotion"),
)
OURS = ("torque_free.c",)
# As many tests as can use the builds by these.
PORTABLE = ("-std=c99", "-O2", "-fPIC")
PLAIN = ("-std=c99", "-O1", "-fPIC")
# What compilers say of the loops that they vectorise.
REPORTS = {"gcc": "-fopt-info-vec", "clang": "-Rpass=loop-vectorize"}
X86 = platform.machine() in ("x86_64", "AMD64")


@dataclass(frozen=True, slots=True)
class Compiler:
    """A command, and how it spells the processors of a build."""

    name: str
    command: tuple[str, ...]
    dashes: str = "-"

    def machine(self, name: str) -> tuple[str, ...]:
        """Return the flags for `native`, `x86-64` or `x86-64-v3`, if there is such a thing."""
        if name != "native" and not X86:
            return ()
        return (f"-march={name.replace('-', self.dashes)}",)

    def run(self, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
        """Run the compiler, which need not succeed."""
        line = [*self.command, *map(str, arguments)]
        return subprocess.run(line, capture_output=True, text=True, check=False)

    def compiled(self, source: Path, *flags: str) -> tuple[Path, str]:
        """Return the object of a source, and what the compiler says of it.

        Compile each text by the same flags once in a run; there is no object where that fails.
        """
        made = self._once(".o", source.parent, (*flags, "-c"), [source], ())
        return made, made.with_suffix(".said").read_text("utf-8")

    def linked(self, here: Path, *flags: str, sources: Sequence[str] = OURS, end: str = "") -> Path:
        """Return a program of sources in `here`, or with the end `.so` a library."""
        objects = []
        for name in sources:
            made, said = self.compiled(here / name, *flags)
            assert made.exists(), said[-4000:]
            objects.append(made)
        shared = ("-shared",) if end else ()
        made = self._once(end or ".out", here, (*flags, *shared), objects, ("-lm",))
        assert made.exists(), made.with_suffix(".said").read_text("utf-8")[-4000:]
        return made

    def _once(
        self, end: str, here: Path, flags: Sequence[str], given: list[Path], last: Sequence[str]
    ) -> Path:
        texts = "\0".join((*self.command, *flags, *map(_included, given)))
        made = here / f"{sha256(texts.encode()).hexdigest()[:24]}{end}"
        said = made.with_suffix(".said")
        with made.with_suffix(".lock").open("w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not said.exists():
                # What is said of loops is of no object that another cache brings.
                fresh = (f"-DFRESH={time.time_ns()}",) if {*REPORTS.values()} & {*flags} else ()
                done = self.run(*flags, *fresh, *given, "-o", made, *last)
                assert made.exists() == (done.returncode == 0), done.stderr
                said.write_text(done.stderr, "utf-8")
        return made


def _included(path: Path) -> str:
    """Return a source with the sources that it includes, or the name of an object."""
    if path.suffix == ".o":
        return path.name
    text = path.read_text("utf-8")
    others = re.findall(r'^#include "(.*)"', text, re.MULTILINE)
    return "\0".join((path.name, text, *(_included(path.with_name(name)) for name in others)))


def written(here: Path) -> None:
    """Write the generated files of every form and ours into a directory."""
    for form in forms.FORMS:
        generate("c", form=form).write(here)
    for source in SOURCES.iterdir():
        shutil.copy(source, here)


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


def either() -> Compiler:
    """GCC, or else clang."""
    return needed("gcc" if gcc() else "clang")


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
