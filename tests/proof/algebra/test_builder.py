"""The builder of ledgers: joined parts, claims, comparisons and publications."""

import pytest
from sympy import sin, sqrt, symbols

from rigidsym.proof.algebra import (
    LedgerBuilder,
    Part,
    Proofs,
    extend,
    half_angle,
    jacobi,
    join,
    sign,
    unit_quaternion,
)
from rigidsym.proof.algebra._builder import definitions, facts, readings
from rigidsym.proof.algebra._computation import Standing, standing
from rigidsym.proof.kernel import Grade, KernelError

A = Part(
    witness={"x": "1", "y": "2"},
    units=("x",),
    definitions={"d": "x*y"},
    relations=("y - 2*x",),
    rates={"x": "y", "y": "2*y"},
    nonnegative=("x",),
    reading={"x": "first"},
)
B = Part(witness={"z": "3"}, units=("z", "d"), definitions={"e": "d*z"}, reading={"z": "last"})


def test_join_concatenates_in_order():
    context = join("both", A, B)
    assert (context.name, context.generators) == ("both", ("x", "y", "z"))
    assert context.units == ("x", "z", "d")
    assert list(context.definitions) == ["d", "e"]
    assert context.relations == A.relations
    assert context.nonnegative == A.nonnegative
    assert context.rates == A.rates
    assert context.reading == {"x": "first", "z": "last"}


def test_later_parts_override_values_but_keep_the_order():
    context = join("both", A, Part(witness={"x": "5", "y": "10"}, reading={"x": "again"}))
    assert context.generators == ("x", "y")
    assert context.witness == {"x": "5", "y": "10"}
    assert context.reading["x"] == "again"


def test_static_contexts_have_no_time():
    builder = LedgerBuilder()
    builder.open(join("still", A, static=True))
    with pytest.raises(KernelError, match="no time derivative"):
        builder.claim("still.rate", {"D(x)": "y"})


def test_later_parts_may_use_earlier_names_and_not_conversely():
    LedgerBuilder().open(join("ordered", A, B))
    with pytest.raises(KernelError):
        LedgerBuilder().open(join("alone", B))


def test_sign_squares_to_one_and_need_not_be_one():
    builder = LedgerBuilder()
    builder.open(join("s", sign("epsilon", "a sign")))
    builder.claim("s.square", {"epsilon**2": "1"})
    builder.refute("s.one", {"epsilon": "1"}, {"epsilon": "-1"})


@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [
        ("sine", {"D(sin_a)": "w*cos_a"}, {"D(sin_a)": "w*cos_a/2"}),
        ("cosine", {"D(cos_a)": "-w*sin_a"}, {"D(cos_a)": "w*sin_a"}),
        ("circle", {"cos_a**2 + sin_a**2": "1"}, {"cos_a**2 - sin_a**2": "1"}),
    ],
)
def test_half_angle_moves_like_an_angle(name, right, wrong):
    builder = LedgerBuilder()
    builder.open(join("turn", Part(witness={"w": "1"}, rates={"w": "?"}), half_angle("a", "w")))
    builder.claim(f"turn.{name}", right)
    with pytest.raises(KernelError, match="undecided"):
        builder.claim(f"turn.no_{name}", wrong)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("(1 - sn**2)*(1 - m*sn**2)", "(1 - sn**2)*(1 - m**2*sn**2)"),
        ("(1 - sn**2)*dn**2", "sn**2*dn**2"),
    ],
)
def test_jacobi_sn_solves_its_differential_equation(right, wrong):
    builder = LedgerBuilder()
    functions = jacobi("sn", "cn", "dn", "u", "m", "1")
    builder.open(join("elliptic", Part(witness={"m": "1/2"}), functions))
    builder.claim("elliptic.square", {"D(sn)**2": right})
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("elliptic.wrong", {"D(sn)**2": wrong})


def test_carry_keeps_the_statement_and_its_weakest_grade():
    builder = LedgerBuilder()
    builder.open(join("general", Part(witness={"x": "1", "y": "1"})))
    builder.open(join("special", Part(witness={"x": "1"}, definitions={"y": "x"})))
    builder.claim("general.square", {"(x + y)**2": "x**2 + 2*x*y + y**2"})
    builder.model("special", "general")
    builder.carry("special", ["general.square"])
    carried = builder.ledger.facts["special.square"]
    assert carried.lhs == ("(x + y)**2",)
    assert carried.grade == Grade.PROVED


@pytest.mark.parametrize(
    "entry",
    [
        *facts("c", "nothing refuted"),
        *readings("c", "d", "1"),
        *readings("nowhere", "x", "1"),
        *definitions("c", "x", "1"),
        *definitions("nowhere", "d", "1"),
    ],
    ids=str,
)
def test_only_proved_facts_definitions_and_readings_are_published(entry):
    builder = LedgerBuilder()
    builder.open(
        join("c", Part(witness={"x": "1"}, definitions={"d": "2*x"}, reading={"x": "sin(1)"}))
    )
    builder.claim("c.one", {"x - x": "0"})
    builder.refute("c.refuted", {"x": "2"}, {})
    good = [*facts("c", "one"), *definitions("c", "d", "2", "3"), *readings("c", "x", "1")]
    assert good == [
        {"fact": "c.one"},
        {"context": "c", "definition": "d", "source": ["2", "3"]},
        {"context": "c", "reading": "x", "source": ["1"]},
    ]
    builder.publish("good", good)
    assert builder.ledger.published == {"sequences": {"good": good}}
    with pytest.raises(KernelError, match="is no proved fact"):
        builder.publish("bad", [entry])


# Comparisons.

CIRCLE = Part(
    witness={"c": "1", "s": "0", "w": "2"},
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


def test_a_point_far_from_the_witness_is_searched_for(builder):
    fact = builder.compare("circle.wrong", {"s*w": "0"})
    assert fact.certificate["point"] == {"c": "0", "s": "1", "w": "2"}


def test_what_no_point_shows_is_left_open(builder):
    builder.open(join("tangent", Part(("x",), relations=("x**2",))))
    assert builder.compare("tangent.open", {"x": "0"}) is None
    assert "tangent.open" not in builder.ledger.facts


def test_a_text_without_meaning_is_an_error(builder):
    with pytest.raises(KernelError, match="has no meaning here"):
        builder.compare("circle.lost", {"x": "0"})


def test_a_context_is_extended_and_what_parts_define_comes_last(builder):
    given = join("given", CIRCLE, Part(definitions={"twice": "2*s"}))
    more = extend(
        "more", given, Part(witness={"t": "0"}, definitions={"twice": "s + s"}, rates={"t": "1"})
    )
    assert more.generators == ("c", "s", "w", "t")
    assert more.definitions == {"twice": "s + s"}
    assert more.rates == {"c": "-w*s", "s": "w*c", "t": "1"}
    assert extend("still", join("static", CIRCLE, static=True)).rates is None


def test_an_expression_is_evaluated_by_definitions_rates_and_relations(builder):
    fact = builder.evaluate("circle.known", ["D(s**2 + c**2)", "(s**2 + c**2)*w", "w**2/w/w/w"])
    assert fact.rhs == ("0", "w", "1/w")
    assert standing(fact) == Standing.COMPUTED
    with pytest.raises(KernelError, match="has no meaning here"):
        builder.evaluate("circle.lost", ["x"])


def test_proofs_name_facts_within_their_context():
    x, y, d = symbols("x y d")
    builder = LedgerBuilder()
    here = Proofs.open(builder, "here", A)
    here.formulas({d: 2 * x**2, y: d / x}, 5, "Remark 1")
    here.root(x, x**2, fact="of_square")
    here.evaluate("rate", [d - x * y], 7)
    here.refute("wrong", {x: 2 * x}, 7)
    found = {fact.id: fact for fact in builder.ledger.facts.values()}
    assert [*found] == ["here.d", "here.y", "here.of_square", "here.rate", "here.wrong"]
    assert found["here.y"].source == ("5", "Remark 1")
    assert found["here.y"].rhs == ("d/x",)
    there = Proofs.open(builder, "there", A, B)
    there.model("here")
    there.carry("here", d, "rate")
    assert [*builder.ledger.facts][-2:] == ["there.d", "there.rate"]
    with pytest.raises(KernelError, match=r"here\.more: undecided"):
        here.claim("more", {x: y})


def test_a_reading_may_be_an_expression_with_functions_that_no_formula_may_have():
    k, u, v = symbols("k u v")
    part = Part((k, u), reading={u: 1 / sqrt(1 + k * sin(k * v))})
    assert join("here", part).reading == {"u": "1/sqrt(1 + k*sin(k*v))"}
    with pytest.raises(ValueError, match="not a whole power"):
        join("here", Part((k, u), definitions={v: sqrt(k)}))


def test_the_components_of_a_unit_quaternion_have_its_norm():
    builder = LedgerBuilder()
    here = Proofs.open(builder, "here", unit_quaternion("p", "the start"))
    here.evaluate("norm", [sum(p**2 for p in symbols("p0:4"))])
    assert builder.ledger.facts["here.norm"].rhs == ("1",)
    assert builder.ledger.contexts["here"].reading["p3"] == "component 3 of the start"
