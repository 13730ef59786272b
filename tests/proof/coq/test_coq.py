"""Theorems exported to Coq, which Coq accepts, and false ones, which it refuses."""

import json
import re
import shutil
import subprocess
from collections import Counter
from dataclasses import replace
from importlib import resources
from pathlib import Path

import pytest
from document_texts import words
from ledgers import prove, unchecked, written

from rigidsym._cli import main
from rigidsym.io.ledger import ledger_text, specification_text
from rigidsym.language._specification import Unproved, require
from rigidsym.proof._coq import SUPPOSED, export
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.kernel import Context, Fact, Grade, Ledger, replay

PLANE = Context(
    name="plane",
    generators=("x", "y", "r"),
    witness={"x": "3", "y": "4", "r": "5"},
    units=("r", "x - y", "radius"),  # one of them twice
    definitions={"cosine": "x/r", "sine": "y/radius", "t": "2*r", "radius": "r"},
    relations=("r**2 - x**2 - y**2",),
    rates={"x": "-y", "y": "x"},
    nonnegative=("r",),
    reading={"r": "a length (*"},
)
CIRCLE = replace(
    PLANE,
    name="circle",
    generators=("c", "s"),
    witness={"c": "3/5", "s": "4/5"},
    units=("c - s",),
    definitions={
        **{"x": "c", "y": "s", "r": "1", "radius": "r"},
        **{"cosine": "c", "sine": "s/r", "t": "2"},
    },
    relations=("c**2 + s**2 - 1",),
    rates={"c": "-s", "s": "c"},
    nonnegative=(),
    reading={},
)
NUMBERS = Context("numbers", ("a",), {"a": "1"}, definitions={"square": "a**2"})
FACTS = (
    Fact("plane.unit", "plane", "equal", ("cosine**2 + sine**2",), ("1",), "identity"),
    Fact("plane.turns", "plane", "equal", ("D(cosine)", "D(x)*y"), ("-sine", "-y*y"), "identity"),
    Fact("plane.radius", "plane", "root", ("r",), ("x**2 + y**2",), "identity"),
    Fact("plane.sign", "plane", "nonnegative", ("t*r",), ("2*x**2 + 2*y**2",), "identity"),
)
# Contexts of the sealed ledger: motions, steps, kicks and sensitivities rest on them.
CONTEXTS = (
    *("regular", "attitude", "kick", "doubling", "second_half", "thirds"),
    *("share", "parts", "turn", "direction", "step"),
    *("coefficients", "varied_rates", "varied_rates_start"),
)
NEEDS_COQ = pytest.mark.skipif(
    not all(map(shutil.which, ("make", "coqc", "coq_makefile"))),
    reason="Coq is not here (Debian: apt-get install coq libcoq-coquelicot)",
)


@pytest.fixture(scope="module")
def ledger() -> Ledger:
    """Return a ledger with a fact of every rule."""
    admitted = Ledger()
    for context in (PLANE, CIRCLE, NUMBERS, *cases()):
        admitted.open(context)
    for fact in FACTS:
        prove(admitted, fact)
    admitted.add(Fact("circle.model", "circle", "model", (), ("plane",), "model"))
    carried = {"context": "circle", "rule": "transfer", "premises": ("plane.turns", "circle.model")}
    turns = replace(FACTS[1], id="circle.turns", certificate={}, **carried)
    admitted.add(turns)
    sides = (("a", "a"), ("square", "1"))
    wrong = Fact("numbers.wrong", "numbers", "unequal", *sides, "counterexample")
    admitted.add(replace(wrong, certificate={"point": {"a": "-2/3"}}))
    supposed = Fact("numbers.supposed", "numbers", "equal", ("square",), ("a",), "assumption")
    admitted.add(replace(supposed, grade=Grade.ASSUMED, certificate={"reference": "somebody"}))
    names = ("zero", "positive", "negative")
    split = Fact("numbers.cases", "numbers", "partition", ("a",), names, "partition")
    admitted.add(replace(split, certificate={"cases": list(names)}))
    moves = Fact("plane.moves", "plane", "unequal", ("x",), ("y",), "counterexample")
    admitted.add(replace(moves, certificate={"point": {**PLANE.witness}}))
    return admitted


def cases():
    points = ({"a": "0"}, {"a": "1"}, {"a": "-1"})
    named = zip(NUMBERS.cases("a"), ("zero", "positive", "negative"), points, strict=True)
    return [replace(case, name=name, witness=point) for case, name, point in named]


def theorem(text: str, name: str) -> str:
    """Return the statement of a theorem in a Coq file."""
    return text.split(f"Theorem fact_{name} ")[1].split("Proof.")[0]


def test_each_rule_has_its_theorem(ledger):
    written = export(ledger)
    assert written.exported == {
        "identity": 4, "model": 1, "transfer": 1, "counterexample": 1, "partition": 1,
        "assumption": 1,
    }  # fmt: skip
    assert list(written.left_out) == ["plane.moves"]
    plane = written.files["contexts/plane.v"]
    assert "(cosine X t) ^ 2 + (sine X t) ^ 2 = 1" in theorem(plane, "unit")
    assert "r X = sqrt ((x X t) ^ 2 + (y X t) ^ 2)" in theorem(plane, "radius")


def test_derivatives_are_said_to_exist(ledger):
    states = theorem(export(ledger).files["contexts/plane.v"], "turns")
    assert "is_derive (fun t : R => cosine X t) t (- (sine X t))" in states
    assert "ex_derive (fun t : R => x X t) t" in states


def test_words_of_coq_are_no_names_and_readings_end_no_comment(ledger):
    plane = export(ledger).files["contexts/plane.v"]
    assert "Definition t_ (X : names)" in plane
    assert "a length ( *" in plane


def test_the_text_is_the_same_every_time(ledger):
    first, second = export(ledger), export(ledger)
    assert dict(first.files) == dict(second.files)


def test_what_needs_other_contexts_is_left_out(ledger):
    files = export(ledger).files
    assert "prelude.v" in files["_CoqProject"].split()
    assert all(name in files for name in files["_CoqProject"].split() if name.endswith(".v"))


def test_a_ledger_that_the_kernel_refuses_is_not_exported(tmp_path, capsys):
    certificate = {"cofactors": [["0"]]}
    false = replace(FACTS[0], rhs=("2",), certificate=certificate)
    path = tmp_path / "ledger.json"
    path.write_text(unchecked([PLANE], [false]))
    into = tmp_path / "coq"
    assert main(["export", "coq", "-o", str(into), "--ledger", str(path)]) == 1
    said = capsys.readouterr().err
    assert said.startswith("rigidsym export: refused by the kernel")
    assert said.count("\n") == 1
    assert not into.exists()


def test_without_coq_one_line_says_so(ledger, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("shutil.which", lambda tool: None if tool.startswith("coq") else tool)
    path = tmp_path / "ledger.json"
    path.write_text(ledger.to_text())
    into = tmp_path / "coq"
    arguments = ["export", "coq", "-o", str(into), "--ledger", str(path), "--check"]
    assert main(arguments) == 1
    shown = capsys.readouterr()
    assert "9 facts are stated in Coq" in shown.out
    assert "1 are hypotheses there of all that rests on them: assumption" in shown.out
    assert "1 are not: a point of a context that moves is no motion: plane.moves" in shown.out
    assert shown.err.splitlines()[-1] == (
        "rigidsym export: --check needs coqc (Debian: apt-get install coq libcoq-coquelicot)"
    )
    assert (into / "contexts" / "plane.v").is_file()


def coqc(folder: Path, *files: str) -> str:
    """Let Coq compile files in this order; return the first that it refuses, or ""."""
    for file in files:
        command = ["coqc", "-w", "none", "-Q", str(folder), "Rigidsym", file]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode:
            assert done.returncode == 1
            assert "Error" in done.stderr
            return file
    return ""


def write(files, folder: Path) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text)


@pytest.fixture(scope="session")
def prelude(once):
    """Return a folder with the compiled prelude, shared by all tests."""

    def make(folder: Path) -> None:
        write({"prelude.v": export(Ledger()).files["prelude.v"]}, folder)
        assert coqc(folder, "prelude.v") == ""

    return once("coq_prelude", make)


@pytest.fixture(scope="module")
def exported(ledger, prelude, tmp_path_factory):
    """Return the folder of the exported files, with the prelude compiled."""
    folder = tmp_path_factory.mktemp("coq")
    files = {k: text for k, text in export(ledger).files.items() if k != "prelude.v"}
    write(files, folder)
    return shutil.copytree(prelude, folder, dirs_exist_ok=True)


@NEEDS_COQ
def test_coq_accepts_all_of_it(exported):
    order = ("plane", "circle", "zero", "positive", "negative", "numbers")
    assert coqc(exported, *(f"contexts/{name}.v" for name in order)) == ""


@NEEDS_COQ
@pytest.mark.parametrize(
    ("stated", "claimed"),
    [
        # A changed statement with its certificate kept, as readers see it and as the checker does.
        (("(sine X t) ^ 2 = 1.", "(sine X t) ^ 2 = 2."), ("", "")),
        (("(sine X t) ^ 2 = 1.", "(sine X t) ^ 2 = 2."), ("(Num 1), [", "(Num 2), [")),
        (("t (- (sine X t))", "t (sine X t)"), ("", "")),
        (("0 <= 2", "0 <= - 2"), ("", "")),
        (("Define 4 (Div (Var 1) (Var 3))", "Define 4 (Div (Var 2) (Var 3))"), ("", "")),
    ],
)
def test_coq_refuses_what_is_false(exported, stated, claimed):
    text = (exported / "contexts" / "plane.v").read_text()
    assert text.count(stated[0]) >= 1
    false = text.replace(*stated)
    false = false.replace(*claimed) if claimed[0] else false
    (exported / "contexts" / "false.v").write_text(false)
    assert coqc(exported, "contexts/false.v") == "contexts/false.v"


# The whole ledger.


@pytest.fixture(scope="module")
def everything(sealed_ledger):
    """Return the export of the sealed ledger."""
    return export(sealed_ledger)


def without(facts, dropped):
    """Return facts without the dropped ones and those that rest on them."""
    kept, dropped = [], {*dropped}
    for fact in facts:
        if fact["id"] in dropped or dropped & {*fact["premises"]}:
            dropped.add(fact["id"])
        else:
            kept.append(fact)
    return kept


def test_coq_has_all_that_the_specification_requires(everything):
    data = json.loads(ledger_text())
    data["facts"] = without(data["facts"], everything.left_out)
    require(specification_text(), data)


def test_a_fact_that_coq_lacks_is_noticed():
    data = json.loads(ledger_text())
    data["facts"] = without(data["facts"], ["halves.models_second_half"])
    with pytest.raises(Unproved, match="theorem halves"):
        require(specification_text(), data)


def test_only_points_of_motions_are_left_out(everything):
    assert {*everything.left_out.values()} == {"a point of a context that moves is no motion"}


def test_no_file_defines_a_name_twice(everything):
    for file, text in everything.files.items():
        pattern = r"^ *(?:Definition|Lemma|Theorem|Record) (\w+)"
        names = Counter(re.findall(pattern, text, re.MULTILINE))
        assert [name for name, count in names.items() if count > 1] == [], file


# Theorems in plain words.


@pytest.fixture(scope="module")
def files():
    """Return the exported files of these contexts of the sealed ledger."""
    data = json.loads(ledger_text())
    data["contexts"] = [one for one in data["contexts"] if one["name"] in CONTEXTS]
    data["facts"] = [fact for fact in data["facts"] if fact["context"] in CONTEXTS]
    return export(replay(written(data), encloses)).files


def in_plain_words(files):
    return [name for name in files if name.startswith("theorems/")]


def listed(text):
    """Return the theorems whose axioms a file prints."""
    return re.findall(r"@(\w+)", text)


def test_theorems_on_other_contexts_are_left_out(files):
    assert "theorems/separatrix.v" in files
    assert "theorems/published.v" not in files
    assert "assumptions/published.v" not in files


def test_nothing_is_admitted(everything):
    files = everything.files
    for name in ("prelude.v", *in_plain_words(files)):
        assert not re.search(r"\b(Admitted|admit|Axiom|Axioms|Parameter|Conjecture)\b", files[name])


def test_the_page_counts_what_coq_supposes(everything):
    supposed = {rule: everything.exported[rule] for rule in SUPPOSED}
    assert "the {theta} equations of the rule `theta`, the {start} of".format(**supposed) in words(
        "trust.md"
    )


def test_of_each_theorem_it_is_asked_what_it_rests_on(everything):
    files = everything.files
    stated = [
        name
        for file in in_plain_words(files)
        for name in re.findall(r"^ *Theorem (\w+)", files[file], re.MULTILINE)
    ]
    asked = [name for file in files if "assumptions/" in file for name in listed(files[file])]
    assert set(stated) - set(asked) == {"pulled_back_motion"}


def build(folder: Path, target: str) -> None:
    """Compile a target of the exported Makefile, with Coq's output in `said`."""
    done = subprocess.run(
        ["make", "-j2", target], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    (folder / "said").write_text(done.stdout)


@pytest.fixture(scope="module")
def compiled(once, files, prelude):
    """Return the folder of compiled theorems on motions."""

    def make(folder: Path) -> None:
        write({name: text for name, text in files.items() if name != "prelude.v"}, folder)
        shutil.copytree(prelude, folder, dirs_exist_ok=True)
        build(folder, "plain")

    return once("coq_plain", make)


@pytest.fixture(scope="module")
def computed(once, compiled):
    """Return the folder of compiled theorems on motions, steps and kicks."""

    def make(folder: Path) -> None:
        shutil.copytree(compiled, folder, dirs_exist_ok=True)
        build(folder, "computed")

    return once("coq_computed", make)


@NEEDS_COQ
@pytest.mark.parametrize("built", ["compiled", pytest.param("computed", marks=pytest.mark.slow)])
def test_the_axioms_are_those_of_the_page(built, request):
    said = (request.getfixturevalue(built) / "said").read_text()
    assert said.count("Axioms:") == 1
    axioms = set(re.findall(r"^\w+\.(\w+)\s*:", said.split("Axioms:")[1], re.MULTILINE))
    assert axioms == {
        "sig_not_dec", "sig_forall_dec", "classic", "functional_extensionality_dep",
    }  # fmt: skip
    assert all(f"`{axiom}`" in words("trust.md") for axiom in axioms)


@pytest.mark.parametrize("file", ["plain", "computed", "published"])
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
    (tmp_path / "false.v").write_text(text.replace(stated, claimed))
    assert coqc(compiled, str(tmp_path / "false.v"))


@NEEDS_COQ
@pytest.mark.slow
@pytest.mark.parametrize(
    ("theorem", "stated", "claimed"),
    [
        ("kick", "(- dot (vector (w1 0)", "(dot (vector (w1 0)"),
        ("step", "t + bent t.", "t - bent t."),
        ("variation", "dc_a * varied_rates.Omega_a_by_c_a", "dc_b * varied_rates.Omega_a_by_c_a"),
        ("step", "W_re * V_re - W_im * V_im", "W_re * V_re + W_im * V_im"),
    ],
)
def test_coq_refuses_a_false_step(computed, tmp_path, theorem, stated, claimed):
    test_coq_refuses_a_false_motion(computed, tmp_path, theorem, stated, claimed)
