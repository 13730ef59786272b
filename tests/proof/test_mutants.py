"""Mutants of definitions, meanings, rates and publications, and the campaign that decides them."""

import json
import random
import tomllib
from importlib import resources

import numpy as np
import pytest
from ledgers import CONTEXTS, LEDGER, TEXT, defined, forger

from rigidsym._cli.proofs import checks
from rigidsym._numbers import check_numbers
from rigidsym.errors import LedgerError
from rigidsym.io.ledger import specification_text
from rigidsym.language._specification import Unproved, require
from rigidsym.proof._mutants import double, exchange, run, sign, turn
from rigidsym.proof._mutants._edits import alone, edits, written
from rigidsym.proof._mutants._field import PRIME, Points, Values
from rigidsym.proof._mutants._publications import doubled, meanings, publications, rates
from rigidsym.proof._mutants._screen import Screen
from rigidsym.proof.kernel import Context, KernelError, replay
from rigidsym.proof.kernel._language import parse
from rigidsym.proof.kernel._rules import _frozen
from rigidsym.validate._executors import Here

SPECIFICATION = specification_text()


@pytest.fixture(scope="module")
def screen():
    return Screen(SPECIFICATION, LEDGER)


def is_specified(ledger):
    try:
        require(SPECIFICATION, ledger)
    except Unproved:
        return False
    return True


def test_no_edit_changes_nothing():
    """Redo every proof of the sealed ledger, with nothing changed."""
    assert forger().forge([]) == LEDGER
    again = forger().forge([], reuse=False)
    assert {fact["id"] for fact in again["facts"]} == {fact["id"] for fact in LEDGER["facts"]}
    assert is_specified(again)


def test_edits_say_what_they_do():
    definitions = {"x_re": "a", "x_im": "b", "y_b": "x_re", "y_d": "c", "z": "y_b + 1"}
    found = [*map(str, edits(definitions))]
    assert found[:5] == [f"- {name}" for name in definitions]
    assert found[5:] == ["<-> x_re, x_im", "i x_re, x_im", "<-> y_b, y_d"]
    assert [*map(str, alone({"z": "y_b + 1"}))] == ["2 z", "lost term of z", "sign in z"]
    assert turn(("x", "a"), ("y", "b")).texts == {("x", "a"): "-(b)", ("y", "b"): "a"}


def test_definitions_that_use_each_other_are_not_exchanged():
    found = [str(edit) for edit in edits({"x_re": "a", "x_im": "x_re*b"})]
    assert found == ["- x_re", "- x_im"]


@pytest.mark.parametrize("text", ["a", "-a", "a - b/c*d", "D(a)**2", "-(a + b)**3/2", "a/(b - c)"])
def test_expressions_are_written_as_they_are_read(text):
    values = [
        Values(Context("x", (), {}), {}, {n: np.array([k + 2]) for k, n in enumerate("abcd")})
    ]
    for at in values:
        at.slopes = dict(at.known)
    assert values[0].value(parse(text)) == values[0].value(parse(written(parse(text))))


@pytest.mark.parametrize(
    "name", ["step", "descended", "kick", "turned_columns", "landen", "thirds"]
)
def test_what_is_proved_holds_modulo_a_prime(name):
    """Evaluate all equations that a context proves at points of it."""
    context = Context(**_frozen(CONTEXTS[name]))
    point, found = Points(context, 1).of({}, 64)
    values = Values(context, {}, point)
    for fact in LEDGER["facts"]:
        if fact["context"] == name and fact["kind"] in ("equal", "root"):
            for lhs, rhs in zip(fact["lhs"], fact["rhs"], strict=True):
                one, other = values.value(parse(lhs)), values.value(parse(rhs))
                one = one * one % PRIME if fact["kind"] == "root" else one
                assert (one == other)[found & values.defined].all(), fact["id"]
    assert found.any()


def test_points_and_proofs_agree(screen):
    """Decide mutants at points, and by redoing all proofs that a change can concern."""
    drawn, every = random.Random(33), dict(screen.mutants())
    for name in ("doubling", "kick", "landen", "theorem1_motion"):
        mutants = every[name]
        rows = np.array(drawn.sample([*range(len(mutants.rows))], 2))
        chosen = [*mutants.each(rows)]
        left = screen.survivors(dict.fromkeys(chosen, name))
        for mutant in chosen:
            if is_specified(forger().forge(mutant)):
                assert mutant in left


@pytest.mark.slow
def test_points_and_a_replay_of_all_proofs_agree(screen):
    """Decide 40 mutants by redoing every proof of the ledger, and no reuse."""
    every = [(name, mutants) for name, mutants in screen.mutants() if len(mutants.rows)]
    drawn = random.Random(34)
    for _ in range(40):
        name, mutants = drawn.choice(every)
        (mutant,) = mutants.each(np.array([drawn.randrange(len(mutants.rows))]))
        left = screen.survivors({mutant: name})
        whole = is_specified(forger().forge(mutant, reuse=False))
        assert whole == is_specified(forger().forge(mutant))
        assert whole <= bool(left)


def test_hollow_ledgers_are_accepted_by_the_kernel():
    """Publish x = 1*x for every name: the kernel has nothing to refuse."""
    *_, (told, ledger) = publications(LEDGER)
    assert told == "hollow, all"
    replay(json.dumps(ledger, indent=1, ensure_ascii=False) + "\n", lambda *_: True)


def test_a_formula_that_another_sequence_has_too_is_missed():
    """Numbers take nothing from elsewhere that a sequence has to set."""
    wanted = {f"without {k} of shift" for k in (0, 2, 3)}
    wanted |= {f"without 0 of {name}" for name in ("thirds", "second_half")}
    found = {told: ledger for told, ledger in publications(LEDGER) if told in wanted}
    assert found.keys() == wanted
    for ledger in found.values():
        with pytest.raises(LedgerError):
            check_numbers(json.dumps(ledger))


def test_signs_of_meanings_that_undo_each_other_are_refused():
    both = next(ledger for told, ledger in meanings(LEDGER) if told == "- c, - d")
    with pytest.raises(LedgerError, match="c is"):
        check_numbers(json.dumps(both))


def test_meanings_are_doubled_exchanged_and_negated():
    assert doubled("sin(Lambda*t)") == "sin(2 * (Lambda * t))"
    assert doubled("2*pi") == "2 * (2 * pi)"
    told = {told for told, _ in meanings(LEDGER)}
    assert {"2 in X_re", "<-> X_re, X_im"} <= told


def test_rates_are_changed_in_all_contexts():
    edit, ledger = next(iter(rates(LEDGER, ["doubling"])))
    changed = [c["name"] for c in ledger["contexts"] if c["rates"] != CONTEXTS[c["name"]]["rates"]]
    assert {"doubling"} <= {*changed}
    assert str(edit).startswith("- D(")


def test_factors_and_exchanges_are_undone_in_formulas():
    """A formula with a doubled name takes half of it, so that it says what it said."""
    (place,) = defined("step", "c_ab")
    ledger = forger().forge([double(place)])
    assert any(
        context["definitions"].get("c_ab", "").startswith("2*(") for context in ledger["contexts"]
    )
    assert exchange(("x", "a"), ("y", "b")).inverse == (("x", "y"), ("y", "x"))
    assert sign(("x", "a")).inverse == (("x", "(-x)"),)


def test_a_context_without_points_is_not_screened():
    context = Context("x", ("a", "b"), {"a": "1", "b": "1"}, relations=("a - b", "b**2 - a**2"))
    points = Points(context, 1)
    _, found = points.of({}, 4)
    assert found.all()
    with pytest.raises(KernelError):
        Values(context, {}, {}).value(parse("nothing"))


def test_a_sample_of_the_campaign_goes_not_unnoticed():
    tally = run(checks(TEXT), Here().submit, sample=6)
    assert sum(fates.total() for fates in tally.counts.values()) >= 200
    assert not tally.unnoticed


def test_equivalent_mutants_change_hidden_names_alone(screen):
    """Compare the values of all names of the theorem's context with those before the change."""
    text = resources.files("rigidsym.proof._mutants").joinpath("equivalent.toml").read_text("utf-8")
    for entry in tomllib.loads(text)["mutants"]:
        for told in entry["edits"]:
            name, _, wanted = told.partition(": ")
            context = screen.contexts[name]
            free = screen.definitions[name]
            known = {str(edit): edit for edit in (*edits(free), *alone(free))}
            changes = {
                place[0]: [(new, np.array([factor % PRIME])) for new, factor in terms]
                for each in wanted.split("; ")
                for place, terms in known[each].terms
            }
            point, found = Points(context, 1).of({}, 8)
            before, after = Values(context, {}, point), Values(context, changes, point)
            assert found.all()
            for other in screen.definitions[name]:
                same = (before.value(parse(other)) == after.value(parse(other))).all()
                assert same or other in entry["hidden"], (told, other)
