import copy
import json
import re
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

import derivations
from derivations.repairs import PRINTED
from rigidsym.proof.algebra.enclosures import encloses
from rigidsym.proof.kernel import replay
from rigidsym.proof.paper import (
    EQUATIONS,
    Condition,
    Equation,
    Flaw,
    Reading,
    Ruling,
    row,
    verdicts,
)
from rigidsym.proof.paper.verdicts import needed_units, ruling_of

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
FACTS = {fact["id"]: fact for fact in LEDGER["facts"]}
CONTEXTS = {context["name"]: context for context in LEDGER["contexts"]}
DECIDED = [equation for equation in EQUATIONS if equation.proved_by]
PROVING = [(e.number, name) for e in DECIDED for s in (e, *e.readings) for name in s.proved_by]
REFUTING = [(e.number, name) for e in DECIDED for s in (e, *e.readings) for name in s.refuted_by]
NECESSARY = [(e.number, name) for e in DECIDED for name in e.needed_by]
NEEDED = sorted({*PROVING, *REFUTING, *NECESSARY})
RULED = {verdict.equation.number: verdict for verdict in verdicts(LEDGER)}
OTHERS = ["Lemma 1", "footnote 1", "footnote 2", "Remark 1", "Theorem 1", "Remark 2", "footnote 3"]
OTHERS += ["R^-1 dR/dt", "Remark 3"]


def ruling(number, ledger=LEDGER):
    (verdict,) = (v for v in verdicts(ledger) if v.equation.number == number)
    return verdict


def changed(fact_id, **fields):
    ledger = copy.copy(LEDGER)
    ledger["facts"] = [fact | fields if fact["id"] == fact_id else fact for fact in LEDGER["facts"]]
    return ledger


def test_every_printed_equation_is_there_once():
    counted = Counter(e.number for e in EQUATIONS)
    assert set(counted.values()) == {1}
    assert set(counted) == {*map(str, range(1, 38)), *OTHERS}


def test_equations_come_in_the_papers_order():
    numbers = [e.number for e in EQUATIONS]
    assert [n for n in numbers if n.isdigit()] == [str(k) for k in range(1, 38)]
    assert [n for n in numbers if not n.isdigit()] == OTHERS
    neighbours = {(numbers[k - 1], n) for k, n in enumerate(numbers) if n in OTHERS}
    assert neighbours >= {("9", "Lemma 1"), ("15", "Remark 1"), ("17", "Theorem 1")}
    assert neighbours >= {("12", "footnote 2"), ("36", "Remark 3"), ("29", "R^-1 dR/dt")}


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda e: e.number)
def test_latex_is_balanced(equation):
    assert equation.latex.count("{") == equation.latex.count("}")
    assert len(re.findall(r"\\left\b", equation.latex)) == equation.latex.count(r"\right")
    assert equation.latex.count(r"\begin") == equation.latex.count(r"\end")


@pytest.mark.parametrize(("number", "name"), NEEDED)
def test_named_facts_are_sealed_with_the_right_kind(number, name):
    proving, refuting = (number, name) in PROVING, (number, name) in REFUTING
    assert not (proving and refuting)
    assert FACTS[name]["grade"] == "PROVED"
    if proving:
        assert FACTS[name]["kind"] in ("equal", "root")
    if refuting:
        assert FACTS[name]["kind"] == "unequal"


@pytest.mark.parametrize("equation", DECIDED, ids=lambda e: e.number)
def test_what_is_backed_is_not_open(equation):
    assert ruling(equation.number).ruling != Ruling.OPEN


def test_every_printed_equation_is_decided():
    assert list(EQUATIONS) == DECIDED


@pytest.mark.parametrize(("number", "name"), NEEDED)
def test_a_verdict_does_not_outlive_its_facts(number, name):
    without = LEDGER | {"facts": [fact for fact in LEDGER["facts"] if fact["id"] != name]}
    weakened = changed(name, grade="ASSUMED")
    turned = changed(name, kind="model")
    for ledger in (without, weakened, turned):
        assert ruling(number, ledger).ruling == Ruling.OPEN


CONDITIONS = [(verdict.equation, text) for verdict in RULED.values() for text in verdict.conditions]


@pytest.mark.parametrize(("equation", "text"), CONDITIONS, ids=lambda x: getattr(x, "number", x))
def test_every_condition_is_shown_necessary(equation, text):
    (condition,) = (c for c in equation.conditions if c.text == text)
    assert condition.needed_by


@pytest.mark.parametrize("equation", DECIDED, ids=lambda e: e.number)
def test_no_condition_speaks_for_units_that_no_proof_has(equation):
    units = needed_units(equation, FACTS, CONTEXTS)
    for condition in equation.conditions:
        assert not condition.units or {*condition.units} & {*units}


def test_units_that_no_condition_speaks_for_are_shown():
    equation = Equation("x", "", "", proved_by=("tangent.phi3",))
    units = needed_units(equation, FACTS, CONTEXTS)
    assert units == ["sin_phi2", "cos_phi3"]
    (verdict,) = (v for v in verdicts(LEDGER) if v.equation.number == "29")
    assert verdict.conditions == ("sin_phi2 != 0", "cos_phi3 != 0")


@pytest.mark.parametrize("number", ["9", "22"])
def test_the_start_has_to_commute_with_the_momentum(number):
    verdict = ruling(number)
    assert verdict.ruling == Ruling.CONDITIONAL
    assert verdict.conditions == ("R(0) M(0) = M(0) R(0)",)
    assert verdict.counterexample


def test_19_holds_on_either_side_with_the_sign_of_that_side():
    verdict = ruling("19")
    assert verdict.ruling == Ruling.CONDITIONAL
    assert verdict.conditions == ("S1*S2*c3*Omega3 > 0", "S3*S4 > 0")
    assert Flaw.SIGNS in verdict.equation.flaws


HOLDING = Reading("a", "", ("x",))
FAILING = Reading("b", "", ("x",), ("y",))
GIVEN = Condition("c", (), ("z",))


@pytest.mark.parametrize(
    ("fields", "conditions", "expected"),
    [
        ({}, (), Ruling.HOLDS),
        ({}, ("c",), Ruling.CONDITIONAL),
        ({"refuted_by": ("y",), "repair": "r"}, ("c",), Ruling.MISPRINT),
        ({"refuted_by": ("y",), "repair": "r", "readings": (HOLDING, FAILING)}, (), "misprint"),
        ({"readings": (HOLDING, FAILING)}, ("c",), Ruling.AMBIGUOUS),
        ({"readings": (HOLDING, HOLDING)}, (), Ruling.HOLDS),
        ({"readings": (FAILING,)}, ("c",), Ruling.OPEN),
        ({"refuted_by": ("y",), "conditions": (GIVEN,)}, ("c",), Ruling.CONDITIONAL),
    ],
)
def test_rulings(fields, conditions, expected):
    assert ruling_of(Equation("n", "", "", ("x",), **fields), conditions) == expected


def test_what_is_ambiguous_says_what_each_reading_implies():
    ambiguous = [v for v in RULED.values() if v.ruling == Ruling.AMBIGUOUS]
    assert [v.equation.number for v in ambiguous] == ["footnote 2", "Remark 1", "17", "Remark 3"]
    for verdict in ambiguous:
        readings = verdict.to_json()["readings"]
        assert {reading["holds"] for reading in readings} == {True, False}
        assert all(reading["implies"] for reading in readings)
        assert all(bool(r["counterexample"]) != r["holds"] for r in readings)


@pytest.mark.parametrize("number", ["Lemma 1", "10", "11", "12", "16", "20", "21", "Theorem 1"])
def test_roots_of_another_variable_are_misprints(number):
    assert ruling(number).ruling == Ruling.MISPRINT
    assert Flaw.VARIABLE in ruling(number).equation.flaws


def test_the_two_conditions_on_the_roots_differ_in_an_exact_motion():
    point = FACTS["two_conditions.differ"]["certificate"]["point"]
    values = {name: Fraction(value) for name, value in point.items()}
    for name, text in CONTEXTS["two_conditions"]["definitions"].items():
        values[name] = eval(text, {}, dict(values))
    s_i, s_j = values["s_i"], values["s_j"]
    assert s_j >= s_i
    assert abs(s_i / s_j) > 1


def test_the_real_form_fails_where_the_lemma_chooses_a_negative_root():
    point = FACTS["negative_root.amplitude"]["certificate"]["point"]
    values = {name: Fraction(value) for name, value in point.items()}
    for name, text in CONTEXTS["negative_root"]["definitions"].items():
        values[name] = eval(text, {}, dict(values))
    assert values["s_i"] < 0
    assert abs(values["s_i"] / values["s_j"]) <= 1
    root = (-values["beta"] + abs(values["alpha"] * (values["s_i"] - values["s_j"]))) / (
        2 * values["alpha"]
    )
    assert root == values["s_i"]


@pytest.mark.parametrize(("number", "symbol"), [("20", "C_{11}"), ("37", "R_{int}")])
def test_undefined_symbols_are_used_and_nowhere_defined(number, symbol):
    equation = ruling(number).equation
    assert equation.flaws[Flaw.UNDEFINED] == symbol
    assert symbol in equation.latex
    assert not any(re.search(re.escape(symbol) + r"\s*=", e.latex) for e in EQUATIONS)


def test_every_undefined_symbol_is_in_the_print():
    flawed = [e for e in EQUATIONS if Flaw.UNDEFINED in e.flaws]
    assert len(flawed) >= 5
    assert all(e.flaws[Flaw.UNDEFINED] in e.latex for e in flawed)


# Misprints whose repair is not one small edit of one formula.
NO_SMALL_REPAIR = {
    "Lemma 1": "two edits of (14) at once",
    "Theorem 1": "that of (20) and that of Remark 2",
    "footnote 3": "words",
}
MISPRINTS = [v for v in RULED.values() if v.ruling == Ruling.MISPRINT]


@pytest.fixture(scope="module")
def sealed():
    return replay(json.dumps(LEDGER, indent=1, ensure_ascii=False) + "\n", encloses)


@pytest.mark.parametrize("verdict", MISPRINTS, ids=lambda v: v.equation.number)
def test_the_search_finds_the_repair_that_is_printed(verdict, sealed):
    equation = verdict.equation
    assert bool(equation.repair_form) != (equation.number in NO_SMALL_REPAIR)
    if equation.repair_form:
        place, _, form = equation.repair_form.partition(" = ")
        rings = [sealed.rings[FACTS[name]["context"]] for name in equation.refuted_by]
        found = [r.partition(" = ")[2] for r in verdict.repairs if r.startswith(f"{place} = ")]
        assert any(_same(ring, form, text) for ring in rings for text in found)


def _same(ring, left, right):
    try:
        return not ring.reduce((ring.read(left) - ring.read(right)).numerator)[1]
    except ValueError:
        return False


def test_every_refuted_line_of_a_misprint_is_searched_or_is_no_single_formula():
    refuting = {name for verdict in MISPRINTS for name in verdict.equation.refuted_by}
    assert {*PRINTED} <= refuting
    assert refuting - {*PRINTED} == {
        "distinct_axis.not_roots_in_momentum",  # two edits of (14) at once
        "signed.any_S1_S2",  # signs that no constant mends
        "crossing.continuous",
        "signed.reflection",  # words
    }


def test_a_row_shows_flaws_readings_and_repairs():
    _, verdict, repair, point = row(ruling("36"))
    assert "wrong left side" in verdict
    assert "found: phi1 = K/c1*t + kappa*Pi" in repair
    assert "mu = 9/16" in point
    assert "fails" in row(ruling("Remark 3"))[2]
    assert row(ruling("29"))[1] == "holds if sin_phi2 != 0, cos_phi3 != 0"


def test_35_is_a_misprint_and_its_counterexample_tells_why():
    verdict = ruling("35")
    assert verdict.ruling == Ruling.MISPRINT
    assert verdict.equation.repair
    point = {name: Fraction(value) for name, value in verdict.counterexample.items()}
    sn, cn, dn, mu, xi = (point[name] for name in ("sn", "cn", "dn", "mu", "xi"))
    assert sn**2 + cn**2 == 1
    assert dn**2 + mu * sn**2 == 1
    rate = Fraction(eval(CONTEXTS["amplitude"]["rates"]["theta"], {"xi": xi, "dn": dn}))
    assert rate**2 != xi**2 * (1 - mu**2 * sn**2)
    assert rate**2 == xi**2 * (1 - mu * sn**2)


@pytest.mark.parametrize("name", ["moving_body.any_start", "amplitude.printed"])
def test_counterexamples_break_the_printed_equation_in_exact_numbers(name):
    fact = FACTS[name]
    context = CONTEXTS[fact["context"]]
    values = {key: Fraction(value) for key, value in fact["certificate"]["point"].items()}
    relations = [eval(relation, {}, dict(values)) for relation in context["relations"]]
    assert set(relations) == {0}
    for key, text in context["definitions"].items():
        values[key] = eval(text, {}, dict(values))
    rates = {key: eval(text, {}, dict(values)) for key, text in context["rates"].items()}
    scope = {"D": lambda name: rates[name]}
    texts = [text.replace("D(theta)", "D('theta')") for text in (*fact["lhs"], *fact["rhs"])]
    sides = [eval(text, scope, dict(values)) for text in texts]
    half = len(sides) // 2
    assert sides[:half] != sides[half:]


def test_verdicts_are_plain_data():
    data = json.loads(json.dumps([verdict.to_json() for verdict in verdicts(LEDGER)]))
    assert [entry["equation"] for entry in data] == [e.number for e in EQUATIONS]
    assert {entry["verdict"] for entry in data} <= {r.value for r in Ruling}
