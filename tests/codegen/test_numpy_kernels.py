"""The elliptic kernels against mpmath at high precision, near and at both ends of the parameter."""

import numpy as np
import pytest
from mpmath.ctx_mp import MPContext

from rigidsym.codegen import numpy_kernels as kernels

ULP = 2.0**-53
COMPLEMENTS = [1.0, 1 - 1e-15, 0.999, 0.5, 1e-3, 1e-8, 1e-16, 1e-30, 1e-100, 1e-280]
CHARACTERISTICS = [0.0, -1e-18, -1e-6, -0.3, -0.999999]


def context(mc):
    ctx = MPContext()
    ctx.dps = 60 + int(-np.log10(mc)) * 2
    return ctx


def arguments(mc):
    quarter = float(kernels._quarter_period(mc))
    near = [1e-200, 1e-5, 0.1, 0.5, 0.9, 1 - 1e-6, 1.1, 1.9, 2.5, 5.7]
    return quarter, np.array([sign * x * quarter for x in near for sign in (1, -1)])


@pytest.mark.parametrize("mc", COMPLEMENTS)
def test_quarter_period(mc):
    ctx = context(mc)
    exact = ctx.pi / (2 * ctx.agm(1, ctx.sqrt(ctx.mpf(mc))))
    assert abs(float(kernels._quarter_period(mc)) / exact - 1) < 4 * ULP


@pytest.mark.parametrize("mc", COMPLEMENTS)
def test_jacobi_to_rounding_of_the_argument(mc):
    ctx = context(mc)
    quarter, u = arguments(mc)
    found = np.array(kernels._jacobi(u, mc, quarter))
    for k, x in enumerate(u):
        m = 1 - ctx.mpf(mc)
        exact = [ctx.ellipfun(kind, ctx.mpf(float(x)), m=m) for kind in ("sn", "cn", "dn")]
        error = max(
            abs(float(f - e)) for f, e in zip(found[:, k], map(ctx.mpf, exact), strict=True)
        )
        assert error < 16 * ULP * (1 + abs(x)), x


@pytest.mark.parametrize("mc", [x for x in COMPLEMENTS if x > 1e-101])
@pytest.mark.parametrize("n", CHARACTERISTICS)
def test_elliptic_j_is_the_integral(mc, n):
    ctx = context(mc)
    quarter, u = arguments(mc)
    complete = kernels._complete_j(n, mc)
    values = kernels._elliptic_j(u, n, quarter, *kernels._jacobi(u, mc, quarter), complete)
    whole = _carlson(ctx, ctx.zero, ctx.mpf(mc), 1, n)
    period = 2 * ctx.pi / (2 * ctx.agm(1, ctx.sqrt(ctx.mpf(mc))))
    for x, value in zip(u, values, strict=True):
        turns = int(ctx.nint(ctx.mpf(float(x)) / period))
        v = ctx.mpf(float(x)) - turns * period
        m = 1 - ctx.mpf(mc)
        sn, cn, dn = (ctx.ellipfun(kind, v, m=m) for kind in ("sn", "cn", "dn"))
        exact = 2 * turns * whole + _carlson(ctx, cn**2, dn**2, sn, n)
        assert abs(float(value - exact)) < 40 * ULP * (1 + abs(x)), x


def _carlson(ctx, x, y, sn, n):
    """DLMF 19.25.14, with mpmath's R_J."""
    return sn**3 / 3 * ctx.elliprj(x, y, 1, 1 - n * sn**2)


def test_elliptic_j_by_quadrature():
    ctx = context(0.3)
    quarter = float(kernels._quarter_period(0.3))
    triple = kernels._jacobi(1.2, 0.3, quarter)
    value = kernels._elliptic_j(1.2, -0.4, quarter, *triple, kernels._complete_j(-0.4, 0.3))

    def integrand(u):
        square = ctx.ellipfun("sn", u, m=1 - ctx.mpf(0.3)) ** 2
        return square / (1 + ctx.mpf(0.4) * square)

    assert abs(float(value - ctx.quad(integrand, [0, ctx.mpf(1.2)]))) < 4 * ULP


def test_the_hyperbolic_end():
    u = np.array([-800.0, -30.0, -1e-3, 0.0, 1e-300, 0.7, 20.0, 400.0])
    sn, cn, dn = kernels._jacobi(u, 0.0, np.inf)
    np.testing.assert_allclose(sn, np.tanh(u), rtol=4e-16)
    np.testing.assert_allclose(cn, dn)
    np.testing.assert_allclose(cn[1:-1], 1 / np.cosh(u[1:-1]), rtol=2e-14)
    j = kernels._elliptic_j(u, -0.5, np.inf, sn, cn, dn, np.inf)
    root = np.sqrt(0.5)
    exact = (u - np.arctan(root * np.tanh(u)) / root) / 1.5
    np.testing.assert_allclose(j, exact, rtol=1e-15, atol=1e-16)


@pytest.mark.parametrize("mc", [*COMPLEMENTS, 0.0])
def test_the_argument_comes_back(mc):
    quarter = float(kernels._quarter_period(mc))
    u = np.array([0.0, 1e-200, 1e-4, 0.3, 0.77, 1.0]) * min(quarter, 40.0)
    back = kernels._jacobi_argument(*kernels._jacobi(u, mc, quarter))
    np.testing.assert_allclose(back, u, rtol=0, atol=16 * ULP * (1 + np.max(u)))


@pytest.mark.parametrize("shape", [(), (0,), (3, 1)])
def test_kernels_broadcast(shape):
    u = np.full(shape, 0.4)
    mc = np.array([0.2, 0.0])
    quarter = kernels._quarter_period(mc)
    if shape in ((), (3, 1)):
        sn, _, _ = kernels._jacobi(u, mc, quarter)
        assert sn.shape == np.broadcast_shapes(shape, (2,))
    else:
        assert kernels._jacobi(u, 0.2, quarter[0])[0].shape == (0,)
