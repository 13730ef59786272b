"""Builds by options that are hostile to extended numbers: each is right or refuses every motion."""

import subprocess
from dataclasses import dataclass

import numpy as np
import pytest
from compilers import PORTABLE, STRICT, X86, needed, written
from regimes import cases, errors

ANGLE = RATE = 2e-15
ARITHMETIC = "8"
OPTIMISED = "-O3 -march=native"
ASSOCIATIVE = "-fassociative-math -fno-signed-zeros -fno-trapping-math"
# y (x/y) becomes x, and not one quotient in five is right then.
UNSAFE_ALONE = "-funsafe-math-optimizations -fno-associative-math -fno-reciprocal-math"
WORST = (ASSOCIATIVE, UNSAFE_ALONE, "-freciprocal-math", "-ffp-contract=fast")
EVERYWHERE = (
    *WORST,
    "-Ofast",
    "-Ofast -fno-finite-math-only",
    "-ffast-math",
    "-ffast-math -fno-finite-math-only",
    "-ffast-math -fno-associative-math -fno-finite-math-only",
    "-funsafe-math-optimizations",
    f"{ASSOCIATIVE} -flto",
    "-ffinite-math-only",
)
GCC = (
    "-Ofast -ftrapping-math",
    "-Ofast -fno-unsafe-math-optimizations",
    "-fsingle-precision-constant",
    "-mfpmath=387",
    "-mfpmath=both",
    "-mrecip -funsafe-math-optimizations",
)
CLANG = (
    "-ffp-model=fast",
    "-fno-honor-nans -fno-honor-infinities",
    "-fapprox-func",
    "-fdenormal-fp-math=preserve-sign",
    "-mrecip=all -freciprocal-math",
)
LOWEST = [f"-O0 {options}" for options in WORST]
BUILDS = [
    *(("gcc", f"{OPTIMISED} {options}") for options in (*EVERYWHERE, *GCC)),
    *(("clang", f"{OPTIMISED} {options}") for options in (*EVERYWHERE, *CLANG)),
    *((name, options) for name in ("gcc", "clang") for options in LOWEST),
]
# Parts of those above, options that promise more than the usual ones or mean nothing to this code,
# levels between, and another clang.
PARTS = (
    "-funsafe-math-optimizations -fno-reciprocal-math",
    "-funsafe-math-optimizations -fno-associative-math",
    f"{ASSOCIATIVE} -ffp-contract=fast",
    "-flto",
    "-frounding-math",
)
PARTS_OF_GCC = (
    "-Ofast -fno-fast-math",
    "-funroll-loops -fvariable-expansion-in-unroller",
    "-ffloat-store",
    "-fcx-limited-range",
)
BETWEEN = [f"{level} {options}" for level in ("-O1", "-O2") for options in WORST]
MORE = [
    *(("gcc", f"{OPTIMISED} {options}") for options in (*PARTS, *PARTS_OF_GCC)),
    *(("clang", f"{OPTIMISED} {options}") for options in (*PARTS, "-ffp-model=strict")),
    *((name, options) for name in ("gcc", "clang") for options in BETWEEN),
    *(("zig", f"{OPTIMISED} {options}") for options in WORST),
]
NOT_FINITE = " ".join(["nan", *["1"] * 9, "0"]) + "\n"
pytestmark = pytest.mark.skipif(not X86, reason="these are options for x86")


@dataclass(frozen=True, slots=True)
class Outcome:
    """What the compiler refused a build for, or all codes of a build and its worst errors."""

    refusal: str
    codes: frozenset[str] = frozenset()
    worst: tuple[float, float] = (0.0, 0.0)
    takes_nan: bool = False

    def is_right(self) -> bool:
        return self.codes == {"0"} and self.worst <= (ANGLE, RATE) and not self.takes_nan

    def is_refused(self) -> bool:
        return "torque_free.c" in self.refusal or self.codes == {ARITHMETIC}


@pytest.fixture(scope="module")
def motions():
    """Motions of all kinds, up to 10^12 s."""
    return [(case, case.exact()) for case in cases()[::2]]


def outcome(here, name, options, motions):
    """Return what comes of a program: a library that is loaded may set the processor's flags."""
    compiler, flags = needed(name), options.split()
    made, said = compiler.compiled(here / "torque_free.c", *flags)
    if not made.exists():
        return Outcome(said or "no reason")
    program = compiler.linked(here, *flags, sources=("driver.c", "torque_free.c"))
    return driven(program, motions)


def driven(program, motions):
    lines = "".join(case.line() for case, _ in motions) + NOT_FINITE
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
    *rows, last = [line.split() for line in done.stdout.splitlines()]
    worst = [(0.0, 0.0)]
    for (code, *values), (_, exact) in zip(rows, motions, strict=True):
        if code == "0":
            states = np.array(list(map(float.fromhex, values))).reshape(-1, 7)
            worst.append(errors(states, exact) if np.isfinite(states).all() else (9.0, 9.0))
    angles, rates = zip(*worst, strict=True)
    codes = frozenset(code for code, *_ in rows)
    return Outcome("", codes, (max(angles), max(rates)), last[0] == "0")


SLOW = [pytest.param(build, marks=pytest.mark.slow) for build in MORE]


@pytest.mark.parametrize("build", [*BUILDS, *SLOW], ids=" ".join)
def test_a_build_is_right_or_refuses(build, here, motions):
    found = outcome(here, *build, motions)
    if "unknown" in found.refusal or "unsupported" in found.refusal:
        pytest.skip(f"{build[0]} has no such option: {build[1]}")
    assert found.is_right() or found.is_refused(), found


@pytest.mark.parametrize(
    "build", [("gcc", ASSOCIATIVE), ("gcc", UNSAFE_ALONE), ("clang", ASSOCIATIVE)], ids=" ".join
)
def test_without_its_question_a_build_would_be_wrong(build, once, motions):
    """The options above are hostile indeed, and no macro of these compilers tells of them."""
    name, options = build
    found = outcome(once("c_unasked", unasked), name, f"-w {OPTIMISED} {options}", motions)
    if found.refusal:
        pytest.skip(f"this {name} tells of it by a macro")
    assert found.codes == {"0"}
    assert found.worst[0] > 1e-13


def unasked(folder):
    """Write the sources without their question of how sums are rounded."""
    written(folder)
    source = folder / "torque_free.c"
    source.write_text(source.read_text().replace("if (!is_rounded_once())", "if (0)"))


USUAL = (*STRICT, "-O0"), PORTABLE, ("-std=c99", *OPTIMISED.split(), "-ffp-contract=off")


@pytest.mark.parametrize("name", ["gcc", "clang"])
@pytest.mark.parametrize("flags", USUAL, ids=["-O0", "-O2", "-O3"])
def test_the_usual_builds_are_not_refused(name, flags, here, motions):
    assert outcome(here, name, " ".join(flags), motions).is_right()


@pytest.mark.parametrize("name", ["gcc", "clang"])
def test_plans_are_not_made_in_other_roundings(name, here):
    program = needed(name).linked(here, *PORTABLE, sources=("rounding.c", "torque_free.c"))
    assert subprocess.run([program], check=False).returncode == 0
