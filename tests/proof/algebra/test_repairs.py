"""Search for repairs of false statements, and exact values at points of a context."""

from fractions import Fraction

import pytest

from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._repairs import Instant, Jet, repairs

CIRCLE = Part(
    witness={"c": "3/5", "s": "4/5", "w": "2", "k1": "3", "k2": "5"},
    units=("w", "k1"),
    relations=("s**2 + c**2 - 1",),
    rates={"c": "-w*s", "s": "w*c"},
)


def mended(statement, place="rhs", definitions=None, point=None):
    """Return the repairs found for a false statement, as equations."""
    builder = LedgerBuilder()
    builder.open(join("c", CIRCLE, Part(definitions=definitions or {})))
    builder.refute("c.wrong", statement, point or {})
    return [f"{lhs} = {rhs}" for lhs, rhs in repairs(builder.ledger, "c.wrong", place)]


@pytest.mark.parametrize(
    ("statement", "place", "expected"),
    [
        ({"D(s)": "-w*c"}, "rhs", "D(s) = w * c"),
        ({"D(s)": "w*s"}, "rhs", "D(s) = w * c"),
        ({"D(D(s))": "w**2*s"}, "rhs", "D(D(s)) = -w ** 2 * s"),
        ({"s**2": "1 - c**3"}, "rhs", "s**2 = 1 - c ** 2"),
        ({"s**2": "1 - k1*c**2"}, "rhs", "s**2 = 1 - c ** 2"),
        ({"s**2": "(1 - c**2)/k1"}, "rhs", "s**2 = 1 - c ** 2"),
        ({"D(c)": "-s"}, "rhs", "D(c) = -(w * s)"),
        ({"D(s*c)": "w*(c**2 + s**2)"}, "rhs", "D(s*c) = w * (c ** 2 - s ** 2)"),
        ({"D(s**2)": "w*s*c"}, "rhs", "D(s**2) = 2 * w * s * c"),
        ({"s": "w*c"}, "lhs", "D(s) = w*c"),
        ({"D(D(s))": "w*c"}, "lhs", "D(s) = w*c"),
    ],
)
def test_a_slip_is_found_and_mended(statement, place, expected):
    assert expected in mended(statement, place)


def test_what_takes_two_edits_is_not_found():
    assert mended({"s**2": "1 + k1*c**3"}) == []


def test_a_printed_definition_is_changed_wherever_it_is_used():
    statement = {"D(printed)**2": "w**2*(1 - printed**2)"}
    assert mended(statement, "printed", {"printed": "s/k1"}) == ["printed = s"]


def test_nothing_is_reported_twice_or_without_proof():
    builder = LedgerBuilder()
    builder.open(join("c", CIRCLE))
    builder.refute("c.wrong", {"D(s)**2": "w**2*(1 + s**2)"}, {})
    found = repairs(builder.ledger, "c.wrong", "rhs")
    sides = [rhs for _, rhs in found]
    ring = builder.ledger.rings["c"]
    assert sides
    assert len({str(ring.remainder(ring.read(text).numerator)) for text in sides}) == len(sides)
    for k, text in enumerate(sides):
        builder.claim(f"c.found{k}", {"D(s)**2": text})


def test_the_shortest_come_first_and_are_few():
    found = mended({"D(s)**2": "w**2*(1 + s**2)"})
    assert found == sorted(found, key=len)
    assert 0 < len(found) <= 3


def test_an_instant_knows_values_and_rates():
    builder = LedgerBuilder()
    builder.open(join("c", CIRCLE, Part(definitions={"t": "s/k1"})))
    instant = Instant(builder.ledger.contexts["c"], builder.ledger.contexts["c"].witness)
    assert instant.agree("D(s)", "w*c", {})
    assert instant.agree("D(t)", "w*c/k1", {})
    assert not instant.agree("D(t)", "w*c", {})
    assert instant.agree("D(t)", "w*c", {"t": "s"})
    assert not instant.agree("1/(k1 - 3)", "1", {})
    assert not instant.agree("k1**w", "1", {})


def test_what_cannot_be_evaluated_is_left_to_the_kernel():
    builder = LedgerBuilder()
    builder.open(join("c", CIRCLE))
    instant = Instant(builder.ledger.contexts["c"], builder.ledger.contexts["c"].witness)
    assert instant.agree("D(D(s))", "17", {})


@pytest.mark.parametrize(
    ("jet", "value", "rate"),
    [
        (Jet(Fraction(2), Fraction(3)).times(Jet(Fraction(5), Fraction(7))), 10, 29),
        (Jet(Fraction(2), Fraction(3)).plus(Jet(Fraction(5), Fraction(7))), 7, 10),
        (Jet(Fraction(2), Fraction(3)).power(3), 8, 36),
        (Jet(Fraction(2), Fraction(3)).power(-1), Fraction(1, 2), Fraction(-3, 4)),
        (Jet(Fraction(2), None).power(2), 4, None),
    ],
)
def test_jets_differentiate(jet, value, rate):
    assert (jet.value, jet.rate) == (value, rate)
