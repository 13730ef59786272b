"""Numbers in README and pages are those that the code gives."""

import json
import re
from collections import Counter

import pytest
from document_texts import ROOT, TEXTS, blocks, rows, words
from ledgers import LEDGER

import rigidsym
from rigidsym._codegen.header import MEASURED_FILE
from rigidsym._codegen.seal import seal
from rigidsym._codegen.trace import told
from rigidsym.proof.paper import Ruling, judged, verdicts
from rigidsym.proof.paper._table import causes
from rigidsym.solution import sealed
from rigidsym.validate._campaign import CASES, SEED
from rigidsym.validate._oracle import SECOND_SHARE, is_due
from rigidsym.validate.faults import all_faults
from rigidsym.validate.strata import STRATA, count, draw

FAULTS = all_faults()
GRADES = Counter(fact["grade"] for fact in LEDGER["facts"])
FACTS, CONTEXTS = len(LEDGER["facts"]), len(LEDGER["contexts"])
MEASURED = json.loads(MEASURED_FILE.read_text("utf-8"))


def rulings():
    found = [verdict.ruling for verdict in verdicts(LEDGER)]
    kinds = (Ruling.HOLDS, Ruling.CONDITIONAL, Ruling.MISPRINT, Ruling.AMBIGUOUS)
    counts = [found.count(kind) for kind in kinds]
    assert sum(counts) == len(found)
    return "{} hold, {} hold under a condition, {} are misprints, {} ambiguous".format(*counts)


def explanation():
    numeral = {2: "two", 3: "three", 4: "four"}[len(causes(verdicts(LEDGER)))]
    return f"the misprints have {numeral} causes"


def worst():
    """Return the largest errors of both modules by stratum: angle, and rates."""
    found: dict = {}
    for target in ("numpy", "c"):
        for name, *errors in MEASURED[target]["worst"]:
            found[name] = [max(pair) for pair in zip(errors, found.get(name, errors), strict=True)]
    return found


def test_the_counts_are_those_of_the_ledger():
    entries = [e for entries in LEDGER["published"]["sequences"].values() for e in entries]
    defined = {(e["context"], e["definition"]) for e in entries if "definition" in e}
    text = words("proofs.md")
    assert f"{FACTS} facts in {CONTEXTS} contexts" in text
    assert f"{len(defined)} definitions that numbers need" in text
    assert f"{GRADES['PROVED']} facts are PROVED" in text
    assert f"The other {GRADES['ENCLOSED']} rests on" in text
    assert rulings() in text
    assert explanation() in text
    assert len(judged(LEDGER)) == 9
    assert "Nine claims that the paper makes in words" in text


def test_trust_has_the_same_counts():
    text = words("trust.md")
    assert f"It has {FACTS} of them in {CONTEXTS} contexts" in text
    assert all(f"**{grade}** ({number} fact" in text for grade, number in GRADES.items())
    assumptions = Counter(fact["rule"] for fact in LEDGER["facts"])["assumption"]
    assert assumptions == 1
    assert "One fact is an *assumption*" in text
    assert f"{seal(sealed())} statements" in text
    assert f"from {len(STRATA)} named strata" in text
    assert f"{len(FAULTS)} faults put into" in text


def test_how_often_taylor_series_check_is_said_right():
    share = SECOND_SHARE // sum(map(is_due, range(SECOND_SHARE)))
    assert [is_due(k) for k in range(3)] == [True, True, False]
    for name in ("trust.md", "validation.md"):
        assert f"check one case in {share}, the first two of each stratum among" in words(name)


def numbers(row):
    return re.findall(r"\d[\d.]*(?:e-\d+)?", row[1])


def test_the_table_of_the_readme():
    """Find rows by their command; what is only measured has to be in a page as well."""
    table = {row[-1]: row for row in rows("README.md") if row[-1].startswith("`")}
    assert table["`rigidsym errata`"][1] == f"{rulings()}; {explanation()}"
    assert numbers(table["`rigidsym derive`"]) == [str(n) for _, n in sorted(GRADES.items())[::-1]]
    assert numbers(table["`rigidsym codegen c --check`"]) == [str(seal(sealed()))]
    shares = [line.split()[0] for line in told("torque_free.py")[1:]]
    assert numbers(table["`rigidsym trace torque_free.py`"]) == shares
    errors = [max(column) for column in zip(*worst().values(), strict=True)]
    row = table["`rigidsym validate numpy c --cases 200`"]
    assert [float(number) for number in numbers(row)] == errors
    assert f"{len(STRATA)} strata" in row[0]
    assert numbers(table["`rigidsym validate --faults`"]) == [str(len(FAULTS))]


@pytest.mark.parametrize(
    ("command", "page"),
    [
        ("`python tests/benchmarks/precise.py`", "digits.md"),
        ("`python tests/benchmarks/generated.py`", "accuracy.md"),
        ("`rigidsym reproduce`", "accuracy.md"),
        ("`rigidsym check`; `rigidsym check --independent`", "accuracy.md"),
    ],
)
def test_times_in_the_readme_are_those_of_a_page(command, page):
    (row,) = (row for row in rows("README.md") if row[-1] == command)
    for number in numbers(row):
        assert re.search(rf"(?<![\d.]){re.escape(number)}(?![\d.]\d)", TEXTS[page]), number


def test_the_map_of_packages_is_that_of_the_folders():
    (text,) = (text for text in blocks("text", "CONTRIBUTING.md"))
    folders = set(re.findall(r"^ {2}(\w+)/ ", text, re.MULTILINE))
    assert folders == {path.parent.name for path in ROOT.glob("rigidsym/*/__init__.py")}
    lines = re.findall(r"^ {2}(\w+\.py .*)", text, re.MULTILINE)
    modules = {name for line in lines for name in re.findall(r"\b\w+\.py\b", line)}
    assert modules == {x.name for x in ROOT.glob("rigidsym/*.py") if x.name[:2] != "__"} - {
        "_version.py"
    }


def test_the_page_of_what_is_stable_lists_the_public_modules():
    paths = (ROOT / "rigidsym").rglob("*.py")
    parts = (path.relative_to(ROOT).with_suffix("").parts for path in paths)
    names = {".".join(one).removesuffix(".__init__") for one in parts}
    public = {name for name in names if "._" not in name}
    listed = {
        name for row in rows("stability.md") for name in re.findall(r"`(rigidsym[\w.]*)`", row[0])
    }
    assert listed == {n for n in public if not n.startswith("rigidsym.generated.")}


def test_every_schema_is_on_the_page_of_what_is_stable():
    written = {
        schema
        for path in (ROOT / "rigidsym").rglob("*.py")
        for schema in re.findall(r"\"(rigidsym\.\w+/\d+)\"", path.read_text("utf-8"))
    }
    assert {row[0].strip("`") for row in rows("stability.md") if "/" in row[0]} == written


def test_the_changelog_has_this_version():
    assert rigidsym.__version__ in (ROOT / "CHANGELOG.md").read_text("utf-8")


# Strata by the row that has them.
ACCURACY = {
    "the paper's spacecraft; motions others published": ["paper", "published"],
    "uniform; every axis order and sign": ["uniform", "axis orders and signs"],
    "the same, evenly over longer times": ["long times", "longest times"],
    "1e-1 … 1e-16 from the separatrix, one ulp beside it":
        ["near separatrix", "beside separatrix", "near separatrix, long"],
    "1e-17 … 1e-250 from the separatrix, by exact decimals": ["nearest separatrix"],
    "on the separatrix": ["separatrix"],
    "symmetric; nearly so, to 1e-16, and by decimals to 1e-300":
        ["symmetric", "near prolate", "near oblate", "nearest symmetric"],
    "sphere; nearly so, to 1e-16, and by decimals to 1e-250":
        ["sphere", "near sphere", "nearest sphere"],
    "spin; tilted from it by 1e-1 … 1e-300 (middle axis 1e-85); rest":
        ["spin", "near spin, largest", "near spin, middle", "near spin, smallest", "rest"],
    "flat bodies, rods, needles (1e-1 … 1e-59)": ["flat", "rod", "needle"],
    "special values and attitudes": ["special values", "special attitudes"],
    "scales: moments 1e-322 … 1e306, rates 1e-298 … 1e297":
        ["scales", "small scales", "large scales", "extreme scales"],
    "decimals that doubles only approximate": ["decimals"],
    "where the series change; zeros of the rates; quarter periods":
        ["branch switch", "zeros of the rates", "quarter periods"],
}  # fmt: skip


def test_the_table_of_errors_is_what_was_recorded():
    """Compare with the larger error of both modules; each stratum is in one row."""
    found, text = worst(), TEXTS["accuracy.md"]
    assert sorted(found) == sorted(name for names in ACCURACY.values() for name in names)
    for motions, names in ACCURACY.items():
        (row,) = (line for line in text.splitlines() if line.startswith(f"| {motions}"))
        expected = [max(found[name][k] for name in names) for k in (0, 1)]
        assert [float(cell) for cell in row.split("|")[-3:-1]] == expected


def test_the_counts_of_the_validation_are_those_of_the_code():
    """Compare with what `rigidsym validate` and `--faults` run by default."""
    sizes = {name: count(name, CASES) for name in STRATA}
    drawn = [draw(name, k, SEED) for name, size in sizes.items() for k in range(size)]
    faults = Counter(fault.target for fault in FAULTS)
    others = sum(fault.target.partition("-")[0] not in ("numpy", "c") for fault in FAULTS)
    text = words("validation.md")
    for said in (
        f"all modules, {len(STRATA)} strata",
        f"{sum(sizes.values())} cases, {sum(len(s.times) for s in drawn)} states",
        f"{len(FAULTS)} faults against every stratum",
        f"{faults['numpy']} in NumPy's module, {faults['c']} in C's, {others} in those of other "
        f"targets, {faults['numpy-pi'] + faults['c-pi']} in what is the Pi modules' own, "
        f"{faults['numpy-step'] + faults['c-step']} in those of steps and torques",
        f"{STRATA['published'].size} motions published by other projects",
    ):
        assert said in text, said
