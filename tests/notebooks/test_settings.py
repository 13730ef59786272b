"""Notebooks that derive run on with another setting: what one cell says, all others follow."""

import re
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

CHOSEN = re.compile(r"^setting = Setting\(.*\)$", re.M)


def run(name, chosen, monkeypatch):
    """The names that a notebook's code leaves behind, run with another line for its setting."""
    import matplotlib

    matplotlib.use("agg")
    code = "\n".join(cell.source for cell in build.source(name).cells if cell.cell_type == "code")
    changed, count = CHOSEN.subn(f"setting = {chosen}", code)
    assert count == 1
    monkeypatch.setattr(sys, "path", [str(build.FOLDER), *sys.path])
    left: dict = {}
    exec(compile(changed, name, "exec"), left)
    return left


OTHER = "Setting(sequence=(3, 1, 3), axis=2, sign=-1)"
# Notebooks by their stems, with the contexts that no chapter has.
NAMES = {
    "02_from_lax_pair_to_k_a1": set(),
    "03_the_phi1_integral_and_pi": set(),
    "04_no_sign_functions": {"psi", "regrouped", "shortest"},
}


@pytest.fixture(scope="module")
def chapters():
    """The facts that the chapters find with the other setting."""
    from derivations.setting import Setting
    from rigidsym.proof.derivation import derive

    derivation = derive(setting=eval(OTHER, {"Setting": Setting}))
    return {fact.id: fact for chapter in derivation.chapters for fact in chapter.facts}


@pytest.mark.parametrize("name", NAMES)
def test_with_another_setting_a_notebook_finds_what_the_chapters_find(name, chapters, monkeypatch):
    left = run(name, OTHER, monkeypatch)
    found = left["builder"].ledger.facts
    known = {fact: value for fact, value in found.items() if value.context not in NAMES[name]}
    assert len(known) > 20
    assert {*known} <= {*chapters}
    for fact, value in known.items():
        assert (value.lhs, value.rhs) == (chapters[fact].lhs, chapters[fact].rhs), fact


def test_a_gyrostat_is_derived_with_its_wheel_across_the_axis(monkeypatch):
    left = run(
        "11_derive_your_own",
        'Setting(sequence=(3, 1, 3), sign=-1, lagrangian=KINETIC + " + h2*Omega2")',
        monkeypatch,
    )
    assert left["wheel"] == 1
    assert {str(w) for w in left["rate"].value.free_symbols if str(w).startswith("Omega")} == {
        "Omega2",
        "Omega3",
    }
