"""The JavaScript target: edits that its seal refuses, errors of its classes, and its types."""

import json
import re
import shutil
import subprocess
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from test_seal_statements import edited

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen.forms import FORMS
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.seal import seal_text
from rigidsym._codegen.seal.bodies import Body
from rigidsym._codegen.targets.javascript import module, read_back
from rigidsym._codegen.targets.javascript.printer import NAMES, Printer
from rigidsym.solution import sealed

NODE, TSC = shutil.which("node"), shutil.which("tsc")
needs_node = pytest.mark.skipif(NODE is None, reason="needs Node.js (Debian: nodejs)")


@cache
def printed(form):
    """Return each routine of a form with its lines in JavaScript."""
    made = module.program(functions(sealed(), form), constants(), form)
    printer = Printer(made, NAMES)
    return [(one, list(printer.routine(one).text)) for one in made.routines.values()]


def is_sealed(one, lines):
    """Return True if the seal accepts lines as a routine."""
    try:
        ((_, node),) = read_back.JavaScriptReader.bodies("f.mjs", "\n".join(lines), {one.name: one})
        read = list(read_back.JavaScriptReader("f.mjs").block(node))
        Body("f.mjs", lines, one).check(read, one.body)
    except (InputError, ValueError, KeyError):
        return False
    return True


def survivors(form, every):
    """Return the edits that the seal accepts, and how many were made; one line in `every`."""
    count, accepted, place = 0, [], 0
    for one, lines in printed(form):
        assert is_sealed(one, lines)
        begin = next(k for k, line in enumerate(lines) if line.endswith(") {")) + 1
        for k in range(begin, len(lines) - 2):
            place += 1
            if place % every or not re.search(r"[;{]", lines[k].partition("/*")[0]):
                continue
            for line in edited(lines[k]):
                count += 1
                if is_sealed(one, [*lines[:k], line, *lines[k + 1 :]]):
                    accepted.append(f"{one.name}: {line.strip()}")
    return accepted, count


@pytest.mark.parametrize("form", FORMS)
def test_no_edit_of_some_statements_is_sealed(form):
    accepted, count = survivors(form, 20)
    assert not accepted
    assert count > 30


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_no_edit_of_any_statement_is_sealed(form):
    accepted, count = survivors(form, 1)
    assert not accepted
    assert count > 1000


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        ("torque_free.mjs", "return n % 2 === 0 ? 1 : -1;", "return n % 2 === 0 ? -1 : 1;"),
        ("torque_free.mjs", "const max_angle = ", "const max_angle = 2 * "),
        ("torque_free.mjs", "export const TIME = 6;", "export const TIME = 5;"),
        (
            "torque_free.mjs",
            "function limit(last, rate, other)",
            "function limit(last, other, rate)",
        ),
        ("torque_free.mjs", "return [OK, failed];", "return [OK, 0];"),
        ("torque_free.d.mts", "readonly lastTime: number;", "readonly lastTime: string;"),
    ],
)
def test_what_stands_outside_statements_is_sealed(file, old, new):
    made = generate("javascript")
    assert made.files[file].count(old) == 1
    changed = {**made.files, file: made.files[file].replace(old, new)}
    with pytest.raises(InputError):
        seal_text(replace(made, files=changed), sealed())


def run(tmp_path, script, form="theta"):
    """Return what a script prints, as JSON, beside a module."""
    generate("javascript", form=form).write(tmp_path)
    (tmp_path / "main.mjs").write_text(script)
    line = [NODE, tmp_path / "main.mjs"]
    return json.loads(subprocess.run(line, capture_output=True, check=True).stdout)


ERRORS = """
import { TorqueFreeMotion, RefusedError, settings } from "./torque_free.mjs";
const wrong = [
    [[1, 2], [0, 0, 1]], [[1, 2, "x"], [0, 0, 1]], [[1, 2, 2.5], null], [[1, 2, 2.5], [0, 0, NaN]],
    [[3, 1, 1], [0, 0, 1]], [[1, 2, 2.5], [0, 0, 1], [0, 0, 0, 0]],
];
const said = wrong.map((given) => {
    try {
        new TorqueFreeMotion(...given);
    } catch (error) {
        return [error.name, error.field, error.message, error instanceof RefusedError];
    }
});
const motion = new TorqueFreeMotion([1, 2, 2.5], [0.3, 0.5, -0.7]);
for (const t of [1e300, "2", undefined]) {
    try {
        motion.at(t);
    } catch (error) {
        said.push([error.name, error.field, error.message, error instanceof RefusedError]);
    }
}
settings.ALLOW_NONPHYSICAL = true;
new TorqueFreeMotion([3, 1, 1], [0, 0, 1]);
console.log(JSON.stringify([said, motion.lastTime, [...motion.states([0, 1]).q]]));
"""


@needs_node
def test_classes_refuse_in_words(tmp_path):
    said, last, q = run(tmp_path, ERRORS)
    names = [name for name, *_ in said]
    assert names == ["TypeError"] + ["RefusedError"] * 1 + ["TypeError"] + ["RefusedError"] * 6
    assert said[0][2] == "inertia: expected 3 numbers"
    assert said[2][2] == "omega0: expected 3 numbers"
    assert [field for _, field, *_ in said[3:7]] == ["", "inertia", "attitude0", "t"]
    assert said[4][2].startswith("inertia: no body has a principal moment larger than the sum")
    assert said[4][2].endswith("(settings.ALLOW_NONPHYSICAL = true lets it pass)")
    assert all(is_refused == (name == "RefusedError") for name, _, _, is_refused in said)
    motion = rigidsym.TorqueFreeMotion((1, 2, 2.5), (0.3, 0.5, -0.7))
    assert last == 2.0**47
    assert np.max(np.abs(np.reshape(q, (2, 4)) - motion([0.0, 1.0])[0])) < 1e-15


BODY = """
import { TorqueFreeBody } from "./torque_free_step.mjs";
const body = new TorqueFreeBody([1, 2, 2.5]), given = [[1, 0, 0, 0], [0.3, 0.5, -0.7]];
const { q, omega } = body.step(...given, 0.25);
console.log(JSON.stringify([[...q, ...omega], given]));
"""


@needs_node
def test_a_body_steps(tmp_path):
    found, given = run(tmp_path, BODY, "step")
    q, omega = rigidsym.step((1, 2, 2.5), *given, 0.25)
    assert np.max(np.abs(np.array(found) - [*q, *omega])) < 1e-15
    assert given == [[1, 0, 0, 0], [0.3, 0.5, -0.7]]


@pytest.mark.skipif(TSC is None, reason="needs TypeScript's tsc (Debian: node-typescript)")
@pytest.mark.parametrize("form", FORMS)
def test_type_declarations_are_typescript(form, tmp_path):
    made = generate("javascript", form=form)
    made.write(tmp_path)
    (name,) = (name for name in made.files if name.endswith(".d.mts"))
    line = [TSC, "--strict", "--noEmit", "--target", "es2022", tmp_path / name]
    done = subprocess.run(line, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
