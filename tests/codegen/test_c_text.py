"""The C target as text: printed without loss, current, traceable."""

import hashlib
import re
from pathlib import Path

import pytest

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.seal import seal_text
from rigidsym._codegen.targets.c import module
from rigidsym._codegen.targets.c.read_back import Reader
from rigidsym.language._expression import parse
from rigidsym.solution import sealed

HOME = Path(rigidsym.__path__[0]) / "generated"
GENERATED = generate("c")
SOURCE = GENERATED.files[module.SOURCES["theta"]]
FUNCTIONS = functions(sealed())


def test_the_committed_files_are_what_the_ledger_says():
    for name, text in GENERATED.texts().items():
        assert (HOME / name).read_text() == text


def test_what_is_printed_reads_back_as_the_lets():
    (discriminant,) = (function for function in FUNCTIONS if function.name == "_discriminant")
    lines = sum(len(function.lets) for function in FUNCTIONS) + len(discriminant.lets)
    assert seal_text(GENERATED, sealed()) == lines


def test_reading_back_undoes_what_only_c_needs():
    read = Reader("f", "dd", {"a"}, {}).read
    assert read("dd_mul_dx(2.0, dd_add_xx(a, dd_of(3.0)))") == (parse("2*(a + 3)"), True)
    assert read("fused(b, -c, fabs(d)) / 2.0") == (parse("fma(b, -c, size(d))/2"), False)


@pytest.mark.parametrize(
    "text",
    [
        *["b / 2", "2.0f*b", "02.0*b", "1e5", "b ** 2.0", "b if c else d", "(b, c)", "b +"],
        *["fma(b, c, d)", "exp(b)", "size(b)", "neg(b)", "ladder(b)", "dd_turn(a)", "exact_neg(a)"],
        *["a + b", "-a", "dd_add_xx(a, b)", "dd_add_dd(b, c)", "dd_of(a)", "fabs(a)", "dd_neg(b)"],
    ],
)
def test_what_c_does_not_say_so_is_no_expression(text):
    with pytest.raises(InputError, match=r"^f = "):
        Reader("f", "dd", {"a"}, {}).read(text)


def test_constants_are_written_to_the_last_digit():
    for constant in constants():
        found = re.search(rf"static const \w+ {constant.name} = (.*); /\*", SOURCE)
        if found:
            parts = [float(x) for x in found[1].strip("{}").split(",")]
            assert parts == [constant.hi] + ([] if constant.lo is None else [constant.lo])


def test_every_derived_line_has_its_equations_and_facts():
    lines = SOURCE.splitlines()
    known = {formula.fact for p in sealed().sequences.values() for formula in p}
    places = GENERATED.map[module.SOURCES["theta"]]
    (twice,) = (f for f in FUNCTIONS if f.name == "_discriminant")
    assert len(places) == sum(len(f.lets) for f in FUNCTIONS) + len(twice.lets)
    for place in places:
        assert lines[place["line"] - 1].startswith("    ")
        assert set(place["facts"]) <= known
        assert (place["kind"] == "fact") == bool(place["facts"])
        assert place["kind"] == "arithmetic" or place["facts"] or place["equations"]
        for equation in place["equations"]:
            assert equation in lines[place["line"] - 1]


def test_one_digest_covers_both_files():
    digest = GENERATED.manifest["digest"]
    assert f"digest {digest}" in GENERATED.files[module.HEADERS["theta"]]
    assert f'return "{digest}";' in SOURCE
    for name, text in GENERATED.files.items():
        assert GENERATED.manifest["sha256"][name] == hashlib.sha256(text.encode()).hexdigest()
