"""The partition of motions, read from the ledger, and refused where it proves none."""

import copy
import json
from fractions import Fraction

import pytest

from rigidsym.errors import LedgerError
from rigidsym.io.ledger import ledger_text
from rigidsym.solution import load, polhode, sealed

LEDGER = json.loads(ledger_text())


def test_every_leaf_has_a_regime_and_an_axis():
    assert set(sealed().partition.leaves) == set(polhode._LEAVES)
    assert {regime for regime, _ in polhode._LEAVES.values()} == set(polhode.Regime)


@pytest.mark.parametrize("leaf", [x for x in polhode._LEAVES if not polhode._LEAVES[x][0].steady])
def test_the_axis_of_a_moving_leaf_is_that_of_its_squares(leaf):
    """The first is A_a^2 = E_d/(c_a c_ad), shown nonnegative with that axis as a."""
    (squares,) = (fact for fact in LEDGER["facts"] if fact["id"] == f"{leaf}.squares")
    a, d = (1, 3) if polhode._LEAVES[leaf][1] == 1 else (3, 1)
    assert squares["grade"] == "PROVED"
    assert squares["lhs"][0].endswith(f"/(c_{a}*(c_{a} - c_{d}))")


def test_signs_of_differences_decide():
    decide = sealed().partition.leaf
    half = Fraction(1, 2)
    assert decide((3, 2, 1), (0, 0, 0)) == "rest"
    assert decide((2, 2, 2), (1, 0, 0)) == "spherical"
    assert decide((3, 2, 1), (1, half, 0)) == "largest"
    assert decide((3, 2, 1), (0, half, 1)) == "smallest"
    assert decide((3, 2, 1), (1, 0, 1)) == "largest"
    assert decide((Fraction(9, 4), 2, 1), (4, 1, Fraction(3, 2))) == "largest"
    assert decide((Fraction(9, 4), 2, 1), (4, 1, 3)) == "separatrix_motion"


def altered(change):
    data = copy.deepcopy(LEDGER)
    facts = {fact["id"]: fact for fact in data["facts"]}
    contexts = {context["name"]: context for context in data["contexts"]}
    change(data, facts, contexts)
    return json.dumps(data)


def unproved(data, facts, contexts):
    facts["sorted_body.cases"]["grade"] = "ASSUMED"


def missing(data, facts, contexts):
    data["facts"].remove(facts["off_1.cases"])


def other_leaves(data, facts, contexts):
    facts["sorted_body.cases"]["rhs"].remove("spin_2")


def twice(data, facts, contexts):
    facts["prolate.cases"]["certificate"]["cases"] = ["prolate_off_1", "prolate_off_1"]


def redefined(data, facts, contexts):
    contexts["oblate"]["definitions"]["E_3"] += " + 1"


def other_inputs(data, facts, contexts):
    contexts["sorted_body"]["generators"].reverse()


def used_early(data, facts, contexts):
    for context in contexts.values():
        if "off_middle" in context["definitions"]:
            context["definitions"]["off_middle"] += " + later"


def without_cases(data, facts, contexts):
    del facts["motion.cases"]["certificate"]["cases"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (unproved, "theorem sorted_body .*exactly one of"),
        (missing, "its leaves are not .*off_1"),
        (other_leaves, "theorem sorted_body .*exactly one of"),
        (twice, "prolate_off_1.cases: splits lead to it twice"),
        (redefined, "oblate: its definitions are not those of sorted_body"),
        (other_inputs, "sorted_body is not about c_3"),
        (used_early, "theorem sorted_body .*let off_middle = "),
        (without_cases, "its partition is not readable: KeyError"),
    ],
)
def test_a_ledger_that_does_not_tell_motions_apart_is_refused(change, message):
    with pytest.raises(LedgerError, match=f"^ledger: .*{message}"):
        load(altered(change))
