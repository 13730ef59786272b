"""Where a statement comes from is told by the type of its text."""

import pytest
from sympy import Mul, apart, solve, symbols

from rigidsym.proof.algebra import LedgerBuilder, Part, join, text
from rigidsym.proof.algebra._computation import (
    Computed,
    Guess,
    Standing,
    compute,
    guess,
    joined,
    ordered,
    reasons,
    standing,
)
from rigidsym.proof.kernel import Fact

X, Y = symbols("x y")
CONTEXT = Part(witness={X: "2", Y: "3"}, units=(X - Y,))


def stated(right):
    """Return the fact (x^2 - y^2)/(x - y) = right, as the builder admits it."""
    builder = LedgerBuilder()
    builder.open(join("here", CONTEXT))
    return builder.claim("here.quotient", {(X**2 - Y**2) / (X - Y): right})


def test_a_statement_is_computed_if_sympy_found_it():
    found = compute((X**2 - Y**2) / (X - Y)).cancel()
    assert standing(stated(found)) == Standing.COMPUTED
    assert standing(stated(X + Y)) == standing(stated("x + y")) == Standing.GUESSED


@pytest.mark.parametrize(
    "typed",
    [
        compute(X + Y),
        compute(X + Y).expand(),
        compute(X).subs(X, X + Y),
        compute((X**2 - Y**2) / (X - Y)).subs((X**2 - Y**2) / (X - Y), X + Y),
        compute(Y) + X,
        compute(Mul(X + Y, 1, evaluate=False)).doit(),
        compute(2 * (Y + X)).expand() / 2,
        -compute(-X - Y).factor(),
        compute(X - Y).cancel() * (X + Y) / (X - Y),
    ],
    ids=[
        *("begun with", "unchanged", "put in", "put in for the whole", "added up"),
        *("not evaluated", "twice", "with a sign", "times one"),
    ],
)
def test_an_answer_that_was_put_in_is_guessed(typed):
    assert not typed.computed
    assert standing(stated(typed)) == Standing.GUESSED


Z = symbols("z")


@pytest.mark.parametrize(
    "solved",
    [compute(Z - X - Y).solve_for(Z), compute(2 * X + 2 * Y - 2 * Z).apply(solve, Z)[0]],
    ids=["solve_for", "solve"],
)
def test_an_equation_that_was_solved_before_is_guessed(solved):
    fact = stated(solved)
    assert standing(fact) == Standing.GUESSED
    assert reasons(fact) == ("an equation with the name on one side, before SymPy solved it",)


def test_a_relation_that_is_said_again_is_chosen():
    builder = LedgerBuilder()
    builder.open(join("here", CONTEXT, Part({Z: "size"}, relations=(Z**2 - X**2 - Y**2,))))
    size = compute(Z**2 - X**2 - Y**2).solve_for(Z**2)
    assert standing(builder.claim("here.size", {Z**2: size})) == Standing.CHOSEN
    assert standing(builder.claim("here.sum", {"z**2 + x": "x**2 + y**2 + x"})) == Standing.CHOSEN
    assert standing(builder.claim("here.other", {"z**2*x": "x**3 + x*y**2"})) == Standing.GUESSED


@pytest.mark.parametrize(
    "operate",
    [
        lambda x: x.apply(lambda value: X + Y),
        lambda x: x.replace(lambda part: part == X, lambda part: X + Y),
    ],
    ids=["apply", "replace"],
)
def test_a_function_without_a_name_is_refused(operate):
    with pytest.raises(ValueError, match="needs a name"):
        operate(compute(X * Y))


def test_typed_expressions_beside_a_computed_one_are_kept_until_the_next_operation():
    found = compute((X**2 - Y**2) / (X - Y)).cancel()
    beside = found * (X + 2 * Y)
    assert (beside.computed, beside.joined) == (True, (X + 2 * Y,))
    assert beside.subs(Y, 2 * Y).joined == beside.joined
    assert (beside.expand().joined, (2 * X * found).joined) == ((), ())
    assert joined(claimed({"x**2 + 3*x*y + 2*y**2": beside})) == beside.joined
    assert joined(claimed({"x**2 + 3*x*y + 2*y**2": beside.expand().factor()})) == ()


def test_a_part_that_is_held_together_is_no_computation_by_that():
    assert not compute(X + Y).held().computed
    found = compute((X**2 - Y**2) / (X - Y)).cancel().held()
    assert found.computed
    assert stated(X * found / X).rhs == ("(x + y)",)


def test_a_computation_goes_on_through_arithmetic_and_other_computations():
    found = compute((X**2 - Y**2) / (X - Y)).cancel()
    for later in (2 * found, X * found - 1, -found, found**2, compute(Y).subs(Y, found)):
        assert later.computed
    assert (X / found).value == X / (X + Y)
    assert compute(1 / (X**2 - 1)).apply(apart, X).operations == ("apart",)


def test_several_computations_go_on_as_one():
    found = compute((X**2 - Y**2) / (X - Y)).cancel()
    both = compute((found, X))
    assert both.value == (X + Y, X)
    assert both.computed
    assert [each.operations for each in both] == [("cancel",)] * 2
    assert not compute((compute(X**2), X)).computed


def test_a_part_that_was_found_is_computed_in_the_context():
    found = compute((X**2 - Y**2) / (X - Y)).cancel()
    context = join("there", CONTEXT, Part(definitions={"s": found, "d": X - Y}))
    assert join("there", CONTEXT, Part(definitions={"s": found.ordered("y")})).definitions == {
        "s": "y + x"
    }
    assert isinstance(context.definitions["s"], Computed)
    assert not isinstance(context.definitions["d"], Computed)
    assert context.definitions == {"s": "x + y", "d": "x - y"}


def test_a_guess_says_why():
    fact = stated(guess("x + y", "it is shorter"))
    assert isinstance(fact.rhs[0], Guess)
    assert standing(fact) == Standing.GUESSED
    assert reasons(fact) == ("it is shorter",)


def claimed(equations, **reasons):
    """Return a fact about x and y, as the builder admits it with reasons."""
    builder = LedgerBuilder()
    builder.open(join("here", CONTEXT, Part(definitions={"s": X + Y})))
    return builder.claim("here.fact", equations, **reasons)


def test_a_law_is_stated_with_its_reason():
    fact = claimed({X**2 - Y**2: "s*(x - y)"}, law="how squares differ")
    assert standing(fact) == Standing.STATED
    assert reasons(fact) == ("how squares differ",)
    assert standing(claimed({X**2 - Y**2: "s*(x - y)"})) == Standing.GUESSED


QUOTIENT = (X**2 - Y**2) / (X - Y)


@pytest.mark.parametrize("equations", [{"s": QUOTIENT}, {X * (X - Y): "x**2 - x*y", "s": QUOTIENT}])
def test_an_answer_is_no_law(equations):
    with pytest.raises(ValueError, match=r"s = .* is an answer"):
        claimed(equations, law="what s is")
    fact = claimed(equations, why="what s is")
    assert standing(fact) == Standing.GUESSED
    assert reasons(fact) == ("what s is",)


def test_a_computed_line_needs_no_reason():
    found = {X**2 - Y**2: compute(X**2 - Y**2).factor()}
    assert standing(claimed(found, law="of no use")) == Standing.COMPUTED
    mixed = claimed({**found, 2 * X: "x + x"}, law="what two of them are")
    assert standing(mixed) == Standing.STATED
    assert reasons(mixed) == ("what two of them are",)


def test_a_statement_that_a_point_refutes_is_stated():
    builder = LedgerBuilder()
    builder.open(join("here", CONTEXT))
    assert standing(builder.refute("here.refuted", {X: Y}, {})) == Standing.STATED


def test_lines_are_judged_one_by_one():
    lines = (Computed("1"), "2")
    whole = Fact("here.two", "here", "equal", ("a", "b"), lines, "identity")
    assert standing(whole) == Standing.GUESSED


def test_the_only_solution_is_computed():
    quotient = symbols("quotient")
    found = compute(X**2 - Y**2 - quotient * (X - Y)).solve_for(quotient)
    assert standing(stated(found)) == Standing.COMPUTED


def test_several_unknowns_have_their_values_by_name():
    found = compute([X + Y - 3, X - Y - 1]).solve_for(X, Y)
    assert {name: value.value for name, value in found.items()} == {X: 2, Y: 1}
    assert all(value.computed for value in found.values())
    with pytest.raises(ValueError, match="x, y: 1 solutions"):
        compute([X + Y - 3]).solve_for(X, Y)


def test_a_table_is_printed_in_an_order_of_names():
    printed = {name: text(form) for name, form in ordered("y x", {"a": X * Y, "b": X + Y}).items()}
    assert printed == {"a": "y*x", "b": "y + x"}


@pytest.mark.parametrize(("equation", "count"), [(X**2 - Y**2, 2), (Y + 1, 0)])
def test_a_solution_that_is_not_the_only_one_is_refused(equation, count):
    with pytest.raises(ValueError, match=f"x: {count} solutions"):
        compute(equation).solve_for(X)
