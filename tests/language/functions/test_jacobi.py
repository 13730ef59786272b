"""Jacobi's functions for SymPy: values, derivatives by enclosures, printing and `lambdify`.

The enclosures are independent of the table: theta functions over balls (DLMF 22.2), their own
derivatives in z from Arb, in tau by the heat equation, and Legendre's relation for dtau/dm.
"""

import pickle
from functools import cache

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp
from mpmath import mp
from sympy.core.function import ArgumentIndexError
from sympy.printing.numpy import CuPyPrinter, JaxPrinter

from rigidsym.language.functions._arrays import NUMPY
from rigidsym.language.functions._jacobi import (
    MPMATH,
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_sn,
)

u, m, t, a, b = sp.symbols("u m t a b")
FUNCTIONS = (jacobi_sn, jacobi_cn, jacobi_dn, jacobi_am, jacobi_epsilon)
every = pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)

ARGUMENTS = ("-7.5", "-1.25", "0.001", "0.4", "1.7", "3.3", "12", "250")
PARAMETERS = ("1e-8", "0.1", "0.5", "0.75", "0.99", "0.999999")
OUTSIDE = ("-1000", "-0.7", "1.000001", "1.3", "40")  # many swings of each m > 1
GRID = [(x, y) for x in ARGUMENTS for y in PARAMETERS + OUTSIDE]
RADIUS = 1e-20


@cache
def exact(name, x, y):
    """Return a function of doubles by mpmath, at its own precision."""
    return MPMATH[name](mp.mpf(x), mp.mpf(y))


# --- enclosures -----------------------------------------------------------------------------


@pytest.fixture
def balls():
    with flint.ctx.workprec(256):
        yield


class Enclosure:
    """The five functions at a point and their two derivatives, as balls.

    K and tau are complex for m outside [0, 1], on the same side of the cut; the results are real.
    """

    def __init__(self, u, m):
        self.u, self.m = flint.arb(u), flint.arb(m)
        one, self.k = 1 - self.m, flint.acb(self.m).elliptic_k()
        tau = flint.acb(0, 1) * flint.acb(one).elliptic_k() / self.k
        self.e = flint.acb(self.m).elliptic_e()
        self.dk = (self.e - one * self.k) / (2 * self.m * one)  # DLMF 19.4.1
        z = self.u / (2 * self.k)
        dz = (1 / (2 * self.k), -z * self.dk / self.k)
        dtau = (0, -flint.arb.pi() / (4 * self.m * one * self.k**2))  # times i
        self.theta = [
            theta_and_slopes(flint.acb(x), tau, y, dtau) for x, y in ((z, dz), (0, (0, 0)))
        ]
        self.values, self.slopes = {}, {}
        # numerator and constants: DLMF 22.2.4-22.2.6
        for name, top, over, under in (("sn", 1, 3, 2), ("cn", 2, 4, 2), ("dn", 3, 4, 3)):
            self.values[name], self.slopes[name] = self.quotient(top, over, under)
        self.amplitude()
        self.epsilon(dz[0])

    def quotient(self, top, over, under):
        """Return theta_top(z) / theta_4(z) * theta_over(0) / theta_under(0) and its slopes."""
        there, at_zero = self.theta[0][0], self.theta[1][0]
        factors = [(there[top - 1], 1), (there[3], -1), (at_zero[over - 1], 1)]
        factors.append((at_zero[under - 1], -1))
        value = flint.acb(1)
        for (theta, _), power in factors:
            value *= theta**power
        slopes = [sum(s[i] / v * p for (v, s), p in factors) * value for i in (0, 1)]
        return value.real, [slope.real for slope in slopes]

    def amplitude(self):
        """Set am, the angle of (cn, sn) in the turn of u / 4K, and its slopes."""
        sn, cn = self.values["sn"], self.values["cn"]
        part = self.u / (4 * self.k.real)
        turns = round(float(part.mid())) if self.m < 1 else 0
        # |am - 2 pi turns| < pi: no doubt about the branch.
        assert abs(part - turns) < 0.4999 if self.m < 1 else cn > 0
        self.values["am"] = flint.arb.atan2(sn, cn) + 2 * turns * flint.arb.pi()
        pairs = zip(self.slopes["sn"], self.slopes["cn"], strict=True)
        self.slopes["am"] = [cn * ds - sn * dc for ds, dc in pairs]

    def epsilon(self, rate):
        """Set epsilon, E u / K plus a logarithmic derivative (DLMF 22.16.30), and its slopes."""
        (theta, d_theta), (slope, d_slope) = (order[3] for order in self.theta[0])
        mean, zeta = self.e / self.k, rate * slope / theta
        d_mean = (self.e - self.k) / (2 * self.m * self.k) - mean * self.dk / self.k  # DLMF 19.4.2
        d_rate = (0, -rate * self.dk / self.k)
        d_zeta = [
            zeta * (d_slope[i] / slope - d_theta[i] / theta + d_rate[i] / rate) for i in (0, 1)
        ]
        self.values["epsilon"] = (mean * self.u + zeta).real
        self.slopes["epsilon"] = [(mean + d_zeta[0]).real, (d_mean * self.u + d_zeta[1]).real]


def theta_and_slopes(z, tau, dz, dtau):
    """Return the four theta functions and their z-derivatives, each with its slopes in u and m.

    The heat equation gives the derivative in tau: dtheta/dtau = theta''/(4 pi i).
    """
    orders = [z.modular_theta(tau, r) for r in range(4)]
    heat = 4 * flint.arb.pi()
    return [
        [
            (v, [v1 * x + v2 / heat * y for x, y in zip(dz, dtau, strict=True)])
            for v, v1, v2 in zip(*orders[r : r + 3], strict=True)
        ]
        for r in (0, 1)
    ]


def over_balls(expression, point):
    """Evaluate an expression of u and m over balls, Jacobi's functions by their enclosures."""
    table = {
        f"jacobi_{name}": lambda _u, _m, ball=ball: ball for name, ball in point.values.items()
    }
    return sp.lambdify((u, m), expression, [table])(point.u, point.m)


def test_the_enclosures_themselves(balls):
    for point in (Enclosure(x, y) for x, y in GRID):
        sn, cn, dn = (point.values[name] for name in ("sn", "cn", "dn"))
        for residue in (sn**2 + cn**2 - 1, dn**2 + point.m * sn**2 - 1):
            assert 0 in residue
            assert residue.rad() < RADIUS
        if point.m < 1:  # the integrals of an amplitude that swings know nothing of later swings
            am = point.values["am"]
            first = flint.acb.elliptic_f(am, point.m).real - point.u
            second = flint.acb.elliptic_e_inc(am, point.m).real - point.values["epsilon"]
            assert 0 in first
            assert 0 in second
            assert max(first.rad(), second.rad()) < RADIUS


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
        points = ((0.3, 0.2), (2.5, 0.9), (-4, 0.5), (9, 0.99), (1.5, -2), (0.2, 7), (-31, 1.25))
        for x, y in points:
            x, y = mp.mpf(x), mp.mpf(y)
            assert abs(stated(x, y) - central(f, x, y, index)) < 1e-30


def central(f, x, y, index):
    """Return a central difference of order six, at 110 digits."""
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
    assert sp.diff(jacobi_epsilon(v, m), t) == a * jacobi_dn(v, m) ** 2
    assert sp.diff(jacobi_sn(u, t**2), t) == 2 * t * jacobi_sn(u, m).diff(m).xreplace({m: t**2})


def test_series_about_the_origin():  # DLMF 22.10(i)
    expected = {
        jacobi_sn: u - (1 + m) * u**3 / 6 + (1 + 14 * m + m**2) * u**5 / 120,
        jacobi_cn: 1 - u**2 / 2 + (1 + 4 * m) * u**4 / 24,
        jacobi_dn: 1 - m * u**2 / 2 + m * (4 + m) * u**4 / 24,
        jacobi_am: u - m * u**3 / 6 + m * (4 + m) * u**5 / 120,
        jacobi_epsilon: u - m * u**3 / 3 + m * (1 + m) * u**5 / 15,
    }
    for function, series in expected.items():
        assert sp.expand(function(u, m).series(u, 0, 6).removeO() - series) == 0


# --- values ---------------------------------------------------------------------------------


def test_special_values():
    gd = 2 * sp.atan(sp.tanh(u / 2))
    for zero, one in ((0, 1), (0.0, 1.0)):
        assert [f(u, zero) for f in FUNCTIONS] == [sp.sin(u), sp.cos(u), 1, u, u]
        hyperbolic = [sp.tanh(u), sp.sech(u), sp.sech(u), gd, sp.tanh(u)]
        assert [f(u, one) for f in FUNCTIONS] == hyperbolic
        assert [f(zero, m) for f in FUNCTIONS] == [0, 1, 1, 0, 0]
    assert all(f(sp.nan, m) is sp.nan and f(u, sp.nan) is sp.nan for f in FUNCTIONS)
    assert all(isinstance(f(u, m), f) and f(u, m).args == (u, m) for f in FUNCTIONS)


@every
def test_parity(function):
    sign = 1 if function in (jacobi_cn, jacobi_dn) else -1
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


@pytest.mark.parametrize(
    ("kind", "function"), [("sn", jacobi_sn), ("cn", jacobi_cn), ("dn", jacobi_dn)]
)
def test_evalf_is_mpmath_to_fifty_digits(kind, function):
    points = [("7/5", "1/3"), ("100", "9/10"), ("2", "-3"), ("1/2", "5"), ("1+I/2", "1/3+I")]
    for x, y in points:
        x, y = sp.sympify(x), sp.sympify(y)
        value = function(x, y).evalf(50)
        with mp.workdps(80):
            expected = mpmath.ellipfun(kind, x._to_mpmath(300), m=y._to_mpmath(300))
            assert abs(value._to_mpmath(200) - expected) < mp.mpf(10) ** -49 * (1 + abs(expected))
        assert value.is_real or not x.is_real


def test_epsilon_is_the_integral_of_dn_squared(balls):
    points = [("7/5", "1/3"), ("3", "-30"), ("-4", "999/1000"), ("9", "8/5"), ("5", "11")]
    points += [("1+I/2", "1/3"), ("2-I/5", "3"), ("1/2+I/3", "1/3+I"), ("1-I", "-2+I/7")]
    for x, y in points:
        x, y = sp.sympify(x), sp.sympify(y)
        value = jacobi_epsilon(x, y).evalf(50)
        end, parameter = (flint.acb(*map(str, z.evalf(80).as_real_imag())) for z in (x, y))
        true = integral_of_dn_squared(end, parameter)
        residue = flint.acb(*map(str, value.as_real_imag())) - true
        assert abs(residue) < flint.arb("1e-49") * abs(true).max(1)
        assert value.is_real or not x.is_real


def integral_of_dn_squared(end, m):
    """Return the integral by Arb's rigorous quadrature; dn is the quotient of DLMF 22.2.6."""
    k = m.elliptic_k()
    tau = flint.acb(0, 1) * (1 - m).elliptic_k() / k
    constants = flint.acb(0).modular_theta(tau)

    def integrand(s, _):
        theta = (s / (2 * k)).modular_theta(tau)
        return (theta[2] / theta[3] * constants[3] / constants[2]) ** 2

    return flint.acb.integral(integrand, 0, end)


@pytest.mark.parametrize("parameter", ["-1e300", "-1e6", "-1e-20", "1e-300", "1.0000001", "1e6"])
def test_epsilon_far_out(parameter):
    """Compare with Carlson's R_D: epsilon is u less the integral of m sn^2 (19.25.13)."""

    def part(sn, cn2, dn2):
        return sn**3 * mp.elliprd(cn2, dn2, 1) / 3

    for x in ("1e-30", "0.01", "30", "1e9"):
        with mp.workdps(400):
            x, y = mp.mpf(x), mp.mpf(parameter)
            quarter = mp.re(mp.ellipk(y))
            turns = mp.nint(x / (2 * quarter))
            v = x - 2 * turns * quarter
            sn, cn, dn = (mp.re(mp.ellipfun(kind, v, m=y)) for kind in ("sn", "cn", "dn"))
            top = 1 / max(y, mp.one)  # of sn^2
            whole = part(mp.sqrt(top), 1 - top, max(1 - y, mp.zero))
            expected = x - y * (part(sn, cn**2, dn**2) + 2 * turns * whole)
        with mp.workdps(50):
            value = MPMATH["jacobi_epsilon"](x, y)
            assert abs(value / expected - 1) < mp.mpf(10) ** -48
            assert not mp.im(value)


@pytest.mark.parametrize("sign", [1, -1])
def test_large_parameters_cost_no_digits(sign):
    with mp.workdps(300):
        exact = mp.re(mp.ellipfun("sn", mp.mpf(10) / 3, m=sign * 10**160))
    value = jacobi_sn(sp.Rational(10, 3), sign * sp.Integer(10) ** 160).evalf(50)
    with mp.workdps(60):
        assert abs(value._to_mpmath(200) / exact - 1) < mp.mpf(10) ** -48


def test_evalf_keeps_the_complement_of_m():
    m_near_1 = 1 - sp.Rational(1, 10**30)
    dn = jacobi_dn(sp.Integer(200), m_near_1).evalf(15)
    with mp.workdps(100):
        expected = mpmath.ellipfun("dn", 200, m=1 - mp.mpf(10) ** -30)
        assert abs(dn / sp.Float(expected, 50) - 1) < 1e-14


def test_evalf_of_symbols_is_none_and_of_floats_at_once():
    assert jacobi_am(u, m).evalf() == jacobi_am(u, m)
    assert jacobi_am(sp.I / 2, sp.Rational(1, 3)).evalf().func is jacobi_am
    with pytest.raises(ValueError, match="many-valued"):
        MPMATH["jacobi_am"](1j, 0.5)
    assert mp.isnan(MPMATH["jacobi_sn"](mp.inf, 0.5))
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
        right = exact("jacobi_am", x, parameter)
        assert abs(NUMPY["jacobi_am"](x, parameter) - right) < 2e-15 * (1 + abs(right))


def test_am_gains_pi_each_half_period():
    with mp.workdps(40):
        for y in (mp.mpf("0.3"), 1 - mp.mpf(10) ** -12):
            period = 2 * mp.ellipk(y)
            start = MPMATH["jacobi_am"](mp.mpf("0.7"), y)
            for turns in (-(10**6), -3, 1, 2, 17, 10**9):
                gain = MPMATH["jacobi_am"](mp.mpf("0.7") + turns * period, y) - start
                assert abs(gain - turns * mp.pi) < mp.mpf(10) ** -36 * abs(turns)


@pytest.mark.parametrize("parameter", ["-40", "0.3", "0.999999999999", "1.25", "1e5"])
def test_epsilon_gains_the_same_each_half_period(parameter):
    epsilon = MPMATH["jacobi_epsilon"]
    with mp.workdps(40):
        y = mp.mpf(parameter)
        half = mp.re(mp.ellipk(y))
        gain = 2 * epsilon(half, y)
        if y < 1:
            assert abs(gain - 2 * mp.ellipe(y)) < mp.mpf(10) ** -37
        for turns in (-(10**6), -3, 1, 2, 17, 10**9):
            rest = epsilon(half / 3 + 2 * turns * half, y) - epsilon(half / 3, y) - turns * gain
            assert abs(rest) < mp.mpf(10) ** -35 * abs(turns)


def test_am_inverts_the_integral_of_the_first_kind():
    phi, y = sp.Rational(29, 4), sp.Rational(4, 5)
    u_of_phi = sp.elliptic_f(phi, y)
    assert abs(jacobi_am(u_of_phi, y).evalf(40) - phi) < sp.Float("1e-38", 40)


# --- printing -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("function", "symbol"),
    [
        (jacobi_sn, r"\operatorname{sn}"),
        (jacobi_am, r"\operatorname{am}"),
        (jacobi_epsilon, r"\mathcal{E}"),
    ],
)
def test_printing(function, symbol):
    one, name = function(u, m), function.__name__
    assert str(one) == f"{name}(u, m)"
    assert sp.srepr(one) == f"{name}(Symbol('u'), Symbol('m'))"
    assert sp.latex(one) == rf"{symbol}\left(u \mid m\right)"
    assert sp.latex(one**2) == rf"{symbol}^{{2}}\left(u \mid m\right)"
    assert sp.latex(1 / one) == rf"\frac{{1}}{{{symbol}\left(u \mid m\right)}}"
    assert sp.latex(function(a * t, m)) == rf"{symbol}\left(a t \mid m\right)"
    assert pickle.loads(pickle.dumps(one)) == one


@every
def test_srepr_makes_a_round_trip(function):
    half = sp.Rational(1, 3) * sp.Symbol("k", positive=True)
    for one in (function(u, m), function(2 * u + sp.I * b, half) ** 2 / a):
        assert eval(sp.srepr(one), {**vars(sp), function.__name__: function}) == one


PRETTY = ["2", "sn (u | m)", "──────────", "⎛u    ⎞", "dn⎜─ | m⎟", "⎝2    ⎠"]


def test_pretty_printing():
    one = jacobi_sn(u, m) ** 2 / jacobi_dn(u / 2, m)
    text = sp.pretty(one, use_unicode=True)
    assert [line.strip() for line in text.splitlines()] == PRETTY
    assert sp.pretty(jacobi_epsilon(u, m), use_unicode=False) == "epsilon(u | m)"


REFUSED = {
    "C": sp.ccode,
    "C++": sp.cxxcode,
    "Fortran": sp.fcode,
    "JAX": JaxPrinter().doprint,
    "CuPy": CuPyPrinter().doprint,
}


@every
@pytest.mark.parametrize("language", REFUSED)
def test_other_languages_are_refused(function, language):
    with pytest.raises(NotImplementedError, match=f"{function.__name__}: .* has no such function"):
        REFUSED[language](function(u, m))


def test_mathematica_and_maple_have_these_functions():
    assert sp.mathematica_code(jacobi_sn(u, m) ** 2) == "JacobiSN[u, m]^2"
    assert sp.mathematica_code(jacobi_am(2 * u, m)) == "JacobiAmplitude[2*u, m]"
    assert sp.maple_code(jacobi_dn(u, m) + 1) == "JacobiDN(u, sqrt(m)) + 1"  # by the modulus
    with pytest.raises(NotImplementedError, match="no such function"):
        sp.maple_code(jacobi_epsilon(u, m))


def test_languages_take_the_callers_function():
    one, own = jacobi_sn(u, m) ** 2, {"jacobi_sn": "my_sn"}
    assert sp.ccode(one, user_functions=own) == "pow(my_sn(u, m), 2)"
    assert sp.fcode(one, user_functions=own, source_format="free") == "my_sn(u, m)**2"
    assert JaxPrinter({"user_functions": own}).doprint(one) == "my_sn(u, m)**2"
    assert "Not supported in C" in sp.ccode(one, strict=False)


def test_printed_python_runs():
    code = sp.pycode(jacobi_sn(u, m) + jacobi_am(u, m))
    assert code.startswith("rigidsym.language.functions.NUMPY['jacobi_")
    found = sp.lambdify([u, m], jacobi_sn(u, m) * jacobi_epsilon(u, m), "math")(0.3, 0.4)
    assert abs(found - float(jacobi_sn(0.3, 0.4) * jacobi_epsilon(0.3, 0.4))) < 1e-15


# --- lambdify -------------------------------------------------------------------------------


@every
@pytest.mark.parametrize("modules", ["numpy", "scipy", None, [NUMPY, "numpy"]])
def test_lambdify_over_arrays(function, modules):
    call = sp.lambdify((u, m), function(u, m), modules)
    grid, parameters = np.linspace(-30, 30, 121)[:, None], np.array([0.0, 0.2, 0.9, 1 - 1e-12, 1.0])
    values = call(grid, parameters)
    assert values.shape == (121, 5)
    for (i, j), value in np.ndenumerate(values):
        right = exact(function.__name__, grid[i, 0], parameters[j])
        assert abs(value - right) < 1e-14 * (1 + abs(right))
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
    arguments = np.array([0.1, 2.0, 9.0, 15.0])
    for name, call in NUMPY.items():
        for y in (1 - 1e-9, 1 - 1e-12, 1 - 1e-15, 1.0, -3.0):
            right = np.array([exact(name, x, y) for x in arguments], dtype=float)
            assert np.allclose(call(arguments, y), right, 5e-15, 5e-15)
        assert np.isnan(call(0.5, 1.5))
        assert np.isnan(call(np.nan, 0.5))


STRATA = {
    "circular": (0.0, 1e-300, 1e-17, 1e-9, 1e-4),
    "middle": (0.03, 0.3, 0.5, 0.8, 0.97),
    "hyperbolic": (1 - 1e-5, 1 - 1e-9, 1 - 1e-13, 1 - 1e-16, 1.0),
    "negative": (-1e-300, -1e-9, -0.01, -0.7, -1.0),
    "very negative": (-10.0, -1e2, -1e3, -1e5, -1e6),
}


@pytest.mark.parametrize("stratum", STRATA)
def test_numpy_epsilon_over_strata(stratum):
    steps = np.random.default_rng(20).uniform(-1, 1, 60)
    arguments = np.concatenate(
        [30 * steps[:40], 2 * steps[40:50], 10.0 ** (100 * steps[50:] - 100)]
    )
    parameters = np.array(STRATA[stratum])
    values = NUMPY["jacobi_epsilon"](arguments[:, None], parameters)
    for (i, j), value in np.ndenumerate(values):
        x, y = arguments[i], parameters[j]
        right = exact("jacobi_epsilon", x, y)
        growth = abs(x * mp.ellipe(y) / mp.ellipk(y)) if y < 0 else 0
        assert abs(value - right) <= 5e-15 * max(growth, abs(right))


@every
def test_numpy_takes_arrays_of_any_shape(function):
    call = NUMPY[function.__name__]
    row, column = np.linspace(-2, 2, 5), np.array([[0.0], [0.4], [1.0]])
    table = call(row, column)
    assert table.shape == (3, 5)
    for i, j in np.ndindex(3, 5):
        assert table[i, j] == pytest.approx(call(row[j], column[i, 0]), rel=1e-14, abs=1e-15)
    assert call(np.empty((0, 3)), 0.5).shape == (0, 3)
    assert isinstance(call(1, 0), float)
    assert np.array_equal(
        np.isnan(call([0.5, np.nan, 0.5, 0.5, 0.5], [0.5, 0.5, np.nan, 2, 1])), [0, 1, 1, 1, 0]
    )


@every
def test_lambdify_of_derivatives_in_m(function):
    stated = sp.diff(function(u, m), m)
    over_numpy, over_mpmath = (sp.lambdify([u, m], stated, name) for name in ("numpy", "mpmath"))
    arguments = np.array([-25.0, -1.2, 1e-3, 0.7, 4.4, 30.0])[:, None]
    parameters = np.array([-20.0, -0.5, 0.04, 0.5, 0.96])
    values = over_numpy(arguments, parameters)
    assert values.shape == (6, 5)
    for (i, j), value in np.ndenumerate(values):
        with mp.workdps(40):
            right = over_mpmath(mp.mpf(arguments[i, 0]), mp.mpf(parameters[j]))
        assert abs(value - right) < 2e-14 * (1 + abs(arguments[i, 0])) * max(1, abs(right))
