"""The seal refuses edited text even if digests and manifests fit the edit."""

import hashlib
import tomllib
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from rigidsym import InputError, generate
from rigidsym._codegen import header
from rigidsym._codegen.forms import split
from rigidsym._codegen.functions import functions
from rigidsym._codegen.seal import seal_text, text
from rigidsym._codegen.targets import reader
from rigidsym.solution import sealed
from rigidsym.validate.faults import all_faults
from rigidsym.validate.faults._printed import constants_of, faulty, functions_of

EDITS = tomllib.loads(Path(__file__).with_name("seal_edits.toml").read_text("utf-8"))
SOURCES = {"numpy": "torque_free.py", "c": "torque_free.c"}
# The file that edits of the other modules are made in, unless they name one.
OTHERS = {
    **{"numpy-pi": "torque_free_pi.py", "numpy-step": "torque_free_step.py"},
    **{"c-pi": "torque_free_pi.c", "c-step": "torque_free_step.c"},
    **{"c_single": "torque_free_single.c", "c_single-step": "torque_free_single_step.c"},
    **{"javascript": "torque_free.mjs", "javascript-pi": "torque_free_pi.mjs"},
    "javascript-step": "torque_free_step.mjs",
    "rust": "torque-free/src/routines.rs",
    "rust-step": "torque-free-step/src/routines.rs",
}
CASES = [pytest.param(t, e, id=f"{t}: {e['name']}") for t, edits in EDITS.items() for e in edits]


@cache
def made(module):
    target, form = split(module)
    return generate(target, form=form)


@pytest.fixture(autouse=True)
def functions_once(monkeypatch):
    """Derive the functions of each form once, since edits change the text alone."""
    monkeypatch.setattr(text, "functions", lambda _, *given: lets(*given))


def edited(target, edit):
    """Return a module with one edit, and with digests that fit it."""
    generated = made(target)
    manifest = generated.manifest
    files = {n: header.unsealed(x, target, manifest["digest"]) for n, x in generated.files.items()}
    name = edit.get("file", (SOURCES | OTHERS)[target])
    assert edit["find"] in files[name], f"{edit['name']}: there is nothing to edit"
    files[name] = files[name].replace(edit["find"], edit["replace"], 1)
    files, digest = header.sealed(files, target)
    digests = {n: hashlib.sha256(text.encode()).hexdigest() for n, text in files.items()}
    manifest = {"target": target, "digest": digest, "sha256": digests}
    return replace(generated, files=files, manifest=manifest)


@pytest.mark.parametrize(("target", "edit"), CASES)
def test_an_edit_is_refused_in_one_line(target, edit):
    with pytest.raises(InputError) as refused:
        seal_text(edited(target, edit), sealed())
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 400


@pytest.mark.parametrize("target", SOURCES)
def test_a_line_says_what_it_is_by(target):
    edit = {"name": "an origin", "find": "attitude.M_a", "replace": "attitude.M_b"}
    with pytest.raises(InputError, match=r"M_a = .*M_b.*: is by .*attitude.M_a"):
        seal_text(edited(target, edit), sealed())


def test_how_many_edits_there_are():
    assert {target: len(edits) for target, edits in EDITS.items()} == {
        **{"numpy": 38, "numpy-step": 4, "numpy-pi": 3},
        **{"c": 36, "c-step": 9, "c-pi": 3},
        **{"c_single": 11, "c_single-step": 2},
        **{"javascript": 13, "javascript-pi": 2, "javascript-step": 2},
        **{"rust": 4, "rust-step": 1},
    }


@pytest.mark.parametrize("target", SOURCES)
def test_what_was_not_edited_is_sealed_again(target):
    nothing = {"name": "nothing", "find": "pi", "replace": "pi"}
    assert edited(target, nothing) == made(target)
    assert seal_text(edited(target, nothing), sealed()) > 500


@pytest.mark.parametrize("target", SOURCES)
def test_digests_are_those_of_the_files(target):
    generated = made(target)
    manifest, files = generated.manifest, generated.files
    with pytest.raises(
        InputError, match=r"sha256 = torque_free\.\w+: is not what the manifest says"
    ):
        seal_text(replace(generated, manifest={**manifest, "sha256": {}}), sealed())
    wrong = "0" * 64
    files = {n: header.unsealed(x, target, manifest["digest"]) for n, x in files.items()}
    files = {n: header.filled(x, target, wrong) for n, x in files.items()}
    digests = {n: hashlib.sha256(text.encode()).hexdigest() for n, text in files.items()}
    other = {"target": target, "digest": wrong, "sha256": digests}
    with pytest.raises(InputError, match=f"digest = {wrong}: is not that of the files"):
        seal_text(replace(generated, files=files, manifest=other), sealed())


@pytest.mark.parametrize("target", SOURCES)
def test_what_a_head_says_of_errors_is_what_was_measured(target):
    generated = made(target)
    files = {n: x.replace(" rad, |domega|", " deg, |domega|") for n, x in generated.files.items()}
    files = {n: x.replace("Errors: not", "Errors: all") for n, x in files.items()}
    files = {n: x.replace("Worst errors", "Best errors") for n, x in files.items()}
    assert files != generated.files
    with pytest.raises(
        InputError, match=r"(Errors: all|Best errors) measured .*: is not @measured@"
    ):
        seal_text(replace(generated, files=files), sealed())


@pytest.mark.parametrize("target", SOURCES)
def test_a_module_names_its_digest_once(target):
    generated = made(target)
    files = {n: x.replace(generated.manifest["digest"], "-") for n, x in generated.files.items()}
    with pytest.raises(InputError, match="0 digests: a module names its own"):
        seal_text(replace(generated, files=files), sealed())


@pytest.mark.parametrize("target", SOURCES)
def test_files_that_end_early_are_refused(target):
    generated = made(target)
    source = SOURCES[target]
    lines = generated.files[source].split("\n")
    for kept in (0, 10, 100, len(lines) // 2, len(lines) - 2):
        files = {**generated.files, source: "\n".join(lines[:kept])}
        with pytest.raises(InputError):
            seal_text(replace(generated, files=files), sealed())


@cache
def lets(*given):
    return functions(sealed(), *given)


def first_of_each_kind():
    seen = set()
    for fault in all_faults():
        first = (fault.target, fault.kind) not in seen
        seen.add((fault.target, fault.kind))
        yield pytest.param(fault, id=fault.line, marks=[] if first else [pytest.mark.slow])


@pytest.mark.parametrize("fault", [*first_of_each_kind()])
def test_what_validation_catches_by_numbers_the_seal_refuses_by_the_text(fault):
    target, form = split(fault.target)
    given = functions_of(fault.target), constants_of(fault.target)
    with pytest.raises(InputError):
        reader(target)(faulty(fault), *given, form)
