"""Every notebook: its text is in step, it shows what it computes, and follows its setting."""

import importlib.util
import re
import shutil
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NEEDED = ("jupytext", "nbclient", "nbformat", "ipykernel", "matplotlib", "plotly", "scipy")
for package in (*NEEDED, "erfa", "ppigrf"):
    pytest.importorskip(package, reason=f"{package} is not installed: extra `lab` or `dev`")

SCRIPT = importlib.util.spec_from_file_location("notebooks_build", ROOT / "notebooks/build.py")
build = importlib.util.module_from_spec(SCRIPT)
SCRIPT.loader.exec_module(build)

NAMES = build.names()
every = pytest.mark.parametrize("name", NAMES)
# It checks what it has changed before it changes it back.
STEP_BY_STEP = ("howto_add_a_target",)
executed = build.executed


def committed(name):
    return build.nbformat.read(build.FOLDER / f"{name}.ipynb", as_version=4)


def with_code(line):
    """Return a notebook with one line of code."""
    notebook = build.source(NAMES[0])
    notebook.cells = [build.nbformat.v4.new_code_cell(line)]
    return notebook


def test_there_are_notebooks_and_no_strays():
    assert NAMES
    assert {path.stem for path in build.FOLDER.glob("*.ipynb")} == set(NAMES)


def gives_the_committed_notebook(name):
    if name == "00_start_here":
        pytest.importorskip("ipywidgets", reason="needs ipywidgets (extra lab)")
    assert build.check(name) == ""


@pytest.mark.parametrize(
    "name",
    [pytest.param(x, marks=pytest.mark.slow if executed.is_current(x) else ()) for x in NAMES],
)
def test_a_fresh_execution_gives_the_committed_notebook(name):
    gives_the_committed_notebook(name)


@pytest.mark.slow
@pytest.mark.usefixtures("another_processor")
@every
def test_another_processor_gives_the_committed_notebook(name):
    """Check that no output shows digits that rounding decides."""
    gives_the_committed_notebook(name)


@every
def test_text_and_notebook_are_in_step(name):
    assert build.check(name, lambda notebook, name: committed(name)) == ""


def test_a_notebook_is_current_until_something_it_depends_on_changes(monkeypatch, tmp_path):
    record, (name, other) = tmp_path / "executed.json", NAMES[:2]
    assert not executed.is_current(name, record)
    executed.note(name, record)
    assert executed.is_current(name, record)
    assert not executed.is_current(other, record)
    executed.note(other, record)
    assert executed.is_current(name, record)
    for lines in (("python 3.99",), ("numpy 1.0",), ("rigidsym/motion.py 0",)):
        with monkeypatch.context() as changed:
            changed.setattr(executed, "common", lambda lines=lines: lines)
            assert not executed.is_current(name, record)
    assert executed.is_current(name, record)


@pytest.mark.parametrize("suffix", [".py", ".ipynb"])
def test_a_notebook_that_is_edited_is_not_current(suffix, monkeypatch, tmp_path):
    name = NAMES[0]
    files = {".py": f"text/{name}.py", ".ipynb": f"{name}.ipynb"}
    (tmp_path / "text").mkdir()
    for file in files.values():
        shutil.copy(executed.FOLDER / file, tmp_path / file)
    before = executed.digest(name)
    monkeypatch.setattr(executed, "FOLDER", tmp_path)
    assert executed.digest(name) == before
    with (tmp_path / files[suffix]).open("a") as file:
        file.write(" ")
    assert executed.digest(name) != before


def test_notebooks_depend_on_the_code_its_data_and_the_versions():
    lines = executed.common()
    for start in ("python 3.", "numpy 2.", "jupyterlab ", "notebooks/support/__init__.py ",
                  "rigidsym/motion.py ", "rigidsym/generated/torque_free.c ",
                  "derivations/ledger.json "):  # fmt: skip
        assert sum(line.startswith(start) for line in lines) == 1
    modules = [*executed.FOLDER.glob("*.py"), *executed.FOLDER.glob("support/*.py")]
    assert {x.relative_to(executed.FOLDER).as_posix() for x in modules} == {*executed.TOGETHER}
    assert not any("ruff " in line or "pycache" in line for line in lines)


@every
def test_a_notebook_checks_itself_in_one_folded_cell_at_its_end(name):
    *others, last = [cell for cell in build.source(name).cells if cell.cell_type == "code"]
    assert "assert " in last.source
    assert "hide-cell" in last.metadata["tags"]
    if name not in STEP_BY_STEP:
        assert not any(re.search("^assert ", cell.source, re.M) for cell in others)


@pytest.mark.parametrize("name", [name for name in NAMES if name[0].isdigit()])
def test_contexts_come_from_chapters_and_imports_are_short(name):
    codes = [cell.source for cell in build.source(name).cells if cell.cell_type == "code"]
    assert not any(re.search(r"\bPart\(|\bwitness\b", code) for code in codes)
    assert max(len(re.findall("(?m)^(?:import|from) ", code)) for code in codes) <= 12
    assert not any(re.search(r"(?m)^from .* import \($", code) for code in codes)


def test_checks_and_pictures_are_folded_here_and_on_the_site():
    folded = build.source("02_from_lax_pair_to_k_a1")
    tagged = [cell for cell in folded.cells if {*cell.metadata.get("tags", ())} & build.FOLDED]
    assert tagged[-1] is folded.cells[-1]
    assert all(cell.metadata["jupyter"]["source_hidden"] for cell in tagged)
    assert sum("jupyter" in cell.metadata for cell in folded.cells) == len(tagged) > 1
    assert "source_hidden" not in build.text(folded)


def test_an_edited_text_is_noticed(monkeypatch):
    changed = build.source(NAMES[0])
    changed.cells[-1].source += "  # edited"
    monkeypatch.setattr(build, "source", lambda name: changed)
    assert "edited" in build.check(NAMES[0], fresh=pytest.fail)


def test_another_output_is_noticed():
    def fresh(notebook, name):
        found = committed(name)
        outputs = next(cell.outputs for cell in found.cells if cell.get("outputs"))
        outputs.append(build.nbformat.v4.new_output("stream", name="stdout", text="another"))
        return found

    assert "+another" in build.check(NAMES[0], fresh)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("1/0", "ZeroDivisionError"),
        ("import sys; sys.stderr.write('x')", "stderr"),
        ("object()", "an address or a path"),
        ("import pathlib; print(pathlib.Path('/tmp/x'))", "an address or a path"),
        ("import time; time.sleep(600)", "longer than 1 s"),
    ],
)
def test_what_must_not_be_committed_is_refused(line, reason, monkeypatch):
    if "sleep" in line:
        monkeypatch.setattr(build, "SECONDS", 1)
    with pytest.raises(build.NotebookError, match=reason):
        build.execute(with_code(line), "a")


def test_the_kernel_runs_the_package_of_this_repository():
    line = "import os, rigidsym; print(os.path.relpath(rigidsym.__file__))"
    (cell,) = build.execute(with_code(line), "a").cells
    assert cell.outputs[0].text.split() == [str(Path("..", "rigidsym", "__init__.py"))]


# Notebooks that derive: all their cells follow the one line with the setting.

AIRCRAFT = "sequence=(3, 2, 1), axis=2, sign=-1"
DERIVING = {
    "02_from_lax_pair_to_k_a1": f'Setting({AIRCRAFT}, group="SO3")',
    "03_the_phi1_integral_and_pi": f"Setting({AIRCRAFT})",
}


def run(name, chosen, monkeypatch):
    """Return the names that a notebook's code leaves behind, run with another setting."""
    import matplotlib

    matplotlib.use("agg")
    monkeypatch.setattr(sys, "path", [str(build.FOLDER), *sys.path])
    code = "\n".join(cell.source for cell in build.source(name).cells if cell.cell_type == "code")
    changed, count = re.subn(r"(?m)^setting = Setting\(.*\)$", f"setting = {chosen}", code)
    assert count == 1
    left: dict = {}
    exec(compile(changed, name, "exec"), left)
    return left


@pytest.mark.parametrize("name", DERIVING)
def test_a_notebook_follows_its_setting(name, monkeypatch):
    """Check that it runs to its end, where it checks its numbers, with the angles of aircraft."""
    left = run(name, DERIVING[name], monkeypatch)
    (nutation,) = left["step"](left["builder"], "compared.phi2").value
    assert str(nutation) == "sin(phi2)"


def test_a_gyrostat_is_derived_with_its_wheel_across_the_axis(monkeypatch):
    wheel = 'Setting(sequence=(3, 1, 3), sign=-1, lagrangian=KINETIC + " + h2*Omega2")'
    left = run("11_derive_your_own", wheel, monkeypatch)
    assert left["wheel"] == 1
    rates = {str(w) for w in left["rate"].value.free_symbols if str(w).startswith("Omega")}
    assert rates == {"Omega2", "Omega3"}
