"""Every change of a coefficient, sign, index or exponent in print changes a verdict."""

import json
from dataclasses import asdict, replace
from itertools import groupby, takewhile
from pathlib import Path

import pytest
from house import imported
from misprints import misprints

import derivations
from derivations import printed
from rigidsym.io.ledger import ledger_text
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._mutants import PRINTED
from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger
from rigidsym.proof.kernel._rules import _frozen
from rigidsym.proof.paper import EQUATIONS
from rigidsym.proof.paper._answers import Answers, asked, question
from rigidsym.proof.paper._printed import PrintError
from rigidsym.proof.paper._verdicts import verdict

# Changes that leave the meaning as it is, each with a reason; and what is not said in formulas.
HARMLESS = {
    ("19", "sign", "-D;"): "D is any constant",
    ("Lemma 1", "axis", r"\Omega_j(t)"): "the lemma is in words, and i any axis",
    ("footnote 2", "number", r"\mathbb C^3"): "a remark in words",
}
PLACES = ("latex", "repair")


@pytest.fixture(scope="module")
def forward():
    """Return the sealed ledger before the chapter on the print, also as data."""
    data, ledger = json.loads(ledger_text()), Ledger()
    for entry in takewhile(lambda entry: "printed" not in entry["name"], data["contexts"]):
        ledger.open(Context(**_frozen(entry)))
    for entry in takewhile(lambda entry: PRINTED not in entry["id"], data["facts"]):
        ledger.facts[entry["id"]] = Fact(**_frozen(entry))
    return ledger, _data(ledger, Ledger())


def _data(ledger, before):
    contexts = [c for name, c in ledger.contexts.items() if name not in before.contexts]
    facts = [f for name, f in ledger.facts.items() if name not in before.facts]
    return {"contexts": [*map(asdict, contexts)], "facts": [*map(asdict, facts)]}


def fate(equation, forward):
    """Return the verdict on a changed line, with all other lines as printed."""
    before, data = forward
    builder = LedgerBuilder()
    builder.ledger.contexts, builder.ledger.facts = dict(before.contexts), dict(before.facts)
    builder.ledger.rings = dict(before.rings)
    every = [equation if e.number == equation.number else e for e in EQUATIONS]
    by_number = {e.number: e for e in every}
    for latex, sense in asked(equation):
        printed.ask(builder, equation.number, question(latex, sense, by_number))
    new = _data(builder.ledger, before)
    ledger = {key: [*data[key], *new[key]] for key in data}
    found = verdict(equation, Answers(ledger, every), {})
    return found.ruling, [read.holds for read in found.readings], found.right_with


def survivors(equation, forward, changes):
    """Yield the changes that leave the verdict on a line unchanged."""
    as_printed = fate(equation, forward)
    for place, kind, text in changes:
        try:
            changed = fate(replace(equation, **{place: text}), forward) != as_printed
        except (PrintError, KernelError):
            changed = True
        harmless = any((equation.number, kind) == key[:2] and key[2] in text for key in HARMLESS)
        if not changed and not harmless:
            yield place, kind, text


def _changes(equation):
    for place in PLACES:
        for kind, text in misprints(getattr(equation, place)):
            yield place, kind, text


@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda e: e.number)
def test_the_first_change_of_each_kind_is_noticed(equation, forward):
    kinds = groupby(_changes(equation), key=lambda change: change[:2])
    assert list(survivors(equation, forward, [next(group) for _, group in kinds])) == []


@pytest.mark.slow
@pytest.mark.parametrize("equation", EQUATIONS, ids=lambda e: e.number)
def test_every_change_is_noticed(equation, forward):
    assert list(survivors(equation, forward, _changes(equation))) == []


def test_what_is_harmless_is_still_printed():
    for number, kind, text in HARMLESS:
        (equation,) = (e for e in EQUATIONS if e.number == number)
        assert any(kind == k and text in t for _, k, t in _changes(equation))


def test_there_are_changes_of_every_kind_and_most_lines_have_some():
    found = {e.number: [kind for _, kind, _ in _changes(e)] for e in EQUATIONS}
    assert {kind for kinds in found.values() for kind in kinds} == {
        "number",
        "sign",
        "axis",
        "function",
    }
    assert sum(map(len, found.values())) > 700
    assert [n for n, kinds in found.items() if not kinds] == ["7", "Remark 1", "Remark 3"]


def test_only_the_comparison_and_the_search_for_repairs_read_the_print():
    readers = {
        path.stem
        for path in Path(derivations.__file__).parent.glob("*.py")
        if any("proof.paper" in name for name in imported(path))
    }
    assert readers == {"printed", "repairs"}
