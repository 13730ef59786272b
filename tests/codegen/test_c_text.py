"""The C target as text: printed without loss, current, traceable."""

import hashlib
import re
from pathlib import Path

import pytest

import rigidsym
from rigidsym import generate
from rigidsym.codegen.c import emit, module
from rigidsym.codegen.functions import constants, finished, functions
from rigidsym.codegen.kernels import exponential
from rigidsym.codegen.passes import fuse, unfused
from rigidsym.seal import is_equal
from rigidsym.solution import sealed
from rigidsym.solution.expression import Call, children, parse, rebuild

HOME = Path(rigidsym.__path__[0]) / "generated"
GENERATED = generate("c")
SOURCE = GENERATED.files[module.SOURCE]
FUNCTIONS = (*functions(sealed()), finished(exponential.function()))


def test_the_committed_files_are_what_the_ledger_says():
    for name, text in GENERATED.texts().items():
        assert (HOME / name).read_text() == text


def body(name):
    """The lines of a function between its braces."""
    found = re.search(
        rf"^static (?:inline )?\w+ {name}\([^)]*\)\n{{\n(.*?)^}}", SOURCE, re.DOTALL | re.MULTILINE
    )
    assert found, name
    return found[1].splitlines()


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.name)
def test_what_is_printed_reads_back_as_the_lets(function):
    names = ["excess_pair", "excess_exact"] if function.name == "_excess" else [function.name[1:]]
    for name in names:
        lines = [line.strip() for line in body(name)]
        extended = set(function.extended)
        if function.name == "_excess":
            extended = set(function.parameters)
        for let, fused in zip(function.lets, fuse(function.lets, extended), strict=True):
            line = next(line for line in lines if is_of(line, let))
            lines.remove(line)
            assert printed(line, let) == without_prefix(fused.expression)
            assert is_equal(unfused(fused.expression), let.expression)


def is_of(line, let):
    if len(let.targets) > 1:
        return f"&{let.targets[0]}, " in line
    return re.match(rf"const (double|pair|exact) {let.targets[0]} = (?!plan->|\w+_in\[)", line)


def printed(line, let):
    if len(let.targets) > 1:
        line = re.sub(r", &.*\)", ")", line)
    return emit.read(line)


def without_prefix(expression):
    """Functions of the module have a leading underscore in lets and none in C."""
    parts = tuple(map(without_prefix, children(expression)))
    if isinstance(expression, Call):
        return Call(expression.function.removeprefix("_"), parts)
    return rebuild(expression, parts)


def test_reading_back_undoes_what_only_c_needs():
    text = "    const pair x = pair_mul_dx(2.0, pair_add_xx(a, pair_of(3.0))); /* (34); f.g */"
    assert emit.read(text) == parse("2*(a + 3)")
    assert emit.read("const double y = fused(a, -b, fabs(c)) / 2.0;") == parse(
        "fma(a, -b, size(c))/2"
    )


def test_constants_are_written_to_the_last_digit():
    for constant in constants():
        found = re.search(rf"static const \w+ {constant.name} = (.*); /\*", SOURCE)
        if found:
            parts = [float(x) for x in found[1].strip("{}").split(",")]
            assert parts == [constant.hi] + ([] if constant.lo is None else [constant.lo])


def test_every_derived_line_has_its_equations_and_facts():
    lines = SOURCE.splitlines()
    known = {formula.fact for p in sealed().programmes.values() for formula in p}
    places = GENERATED.map[module.SOURCE]
    assert len(places) == sum(len(f.lets) for f in FUNCTIONS) + len(FUNCTIONS[0].lets)
    for place in places:
        assert lines[place["line"] - 1].startswith("    ")
        assert set(place["facts"]) <= known
        for equation in place["equations"]:
            assert equation in lines[place["line"] - 1]


def test_one_digest_covers_both_files():
    digest = GENERATED.manifest["digest"]
    assert f"digest {digest}" in GENERATED.files[module.HEADER]
    assert f'return "{digest}";' in SOURCE
    for name, text in GENERATED.files.items():
        assert GENERATED.manifest["sha256"][name] == hashlib.sha256(text.encode()).hexdigest()
