"""Code, case files and flags in README and pages work as they are printed."""

import ast
import re
import shutil
import subprocess
import tomllib

import numpy as np
import pytest
import six_files
from document_texts import FENCED, README, ROOT, TEXTS, blocks

import rigidsym
from rigidsym._cli import main, parser
from rigidsym._engines.build import ANY_MOMENTS, FLAGS, NATIVE
from rigidsym.fitting import load
from rigidsym.io.cases import parse_case
from rigidsym.manoeuvre._manoeuvre import parse
from rigidsym.manoeuvre._planning import solve

KINDS = {
    *("sh", "python", "toml", "toml manoeuvre", "toml observations", "c", "c single", "js", "rust"),
    *("text", "python no-run", "c no-run", "python jax", "python torch"),
}
# What a programme of one's own is compiled with: as the engine is, but for any machine.
OF_PYTHON = (*NATIVE, ANY_MOMENTS, "-fPIC", "-shared")
COMPILED_WITH = [flag for flag in FLAGS if flag not in OF_PYTHON]

# What the programmes find, by the names they give it.
ANSWERS = {
    "q": lambda q: q.shape == (3, 4) and np.isfinite(q).all(),
    "report": lambda report: report.passed,
    "solution": lambda solution: str(solution.omega(180).evalf(30)[0]).startswith(
        "0.0571406808658981944279541748"
    ),
    "fit": lambda fit: fit.converged and fit.agreement.verdict == "agree",
    "plan": lambda plan: plan.best.residual <= 1e-12,
}


@pytest.mark.parametrize("name", TEXTS)
def test_every_block_is_of_a_kind_that_is_run(name):
    """Check kinds of blocks; one that cannot run says so by a second word: ```python no-run."""
    assert TEXTS[name].count("```") == 2 * len(FENCED[name])
    assert {info for info, _ in FENCED[name]} <= KINDS


@pytest.mark.parametrize("name", [name for name in TEXTS if blocks("python", name)])
def test_the_python_runs(name, tmp_path, monkeypatch):
    """Run all of a text, from top to bottom, as a reader would type it."""
    monkeypatch.chdir(tmp_path)
    six_files.write(tmp_path / "six")
    scope = {}
    for code in blocks("python", name):
        exec(code, scope)
    checks = [check(scope[name]) for name, check in ANSWERS.items() if name in scope]
    assert checks
    assert all(checks)


@pytest.mark.parametrize("library", ["jax", "torch"])
def test_gradient_descent_finds_the_rates(library):
    pytest.importorskip(library)
    scope = {}
    for code in blocks(f"python {library}", "autodiff.md"):
        exec(code, scope)
    assert scope["miss"] < 1e-12
    assert np.allclose(scope["omega0"].tolist(), [0.3, 0.2, -0.1], atol=1e-6)


def test_the_example_has_five_lines():
    (example,) = blocks("python", "README.md")
    assert len(example.splitlines()) == 5


@pytest.mark.parametrize("text", blocks("toml"))
def test_a_case_file_is_one(text, tmp_path, capsys):
    assert tomllib.loads(text)
    count = len(parse_case(text).times)
    path = tmp_path / "case.toml"
    path.write_text(text)
    assert main(["propagate", str(path)]) == 0
    assert len(capsys.readouterr().out.splitlines()) == count + 1


@pytest.mark.parametrize("text", blocks("toml manoeuvre"))
def test_a_manoeuvre_is_planned(text):
    assert solve(parse(tomllib.loads(text))).best.residual <= 1e-12


@pytest.mark.parametrize("text", blocks("toml observations"))
def test_observations_are_read(text, tmp_path):
    path = six_files.write(tmp_path) / "observations.toml"
    path.write_text(text)
    assert load(path).observations["rates"][0].count == 200


def test_the_table_of_commands_has_all_of_them(capsys):
    listed = re.findall(r"^\| `rigidsym ([\w-]+)` \|", TEXTS["use.md"], re.MULTILINE)
    (known,) = (action.choices for action in parser()._actions if action.dest == "command")
    assert listed == [*known]
    for command in listed:
        with pytest.raises(SystemExit) as stop:
            main([command, "--help"])
        assert stop.value.code == 0


@pytest.mark.parametrize("program", blocks("c"))
def test_a_c_program_compiles_and_runs(program, tmp_path):
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        pytest.skip("no C compiler here")
    (tmp_path / "main.c").write_text(program)
    rigidsym.generate("c").write(tmp_path)
    subprocess.run([compiler, *_flags(), "-o", "main"], cwd=tmp_path, check=True)
    found = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True)
    expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)[0]
    assert list(map(float, found.stdout.split())) == pytest.approx(expected.tolist(), abs=1e-15)


@pytest.mark.parametrize("program", blocks("c single"))
def test_a_c_program_in_single_precision_compiles_and_runs(program, tmp_path):
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        pytest.skip("no C compiler here")
    (tmp_path / "main.c").write_text(program)
    rigidsym.generate("c_single").write(tmp_path)
    sources = ["main.c", "torque_free_single.c"]
    command = [compiler, "-std=c99", "-Os", *sources, "-lm", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    found = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True)
    expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)[0]
    # The inputs are rounded to floats.
    assert list(map(float, found.stdout.split())) == pytest.approx(expected.tolist(), abs=1e-5)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node.js (Debian: nodejs)")
@pytest.mark.parametrize("program", blocks("js"))
def test_the_javascript_runs(program, tmp_path):
    (tmp_path / "main.mjs").write_text(program)
    rigidsym.generate("javascript").write(tmp_path)
    line = ["node", tmp_path / "main.mjs"]
    found = subprocess.run(line, capture_output=True, text=True, check=True)
    state, refused = found.stdout.splitlines()
    expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)
    assert list(map(float, state.split())) == pytest.approx(np.hstack(expected), abs=1e-15)
    assert refused.startswith("inertia no body has")


@pytest.mark.skipif(shutil.which("cargo") is None, reason="needs Rust (Debian: cargo, rustc)")
@pytest.mark.parametrize("program", blocks("rust"))
def test_the_rust_runs(program, tmp_path):
    rigidsym.generate("rust").write(tmp_path)
    examples = tmp_path / "torque-free" / "examples"
    examples.mkdir()
    (examples / "main.rs").write_text(program)
    line = ["cargo", "run", "--quiet", "--offline", "--example", "main"]
    found = subprocess.run(line, cwd=examples, capture_output=True, text=True, check=True)
    state, refused = found.stdout.splitlines()
    expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)[0]
    assert list(map(float, state.split())) == pytest.approx(expected.tolist(), abs=1e-15)
    assert refused.startswith("inertia no body has")


def _flags():
    (line,) = re.findall(r"^cc (.*)$", TEXTS["code.md"], re.MULTILINE)
    return line.split()


def test_the_flags_are_those_of_the_engine():
    assert _flags() == [*COMPILED_WITH, "main.c", "torque_free.c", "-lm"]
    assert f"`{' '.join(NATIVE)}`" in TEXTS["code.md"]


@pytest.mark.parametrize("stem", ["08_code_you_can_fly", "howto_c_for_my_flight_code"])
def test_so_are_those_of_notebooks(stem):
    text = (ROOT / "notebooks" / "text" / f"{stem}.py").read_text("utf-8")
    (flags,) = re.findall(r"^FLAGS = (.*)$", text, re.MULTILINE)
    assert ast.literal_eval(flags) == COMPILED_WITH
    assert stem.startswith("08") or f"`{' '.join(COMPILED_WITH)}`" in text


def test_extras_are_those_of_the_package():
    known = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    install = README.partition("## Install")[2].partition("\n## ")[0]
    for extra in ("lab", "app", "docs", "dev"):
        assert extra in known["optional-dependencies"]
        assert re.search(rf'`{extra}`|"\.\[{extra}\]"', install), extra
    assert f"Python {known['requires-python'].removeprefix('>=')} or newer" in install
