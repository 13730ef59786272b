"""Published formulas against the equations of motion: what is wrong in numbers is refused."""

import json

import pytest
from ledgers import LEDGER, OUTSIDE, TEXT, doubled_meanings, forger, hollow, written

from rigidsym._numbers import check_numbers
from rigidsym._numbers._motions import motions
from rigidsym.errors import LedgerError


def refused(ledger):
    """Return why numbers refuse a ledger that nothing else has checked."""
    with pytest.raises(LedgerError) as refusal:
        check_numbers(ledger if isinstance(ledger, str) else written(ledger))
    return str(refusal.value)


def test_the_sealed_ledger_agrees():
    count, formulas = check_numbers(TEXT)
    published = LEDGER["published"]
    sequences = [*published["sequences"].values(), *published["forms"].values()]
    assert (count, formulas) == (len([*motions(TEXT)]), sum(map(len, sequences)))


def test_motions_are_of_every_kind_and_of_both_handednesses():
    drawn = [*motions(TEXT)]
    for kind in ("rest", "spherical", "separatrix_motion", "largest", "smallest"):
        assert sum(motion.kind == kind for motion in drawn) >= 3
    for sign in ("epsilon", "sigma", "chi"):
        assert {motion.signs[sign] for motion in drawn if motion.moves} == {-1, 1}
    assert {motion.axes[0] for motion in drawn if motion.kind == "largest"} == {0, 1, 2}
    assert [*map(str, motions(TEXT))] == [*map(str, drawn)]
    assert [*map(str, motions(TEXT + " "))] != [*map(str, drawn)]


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_changes_together_is_refused(name):
    """Refuse the ledgers of the outside attack, which kernel and theorems accept."""
    assert refused(forger().forge(OUTSIDE[name])).startswith("ledger: sequence ")


def test_hollow_formulas_are_refused():
    assert refused(hollow()).startswith("ledger: sequence ")


@pytest.mark.parametrize("name", doubled_meanings())
def test_a_doubled_meaning_is_refused(name):
    assert refused(doubled_meanings()[name]).startswith("ledger: ")


@pytest.mark.parametrize("sequence", ["constants", "kick", "periods", "turn"])
def test_a_sequence_has_to_be_published(sequence):
    ledger = json.loads(TEXT)
    group = "forms" if sequence in ledger["published"]["forms"] else "sequences"
    del ledger["published"][group][sequence]
    assert sequence in refused(ledger)


def test_an_output_without_a_comparison_is_refused():
    ledger = json.loads(TEXT)
    entry = {"context": "kick", "definition": "w1", "source": ["3"]}
    ledger["published"]["sequences"]["more"] = [entry]
    assert refused(ledger) == "ledger: sequence more: w1 is compared with nothing"
