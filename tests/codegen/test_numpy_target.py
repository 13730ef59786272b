"""The NumPy target: derived, shared without loss, printed without loss, current, deterministic."""

import ast
import hashlib
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym import InputError, generate
from rigidsym.codegen import emit_numpy
from rigidsym.codegen.functions import functions
from rigidsym.codegen.passes import expand, select, share, specialise
from rigidsym.solution import sealed
from rigidsym.solution.expression import Call, children, names, parse, rebuild
from rigidsym.solution.formulas import INPUTS

HOME = Path(rigidsym.__path__[0]) / "generated"
GENERATED = generate("numpy")
TEXT = GENERATED.files[emit_numpy.FILE]
FUNCTIONS = functions(sealed())


def test_the_committed_module_is_what_the_ledger_says():
    for name, text in GENERATED.texts().items():
        assert (HOME / name).read_text() == text


def test_it_imports_numpy_alone():
    found = [node for node in ast.walk(ast.parse(TEXT)) if isinstance(node, ast.Import)]
    assert [alias.name for node in found for alias in node.names] == ["numpy"]
    assert not any(isinstance(node, ast.ImportFrom) for node in ast.walk(ast.parse(TEXT)))


@pytest.mark.parametrize("name", ["plan", "state", "steady"])
def test_sharing_can_be_undone(name):
    wanted = [formula.name for formula in sealed().programmes[name]]
    lets = select(sealed().programmes[name], wanted, ())
    shared = share(lets)
    assert len(shared) >= len(lets)
    assert [let.expression for let in expand(shared)] == [
        expanded(let.expression, lets) for let in lets
    ]
    for place, let in enumerate(shared):
        before = {target for earlier in shared[:place] for target in earlier.targets}
        assert set(names(let.expression)) <= before | set(INPUTS[name]) | {"t"}


def expanded(expression, lets):
    """`share` also uses a let's own name where its whole expression occurs again."""
    for let in lets:
        if let.expression is expression:
            break
        if let.expression == expression:
            return parse(let.targets[0])
    inside = {let.expression: parse(let.targets[0]) for let in lets_before(expression, lets)}

    def walk(part):
        if part in inside:
            return inside[part]
        return rebuild(part, tuple(map(walk, children(part))))

    return rebuild(expression, tuple(map(walk, children(expression))))


def lets_before(expression, lets):
    for let in lets:
        if let.expression is expression:
            return
        yield let


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.name)
def test_what_is_printed_reads_back_as_the_lets(function):
    tree = next(
        node
        for node in ast.parse(TEXT).body
        if isinstance(node, ast.FunctionDef) and node.name == function.name
    )
    assert tuple(argument.arg for argument in tree.args.args) == function.parameters
    assignments = [node for node in tree.body if isinstance(node, ast.Assign)]
    assert len(assignments) == len(function.lets)
    back = {f"np.{name}": name for name in ("sqrt", "cos", "sin")}
    for node, let in zip(assignments, function.lets, strict=True):
        text = ast.unparse(node.value)
        for printed, name in back.items():
            text = text.replace(printed, name)
        assert unprefixed(parse(text)) == let.expression


def unprefixed(expression):
    parts = tuple(map(unprefixed, children(expression)))
    if isinstance(expression, Call):
        return Call(expression.function.removeprefix("_"), parts)
    return rebuild(expression, parts)


def test_specialising_folds_what_is_known():
    lets = select(sealed().programmes["plan"], ["qbar_a", "qbar_b"], ["s_0", "s_b", "s_d"])
    folded = specialise(lets, {"cos_half_psi": 1, "sin_half_psi": 0})
    assert [str(let) for let in folded] == ["qbar_a = 0", "qbar_b = s_b"]


def test_every_derived_line_has_its_equations_and_facts():
    lines = TEXT.splitlines()
    places = GENERATED.map[emit_numpy.FILE]
    assert len(places) == sum(len(function.lets) for function in FUNCTIONS)
    known = {formula.fact for p in sealed().programmes.values() for formula in p}
    for place in places:
        assert " = " in lines[place["line"] - 1]
        assert place["equations"]
        assert set(place["facts"]) <= known


def test_the_header_names_digest_and_command():
    assert "rigidsym codegen numpy" in TEXT
    assert "digest " in TEXT
    digest = hashlib.sha256(TEXT.encode()).hexdigest()
    assert GENERATED.manifest["sha256"] == {emit_numpy.FILE: digest}


@pytest.mark.parametrize("seed", ["0", "4242"])
def test_bytes_do_not_depend_on_the_hash_seed(seed):
    code = "import rigidsym, json; print(json.dumps(rigidsym.generate('numpy').texts()))"
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    found = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    )
    assert json.loads(found.stdout) == GENERATED.texts()


def test_the_module_works_alone(tmp_path):
    GENERATED.write(tmp_path)
    code = (
        "import torque_free as tf; p = tf.plan((1, 2, 2.5), (1, 2, 3)); print(tf.states(p, 1.0)[0])"
    )
    found = subprocess.run(
        [sys.executable, "-S", "-c", f"import sys; sys.path.insert(0, {numpy_home()!r}); {code}"],
        capture_output=True, text=True, check=True, cwd=tmp_path,
    )  # fmt: skip
    expected = rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3))(1.0)[0]
    assert found.stdout.strip() == str(expected)


def numpy_home():
    return str(Path(np.__path__[0]).parent)


def test_unknown_targets_are_named_with_the_known_ones():
    with pytest.raises(InputError, match="target = fortran: must be one of: numpy"):
        generate("fortran")


def test_an_unnamed_parameter_fails_at_generation():
    from rigidsym.codegen.ir import Let
    from rigidsym.codegen.passes import lower

    let = Let(("s",), parse("jacobi_sn(u, 1 - m)"), ("10",), ("x",))
    with pytest.raises(ValueError, match="must be a named quantity"):
        lower((let,))
