"""What the README says is what the project does."""

import json
import re
import shlex
import shutil
import subprocess
import tomllib
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

import rigidsym
from rigidsym.cases import parse_case
from rigidsym.cli import _parser, main
from rigidsym.codegen.header import MEASURED_FILE
from rigidsym.paper import Ruling, verdicts
from rigidsym.solution import ledger_text
from rigidsym.validate.campaign import CASES, SEED
from rigidsym.validate.faults.tables import FAULTS
from rigidsym.validate.strata import STRATA, count, draw

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text()
LEDGER = json.loads(ledger_text())


FENCED = re.findall(r"^```(.*?)\n(.*?)^```$", README, re.DOTALL | re.MULTILINE)


def blocks(language):
    return [text for info, text in FENCED if info == language]


def test_the_counts_are_those_of_the_ledger():
    definitions = {c["name"]: c["definitions"] for c in LEDGER["contexts"]}
    restated = sum(
        len(f["lhs"]) == 1 and definitions[f["context"]].get(f["lhs"][0]) == f["rhs"][0]
        for f in LEDGER["facts"]
        if f["kind"] == "equal"
    )
    words = " ".join(README.split())
    assert f"{len(LEDGER['facts'])} facts in {len(LEDGER['contexts'])} contexts" in words
    assert f"{restated} of them definitions restated" in words
    rulings = [verdict.ruling for verdict in verdicts(LEDGER)]
    kinds = (Ruling.HOLDS, Ruling.CONDITIONAL, Ruling.MISPRINT, Ruling.AMBIGUOUS)
    counts = [rulings.count(r) for r in kinds]
    assert (
        "{} hold, {} hold under a condition, {} are misprints, {} ambiguous".format(*counts)
        in words
    )
    assert sum(counts) == len(rulings)
    assert "@@" not in README


def test_every_block_is_of_a_kind_that_is_run():
    """A block that cannot run says so by a second word: ```python no-run."""
    assert README.count("```") == 2 * len(FENCED)
    assert {info for info, _ in FENCED} <= {"", "python", "toml", "c", "python no-run", "c no-run"}


def test_the_python_runs(tmp_path, monkeypatch):
    """All of it, from top to bottom, as a reader would type it."""
    monkeypatch.chdir(tmp_path)
    scope = {}
    for code in blocks("python"):
        exec(code, scope)
    assert scope["q"].shape == (3, 4)
    assert np.isfinite(scope["omega"]).all()


@pytest.mark.parametrize("text", blocks("toml"))
def test_a_case_file_is_one(text, tmp_path, capsys):
    assert tomllib.loads(text)
    count = len(parse_case(text).times)
    path = tmp_path / "case.toml"
    path.write_text(text)
    assert main(["propagate", str(path)]) == 0
    assert len(capsys.readouterr().out.splitlines()) == count + 1


COMMANDS = [
    line.partition("#")[0].replace("uv run ", "").rpartition("&&")[2].strip()
    for block in blocks("")
    for line in block.splitlines()
    if re.search(r"(^|&& |uv run )rigidsym ", line)
]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_line_is_understood(command):
    """It is only parsed: what it does is tested where it is."""
    assert _parser().parse_args(shlex.split(command)[1:]).command


@pytest.mark.parametrize("command", re.findall(r"^\| `rigidsym (\w+)", README, re.MULTILINE))
def test_every_command_in_the_table_exists(command, capsys):
    with pytest.raises(SystemExit) as stop:
        main([command, "--help"])
    assert stop.value.code == 0


@pytest.mark.parametrize(
    "room", re.findall(r"^(rigidsym/\w+(?:\.py)?|derivations/) ", README, re.M)
)
def test_every_room_of_the_house_is_there(room):
    assert (ROOT / room).exists()
    assert rigidsym.__version__ in (ROOT / "CHANGELOG.md").read_text()


@pytest.mark.parametrize("program", blocks("c"))
def test_a_c_program_of_the_readme_compiles_and_runs(program, tmp_path):
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        pytest.skip("no C compiler here")
    (tmp_path / "main.c").write_text(program)
    rigidsym.generate("c").write(tmp_path)
    flags = re.search(r"`cc (.*?)`", README)[1].split()
    subprocess.run([compiler, *flags, "-o", "main"], cwd=tmp_path, check=True)
    found = subprocess.run([tmp_path / "main"], capture_output=True, text=True, check=True)
    expected = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))(180.0)[0]
    assert list(map(float, found.stdout.split())) == pytest.approx(expected.tolist(), abs=1e-15)


ACCURACY = {
    "the paper's spacecraft, 0 to 180 s; motions others published": ["paper", "published"],
    "uniform; every axis order and sign": ["uniform", "axis orders and signs"],
    "the same, long": ["long times", "longest times"],
    "1e-1 … 1e-16 from the separatrix, one ulp beside it": [
        "near separatrix",
        "beside separatrix",
        "near separatrix, long",
    ],
    "1e-17 … 1e-250 from the separatrix, by exact decimals": ["nearest separatrix"],
    "on the separatrix": ["separatrix"],
    "symmetric; nearly so, to 1e-16, and by decimals to 1e-300": [
        "symmetric",
        "near prolate",
        "near oblate",
        "nearest symmetric",
    ],
    "sphere; nearly so, to 1e-16, and by decimals to 1e-250": [
        "sphere",
        "near sphere",
        "nearest sphere",
    ],
    "spin; tilted from it by 1e-1 … 1e-300 (middle axis 1e-85); rest": [
        "spin",
        "near spin, largest",
        "near spin, middle",
        "near spin, smallest",
        "rest",
    ],
    "flat bodies, rods, needles (1e-1 … 1e-59)": ["flat", "rod", "needle"],
    "special values and attitudes": ["special values", "special attitudes"],
    "scales: moments 1e-322 … 1e306, rates 1e-298 … 1e297": [
        "scales",
        "small scales",
        "large scales",
        "extreme scales",
    ],
    "decimals that doubles only approximate": ["decimals"],
    "where the series change; zeros of the rates; quarter periods": [
        "branch switch",
        "zeros of the rates",
        "quarter periods",
    ],
}


def test_the_table_of_errors_is_what_was_recorded():
    """Of both modules, the larger; each stratum is in one row."""
    measured = json.loads(MEASURED_FILE.read_text())
    worst: dict = {}
    for target in measured.values():
        for name, *errors in target["worst"]:
            worst[name] = [max(pair) for pair in zip(errors, worst.get(name, errors), strict=True)]
    assert sorted(worst) == sorted(name for names in ACCURACY.values() for name in names)
    for motions, names in ACCURACY.items():
        (row,) = (line for line in README.splitlines() if line.startswith(f"| {motions}"))
        expected = [max(worst[name][k] for name in names) for k in (0, 1)]
        assert [float(cell) for cell in row.split("|")[-3:-1]] == expected


def test_the_counts_of_the_validation_are_those_of_the_code():
    """What `rigidsym validate` and `--faults` run by default; speeds are of their named command."""
    sizes = {name: count(name, CASES) for name in STRATA}
    drawn = [draw(name, k, SEED) for name, size in sizes.items() for k in range(size)]
    faults = Counter(fault.target for fault in FAULTS)
    for words in (
        f"all modules, {len(STRATA)} strata",
        f"{sum(sizes.values())} cases, {sum(len(s.times) for s in drawn)} states",
        f"{len(FAULTS)} faults against every stratum",
        f"{faults['numpy']} in the text of NumPy's module, {faults['c']} in\n  C's",
        f"{STRATA['published'].size} motions\n  published by other projects",
    ):
        assert words in README, words
