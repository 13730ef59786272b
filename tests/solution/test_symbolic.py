"""Forms in SymPy: against precise states, equations of motion, and uses of expressions."""

import itertools
import pickle
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy as sp
from ledgers import CONTEXTS, FACTS

import rigidsym
from rigidsym import InputError, TorqueFreeMotion, symbolic
from rigidsym.language import functions
from rigidsym.solution._symbolic import FORMS
from rigidsym.solution._symbolic.symbols import Constant, Word

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
# Omega3 changes its sign.
CROSSING = ((1, 2, "5/2"), (1, 1, "3/10"))
GIVEN = [sp.Rational(x) for x in ATTITUDE]
UNIT = [x / sp.sqrt(sum(y * y for y in GIVEN)) for x in GIVEN]
AT, STEP = sp.Rational(7, 3), sp.Rational(1, 10**6)
NAMESPACE = {**vars(sp), **vars(functions), "Constant": Constant, "Word": Word}


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


def are_close(found, expected, bound, digits=60):
    """Assert that SymPy's numbers, or mpmath's, are mpmath's up to an absolute bound."""
    with mpmath.workdps(digits):
        for x, y in zip(found, expected, strict=True):
            x = x._to_mpmath(240) if isinstance(x, sp.Expr) else x
            assert abs(x - y) < bound


def kinematics(q, omega):
    """Return q' = q (0, omega)/2."""
    (a, b, c, d), (x, y, z) = q, omega
    rows = (-b * x - c * y - d * z, a * x - d * y + c * z, d * x + a * y - b * z)
    return [row / 2 for row in (*rows, -c * x + b * y + a * z)]


# States, equations, and what the forms say of themselves.


@forms(*FORMS, slow=("separatrix",))
def test_states_are_those_of_the_balls_to_fifty_digits(solutions, form):
    q, omega = motion_of(form).precise("7/3", 50)
    are_close(numbers(solutions[form].q(AT)), q, 1e-49)
    are_close(numbers(solutions[form].omega(AT)), omega, 1e-49)


@forms("theorem1", "theta", "symmetric", "sphere", "spin")
def test_it_starts_where_the_motion_does(solutions, form):
    found = numbers(solutions[form].q(0), 30)
    assert all(abs(x - y) < 1e-28 for x, y in zip(found, UNIT, strict=True))


@forms(*FORMS, slow=("pi", "separatrix", "theorem1"))
def test_the_derivative_is_the_kinematics_to_fifty_digits(solutions, form):
    solution = solutions[form]
    (value,) = numbers([solution.q()[1].diff(solution.t).subs(solution.t, AT)])
    q, omega = numbers(solution.q(AT)), numbers(solution.omega(AT))
    assert abs(value - kinematics(q, omega)[1]) < 1e-48


@forms(*FORMS)
def test_constants_are_given_each_by_those_before_it(form):
    solution = symbolic(form)
    inputs = solution.q().free_symbols | solution.omega().free_symbols
    known = {*inputs, *solution.choices} - {*solution.constants}
    given = ("c_", "Omega", "q_", "c1", "c2", "c3", *(f"{x}{k}" for x in "pq" for k in range(4)))
    for symbol, value in solution.constants.items():
        new = value.free_symbols - known
        assert all(str(x).startswith(given) for x in new), (symbol, new)
        assert solution.t not in value.free_symbols
        known |= {symbol, *new}
    assert inputs <= known | {solution.t}


@forms(*FORMS)
def test_it_rests_on_facts_definitions_and_readings_of_the_ledger(form):
    for fact in symbolic(form).facts:
        how, _, place = fact.rpartition(" ")
        context, _, name = place.partition(".")
        table = {"definition": "definitions", "reading": "reading"}.get(how)
        assert name in CONTEXTS[context][table] if table else FACTS[fact]["grade"] == "PROVED"


@forms("pi", slow=("theta", "separatrix"))
def test_free_symbols_take_numbers(form, solutions):
    """Substitute a motion's constants into the form with free symbols: it is that motion."""
    free, own = symbolic(form), solutions[form]
    found = free.omega(AT).subs({x: sp.N(value, 40) for x, value in own.constants.items()})
    expected = {round(float(x), 12) for x in own.omega(AT).evalf(20)}
    assert {round(float(sp.N(x, 30)), 12) for x in found} == expected


def test_conditions_are_met_by_the_motions_they_are_for(solutions):
    for form, solution in solutions.items():
        assert solution.conditions == ()
        assert symbolic(form).conditions
    # Where Omega3 is zero, there is no quotient by it.
    solution = TorqueFreeMotion(*CROSSING).symbolic("theorem1")
    assert len(solution.conditions) in (1, 2)
    assert all(sp.re(sp.N(c.lhs.subs(solution.t, 0), 30)) > 0 for c in solution.conditions)
    assert not solution.choices
    free = symbolic("theorem1")
    (side,) = (symbol for symbol in free.choices if symbol.name == "side")
    assert free.conditions[-1] == sp.Gt(side * free.omega()[2], 0)


@forms("pi", "separatrix", "symmetric")
def test_the_start_is_the_attitude_itself(form):
    """Check that psi vanishes at t = 0 as an expression, without evaluating digits."""
    found = motion_of(form).symbolic(form).q(0)
    assert not any(isinstance(x, sp.tanh) for x in found.atoms(sp.cos))
    for one, given in zip(found, UNIT, strict=True):
        assert abs(sp.N(one, 50) - sp.N(given, 60)) < 1e-49
        assert not one.has(sp.cos, sp.sin) or form == "symmetric"


# Numbers by `lambdify`.


def lambdified(solution, times, modules="numpy"):
    """Evaluate q and omega (7, N) at an array of times; compare with one time alone."""
    call = sp.lambdify(solution.t, [*solution.q(), *solution.omega()], modules)
    found = np.array([np.broadcast_to(x, times.shape) for x in call(times)])
    assert found.dtype == float
    one = np.array([float(x) for x in call(float(times[0]))])
    assert np.max(np.abs(found[:, 0] - one)) < 1e-14
    return found


def lambdified_is(motion, solution, times, of_q, of_omega, modules="numpy"):
    """Assert that a solution gives a motion's states at an array of times, up to bounds."""
    found, (q, omega) = lambdified(solution, times, modules), motion(times)
    assert np.max(np.abs(found[:4].T - q)) < of_q
    assert np.max(np.abs(found[4:].T - omega)) < of_omega


@forms("theorem1", "pi", "theta", "symmetric", "separatrix", "spin")
@pytest.mark.parametrize("modules", ["numpy", "scipy"])
def test_lambdify_over_arrays(solutions, form, modules):
    times = np.linspace(-9.0, 9.0, 7)
    lambdified_is(motion_of(form), solutions[form], times, 3e-14, 3e-14, modules)


# Bodies and rates of each form; the other five orders of axes have other signs.
SHAPES = {
    "pi": CROSSING,
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


@forms(*SHAPES)
def test_lambdify_in_every_order_of_axes(form):
    times = np.array([-31.3, -7.1, -0.01, 0.0, 1.4, 9.1])
    for order, signs in zip(ORDERS, SIGNS, strict=True):
        motion = reordered(*SHAPES[form], order, signs)
        lambdified_is(motion, motion.symbolic(form), times, 1e-13, 1e-13)


@pytest.mark.parametrize(("order", "signs"), [*zip(ORDERS, SIGNS, strict=True)])
@pytest.mark.parametrize("shape", ["pi", "theta"])
def test_theorem1_is_followed_past_zeros_of_omega3(shape, order, signs):
    """Follow motions forward and back, with each axis as the circulation axis."""
    motion = reordered(*SHAPES[shape], order, signs)
    times = np.linspace(-40.0, 60.0, 101)
    _, omega = motion(times)
    changes = np.sum(np.diff(np.sign(omega[:, 2])) != 0)
    circulates = set(np.sign(omega[:, 2])) in ({1.0}, {-1.0})
    assert changes == 0 if circulates else changes > 3
    lambdified_is(motion, motion.symbolic("theorem1"), times, 1e-12, 1e-13)


@pytest.fixture(scope="module")
def crossing():
    motion = TorqueFreeMotion(*CROSSING, ATTITUDE)
    return motion, motion.symbolic("theorem1")


@pytest.mark.parametrize("t", ["7/5", "-1234/7"])
def test_theorem1_evaluates_past_zeros_of_omega3(crossing, t):
    (motion, solution), at = crossing, sp.Rational(t)
    q, omega = motion.precise(t, 35)
    later = [x.evalf(30, subs={solution.t: at}) for x in solution.q()]
    found = [*(x.evalf(30) for x in (*solution.q(at), *solution.omega(at))), *later]
    assert all(x.is_Float for x in found)
    are_close(found, [*q, *omega, *q], 1e-28, 40)


@forms("symmetric", "spin", "theorem1", slow=("theta", "pi", "separatrix"))
def test_lambdify_over_mpmath(solutions, form):
    solution = solutions[form]
    call = sp.lambdify(solution.t, [*solution.omega()], "mpmath")
    expected = motion_of(form).precise("7/3", 40)[1]
    with mpmath.workdps(45):
        are_close(call(mpmath.mpf(7) / 3), expected, 1e-39, 45)


# Series and Taylor polynomials.


@forms("symmetric", "spin", slow=("pi", "theta", "separatrix"))
def test_series_in_time(solutions, form):
    t, rate = solutions[form].t, solutions[form].omega()[1]
    found = sp.sympify(rate).series(t, 0, 3).removeO()
    assert abs(sp.N((found - rate).subs(t, sp.Rational(1, 1000)), 20)) < 1e-8


@forms(*FORMS)
def test_taylor_polynomials_are_the_motion(solutions, form):
    """Take eight terms, which leave out less than 1e-48 after a microsecond."""
    columns = solutions[form].taylor(8)
    for column, expected in zip(columns, motion_of(form).precise(STEP, 50), strict=True):
        found = [sp.N(entry.subs(solutions[form].t, STEP), 60) for entry in column]
        are_close(found, expected, 1e-40)


def test_coefficients_are_exact(solutions):
    q, omega = solutions["pi"].taylor(3)
    (c1, c2, c3), (w1, w2, w3) = MOTIONS["pi"]
    t = sp.Symbol("t", real=True)
    assert omega[0].coeff(t, 0) == w1
    assert omega[0].coeff(t, 1) == sp.Rational((c2 - c3) * w2 * w3, c1)
    assert not q.atoms(sp.Float) | omega.atoms(sp.Float)
    assert [sp.N(x, 30) for x in q.subs(t, 0)] == [sp.N(x, 30) for x in UNIT]


@forms("pi", "theta", "symmetric")
def test_taylor_polynomials_with_free_symbols_take_numbers(solutions, form):
    """Substitute constants for axes of either handedness."""
    free, own = symbolic(form), solutions[form]
    substituted = free.taylor(4)[1].subs({**own.constants}).subs(free.t, STEP)
    found = sorted(sp.N(x, 25) for x in substituted)
    expected = sorted(sp.N(x, 25) for x in own.taylor(4)[1].subs(own.t, STEP))
    assert all(abs(x - y) < 1e-20 for x, y in zip(found, expected, strict=True))


def test_about_another_instant(solutions):
    solution, later = solutions["symmetric"], 2 + STEP
    q, omega = solution.taylor(2, at=2)
    for one, other in ((q, solution.q(later)), (omega, solution.omega(later))):
        assert abs(sp.N(one[1].subs(solution.t, later) - other[1], 30)) < 1e-11


# Text, LaTeX, and what a solution is made of.


@forms(*FORMS)
def test_text_comes_back_as_the_same_expression(solutions, form):
    for solution in (symbolic(form), solutions[form]):
        assert eval(sp.srepr(solution.omega()), dict(NAMESPACE)) == solution.omega()


@forms(*FORMS, slow=("pi", "theorem1"))
def test_printing(solutions, form):
    for solution in (symbolic(form), solutions[form]):
        assert r"\operatorname{None}" not in sp.latex(solution.q())
        assert sp.pretty(solution.omega())
        assert solution._repr_latex_().startswith("$")


def test_pi_is_legendres():
    solution, theta = symbolic("pi"), symbolic("theta")
    assert r"\Pi\left(" in sp.latex(solution.q()[0])
    assert r"\theta_{4}" in sp.latex(theta.omega()[0])
    assert solution.q().has(functions.jacobi_pi)
    assert solution.q().rewrite(sp.elliptic_pi).has(sp.elliptic_pi)
    assert not theta.q().has(functions.jacobi_pi)


def test_explicit_puts_every_constant_in(solutions):
    solution, free = solutions["symmetric"], symbolic("spin")
    assert solution.omega().atoms(Constant)
    assert not solution.explicit(solution.omega()).atoms(Constant)
    left = {str(x) for x in free.explicit(free.omega()).free_symbols}
    assert left <= {"Omega1", "Omega2", "Omega3"}


def test_it_is_frozen(solutions):
    with pytest.raises(AttributeError):
        solutions["pi"].form = "theta"
    with pytest.raises(TypeError):
        solutions["pi"].constants[sp.Symbol("x")] = 1


@forms("pi", "symmetric")
def test_periods_and_phases(form):
    motion = motion_of(form)
    q, omega = motion.precise([0, Fraction(motion.period)], 20)
    assert max(abs(x - y) for x, y in zip(*omega, strict=True)) < 1e-14
    # R(T) R(0)^-1 turns about the momentum, which is fixed in space, by the phase.
    cosine = sum(x * y for x, y in zip(*q, strict=True))
    assert abs(cosine - mpmath.cos(motion.phase_per_period / 2)) < 1e-13
    angle = float(motion.symbolic().quantities["solid_angle"])
    montgomery = 2 * motion.energy * motion.period / motion.momentum - angle
    assert montgomery == pytest.approx(motion.phase_per_period, abs=1e-12)
    turned = motion.precession_rate * motion.period
    assert turned == pytest.approx(motion.phase_per_period, rel=1e-14)


def test_quantities_of_the_edges():
    on, turning = (motion_of(form).symbolic().quantities for form in ("separatrix", "spin"))
    assert on["period"] == float("inf")
    assert (on["modulus"], on["parameter"]) == (1, 1)
    assert "precession_rate" not in on
    assert (turning["precession_rate"], turning["energy"], turning["momentum"]) == (2, 4, 4)
    assert not {"period", "modulus"} & {*turning}


@pytest.mark.parametrize(
    ("ask", "message"),
    [
        (lambda: symbolic("euler"), "form = 'euler': must be one of: theorem1, pi, theta"),
        (lambda: symbolic("pi").taylor(0), "n = 0: a series has at least one term"),
        (
            lambda: motion_of("separatrix").symbolic("pi"),
            r"form = 'pi': .*regime is separatrix; separatrix serves",
        ),
        (lambda: motion_of("pi").symbolic("spin"), r"regime is circulation .*; pi serves"),
        (lambda: motion_of("pi").symbolic(3), "form = 3: must be one of"),
        (
            lambda: TorqueFreeMotion(("2 +/- 1e-9", 3, 4), (1, 1, 2)).symbolic(),
            r"inertia\[0\].*is uncertain",
        ),
        (
            lambda: TorqueFreeMotion((2, 3, 4), (1, 1, 0)).symbolic("theorem1"),
            "Theorem 1 divides by it",
        ),
    ],
)
def test_bad_input_is_named(ask, message):
    with pytest.raises(InputError, match=message):
        ask()


def test_the_names_are_public():
    assert rigidsym.symbolic is symbolic
    assert {"symbolic", "Symbolic"} <= {*rigidsym.__all__}


def test_words_are_upright():
    """Check that phase is not printed as the product of its letters, with numbers or without."""
    for solution in (symbolic("pi"), motion_of("pi").symbolic("pi")):
        assert r"t + \mathrm{phase} \mid" in sp.latex(solution.omega())
    (phase,) = (x for x in symbolic("pi").omega().free_symbols if x.name == "phase")
    assert sp.latex(phase) == r"\mathrm{phase}"
    assert sp.pretty(phase) == str(phase) == "phase"
    assert pickle.loads(pickle.dumps(phase)) == phase
