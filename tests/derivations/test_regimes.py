"""The sealed partition of motions at exact points: each is in one leaf, the expected one."""

from fractions import Fraction
from functools import cache
from itertools import permutations, product
from random import Random

import pytest
from ledgers import CONTEXTS, FACTS

from rigidsym.language._expression import parse
from rigidsym.language._sequence import FormulaSequence
from rigidsym.solution._polhode import Regime, classify

SPLITS = {fact["context"]: fact for fact in FACTS.values() if fact["kind"] == "partition"}
LEAVES = {
    **{"rest": Regime.REST, "spherical": Regime.SPHERICAL, "separatrix_motion": Regime.SEPARATRIX},
    **dict.fromkeys(("spin_1", "spin_2", "spin_3"), Regime.SPIN),
    **dict.fromkeys(("prolate_equatorial", "prolate_polar"), Regime.SPIN),
    **dict.fromkeys(("oblate_equatorial", "oblate_polar"), Regime.SPIN),
    **dict.fromkeys(("prolate_motion", "oblate_motion"), Regime.SYMMETRIC),
    **{"largest": Regime.LARGEST, "smallest": Regime.SMALLEST},
}
# Which of c_1 >= c_2 >= c_3 the motion circulates about.
CIRCULATES = {"prolate_motion": 3, "oblate_motion": 1, "separatrix_motion": 1}
CIRCULATES |= {"largest": 1, "smallest": 3}
RATES = [Fraction(x, 4) for x in (-4, -3, 0, 3, 4, 16)]
GRID = [
    (Fraction(1), c_13, c_23, *rates)
    for c_13, c_23 in ((0, 0), (1, 0), (1, 1), (Fraction(5, 4), 1), (2, 1))
    for rates in product(RATES, repeat=3)
]


def random_points(count):
    """Draw generic points, and points on the separatrix, where E_2 is a difference of squares."""
    random = Random(11)
    for _ in range(count):
        c_3, c_23, c_12 = (Fraction(random.randint(1, 99), random.randint(1, 9)) for _ in range(3))
        rates = [Fraction(random.randint(-99, 99), random.randint(1, 9)) for _ in range(3)]
        yield c_3, c_23 + c_12, c_23, *rates
        x, y = (random.randint(1, 9) for _ in range(2))
        c_3, c_1 = Fraction(x * x), Fraction((x + y) ** 2)
        c_2 = (c_1 + c_3) / 2
        slow, fast = random.choice((1, -1)) * (x + y), random.choice((1, -1)) * x
        yield c_3, c_1 - c_3, c_2 - c_3, Fraction(fast), rates[1], Fraction(slow)


def valuation(point):
    """Return the values of all names at a point given in the order of the generators."""
    context = CONTEXTS["sorted_body"]
    values = dict(zip(context["generators"], map(Fraction, point), strict=True))
    for name, text in context["definitions"].items():
        values[name] = of_text(text, values)
    return values


@cache
def compiled(text):
    return FormulaSequence([("value", parse(text))])


def of_text(text, values):
    return compiled(text).evaluate(values, {"power": pow})["value"]


def holds(name, values):
    """Return True for a point that satisfies all hypotheses of a context."""
    context = CONTEXTS[name]
    return (
        all(of_text(text, values) != 0 for text in context["units"])
        and all(of_text(text, values) == 0 for text in context["relations"])
        and all(of_text(text, values) >= 0 for text in context["nonnegative"])
    )


def walk(values, name="sorted_body"):
    """Return the leaf that the decisions of the tree lead to."""
    while name in SPLITS:
        sign = of_text(*SPLITS[name]["lhs"], values)
        cases = SPLITS[name]["certificate"]["cases"]
        name = cases[0 if sign == 0 else 1 if sign > 0 else 2]
    return name


def body(values):
    return [values[f"c_{k}"] for k in (1, 2, 3)], [values[f"Omega_{k}"] for k in (1, 2, 3)]


@pytest.fixture(scope="module")
def points():
    return [*map(valuation, [*GRID, *random_points(150)])]


@pytest.fixture(scope="module")
def by_leaf(points):
    found = {leaf: [] for leaf in LEAVES}
    for values in points:
        found[walk(values)].append(values)
    return found


def test_the_leaves_are_those_of_the_ledger_and_each_is_hit(points, by_leaf):
    assert set(SPLITS["sorted_body"]["rhs"]) == set(LEAVES)
    assert len(SPLITS["sorted_body"]["rhs"]) == len(LEAVES)
    assert SPLITS["sorted_body"]["grade"] == "PROVED"
    assert all(by_leaf.values())
    assert sum(map(len, by_leaf.values())) == len(points)


def test_every_point_is_in_the_one_leaf_that_the_tree_leads_to(points):
    for values in points:
        assert holds("sorted_body", values)
        assert [leaf for leaf in LEAVES if holds(leaf, values)] == [walk(values)]


def test_a_body_that_is_not_sorted_is_in_no_leaf():
    for c_13, c_23 in ((1, 2), (-1, 0), (0, -1)):
        values = valuation((2, c_13, c_23, 1, 2, 3))
        assert not any(holds(leaf, values) for leaf in LEAVES)


@pytest.mark.parametrize("leaf", LEAVES)
def test_what_a_leaf_declares_holds_at_its_points(leaf, by_leaf):
    facts = [fact for fact in FACTS.values() if fact["context"] == leaf]
    assert facts
    assert {fact["kind"] for fact in facts} <= {"equal", "nonnegative"}
    for values in by_leaf[leaf]:
        for fact in facts:
            for lhs, rhs in zip(fact["lhs"], fact["rhs"], strict=True):
                assert of_text(lhs, values) == of_text(rhs, values)
                assert fact["kind"] == "equal" or of_text(lhs, values) >= 0


@pytest.mark.parametrize("leaf", LEAVES)
def test_momentum_and_rates_are_parallel_in_the_steady_leaves_only(leaf, by_leaf):
    for values in by_leaf[leaf]:
        moments, rates = body(values)
        parallel = any(
            all((x - c) * rate == 0 for x, rate in zip(moments, rates, strict=True))
            for c in moments
        )
        assert parallel == LEAVES[leaf].steady


@pytest.mark.parametrize("leaf", LEAVES)
def test_a_leaf_is_the_regime_that_is_decided_for_numbers(leaf, by_leaf):
    for values in by_leaf[leaf][:40]:
        moments, rates = body(values)
        for order in permutations(range(3)):
            found = classify([moments[k] for k in order], [rates[k] for k in order])
            assert found.regime == LEAVES[leaf]
            if leaf in CIRCULATES:
                assert order[found.axes[0]] == CIRCULATES[leaf] - 1


@pytest.mark.parametrize("leaf", CIRCULATES)
def test_the_differences_are_those_of_energy_and_momentum(leaf, by_leaf):
    for values in by_leaf[leaf]:
        moments, rates = body(values)
        twice_energy = sum(c * w * w for c, w in zip(moments, rates, strict=True))
        square = sum((c * w) ** 2 for c, w in zip(moments, rates, strict=True))
        assert values["E_1"] == twice_energy * moments[0] - square
        assert values["E_2"] == square - twice_energy * moments[1]
        assert values["E_3"] == square - twice_energy * moments[2]
