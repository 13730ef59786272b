"""Jacobi's functions for SymPy; their table of derivatives is checked with enclosures.

The enclosures are independent of the table: theta functions over balls (DLMF 22.2), their own
derivatives in z from Arb, in tau by the heat equation, and Legendre's relation for dtau/dm.
"""

import pickle

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp
from mpmath import mp
from sympy.core.function import ArgumentIndexError

from rigidsym.algebra.jacobi_functions import (
    MPMATH,
    NUMPY,
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_sn,
)

u, m, t, a, b = sp.symbols("u m t a b")
FUNCTIONS = (jacobi_sn, jacobi_cn, jacobi_dn, jacobi_am)
every = pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)

ARGUMENTS = ("-7.5", "-1.25", "0.001", "0.4", "1.7", "3.3", "12", "250")
PARAMETERS = ("1e-8", "0.1", "0.5", "0.75", "0.99", "0.999999")
GRID = [(x, y) for x in ARGUMENTS for y in PARAMETERS]
RADIUS = 1e-20


# --- enclosures -----------------------------------------------------------------------------


@pytest.fixture
def balls():
    before = flint.ctx.prec
    flint.ctx.prec = 256
    yield
    flint.ctx.prec = before


class Enclosure:
    """sn, cn, dn, am at a point and their two derivatives, as balls."""

    def __init__(self, u, m):
        self.u, self.m = flint.arb(u), flint.arb(m)
        one, self.k = 1 - self.m, flint.acb(self.m).elliptic_k().real
        tau = flint.acb(0, flint.acb(one).elliptic_k().real / self.k)
        e = flint.acb(self.m).elliptic_e().real
        dk = (e - one * self.k) / (2 * self.m * one)  # DLMF 19.4.1
        z = self.u / (2 * self.k)
        dz = (1 / (2 * self.k), -z * dk / self.k)
        dtau = (flint.arb(0), -flint.arb.pi() / (4 * self.m * one * self.k**2))  # times i
        self.theta = [
            theta_and_slopes(flint.acb(x), tau, y, dtau) for x, y in ((z, dz), (0, (0, 0)))
        ]
        self.values, self.slopes = {}, {}
        # numerator and constants: DLMF 22.2.4-22.2.6
        for name, top, over, under in (("sn", 1, 3, 2), ("cn", 2, 4, 2), ("dn", 3, 4, 3)):
            self.values[name], self.slopes[name] = self.quotient(top, over, under)
        self.amplitude()

    def quotient(self, top, over, under):
        """theta_top(z) / theta_4(z) * theta_over(0) / theta_under(0), by the logarithm."""
        factors = [
            (self.theta[0][top - 1], 1),
            (self.theta[0][3], -1),
            (self.theta[1][over - 1], 1),
            (self.theta[1][under - 1], -1),
        ]
        value = flint.arb(1)
        for (theta, _), power in factors:
            value *= theta**power
        slopes = [sum(s[i] / v * p for (v, s), p in factors) * value for i in (0, 1)]
        return value, slopes

    def amplitude(self):
        """am is the angle of (cn, sn), in the turn that u / 4K tells."""
        sn, cn = self.values["sn"], self.values["cn"]
        turns = round(float((self.u / (4 * self.k)).mid()))
        rest = self.u / (4 * self.k) - turns
        assert abs(rest) < 0.4999  # |am - 2 pi turns| < pi: no doubt about the branch
        self.values["am"] = flint.arb.atan2(sn, cn) + 2 * turns * flint.arb.pi()
        pairs = zip(self.slopes["sn"], self.slopes["cn"], strict=True)
        self.slopes["am"] = [cn * ds - sn * dc for ds, dc in pairs]


def theta_and_slopes(z, tau, dz, dtau):
    """The four theta functions with derivatives along u and m; dtheta/dtau = theta''/(4 pi i)."""
    orders = [z.modular_theta(tau, r) for r in range(3)]
    heat = 4 * flint.arb.pi()
    return [
        (v.real, [v1.real * x + v2.real / heat * y for x, y in zip(dz, dtau, strict=True)])
        for v, v1, v2 in zip(*orders, strict=True)
    ]


def over_balls(expression, point):
    """Evaluate an expression of u and m over balls, Jacobi's functions by their enclosures."""
    table = {
        f"jacobi_{name}": lambda _u, _m, ball=ball: ball for name, ball in point.values.items()
    }
    table["elliptic_e"] = lambda phi, m: flint.acb.elliptic_e_inc(phi, m).real
    return sp.lambdify((u, m), expression, [table])(point.u, point.m)


def test_the_enclosures_themselves(balls):
    for point in (Enclosure(x, y) for x, y in GRID):
        sn, cn, dn = (point.values[name] for name in ("sn", "cn", "dn"))
        for residue in (sn**2 + cn**2 - 1, dn**2 + point.m * sn**2 - 1):
            assert 0 in residue
            assert residue.rad() < RADIUS
        back = flint.acb.elliptic_f(point.values["am"], point.m).real - point.u
        assert 0 in back
        assert back.rad() < RADIUS


@pytest.mark.parametrize("index", [1, 2])
@every
def test_derivatives_are_enclosed(balls, function, index):
    stated = function(u, m).fdiff(index)
    for point in (Enclosure(x, y) for x, y in GRID):
        true = point.slopes[function.__name__.removeprefix("jacobi_")][index - 1]
        residue = over_balls(stated, point) - true
        assert 0 in residue
        assert residue.rad() < RADIUS
        assert not over_balls(stated + sp.Rational(1, 10**9) * u, point).overlaps(true)


@every
def test_fifty_digits_are_enclosed(balls, function):
    name = function.__name__.removeprefix("jacobi_")
    for x, y in GRID:
        value = function(sp.Rational(x), sp.Rational(y)).evalf(50)
        true = Enclosure(x, y).values[name]
        assert abs(flint.arb(str(value)) - true) < flint.arb("1e-49") * max(1, abs(true))


# --- derivatives ----------------------------------------------------------------------------


@pytest.mark.parametrize("index", [1, 2])
@every
def test_derivatives_are_the_numerical_ones(function, index):
    stated = sp.lambdify((u, m), function(u, m).fdiff(index), "mpmath")
    f = MPMATH[function.__name__]
    with mp.workdps(50):
        for x, y in ((0.3, 0.2), (2.5, 0.9), (-4, 0.5), (9, 0.99), (1.5, -2)):
            x, y = mp.mpf(x), mp.mpf(y)
            assert abs(stated(x, y) - central(f, x, y, index)) < 1e-30


def central(f, x, y, index):
    """A central difference of order six, at 110 digits."""
    with mp.workdps(110):
        h, total = mp.mpf(10) ** -12, mp.mpf(0)
        for k, weight in ((1, 45), (2, -9), (3, 1)):
            dx, dy = (k * h, 0) if index == 1 else (0, k * h)
            total += weight * (f(x + dx, y + dy) - f(x - dx, y - dy))
        return total / (60 * h)


@pytest.mark.parametrize("end", [0, 1])
@every
def test_derivatives_in_m_at_the_two_ends(function, end):
    stated = function(u, sp.Integer(end), evaluate=False).fdiff(2)
    inside = sp.lambdify((u, m), function(u, m).fdiff(2), "mpmath")
    with mp.workdps(60):
        for x in (0.3, 1.5, -2.5):
            limit = inside(mp.mpf(x), abs(end - mp.mpf(10) ** -25))
            assert abs(sp.lambdify(u, stated, "mpmath")(mp.mpf(x)) - limit) < 1e-20


@every
def test_other_arguments_have_no_derivative(function):
    for index in (0, 3):
        with pytest.raises(ArgumentIndexError):
            function(u, m).fdiff(index)


def test_the_chain_rule():
    v = a * t + b
    assert sp.diff(jacobi_sn(v, m), t) == a * jacobi_cn(v, m) * jacobi_dn(v, m)
    assert sp.diff(jacobi_cn(v, m), t) == -a * jacobi_sn(v, m) * jacobi_dn(v, m)
    assert sp.diff(jacobi_dn(v, m), t) == -a * m * jacobi_sn(v, m) * jacobi_cn(v, m)
    assert sp.diff(jacobi_am(v, m), t) == a * jacobi_dn(v, m)
    assert sp.diff(jacobi_sn(u, t**2), t) == 2 * t * jacobi_sn(u, m).diff(m).xreplace({m: t**2})


def test_series_about_the_origin():  # DLMF 22.10(i)
    expected = {
        jacobi_sn: u - (1 + m) * u**3 / 6 + (1 + 14 * m + m**2) * u**5 / 120,
        jacobi_cn: 1 - u**2 / 2 + (1 + 4 * m) * u**4 / 24,
        jacobi_dn: 1 - m * u**2 / 2 + m * (4 + m) * u**4 / 24,
        jacobi_am: u - m * u**3 / 6 + m * (4 + m) * u**5 / 120,
    }
    for function, series in expected.items():
        assert sp.expand(function(u, m).series(u, 0, 6).removeO() - series) == 0


# --- values ---------------------------------------------------------------------------------


def test_special_values():
    gd = 2 * sp.atan(sp.tanh(u / 2))
    for zero, one in ((0, 1), (0.0, 1.0)):
        assert [f(u, zero) for f in FUNCTIONS] == [sp.sin(u), sp.cos(u), 1, u]
        assert [f(u, one) for f in FUNCTIONS] == [sp.tanh(u), sp.sech(u), sp.sech(u), gd]
        assert [f(zero, m) for f in FUNCTIONS] == [0, 1, 1, 0]
    assert all(f(sp.nan, m) is sp.nan and f(u, sp.nan) is sp.nan for f in FUNCTIONS)
    assert all(isinstance(f(u, m), f) and f(u, m).args == (u, m) for f in FUNCTIONS)


@every
def test_parity(function):
    sign = -1 if function in (jacobi_sn, jacobi_am) else 1
    assert function(-u, m) == sign * function(u, m)
    assert function(-2 * a * t, m) == sign * function(2 * a * t, m)
    assert function(a - b, m) in (function(b - a, m), sign * function(b - a, m))
    assert function(u, -m).args == (u, -m)


def test_assumptions():
    x, y = sp.symbols("x y", real=True)
    assert all(f(x, y).is_real for f in FUNCTIONS)
    assert all(f(u, m).is_real is None for f in FUNCTIONS)
    assert jacobi_dn(x, sp.Rational(1, 3)).is_positive
    assert jacobi_dn(x, y).is_positive is None


@pytest.mark.parametrize("kind", ["sn", "cn", "dn"])
def test_evalf_is_mpmath_to_fifty_digits(kind):
    function = {"sn": jacobi_sn, "cn": jacobi_cn, "dn": jacobi_dn}[kind]
    points = [("7/5", "1/3"), ("100", "9/10"), ("2", "-3"), ("1/2", "5"), ("1+I/2", "1/3+I")]
    for x, y in points:
        x, y = sp.sympify(x), sp.sympify(y)
        value = function(x, y).evalf(50)
        with mp.workdps(80):
            expected = mpmath.ellipfun(kind, x._to_mpmath(300), m=y._to_mpmath(300))
            assert abs(value._to_mpmath(200) - expected) < mp.mpf(10) ** -49 * (1 + abs(expected))
        assert value.is_real or not x.is_real


def test_evalf_keeps_the_complement_of_m():
    m_near_1 = 1 - sp.Rational(1, 10**30)
    dn = jacobi_dn(sp.Integer(200), m_near_1).evalf(15)
    with mp.workdps(100):
        expected = mpmath.ellipfun("dn", 200, m=1 - mp.mpf(10) ** -30)
        assert abs(dn / sp.Float(expected, 50) - 1) < 1e-14


def test_evalf_where_nothing_can_be_evaluated():
    assert jacobi_am(u, m).evalf() == jacobi_am(u, m)
    assert jacobi_am(sp.I / 2, sp.Rational(1, 3)).evalf().func is jacobi_am
    with pytest.raises(ValueError, match="many-valued"):
        MPMATH["jacobi_am"](1j, 0.5)
    assert mp.isnan(MPMATH["jacobi_sn"](mp.inf, 0.5))


def test_floats_evaluate_at_once():
    assert jacobi_sn(0.5, 0.25) == jacobi_sn(sp.Rational(1, 2), sp.Rational(1, 4)).evalf()


@pytest.mark.parametrize("parameter", [0.0, 1e-9, 0.3, 0.99, 1 - 1e-9, -2.0])
def test_am_has_no_jumps(parameter):
    grid = np.linspace(-100, 100, 4001)
    am = NUMPY["jacobi_am"](grid, parameter)
    dn = NUMPY["jacobi_dn"](grid, parameter)
    step = grid[1] - grid[0]
    assert np.all(np.diff(am) > 0)
    slope = (dn[1:] + dn[:-1]) / 2
    assert np.max(np.abs(np.diff(am) / step - slope)) < 2e-3
    for x in grid[::400]:
        exact = MPMATH["jacobi_am"](mp.mpf(x), mp.mpf(parameter))
        assert abs(NUMPY["jacobi_am"](x, parameter) - exact) < 2e-15 * (1 + abs(exact))


def test_am_gains_pi_each_half_period():
    with mp.workdps(40):
        for y in (mp.mpf("0.3"), 1 - mp.mpf(10) ** -12):
            period = 2 * mp.ellipk(y)
            start = MPMATH["jacobi_am"](mp.mpf("0.7"), y)
            for turns in (-(10**6), -3, 1, 2, 17, 10**9):
                gain = MPMATH["jacobi_am"](mp.mpf("0.7") + turns * period, y) - start
                assert abs(gain - turns * mp.pi) < mp.mpf(10) ** -36 * abs(turns)


def test_am_inverts_the_integral_of_the_first_kind():
    phi, y = sp.Rational(29, 4), sp.Rational(4, 5)
    u_of_phi = sp.elliptic_f(phi, y)
    assert abs(jacobi_am(u_of_phi, y).evalf(40) - phi) < sp.Float("1e-38", 40)


# --- printing -------------------------------------------------------------------------------


def test_printing():
    sn = jacobi_sn(u, m)
    assert str(sn) == "jacobi_sn(u, m)"
    assert sp.srepr(sn) == "jacobi_sn(Symbol('u'), Symbol('m'))"
    assert sp.latex(sn) == r"\operatorname{sn}\left(u \mid m\right)"
    assert sp.latex(sn**2) == r"\operatorname{sn}^{2}\left(u \mid m\right)"
    assert sp.latex(1 / sn) == r"\frac{1}{\operatorname{sn}\left(u \mid m\right)}"
    assert sp.latex(jacobi_am(a * t, m)) == r"\operatorname{am}\left(a t \mid m\right)"
    assert pickle.loads(pickle.dumps(sn)) == sn


# --- lambdify -------------------------------------------------------------------------------


@every
@pytest.mark.parametrize("modules", ["numpy", "scipy", None, [NUMPY, "numpy"]])
def test_lambdify_over_arrays(function, modules):
    call = sp.lambdify((u, m), function(u, m), modules)
    grid, parameters = np.linspace(-30, 30, 121)[:, None], np.array([0.0, 0.2, 0.9, 1 - 1e-12, 1.0])
    values = call(grid, parameters)
    assert values.shape == (121, 5)
    for i, x in enumerate(grid[:, 0]):
        for j, y in enumerate(parameters):
            exact = MPMATH[function.__name__](mp.mpf(x), mp.mpf(y))
            assert abs(values[i, j] - exact) < 1e-14 * (1 + abs(exact))
    assert call(0.5, 0.2) == pytest.approx(float(function(0.5, 0.2)), rel=1e-15)


@every
@pytest.mark.parametrize("modules", ["mpmath", [MPMATH, "mpmath"]])
def test_lambdify_over_mpmath(function, modules):
    call = sp.lambdify((u, m), function(u / 3, m), modules)
    with mp.workdps(50):
        value = call(mp.mpf(4), mp.mpf(2) / 7)
        exact = function(sp.Rational(4, 3), sp.Rational(2, 7)).evalf(60)._to_mpmath(220)
        assert abs(value - exact) < mp.mpf(10) ** -49


def test_lambdify_prefers_the_callers_implementation():
    for module in ("numpy", "mpmath"):
        assert sp.lambdify((u, m), jacobi_sn(u, m), [{"jacobi_sn": max}, module])(2, 3) == 3


def test_numpy_is_accurate_up_to_the_end_and_silent_beyond():
    for y in (1 - 1e-9, 1 - 1e-12, 1 - 1e-15, 1.0, -3.0):
        for name, call in NUMPY.items():
            exact = [MPMATH[name](mp.mpf(x), mp.mpf(y)) for x in (0.1, 2.0, 9.0, 15.0)]
            assert np.allclose(
                call(np.array([0.1, 2.0, 9.0, 15.0]), y), np.array(exact, dtype=float), 5e-15, 5e-15
            )
    for call in NUMPY.values():
        assert np.isnan(call(0.5, 1.5))
        assert np.isnan(call(np.nan, 0.5))
