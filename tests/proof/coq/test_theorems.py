"""The theorems in plain words: Coq accepts them, from the axioms that the page of trust names."""

import json
import re
import shutil
import subprocess
from importlib import resources
from pathlib import Path

import pytest
from document_texts import words
from ledgers import written

from rigidsym.io.ledger import ledger_text
from rigidsym.proof._coq import export
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.kernel import replay

# The contexts that theorems in plain words rest on.
CONTEXTS = ("regular", "attitude")
TOOLS = ("make", "coqc", "coq_makefile")
NEEDS_COQ = pytest.mark.skipif(
    not all(map(shutil.which, TOOLS)),
    reason="Coq is not here (Debian: apt-get install coq libcoq-coquelicot)",
)


@pytest.fixture(scope="module")
def files():
    """The export of these contexts alone."""
    data = json.loads(ledger_text())
    data["contexts"] = [one for one in data["contexts"] if one["name"] in CONTEXTS]
    data["facts"] = [fact for fact in data["facts"] if fact["context"] in CONTEXTS]
    return export(replay(written(data), encloses)).files


def in_plain_words(files):
    return [name for name in files if name.startswith("theorems/")]


def listed(text):
    """The theorems of which Coq is asked what they rest on."""
    return re.findall(r"@(\w+)", text)


def test_what_needs_other_contexts_is_left_out(files):
    assert "theorems/separatrix.v" in files
    assert "theorems/published.v" not in files
    assert "assumptions/published.v" not in files


def test_nothing_is_admitted(files):
    for name in ("prelude.v", *in_plain_words(files)):
        assert not re.search(r"\b(Admitted|admit|Axiom|Axioms|Parameter|Conjecture)\b", files[name])


def test_of_each_theorem_it_is_asked_what_it_rests_on(files):
    stated = [
        name
        for file in in_plain_words(files)
        for name in re.findall(r"^ *Theorem (\w+)", files[file], re.MULTILINE)
    ]
    asked = listed(files["assumptions/plain.v"])
    assert set(stated) - set(asked) == {"pulled_back_motion"}


@pytest.fixture(scope="module")
def compiled(once, files):
    """The folder of theorems that Coq has accepted, and what it said in `said`."""

    def make(folder: Path) -> None:
        for name, text in files.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text)
        done = subprocess.run(
            ["make", "plain"], cwd=folder, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        (folder / "said").write_text(done.stdout)

    return once("coq_plain", make)


@NEEDS_COQ
def test_the_axioms_are_those_of_the_page(compiled):
    said = (compiled / "said").read_text()
    assert said.count("Axioms:") == 1
    axioms = set(re.findall(r"^\w+\.(\w+)\s*:", said.split("Axioms:")[1], re.MULTILINE))
    assert axioms == {
        "sig_not_dec", "sig_forall_dec", "classic", "functional_extensionality_dep",
    }  # fmt: skip
    assert all(f"`{axiom}`" in words("trust.md") for axiom in axioms)


@pytest.mark.parametrize("file", ["plain", "published"])
def test_the_page_names_each_theorem(file):
    text = resources.files("rigidsym.proof._coq").joinpath("assumptions", f"{file}.v").read_text()
    assert [name for name in listed(text) if f"`{name}`" not in words("trust.md")] == []


@NEEDS_COQ
@pytest.mark.parametrize(
    ("theorem", "stated", "claimed"),
    [
        ("steady", "v_b / w * sin (w * t / 2)", "v_b / w * sin (w * t)"),
        ("symmetric", "let n := h * (1 - c_a / c) * v_a", "let n := h * (c_a / c - 1) * v_a"),
        ("symmetric", "(1 - c_a / c) * (sigma * v_a)) * t", "(1 - c_a / c) * v_a) * t"),
        ("separatrix", "K / c_b * t - 2 * rho", "K / c_b * t + 2 * rho"),
    ],
)
def test_coq_refuses_a_false_motion(compiled, tmp_path, theorem, stated, claimed):
    text = (compiled / "theorems" / f"{theorem}.v").read_text()
    assert stated in text
    false = tmp_path / "false.v"
    false.write_text(text.replace(stated, claimed))
    command = ["coqc", "-w", "none", "-Q", str(compiled), "Rigidsym", str(false)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "Error" in done.stderr
