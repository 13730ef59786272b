"""Carlson's R_J and the complete integrals of generated code against mpmath's own."""

import mpmath
import pytest
from mpmath import mpf
from values import value_of

from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.special_functions import carlson, landen
from rigidsym.solution import sealed

FUNCTIONS = {function.name: function for function in functions(sealed(), "pi")}
NUMBERS = {c.name: mpf(c.hi) + mpf(c.lo or 0) for c in constants()}


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(50):
        yield


def run(name, *arguments):
    """A function's results over mpmath numbers: what it leaves out, and no rounding."""
    function = FUNCTIONS[name]
    found = NUMBERS | {"pi": mpmath.pi()} | dict(zip(function.parameters, arguments, strict=True))
    for let in function.lets:
        found[let.targets[0]] = value_of(let.expression, found, {"sqrt": mpmath.sqrt})
    return [found[result] for result in function.results]


def jacobi(u, m):
    return [mpmath.ellipfun(name, u, m=m) for name in ("sn", "cn", "dn")]


def third_kind(s, c, d, n, k):
    """What the code finds, and what it should."""
    path = 1 - n * s**2
    spread = -n * (1 - n) * (k**2 - n)
    (found,) = run("_third_kind", s, c, d, path, spread)
    return found, s**3 / 3 * mpmath.elliprj(c**2, d**2, 1, path)


@pytest.mark.parametrize("k", ["0.02", "0.3", "0.6", "0.70710678"])
@pytest.mark.parametrize("share", ["0", "0.4", "1"])
def test_third_kind_up_to_a_quarter_period(k, share):
    """n between 0 and -k, kappa at most 2 k (1 + k): what J is off by counts in psi by half."""
    k = mpf(k)
    n = -k * mpf(share)
    for part in range(1, 9):
        s, c, d = jacobi(mpmath.ellipk(k**2) * part / 8, k**2)
        found, true = third_kind(s, c, d, n, k)
        assert abs(found - true) * k * (1 + k) <= carlson.MEASURED


@pytest.mark.parametrize("complement", ["0.707", "0.4", "0.1", "1e-2", "1e-5", "1e-12", "1e-60"])
@pytest.mark.parametrize("x", ["0.01", "0.5", "1"])
def test_third_kind_near_the_separatrix(complement, x):
    """Up to half a quarter period, times the larger of what it is multiplied by there."""
    with mpmath.workdps(200):
        kc, x = mpf(complement), mpf(x)
        k = mpmath.sqrt(1 - kc**2)
        y, z = mpmath.sqrt(1 + x**2), mpmath.sqrt(1 + (k * x) ** 2)
        delta = (kc / z) ** 2
        share = k**2 * x * y * kc**2 / z**3
        for part in range(1, 9):
            s, c, d = jacobi(mpmath.ellipk(k**2) * part / 16, k**2)
            found, true = third_kind(s, c, d, 1 - delta, k)
            assert abs(found - true) * 2 * share <= carlson.MEASURED


@pytest.mark.parametrize("complement", ["1", "0.9", "0.70710678", "1e-3", "1e-20", "1e-68"])
@pytest.mark.parametrize("n", ["-1e-9", "-0.1", "-0.9"])
def test_complete_integrals(complement, n):
    with mpmath.workdps(200):
        kc, n = mpf(complement), mpf(n)
        m = 1 - kc**2
        quarter, total = run("_complete", kc, 1 - n)
        assert abs(quarter / mpmath.ellipk(m) - 1) <= landen.MEANS_MEASURED
        slope = total / (2 * (1 - n))
        true = (mpmath.ellippi(n, m) / mpmath.ellipk(m) - 1) / n
        assert abs(slope / true - 1) * quarter <= landen.MEANS_MEASURED
