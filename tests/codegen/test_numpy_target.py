"""The NumPy target: printed without loss, current, deterministic, alone."""

import ast
import hashlib
import json
import os
import subprocess
import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen.functions import functions
from rigidsym._codegen.ir import Function, let
from rigidsym._codegen.seal import seal_text
from rigidsym._codegen.targets.numpy import emit, module
from rigidsym.generated import torque_free
from rigidsym.solution import sealed

HOME = Path(rigidsym.__path__[0]) / "generated"
GENERATED = generate("numpy")
TEXT = GENERATED.files[module.FILES["theta"]]
FUNCTIONS = emit.own(functions(sealed()))


def test_the_committed_module_is_what_the_ledger_says():
    for name, text in GENERATED.texts().items():
        assert (HOME / name).read_text() == text


def test_it_imports_numpy_and_the_standard_library_alone():
    found = [n for n in ast.walk(ast.parse(TEXT)) if isinstance(n, ast.Import | ast.ImportFrom)]
    assert [ast.unparse(node) for node in found] == [
        "import math",
        "from typing import Any",
        "import numpy as np",
    ]


def test_what_is_printed_reads_back_as_the_lets():
    assert seal_text(GENERATED, sealed()) == sum(len(function.lets) for function in FUNCTIONS)


def test_every_derived_line_has_its_equations_and_facts():
    lines = TEXT.splitlines()
    places = GENERATED.map[module.FILES["theta"]]
    assert len(places) == sum(len(function.lets) for function in FUNCTIONS)
    known = {formula.fact for p in sealed().sequences.values() for formula in p}
    for place in places:
        assert " = " in lines[place["line"] - 1]
        assert set(place["facts"]) <= known
        assert (place["kind"] == "fact") == bool(place["facts"])
        assert place["kind"] == "arithmetic" or place["facts"] or place["equations"]


def test_the_header_names_digest_command_and_bounds():
    head = ast.get_docstring(ast.parse(TEXT))
    assert "rigidsym codegen numpy" in head
    assert f"digest {GENERATED.manifest['digest']}" in head
    assert "Landen's ladder, 5 steps" in head
    assert f"\nrigidsym {rigidsym.__version__}, emitter numpy/2\n" in head
    digest = hashlib.sha256(TEXT.encode()).hexdigest()
    assert GENERATED.manifest["sha256"] == {module.FILES["theta"]: digest}


@pytest.mark.parametrize("target", ["numpy", "c"])
@pytest.mark.parametrize("seed", ["0", "4242"])
def test_bytes_do_not_depend_on_the_hash_seed(seed, target):
    code = f"import rigidsym, json; print(json.dumps(rigidsym.generate('{target}').texts()))"
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    found = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment
    )
    assert json.loads(found.stdout) == generate(target).texts()


def test_the_module_works_alone(tmp_path):
    GENERATED.write(tmp_path)
    made = "p = tf.prepare((1, 2, 2.5), (1, 2, 3))"
    code = f"import torque_free as tf; {made}; print(tf.states(p, 1.0)[0])"
    found = subprocess.run(
        [sys.executable, "-S", "-c", f"import sys; sys.path.insert(0, {numpy_home()!r}); {code}"],
        capture_output=True, text=True, check=True, cwd=tmp_path,
    )  # fmt: skip
    expected = rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3))(1.0)[0]
    assert found.stdout.strip() == str(expected)


def numpy_home():
    return str(Path(np.__path__[0]).parent)


def test_unknown_targets_are_named_with_the_known_ones():
    with pytest.raises(InputError, match="target = fortran: must be one of: numpy, c"):
        generate("fortran")


@pytest.mark.parametrize("text", ["a = gamma(b)", "a = b**c"])
def test_an_unsupported_node_fails_at_generation(text):
    from rigidsym._codegen.passes import products
    from rigidsym._codegen.targets.c import emit as emit_c

    odd = Function("_odd", "", ("b", "c"), (let(text),), ("a",))
    with pytest.raises(ValueError, match=r"gamma|whole power"):
        [emit.printed(one.expression) for one in products(odd.lets)]
    with pytest.raises(ValueError, match=r"gamma|cannot say"):
        emit_c.lowered(odd.lets[0].expression, set(), "pair")


def test_out_is_filled_and_returned():
    prepared = torque_free.prepare((1, 2, 2.5), [(1, 2, 3), (0, 1, 0)])
    t = np.linspace(-3, 3, 50)
    out = np.empty((2, 50, 4)), np.empty((2, 50, 3))
    found = torque_free.states(prepared, t, out)
    assert all(a is b for a, b in zip(found, out, strict=True))
    for a, b in zip(found, torque_free.states(prepared, t), strict=True):
        np.testing.assert_array_equal(a, b)
    for wrong in ((out[0], out[1][:, :-1]), (out[0].astype("f4"), out[1]), (out[0],), out[::-1]):
        with pytest.raises(ValueError, match="out: must be C-contiguous float64 arrays of shapes"):
            torque_free.states(prepared, t, wrong)


def test_blocks_do_not_show():
    """Many times, many bodies and single calls give the same bits, or nearly: scalars are summed
    by the same lines."""
    t = np.linspace(0.5, 400, 20_001)
    prepared = torque_free.prepare((1, 2, 2.5), (0.1, 1, 0.2))
    q, omega = torque_free.states(prepared, t)
    for k in (0, 8191, 8192, 20_000):
        one = torque_free.states(prepared, float(t[k]))
        np.testing.assert_allclose(one[0], q[k], rtol=0, atol=5e-16)
        np.testing.assert_allclose(one[1], omega[k], rtol=0, atol=5e-16)
    many = torque_free.prepare(np.tile((1, 2, 2.5), (500, 1)), (0.1, 1, 0.2))
    batch, _ = torque_free.states(many, t[:30])
    np.testing.assert_array_equal(batch[0], batch[-1])
    np.testing.assert_allclose(batch[0], q[:30], rtol=0, atol=5e-16)


def test_memory_beyond_the_output_does_not_grow_with_the_number_of_times():
    prepared = torque_free.prepare((1, 2, 2.5), (0.1, 1, 0.2))
    t = np.linspace(0, 100, 1_000_000)
    out = np.empty((t.size, 4)), np.empty((t.size, 3))
    tracemalloc.start()
    torque_free.states(prepared, t, out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 16e6


@pytest.mark.parametrize("target", ["numpy", "c"])
def test_the_head_says_what_was_measured_of_this_very_code(target):
    """`rigidsym validate numpy c --cases 200 --record`, then `rigidsym codegen` again."""
    texts = "".join(generate(target).files.values())
    assert "not measured" not in texts
    assert f"rigidsym validate {target} --cases" in texts
