"""Legendre's Pi over Jacobi's argument and the parts of thetas, against mpmath's own functions."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from mpmath import mp

from rigidsym.language.functions import jacobi_pi, jacobi_sn, theta_im, theta_re

u, n, m, x, y, q = sp.symbols("u n m x y q", real=True)
THETAS = [(k, r) for k in (1, 2, 3, 4) for r in (0, 1, 2)]


@pytest.mark.parametrize("argument", ["-31/10", "2/5", "13"])
@pytest.mark.parametrize(("characteristic", "parameter"), [("-3", "1/4"), ("9/10", "99/100")])
def test_pi_is_legendres_at_the_amplitude(argument, characteristic, parameter):
    values = [sp.Rational(text) for text in (characteristic, argument, parameter)]
    own = jacobi_pi(*values)
    assert abs(own.evalf(40) - own.rewrite(sp.elliptic_pi).evalf(40)) < 1e-38 * abs(own.evalf())
    slope = mp.diff(lambda v: jacobi_pi(values[0], sp.Float(v, 30), values[2])._to_mpmath(80), 0.3)
    exact = jacobi_pi(n, u, m).diff(u).subs({n: values[0], u: sp.Rational(3, 10), m: values[2]})
    assert abs(slope - exact.evalf(20)) < 1e-5


def test_pi_at_the_edges():
    assert jacobi_pi(n, 0, m) == 0
    assert jacobi_pi(0, u, m) == u
    assert jacobi_pi(n, -u, m) == -jacobi_pi(n, u, m)
    assert jacobi_pi(n, u, m).diff(u) == 1 / (1 - n * jacobi_sn(u, m) ** 2)
    hyperbolic = jacobi_pi(-2, u, 1)
    assert not hyperbolic.has(jacobi_pi)
    assert sp.simplify(hyperbolic.diff(u) - 1 / (1 + 2 * sp.tanh(u) ** 2)) == 0
    with pytest.raises(sp.core.function.ArgumentIndexError):
        jacobi_pi(n, u, m).fdiff(3)


def test_pi_across_the_real_line_grows_as_its_integrand_says():
    parameter, characteristic = mp.mpf("0.3"), mp.mpf("0.2")
    quarter = mp.ellipk(parameter)
    call = sp.lambdify(u, jacobi_pi(characteristic, u, parameter), "mpmath")
    grown = call(mp.mpc(quarter, 1.1)) - call(mp.mpc(quarter, 0.2))
    path = [mp.mpc(quarter, 0.2), mp.mpc(quarter, 1.1)]
    integral = mp.quad(
        lambda v: 1 / (1 - characteristic * mp.ellipfun("sn", v, m=parameter) ** 2), path
    )
    assert abs(grown - integral) < 1e-14
    with pytest.raises(ValueError, match="real line"):
        call(mp.mpc(0.1, 0.2))


@pytest.mark.parametrize("characteristic", [-40.0, -0.5, 0.3, 0.95])
def test_pi_over_arrays(characteristic):
    call = sp.lambdify((n, u, m), jacobi_pi(n, u, m), "numpy")
    grid, parameters = np.linspace(-20, 20, 41)[:, None], np.array([0.0, 0.3, 0.99])
    found = call(characteristic, grid, parameters)
    for i, j in ((0, 0), (7, 1), (20, 2), (33, 1), (40, 2)):
        exact = jacobi_pi(characteristic, sp.Float(grid[i, 0], 30), parameters[j])
        assert abs(found[i, j] - float(exact)) < 2e-14 * (1 + abs(float(exact)))


@pytest.mark.parametrize(("k", "r"), THETAS)
def test_parts_of_thetas(k, r):
    at = {x: sp.Rational(7, 5), y: sp.Rational(-2, 5), q: sp.Rational(3, 10)}
    exact = mpmath.jtheta(k, mpmath.mpc(1.4, -0.4), 0.3, r)
    real, imaginary = theta_re(k, x, y, q, r), theta_im(k, x, y, q, r)
    assert abs(complex(real.subs(at), imaginary.subs(at)) - complex(exact)) < 1e-12
    for module in ("numpy", "mpmath"):
        call = sp.lambdify((x, y, q), [real, imaginary], module)
        assert abs(complex(*map(float, call(1.4, -0.4, 0.3))) - complex(exact)) < 1e-12


@pytest.mark.parametrize("part", [theta_re, theta_im])
@pytest.mark.parametrize("variable", [x, y, q])
def test_derivatives_of_thetas(part, variable):
    at = {x: 1.4, y: -0.4, q: 0.3}
    for k in (1, 2, 3, 4):
        function = part(k, x, y, q, 0)
        call = sp.lambdify(variable, function.subs({v: c for v, c in at.items() if v != variable}))
        with mp.workdps(15):
            step = 1e-5
            slope = (call(at[variable] + step) - call(at[variable] - step)) / (2 * step)
        assert abs(float(function.diff(variable).subs(at)) - slope) < 1e-7


def test_parts_that_vanish():
    assert theta_im(3, x, 0, q, 0) == 0
    assert theta_im(4, 0, y, q, 0) == 0
    assert theta_re(4, 0, y, q, 1) == 0
    assert theta_re(1, 0, y, q, 0) == 0
    assert theta_re(3, x, 0, q, 0).is_real
    with pytest.raises(ValueError, match="k = 1, 2, 3 or 4"):
        theta_re(5, x, y, q, 0)


def test_mathematica_is_refused():
    with pytest.raises(NotImplementedError, match=r"jacobi_pi: .* has no such function"):
        sp.mathematica_code(jacobi_pi(*sp.symbols("n u m")))


def test_latex():
    assert sp.latex(jacobi_pi(n, u, m)) == (
        r"\Pi\left(n; \operatorname{am}\left(u \mid m\right) \mid m\right)"
    )
    assert sp.pretty(jacobi_pi(n, u, m), use_unicode=True) == "Π(n; am(u | m)│m)"
    with pytest.raises(NotImplementedError, match="jacobi_pi: C has no such function"):
        sp.ccode(jacobi_pi(n, u, m))
    assert sp.latex(theta_re(4, x, y, q, 0)).startswith(r"\operatorname{Re} \theta_{4}\left(")
