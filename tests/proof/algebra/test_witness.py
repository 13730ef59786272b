"""The witness of a context is found, and the kernel accepts it."""

import pytest

from rigidsym.proof.algebra import LedgerBuilder, Part, circle, jacobi, join
from rigidsym.proof.kernel import KernelError

CIRCLE = circle("c", "s", "a")


def found(*parts: Part, static: bool = False):
    """Return the witness of a context that the kernel accepts."""
    builder = LedgerBuilder()
    builder.open(join("found", *parts, static=static))
    return builder.ledger.contexts["found"].witness


@pytest.mark.parametrize(
    ("part", "point"),
    [
        (Part(("x", "y"), relations=("2*x + 3*y - 1",)), {"x": "1", "y": "-1/3"}),
        (Part(("x", "y"), relations=("x**2 + y**2 - 1",)), {"x": "1", "y": "0"}),
        (Part(("x", "y"), ("x", "y"), {}, ("x**2 + y**2 - 1",)), {"x": "3/5", "y": "4/5"}),
        (Part(("x", "y"), ("x",), {}, ("y**2 - x**2 - 1",)), {"x": "3/4", "y": "5/4"}),
        (Part(("x",), relations=("x**2 - 4",), nonnegative=("-x",)), {"x": "-2"}),
        (Part(("x",), relations=("x**3 - 8",)), {"x": "2"}),
        (Part(("x", "y"), ("d",), {"d": "x - y"}), {"x": "1", "y": "2"}),
        (Part(("x", "y"), start=("x", "y - 3"), rates={"x": "1"}), {"x": "0", "y": "3"}),
    ],
    ids=str,
)
def test_relations_units_signs_and_the_start_decide(part, point):
    assert found(part) == point


def test_the_search_returns_to_the_name_that_is_in_conflict():
    """Ten free names stand between the sides of a right triangle and its hypotenuse."""
    between = Part(tuple(f"x{k}" for k in range(10)))
    sides = Part(("a", "b"), ("a", "b"))
    last = Part(("r",), relations=("r**2 - a**2 - b**2",))
    point = found(sides, between, last)
    assert (point["a"], point["b"], point["r"]) == ("1", "3/4", "5/4")


def test_preferred_values_are_kept_where_they_can_be():
    sides = Part(("a", "b", "r"), relations=("r**2 - a**2 - b**2",), witness={"a": 5, "b": 12})
    assert found(sides) == {"a": "5", "b": "12", "r": "13"}
    assert found(sides, Part(relations=("a",))) == {"a": "0", "b": "12", "r": "12"}
    assert found(sides, Part(nonnegative=("-r",)))["r"] == "-13"


def test_what_is_zero_has_to_stay_zero():
    """At x = 0 the sign of x is about to change, unless x is constant or there is no time."""
    fixed = Part(("x",), witness={"x": 0}, nonnegative=("x",))
    assert found(fixed)["x"] == found(fixed, static=True)["x"] == "0"
    assert found(fixed, Part(rates={"x": "1"}))["x"] == "1"


def test_functions_need_no_value_of_theirs():
    functions = jacobi("sn", "cn", "dn", "u", "m", "1")
    point = found(Part(("m",), ("sn", "dn")), functions)
    assert all(map(str.strip, point.values()))
    assert point["sn"] != "0" != point["dn"]


@pytest.mark.parametrize(
    "part",
    [
        Part(("x",), relations=("x**2 - 2",)),
        Part(("x",), ("x",), {}, ("x",)),
        Part(("x",), relations=("x**2 + 1",)),
        Part(("x",), nonnegative=("-1 - x**2",)),
    ],
    ids=str,
)
def test_contexts_without_a_rational_point_are_refused(part):
    with pytest.raises(KernelError, match="context found: no witness"):
        found(part)


def test_the_kernel_refuses_what_has_a_point_and_is_wrong():
    with pytest.raises(KernelError, match="not closed"):
        found(CIRCLE, Part(rates={"s": "1"}))


def test_a_counterexample_is_found_near_the_point():
    builder = LedgerBuilder()
    builder.open(join("found", CIRCLE))
    assert builder.ledger.contexts["found"].witness == {"s": "1", "c": "0"}
    fact = builder.refute("found.sum", {"s + c": "1"}, {})
    assert fact.certificate["point"] == {"s": "0", "c": "-1"}
    with pytest.raises(KernelError):
        builder.refute("found.circle", {"s**2": "1 - c**2"}, {})
