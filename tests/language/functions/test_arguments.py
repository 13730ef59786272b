"""Algebra of the arguments of Jacobi's functions, against mpmath at complex points."""

import itertools

import pytest
import sympy as sp
from mpmath import mp

from rigidsym.language.functions import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_pi,
    jacobi_sn,
)
from rigidsym.language.functions._jacobi import FUNCTIONS, MPMATH

u, v, w, m, n = sp.symbols("u v w m n")
x = sp.Symbol("x", real=True)
K, ACROSS = sp.elliptic_k(m), sp.I * sp.elliptic_k(1 - m)
MEROMORPHIC = (jacobi_sn, jacobi_cn, jacobi_dn, jacobi_epsilon)
# Real parameters on both cuts of K(m) and K(1 - m), between them, and a complex one.
PARAMETERS = ("-31/10", "2/7", "9/4", "1/3 + 4*I/5")
SHIFTS = [(p, q) for p in range(-3, 4) for q in range(-2, 3)]
every = pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.__name__)
meromorphic = pytest.mark.parametrize("function", MEROMORPHIC, ids=lambda f: f.__name__)
at_parameters = pytest.mark.parametrize("parameter", PARAMETERS)


def number(expression, **values):
    """Evaluate an expression of u, v, w and m over mpmath, at 40 digits."""
    with mp.workdps(40):
        point = [mp.mpmathify(complex(sp.sympify(z))) for z in values.values()]
        return sp.lambdify([*map(sp.Symbol, values)], expression, "mpmath")(*point)


def same(one, other):
    return abs(one - other) < 1e-25 * (1 + abs(other))


def value(function, argument, **values):
    """Evaluate a function by mpmath at an argument that SymPy does not see."""
    with mp.workdps(40):
        parameter = mp.mpmathify(complex(sp.sympify(values["m"])))
        return MPMATH[function.__name__](number(argument, **values), parameter)


POINT = {"u": "3/10 + I/5", "v": "-2/5 + I/7", "w": "11/10"}


@at_parameters
@meromorphic
def test_quarter_periods_are_translations(function, parameter):
    values = {**POINT, "m": parameter}
    for p, q in SHIFTS:
        moved = u + p * K + q * ACROSS
        exact = value(function, moved, **values)
        taken = function(moved, m)
        assert same(number(taken, **values), exact)
        if p % 2 == q % 2 == 0:
            assert not any(f.args[0].has(sp.elliptic_k) for f in taken.atoms(*MEROMORPHIC))
        spread = sp.expand_func(taken)
        assert not any(f.args[0].has(sp.elliptic_k) for f in spread.atoms(*MEROMORPHIC))
        assert same(number(spread, **values), exact)


@at_parameters
@meromorphic
def test_values_at_quarter_periods(function, parameter):
    for p, q in SHIFTS:
        found = function(p * K + q * ACROSS, m)
        if q % 2 and not p % 2:
            assert found is sp.zoo
        else:
            assert not found.has(*MEROMORPHIC)
            exact = value(function, p * K + q * ACROSS, m=parameter)
            assert abs(number(found, m=parameter) - exact) < 1e-14  # K is rounded in between


def test_the_table_of_values():  # DLMF Table 22.5.1
    kc, k = sp.sqrt(1 - m), sp.sqrt(m)
    assert [f(K, m) for f in FUNCTIONS] == [1, 0, kc, sp.pi / 2, sp.elliptic_e(m)]
    assert [f(2 * K, m) for f in FUNCTIONS] == [0, -1, 1, sp.pi, 2 * sp.elliptic_e(m)]
    assert [f(K + ACROSS, m) for f in FUNCTIONS[:3]] == [1 / k, -sp.I * kc / k, 0]
    assert [f(2 * ACROSS, m) for f in FUNCTIONS[:3]] == [0, -1, -1]
    half = sp.Rational(1, 2)  # where SymPy writes K by gamma functions
    assert jacobi_dn(3 * sp.elliptic_k(half), half) == sp.sqrt(2) / 2


@pytest.mark.parametrize("rest", [u, -u, u - v, v - u])
@every
def test_translations_end_in_one_form(function, rest):
    """Each argument modulo 2 K, and its negative, reach one function; no rewriting goes round."""
    for p, q in itertools.product(range(-3, 4), (0, 1) if function is jacobi_am else range(-2, 3)):
        argument = rest + p * K + q * ACROSS
        (one,), (other,) = (function(z, m).atoms(function) for z in (argument, -argument))
        if function is not jacobi_am or not q:
            assert one == other
            assert one.func(*one.args) == one


def test_am_gains_pi():
    assert jacobi_am(u + 2 * K, m) == jacobi_am(u, m) + sp.pi
    assert jacobi_am(u - 6 * K, m) == jacobi_am(u, m) - 3 * sp.pi
    assert sp.expand_func(jacobi_am(u + v, m)) == jacobi_am(u + v, m)
    exact = value(jacobi_am, x - 5 * K, x="3/10", m="2/7")
    assert same(number(jacobi_am(x - 5 * K, m), x="3/10", m="2/7"), exact)


def test_pi_gains_the_complete_integral():
    assert jacobi_pi(n, 3 * K, m) == 3 * sp.elliptic_pi(n, m)
    third, parameter = mp.mpf(1) / 3, mp.mpf("0.25")
    for count in range(-4, 5):
        moved = jacobi_pi(n, u + count * K, m)
        assert moved == -jacobi_pi(n, -u - count * K, m)
        end = mp.mpf("0.3") + count * mp.ellipk(parameter)
        path = mp.linspace(0, end, 9)
        exact = mp.quad(lambda s: 1 / (1 - third * mp.ellipfun("sn", s, m=parameter) ** 2), path)
        found = sp.lambdify([n, u, m], moved, "mpmath")(third, mp.mpf("0.3"), parameter)
        assert abs(found - exact) < 1e-12


@at_parameters
@meromorphic
@pytest.mark.parametrize(
    "argument",
    [u + v, u - v, u + v + w, 2 * u, -3 * u, 4 * u - 2 * v, sp.I * w, 2 * (u + K) + sp.I * w],
    ids=str,
)
def test_addition(function, argument, parameter):
    values = {**POINT, "m": parameter}
    spread = sp.expand_func(function(argument, m))
    plain = {u, v, w}
    assert all(f.args[0] in plain for f in spread.atoms(*MEROMORPHIC))
    assert same(number(spread, **values), value(function, argument, **values))


@meromorphic
def test_conjugates(function):
    assert sp.conjugate(function(u, m)) == function(sp.conjugate(u), sp.conjugate(m))


def test_functions_of_the_integral():
    integral = sp.elliptic_f(u, m)
    assert [f(integral, m) for f in (jacobi_sn, jacobi_cn)] == [sp.sin(u), sp.cos(u)]
    assert jacobi_sn(sp.elliptic_f(sp.asin(v), m), m) == v
    assert jacobi_sn(integral, n).func is jacobi_sn
    # The branch of F decides the amplitude, except for real numbers.
    assert jacobi_am(integral, m).func is jacobi_am
    assert jacobi_am(sp.elliptic_f(x, sp.Rational(-1, 3)), sp.Rational(-1, 3)) == x
    assert jacobi_am(sp.elliptic_f(x, 3), 3).func is jacobi_am


def test_rewriting():
    real, small = sp.Symbol("r", real=True), sp.Symbol("k", negative=True)
    assert jacobi_sn(u, m).rewrite(sp.sin) == sp.sin(jacobi_am(u, m))
    assert jacobi_cn(u, m).rewrite(jacobi_am) == sp.cos(jacobi_am(u, m))
    for function in (jacobi_am, jacobi_epsilon):
        one = function(real, small)
        assert one.rewrite(sp.Integral).diff(real).doit() == one.diff(real)
    assert jacobi_dn(u, m).rewrite(jacobi_sn) == jacobi_dn(u, m)  # which sign?
    found = jacobi_dn(real, small).rewrite(jacobi_sn)
    assert found == sp.sqrt(1 - small * jacobi_sn(real, small) ** 2)
    assert jacobi_epsilon(u, m).rewrite(sp.elliptic_e) == jacobi_epsilon(u, m)
    legendre = jacobi_epsilon(real, small).rewrite(sp.elliptic_e)
    assert legendre == sp.elliptic_e(jacobi_am(real, small), small)
    at = {real: sp.Rational(-77, 10), small: sp.Rational(-2, 3)}
    assert abs(sp.N((legendre - jacobi_epsilon(real, small)).subs(at), 30, chop=True)) < 1e-25


# --- series and limits ----------------------------------------------------------------------


@pytest.mark.parametrize("centre", [0, K, -K, 2 * K, ACROSS, K + ACROSS, 3 * ACROSS, v], ids=str)
@meromorphic
def test_series(function, centre):
    """Compare the series with the function, near regular points, zeros and poles."""
    values = {"v": "2/5", "m": "2/7", "u": "1/5000"}
    series = function(u + centre, m).series(u, 0, 5).removeO()
    exact = value(function, u + centre, **values)
    assert abs(number(series, **values) - exact) < 1e-12
    shorter = series - series.coeff(u, 1) * u
    if series.coeff(u, 1) != 0:
        assert abs(number(shorter, **values) - exact) > 1e-8
    about = function(u, m).series(u, centre, 3).removeO().subs(u, u + centre)
    assert sp.simplify(about - function(u + centre, m).series(u, 0, 3).removeO()) == 0


def test_series_in_m():
    for function, end in itertools.product(FUNCTIONS, (0, 1)):
        series = function(u, m).series(m, end, 2).removeO()
        point = {"u": "7/10", "m": f"{end} + (1 - 2*{end})/10**9"}
        assert abs(number(series - function(u, m), **point)) < 1e-17
        assert abs(number(series.subs(m, end) - function(u, m), **point)) > 1e-12
        with pytest.raises(sp.PoleError, match=f"about m = {end} two terms are known"):
            function(u, m).series(m, end, 4)


def test_limits():
    kc = sp.sqrt(1 - m)
    assert sp.limit(jacobi_sn(u, m) / u, u, 0) == 1
    assert sp.limit(jacobi_cn(u, m) / (u - K), u, K) == -kc
    assert sp.limit(jacobi_sn(u, m) * (u - ACROSS), u, ACROSS) == 1 / sp.sqrt(m)
    assert sp.limit((1 - jacobi_dn(u, m)) / u**2, u, 0) == m / 2
    gd = 2 * sp.atan(sp.tanh(u / 2))
    edges = {0: [sp.sin(u), sp.cos(u), 1, u, u], 1: [sp.tanh(u), *[sp.sech(u)] * 2, gd, sp.tanh(u)]}
    for end, expected in edges.items():
        assert [sp.limit(f(u, m), m, end) for f in FUNCTIONS] == expected
