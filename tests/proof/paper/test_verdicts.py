"""Verdicts on the printed equations: rulings, conditions, counterexamples and repairs."""

import copy
import json
import re
from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

import derivations
from derivations.repairs import PRINTED
from rigidsym import TorqueFreeMotion
from rigidsym.proof.kernel import Context
from rigidsym.proof.kernel._rules import _frozen
from rigidsym.proof.paper import EQUATIONS, Flaw, Root, Ruling, _answers, judged, verdicts
from rigidsym.proof.paper import _table as table
from rigidsym.proof.paper._answers import Answers, question
from rigidsym.proof.paper._table import counted, details, row
from rigidsym.proof.paper._verdicts import needed_units, ruling_of
from rigidsym.proof.paper._verdicts import verdict as verdict_on

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
FACTS = {fact["id"]: fact for fact in LEDGER["facts"]}
CONTEXTS = {context["name"]: context for context in LEDGER["contexts"]}
RULED = {verdict.equation.number: verdict for verdict in verdicts(LEDGER)}
PRINT = {equation.number: equation for equation in EQUATIONS}
NEEDED = sorted((number, name) for number, v in RULED.items() for name in v.facts())
OTHERS = ["Lemma 1", "footnote 1", "footnote 2", "Remark 1", "Theorem 1", "Remark 2", "footnote 3"]
OTHERS += ["R^-1 dR/dt", "Remark 3"]


@pytest.fixture(autouse=True, scope="module")
def questions_once():
    """Translate each line once, since no question depends on the ledger."""
    known = {}

    def once(latex, sense, printed):
        if (key := (latex, id(sense))) not in known:
            known[key] = question(latex, sense, printed)
        return known[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_answers, "question", once)
        yield


def ruling(number, ledger=LEDGER):
    return verdict_on(PRINT[number], Answers(ledger, EQUATIONS), ledger["published"])


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


def test_every_printed_equation_is_decided():
    assert [v.equation.number for v in RULED.values() if v.ruling == Ruling.OPEN] == []
    assert all(verdict.facts() for verdict in RULED.values())


@pytest.mark.parametrize(("number", "name"), NEEDED)
def test_a_verdict_rests_on_what_facts_say_and_not_on_their_names(number, name):
    fact = FACTS[name]
    without = LEDGER | {"facts": [fact for fact in LEDGER["facts"] if fact["id"] != name]}
    other = changed(name, lhs=[f"2*({fact['lhs'][0]})", *fact["lhs"][1:]])
    weaker = changed(name, grade="ASSUMED")
    turned = changed(name, kind="model")
    elsewhere = changed(name, context="body" if fact["context"] != "body" else "axis")
    for ledger in (without, other, weaker, turned, elsewhere):
        assert ruling(number, ledger).ruling == Ruling.OPEN
    renamed = changed(name, id=f"{fact['context']}.by_another_name")
    assert ruling(number, renamed).ruling == RULED[number].ruling


@pytest.mark.parametrize("number", ["5", "6", "14", "20"])
def test_a_context_that_defines_something_else_answers_nothing(number):
    (sense,) = PRINT[number].senses
    contexts = []
    for context in LEDGER["contexts"]:
        if context["name"] == sense.context:
            name = next(iter(sense.defines.values()))
            assert name in context["definitions"]
            context = context | {"definitions": context["definitions"] | {name: "1"}}
        contexts.append(context)
    assert ruling(number, LEDGER | {"contexts": contexts}).ruling == Ruling.OPEN


CONDITIONS = [(verdict.equation, text) for verdict in RULED.values() for text in verdict.conditions]


@pytest.mark.parametrize(("equation", "text"), CONDITIONS, ids=lambda x: getattr(x, "number", x))
def test_every_condition_is_shown_necessary(equation, text):
    (condition,) = (c for c in equation.conditions if c.text == text)
    assert condition.needed_by
    assert RULED[equation.number].needed_by[text]


def test_units_that_no_condition_speaks_for_are_shown():
    answers = Answers(LEDGER, EQUATIONS)
    answer = answers.to(PRINT["29"].latex, PRINT["29"].senses[0])
    assert needed_units([answer], answers) == ["sin_phi2", "cos_phi3"]
    assert RULED["29"].conditions == ("sin_phi2 != 0", "cos_phi3 != 0")


@pytest.mark.parametrize("number", ["9", "22"])
def test_the_start_has_to_commute_with_the_momentum(number):
    verdict = ruling(number)
    assert verdict.ruling == Ruling.CONDITIONAL
    assert verdict.conditions == ("R(0) M(0) = M(0) R(0)",)
    assert verdict.counterexample


def test_19_holds_on_either_side_with_the_sign_of_that_side():
    verdict = ruling("19")
    assert verdict.ruling == Ruling.CONDITIONAL
    assert verdict.conditions[:2] == ("S1*S2*c3*Omega3 > 0", "S3*S4 > 0")


@pytest.mark.parametrize(
    ("holds", "mended", "readings", "conditions", "expected"),
    [
        (True, False, (), (), Ruling.HOLDS),
        (True, False, (), ("c",), Ruling.CONDITIONAL),
        (False, True, (), ("c",), Ruling.MISPRINT),
        (False, True, (True, False), (), Ruling.MISPRINT),
        (False, False, (), (), Ruling.OPEN),
        (False, None, (True, False), (), Ruling.OPEN),
        (None, True, (), (), Ruling.OPEN),
        (True, False, (True, False), ("c",), Ruling.AMBIGUOUS),
        (True, False, (True, True), (), Ruling.HOLDS),
        (True, False, (False,), ("c",), Ruling.OPEN),
        (True, False, (True, None), (), Ruling.OPEN),
    ],
)
def test_rulings(holds, mended, readings, conditions, expected):
    assert ruling_of(holds, mended, readings, conditions) == expected


def test_what_is_ambiguous_says_what_each_reading_implies():
    ambiguous = [v for v in RULED.values() if v.ruling == Ruling.AMBIGUOUS]
    found = [v.equation.number for v in ambiguous]
    assert found == ["footnote 2", "14", "Remark 1", "17", "Remark 3"]
    for verdict in ambiguous:
        readings = verdict.to_json()["readings"]
        assert {reading["holds"] for reading in readings} == {True, False}
        assert all(reading["implies"] for reading in readings)
        assert all(bool(r["counterexample"]) != r["holds"] for r in readings)


@pytest.mark.parametrize("number", ["Lemma 1", "10", "11", "12", "16", "20", "21", "Theorem 1"])
def test_roots_of_another_variable_are_misprints(number):
    assert RULED[number].ruling == Ruling.MISPRINT
    assert Flaw.VARIABLE in PRINT[number].flaws


@pytest.mark.parametrize(
    ("number", "flaw", "text"),
    [
        ("19", Flaw.SIGNS, "unless axis 3 is the circulation axis"),
        ("29", Flaw.BRANCH, "half turns"),
        ("Theorem 1", Flaw.JUMP, "phi3 passes pi"),
        ("footnote 3", Flaw.JUDGEMENT, "what is refuted is an interpretation"),
    ],
)
def test_flaws_are_explained(number, flaw, text):
    assert text in PRINT[number].flaws[flaw]


def test_the_two_conditions_on_the_roots_differ_in_an_exact_motion():
    point = FACTS["two_conditions.differ"]["certificate"]["point"]
    values = _values(CONTEXTS["two_conditions"], point)
    s_i, s_j = values["s_i"], values["s_j"]
    assert s_j >= s_i
    assert abs(s_i / s_j) > 1


def test_the_real_form_fails_where_the_lemma_chooses_a_negative_root():
    point = FACTS["negative_root.amplitude"]["certificate"]["point"]
    values = _values(CONTEXTS["negative_root"], point)
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


@pytest.mark.parametrize("verdict", MISPRINTS, ids=lambda v: v.equation.number)
def test_the_search_finds_the_repair_that_is_printed(verdict):
    number = verdict.equation.number
    assert bool(verdict.repairs) != (number in NO_SMALL_REPAIR)
    for line, left, place in PRINTED:
        if line == number and (line, place) != ("36", "lhs"):
            context, mended = _repair(verdict.equation, left, place)
            ring = Context(**_frozen(CONTEXTS[context])).open()
            found = [r.partition(" = ")[2] for r in verdict.repairs]
            assert any(_same(ring, mended, text) for text in found)


def _repair(equation, left, place):
    """Return the context and text of the printed repair at the place that was searched."""
    asked = [question(equation.repair, sense, PRINT) for sense in equation.mended]
    if place in ("lhs", "rhs"):
        (whole,) = (q for q in asked if left in q.lhs)
        return whole.context, whole.rhs[whole.lhs.index(left)]
    (whole,) = (q for q in asked if place in q.definitions)
    return whole.context, whole.definitions[place]


def _same(ring, left, right):
    try:
        return not ring.remainder((ring.read(left) - ring.read(right)).numerator)
    except ValueError:
        return False


def test_every_misprint_is_searched_or_is_no_single_formula():
    numbers = {verdict.equation.number for verdict in MISPRINTS}
    assert numbers == {line for line, *_ in PRINTED} | {*NO_SMALL_REPAIR}


def test_only_four_slips_are_independent():
    causes = {verdict.equation.number: verdict.roots for verdict in MISPRINTS}
    assert {root for roots in causes.values() for root in roots} == {*Root}
    assert all(causes.values())
    assert causes["footnote 3"] == causes["Remark 2"] == (Root.HALF_ANGLE,)
    assert causes["11"] == causes["20"] == (Root.SCALE,)
    assert causes["36"] == (Root.MODULUS, Root.DOT)


@pytest.mark.parametrize("number", ["10", "11", "12", "16", "20", "21"])
def test_lines_on_the_roots_are_right_as_printed_once_14_is_mended(number):
    assert RULED[number].right_with == ("14",)
    assert ("right as printed", "once (14) is mended") in details(RULED[number])


# Statements about all motions, and what speaks of none: quaternions, footnote 1.
MOVING = ["Lemma 1", "10", "11", "12", "16", "Theorem 1", "20", "21", "36", "35", "Remark 2"]


@pytest.mark.parametrize("number", MOVING)
def test_counterexamples_are_motions_with_printed_and_true_value(number):
    found = RULED[number].counterexample
    assert found.left != found.right
    motion = TorqueFreeMotion([*map(str, found.motion.inertia)], [*map(str, found.motion.omega)])
    assert motion.regime
    assert str(found.motion) in row(RULED[number])[3]
    (fails,) = (text for name, text in details(RULED[number]) if name == "fails at")
    assert str(found.motion) in fails
    assert str(found.left) in fails


@pytest.mark.parametrize("name", ["printed_sine", "printed_20", "printed_35", "printed_36"])
def test_amplitudes_at_a_point_are_those_of_the_motion(name):
    point = {k: Fraction(v) for k, v in CONTEXTS[name]["witness"].items()}
    motion = next(
        v.counterexample.motion
        for v in RULED.values()
        if v.counterexample and v.counterexample.fact.startswith(f"{name}.")
    )
    (c1, c2, c3), (w1, w2, w3) = motion.inertia, motion.omega
    H = (c1 * w1**2 + c2 * w2**2 + c3 * w3**2) / 2
    KK = (c1 * w1) ** 2 + (c2 * w2) ** 2 + (c3 * w3) ** 2
    alpha = -(c1 - c2) * (c1 - c3) / (c2 * c3)
    roots = [(KK - 2 * H * c) / (c1 * (c1 - c)) for c in (c2, c3)]
    assert {"zeta", "xi", "sn", "cn"} <= {*point}
    zeta, xi, sn, cn = (point[k] for k in ("zeta", "xi", "sn", "cn"))
    dn = point["dn"] if "dn" in point else point["w"] / point["root_s"]
    assert zeta**2 in roots
    (other,) = {*roots} - {zeta**2}
    assert xi**2 == alpha * other
    assert w1 == zeta * sn
    assert xi * zeta * cn * dn == (c2 - c3) / c1 * w2 * w3
    assert point.get("c_i", point.get("c1")) == c1
    assert (point.get("H", H), point.get("K", 0) ** 2 or KK) == (H, KK)
    assert point.get("mu", zeta**2 / other) == zeta**2 / other


def test_readings_that_fail():
    rate, momentum = RULED["14"].readings
    assert (rate.holds, momentum.holds) == (True, False)
    negative_root = RULED["Lemma 1"].readings[3]
    assert not negative_root.holds
    assert "never s_j" in negative_root.reading.implies
    second_condition = RULED["Remark 1"].readings[3]
    assert second_condition.holds is False
    found = second_condition.counterexample
    assert Fraction(found.left) == -Fraction(found.right)


def test_a_row_shows_the_verdict_and_what_mends_it():
    number, verdict, repair, fails = row(ruling("36"))
    assert (number, verdict) == ("(36)", "misprint")
    assert repair.startswith("φ₁(t)=∫(K/c₁)dt+")
    assert str(ruling("36").counterexample.motion) == fails
    assert row(ruling("29"))[1] == "holds if sin_phi2 != 0, cos_phi3 != 0"
    assert row(ruling("29"))[2] == ruling("29").equation.reading


def test_details_show_flaws_causes_readings_and_repairs():
    told = [*details(ruling("36"))]
    said = dict(told)
    assert said["printed"].startswith("φ̇₁=∫(K/c₁)dt+")
    assert any("mu^2 is printed for mu" in text for name, text in told if name == "root cause")
    assert said["found by search"].startswith("D(phi1) = K / c1 + sigma_printed")
    assert "mu = 49/225" in said["fails at"]
    assert any(text.startswith("wrong left side") for name, text in told if name == "flaw")
    assert any("fails" in x for name, x in details(ruling("Remark 3")) if name == "reading")


def test_nothing_is_left_of_the_latex():
    """Every line, repair and symbol has a form in plain text."""
    for verdict in RULED.values():
        for _, text in details(verdict):
            assert not set("\\{}$") & set(text)


def test_rulings_are_counted():
    assert counted([ruling("36"), ruling("35"), ruling("6")]) == "1 hold, 2 are misprints"


def test_35_is_a_misprint_and_its_counterexample_tells_why():
    verdict = ruling("35")
    assert verdict.ruling == Ruling.MISPRINT
    assert verdict.equation.repair
    point = {name: Fraction(value) for name, value in verdict.counterexample.point.items()}
    sn, cn, dn, mu, xi = (point[name] for name in ("sn", "cn", "dn", "mu", "xi"))
    assert sn**2 + cn**2 == 1
    assert dn**2 + mu * sn**2 == 1
    rate = Fraction(eval(CONTEXTS["amplitude"]["rates"]["theta"], {"xi": xi, "dn": dn}))
    assert rate**2 != xi**2 * (1 - mu**2 * sn**2)
    assert rate**2 == xi**2 * (1 - mu * sn**2)


REFUTED = [v for v in RULED.values() if v.counterexample]


def _values(context, point):
    """Return the values of all names of a context at a point."""
    values = {key: Fraction(value) for key, value in point.items()}
    waiting = {k: v for k, v in context["definitions"].items() if "D(" not in v}
    while waiting:
        known = {k: v for k, v in waiting.items() if not _names(v) & {*waiting}}
        values |= {key: eval(text, {}, dict(values)) for key, text in known.items()}
        waiting = {k: v for k, v in waiting.items() if k not in known}
    return values


def _names(text):
    return {*re.findall(r"[A-Za-z_]\w*", text)}


@pytest.mark.parametrize("verdict", REFUTED, ids=lambda v: v.equation.number)
def test_counterexamples_break_the_printed_equation_in_exact_numbers(verdict):
    found = verdict.counterexample
    context = CONTEXTS[FACTS[found.fact]["context"]]
    values = _values(context, found.point)
    assert {eval(relation, {}, dict(values)) for relation in context["relations"]} <= {0}
    for text, value in ((found.lhs, found.left), (found.rhs, found.right)):
        if "D(" not in text:
            exact = re.sub(r"(?<![\w*])(\d+)", r"Fraction(\1)", text)
            assert eval(exact, {"Fraction": Fraction}, dict(values)) == value
    assert found.left != found.right


def test_three_errors_explain_all_misprints():
    every = [*RULED.values()]
    found = table.causes(every)
    assert [*found] == [Root.SCALE, Root.HALF_ANGLE, Root.MODULUS]
    misprints = {v.equation.number for v in every if v.ruling is Ruling.MISPRINT}
    assert {number for numbers in found.values() for number in numbers} == misprints
    # No two of them do.
    for root in found:
        rest = {n for other, numbers in found.items() if other != root for n in numbers}
        assert rest < misprints
    text = table.explained(every)
    assert text.startswith("the misprints have 3 causes: ")
    assert text.endswith(f"besides, {Root.DOT} (36)")
    assert not table.explained([v for v in every if v.ruling is Ruling.HOLDS])


def test_verdicts_are_plain_data():
    data = json.loads(json.dumps([verdict.to_json() for verdict in verdicts(LEDGER)]))
    assert [entry["equation"] for entry in data] == [e.number for e in EQUATIONS]
    assert {entry["verdict"] for entry in data} <= {r.value for r in Ruling}


def test_claims_in_words_are_judgements_that_name_what_decides_them():
    found = judged(LEDGER)
    assert len(found) == 9
    assert all(claim.facts or claim.prose.commands for claim in found)
    assert all(claim.decided for claim in found)
    assert {*FACTS} >= {name for claim in found for name in claim.facts}


def test_a_claim_in_words_is_open_without_its_facts():
    for claim in judged(LEDGER):
        for name in claim.facts:
            left = [fact for fact in LEDGER["facts"] if fact["id"] != name]
            assert "open" in {c.judgement for c in judged(LEDGER | {"facts": left})}
