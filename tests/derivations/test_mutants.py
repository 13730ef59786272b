"""Mutants: every one is accounted for, and a wrong proof would be noticed."""

import json
from collections import Counter
from dataclasses import replace

import pytest

from rigidsym.io.ledger import ledger_text
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.algebra._mutants import PRINTED, known_fates, mutants, tally
from rigidsym.proof.kernel import replay
from rigidsym.proof.paper import verdicts

LEDGER = json.loads(ledger_text())
FATES = {"refuted", "refused", "equivalent"}


@pytest.mark.parametrize("verdict", verdicts(LEDGER), ids=lambda v: v.equation.number)
def test_every_equation_has_ten_mutants_and_most_are_refuted(verdict):
    counts = Counter(verdict.mutants)
    assert set(counts) <= FATES
    assert counts.total() >= 10
    assert counts["refuted"] >= 6


def test_every_fact_decided_or_enclosed_is_counted():
    facts = [f for f in LEDGER["facts"] if f["rule"] in ("identity", "assumption")]
    decided = [f["id"] for f in facts if PRINTED not in f["id"]]
    assert list(LEDGER["published"]["mutants"]) == decided


def test_all_mutants_counted_again_have_the_sealed_fates():
    assert tally(replay(ledger_text(), encloses)) == LEDGER["published"]["mutants"]


@pytest.fixture
def builder():
    builder = LedgerBuilder()
    builder.open(join("c", Part({"c1": "1", "c2": "2", "x1": "1", "x2": "1"}, units=("c1",))))
    return builder


def test_mutants_change_one_place_and_are_all_different(builder):
    fact = builder.claim("c.square", {"(x1 + x2)**2/c1": "(x1**2 + 2*x1*x2 + x2**2)/c1"})
    found = list(mutants(fact, builder.ledger.rings["c"]))
    assert len(found) == len(set(found)) > 10
    assert (fact.lhs[0], fact.rhs[0]) not in found
    assert ("(x1 + x2)**2/c1", "(x1 ** 2 - 2 * x1 * x2 + x2 ** 2) / c1") in found
    assert ("(x1 + x2)**2/c1", "(x1 ** 2 + 2 * x1 * x2 + x2 ** 2) / c2") in found
    assert ("(x1 + x2)**2/c1", "x1 ** 2 + 2 * x1 * x2 + x2 ** 2") in found
    assert ("(x1 + x2)**2/c1", "(x1 + 2 * x1 * x2 + x2 ** 2) / c1") in found


def test_the_three_fates(builder):
    builder.claim("c.zero", {"(x1 - x1)/c1": "0"})
    counts = tally(builder.ledger, each=40)["c.zero"]
    assert set(counts) == FATES


PART = Part({"c1": "1", "x1": "1", "x2": "1"}, units=("c1",))


def other_book(part=PART):
    other = LedgerBuilder()
    other.open(join("c", part))
    other.claim("c.square", {"(x1 + x2)**2/c1": "(x1**2 + 2*x1*x2 + x2**2)/c1"})
    other.claim("c.sum", {"x1 + x2": "x2 + x1"})
    return other


def test_fates_are_known_of_facts_that_are_word_for_word_the_same():
    sealed = other_book()
    marked = {"c.square": {"refuted": 1}, "c.sum": {"refuted": 2}}
    sealed.ledger.published["mutants"] = marked
    text = sealed.ledger.to_text()
    assert known_fates(other_book().ledger, text) == marked
    more = other_book()
    more.claim("c.double", {"x1 + x1": "2*x1"})
    assert known_fates(more.ledger, text) == marked
    counts = tally(more.ledger, known_fates(more.ledger, text))
    assert counts["c.square"] == {"refuted": 1}
    assert counts["c.double"] == tally(more.ledger)["c.double"]


@pytest.mark.parametrize(
    "part",
    [
        replace(PART, units=("c1", "x1")),
        replace(PART, definitions={"y": "x1"}),
        replace(PART, witness={"c1": "2", "x1": "1", "x2": "1"}),
    ],
)
def test_no_fate_is_known_where_the_context_is_another(part):
    sealed = other_book()
    sealed.ledger.published["mutants"] = {"c.square": {"refuted": 1}}
    assert known_fates(other_book(part).ledger, sealed.ledger.to_text()) == {}


def test_no_fate_is_known_of_a_changed_fact():
    sealed = other_book()
    sealed.ledger.published["mutants"] = {"c.sum": {"refuted": 1}}
    text = sealed.ledger.to_text().replace('"x2 + x1"', '"x1 + x2 + 0"')
    assert known_fates(other_book().ledger, text) == {}
    assert known_fates(other_book().ledger, LedgerBuilder().ledger.to_text()) == {}
