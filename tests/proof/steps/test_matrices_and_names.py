"""Named matrices, the dictionary of names and functions, and scopes."""

import random

import pytest
import sympy
from sympy import I, Identity, ImmutableMatrix, MatAdd, MatMul, ZeroMatrix

from rigidsym.language._expression import parse
from rigidsym.language.functions._jacobi import jacobi_sn
from rigidsym.proof.algebra import LedgerBuilder, Part, circle, half_angle, jacobi
from rigidsym.proof.steps import SIZE, Rate, Scope, StepError, matrix, multiply
from rigidsym.proof.steps._matrices import part_name, split
from rigidsym.proof.steps._names import (
    collected,
    expressions,
    positive,
    read,
    symbol,
    symbols,
    unfold,
)

x, y, a = symbols("x y a")
NAMES = ("P", "Q", "S")
POOL = (0, 1, -1, I, -I, x, -x, I * y, x + I * y, 2 - I * a, sympy.Rational(1, 2))


def drawn(random: random.Random, size: int) -> ImmutableMatrix:
    return ImmutableMatrix(size, size, [random.choice(POOL) for _ in range(size**2)])


def expression(random: random.Random, depth: int):
    if depth == 0:
        return random.choice([*map(matrix, NAMES), Identity(SIZE), ZeroMatrix(SIZE, SIZE)])
    one, two = (expression(random, depth - 1) for _ in range(2))
    match random.randrange(4):
        case 0:
            return MatAdd(one, two, evaluate=False)
        case 1:
            return MatMul(one, two, evaluate=False)
        case 2:
            return MatMul(random.choice((-x, sympy.Integer(-2), y - x, a)), one, evaluate=False)
    return one.adjoint()


@pytest.mark.parametrize("seed", range(25))
def test_entries_are_those_of_explicit_multiplication(seed):
    draw = random.Random(seed)
    size = 2 + seed // 2 % 2
    values = {name: drawn(draw, size) for name in NAMES}
    witness = dict.fromkeys("xya", "1")
    rates = {"x": "a*y", "y": "x - a"}
    scope = Scope.open(
        LedgerBuilder(), "named", Part(witness=witness, rates=rates), matrices=values
    )
    whole = expression(draw, 3)
    if seed % 2:
        whole = Rate(whole)
    explicit = scope.explicit(whole)
    assert explicit.shape == (size, size)
    assert len(scope.entries(whole)) == size**2
    for (i, j), texts in scope.entries(whole).items():
        parts = split(explicit[i - 1, j - 1])
        for text, part in zip(texts, parts, strict=True):
            said = scope.ring.read(text or "0")
            assert not (said - scope.ring.read(scope.text(part))).numerator


@pytest.mark.parametrize("size", [1, 2, 3, 4])
def test_a_determinant_is_that_of_sympy(size):
    values = {"P": drawn(random.Random(size), size)}
    scope = Scope.open(
        LedgerBuilder(), "named", Part(witness=dict.fromkeys("xya", "1")), matrices=values
    )
    parts = split(sympy.expand(values["P"].det(method="berkowitz")))
    for text, part in zip(scope.determinant(matrix("P")), parts, strict=True):
        assert not (scope.ring.read(text or "0") - scope.ring.read(scope.text(part))).numerator


def test_an_explicit_matrix_may_stand_in_an_equation():
    builder, value = LedgerBuilder(), ImmutableMatrix(3, 3, [x, 0, I * y, 1, y, 0, 0, 0, x])
    parts = Part(witness={"x": "1", "y": "1"})
    scope = Scope.open(builder, "named", parts, matrices={"P": value}, static=True)
    step = multiply(scope, "named.square", matrix("P") ** 2, value * value, "why")
    assert step.value == value * value
    assert step.shown[0].rhs == value * value
    with pytest.raises(StepError, match=r"fact named\.wrong: undecided"):
        multiply(scope, "named.wrong", matrix("P") ** 2, value, "why")


def test_an_entry_is_sums_of_products_of_names_unexpanded():
    values = {"P": ImmutableMatrix(((x, I * y), (I * y, x)))}
    scope = Scope.open(
        LedgerBuilder(), "named", Part(witness={"x": "1", "y": "1"}), matrices=values
    )
    P = matrix("P")
    assert scope.entries(P * P)[1, 1] == ("P_11_re * P_11_re - P_12_im * P_21_im", None)
    assert part_name("P", (1, 2), 1) == "P_12_im"


def test_a_matrix_by_those_before_it():
    values = {"P": ImmutableMatrix(((x, 0), (0, y))), "Q": matrix("P") * matrix("P")}
    scope = Scope.open(
        LedgerBuilder(), "named", Part(witness={"x": "1", "y": "1"}), matrices=values
    )
    assert scope.context.definitions["Q_11_re"] == "P_11_re * P_11_re"
    assert scope.explicit(matrix("Q")) == ImmutableMatrix(((x**2, 0), (0, y**2)))


@pytest.fixture
def scope():
    parts = (
        Part(witness={"a": "2", "w": "1", "xi": "1", "mu": "9/16"}),
        half_angle("phi1", "w"),
        jacobi("sn", "cn", "dn", "xi*t", "mu", "xi"),
    )
    return Scope.open(LedgerBuilder(), "words", *parts)


def test_a_dictionary_goes_both_ways(scope):
    sn = jacobi_sn(symbol("xi") * symbol("t"), symbol("mu"))
    meant = a * sympy.cos(symbol("phi1") / 2) + sn**2
    named = scope.dictionary.named(meant)
    assert {str(name) for name in named.free_symbols} >= {"a", "sn"}
    assert not named.atoms(sympy.Function)
    assert scope.dictionary.meant(named) == meant
    assert scope.read(scope.text(meant)) == meant


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x**-1, "1/x"),
        (x**-3, "1/x**3"),
        (y * x**-2, "y/x**2"),
        ((x + y) ** -2, "1/(x + y)**2"),
        (x * (x + y) ** -1, "x/(x + y)"),
        (sympy.Rational(-2, 3) * x, "-2*x/3"),
        (-1 / x, "-1/x"),
    ],
)
def test_negative_powers_are_quotients(expression, text):
    scope = Scope.open(
        LedgerBuilder(),
        "plain",
        Part(witness={"x": "1", "y": "1"}, units=("x", "x + y")),
        static=True,
    )
    assert scope.text(expression) == text
    assert sympy.cancel(read(text) - expression) == 0
    scope.ring.read(text)


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        (sympy.tan(x), r"tan\(x\) has no name in words"),
        (I * x, "I has no name in words"),
        (sympy.sqrt(x), "the kernel knows whole powers only"),
        (x**y, "the kernel knows whole powers only"),
    ],
)
def test_what_the_kernel_has_no_word_for_is_one_line(scope, expression, message):
    with pytest.raises(StepError, match=message):
        scope.text(expression)


def test_a_reading_that_is_words_is_no_function(scope):
    assert all(isinstance(f, sympy.Function) for f in scope.dictionary.names)
    with pytest.raises((ValueError, SyntaxError)):
        read("a moment of inertia, kg m^2")
    with pytest.raises(ValueError, match="not a function that has a counterpart in SymPy"):
        read("zeta(x)")
    assert parse("x") is not None


# A scope.


def test_at_a_context_of_its_own_and_the_same_again():
    builder = LedgerBuilder()
    scope = Scope.open(builder, "whole", Part(witness={"x": "2", "y": "1"}), static=True)
    there = scope.at("part.fact", x - y)
    assert there.name == "part"
    assert builder.ledger.contexts["part"].units == ("x - y",)
    assert scope.at("whole.fact", x) is scope
    assert scope.at("part.other", x).context == there.context


def test_where_what_is_not_zero_is_always_zero():
    part = Part(("x", "y"), relations=("x - y",))
    scope = Scope.open(LedgerBuilder(), "whole", part, static=True)
    with pytest.raises(ValueError, match="context part: no witness"):
        scope.where("part", x - y)


def test_divisors_are_factors_but_what_is_never_zero():
    part = Part(witness={"x": "2", "y": "1", "c1": "1", "K": "1"}, definitions={"d": "x**2 - y**2"})
    scope = Scope.open(LedgerBuilder(), "whole", part, static=True)
    c1, K, d = symbols("c1 K d")
    assert scope.divisors(1 / (c1 * K * 3)) == ()
    assert set(scope.divisors(1 / d, a / (x - y))) == {x - y, x + y}
    assert scope.divisors(x, y**2) == ()


def test_reduced_by_the_relations():
    scope = Scope.open(
        LedgerBuilder(), "circle", circle("C", "S", "theta"), Part(witness={"x": "1"}), static=True
    )
    C, S = (f(symbol("theta")) for f in (sympy.cos, sympy.sin))
    assert scope.reduced(x * C**2 + x * S**2) == x
    assert scope.reduced(x / (C**2 + S**2)) == x


def test_rates_with_definitions_written_out():
    moving = Part(witness={"x": "1", "y": "1"}, rates={"x": "w"}, definitions={"w": "x*y"})
    scope = Scope.open(LedgerBuilder(), "moving", moving)
    assert scope.rates(x**2) == (2 * symbol("w") * x, 2 * x**2 * y)


def test_definitions_are_put_in_until_none_is_left():
    w, v = symbols("w v")
    part = Part(definitions={"w": "x*y", v: 2 * w + sympy.Symbol("x")})
    found = unfold(v * a, part)
    assert found.value == (2 * x * y + x) * a
    assert found.computed
    assert not unfold(a, part).computed
    assert {name: side.computed for name, side in expressions(part.definitions).items()} == {
        w: False,
        v: False,
    }


def test_collected_is_the_same_and_begins_with_a_plus():
    expression = (x - y) * (y - a) / (a - x)
    found = collected(sympy.expand(expression))
    assert sympy.cancel(found - expression) == 0
    assert positive(-x + y) in (x - y, y - x)
    assert not str(positive(y - x)).startswith("-")
