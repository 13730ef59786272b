"""Generated files: printed without loss, current, deterministic, traceable, and read back."""

import ast
import hashlib
import json
import os
import re
import runpy
import subprocess
import sys
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen import TARGETS, forms, targets
from rigidsym._codegen.formats import BINARY32
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.ir import Function, let
from rigidsym._codegen.passes import products
from rigidsym._codegen.routines import DOUBLE, PAIR, SIZE, Program, Routine, Type, lowered
from rigidsym._codegen.seal import seal_text
from rigidsym._codegen.targets.c import module as c_module
from rigidsym._codegen.targets.c.derived import plain
from rigidsym._codegen.targets.c.printer import Printer
from rigidsym._codegen.targets.c.reader import Reader, parsed
from rigidsym._codegen.targets.c.reader import functions as functions_in
from rigidsym._codegen.targets.c_single import module as c_single
from rigidsym._codegen.targets.javascript import module as javascript_module
from rigidsym._codegen.targets.numpy import emit as numpy
from rigidsym._codegen.targets.numpy import module as numpy_module
from rigidsym._codegen.targets.rust import module as rust_module
from rigidsym._codegen.trace import lines_of_equation
from rigidsym.solution import sealed

HOME = Path(rigidsym.__path__[0]) / "generated"
HOW_TO = Path(__file__).parents[2] / "notebooks" / "text" / "howto_add_a_target.py"
SOURCES = {
    **{"numpy": numpy_module.FILES, "c": c_module.SOURCES},
    "javascript": javascript_module.FILES,
    "c_single": {form: f"{stem}.c" for form, stem in c_single.STEMS.items()},
    "rust": {form: rust_module.source(form) for form in forms.FORMS},
}
HEADS = SOURCES | {
    "c": c_module.HEADERS,
    "c_single": {form: f"{stem}.h" for form, stem in c_single.STEMS.items()},
    "rust": {form: f"{crate}/src/lib.rs" for form, crate in rust_module.CRATES.items()},
}
SCALAR = {"javascript": javascript_module, "rust": rust_module}
every_module = pytest.mark.parametrize(
    ("target", "form"), [(t, f) for t in TARGETS for f in targets.forms_of(t)]
)

made, lets_of = cache(generate), cache(partial(functions, sealed()))


def source(target, form="theta"):
    return made(target, form=form).files[SOURCES[target][form]]


def count_of_lines(target, form):
    """Return how many lets a module prints: the discriminant for two kinds of numbers but in NumPy.

    JavaScript, Rust and single precision have no sensitivities.
    """
    if target == "c_single":
        own = functions(sealed(), form, BINARY32), constants(BINARY32)
        routines = c_single.Files(*own, form).made.routines.values()
        return sum(len(x.function.lets) for x in routines if x.function)
    printed = [x for x in lets_of(form) if target != "numpy" or x.name != "_exponential"]
    if target in SCALAR:
        own = SCALAR[target].program(lets_of(form), constants(), form).routines.values()
        printed = [x for x in printed if any(one.prints(x) for one in own)]
    twice = [x for x in printed if target != "numpy" and x.name == "_discriminant"]
    return sum(len(function.lets) for function in (*printed, *twice))


@every_module
def test_the_committed_files_are_what_the_ledger_says(target, form):
    for name, text in made(target, form=form).texts().items():
        assert (HOME / name).read_text() == text


@every_module
def test_what_is_printed_reads_back_as_the_lets(target, form):
    generated = made(target, form=form)
    assert seal_text(generated, sealed()) == count_of_lines(target, form) > 150
    assert generated.manifest["target"] == forms.key(target, form)
    for name, text in generated.files.items():
        first = Path(SOURCES[target][form]).parts[0]
        if name != c_module.ARITHMETIC:
            assert name.startswith(Path(first).stem)
        if name == c_module.ARITHMETIC or ("/" in name and name != HEADS[target][form]):
            continue
        command = f"rigidsym codegen {target}{forms.option(form)}"
        assert f"{command}\n" in text or f"`{command}`" in text or name.endswith(".c")


@every_module
def test_every_derived_line_has_its_equations_and_facts(target, form):
    lines = source(target, form).splitlines()
    known = {formula.fact for p in sealed().sequences.values() for formula in p}
    places = made(target, form=form).map[SOURCES[target][form]]
    assert len(places) == count_of_lines(target, form)
    for place in places:
        line = lines[place["line"] - 1]
        assert line.startswith("    ")
        assert " = " in line or target.startswith("c")
        assert set(place["facts"]) <= known
        assert (place["kind"] == "fact") == bool(place["facts"])
        assert place["kind"] == "arithmetic" or place["facts"] or place["equations"]
        assert all(equation in line for equation in place["equations"])


@every_module
def test_one_digest_covers_all_files(target, form):
    generated = made(target, form=form)
    digest, files = generated.manifest["digest"], generated.files
    (head,) = (name for name, text in files.items() if f"digest {digest}" in text)
    assert head == HEADS[target][form]
    assert f'return "{digest}";' in source(target, form) or target == "numpy"
    sums = {name: hashlib.sha256(text.encode()).hexdigest() for name, text in files.items()}
    assert generated.manifest["sha256"] == sums


def test_the_header_names_command_and_bounds():
    head = ast.get_docstring(ast.parse(source("numpy")))
    assert "rigidsym codegen numpy" in head
    assert "Landen's ladder, 5 steps" in head
    assert f"\nrigidsym {rigidsym.__version__}, emitter numpy/2\n" in head


@pytest.mark.parametrize("target", TARGETS)
def test_the_head_says_what_was_measured_of_this_very_code(target):
    """`rigidsym validate numpy c --cases 200 --record`, then `rigidsym codegen` again."""
    texts = "".join(made(target).files.values())
    assert "not measured" not in texts
    assert f"rigidsym validate {target} --cases" in texts


def test_constants_are_written_to_the_last_digit():
    for constant in constants():
        found = re.search(rf"static const \w+ {constant.name} = (.*); /\*", source("c"))
        if found:
            parts = [float(x) for x in found[1].strip("{}").split(",")]
            assert parts == [constant.hi] + ([] if constant.lo is None else [constant.lo])


@pytest.mark.parametrize("seed", ["0", "4242"])
def test_bytes_do_not_depend_on_the_hash_seed(seed):
    code = "import json; from rigidsym import generate; "
    code += f"print(json.dumps([generate(target).texts() for target in {TARGETS}]))"
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    found = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    )
    assert json.loads(found.stdout) == [made(target).texts() for target in TARGETS]


def test_the_numpy_module_works_alone(tmp_path):
    found = [
        n
        for n in ast.walk(ast.parse(source("numpy")))
        if isinstance(n, ast.Import | ast.ImportFrom)
    ]
    assert [ast.unparse(node) for node in found] == [
        "import math",
        "from fractions import Fraction",
        "from typing import Any",
        "import numpy as np",
    ]
    made("numpy").write(tmp_path)
    home = str(Path(np.__path__[0]).parent)
    code = f"import sys; sys.path.insert(0, {home!r}); import torque_free as tf; "
    code += "p = tf.prepare((1, 2, 2.5), (1, 2, 3)); print(tf.states(p, 1.0)[0])"
    found = subprocess.run(
        [sys.executable, "-S", "-c", code], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    expected = rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3))(1.0)[0]
    assert found.stdout.strip() == str(expected)


@pytest.mark.parametrize(
    ("target", "form", "message"),
    [
        ("fortran", "theta", f"target = fortran: must be one of: {', '.join(TARGETS)}"),
        ("numpy", "phi", r"form = 'phi': must be one of: theta, pi|phi"),
    ],
)
def test_unknown_targets_and_forms_are_named_with_the_known_ones(target, form, message):
    with pytest.raises(InputError, match=message):
        generate(target, form=form)


@pytest.mark.parametrize("text", ["a = gamma(b)", "a = b**c"])
def test_an_unsupported_node_fails_at_generation(text):
    odd = Function("_odd", "", ("b", "c"), (let(text),), ("a",))
    with pytest.raises(ValueError, match=r"gamma|whole power"):
        [numpy.printed(one.expression) for one in products(odd.lets)]
    with pytest.raises(ValueError, match=r"gamma|cannot be printed"):
        lowered(routine(odd), Program())


def routine(function):
    """Return a function of doubles as a C routine."""
    return replace(plain(function), function=None)


def read(text):
    """Read the C text of a function of a double-double a, doubles b and c, and times t[]."""
    types = {"a": PAIR, "b": DOUBLE, "c": DOUBLE, "t": Type("double", ("...",)), "k": SIZE}
    one = Routine("f", "", types, (), ())
    program = Program(routines={"f": one})
    head = "static void f(double_double a, double b, double c, const double *t, size_t k)"
    text = f"{head}\n{{\n{text}\n}}"
    ((_, node),) = functions_in("f.c", parsed(text))
    body = node.child_by_field_name("body")
    read = list(Reader("f.c", one, Printer(program, "", {})).block(body))
    return "\n".join(map(ast.unparse, read))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("const double_double x = {b, 0.0};", "x: pair = pair(b, 0.0)"),
        ("x = fused(b, -c, fabs(b)) / 2.0;", "x = fused(b, -c, abs(b)) / 2.0"),
        (
            "x[k] = b <= c && !(c < b) ? 1.0 : -1.0;",
            "x[k] = 1.0 if b <= c and (not c < b) else -1.0",
        ),
        ("f(a, b, c, t + 2 * k, k);", "f(a, b, c, t[2 * k:], k)"),
        (
            "if (b < c) {\nx += 1.0;\n} else {\nreturn;\n}",
            "if b < c:\n    x += 1.0\nelse:\n    return",
        ),
        ("for (size_t i = 1; i < k; i += 2) {\nbreak;\n}", "for i in range(1, k, 2):\n    break"),
        ("y = (double)k * (b - (c - b));", "y = double(k) * (b - (c - b))"),
    ],
)
def test_c_reads_back_as_the_statements_of_a_routine(text, said):
    assert read(text) == said


@pytest.mark.parametrize(
    "text",
    [
        *["goto f;", "while (b < c) {\n}", "do {\n} while (0);", "b++;", "b, c;", "{\nb = c;\n}"],
        *[
            "if (b < c) b = c;",
            "for (int i = 0; i < 3; i++) {\n}",
            "switch (k) {\n}",
            "long x = 1;",
        ],
        *["b = c = 1.0;", "b = 1.0f;", "b = c ^ 1.0 ++;", "b = sizeof c;", "int x, y;", "*b = +c;"],
    ],
)
def test_what_no_routine_has_is_refused(text):
    with pytest.raises((InputError, KeyError, ValueError)):
        read(text)


# --- the Pi form, and other targets


@pytest.mark.parametrize("target", [t for t in TARGETS if "pi" in targets.forms_of(t)])
def test_the_pi_form_has_no_theta_function_and_no_nome(target):
    for text in made(target, form="pi").files.values():
        assert not re.search(r"theta\d|_root_ratio|root_ratio|\bnome|DLMF 20\.", text)


def test_c_modules_of_both_forms_have_no_name_in_common():
    """Neither what a header declares or defines, nor what the linker sees."""
    own = re.compile(r"\b(?:torque_free|TORQUE_FREE)_\w+")
    shared = {"torque_free_arithmetic", "TORQUE_FREE_FMA"}
    theta, pi = (
        {
            name
            for file, text in made("c", form=form).files.items()
            for name in own.findall(text)
            if file != c_module.ARITHMETIC and name not in shared
        }
        for form in ("theta", "pi")
    )
    assert not theta & pi
    assert all(name.lower().startswith("torque_free_pi") for name in pi)


def test_a_name_of_another_form_is_refused():
    generated, name = made("c", form="pi"), "torque_free_pi.c"
    text = generated.files[name].replace("torque_free_pi_state_at(", "torque_free_state_at(", 1)
    changed = replace(generated, files={**generated.files, name: text})
    with pytest.raises(InputError, match=r"torque_free_pi.c:\d+ = .*has another form's name"):
        seal_text(changed, sealed())


def test_equation_36_has_lines_in_all_languages():
    files = {line.split(":")[0] for line in lines_of_equation("36")}
    every = {
        name for path in HOME.glob("*.map.json") for name in json.loads(path.read_text())["lines"]
    }
    assert files == {name for name in every if re.search("[-_](pi|step)[./]", name)}


def test_the_how_to_adds_a_target_and_takes_it_away(capsys):
    before = list(targets.TARGETS), list(targets.__path__)
    try:
        runpy.run_path(str(HOW_TO))
    finally:
        for name in [name for name in sys.modules if name.startswith(f"{targets.__name__}.floats")]:
            del sys.modules[name]
    assert (list(targets.TARGETS), list(targets.__path__)) == before
    said = capsys.readouterr().out
    assert f"{count_of_lines('javascript', 'theta')} lines read back" in said
    assert said.count("not what was derived") == 2
    assert "apart by less than 2e-15: True" in said


@pytest.mark.parametrize("find", [targets.reader, targets.server])
def test_a_missing_package_is_not_a_missing_reader(find, monkeypatch):
    """The error for a package that a target's module imports names the package."""

    def importing(name):
        raise ModuleNotFoundError("No module named 'tree_sitter'", name="tree_sitter")

    monkeypatch.setattr(targets, "import_module", importing)
    with pytest.raises(ModuleNotFoundError, match="tree_sitter"):
        find("javascript")


def test_a_target_without_a_server_is_refused():
    with pytest.raises(InputError, match=r"target = c: has no server\.py: it computes no states"):
        targets.server("c")
