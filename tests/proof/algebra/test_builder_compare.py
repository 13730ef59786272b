"""Comparing: an equation that holds, one that fails somewhere, one that nobody can decide."""

import pytest

from rigidsym.proof.algebra import LedgerBuilder, Part, extend, join
from rigidsym.proof.kernel import KernelError

CIRCLE = Part(
    {"c": "1", "s": "0", "w": "2"},
    units=("w",),
    relations=("s**2 + c**2 - 1",),
    rates={"c": "-w*s", "s": "w*c"},
)


@pytest.fixture
def builder():
    builder = LedgerBuilder()
    builder.open(join("circle", CIRCLE))
    return builder


def test_what_holds_is_admitted_as_equal(builder):
    fact = builder.compare("circle.rate", {"D(s*c)": "w*(c**2 - s**2)"}, source=["1"])
    assert fact.kind == "equal"
    assert fact.source == ("1",)
    assert builder.ledger.facts["circle.rate"] == fact


def test_what_fails_is_admitted_as_unequal_at_a_given_point(builder):
    fact = builder.compare("circle.wrong", {"s**2": "1 + c**2"}, [{"c": "3/5", "s": "4/5"}])
    assert fact.kind == "unequal"
    assert fact.certificate["point"] == {"c": "3/5", "s": "4/5", "w": "2"}


def test_a_point_is_found_near_the_witness(builder):
    fact = builder.compare("circle.wrong", {"w": "2*c"})
    assert fact.kind == "unequal"
    assert fact.certificate["point"]["w"] != "2"


def test_points_that_are_none_of_the_context_are_passed_over(builder):
    fact = builder.compare("circle.wrong", {"s": "1"}, [{"c": "3"}, {"c": "0", "s": "1"}])
    assert fact.certificate["point"] == {"c": "1", "s": "0", "w": "2"}


def test_what_no_point_shows_is_left_open(builder):
    assert builder.compare("circle.open", {"s*w": "0"}) is None
    assert "circle.open" not in builder.ledger.facts


def test_a_text_without_meaning_is_an_error(builder):
    with pytest.raises(KernelError, match="has no meaning here"):
        builder.compare("circle.lost", {"x": "0"})


def test_a_context_is_extended_and_what_parts_define_comes_last(builder):
    given = join("given", CIRCLE, Part(definitions={"twice": "2*s"}))
    more = extend("more", given, Part({"t": "0"}, definitions={"twice": "s + s"}, rates={"t": "1"}))
    assert more.generators == ("c", "s", "w", "t")
    assert more.definitions == {"twice": "s + s"}
    assert more.rates == {"c": "-w*s", "s": "w*c", "t": "1"}
    assert extend("still", join("static", CIRCLE, static=True)).rates is None
