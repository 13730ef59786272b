"""Builds of the C sources: no warnings, no globals, right states under hostile options."""

import re
import shutil
import subprocess
from dataclasses import dataclass
from itertools import product

import numpy as np
import pytest
from compilers import (
    FAST,
    PLAIN,
    PORTABLE,
    REPORTS,
    STRICT,
    X86,
    either,
    for_32_bits,
    needed,
    written,
)
from regimes import are_right, errors

from rigidsym._codegen.targets.c import module
from rigidsym._engines.build import ANY_MOMENTS

PROGRAM = ("driver.c", "torque_free.c")
# With several lanes, as only builds for wide registers have them.
SANITIZED = (
    *("-std=c99", "-O1", ANY_MOMENTS),
    "-DTORQUE_FREE_LANES=4",
    "-fsanitize=address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
)
MATHEMATICS = {"exp", "exp2", "fma", "fmax", "fmin", "frexp", "ilogb", "ldexp", "log", "log2"}
MATHEMATICS |= {"sqrt"}
# What compilers call by themselves.
UNASKED = {"memset", "memcpy", "memmove", "__stack_chk_fail"}
TO_VECTORISE = ("circular_angles", "circular_state", "hyperbolic_angles", "hyperbolic_state")
# The clang inside Zig knows no -fsyntax-only that writes nothing.
OBJECT = "-c"
CPP = ("-Wall", "-Wextra", "-Wpedantic", "-Werror", "-x", "c++")
SOURCES = (*module.SOURCES.values(), "driver.c", "fuzz.c", "both.c")
# What clang says hardly depends on the level, and moments change no line that is optimised: what
# only optimisers see there is looked for in slow tests.
CLEAN = [
    *((name, source, (*STRICT, "-O0")) for name in ("gcc", "clang") for source in SOURCES),
    *(("gcc", source, (*STRICT, "-O3")) for source in module.SOURCES.values()),
    *(
        (name, source, (*STRICT, ANY_MOMENTS, OBJECT))
        for name, source in product(("gcc", "clang"), module.SOURCES.values())
    ),
    *((name, "torque_free.c", ("-std=c++20", *CPP)) for name in ("gcc", "clang")),
    *((name, "torque_free.c", ("-std=c++11", *CPP, OBJECT)) for name in ("gcc", "clang")),
    *(
        pytest.param(name, source, (*STRICT, level), marks=pytest.mark.slow)
        for source in module.SOURCES.values()
        for name, level in (("gcc", "-O2"), ("clang", "-O2"), ("clang", "-O3"))
    ),
    *(
        pytest.param(name, source, flags, marks=pytest.mark.slow)
        for name in ("gcc", "clang")
        for source, flags in (
            *((source, (*STRICT, "-O0", ANY_MOMENTS)) for source in module.SOURCES.values()),
            ("torque_free.c", ("-std=c++11", *CPP)),
        )
    ),
]


@pytest.mark.parametrize(("name", "source", "flags"), CLEAN)
def test_no_compiler_has_anything_to_say(name, source, flags, here):
    if OBJECT in flags:
        done = needed(name).run(*flags, "-o", here / "object.o", here / source)
        assert (done.returncode, done.stderr) == (0, "")
        return
    made, said = needed(name).compiled(here / source, *flags)
    assert (made.exists(), said) == (True, "")


@pytest.fixture(scope="module", params=[*product(REPORTS, ["x86-64", "x86-64-v3"])], ids=" ".join)
def compiled(request, here):
    """Return an optimised object, and the compiler's report on its loops."""
    name, machine = request.param
    flags = ("-std=c99", *FAST, *needed(name).machine(machine), REPORTS[name])
    return needed(name).compiled(here / "torque_free.c", *flags)


def test_it_needs_nothing_but_libm_and_has_no_variables(compiled):
    if shutil.which("nm") is None:
        pytest.skip("no nm here")
    listing = subprocess.run(["nm", compiled[0]], capture_output=True, text=True, check=True)
    symbols = re.findall(r"([A-Za-z]) (\S+)$", listing.stdout, re.MULTILINE)
    assert {symbol for kind, symbol in symbols if kind == "U"} <= MATHEMATICS | UNASKED
    assert not [symbol for kind, symbol in symbols if kind in "BbDdCSsG"]
    assert all(s.startswith("torque_free_") for kind, s in symbols if kind == "T")


def test_the_loops_vectorise(compiled, here):
    lines = (here / "torque_free.c").read_text().splitlines()

    def function_at(line):
        heads = (re.match(r"(?:static )?(?:inline )?\w[\w ]*?\*?(\w+)\(", x) for x in lines[:line])
        return [head[1] for head in heads if head][-1]

    found = re.findall(r"torque_free\.c:(\d+):.*vectorized", compiled[1])
    assert set(TO_VECTORISE) <= {function_at(int(line)) for line in found}


def driven(program, motions, more=""):
    """Return codes and states (n, 7) by a driver for each motion, and for a further line."""
    lines = "".join(case.line() for case, _ in motions) + more
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    rows = (line.split() for line in done.stdout.splitlines())
    return [(code, np.array([*map(float.fromhex, x)]).reshape(-1, 7)) for code, *x in rows]


def check_driven(program, motions):
    for (case, exact), (code, found) in zip(motions, driven(program, motions), strict=True):
        assert code == "0"
        assert are_right(found, exact), case


def test_sanitizers_find_nothing(here, exact_motions):
    """States are right, without undefined behaviour, bad addresses or casts."""
    check_driven(needed("gcc").linked(here, *SANITIZED, sources=PROGRAM), exact_motions)


@pytest.mark.parametrize(
    "flags", [SANITIZED, (*PLAIN, ANY_MOMENTS), PORTABLE], ids=["sanitized", "fast", "bodies"]
)
def test_arbitrary_bits_are_refused_or_move(flags, here):
    program = needed("gcc").linked(here, *flags, sources=("fuzz.c", "torque_free.c"))
    done = subprocess.run(
        [program, "200000", "1"], capture_output=True, text=True, timeout=600, check=False
    )
    assert (done.returncode, done.stderr) == (0, ""), done.stdout[-2000:]
    counts = list(map(int, done.stdout.split()))
    assert all(count > 50 for code, count in enumerate(counts[:8]) if code != 4), counts
    # Moments that no body has are refused in their words, or not at all.
    assert counts[10] > 50 if ANY_MOMENTS not in flags else counts[8:] == [0] * 4, counts


def test_both_modules_go_into_one_programme(here):
    """Their states of one motion agree."""
    sources = ("both.c", "torque_free.c", "torque_free_pi.c")
    program = either().linked(here, *PORTABLE, sources=sources)
    told = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    one, other = ([float(x) for x in line.split()] for line in told.splitlines())
    assert one == pytest.approx(other, abs=3e-15)


@pytest.mark.slow  # a C library for 32 bits is compiled first
def test_on_32_bits_with_sse_states_are_right(here, exact_motions):
    flags = ("-std=c99", "-O2", "-msse2", "-mfpmath=sse")
    program = for_32_bits().linked(here, *flags, sources=PROGRAM)
    try:
        runs = subprocess.run([program], input="", text=True, check=False).returncode == 0
    except OSError:
        runs = False
    if not runs:
        pytest.skip("programs for 32-bit x86 do not run here")
    check_driven(program, exact_motions)


def test_arithmetic_of_80_bits_is_refused(here):
    made, said = for_32_bits().compiled(here / "torque_free.c", "-mcpu=i686")
    assert not made.exists()
    assert "-mfpmath=sse" in said


@pytest.mark.parametrize(
    ("name", "flag"), [("gcc", "-ffast-math"), ("gcc", "-Ofast"), ("clang", "-ffast-math")]
)
def test_fast_math_is_refused(name, flag, here):
    made, said = needed(name).compiled(here / "torque_free.c", flag)
    assert not made.exists()
    assert "compile without it" in said


# --- options that are hostile to extended numbers: each build is right or refuses every motion

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
HOSTILE = {
    "gcc": (
        *EVERYWHERE,
        "-Ofast -ftrapping-math",
        "-Ofast -fno-unsafe-math-optimizations",
        "-fsingle-precision-constant",
        "-mfpmath=387",
        "-mfpmath=both",
        "-mrecip -funsafe-math-optimizations",
    ),
    "clang": (
        *EVERYWHERE,
        "-ffp-model=fast",
        "-fno-honor-nans -fno-honor-infinities",
        "-fapprox-func",
        "-fdenormal-fp-math=preserve-sign",
        "-mrecip=all -freciprocal-math",
    ),
}
# Parts of those above, options that promise more than the usual ones or mean nothing to this code,
# levels between, and another clang.
PARTS = (
    "-funsafe-math-optimizations -fno-reciprocal-math",
    "-funsafe-math-optimizations -fno-associative-math",
    f"{ASSOCIATIVE} -ffp-contract=fast",
    "-flto",
    "-frounding-math",
)
MORE = {
    "gcc": (
        *PARTS,
        "-Ofast -fno-fast-math",
        "-funroll-loops -fvariable-expansion-in-unroller",
        "-ffloat-store",
        "-fcx-limited-range",
    ),
    "clang": (*PARTS, "-ffp-model=strict"),
    "zig": WORST,
}
BOTH = ("gcc", "clang")
OPTIONS = [
    *((name, f"{OPTIMISED} {options}") for name in HOSTILE for options in HOSTILE[name]),
    *((name, f"-O0 {options}") for name in BOTH for options in WORST),
    *(
        pytest.param(name, options, marks=pytest.mark.slow)
        for name, options in (
            *((name, f"{OPTIMISED} {options}") for name in MORE for options in MORE[name]),
            *product(BOTH, [f"{level} {x}" for level in ("-O1", "-O2") for x in WORST]),
        )
    ),
]
NOT_FINITE = " ".join(["nan", *["1"] * 9, "0"]) + "\n"
for_x86 = pytest.mark.skipif(not X86, reason="these are options for x86")


@dataclass(frozen=True, slots=True)
class Outcome:
    """The reason why the compiler refused a build, or the build's codes and worst errors."""

    refusal: str
    codes: frozenset[str] = frozenset()
    worst: tuple[float, float] = (0.0, 0.0)
    takes_nan: bool = False

    def is_right(self) -> bool:
        return self.codes == {"0"} and max(self.worst) <= 2e-15 and not self.takes_nan

    def is_refused(self) -> bool:
        # By the compiler: what a linker misses has no line and column.
        said = re.search(r"torque_free(_arithmetic\.h|\.c):\d+:\d+: ", self.refusal)
        return said is not None or self.codes == {ARITHMETIC}


def outcome(here, name, options, motions):
    """Build and run a program; loading a library could set the processor's flags."""
    program, said = needed(name).built(here, *options.split(), sources=PROGRAM)
    if not program.exists():
        return Outcome(said or "no reason")
    *rows, (nan, _) = driven(program, motions, NOT_FINITE)
    worst = [(0.0, 0.0)]
    for (code, states), (_, exact) in zip(rows, motions, strict=True):
        if code == "0":
            worst.append(errors(states, exact) if np.isfinite(states).all() else (9.0, 9.0))
    codes = frozenset(code for code, _ in rows)
    angle, rate = map(max, zip(*worst, strict=True))
    return Outcome("", codes, (angle, rate), nan == "0")


@for_x86
@pytest.mark.parametrize(("name", "options"), OPTIONS)
def test_a_build_is_right_or_refuses(name, options, here, exact_motions):
    found = outcome(here, name, options, exact_motions[::2])
    if "unknown" in found.refusal or "unsupported" in found.refusal:
        pytest.skip(f"{name} has no such option: {options}")
    assert found.is_right() or found.is_refused(), found


@for_x86
@pytest.mark.parametrize(
    ("name", "options"), [("gcc", ASSOCIATIVE), ("gcc", UNSAFE_ALONE), ("clang", ASSOCIATIVE)]
)
def test_without_its_question_a_build_would_be_wrong(name, options, once, exact_motions):
    """Without the test of arithmetic, states are wrong under options that define no macro."""
    here = once("c_unasked", unasked)
    found = outcome(here, name, f"-w {OPTIMISED} {options}", exact_motions[::2])
    if found.refusal:
        pytest.skip(f"this {name} tells of it by a macro")
    assert found.codes == {"0"}
    assert found.worst[0] > 1e-13


def unasked(folder):
    """Write the sources without their test of arithmetic."""
    written(folder)
    source = folder / "torque_free.c"
    source.write_text(source.read_text().replace("if (!is_rounded_once())", "if (0)"))


USUAL = (*STRICT, "-O0"), PORTABLE, ("-std=c99", *OPTIMISED.split(), "-ffp-contract=off")


@for_x86
@pytest.mark.parametrize("name", BOTH)
@pytest.mark.parametrize("flags", USUAL, ids=["-O0", "-O2", "-O3"])
def test_the_usual_builds_are_not_refused(name, flags, here, exact_motions):
    program = needed(name).linked(here, *flags, sources=PROGRAM)
    check_driven(program, exact_motions[::2])
    assert driven(program, [], NOT_FINITE)[0][0] != "0"


@for_x86
@pytest.mark.parametrize("name", BOTH)
def test_motions_are_not_prepared_in_other_roundings(name, here):
    program = needed(name).linked(here, *PORTABLE, sources=("rounding.c", "torque_free.c"))
    assert subprocess.run([program], check=False).returncode == 0
