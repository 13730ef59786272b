"""The Rust crate: sealed statement by statement, with tests of its own, and clean to its tools."""

import shutil
import subprocess
from functools import cache

import pytest
from test_seal_statements import edited

import rigidsym
from rigidsym import InputError, generate
from rigidsym._codegen.forms import FORMS
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.seal.bodies import Body
from rigidsym._codegen.targets.rust import module, read_back
from rigidsym._codegen.targets.rust.printer import Printer
from rigidsym.solution import sealed

made = cache(generate)
needs_cargo = pytest.mark.skipif(
    not shutil.which("cargo"), reason="needs Rust (Debian: cargo and rustc)"
)


@cache
def program(form):
    return module.program(functions(sealed(), form), constants(), form)


def is_sealed(one, lines):
    """Return True if the seal accepts lines as the text of a routine."""
    try:
        ((_, node),) = read_back.RustReader.bodies("f.rs", "\n".join(lines), {one.name: one})
        reader = read_back.RustReader("f.rs")
        Body("f.rs", lines, one, reader.plain).check(list(reader.block(node)), one.body)
    except (InputError, ValueError, KeyError):
        return False
    return True


def survivors(form, every):
    """Return the edits that the seal accepts, and how many were made; one line in `every`."""
    count, accepted, place, printer = 0, [], 0, Printer(program(form))
    for one in program(form).routines.values():
        lines = list(printer.routine(one).text)
        assert is_sealed(one, lines)
        begin = next(k for k, line in enumerate(lines) if line.endswith(" {"))
        for k in range(begin + 1, len(lines) - 2):
            place += 1
            if place % every or lines[k].lstrip().startswith(("/*", "*/", "}")):
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
    ("line", "instead"),
    [
        ("        (X, Y) = step_doubled(", "        let (X, Y) = step_doubled("),
        ("    let mut given: [f64; 4] = [0.0; 4];", "    let mut given: [f64; 4] = [1.0; 4];"),
        ("    let is_turned: bool = is_under(", "    let is_turned: f64 = is_under("),
        ("const rounder: f64 = 6", "const rounder: f64 = 7"),
        ("pub(crate) fn step_doubled(X: Pair", "pub(crate) fn step_doubled(X: &Pair"),
        ("forbid(unsafe_code)", "allow(unsafe_code)"),
    ],
)
def test_declarations_and_what_is_outside_are_sealed(line, instead):
    generated = made("rust", form="step")
    ((name, text),) = ((name, text) for name, text in generated.files.items() if line in text)
    files = {**generated.files, name: text.replace(line, instead, 1)}
    with pytest.raises(InputError, match=r"(routines|lib)\.rs:\d+"):
        read_back.check(files, functions(sealed(), "step"), constants(), "step")


@needs_cargo
@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_the_crate_passes_its_own_tests_and_lints(form, tmp_path):
    made("rust", form=form).write(tmp_path)
    home = tmp_path / module.CRATES[form]
    for task in ("test", "clippy", "doc"):
        if shutil.which(f"cargo-{task}") or task != "clippy":
            given = ["--all-targets"] * (task == "clippy")
            line = ["cargo", task, "--offline", *given]
            done = subprocess.run(line, cwd=home, capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr
            assert "warning" not in done.stderr
            assert task != "test" or "2 passed" in done.stdout


def test_the_crate_has_neither_dependencies_nor_unsafe_code():
    for form in FORMS:
        files = made("rust", form=form).files
        crate = module.CRATES[form]
        root = files[f"{crate}/src/lib.rs"]
        assert "#![no_std]\n#![forbid(unsafe_code)]" in root
        assert "dependencies" not in files[f"{crate}/Cargo.toml"]
        assert "std::" not in "".join(files[f"{crate}/src/{x}.rs"] for x in ("lib", "routines"))
        assert f'version = "{rigidsym.__version__}"' in files[f"{crate}/Cargo.toml"]
