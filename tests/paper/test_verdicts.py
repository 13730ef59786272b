import copy
import json
import re
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

import derivations
from rigidsym.paper import EQUATIONS, Ruling, verdicts

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
FACTS = {fact["id"]: fact for fact in LEDGER["facts"]}
CONTEXTS = {context["name"]: context for context in LEDGER["contexts"]}
DECIDED = [equation for equation in EQUATIONS if equation.proved_by]
NEEDED = [(e.number, name) for e in DECIDED for name in (*e.proved_by, *e.refuted_by, *e.needed_by)]


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
    assert {number for number in counted if number.isdigit()} == {str(k) for k in range(1, 38)}


def test_equations_come_in_the_papers_order():
    numbers = [int(e.number) for e in EQUATIONS if e.number.isdigit()]
    assert numbers == sorted(numbers)


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda e: e.number)
def test_latex_is_balanced(equation):
    assert equation.latex.count("{") == equation.latex.count("}")
    assert len(re.findall(r"\\left\b", equation.latex)) == equation.latex.count(r"\right")
    assert equation.latex.count(r"\begin") == equation.latex.count(r"\end")


@pytest.mark.parametrize(("number", "name"), NEEDED)
def test_named_facts_are_sealed_with_the_right_kind(number, name):
    (equation,) = (e for e in EQUATIONS if e.number == number)
    kinds = ("unequal",) if name in equation.refuted_by else ("equal", "root")
    assert FACTS[name]["grade"] == "PROVED"
    assert FACTS[name]["kind"] in kinds


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


@pytest.mark.parametrize("number", ["9", "22"])
def test_the_start_at_the_identity_is_a_condition(number):
    verdict = ruling(number)
    assert verdict.ruling == Ruling.CONDITIONAL
    assert verdict.conditions[0] == "R(0) = e"
    assert verdict.counterexample


@pytest.mark.parametrize(
    ("number", "condition"), [("29", "cos_phi3 != 0"), ("32", "sin_phi2 != 0")]
)
def test_a_division_of_the_paper_is_a_condition(number, condition):
    verdict = ruling(number)
    assert verdict.ruling == Ruling.CONDITIONAL
    assert condition in verdict.conditions


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
