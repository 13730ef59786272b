"""Chapters that compute, for any basis, sequence and Lagrangian, against motions by numbers."""

import ast
import json
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import permutations, product
from pathlib import Path

import numpy as np
import pytest
import sympy
from forward_motions import (
    INERTIA,
    MOMENTA,
    RATES,
    RATES0,
    TIME,
    Motion,
    constants,
    errors,
    rotation,
    steps_of,
    value,
)

import derivations
import rigidsym
from derivations import FORWARD, conjugacy, euler_lax, lie_algebra
from derivations.setting import GROUPS, KINETIC, SEQUENCES, Setting
from rigidsym import quaternions
from rigidsym.language._expression import parse, to_text
from rigidsym.proof.derivation import Derivation, DerivationError, derive
from rigidsym.proof.steps import _algebra as algebra
from rigidsym.proof.steps import _calculus as calculus
from rigidsym.proof.steps import _linear as linear
from rigidsym.proof.steps._names import read, symbol

FOLDER = Path(derivations.__file__).parent
PAPER = Setting()
OTHER = Setting((3, 1, 3), 2, sympy.Integer(1), -1, (2, 1, 3))
WHEELS = [
    Setting(lagrangian=f"{KINETIC} + h2*Omega2"),
    Setting((2, 1, 2), 1, lagrangian=f"{KINETIC} + h1*Omega1 + h3*Omega3"),
]
# Products of inertia, one of them with a wheel; equal moments, across the last axis and along it.
TILTED = [
    Setting((3, 1, 3), lagrangian=f"{KINETIC} - c12*Omega1*Omega2 - c13*Omega1*Omega3"),
    Setting((1, 2, 3), lagrangian=f"{KINETIC} + c23*Omega2*Omega3 + h1*Omega1"),
]
FULL = Setting(lagrangian=f"{KINETIC} - c12*Omega1*Omega2 - c13*Omega1*Omega3 - c23*Omega2*Omega3")
TWO_ALIKE = "(c1*(Omega1**2 + Omega2**2) + c3*Omega3**2)/2"
EQUAL = [
    Setting((2, 3, 2), lagrangian=TWO_ALIKE),
    Setting((1, 2, 3), 2, lagrangian=TWO_ALIKE),
    Setting((3, 1, 3), lagrangian="c1*(Omega1**2 + Omega2**2 + Omega3**2)/2"),
]
THREE_WHEELS = Setting((3, 2, 3), lagrangian=f"{KINETIC} + h1*Omega1 + h2*Omega2 + h3*Omega3")


@cache
def derived(setting: Setting) -> Derivation:
    return derive((), setting=setting)


@cache
def found(setting: Setting):
    """Return all steps of a derivation by their facts."""
    return steps_of(derived(setting))


# What is typed in the chapters: nothing.

# What computes: steps that find their value, SymPy, and what a scope or a chapter found.
COMPUTES = {
    *(
        "solve",
        "solve_for",
        "factor",
        "expand",
        "cancel",
        "apart",
        "together",
        "subs",
        "coefficients",
        "rate",
    ),
    *("read", "result", "numer", "det", "reduced", "coordinates", "eliminate", "collect"),
    *("linsolve", "integrate", "roots", "match", "solve_family", "determinant", "vary"),
}
NOTHING = {"One", "Zero", "Identity", "ZeroMatrix"}
# The steps to which a chapter gives the right side, and where that stands among their arguments.
GIVEN = {"rewrite": 3, "nonnegative": 3}
STEPS = {*GIVEN, "multiply", "coordinates", "determinant", "differentiate", "eliminate", "match"}
STEPS |= {"roots", "integrate", "solve", "solve_family", "vary"}
# Calls that state an equation past the steps.
STATES = {"claim", "refute", "root", "sign", "decide", "model", "carry"}


def called(call: ast.Call) -> str:
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def bound(function: ast.FunctionDef) -> dict[str, list[ast.expr]]:
    """Return the expressions that a function binds to each name; none to its parameters."""
    values: dict[str, list[ast.expr]] = {}
    for node in ast.walk(function):
        targets = node.targets if isinstance(node, ast.Assign) else []
        if isinstance(node, ast.For | ast.comprehension):
            targets, node.value = [node.target], node.iter
        for name in (n for target in targets for n in ast.walk(target)):
            if isinstance(name, ast.Name):
                values.setdefault(name.id, []).append(node.value)
    return values


def computed(node: ast.AST, names: dict[str, list[ast.expr]], seen: tuple[str, ...] = ()) -> bool:
    """Return True for an expression with a computed part, its names looked up."""
    for part in ast.walk(node):
        if isinstance(part, ast.Call) and called(part) in COMPUTES:
            return not (called(part) == "read" and isinstance(part.args[0], ast.Constant))
        if isinstance(part, ast.Attribute) and part.attr in {*NOTHING, "value", "by_invariants"}:
            return True
        if isinstance(part, ast.Name) and part.id not in seen:
            values = names.get(part.id, [])
            if any(computed(value, names, (*seen, part.id)) for value in values):
                return True
    return False


def typed(source: str) -> Iterator[str]:
    """Yield the right sides that a chapter types, and the calls by which it could state one.

    Typed is: an equation stated past the steps; a text handed to a step that is neither its fact's
    name, nor its words; a number in a product of matrices; a right side handed to `rewrite` or
    `nonnegative` that nothing computed: no part of it, names looked up, was found by a step, by
    SymPy, or by an earlier chapter.
    """
    for function in (f for f in ast.walk(ast.parse(source)) if isinstance(f, ast.FunctionDef)):
        names = bound(function)
        for call in (node for node in ast.walk(function) if isinstance(node, ast.Call)):
            name, where = called(call), f"in line {call.lineno}"
            if name in STATES:
                yield f"{name} {where}"
            texts = [x.value for x in call.args[:1] if isinstance(x, ast.Constant)]
            if name == "read" and any(not str(text).isidentifier() for text in texts):
                yield f"a text is read {where}"
            if name not in STEPS or not isinstance(call.func, ast.Name):
                continue
            constant = [x for x in call.args[2:] if isinstance(x, ast.Constant)]
            told = [x for x in constant if x.value is not None]
            words = [x for x in told if isinstance(x.value, str)]
            if len(words) > 1 + (len(call.args) > 6) or len(words) < len(told):
                yield f"{name} is given a text {where}"
            if name == "multiply" and any(isinstance(x, ast.Constant) for x in numbers(call)):
                yield f"a number in a product {where}"
            if name in GIVEN and not computed(call.args[GIVEN[name]], names):
                yield f"{name} is given what nothing computed {where}"


def numbers(call: ast.Call) -> Iterator[ast.AST]:
    """Yield the parts of a product of matrices, except for indices and the sizes of 0 and 1."""
    waiting = list(call.args[2:4])
    while waiting:
        node = waiting.pop()
        sized = isinstance(node, ast.Call) and called(node) in NOTHING
        if not (sized or isinstance(node, ast.Subscript)):
            yield node
            waiting += ast.iter_child_nodes(node)


@pytest.mark.parametrize("chapter", [*FORWARD, "gyrostat", "symmetric"])
def test_no_right_side_is_typed(chapter):
    assert list(typed((FOLDER / f"{chapter}.py").read_text("utf-8"))) == []


TYPED = [
    'builder.claim("a.b", {"x": "y"})',
    'rewrite(scope, "a.b", x, read("c1*Omega1"), "why")',
    'rewrite(scope, "a.b", x, c1 * Omega1, "why")',
    'y = symbol("c1") * symbol("Omega1")\n    rewrite(scope, "a.b", x, y, "why")',
    'nonnegative(scope, "a.b", x, 1 + y**2, "why")',
    'multiply(scope, "a.b", R * M, 2 * A, "why")',
    'differentiate(scope, "a.b", "x*y", "why")',
]


@pytest.mark.parametrize("line", TYPED)
def test_a_right_side_that_is_typed_is_seen(line):
    assert len(list(typed(f"def derive(builder):\n    {line}\n"))) >= 1


def test_what_is_not_a_step_is_the_assumption_about_Pi_alone():
    facts = {fact.id for chapter in derived(PAPER).chapters for fact in chapter.facts}
    assert facts - {*found(PAPER)} == {"windings.rule"}


# No fact says nothing.


def spelled(text: str) -> str:
    return to_text(parse(text))


@pytest.mark.parametrize("setting", [PAPER, OTHER, WHEELS[0], Setting(group="SO3")], ids=str)
def test_no_fact_has_equal_sides_or_restates_a_definition_or_a_rate_of_its_context(setting):
    data = json.loads(derived(setting).ledger)
    contexts = {context["name"]: context for context in data["contexts"]}
    for fact in data["facts"]:
        context, sides = contexts[fact["context"]], zip(fact["lhs"], fact["rhs"], strict=True)
        pairs = [(spelled(x), spelled(y)) for x, y in sides]
        known = {(name, spelled(text)) for name, text in context["definitions"].items()}
        rates = (context["rates"] or {}).items()
        known |= {(f"D({name})", spelled(text)) for name, text in rates if text != "?"}
        assert all(x != y for x, y in pairs), fact["id"]
        assert not all(pair in known or pair[::-1] in known for pair in pairs), fact["id"]


def test_the_paper_is_the_default():
    assert Setting().paper
    assert Setting(axis=1).paper
    assert not Setting((1, 3, 1)).paper


# Any sequence, axis and basis, by numbers.


def variants() -> list[Setting]:
    factors = (sympy.Rational(1, 2), sympy.Integer(1))
    plain = [
        Setting(sequence, axis, factor, sign)
        for sequence, axis, factor, sign in product(SEQUENCES, (1, 2, 3), factors, (1, -1))
    ]
    return plain + [Setting(order=order) for order in permutations((1, 2, 3))]


AIRCRAFT = Setting((3, 2, 1), 2, sympy.Integer(1), -1, (2, 1, 3))
DRAWN = [PAPER, OTHER, Setting((2, 3, 2), 3, order=(3, 1, 2)), AIRCRAFT, *WHEELS]


# The same with rotation matrices.
ROTATIONS = [replace(x, group="SO3") for x in (PAPER, OTHER, AIRCRAFT, WHEELS[1], TILTED[0])]


def follows(setting: Setting, fact: str) -> None:
    """Assert that the angles carry R' = R Omega and turn the momentum onto the axis."""
    of_attitude, of_momentum = errors(derived(setting), setting, fact)
    assert of_attitude < 1e-9
    assert of_momentum < 1e-12


@pytest.mark.parametrize("fact", ["line32.rate", "line32.by_invariants"])
@pytest.mark.parametrize("setting", [*DRAWN, *TILTED, EQUAL[0], *ROTATIONS], ids=str)
def test_a_derivation_is_a_motion_by_numbers(setting, fact):
    follows(setting, fact)


@pytest.mark.parametrize("sequence", SEQUENCES, ids=str)
def test_each_of_twelve_sequences_is_a_motion_by_numbers(sequence):
    """Each has phi1' as a function of the rate about its last axis, and its own angles."""
    assert len({*SEQUENCES}) == 12
    setting = Setting(sequence)
    short = derive(["euler_lax", "conjugacy", "kinematics"], setting=setting)
    phi1_rate = steps_of(short)["line32.by_invariants"].value
    assert phi1_rate.free_symbols & {*RATES} == {symbol(f"Omega{sequence[-1]}")}
    assert max(errors(short, setting, "line32.by_invariants")) < 1e-9


# Rotation matrices.


@pytest.mark.parametrize("setting", ROTATIONS, ids=str)
def test_the_rotation_matrix_is_that_of_the_quaternions_in_SU2(setting):
    """Compare with R A R^-1 of a motion in SU(2), whose column k has the coordinates for A_k."""
    unitary = Motion(replace(setting, group="SU2"))
    K = float(np.linalg.norm(unitary.momentum(RATES0)))
    known = {**constants(), symbol("K"): K, symbol("H"): unitary.energy(RATES0)}
    steps = found(setting)
    phi1_rate = sympy.lambdify([RATES], steps["line32.rate"].value.subs(known))
    R, momentum, phi1 = unitary.run(phi1_rate)
    columns = [unitary.coordinates(R @ A @ R.conj().T) for A in unitary.basis]
    before = rotation(steps, setting, unitary.momentum(RATES0), 0.0)
    after = rotation(steps, setting, momentum, phi1)
    axes = np.array(setting.order) - 1
    assert np.allclose((before.T @ after)[np.ix_(axes, axes)], np.transpose(columns), atol=1e-9)


def test_the_rotation_matrix_is_that_of_the_package():
    setting = ROTATIONS[0]
    motion, steps = Motion(setting), found(setting)
    K = float(np.linalg.norm(motion.momentum(RATES0)))
    known = {**constants(), symbol("K"): K}
    _, _, phi1 = motion.run(sympy.lambdify([RATES], steps["line32.rate"].value.subs(known)))
    q, omega = rigidsym.TorqueFreeMotion(INERTIA, RATES0)(TIME)
    before = rotation(steps, setting, motion.momentum(RATES0), 0.0)
    after = rotation(steps, setting, motion.momentum(omega), phi1)
    assert np.allclose(before.T @ after, quaternions.matrices(q), atol=1e-9)


def test_the_momentum_is_a_row_of_the_rotation_matrix_and_no_angle_is_halved():
    steps = found(ROTATIONS[0])
    assert [*steps["theorem1.by_momentum"].value.row(0)] == [m / symbol("K") for m in MOMENTA]
    angles = {x.args[0] for x in steps["theorem1.matrix"].value.atoms(sympy.Function)}
    assert angles == {symbol(f"phi{k}") for k in (1, 2, 3)}
    facts = {fact for fact in steps if fact.startswith(("half_tangent", "theorem1.outer"))}
    assert not facts


def test_rotation_matrices_that_multiply_in_the_other_order_are_refused(monkeypatch):
    so3 = GROUPS["SO3"]
    monkeypatch.setitem(GROUPS, "SO3", lambda q: so3(q).T)
    with pytest.raises(DerivationError, match=r"fact quaternions\.product: undecided"):
        derive(["lie_algebra"], setting=Setting(group="SO3"))


def test_an_exponential_without_the_square_of_its_matrix_is_refused(monkeypatch):
    monkeypatch.setattr(
        conjugacy,
        "_exponential",
        lambda A, w, x: (
            conjugacy.ImmutableMatrix.eye(A.rows) * sympy.cos(w * x) + A * sympy.sin(w * x) / w
        ),
    )  # as in SU(2)
    with pytest.raises(DerivationError, match=r"fact three_angles\.exponential: undecided"):
        derive(["conjugacy"], setting=Setting(group="SO3"))
    derive(["conjugacy"], setting=Setting())


def test_the_groups_have_the_same_brackets_equations_and_angles():
    one, other = found(OTHER), found(ROTATIONS[1])
    facts = ["quaternions.bracket_12", "variation.euler", "three_angles.momentum"]
    facts += ["compared.phi2", "compared.phi3", "rates.angles", "line32.by_invariants"]
    for fact in facts:
        assert one[fact].value == other[fact].value


IN_SO3 = [Setting(sequence, group="SO3") for sequence in SEQUENCES]


@pytest.mark.slow
@pytest.mark.parametrize("setting", [*variants(), THREE_WHEELS, FULL, *IN_SO3], ids=str)
def test_every_derivation_is_a_motion_by_numbers(setting):
    follows(setting, "line32.by_invariants")


@pytest.mark.parametrize("setting", EQUAL[1:], ids=str)
def test_about_a_symmetry_axis_phi1_turns_at_K_over_c(setting):
    follows(setting, "line32.rate")
    steps = found(setting)
    assert steps["line32.rate"].value == symbol("K") / symbol("c1")
    assert steps["precession.phi1"].value == symbol("K") / symbol("c1") * symbol("t")
    assert steps["three_angle_motion.tilt"].value == 0


@pytest.mark.parametrize("setting", EQUAL[:2], ids=str)
def test_the_rates_across_a_symmetry_axis_are_a_cosine_and_a_sine(setting):
    motion, steps = Motion(setting), found(setting)

    def slope(rates):
        return np.linalg.solve(motion.tensor, motion.moments(motion.momentum(rates)))

    point = {**constants(), **dict(zip(RATES, RATES0, strict=True))}
    ends = [slope(RATES0 + sign * slope(RATES0)) for sign in (1, -1)]
    second = (ends[0] - ends[1]) / 2  # exact: a slope is quadratic in the rates
    assert value(steps["symmetric.swing"].value, point) == pytest.approx(second[0], rel=1e-12)
    assert {"swinging.Omega1", "swinging.Omega2"} <= {*steps}
    assert "eliminated.square" not in steps


@pytest.mark.parametrize("setting", [*DRAWN, *TILTED, *EQUAL], ids=str)
def test_euler_s_equations_are_those_of_the_matrices(setting):
    motion = Motion(setting)
    point = {**constants(), **dict(zip(RATES, RATES0, strict=True))}
    rates = [value(x, point) for x in found(setting)["variation.euler"].value.values()]
    expected = np.linalg.solve(motion.tensor, motion.moments(motion.momentum(RATES0)))
    assert np.allclose(rates, expected, atol=1e-14)


# The Lie-Poisson form by numbers.


@pytest.mark.parametrize("setting", [*DRAWN, *TILTED, *EQUAL], ids=str)
def test_the_bracket_is_that_of_the_matrices_and_its_flow_of_H_is_the_motion(setting):
    motion, contexts = Motion(setting), json.loads(derived(setting).ledger)["contexts"]
    momentum = motion.momentum(RATES0)
    point = {**constants(), **dict(zip(MOMENTA, momentum, strict=True))}
    known = {context["name"]: context for context in contexts}
    flow = motion.moments(momentum)
    for j, other in enumerate(motion.basis):
        rates = known[f"poisson{j + 1}"]["rates"]
        for name, one in zip(MOMENTA, motion.basis, strict=True):
            expected = -momentum @ motion.coordinates(one @ other - other @ one)
            assert value(read(rates[str(name)]), point) == pytest.approx(expected, abs=1e-12)
        bracket = value(found(setting)[f"poisson{j + 1}.energy"].value, point)
        assert bracket == pytest.approx(-flow[j], abs=1e-12)
        assert found(setting)[f"poisson{j + 1}.casimir"].value == 0


# Wheels: the quartic by numbers, and that both quartics are of one curve.


def invariants(motion: Motion) -> dict[sympy.Symbol, float]:
    momentum = motion.momentum(RATES0)
    squared = {symbol("K_squared"): float(momentum @ momentum)}
    return {**constants(), **squared, symbol("H"): motion.energy(RATES0)}


def test_the_quartic_of_one_wheel_is_the_square_of_its_rate():
    motion = Motion(WHEELS[0])
    rate = motion.moments(motion.momentum(RATES0))[1] / INERTIA[1]
    quartic = found(WHEELS[0])["gyrostat.quartic"].value
    squared = value(quartic, {**invariants(motion), symbol("Omega2"): RATES0[1]})
    assert squared == pytest.approx(rate**2, rel=1e-12)


@pytest.mark.parametrize("setting", [*WHEELS, *TILTED], ids=str)
def test_the_quartic_of_wheels_or_products_is_the_determinant_of_the_pencil(setting):
    motion = Motion(setting)
    point = invariants(motion)
    H, K2 = (point[symbol(name)] for name in ("H", "K_squared"))
    energy = np.block([[motion.tensor, np.zeros((3, 1))], [np.zeros((1, 3)), -2 * H]])
    corner = np.sum(motion.wheel**2) - K2
    along = (motion.tensor @ motion.wheel)[:, None]
    momentum = np.block([[motion.tensor @ motion.tensor, along], [along.T, corner]])
    quartic = found(setting)["pencil.quartic"].value
    for x in (-1.5, 0.3, 4.0):
        expected = np.linalg.det(x * energy - momentum)
        assert value(quartic, {**point, symbol("x"): x}) == pytest.approx(expected, rel=1e-10)


def j_invariant(quartic: sympy.Expr, variable: sympy.Symbol) -> sympy.Expr:
    """Return the j-invariant of the elliptic curve y^2 = quartic."""
    a, b, c, d, e = sympy.Poly(quartic, variable).all_coeffs()
    one = 12 * a * e - 3 * b * d + c**2
    two = 72 * a * c * e + 9 * b * c * d - 27 * a * d**2 - 27 * e * b**2 - 2 * c**3
    return 1728 * 4 * one**3 / (4 * one**3 - two**2)


def modular(x: sympy.Expr, y: sympy.Expr) -> sympy.Expr:
    """Return the classical modular polynomial of level 2: 0 where curves have a 2-isogeny."""
    return (
        x**3 + y**3 - x**2 * y**2 + 1488 * x * y * (x + y) - 162000 * (x**2 + y**2)
        + 40773375 * x * y + 8748000000 * (x + y) - 157464000000000
    )  # fmt: skip


def test_one_rate_of_a_gyrostat_is_on_a_quotient_of_the_pencil_s_curve():
    """Find a 2-isogeny: (Omega1, Omega3) and their negatives have the same Omega2."""
    names = ("c1", "c2", "c3", "h2", "H", "K_squared")
    values = map(sympy.Rational, ("1", "7/4", "5/2", "1/3", "9/8", "4"))
    exact = dict(zip(map(symbol, names), values, strict=True))
    curves = (("gyrostat.quartic", "Omega2"), ("pencil.quartic", "x"))
    one, two = (
        j_invariant(sympy.expand(found(WHEELS[0])[fact].value.subs(exact)), symbol(name))
        for fact, name in curves
    )
    assert modular(one, two) == 0
    assert one != two
    assert modular(one, two + 1) != 0


def test_with_wheels_about_other_axes_phi1_is_no_function_of_one_rate():
    steps = found(WHEELS[1])
    assert steps["line32.by_invariants"].value.free_symbols & {*RATES} > {symbol("Omega2")}
    assert "sine_motion.split" not in steps


# What is changed changes what comes out.


def test_the_other_handedness_turns_the_signs_of_euler_s_equations():
    plain, turned = found(PAPER), found(Setting(order=(2, 1, 3)))
    for rate, moment in plain["variation.euler"].value.items():
        assert turned["variation.euler"].value[rate] == -moment


def test_the_other_sign_and_twice_the_basis_scale_the_brackets():
    plain = found(PAPER)["quaternions.bracket_12"].value
    scaled = derive(["lie_algebra"], setting=Setting((3, 1, 3), 2, sympy.Integer(1), -1))
    bracket = steps_of(scaled)["quaternions.bracket_12"].value
    assert bracket == tuple(-2 * x for x in plain)


def test_another_kinetic_energy_gives_other_equations_and_another_phi1(monkeypatch):
    heavier = KINETIC.replace("c3", "5*c3")
    plain = found(PAPER)
    monkeypatch.setattr("derivations.setting.KINETIC", heavier)
    steps = steps_of(derive((), setting=Setting(lagrangian=heavier)))
    heavy: dict = {symbol("c3"): 5 * symbol("c3")}
    for fact in ("variation.euler", "compared.phi3"):
        for one, two in zip(plain[fact].value.values(), steps[fact].value.values(), strict=True):
            assert sympy.cancel(one.subs(heavy) - two) == 0
    one, two = (known["line32.rate"].value for known in (plain, steps))
    assert sympy.cancel(one.subs(heavy) - two) == 0
    assert sympy.cancel(one - two) != 0


def negated(value):
    if isinstance(value, tuple):
        return tuple(map(negated, value))
    return f"-({value})" if isinstance(value, str) else -value


# What is found wrong is refused by the kernel, in whatever chapter.  A variation is proved for the
# brackets that it is given; the Lax pair refuses wrong ones, and a partner that is none.
WRONG = [
    (lie_algebra, "_brackets", negated, "euler_lax", r"fact body\.lax"),
    (algebra, "_coordinate", negated, "lie_algebra", r"fact quaternions\.product"),
    (linear, "_combination", negated, "euler_lax", r"fact variation\.euler"),
    (calculus, "collected", negated, "phi1_integral", r"fact sine_motion\.split"),
    (euler_lax, "Rate", None, "euler_lax", r"fact body\.lax"),
]


@pytest.mark.parametrize(
    ("module", "name", "change", "chapter", "fact"), WRONG, ids=[x[1] for x in WRONG]
)
def test_a_wrong_answer_is_refused(monkeypatch, module, name, change, chapter, fact):
    honest = getattr(module, name)
    wrong = (lambda *arguments: change(honest(*arguments))) if change else lambda matrix: matrix
    monkeypatch.setattr(module, name, wrong)
    with pytest.raises(DerivationError, match=rf"^chapter {chapter}: {fact}: undecided"):
        derive([chapter], setting=Setting())


# The command.


@pytest.mark.parametrize("choice", ["--sequence 3-1-3 --axis 3", "--group SO3"])
def test_a_variant_leaves_the_sealed_ledger_and_both_checkers_accept_its_own(tmp_path, choice, run):
    sealed, path = FOLDER / "ledger.json", tmp_path / "own.json"
    before = sealed.read_bytes(), sealed.stat().st_mtime_ns
    run(f"derive {choice} -o", path)
    run(f"derive lie_algebra {choice}")
    assert (sealed.read_bytes(), sealed.stat().st_mtime_ns) == before
    for options in ([], ["--independent"]):
        # It is not what numbers rest on.
        assert "theorem steady" in run("check", path, *options, status=1).err
        assert "accepted" in run("check --facts", path, *options).out


PLUS = f"{KINETIC} + "
BAD = [
    ("--sequence", "3-3-1", "must be one of: 1-2-1, 1-2-3, 1-3-1, 1-3-2, 2-1-2, 2-1-3, 2-3-1"),
    ("--sequence", "1-1-1", "must be one of: 1-2-1"),
    ("--sequence", "1-4-1", "must be one of: 1-2-1, 1-2-3, 1-3-1"),
    ("--sequence", "", "must be one of: 1-2-1"),
    ("--group", "SO(3)", "must be one of: SU2, SO3"),
    ("--group", "", "must be one of: SU2, SO3"),
    ("--order", "1-2", "must be one of: 1-2-3, 1-3-2, 2-1-3, 2-3-1, 3-1-2, 3-2-1"),
    ("--axis", "4", "must be 1, 2 or 3"),
    ("--axis", "x", "must be a whole number"),
    ("--factor", "2", "must be 1/2 or 1"),
    ("--factor", "1/0", "must be 1/2 or 1"),
    ("--sign", "0", "must be 1 or -1"),
    ("--order", "1-1-2", "another basis spans no algebra"),
    ("--lagrangian", "", "must be an expression"),
    ("--lagrangian", "(c1*Omega1**2", "must be an expression"),
    ("--lagrangian", "f(Omega1)", "must be an expression"),
    ("--lagrangian", "neg(Omega1, Omega2)", "must be an expression"),
    ("--lagrangian", "Omega1**3", "plus a linear part"),
    ("--lagrangian", PLUS + "h1", "plus a linear part"),
    ("--lagrangian", PLUS + "1/Omega1", "plus a linear part"),
    (
        "--lagrangian",
        PLUS + "Omega1*Omega2",
        "the product of inertia c12 in front of Omega1*Omega2",
    ),
    ("--lagrangian", PLUS + "c12*Omega1*Omega3", "the product of inertia c13"),
    ("--lagrangian", "c2*(Omega1**2 + Omega3**2)/2 + c1*Omega2**2/2", "the moments c1, c2, c3"),
    ("--lagrangian", "h1*Omega1", "the moments c1, c2, c3"),
    ("--lagrangian", f"{KINETIC} - g*n3", "no potential (-g*n3): its torque adds to [M, Omega]"),
    ("--lagrangian", f"{KINETIC} - m*g*l*cos(phi2)", "so the spectrum of M, that is K, is not"),
    ("--lagrangian", f"{KINETIC} - g*n3*Omega1", "polynomials in h1, h2, h3"),
    ("--lagrangian", PLUS + "w*Omega1", "polynomials in h1, h2, h3"),
    ("--lagrangian", PLUS + "Omega1/h1", "polynomials in h1, h2, h3"),
    ("--lagrangian", PLUS + "sqrt(h1)*Omega1", "polynomials in h1, h2, h3"),
]


@pytest.mark.parametrize(("option", "text", "rule"), BAD, ids=[f"{o} {t}" for o, t, _ in BAD])
def test_a_choice_that_is_none_is_one_line(option, text, rule, refused):
    error = refused("derive", option, text)
    assert f"{option[2:]} = {text}: " in error
    assert rule in error


def test_a_variant_has_no_chapters_beyond_theorem_1(refused):
    error = refused("derive regimes --sequence 3-1-3")
    assert "chapter = regimes: must be one of: lie_algebra" in error
    assert error.rstrip().endswith("theorem1: others are the paper's alone")


def test_an_expression_is_read_as_it_is_written():
    assert read(KINETIC) == sum(symbol(f"c{k}") * symbol(f"Omega{k}") ** 2 for k in (1, 2, 3)) / 2
