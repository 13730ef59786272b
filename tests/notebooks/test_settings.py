"""Notebooks that derive run on with another setting: what one cell says, all others follow."""

import os
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NEEDED = ("jupytext", "nbclient", "nbformat", "ipykernel", "matplotlib", "plotly")
for package in NEEDED:
    pytest.importorskip(package, reason=f"{package} is not installed: extra `lab`")

SCRIPT = spec_from_file_location("notebooks_build", ROOT / "notebooks/build.py")
build = module_from_spec(SCRIPT)
SCRIPT.loader.exec_module(build)

CHOSEN = "setting = Setting()\n"


def run(name, chosen, monkeypatch):
    """The names that a notebook's code leaves behind, run with another line for its setting."""
    import matplotlib

    matplotlib.use("agg")
    code = "\n".join(cell.source for cell in build.source(name).cells if cell.cell_type == "code")
    assert code.count(CHOSEN) == 1
    monkeypatch.setattr(sys, "path", [str(build.FOLDER), *sys.path])
    left: dict = {}
    exec(compile(code.replace(CHOSEN, f"setting = {chosen}\n"), name, "exec"), left)
    return left


@pytest.mark.parametrize(
    ("name", "chosen"),
    [("02_from_lax_pair_to_k_a1", "Setting(sequence=(3, 1, 3), axis=2, sign=-1)")],
)
def test_a_notebook_runs_on_with_another_setting(name, chosen, monkeypatch):
    left = run(name, chosen, monkeypatch)
    book = left["book"]
    assert left["setting"] != left["Setting"]()
    assert {fact.grade.value for fact in book.ledger.facts.values()} == {"PROVED"}
