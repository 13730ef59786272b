"""The C target as compilers see it: clean, right in every regime, robust, self-contained."""

import math
import re
import shutil
import subprocess
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from compilers import PLAIN, PORTABLE, REPORTS, STRICT, either, for_32_bits, gcc, needed
from library import Library
from regimes import cases, errors

from rigidsym import TorqueFreeMotion
from rigidsym._codegen import forms
from rigidsym._codegen.targets.c import module
from rigidsym._engines.compiler import ANY_MOMENTS

ANGLE = RATE = 2e-15
# With several lanes, as only builds for wide registers have them.
SANITIZED = (
    *("-std=c99", "-O1", ANY_MOMENTS),
    "-DTORQUE_FREE_LANES=4",
    "-fsanitize=address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
)
FAST = ("-O3", "-fno-math-errno", "-fno-trapping-math")
BUILDS = {
    "gcc native": ("gcc", "native", ("-std=c99", *FAST, "-fPIC")),
    # GNU C fuses products and sums by itself where the machine can.
    "gcc native, GNU C": ("gcc", "native", ("-O3", "-fPIC")),
    "gcc portable": ("gcc", "", PORTABLE),
    "clang native": ("clang", "native", ("-std=c99", *FAST, "-fPIC")),
    "clang portable": ("clang", "", PORTABLE),
}
BODY = ((1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0))
MATHEMATICS = {
    "exp",
    "exp2",
    "fma",
    "fmax",
    "fmin",
    "frexp",
    "ilogb",
    "ldexp",
    "log",
    "log2",
    "sqrt",
}
# What compilers call by themselves.
UNASKED = {"memset", "memcpy", "memmove", "__stack_chk_fail"}
TO_VECTORISE = ("circular_angles", "circular_state", "hyperbolic_angles", "hyperbolic_state")


@pytest.fixture(scope="module")
def motions():
    """All cases with their true states."""
    return [(case, case.exact()) for case in cases()]


@pytest.fixture(scope="module")
def library(here):
    """Builds by name, each made and loaded once."""
    made = {}

    def get(name):
        if name not in made:
            kind, machine, flags = BUILDS[name]
            compiler = needed(kind)
            flags = (*flags, *(compiler.machine(machine) if machine else ()))
            made[name] = Library(compiler.linked(here, *flags, end=".so"))
        return made[name]

    return get


@pytest.fixture(params=BUILDS)
def built(request, library):
    return library(request.param)


@pytest.fixture(scope="module")
def any_library(library):
    return library("gcc portable" if gcc() else "clang portable")


@pytest.fixture(scope="module")
def of_any_moments(here):
    return Library(either().linked(here, *PLAIN, ANY_MOMENTS, end=".so"))


@pytest.mark.parametrize("name", ["gcc", "clang"])
@pytest.mark.parametrize("source", ["driver.c", "fuzz.c"])
def test_no_compiler_has_anything_to_say(name, source, here):
    made, said = needed(name).compiled(here / source, *STRICT)
    assert (made.exists(), said) == (True, "")


# What clang says does not depend on the level.
LEVELS = [
    *((name, "-O0", moments) for name in ("gcc", "clang") for moments in ("", ANY_MOMENTS)),
    ("gcc", "-O3", ""),
    *(
        pytest.param(name, level, "", marks=pytest.mark.slow)
        for name, level in (("gcc", "-O2"), ("clang", "-O2"), ("clang", "-O3"))
    ),
]


@pytest.mark.parametrize("form", forms.FORMS)
@pytest.mark.parametrize(("name", "level", "moments"), LEVELS)
def test_no_compiler_has_anything_to_say_of_any_module(name, level, moments, form, here):
    source = here / module.SOURCES[form]
    made, said = needed(name).compiled(source, *STRICT, level, *moments.split())
    assert (made.exists(), said) == (True, "")


@pytest.mark.parametrize("name", ["gcc", "clang"])
@pytest.mark.parametrize("standard", ["c++11", "c++20"])
def test_it_is_cpp_too(name, standard, here):
    flags = (f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-x", "c++")
    made, said = needed(name).compiled(here / "torque_free.c", *flags)
    assert (made.exists(), said) == (True, "")


@pytest.fixture(scope="module", params=[1, 8, 100])
def small(request, here):
    return Library(either().linked(here, *PLAIN, f"-DTORQUE_FREE_BLOCK={request.param}", end=".so"))


@pytest.mark.parametrize("omega0", [BODY[1], (0.75, 0.5, 1.0), (0, 1.0, 0)])
def test_blocks_of_any_size_have_the_same_states(small, omega0, any_library):
    _, prepared = any_library.prepare((1, 2, 2.25), omega0, (1, 0, 0, 0))
    times = np.linspace(-7, 30, 250)
    found, grid = small.states(prepared, times)[1], small.grid(prepared, 1.0, 0.1, 250)[1]
    assert np.abs(found - any_library.states(prepared, times)[1]).max() < 2e-15
    assert np.abs(grid - any_library.grid(prepared, 1.0, 0.1, 250)[1]).max() < 2e-15


@pytest.mark.parametrize("omega0", [BODY[1], (0.75, 0.5, 1.0), (0, 1.0, 0)])
def test_a_grid_in_parts_has_the_same_bits(omega0, any_library):
    _, prepared = any_library.prepare((1.0, 2.0, 2.25), omega0, (3.0, 0, -4.0, 0))
    _, whole = any_library.grid(prepared, -20.0, 0.25, 5000)
    parts = [
        any_library.grid(prepared, -20.0, 0.25, n, k)[1]
        for k, n in ((0, 64), (64, 4416), (4480, 520))
    ]
    assert np.array_equal(np.concatenate(parts), whole)


def test_parts_of_grids_that_are_too_far_are_refused(any_library):
    _, prepared = any_library.prepare(*BODY)
    assert any_library.grid(prepared, 0.0, 2.0**40, 2, 1)[0] == 0
    assert any_library.grid(prepared, 0.0, 2.0**40, 2, 200)[0] == 6


@pytest.fixture(scope="module", params=[*product(REPORTS, ["x86-64", "x86-64-v3"])], ids=" ".join)
def compiled(request, here):
    """An optimised object, and what the compiler says of its loops."""
    name, machine = request.param
    compiler = needed(name)
    flags = ("-std=c99", *FAST, *compiler.machine(machine), REPORTS[name])
    return compiler.compiled(here / "torque_free.c", *flags)


def test_it_needs_nothing_but_libm_and_has_no_variables(compiled):
    if shutil.which("nm") is None:
        pytest.skip("no nm here")
    listing = subprocess.run(["nm", compiled[0]], capture_output=True, text=True, check=True)
    symbols = re.findall(r"([A-Za-z]) (\S+)$", listing.stdout, re.MULTILINE)
    assert {symbol for kind, symbol in symbols if kind == "U"} <= MATHEMATICS | UNASKED
    assert not [symbol for kind, symbol in symbols if kind in "BbDdCSsG"]
    assert all(s.startswith("torque_free_") for kind, s in symbols if kind == "T")


def test_the_loops_vectorise(compiled, here):
    found = re.findall(r"torque_free\.c:(\d+):.*vectorized", compiled[1])
    within = {function_at(here, int(line)) for line in found}
    assert set(TO_VECTORISE) <= within


def function_at(here, line):
    """The function that a line of the source is in."""
    before = (here / "torque_free.c").read_text().splitlines()[:line]
    heads = [re.match(r"(?:static )?(?:inline )?\w[\w ]*?\*?(\w+)\(", text) for text in before]
    return [head[1] for head in heads if head][-1]


def states(built, case):
    code, prepared = built.prepare(case.inertia, case.omega0, case.attitude0)
    assert code == 0, case.name
    code, found = built.states(prepared, case.times)
    assert code == 0, case.name
    return found


def check(case, found, exact):
    angle, rate = errors(found, exact)
    assert (angle <= ANGLE, rate <= RATE) == (True, True), (case, angle, rate)


def test_states_are_right_in_every_regime(built, motions):
    assert len(motions) > 100
    for case, exact in motions:
        check(case, states(built, case), exact)


def driven(program, motions):
    """A driver's states for all cases."""
    lines = "".join(case.line() for case, _ in motions)
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    for line in done.stdout.splitlines():
        code, *values = line.split()
        assert code == "0"
        yield np.array(list(map(float.fromhex, values))).reshape(-1, 7)


def test_sanitizers_find_nothing(here, motions):
    """Undefined behaviour, bad addresses and casts, in every regime; and the states are right."""
    program = needed("gcc").linked(here, *SANITIZED, sources=("driver.c", "torque_free.c"))
    for (case, exact), found in zip(motions, driven(program, motions), strict=True):
        check(case, found, exact)


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


@pytest.mark.slow  # a C library for 32 bits is compiled first
def test_on_32_bits_with_sse_states_are_right(here, motions):
    flags = ("-std=c99", "-O2", "-msse2", "-mfpmath=sse")
    sources = ("driver.c", "torque_free.c")
    program = for_32_bits().linked(here, *flags, sources=sources)
    if not can_run(program):
        pytest.skip("programs for 32-bit x86 do not run here")
    for (case, exact), found in zip(motions, driven(program, motions), strict=True):
        check(case, found, exact)


def can_run(program):
    try:
        return subprocess.run([program], input="", text=True, check=False).returncode == 0
    except OSError:
        return False


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


NAN, INF, MOST = math.nan, math.inf, 1.7e308


@pytest.mark.parametrize(
    ("code", "inertia", "omega0", "attitude0"),
    [
        (1, (NAN, 1, 1), (0, 0, 1), (1, 0, 0, 0)),
        (1, (1, 1, 1), (0, -INF, 1), (1, 0, 0, 0)),
        (1, (1, 1, 1), (0, 0, 1), (1, 0, 0, INF)),
        (2, (1, 0.0, 1), (0, 0, 1), (1, 0, 0, 0)),
        (2, (1, 1, -5e-324), (0, 0, 1), (1, 0, 0, 0)),
        (3, (1, 1, 2.0**-201), (0, 0, 1), (1, 0, 0, 0)),
        (3, (5e-324, 1e308, 1e308), (0, 0, 1), (1, 0, 0, 0)),
        (4, (1, 1, 1), (0, 0, 1), (0, -0.0, 0, 0)),
        (7, (1, 2, 2.5), (MOST, MOST, MOST), (1, 0, 0, 0)),
    ],
)
def test_what_no_plan_is_made_of(code, inertia, omega0, attitude0, any_library):
    found, prepared = any_library.prepare(inertia, omega0, attitude0)
    assert found == code
    assert prepared.raw == bytes(len(prepared)), "a refused call writes nothing"
    assert len(any_library.message(code)) > 10


@pytest.mark.parametrize("rates", [(0, 1, 1e-130), (1e-125, 1, 1e-130), (5e-324, 1, 0)])
def test_times_after_which_a_spin_may_have_turned_over(rates, any_library):
    code, prepared = any_library.prepare((1, 2, 2.5), rates, (1, 0, 0, 0))
    assert code == 0
    code, found = any_library.states(prepared, [1.0, -400.0])
    assert code == 0
    np.testing.assert_array_equal(found[:, 4:], [rates, rates])
    code, found = any_library.states(prepared, [1.0, 4000.0])
    assert code == 5
    assert np.isnan(found).all(), "a refused call writes nothing"
    assert any_library.grid(prepared, 0.0, 1000.0, 5)[0] == 5


@pytest.mark.parametrize(
    ("bad", "expected"), [(NAN, 1), (INF, 1), (-INF, 1), (MOST, 6), (-(2.0**46) - 1, 6)]
)
@pytest.mark.parametrize("place", [0, 191, 192, 400])
def test_times_that_are_none_or_too_far(bad, expected, place, any_library):
    _, prepared = any_library.prepare((1, 2, 2.5), (0.3, 0.5, -1.0), (1, 0, 0, 0))
    times = np.linspace(0, 1, 401)
    times[place] = bad
    code, found = any_library.states(prepared, times)
    assert code == expected
    assert np.isnan(found).all(), "a refused call writes nothing"
    # Numbers that are none come first, wherever they stand.
    times[200] = MOST
    assert any_library.states(prepared, times)[0] == expected


@pytest.mark.parametrize("omega0", [(0.3, 0.5, -0.7), (0.75, 0.5, 1.0), (0, 0, 0), (0, 2.0, 0)])
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_a_motion_begins_at_its_start_to_the_last_bit(omega0, zero, any_library):
    _, prepared = any_library.prepare((1, 2, 2.25), omega0, (3.0, 0, -4.0, 0))
    code, found = any_library.states(prepared, [zero])
    assert code == 0
    assert found[0].tolist() == [0.6, 0, -0.8, 0, *omega0]


def test_faint_rates_are_there_at_the_start_whatever_the_largest(any_library):
    omega0 = (1e300, 1e-20, -3e-17)
    _, prepared = any_library.prepare((1, 2, 2.5), omega0, (1, 0, 0, 0))
    assert any_library.states(prepared, [0.0])[1][0, 4:].tolist() == list(omega0)


def test_a_body_at_rest_rests_for_ever(any_library):
    _, prepared = any_library.prepare((1, 2, 2.5), (0, 0, 0), (0, 1, 0, 0))
    code, found = any_library.states(prepared, [1e300, -MOST])
    assert code == 0
    assert found.tolist() == [[0, 1, 0, 0, 0, 0, 0]] * 2
    assert any_library.states(prepared, [INF])[0] == 1


@pytest.mark.parametrize("omega0", [BODY[1], (0.75, 0.5, 1.0), (0, 1.0, 0)])
@pytest.mark.parametrize("n", [0, 1, 63, 64, 65, 191, 192, 193, 383, 384, 385])
def test_a_state_does_not_depend_on_its_place_in_a_block(n, omega0, any_library):
    _, prepared = any_library.prepare((1, 2, 2.25), omega0, (1, 0, 0, 0))
    times = np.linspace(-7, 30, 400)[:n]
    code, found = any_library.states(prepared, times)
    assert code == 0
    # In turns of a loop that the compiler made wide and those left over, sums may differ in a bit.
    one_by_one = [any_library.states(prepared, [t])[1][0] for t in times]
    assert np.abs(found - np.reshape(one_by_one, (-1, 7))).max(initial=0) < 1e-15


def test_a_grid_of_one_sample_does_not_ask_its_step(built):
    _, prepared = built.prepare(*BODY)
    code, found = built.grid(prepared, 2.0, MOST, 1)
    assert code == 0
    assert np.array_equal(found, built.grid(prepared, 2.0, 0.25, 1)[1])


@pytest.mark.parametrize("omega0", [BODY[1], (0.75, 0.5, 1.0), (0, 1.0, 0)])
def test_a_grid_that_passes_zero_is_at_its_start_there(omega0, any_library):
    _, prepared = any_library.prepare((1.0, 2.0, 2.25), omega0, (3.0, 0, -4.0, 0))
    expected = [0.6, 0, -0.8, 0, *omega0]
    for start, step, at in ((-1.0, 0.5, [2]), (6.25, -0.125, [50]), (0.0, 1.0, [0])):
        found = any_library.grid(prepared, start, step, 100)[1]
        assert [k for k in range(100) if found[k].tolist() == expected] == at
    assert any_library.grid(prepared, 0.0, 0.0, 3)[1].tolist() == [expected] * 3


@pytest.mark.parametrize(
    ("code", "inertia", "omega0", "unit"),
    [
        (7, (1.0, 1.5, 1.2), (1e300, 0.0, 0.0), 1.0),
        (7, (1.0, 1.5, 1.2), (1.0, 0.5, 0.1), -3.0),
        (7, (1.0, 1.5, 1.2), (1.0, 0.5, 0.1), 0.0),
        (3, (1.0, 1.5, 1e-70), (1.0, 0.5, 0.1), 1.0),
        (1, (1.0, 1.5, 1.2), (NAN, 0.5, 0.1), 1.0),
        (2, (1.0, -1.5, 1.2), (1.0, 0.5, 0.1), 1.0),
    ],
)
def test_pairs_that_no_plan_is_made_of(code, inertia, omega0, unit, any_library):
    given = (inertia, differences(inertia), omega0, (1.0, 0, 0, 0))
    pairs = [[(x, 0.0) for x in values] for values in given]
    found, prepared = any_library.plan_of_pairs(*pairs, (0.1, 0.0), unit=unit)
    assert found == code
    assert prepared.raw == bytes(len(prepared)), "a refused call writes nothing"


def differences(inertia):
    return [inertia[k] - inertia[(k + 1) % 3] for k in range(3)]


def test_grids_are_right_in_every_regime(built, motions):
    for case, _ in motions[::7]:
        _, prepared = built.prepare(case.inertia, case.omega0, case.attitude0)
        n, start, step = 130, case.times[0] / 4, case.times[0] / 400
        code, found = built.grid(prepared, start, step, n)
        assert code == 0, case.name
        picked = [0, 1, 63, 64, 129]
        check(case, found[picked], exact_grid(case, start, step, picked))


def exact_grid(case, start, step, picked):
    motion = TorqueFreeMotion(case.inertia, case.omega0, case.attitude0)
    return motion.precise([Fraction(start) + k * Fraction(step) for k in picked], 40)


def test_pairs_begin_where_doubles_do(any_library):
    """With no low parts, and the discriminant of these numbers, states are the same."""
    (d, b, a), (rate_d, _, rate_a), _ = BODY
    discriminant = a * (a - b) * rate_a**2 - d * (b - d) * rate_d**2
    given = (BODY[0], differences(BODY[0]), *BODY[1:])
    pairs = [[(x, 0.0) for x in values] for values in given]
    code, prepared = any_library.plan_of_pairs(*pairs, (discriminant, 0.0), unit=1.0)
    assert code == 0
    _, found = any_library.states(prepared, [0.0, 1.0, 50.0])
    _, other = any_library.prepare(*BODY)
    assert np.abs(found - any_library.states(other, [0.0, 1.0, 50.0])[1]).max() < 1e-14


def test_bodies_that_cannot_exist_are_refused_times_they_turn_too_often_by(of_any_moments):
    any_library = of_any_moments
    code, prepared = any_library.prepare((1.0, 2.0**-60, 2.0**-90), (1.0, 0.5, 0.1), (1, 0, 0, 0))
    assert code == 0
    assert any_library.states(prepared, [2.0**40])[0] == 6
    code, found = any_library.states(prepared, [2.0**-40])
    assert code == 0
    assert abs(np.linalg.norm(found[0, :4]) - 1) < 1e-15
