"""Derivation steps: their values, conditions and facts, and what they refuse."""

import pytest
import sympy
from sympy import I, ImmutableMatrix, MatAdd

from rigidsym.proof.algebra import LedgerBuilder, Part, circle, half_angle, jacobi
from rigidsym.proof.kernel import Grade
from rigidsym.proof.steps import (
    Rate,
    Scope,
    StepError,
    apart,
    coefficients,
    coordinates,
    determinant,
    differentiate,
    eliminate,
    integrate,
    match,
    matrix,
    multiply,
    nonnegative,
    rate_of,
    rewrite,
    roots,
    solve,
    solve_family,
    vary,
)
from rigidsym.proof.steps import (
    _calculus as calculus,
)
from rigidsym.proof.steps import (
    _linear as linear,
)
from rigidsym.proof.steps._names import symbol, symbols

x, y, z, a, b, v = symbols("x y z a b v")
FREE = Part(witness=dict(zip("xyzabv", "231512", strict=True)), units=("a", "a - b"))
HALF = ImmutableMatrix(((I, 0), (0, -I))) / 2
SWAP = ImmutableMatrix(((0, 1), (-1, 0))) / 2
BOTH = ImmutableMatrix(((0, I), (I, 0))) / 2
BASIS = {"A1": HALF, "A2": SWAP, "A3": BOTH}
A1, A2, A3, E, X = map(matrix, ("A1", "A2", "A3", "E", "X"))
CONSTANTS = [[[0, 0, 0] for _ in range(3)] for _ in range(3)]
for one, two, three in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    CONSTANTS[one][two][three], CONSTANTS[two][one][three] = sympy.S(1), sympy.S(-1)


@pytest.fixture
def builder():
    return LedgerBuilder()


@pytest.fixture
def scope(builder):
    return Scope.open(builder, "free", FREE, matrices=BASIS, static=True)


@pytest.fixture
def turning(builder):
    parts = (half_angle("phi1", "w"), Part(witness={"w": "1"}))
    turn = sympy.cos(symbol("phi1") / 2) * sympy.eye(2) + 2 * HALF * sympy.sin(symbol("phi1") / 2)
    matrices = {**BASIS, "E": ImmutableMatrix(turn)}
    return Scope.open(builder, "turning", *parts, matrices=matrices)


def admitted(builder, step, kind="equal"):
    """Assert that a step's fact is proved in the ledger, and that the builder recorded the step."""
    assert builder.ledger.facts[step.fact.id] is step.fact
    assert (step.fact.grade, step.fact.kind) == (Grade.PROVED, kind)
    assert builder.steps[-1] is step
    assert step.why == "why"


def refused(builder, message, step, *arguments):
    """Assert that a step fails with one line and leaves neither fact nor step behind."""
    facts, lines = dict(builder.ledger.facts), list(builder.steps)
    with pytest.raises(StepError, match=message) as error:
        step(*arguments)
    assert len(str(error.value).splitlines()) == 1
    assert (builder.ledger.facts, builder.steps) == (facts, lines)


# What steps refuse in a static context, with the fact that each is to state.
REFUSED = [
    ("free.outside", "undecided", coordinates, A1 + A2, (A1,)),
    ("free.t", "no matrix expression", multiply, A1.T, A1),
    ("free.wrong", r"^solve: free\.wrong: the equations leave y free", solve, [(x + y, 1)], (x, y)),
    (
        "free.wrong",
        r"^solve: free\.wrong: the equations leave y free",
        solve,
        [(x + y, 1), (2 * x + 2 * y, 2)],
        (x, y),
    ),
    ("free.wrong", r"^fact free\.wrong: undecided", solve, [(x, 1), (x, 2), (y, 1)], (x, y)),
    ("free.wrong", r"^solve: free\.wrong: .* not linear", solve, [(x * y, 1), (y, 1)], (x, y)),
    *(
        (
            "free.family",
            r"^solve: free\.family: [02] directions are free, one was expected",
            *(solve_family, equations, (x, y), z),
        )
        for equations in ([(x, a), (y, b)], [(x - x, 0)])
    ),
    ("free.x", "^D: free has no time derivative", differentiate, x),
    ("free.s", r"sin\(x\) has no name in free", rewrite, sympy.sin(x), x),
    ("free.s", "'stranger' has no meaning", rewrite, x, symbol("stranger")),
    *(
        ("free.e", r"^eliminate: free\.e: no one solution", eliminate, x, equations, [x, y])
        for equations in ([x + y - 1, x + y - 2], [x * y - 1])
    ),
    (
        "free.e",
        r"^eliminate: free\.e: the equations leave an unknown free",
        *(eliminate, x, [x + y - 1], [x, y]),
    ),
    ("free.e", "undecided", eliminate, x, [x - y], [x]),
    ("free.roots", r"^roots: free\.roots: a factor is not linear", roots, x**2 - a, x),
    *(
        ("free.match", r"^match: free\.match: no choice of", match, y * (1 - z * v), *wanted)
        for wanted in ((a + b * v**2, v, (y, z)), (b * v, v, (y, z)))
    ),
]


@pytest.mark.parametrize("case", REFUSED, ids=lambda case: f"{case[2].__name__} {case[1]}")
def test_steps_refuse(builder, scope, case):
    fact_id, message, step, *arguments = case
    refused(builder, message, step, scope, fact_id, *arguments, "why")


# Matrices.


@pytest.mark.parametrize(
    ("name", "message", "left", "right"),
    [
        ("rate", r"fact turning\.rate: undecided", Rate(E), -symbol("w") * A1 * E),
        ("half", r"^fact turning\.half: A1 is not unitary", A1.I, -A1),
        ("half", r"^fact turning\.half: A1 is not unitary", A2 * A1.I, A3),
        ("same", r"^fact turning\.same: both sides are the same: I", E.I * E, sympy.Identity(2)),
    ],
)
def test_multiply_refuses(builder, turning, name, message, left, right):
    refused(builder, message, multiply, turning, f"turning.{name}", left, right, "why")


def test_multiply_shows_the_matrices_by_their_names(builder, turning):
    step = multiply(turning, "turning.rate", Rate(E), symbol("w") * A1 * E, "why", ["25"])
    admitted(builder, step)
    assert step.shown == (sympy.Eq(Rate(E), symbol("w") * A1 * E, evaluate=False),)
    assert step.source == step.fact.source == ("25",)
    assert any("E_11_re" in text for text in step.fact.lhs)


def test_the_inverse_is_of_unitary_matrices(builder, turning):
    admitted(builder, multiply(turning, "turning.turned", E.I * A1 * E, A1, "why"))


def test_a_square_is_a_product(builder, scope):
    admitted(builder, multiply(scope, "free.square", A1 * A1, A2**2, "why"))


def test_coordinates_of_a_commutator(builder, scope):
    bracket = MatAdd(A1 * A2, -A2 * A1, evaluate=False)
    step = coordinates(scope, "free.bracket", bracket, (A1, A2, A3), "why")
    admitted(builder, step)
    assert step.value == (0, 0, 1)
    assert step[2] == 1


def test_coordinates_of_nothing(builder, scope):
    nothing = MatAdd(A1, -A1, evaluate=False)
    step = coordinates(scope, "free.nothing", nothing, (A1, A2), "why")
    assert step.value == (0, 0)


def test_coordinates_refuse_what_is_not_real(builder):
    matrices = {**BASIS, "X": ImmutableMatrix(((1, 0), (0, -1)))}
    scope = Scope.open(builder, "complex", FREE, matrices=matrices, static=True)
    refused(builder, "is not real", coordinates, scope, "complex.x", X, (A1, A2, A3), "why")


def test_coordinates_are_in_whole_angles_where_they_can_be(builder):
    parts = (half_angle("phi1", "w"), Part(witness={"w": "1"}))
    parts += (circle("cos_phi1", "sin_phi1", "phi1"),)
    turn = sympy.cos(symbol("phi1") / 2) * sympy.eye(2) + 2 * HALF * sympy.sin(symbol("phi1") / 2)
    known = {name for part in parts for name in part.names}
    assert {"cos_phi1", "sin_phi1"} <= known
    matrices = {**BASIS, "E": ImmutableMatrix(turn)}
    scope = Scope.open(builder, "turned", *parts[:2], matrices=matrices)
    step = coordinates(scope, "turned.seen", E.I * A2 * E, (A1, A2, A3), "why")
    assert step.value == (0, sympy.cos(symbol("phi1")), -sympy.sin(symbol("phi1")))


def test_a_determinant(builder, turning):
    step = determinant(turning, "turning.determinant", E, "why")
    admitted(builder, step)
    assert step.value == 1


# Linear equations.


def test_solve_states_both_directions_and_its_conditions(builder, scope):
    step = solve(scope, "solved.xy", [(a * x + y, z), (x - y, 1)], (x, y), "why")
    admitted(builder, step)
    assert sympy.cancel(step[x] - (z + 1) / (a + 1)) == 0
    assert step.conditions == (a + 1,)
    assert len(step.fact.lhs) == 4
    assert builder.ledger.contexts["solved"].units == (*FREE.units, "a + 1")


def test_solve_takes_the_rows_that_determine(builder, scope):
    step = solve(scope, "free.more", [(2 * x, 4 * a), (x, 2 * a)], (x,), "why")
    assert step[x] == 2 * a


def test_solve_refuses_what_the_relations_make_singular(builder):
    scope = Scope.open(builder, "circle", circle("C", "S", "theta"), FREE, static=True)
    C, S = symbols("C S")
    equations = [(C * x - S * y, 1), (S * x + C * y, a), ((C**2 + S**2 - 1) * z, 0)]
    message = r"^solve: circle\.wrong: the determinant is 0 by the relations of circle"
    refused(builder, message, solve, scope, "circle.wrong", equations, (x, y, z), "why")


def test_solve_divides_modulo_the_relations(builder):
    scope = Scope.open(builder, "circle", circle("C", "S", "theta"), FREE, static=True)
    C, S = (f(symbol("theta")) for f in (sympy.cos, sympy.sin))
    step = solve(scope, "circle.turned", [(C * x - S * y, a), (S * x + C * y, b)], (x, y), "why")
    assert step.conditions == ()
    assert sympy.expand(step[x] - (a * C + b * S)) == 0


def test_a_family_has_what_is_free(builder, scope):
    equations = [(a * y - b * x, a * z - b * v)]  # (x, y) along (a, b), through (v, z)
    step = solve_family(scope, "free.family", equations, (x, y), symbol("z"), "why")
    admitted(builder, step)
    assert step.choice == "z is free"
    assert len(step.fact.lhs) == 2


def test_what_sympy_solves_wrong_is_refused(builder, scope, monkeypatch):
    honest = linear._inverse
    monkeypatch.setattr(linear, "_inverse", lambda *k: (-honest(*k)[0], honest(*k)[1]))
    refused(builder, "undecided", solve, scope, "free.xy", [(x, y)], (x,), "why")


# One expression.


def test_differentiate_by_the_rates(builder):
    moving = Part(witness={"x": "1", "y": "1"}, rates={"x": "y", "y": "-x"},
                  definitions={"E": "(x**2 + y**2)/2"})  # fmt: skip
    scope = Scope.open(builder, "moving", moving)
    step = differentiate(scope, "moving.E", symbol("E"), "why")
    admitted(builder, step)
    assert step.value == 0
    assert step.shown[0].lhs == rate_of(symbol("E"))
    product = differentiate(scope, "moving.product", x * y, "why")
    assert sympy.expand(product.value - (y**2 - x**2)) == 0


def test_differentiate_refuses_an_unknown_rate(builder):
    unknown = Scope.open(builder, "unknown", Part(witness={"x": "1"}, rates={"x": "?"}))
    message = r"^D\(x\) is not known in unknown"
    refused(builder, message, differentiate, unknown, "unknown.x", x, "why")


def test_differentiate_does_not_pass_on_a_wrong_rate(builder, monkeypatch):
    scope = Scope.open(builder, "moving", Part(witness={"x": "1", "y": "1"}, rates={"x": "y"}))
    monkeypatch.setattr(Scope, "rates", lambda self, expression: (x, x))
    refused(builder, r"^fact moving\.x: undecided", differentiate, scope, "moving.x", x, "why")


def test_rewrite_states_what_it_divides_by(builder, scope):
    step = rewrite(scope, "cancelled.x", (x**2 - y**2) / (x - y), x + y, "why")
    admitted(builder, step)
    assert step.conditions == (x - y,)
    assert builder.ledger.contexts["cancelled"].units == (*FREE.units, "x - y")
    refused(builder, "undecided", rewrite, scope, "cancelled.y", x / (x - y), x + y, "why")


def test_eliminate_powers(builder):
    equations = [x**2 + y**2 - a, x**2 - y**2 - b]
    circles = Part(relations=("x**2 + y**2 - a", "x**2 - y**2 - b"))
    there = Part(witness=dict(zip("xyabv", "21532", strict=True)))
    scope = Scope.open(builder, "circles", there, circles, static=True)
    step = eliminate(scope, "circles.x", 3 * x**2 + v, equations, [x**2, y**2], "why")
    admitted(builder, step)
    assert sympy.expand(step.value - (3 * (a + b) / 2 + v)) == 0


def test_partial_fractions_are_of_the_form_of_the_table():
    found = apart((x + 1) / (a - b * x), x).value
    assert sympy.cancel(found - (x + 1) / (a - b * x)) == 0
    (fraction,) = (term for term in found.args if term.has(x))
    below = sympy.fraction(fraction)[1]
    assert any(factor.subs(x, 0) == 1 for factor in sympy.Mul.make_args(below))


@pytest.fixture
def table(builder):
    third = Part(
        witness={"a": "1", "b": "2", "Pi": "0", "t": "0"},
        rates={"t": "1", "Pi": "xi/(1 - a*sn**2)"},
        units=("1 - a*sn**2", "xi", "b"),
    )
    functions = jacobi("sn", "cn", "dn", "xi*t", "mu", "xi")
    constants = Part(witness={"xi": "1", "mu": "9/16"})
    return Scope.open(builder, "table", constants, functions, third)


def entries_of(scope):
    sn, t, Pi, xi = scope.read("sn"), symbol("t"), symbol("Pi"), symbol("xi")
    return sn, {t: sympy.S.One, Pi: xi / (1 - a * sn**2)}


def test_integrate_by_the_table(builder, table):
    sn, known = entries_of(table)
    step = integrate(table, "table.phi", b + 3 / (b * (1 - a * sn**2)), known, "why")
    admitted(builder, step)
    expected = b * symbol("t") + 3 * symbol("Pi") / (b * symbol("xi"))
    assert sympy.expand(step.value - expected) == 0


def test_integrate_refuses_what_is_not_in_the_table(builder, table):
    sn, known = entries_of(table)
    message = r"^integrate: table\.phi: .* is not in the table"
    refused(builder, message, integrate, table, "table.phi", b + sn, known, "why")


def test_a_wrong_table_is_refused(builder, table):
    sn, known = entries_of(table)
    wrong = {**known, symbol("Pi"): 1 / (1 - a * sn**2)}
    rate = 1 / (1 - a * sn**2)
    refused(builder, "undecided", integrate, table, "table.phi", rate, wrong, "why")


def test_roots_with_their_multiplicity(builder, scope):
    polynomial = a * (x - y) * (x - 2 * y) ** 2
    step = roots(scope, "free.roots", sympy.expand(polynomial), x, "why")
    admitted(builder, step)
    assert sorted(step.value, key=str) == [2 * y, 2 * y, y]
    fourth = roots(scope, "other.roots", (a - b) * x**4 - y * x**2, x**2, "why")
    assert set(fourth.value) == {0, y / (a - b)}


def test_a_wrong_root_is_refused(builder, scope, monkeypatch):
    honest = sympy.factor_list

    def wrong(polynomial, *symbols):
        leading, factors = honest(polynomial, *symbols)
        return leading, [(factor + 1, power) for factor, power in factors]

    monkeypatch.setattr(calculus.sympy, "factor_list", wrong)
    polynomial = sympy.expand((x - 1) * (x - 2))
    refused(builder, "undecided", roots, scope, "free.roots", polynomial, x, "why")


def test_coefficients_have_the_highest_power_first():
    assert coefficients((a * x**2 + b) ** 2, x**2) == (a**2, 2 * a * b, b**2)


def test_match_finds_all_choices_without_a_zero(builder):
    scope = Scope.open(builder, "free", FREE, static=True)
    step = match(scope, "free.match", y * (1 - z * v), a - b * v, v, (y, z), "why")
    admitted(builder, step)
    assert step.value == [{y: a, z: b / a}]
    assert step.conditions in ((), (a,))


def test_a_wrong_match_is_refused(builder, scope, monkeypatch):
    monkeypatch.setattr(calculus.sympy, "solve", lambda *_, **__: [{y: -a, z: b / a}])
    arguments = (y * (1 - z * v), a - b * v, v, (y, z), "why")
    refused(builder, r"^fact free\.match: undecided", match, scope, "free.match", *arguments)


def test_a_form_shows_what_is_not_negative(builder):
    positive = Part(witness={"x": "2", "a": "1"}, nonnegative=("a",))
    scope = Scope.open(builder, "signs", positive, static=True)
    step = nonnegative(scope, "signs.sum", a * x**2 + a, a * (x**2 + 1), "why")
    admitted(builder, step, "nonnegative")


@pytest.mark.parametrize("form", [x * a, -a, x**2], ids=["no sign", "negative", "another"])
def test_a_form_that_shows_nothing_is_one_line(builder, form):
    positive = Part(witness={"x": "2", "a": "1"}, nonnegative=("a",))
    scope = Scope.open(builder, "signs", positive, static=True)
    expression = a if form == x**2 else form
    refused(builder, "signs.form", nonnegative, scope, "signs.form", expression, form, "why")


# The variation.


def test_vary_gives_momenta_and_moments(builder):
    rates = symbols("Omega1 Omega2 Omega3")
    energy = sum(c * w**2 for c, w in zip((a, b, 1), rates, strict=True)) / 2
    given = Part(witness={"a": "1", "b": "2"})
    found = vary(builder, "variation", energy, CONSTANTS, given, "why")
    admitted(builder, found.step)
    assert found.momenta == (a * rates[0], b * rates[1], rates[2])
    M2, M3 = symbols("M2 M3")
    assert sympy.expand(found.moments[0] - (M2 * rates[2] - M3 * rates[1])) == 0


def test_vary_refuses_a_stranger_in_the_lagrangian(builder):
    message = "^vary: variation: the Lagrangian has q in it"
    energy = symbol("Omega1") ** 2 + symbol("q")
    refused(builder, message, vary, builder, "variation", energy, CONSTANTS, Part(), "why")
