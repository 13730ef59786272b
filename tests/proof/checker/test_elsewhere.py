"""Suppositions are looked at where their author did not choose: by the kernel's balls, and others.

Each claim here holds at all points that it gives.
"""

from dataclasses import replace

import pytest
from ledgers import unchecked

from rigidsym.proof.algebra._enclosures import COUNT, encloses
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.checker import _enclosures as enclosures
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, replay

NAMES = ("k_1", "rho", "a", "b", "K", "x", "n", "s")
PLACE = Context(
    "place",
    NAMES,
    dict.fromkeys(NAMES, "1") | {"a": "3", "b": "4", "K": "5"},
    units=("K",),
    relations=("rho**2 - 1", "K**2 - a**2 - b**2"),
    nonnegative=("K",),
    reading={"s": "sqrt(x**2)", "n": "a whole number"},
)
AUTHORS = {
    "k_1": ["1/100", "2/5", "9/10"],
    "rho": ["1", "1", "1"],
    "a": ["3", "-3", "24"],
    "b": ["4", "4", "7"],
    "K": ["5", "5", "25"],
    "x": ["1", "2", "7"],
    "n": ["1", "2", "3"],
}


def supposed(lhs, rhs, free, **certificate):
    """A claim with the author's points for names that it needs."""
    points = [{name: AUTHORS[name][k] for name in free.split()} for k in range(3)]
    certificate |= {"reference": "a book", "points": points}
    fact = Fact("f", "place", "equal", (lhs,), (rhs,), "assumption", Grade.ENCLOSED)
    return replace(fact, certificate=certificate)


def by_the_kernel(fact, context=PLACE):
    return replay(unchecked([context], [fact]), encloses)


def by_the_other(fact, context=PLACE):
    return check(unchecked([context], [fact]))


BOTH = pytest.mark.parametrize("decide", [by_the_kernel, by_the_other])
FALSE = [
    ("(k_1 - 1/100)*(k_1 - 2/5)*(k_1 - 9/10)", "0", "k_1"),
    ("jacobi_sn(x, k_1)*(k_1 - 1/100)*(k_1 - 2/5)*(k_1 - 9/10)", "0", "x k_1"),
    ("k_1", "k_1 + (100*k_1 - 1)*(5*k_1 - 2)*(10*k_1 - 9)/10**12", "k_1"),
    ("(K - 5)*(K - 25)", "0", "a b K"),
    ("(b - 4)*(b - 7)", "0", "a b K"),
    ("rho", "1", "rho"),
    ("s", "x", "x"),
    ("(x - 1)*(x - 2)*(x - 7)*k_1", "0", "x k_1"),
]
TRUE = [
    ("K**2", "a**2 + b**2", "a b K"),
    ("(K - b)*(K + b)", "a*a", "a b K"),
    ("rho**3", "rho", "rho"),
    ("s**2", "x*x", "x"),
    ("rho*(k_1 - 1)*(k_1 + 1)", "rho*k_1**2 - rho", "rho k_1"),
]


def functions(fact):
    """The context where functions are read by a name: facts themselves name none."""
    text = "jacobi_sn(x, k_1)"
    names = (*NAMES, "y")
    reading = {**PLACE.reading, "y": text}
    wider = replace(PLACE, generators=names, witness={**PLACE.witness, "y": "1"}, reading=reading)
    return replace(fact, lhs=tuple(side.replace(text, "y") for side in fact.lhs)), wider


@BOTH
@pytest.mark.parametrize(("lhs", "rhs", "free"), FALSE)
def test_what_holds_where_its_author_looks_is_refused(decide, lhs, rhs, free):
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(*functions(supposed(lhs, rhs, free)))


@BOTH
@pytest.mark.parametrize(("lhs", "rhs", "free"), TRUE)
def test_what_holds_everywhere_is_enclosed(decide, lhs, rhs, free):
    assert decide(supposed(lhs, rhs, free))


@BOTH
def test_a_hypothesis_is_where_to_look(decide):
    """Without x >= 0 it is false, as above."""
    signed = replace(PLACE, nonnegative=("K", "x"))
    assert decide(supposed("2*s", "s + x", "x"), signed)


@BOTH
def test_whole_numbers_are_said_to_be_whole(decide):
    period = replace(PLACE, reading={"s": "re(exp(2*pi*I*n))"})
    claim = supposed("s", "n/n", "n", whole=["n"])
    period = replace(period, units=("K", "n"))
    assert decide(claim, period)
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(supposed("s", "n/n", "n"), period)
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(supposed("(n - 1)*(n - 2)*(n - 3)", "0", "n", whole=["n"]), period)


@BOTH
def test_a_claim_has_to_say_something_at_enough_points(decide):
    """A function without a value is no agreement, and where nearly all have none is no evidence."""
    nowhere = replace(PLACE, reading={"s": "jacobi_sn(1, 1 + x**2)"})
    with pytest.raises((KernelError, Refused)):
        decide(supposed("2*s", "s + s", "x"), nowhere)
    rare = replace(PLACE, nonnegative=("K", "-x"), units=("K", "x"))
    few = replace(rare, relations=(*PLACE.relations, "x**2 - 1"))
    with pytest.raises((KernelError, Refused)):
        decide(supposed("2*s", "s - x", "x"), few)


def test_both_ask_for_forty():
    assert min(COUNT, enclosures.DUE) >= 40


@pytest.mark.parametrize("whole", [1, ["n", 1], {"n": "1"}])
def test_whole_names_are_a_list_of_names(whole):
    with pytest.raises(Refused):
        by_the_other(supposed("2*n", "n + n", "n", whole=whole))
