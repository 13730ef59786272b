"""C compilers at hand, gcc and clang, and their builds of the C target.

Files are named by a digest of all that they are made from, so that the tests of a run share them.
"""

import ctypes
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
from itertools import chain
from pathlib import Path

import numpy as np
import pytest

from rigidsym import generate
from rigidsym._codegen import forms
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.targets.c import module
from rigidsym._codegen.targets.c.program import program
from rigidsym._engines import library
from rigidsym.solution import sealed

SOURCES = Path(__file__).parent / "c"
STRICT = (
    *("-std=c99", "-Werror", "-Wall", "-Wextra", "-Wpedantic"),
    *("-Wconversion", "-Wshadow", "-Wdouble-promotion"),
)
OURS = ("torque_free.c",)
# As many tests as can use the builds by these.
PORTABLE = ("-std=c99", "-O2", "-fPIC")
PLAIN = ("-std=c99", "-O1", "-fPIC")
FAST = ("-O3", "-fno-math-errno", "-fno-trapping-math")
# Builds of libraries: compiler, machine, flags.
BUILDS = {
    "gcc native": ("gcc", "native", ("-std=c99", *FAST, "-fPIC")),
    # GNU C fuses products and sums by itself where the machine can.
    "gcc native, GNU C": ("gcc", "native", ("-O3", "-fPIC")),
    "gcc portable": ("gcc", "", PORTABLE),
    "clang native": ("clang", "native", ("-std=c99", *FAST, "-fPIC")),
    "clang portable": ("clang", "", PORTABLE),
}
# What compilers say of the loops that they vectorise.
REPORTS = {"gcc": "-fopt-info-vec", "clang": "-Rpass=loop-vectorize"}
X86 = platform.machine() in ("x86_64", "AMD64")
# Memory that every struct of constants fits, and rates and an attitude that serve most tests.
ROOM = 8192
RATES, ATTITUDE = (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Compiler:
    """A compiler: its name, its command, and its spelling of processors."""

    name: str
    command: tuple[str, ...]
    dashes: str = "-"

    def machine(self, name: str) -> tuple[str, ...]:
        """Return the flags for `native`, `x86-64` or `x86-64-v3`, if there is such a thing."""
        if not name or (name != "native" and not X86):
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
        return self._once(".o", source.parent, (*flags, "-c"), [source], ())

    def built(self, here: Path, *flags: str, sources: Sequence[str]) -> tuple[Path, str]:
        """Return a program of sources by one start of the compiler, and what that says."""
        return self._once(".out", here, flags, [here / name for name in sources], ("-lm",))

    def linked(self, here: Path, *flags: str, sources: Sequence[str] = OURS, end: str = "") -> Path:
        """Return a program of sources in `here`, or with the end `.so` a library.

        Objects are shared with all that is built of the same sources by the same flags.
        """
        objects = []
        for name in sources:
            made, said = self.compiled(here / name, *flags)
            assert made.exists(), said[-4000:]
            objects.append(made)
        shared = ("-shared",) if end else ()
        made, said = self._once(end or ".out", here, (*flags, *shared), objects, ("-lm",))
        assert made.exists(), said[-4000:]
        return made

    def _once(
        self, end: str, here: Path, flags: Sequence[str], given: list[Path], last: Sequence[str]
    ) -> tuple[Path, str]:
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
        return made, said.read_text("utf-8")


def _included(path: Path) -> str:
    """Return a source with the sources that it includes, or the name of an object."""
    if path.suffix == ".o":
        return path.name
    text = path.read_text("utf-8")
    others = re.findall(r'^#include "(.*)"', text, re.MULTILINE)
    return "\0".join((path.name, text, *(_included(path.with_name(name)) for name in others)))


def written(here: Path) -> None:
    """Write the C sources of all forms, their exact numbers alone, and those of tests."""
    for form in forms.FORMS:
        generate("c", form=form).write(here)
    (here / "exact_numbers.c").write_text(_exact_numbers(), "utf-8")
    for source in SOURCES.iterdir():
        shutil.copy(source, here)


def _exact_numbers() -> str:
    form = forms.THETA
    made = program(functions(sealed(), form), constants(), form)
    printer = module.Files(made, form).printer
    names = ("grown", "exact_of", "exact_sub_xx", "exact_mul_xx")
    routines = (printer.routine(made.routines[name]).text for name in names)
    return "\n".join([printer.struct(made.structs["exact"]), "", *chain.from_iterable(routines)])


class Library:
    """A compiled module, called with sequences and arrays."""

    def __init__(
        self, compiler: Compiler, here: Path, *flags: str, form: str = forms.THETA
    ) -> None:
        header, source = module.HEADERS[form], module.SOURCES[form]
        path = compiler.linked(here, *flags, sources=(source,), end=".so")
        self.c = library.load(path, {header: (here / header).read_text("utf-8")})
        of_body = "body_init" in self.c.signatures
        assert (self.c.body_size() if of_body else self.c.motion_size()) <= ROOM

    def prepare(self, inertia, omega0=RATES, attitude0=ATTITUDE) -> tuple[int, ctypes.Array]:
        """Return the code for a motion, or for the body of a step, and the memory prepared."""
        room = ctypes.create_string_buffer(ROOM)
        if "body_init" in self.c.signatures:
            return self.c.body_init(room, numbers(inertia)), room
        return self.c.motion_init(room, *map(numbers, (inertia, omega0, attitude0))), room

    def prepare_pairs(self, *pairs, unit) -> tuple[int, ctypes.Array]:
        """Return the code for a motion of double-doubles, and the memory prepared."""
        room = ctypes.create_string_buffer(ROOM)
        return self.c.motion_init_double_doubles(room, *map(numbers, pairs), unit), room

    def states(self, prepared, times) -> tuple[int, np.ndarray]:
        """Return a code, and the states: rows of seven, NaN where nothing was written."""
        q, omega = np.full((len(times), 4), np.nan), np.full((len(times), 3), np.nan)
        code = self.c.states_at(prepared, len(times), numbers(times), q, omega)
        return code, np.hstack([q, omega])

    def grid(self, prepared, start, step, n, first=0) -> tuple[int, np.ndarray]:
        """Return a code, and the states at start + k step, k = first, first + 1, ..."""
        q, omega = np.full((n, 4), np.nan), np.full((n, 3), np.nan)
        code = self.c.states_on_grid(prepared, start, step, first, n, q, omega)
        return code, np.hstack([q, omega])

    def message(self, code: int) -> str:
        return self.c.message(code).decode()


def numbers(values: Sequence[float] | np.ndarray) -> np.ndarray:
    """Return an array of doubles."""
    return np.ascontiguousarray(values, dtype=float)


@cache
def gcc() -> Compiler | None:
    """Return GCC where the command is not clang under another name."""
    if shutil.which("gcc") is None:
        return None
    found = Compiler("gcc", ("gcc",))
    return None if "clang" in found.run("--version").stdout else found


@cache
def zig() -> Compiler | None:
    """Return the clang inside Zig, as the package ziglang brings it."""
    if importlib.util.find_spec("ziglang") is None:
        return None
    command = (sys.executable, "-m", "ziglang", "cc", "-fno-sanitize=all")
    return Compiler("clang", command, dashes="_")


@cache
def clang() -> Compiler | None:
    """Return the system's clang, or else the one inside Zig."""
    return Compiler("clang", ("clang",)) if shutil.which("clang") else zig()


def installed(command: str) -> str:
    """Return a command by name; the test is skipped where it is not installed."""
    return command if shutil.which(command) else pytest.skip(f"{command} is not installed")


def either() -> Compiler:
    """Return GCC, or else clang."""
    return needed("gcc" if gcc() else "clang")


def needed(name: str) -> Compiler:
    """Return a compiler by name; the test is skipped where there is none."""
    found = {"gcc": gcc, "clang": clang, "zig": zig}[name]()
    if found is None:
        pytest.skip(f"no {name} here" + (": pip install ziglang" if name != "gcc" else ""))
    return found


def for_32_bits() -> Compiler:
    """Return a compiler for 32-bit x86 with musl, whose programs need nothing else to run."""
    found = needed("zig")
    return replace(found, command=(*found.command, "-target", "x86-linux-musl"))
