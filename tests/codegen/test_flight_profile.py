"""Unit tests, bits, shape, records and checks of the flight profile."""

import ast
import ctypes
import json
import math
import re
import shutil
import subprocess
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from importlib import resources
from pathlib import Path

import mpmath
import numpy as np
import pytest
from compilers import installed
from test_seal_statements import edited

from rigidsym import generate
from rigidsym._codegen.flight import read_back, records, report
from rigidsym._codegen.flight.module import HEADER, SOURCE, code
from rigidsym._codegen.flight.printer import FlightPrinter
from rigidsym._codegen.flight.profile import files
from rigidsym._codegen.flight.program import MOST_LINES, PREFIX, lines, names, program
from rigidsym._codegen.flight.trace import facts, rows
from rigidsym._codegen.flight.vectors import of_motions, of_steps, vectors
from rigidsym._codegen.functions import functions
from rigidsym._codegen.lines import Lines, code_lines
from rigidsym._codegen.passes import fuse
from rigidsym._codegen.routines import let_of
from rigidsym._codegen.targets.c import reader
from rigidsym.errors import InputError
from rigidsym.precise import PreciseMotion
from rigidsym.solution import sealed

PAGES = Path(__file__).parents[2] / "notebooks" / "site" / "pages"
# Figures of a report, and where its page says them; those of compilers differ a little.
FIGURES = {
    r"(\d+) tests, 0 failures": r"(\d+) of \d+; largest",
    r"coverage at least 95 % \| ([\d.]+) %": r"explained \| ([\d.]+) %",
    r"at most 60 lines \| (\d+)": r"at most 60 \| (\d+)",
    r"150000 bytes \| (\d+)\d{3} bytes": r"150 kB \| (\d+) kB",
    r"motion_init` \| (\d+) \|\n": r"(\d+) bytes to begin",
    r"state_at` \| (\d+) \|\n": r"motion, (\d+) for a state, \d+ for a step \|\n\| most",
    r"step` \| (\d+) \|\n": r"state, (\d+) for a step \|\n\| most",
    r"motion_init` \| \d+ \| (\d+)": r"(\d+) to begin",
    r"state_at` \| \d+ \| (\d+)": r"to begin a motion, (\d+) for a state, \d+ for a step \|\n\n",
    r"_step` \| \d+ \| (\d+)": r"state, (\d+) for a step \|\n\n",
}
# Debian's cross-compilers, and the processors that qemu emulates for them.
FOREIGN = {
    "aarch64-linux-gnu": "aarch64",
    "arm-linux-gnueabihf": "arm",
    "powerpc64-linux-gnu": "ppc64",
    "riscv64-linux-gnu": "riscv64",
    "s390x-linux-gnu": "s390x",
}
BITS = ("-std=c99", "-O1", "-ffp-contract=off")
needs_gcc = pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc here")


@pytest.fixture(scope="module")
def made():
    return program(sealed())


@pytest.fixture(scope="module")
def folder(once):
    """Return a folder with the files of the profile."""

    def write(here):
        for name, text in files().items():
            (here / name).write_text(text, "utf-8")

    return once("flight", write)


def built(folder, *more):
    """Build the unit tests of a folder, run them, and return what they print."""
    sources = (folder / SOURCE, folder / "test_torque_free.c")
    subprocess.run(["gcc", *BITS, *sources, "-o", folder / "tests", "-lm"], check=True)
    return subprocess.run([folder / "tests", *more], capture_output=True, text=True, check=False)


@needs_gcc
def test_the_unit_tests_pass(folder):
    done = built(folder)
    assert done.returncode == 0, done.stdout[-2000:]
    assert int(re.search(r"tests (\d+), failures 0", done.stdout)[1]) > 2000


FAULTS = {
    "a coefficient": (
        r"static const double cosine_2 = (\S+);",
        "static const double cosine_2 = 0.0;",
    ),
    "an axis": (r"const int third = .*;", "const int third = b;"),
    "a limit": (r"static const double max_step = \S+;", "static const double max_step = 100.0;"),
    "a check": (r"if \(motion->prepared != PREPARED\)", "if (false)"),
    "the separatrix": (
        r"static const double tolerated = \S+;",
        "static const double tolerated = 1.0;",
    ),
    "an assertion": (r"if \(!holds\) \{", "if (false) {"),
}


@needs_gcc
@pytest.mark.parametrize("fault", FAULTS)
def test_the_unit_tests_see_faults(fault, folder, tmp_path):
    pattern, replacement = FAULTS[fault]
    for name in (SOURCE, HEADER, "test_torque_free.c"):
        shutil.copy(folder / name, tmp_path)
    text = (folder / SOURCE).read_text("utf-8")
    changed, count = re.subn(pattern, replacement, text, count=1)
    assert count == 1
    (tmp_path / SOURCE).write_text(changed, "utf-8")
    assert built(tmp_path).returncode != 0


class Functions:
    """Functions for motions and steps in a shared library, by ctypes."""

    def __init__(self, path):
        self.found = ctypes.CDLL(str(path))
        self.room = ctypes.create_string_buffer(8192)

    def __call__(self, name, *given):
        kinds = {float: ctypes.c_double, np.ndarray: lambda x: x.ctypes.data_as(ctypes.c_void_p)}
        return getattr(self.found, PREFIX + name)(
            *(kinds.get(type(x), lambda x: x)(x) for x in given)
        )

    def state(self, vector):
        q, omega = np.zeros(4), np.zeros(3)
        code = self("motion_init", self.room, *map(np.array, vector.given))
        return code or self("state_at", self.room, vector.time, q, omega), *q, *omega

    def step(self, vector):
        inertia, omega, q = map(np.array, vector.given)
        code = self("body_init", self.room, inertia)
        return code or self("step", self.room, q, omega, vector.time), *q, *omega


@needs_gcc
def test_states_and_steps_have_the_bits_of_the_library_without_fused_products(folder, tmp_path):
    stub = tmp_path / "stub.c"
    stub.write_text(
        "#include <stdint.h>\nvoid torque_free_assertion_failed(int32_t x) { (void)x; }\n"
    )
    paths = []
    for form in ("theta", "step"):
        paths += generate("c", form=form).write(tmp_path)
    sources = [path for path in paths if path.suffix == ".c"]
    for name, own in {"flight": [folder / SOURCE, stub], "library": sources}.items():
        line = ["gcc", *BITS, "-DTORQUE_FREE_FMA=0", "-shared", "-fPIC", *own]
        subprocess.run([*line, "-o", tmp_path / f"{name}.so", "-lm"], check=True)
    flight, library = Functions(tmp_path / "flight.so"), Functions(tmp_path / "library.so")
    for vector in of_motions():
        np.testing.assert_array_equal(flight.state(vector), library.state(vector), vector.name)
    for vector in of_steps():
        np.testing.assert_array_equal(flight.step(vector), library.step(vector), vector.name)


@needs_gcc
@pytest.mark.slow
@pytest.mark.parametrize("target", FOREIGN)
def test_the_unit_tests_pass_with_the_same_bits_on_other_processors(target, folder, tmp_path):
    sources = (folder / SOURCE, folder / "test_torque_free.c")
    build = [installed(f"{target}-gcc"), *BITS, "-static", *sources, "-o", tmp_path / "tests"]
    subprocess.run([*build, "-lm"], check=True)
    run = [installed(f"qemu-{FOREIGN[target]}"), tmp_path / "tests"]
    done = subprocess.run(run, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, built(folder).stdout)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["gcc", "clang"])
def test_the_bits_are_the_same_with_all_optimisation(name, folder, tmp_path):
    sources = (folder / SOURCE, folder / "test_torque_free.c")
    flags = ("-std=c99", "-O3", "-march=native", "-ffp-contract=off")
    line = [installed(name), *flags, *sources, "-o", tmp_path / "tests", "-lm"]
    subprocess.run(line, check=True)
    done = subprocess.run([tmp_path / "tests"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, built(folder).stdout)


def test_vectors_are_the_nearest_doubles():
    for vector in list(of_motions(cases=1, times=2))[::5]:
        motion = PreciseMotion(*(tuple(map(Fraction, x)) for x in vector.given))
        ((q, omega),) = motion.states([Fraction(vector.time) + Fraction(vector.more)], 60)
        with mpmath.workdps(80):
            apart = [
                abs(mpmath.mpf(x) - y) for x, y in zip(vector.state, (*q, *omega), strict=True)
            ]
        halves = [mpmath.mpf(math.ulp(x)) / 2 for x in vector.state]
        assert all(x <= y for x, y in zip(apart, halves, strict=True)), vector.name


# --- the shape of the code


def test_functions_are_short_and_call_nothing_in_a_circle(made):
    assert max(lines(one, made) for one in made.routines.values()) <= MOST_LINES
    known = set()
    for name, one in made.routines.items():
        assert one.calls() & made.routines.keys() <= known, name
        known.add(name)


def test_pieces_have_the_assignments_of_the_derived_functions(made):
    """Each function, whole or in pieces, has the statements of the derivation, in their order."""
    found = {}
    for name, one in made.routines.items():
        nodes = (node for part in one.body for node in ast.walk(part))
        lets = [let_of(node) for node in nodes if isinstance(node, ast.stmt) and let_of(node)]
        found.setdefault(re.sub(r"_\d+$", "", name), []).extend(lets)
    derived = {x.name[1:]: x for form in ("theta", "step") for x in functions(sealed(), form)}
    having = {name: tuple(lets) for name, lets in found.items() if lets}
    assert having.keys() - derived.keys() == {"discriminant_dd", "discriminant_exact"}
    for name in having.keys() & derived.keys():
        assert having[name] == fuse(derived[name]), name


def test_every_loop_has_a_bound(made):
    loops = [
        node
        for one in made.routines.values()
        for part in one.body
        for node in ast.walk(part)
        if isinstance(node, ast.For | ast.While)
    ]
    assert loops
    assert all(ast.unparse(loop.iter).startswith("range(") for loop in loops)


def test_pointers_and_indices_are_asserted(made):
    printer = FlightPrinter(made, PREFIX, names())
    for one in made.routines.values():
        text = "\n".join(printer.routine(one).text)
        if one.is_public:
            pointers = [x for x, t in one.parameters.items() if t.is_struct or t.shape]
            assert all(f"require({x} != NULL, __LINE__);" in text for x in pointers)
    text = "\n".join(printer.routine(made.routines["difference"]).text)
    assert "require((uint32_t)j < 3u, __LINE__);" in text


EDITS = {
    "a comparison": ("(x.hi > y.hi)", "(x.hi >= y.hi)"),
    "a sign": ("+ (b - c)", "- (b - c)"),
    "an index": ("axis[2] = third;", "axis[1] = third;"),
    "a number": ("= 4503599627370496.0;", "= 4503599627370497.0;"),
    "a statement": ("    motion->branch = 0;\n", ""),
    "an assertion": ("    require((uint32_t)k < 3u, __LINE__);\n", ""),
    "a choice": ("? (int)0 : (int)2", "? (int)2 : (int)0"),
    "a code": ("return TORQUE_FREE_STEP_ANGLE;", "return TORQUE_FREE_STEP_OK;"),
    "an argument": ("two_sum(x.hi, y.hi)", "two_sum(y.hi, x.hi)"),
    "a call": ("circular_constants_2(", "circular_constants_3("),
    "a loop": ("k < 3u; k++", "k < 2u; k++"),
    "a head": (
        "static double_double dd_neg(double_double x)",
        "static double_double dd_neg(double x)",
    ),
    "a message": ('"rates beyond what binary64 can hold"', '"rates"'),
}


@pytest.fixture(scope="module")
def printed():
    return code(sealed())


def test_the_text_reads_back_as_its_routines(printed):
    assert read_back.check(printed) == len(printed.program.routines)


@pytest.mark.parametrize("edit", EDITS)
def test_edits_of_the_text_are_refused(edit, printed):
    old, new = EDITS[edit]
    text = "\n".join(printed.source.text)
    assert old in text
    changed = Lines(tuple(text.replace(old, new, 1).split("\n")), {})
    with pytest.raises(InputError):
        read_back.check(replace(printed, source=changed))


def survivors(made, every):
    """Return the edits of one token that are accepted, and how many were made, of some lines."""
    printer, accepted, count, place = FlightPrinter(made, PREFIX, names()), [], 0, 0
    for one in made.routines.values():
        lines = list(printer.routine(one).text)
        for k in range(lines.index("{") + 1, len(lines) - 2):
            place += 1
            is_code = not lines[k].lstrip().startswith("/*") and re.search(r"[;{]", lines[k])
            for line in edited(lines[k]) if is_code and place % every == 0 else ():
                text = "\n".join([*lines[:k], line, *lines[k + 1 :]])
                count += 1
                with suppress(InputError, ValueError, KeyError):
                    root = reader.parsed(read_back.plain(text))
                    ((_, node),) = reader.functions(SOURCE, root)
                    read_back.check_body(text, node, one, printer)
                    accepted.append(f"{one.name}: {line.strip()}")
    return accepted, count


@pytest.mark.parametrize("every", [25, pytest.param(1, marks=pytest.mark.slow)])
def test_no_edit_of_a_token_is_accepted(every, made):
    accepted, count = survivors(made, every)
    assert accepted == []
    assert count > 1900 / every


# --- records


def test_records_are_of_lines_that_there_are(folder):
    text = (folder / SOURCE).read_text("utf-8")
    assert [x for x in records.UNREACHED if not re.search(x, text)] == []
    said = (folder / "DEVIATIONS.md").read_text("utf-8")
    assert all(f"| {rule} |" in said for rule in records.DEVIATIONS)
    assert not records.DEVIATIONS.keys() & report.ADVISORY


def test_the_page_counts_the_lines_written_by_hand():
    home = resources.files("rigidsym._codegen.flight")
    count = code_lines(home.joinpath("preamble.c").read_text("utf-8"), "c")
    assert f"* {count} lines of the source are written by hand" in (PAGES / "flight.md").read_text()


def test_every_requirement_has_functions_and_tests(made):
    found = list(rows(sealed(), made, vectors()))
    assert [row.name for row in found if not row.functions or row.tests.startswith("0 ")] == []
    assert len({row.name for row in found}) == len(found)
    derived = {one.name for one in made.routines.values() if facts(one)}
    assert derived == {name for row in found if row.theorems for name in row.functions} & derived
    public = {PREFIX + one.name for one in made.routines.values() if one.is_public}
    assert public <= {name for row in found for name in row.functions}


# --- the checks


@needs_gcc
@pytest.mark.slow
def test_the_report_meets_all_goals(folder):
    for tool in ("gcov", "valgrind", "cppcheck"):
        if shutil.which(tool) is None:
            pytest.skip(f"no {tool} here")
    assert report.main(folder) == 0
    text = (folder / "REPORT.md").read_text("utf-8")
    assert "**no**" not in text
    assert "**not" not in text
    assert text.count("| yes |") == 12
    page = (PAGES / "flight.md").read_text("utf-8")
    for pattern, said in FIGURES.items():
        found = [float(re.search(one, where)[1]) for one, where in ((pattern, text), (said, page))]
        assert found[0] == pytest.approx(found[1], rel=0.1), pattern


def test_checks_without_their_tool_are_left_out(folder, monkeypatch):
    monkeypatch.setattr(report.shutil, "which", lambda name: None)
    found = list(report.checks(report.Folder(folder)))
    assert [check.title for check in found if not check.title.startswith("Left out: no ")] == []
    assert not any(check.goals for check in found)


def test_goals_that_are_missed_are_the_status(folder, monkeypatch, capsys):
    missed = report.Check("One", ["text"], [report.Goal("a goal", "nothing", False)])
    monkeypatch.setattr(report, "CHECKS", (lambda folder: missed,))
    assert report.main(folder) == 1
    assert "MISSED a goal: nothing" in capsys.readouterr().out
    assert json.loads((folder / "profile.json").read_text("utf-8"))["public"]
