"""Forms in SymPy against precise states and the equations of motion; and how users apply them."""

import itertools
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp

import rigidsym
from rigidsym import InputError, TorqueFreeMotion, symbolic
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.language import functions
from rigidsym.solution._symbolic import FORMS
from rigidsym.solution._symbolic.symbols import Constant

# A motion for each form.
ATTITUDE = ("0.5", "-0.1", "0.7", "0.3")
MOTIONS = {
    "theorem1": ((3, 2, 4), (1, 1, 2)),
    "pi": ((2, 4, 3), (1, 2, 1)),
    "theta": ((4, 3, 2), (1, -1, 2)),
    "separatrix": ((1, 2, "9/4"), (3, 1, 4)),
    "symmetric": ((2, 3, 2), (1, -1, "1/2")),
    "sphere": ((2, 2, 2), (1, 2, 2)),
    "spin": ((1, 2, "5/2"), (0, -2, 0)),
}
AT, STEP = sp.Rational(7, 3), sp.Rational(1, 10**6)
NAMESPACE = {**vars(sp), **vars(functions), "Constant": Constant}


def motion_of(form):
    return TorqueFreeMotion(*MOTIONS[form], ATTITUDE)


def forms(*names, slow=()):
    """Parametrize by forms; those that take SymPy seconds are marked slow."""
    marked = [pytest.param(name, marks=pytest.mark.slow) for name in slow]
    return pytest.mark.parametrize("form", [*(n for n in names if n not in slow), *marked])


@pytest.fixture(scope="module")
def solutions():
    return {form: motion_of(form).symbolic(form) for form in FORMS}


def numbers(column, digits=60):
    """Return the real parts of a column that is real up to rounding."""
    found = [sp.N(x, digits) for x in column]
    assert all(abs(sp.im(x)) < 1e-50 for x in found)
    return [sp.re(x) for x in found]


def kinematics(q, omega):
    """Return q' = q (0, omega)/2."""
    (a, b, c, d), (x, y, z) = q, omega
    rows = (-b * x - c * y - d * z, a * x - d * y + c * z, d * x + a * y - b * z)
    return [row / 2 for row in (*rows, -c * x + b * y + a * z)]


@forms(*FORMS, slow=("separatrix",))
def test_states_are_those_of_the_balls_to_fifty_digits(solutions, form):
    solution = solutions[form]
    q, omega = numbers(solution.q(AT)), numbers(solution.omega(AT))
    expected = motion_of(form).precise("7/3", 50)
    with mpmath.workdps(60):
        for found, values in ((q, expected[0]), (omega, expected[1])):
            for x, y in zip(found, values, strict=True):
                assert abs(x._to_mpmath(220) - y) < 1e-49


@pytest.mark.parametrize("form", ["theorem1", "theta", "symmetric", "sphere", "spin"])
def test_it_starts_where_the_motion_does(solutions, form):
    found = numbers(solutions[form].q(0), 30)
    given = [sp.Rational(x) for x in ATTITUDE]
    size = sp.sqrt(sum(x * x for x in given))
    assert all(abs(x - y / size) < 1e-28 for x, y in zip(found, given, strict=True))


@forms(*FORMS, slow=("pi", "separatrix", "theorem1"))
def test_the_derivative_is_the_kinematics_to_fifty_digits(solutions, form):
    solution = solutions[form]
    found = solution.q()[1].diff(solution.t).subs(solution.t, AT)
    q, omega = numbers(solution.q(AT)), numbers(solution.omega(AT))
    (value,) = numbers([found])
    assert abs(value - kinematics(q, omega)[1]) < 1e-48


@pytest.mark.parametrize("form", FORMS)
def test_constants_are_given_each_by_those_before_it(form):
    solution = symbolic(form)
    inputs = solution.q().free_symbols | solution.omega().free_symbols
    known = {*inputs, *solution.choices} - {*solution.constants}
    given = ("c_", "Omega", "q_", "c1", "c2", "c3", "p0", "p1", "p2", "p3", "q0", "q1", "q2", "q3")
    for symbol, value in solution.constants.items():
        new = value.free_symbols - known
        assert all(str(x).startswith(given) for x in new), (symbol, new)
        known |= {symbol, *new}
    assert solution.t not in set().union(*(x.free_symbols for x in solution.constants.values()))
    assert inputs <= known | {solution.t}


@pytest.mark.parametrize("form", FORMS)
def test_it_rests_on_facts_definitions_and_readings_of_the_ledger(form):
    data = ledger_data(ledger_text())
    proved = {fact["id"] for fact in data["facts"] if fact["grade"] == "PROVED"}
    contexts = {context["name"]: context for context in data["contexts"]}
    for fact in symbolic(form).facts:
        how, _, place = fact.rpartition(" ")
        context, _, name = place.partition(".")
        table = {"definition": "definitions", "reading": "reading"}.get(how)
        assert name in contexts[context][table] if table else fact in proved


@forms("pi", slow=("theta", "separatrix"))
def test_free_symbols_take_numbers(form, solutions):
    """Substitute a motion's constants into the form with free symbols: it is that motion."""
    free, own = symbolic(form), solutions[form]
    numbers_of = {x: sp.N(value, 40) for x, value in own.constants.items()}
    found = free.omega(AT).subs(numbers_of)
    a, b, d = (sp.N(x, 30) for x in found)
    assert {*(round(float(x), 12) for x in (a, b, d))} == {
        round(float(x), 12) for x in own.omega(AT).evalf(20)
    }


def lambdified(solution, times, modules="numpy"):
    """Evaluate q and omega (7, N) at an array of times; compare with one time alone."""
    call = sp.lambdify(solution.t, [*solution.q(), *solution.omega()], modules)
    found = np.array([np.broadcast_to(x, times.shape) for x in call(times)])
    assert found.dtype == float
    one = np.array([float(x) for x in call(float(times[0]))])
    assert np.max(np.abs(found[:, 0] - one)) < 1e-14
    return found


@pytest.mark.parametrize("form", ["theorem1", "pi", "theta", "symmetric", "separatrix", "spin"])
@pytest.mark.parametrize("modules", ["numpy", "scipy"])
def test_lambdify_over_arrays(solutions, form, modules):
    times = np.linspace(-9.0, 9.0, 7)
    found = lambdified(solutions[form], times, modules)
    q, omega = motion_of(form)(times)
    assert np.max(np.abs(found[:4].T - q)) < 3e-14
    assert np.max(np.abs(found[4:].T - omega)) < 3e-14


# Bodies and rates of each form; the other five orders of axes have other signs.
SHAPES = {
    "pi": ((1, 2, "5/2"), (1, 1, "3/10")),
    "theta": ((1, 2, "5/2"), ("1/10", "1/3", 2)),
    "separatrix": ((1, 2, "9/4"), (3, 1, 4)),
    "symmetric": ((2, 1, 2), (1, -1, "1/2")),
    "sphere": ((2, 2, 2), (1, 2, 0)),
    "spin": ((1, 2, "5/2"), (0, -2, 0)),
}
ORDERS = [*itertools.permutations(range(3))]
SIGNS = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1), (1, 1, -1), (1, -1, 1)]


def reordered(inertia, omega0, order, signs):
    rates = [str(Fraction(omega0[k]) * signs[k]) for k in order]
    return TorqueFreeMotion([inertia[k] for k in order], rates, ATTITUDE)


@pytest.mark.parametrize("form", SHAPES)
def test_lambdify_in_every_order_of_axes(form):
    times = np.array([-31.3, -7.1, -0.01, 0.0, 1.4, 9.1])
    for order, signs in zip(ORDERS, SIGNS, strict=True):
        motion = reordered(*SHAPES[form], order, signs)
        found = lambdified(motion.symbolic(form), times)
        q, omega = motion(times)
        assert np.max(np.abs(found[:4].T - q)) < 1e-13
        assert np.max(np.abs(found[4:].T - omega)) < 1e-13


@pytest.mark.parametrize(("order", "signs"), [*zip(ORDERS, SIGNS, strict=True)])
@pytest.mark.parametrize("shape", ["pi", "theta"])
def test_theorem1_is_followed_past_zeros_of_omega3(shape, order, signs):
    """Follow motions forward and back, with each axis as the circulation axis."""
    motion = reordered(*SHAPES[shape], order, signs)
    times = np.linspace(-40.0, 60.0, 101)
    q, omega = motion(times)
    changes = np.sum(np.diff(np.sign(omega[:, 2])) != 0)
    circulates = set(np.sign(omega[:, 2])) in ({1.0}, {-1.0})
    assert changes == 0 if circulates else changes > 3
    found = lambdified(motion.symbolic("theorem1"), times)
    assert np.max(np.abs(found[:4].T - q)) < 1e-12
    assert np.max(np.abs(found[4:].T - omega)) < 1e-13


@pytest.mark.parametrize("t", ["7/5", "-1234/7"])
def test_theorem1_evaluates_past_zeros_of_omega3(t):
    motion = TorqueFreeMotion((1, 2, "5/2"), (1, 1, "3/10"), ATTITUDE)
    solution, expected = motion.symbolic("theorem1"), motion.precise(t, 35)
    at = sp.Rational(t)
    states = [*solution.q(at), *solution.omega(at)]
    later = [x.evalf(30, subs={solution.t: at}) for x in solution.q()]
    found = [*(x.evalf(30) for x in states), *later]
    assert all(x.is_Float for x in found)
    with mpmath.workdps(40):
        for x, y in zip(found, [*expected[0], *expected[1], *expected[0]], strict=True):
            assert abs(x._to_mpmath(120) - y) < 1e-28


@forms("symmetric", "spin", "theorem1", slow=("theta", "pi", "separatrix"))
def test_lambdify_over_mpmath(solutions, form):
    solution = solutions[form]
    call = sp.lambdify(solution.t, [*solution.omega()], "mpmath")
    expected = motion_of(form).precise("7/3", 40)[1]
    with mpmath.workdps(45):
        found = call(mpmath.mpf(7) / 3)
        assert all(abs(x - y) < 1e-39 for x, y in zip(found, expected, strict=True))


@forms("symmetric", "spin", slow=("pi", "theta", "separatrix"))
def test_series_in_time(solutions, form):
    solution = solutions[form]
    t, rate = solution.t, solution.omega()[1]
    found = sp.sympify(rate).series(t, 0, 3).removeO()
    gap = sp.N((found - rate).subs(t, sp.Rational(1, 1000)), 20)
    assert abs(gap) < 1e-8


@pytest.mark.parametrize("form", FORMS)
def test_taylor_polynomials_are_the_motion(form):
    """Take eight terms, which leave out less than 1e-48 after a microsecond."""
    motion = motion_of(form)
    expected = motion.precise(STEP, 50)
    with mpmath.workdps(60):
        for column, values in zip(motion.symbolic(form).taylor(8), expected, strict=True):
            for entry, value in zip(column, values, strict=True):
                found = sp.N(entry.subs(motion.symbolic(form).t, STEP), 60)
                assert abs(found._to_mpmath(200) - value) < 1e-40


def test_coefficients_are_exact():
    q, omega = motion_of("pi").symbolic("pi").taylor(3)
    (c1, c2, c3), (w1, w2, w3) = MOTIONS["pi"]
    t = sp.Symbol("t", real=True)
    assert omega[0].coeff(t, 0) == w1
    assert omega[0].coeff(t, 1) == sp.Rational((c2 - c3) * w2 * w3, c1)
    assert not q.atoms(sp.Float) | omega.atoms(sp.Float)
    assert [sp.N(x, 30) for x in q.subs(t, 0)] == [
        sp.N(sp.Rational(x) / sp.sqrt(sum(sp.Rational(y) ** 2 for y in ATTITUDE)), 30)
        for x in ATTITUDE
    ]


@pytest.mark.parametrize("form", ["pi", "theta", "symmetric"])
def test_taylor_polynomials_with_free_symbols_take_numbers(form):
    """Substitute constants for axes of either handedness."""
    solution, own = symbolic(form), motion_of(form).symbolic(form)
    numbers = {**own.constants}
    free = solution.taylor(4)[1].subs(numbers).subs(solution.t, STEP)
    found = sorted(sp.N(x, 25) for x in free)
    expected = sorted(sp.N(x, 25) for x in own.taylor(4)[1].subs(own.t, STEP))
    assert all(abs(x - y) < 1e-20 for x, y in zip(found, expected, strict=True))


def test_about_another_instant():
    solution = motion_of("symmetric").symbolic("symmetric")
    q, omega = solution.taylor(2, at=2)
    later = 2 + STEP
    for one, other in ((q, solution.q(later)), (omega, solution.omega(later))):
        assert abs(sp.N(one[1].subs(solution.t, later) - other[1], 30)) < 1e-11


def test_a_series_has_a_term():
    with pytest.raises(InputError, match="n = 0: a series has at least one term"):
        symbolic("pi").taylor(0)


@pytest.mark.parametrize("form", ["pi", "separatrix", "symmetric"])
def test_the_start_is_the_attitude_itself(form):
    """Check that psi vanishes at t = 0 as an expression, without evaluating digits."""
    found = motion_of(form).symbolic(form).q(0)
    assert not any(isinstance(x, sp.tanh) for x in found.atoms(sp.cos))
    size = sp.sqrt(sum(sp.Rational(x) ** 2 for x in ATTITUDE))
    for one, given in zip(found, ATTITUDE, strict=True):
        assert abs(sp.N(one, 50) - sp.N(sp.Rational(given) / size, 60)) < 1e-49
        assert not one.has(sp.cos, sp.sin) or form == "symmetric"


@pytest.mark.parametrize("form", FORMS)
def test_text_comes_back_as_the_same_expression(solutions, form):
    for solution in (symbolic(form), solutions[form]):
        again = eval(sp.srepr(solution.omega()), dict(NAMESPACE))
        assert again == solution.omega()


@forms(*FORMS, slow=("pi", "theorem1"))
def test_printing(solutions, form):
    for solution in (symbolic(form), solutions[form]):
        assert r"\operatorname{None}" not in sp.latex(solution.q())
        assert sp.pretty(solution.omega())
        assert solution._repr_latex_().startswith("$")


def test_pi_is_legendres():
    solution = symbolic("pi")
    assert r"\Pi\left(" in sp.latex(solution.q()[0])
    assert r"\theta_{4}" in sp.latex(symbolic("theta").omega()[0])
    assert solution.q().has(functions.jacobi_pi)
    assert solution.q().rewrite(sp.elliptic_pi).has(sp.elliptic_pi)
    assert not symbolic("theta").q().has(functions.jacobi_pi)


def test_explicit_puts_every_constant_in(solutions):
    solution = solutions["symmetric"]
    assert solution.omega().atoms(Constant)
    found = solution.explicit(solution.omega())
    assert not found.atoms(Constant)
    free = symbolic("spin")
    assert {str(x) for x in free.explicit(free.omega()).free_symbols} <= {
        "Omega1",
        "Omega2",
        "Omega3",
    }


def test_it_is_frozen(solutions):
    with pytest.raises(AttributeError):
        solutions["pi"].form = "theta"
    with pytest.raises(TypeError):
        solutions["pi"].constants[sp.Symbol("x")] = 1


def test_conditions_are_met_by_the_motions_they_are_for(solutions):
    for form, solution in solutions.items():
        assert solution.conditions == ()
        assert symbolic(form).conditions
    # Omega3 changes its sign: where it is zero, there is no quotient by it.
    solution = TorqueFreeMotion((1, 2, "5/2"), (1, 1, "3/10")).symbolic("theorem1")
    assert len(solution.conditions) in (1, 2)
    assert all(sp.re(sp.N(c.lhs.subs(solution.t, 0), 30)) > 0 for c in solution.conditions)
    assert not solution.choices
    free = symbolic("theorem1")
    assert free.conditions[-1] == sp.Gt(sp.Symbol("side", real=True) * free.omega()[2], 0)


@pytest.mark.parametrize("form", ["pi", "symmetric"])
def test_periods_and_phases(form):
    motion = motion_of(form)
    period, phase = Fraction(motion.period), motion.phase_per_period
    q, omega = motion.precise([0, period], 20)
    assert max(abs(x - y) for x, y in zip(*omega, strict=True)) < 1e-14
    # R(T) R(0)^-1 turns about the momentum, which is fixed in space, by the phase.
    (a, *v), (b, *u) = q[1], q[0]
    cosine = a * b + sum(x * y for x, y in zip(v, u, strict=True))
    assert abs(cosine - mpmath.cos(phase / 2)) < 1e-13
    quantities = motion.symbolic().quantities
    montgomery = 2 * motion.energy * motion.period / motion.momentum - float(
        quantities["solid_angle"]
    )
    assert montgomery == pytest.approx(phase, abs=1e-12)
    assert motion.precession_rate * motion.period == pytest.approx(phase, rel=1e-14)


def test_quantities_of_the_edges():
    on, turning = (motion_of(form).symbolic().quantities for form in ("separatrix", "spin"))
    assert on["period"] == float("inf")
    assert (on["modulus"], on["parameter"]) == (1, 1)
    assert "precession_rate" not in on
    assert (turning["precession_rate"], turning["energy"], turning["momentum"]) == (2, 4, 4)
    assert not {"period", "modulus"} & {*turning}


def test_bad_input_is_named():
    with pytest.raises(InputError, match="form = 'euler': must be one of: theorem1, pi, theta"):
        symbolic("euler")
    with pytest.raises(InputError, match=r"form = 'pi': .*regime is separatrix; separatrix serves"):
        motion_of("separatrix").symbolic("pi")
    with pytest.raises(InputError, match=r"regime is circulation .*; pi serves"):
        motion_of("pi").symbolic("spin")
    with pytest.raises(InputError, match="form = 3: must be one of"):
        motion_of("pi").symbolic(3)
    uncertain = TorqueFreeMotion(("2 +/- 1e-9", 3, 4), (1, 1, 2))
    with pytest.raises(InputError, match=r"inertia\[0\].*is uncertain"):
        uncertain.symbolic()
    with pytest.raises(InputError, match="Theorem 1 divides by it"):
        TorqueFreeMotion((2, 3, 4), (1, 1, 0)).symbolic("theorem1")


def test_the_names_are_public():
    assert rigidsym.symbolic is symbolic
    assert {"symbolic", "Symbolic"} <= {*rigidsym.__all__}
