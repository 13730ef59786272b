"""Mutants: every one is accounted for, and a wrong proof would be noticed."""

import json
from collections import Counter

import pytest

from rigidsym.io.ledger import ledger_text
from rigidsym.proof.algebra import Book, Part, join
from rigidsym.proof.algebra.mutants import PRINTED, mutants, tally
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


@pytest.fixture
def book():
    book = Book()
    book.open(join("c", Part({"c1": "1", "c2": "2", "x1": "1", "x2": "1"}, units=("c1",))))
    return book


def test_mutants_change_one_place_and_are_all_different(book):
    fact = book.claim("c.square", {"(x1 + x2)**2/c1": "(x1**2 + 2*x1*x2 + x2**2)/c1"})
    found = list(mutants(fact, book.ledger.rings["c"]))
    assert len(found) == len(set(found)) > 10
    assert (fact.lhs[0], fact.rhs[0]) not in found
    assert ("(x1 + x2)**2/c1", "(x1 ** 2 - 2 * x1 * x2 + x2 ** 2) / c1") in found
    assert ("(x1 + x2)**2/c1", "(x1 ** 2 + 2 * x1 * x2 + x2 ** 2) / c2") in found
    assert ("(x1 + x2)**2/c1", "x1 ** 2 + 2 * x1 * x2 + x2 ** 2") in found
    assert ("(x1 + x2)**2/c1", "(x1 + 2 * x1 * x2 + x2 ** 2) / c1") in found


def test_the_three_fates(book):
    book.claim("c.zero", {"(x1 - x1)/c1": "0"})
    counts = tally(book.ledger, each=40)["c.zero"]
    assert set(counts) == FATES
