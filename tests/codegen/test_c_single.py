"""C in single precision: its size, its errors, and the text it is made from."""

import re
import shutil
import subprocess
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen.formats import BINARY32, BINARY64
from rigidsym._codegen.functions import functions
from rigidsym._codegen.ir import Function, let
from rigidsym._codegen.passes import narrowed
from rigidsym._codegen.seal import seal, seal_text
from rigidsym._codegen.seal.structure import check_rounding
from rigidsym._codegen.targets.c_single.module import SIZES, STACKS, STEMS, doubled, single
from rigidsym.solution import sealed
from rigidsym.validate import STRATA, draw, measure_case
from rigidsym.validate._singles import ROOM
from rigidsym.validate.strata._singles import in_singles

HOME = Path(rigidsym.__path__[0]) / "generated"
FORMS = tuple(STEMS)
# Text at -Os in both forms together, in bytes.
MOST = 40_000
COMPILERS = {
    "gcc": (),
    "arm-linux-gnueabihf-gcc": ("-mthumb",),
    "arm-none-eabi-gcc": ("-mthumb", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"),
}


def compiled(name, folder, form, *flags):
    """Compile a module at -Os, and return the path of the object."""
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    path = folder / f"{form}.o"
    command = [name, "-std=c99", "-Os", "-Wall", "-Wextra", "-Werror", *COMPILERS[name], *flags]
    source = HOME / f"{STEMS[form]}.c"
    subprocess.run([*command, "-c", str(source), "-o", str(path)], check=True)
    return path


@pytest.mark.parametrize("name", COMPILERS)
def test_states_and_steps_take_less_than_40_kilobytes(name, tmp_path):
    sizes = {}
    for form in FORMS:
        path = compiled(name, tmp_path, form)
        said = subprocess.run(["size", str(path)], capture_output=True, text=True, check=False)
        if said.returncode:
            pytest.skip("binutils cannot read this object")
        text, data, bss, *_ = map(int, said.stdout.splitlines()[1].split()[:3])
        assert (data, bss) == (0, 0)
        sizes[form] = text
    assert sum(sizes.values()) <= MOST
    assert name != "gcc" or all(size <= 1000 * SIZES[form] for form, size in sizes.items())


@pytest.mark.parametrize("form", FORMS)
def test_no_call_takes_more_stack_than_the_header_says(form, tmp_path):
    path = compiled("gcc", tmp_path, form, "-fstack-usage")
    found = [line.split("\t") for line in path.with_suffix(".su").read_text().splitlines()]
    assert all(kind in ("static", "dynamic,bounded") for _, _, kind in found)
    # All routines at once take more than any call.
    assert sum(int(size) for _, size, _ in found) <= STACKS[form]


@pytest.mark.parametrize("form", FORMS)
def test_a_small_processor_without_floats_needs_no_doubles(form, tmp_path):
    name = "arm-none-eabi-gcc"
    if not shutil.which(name):
        pytest.skip(f"{name} is not installed")
    path = tmp_path / "m0.o"
    command = [name, "-std=c99", "-Os", "-mthumb", "-mcpu=cortex-m0", "-c"]
    subprocess.run([*command, str(HOME / f"{STEMS[form]}.c"), "-o", str(path)], check=True)
    said = subprocess.run(
        ["arm-none-eabi-nm", str(path)], capture_output=True, text=True, check=True
    )
    called = set(re.findall(r" U (\w+)", said.stdout))
    assert "__aeabi_fadd" in called
    assert not {name for name in called if re.match(r"__aeabi_(d|.2d)", name)}


@pytest.mark.parametrize("form", FORMS)
def test_constants_fit_into_the_room_that_validation_has_for_them(form, tmp_path):
    kind = "motion" if form == "theta" else "body"
    text = f'#include "{STEMS[form]}.h"\n'
    text += f"typedef char fits[sizeof(torque_free_single_{kind}) <= 4 * {ROOM} ? 1 : -1];\n"
    source = tmp_path / "size.c"
    source.write_text(text)
    command = ["gcc", "-std=c99", "-fsyntax-only", f"-I{HOME}", str(source)]
    if not shutil.which("gcc"):
        pytest.skip("gcc is not installed")
    subprocess.run(command, check=True)


# --- errors


@pytest.mark.parametrize("target", ["c_single", "c_single-step"])
@pytest.mark.parametrize("stratum", STRATA)
def test_errors_stay_within_a_millionth_of_a_radian(target, stratum):
    try:
        shares = [
            measure_case(draw(stratum, k, 5), 30, [target]).shares(target)
            for k in range(min(2, STRATA[stratum].size or 2))
        ]
    except InputError as error:
        pytest.skip(str(error))
    assert {"angle", "omega", "norm"} <= shares[0].keys()
    assert max(value for found in shares for value in found.values()) <= 1


@pytest.mark.parametrize("stratum", STRATA)
def test_samples_in_singles_are_bodies_in_floats(stratum):
    for k in range(min(8, STRATA[stratum].size or 8)):
        sample = in_singles(draw(stratum, k, 3))
        numbers = (*sample.inertia, *sample.omega0, *sample.attitude0)
        assert all(float(np.float32(x)) == x for x in numbers)
        a, b, c = sorted(map(Fraction, sample.inertia))
        assert 0 < a <= b <= c <= a + b
        assert a >= c / 2**20
        turned = max(map(abs, sample.times)) * float(np.linalg.norm(sample.omega0))
        assert turned <= 2.0**17


# --- text


@pytest.mark.parametrize("form", FORMS)
def test_words_for_doubles_and_floats_are_exchanged_without_loss(form):
    for end, first in ((".c", "static "), (".h", "enum {")):
        text = (HOME / f"{STEMS[form]}{end}").read_text()
        body = text[text.index(first) :]
        assert single(doubled(body)) == body
        code = re.sub(r"/\*.*?\*/", "", body, flags=re.DOTALL)
        assert not re.search(r"\bdouble|\buint64_t|\d\.\d+(e-?\d+)?(?![\df.e])", code)


@pytest.mark.parametrize(
    ("form", "old", "new"),
    [
        ("theta", "const float half = 0.5f;", "const float half = 0.25f;"),
        ("theta", "rounded", "unrounded"),
        ("theta", " * rest;", " * 2.0f * rest;"),
        (
            "theta",
            "state_after(motion, motion->unit * t, motion->unit * t_lo",
            "state_after(motion, motion->unit * t, 0.0f",
        ),
        ("step", "k < 7", "k < 6"),
        ("step", "(mixed << 10)", "(mixed << 11)"),
        ("step", "fmaf", "fma"),
    ],
)
def test_edits_are_refused(form, old, new):
    generated = generate("c_single", form=form)
    name = f"{STEMS[form]}.c"
    text = generated.files[name]
    assert old in text
    files = {**generated.files, name: text.replace(old, new, 1)}
    with pytest.raises(InputError):
        seal_text(replace(generated, files=files), sealed())


def test_the_pi_form_is_refused():
    with pytest.raises(InputError, match="form = pi: c_single has: theta, step"):
        generate("c_single", form="pi")


@pytest.mark.parametrize("form", FORMS)
def test_the_formulas_are_decided_for_floats_too(form):
    assert seal(sealed(), form, BINARY32) > 50


# --- what is computed with pairs


def example(*texts):
    lets = tuple(map(let, texts))
    return Function("_f", "", ("a", "b"), lets, ("p", "q"), frozenset("a"), frozenset("p"))


def test_only_what_is_handed_on_in_two_parts_is_computed_with_pairs():
    plain = example("c = a*b", "p = c + 1", "d = c*rounded(a)", "q = d/a")
    found = narrowed(plain)
    assert [str(x) for x in found.lets] == [
        "c = a * b",
        "p = c + 1",
        "a_rounded = rounded(a)",
        "c_rounded = rounded(c)",
        "d = c_rounded * a_rounded",
        "q = d / a_rounded",
    ]
    assert found.all_extended() == {"a", "c", "p"}
    check_rounding([plain], [found])
    spoiled = replace(found, lets=(*found.lets[:-1], let("q = d*a_rounded")))
    with pytest.raises(InputError, match="q = d"):
        check_rounding([plain], [spoiled])


def test_a_function_without_such_results_stays_as_it_is():
    plain = replace(example("c = a*b", "p = c + 1", "q = c/a"), split=frozenset())
    assert narrowed(plain) == plain


def test_formats_have_the_numbers_of_their_processors():
    numbers = BINARY32.numbers()
    kinds = {BINARY32: np.finfo(np.float32), BINARY64: np.finfo(np.float64)}
    for binary, known in kinds.items():
        numbers = binary.numbers()
        assert numbers["LARGEST"] == known.max
        assert numbers["LEAST"] == known.smallest_subnormal
        assert 2.0 ** numbers["LEAST_EXPONENT"] == known.smallest_normal
        assert binary.word == known.bits
    thirds = [BINARY32.pair(Fraction(1, 3)), BINARY64.pair(Fraction(1, 3))]
    assert thirds[0][0] == float(np.float32(1) / np.float32(3))
    for (high, low), digits in zip(thirds, (49, 107), strict=True):
        assert abs(Fraction(high) + Fraction(low) - Fraction(1, 3)) < 2.0**-digits


def test_sensitivities_are_doubles_alone():
    assert not any("moduli" in one.name for one in functions(sealed(), "theta", BINARY32))
