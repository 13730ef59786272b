"""Fourier series: the coefficients against Jacobi's functions, and what is wrong with others."""

import mpmath
import pytest

from derivations.fourier_form import COEFFICIENT, PHASE, TERMS
from derivations.regular_form import CIRCULATION
from rigidsym.proof.algebra import LedgerBuilder, Part, join, sign
from rigidsym.proof.kernel import KernelError
from rigidsym.solution._formulas import sequence

NOME, PLACE = mpmath.mpf("0.3"), mpmath.mpf("0.7")
# How far sums go: what is left out is below the nome to this power.
MANY = 80


def coefficient(e, k):
    """a(k), by the ledger's formula."""
    return sequence("fourier").evaluate({"e": e, "x": NOME**k}, {"power": pow})["a"]


def quotient(index):
    """theta_index/theta_4 at PLACE."""
    return mpmath.jtheta(index, PLACE, NOME) / mpmath.jtheta(4, PLACE, NOME)


def whole(first):
    """first, first + 1, ..."""
    return [first + mpmath.mpf(n) for n in range(MANY)]


def sums(at):
    """The series of sn, cn and dn, each up to a factor."""
    odd = whole(mpmath.mpf(1) / 2)
    return {
        1: sum(coefficient(1, k) * mpmath.sin(2 * k * at) for k in odd),
        2: sum(coefficient(-1, k) * mpmath.cos(2 * k * at) for k in odd),
        3: coefficient(-1, 0) / 2
        + sum(coefficient(-1, k) * mpmath.cos(2 * k * at) for k in whole(1)),
    }


@pytest.fixture(autouse=True)
def forty_digits():
    """Forty digits, so that thirty can be compared."""
    with mpmath.workdps(40):
        yield


@pytest.mark.parametrize("index", [1, 2, 3])
def test_series_are_multiples_of_quotients_of_thetas(index):
    other = mpmath.mpf("-1.1")
    ratio = mpmath.jtheta(index, other, NOME) / mpmath.jtheta(4, other, NOME) / quotient(index)
    assert abs(sums(other)[index] / sums(PLACE)[index] - ratio) < 1e-35


def test_the_logarithmic_derivative_of_theta_4():
    slope = 4 * sum(coefficient(1, k) * mpmath.sin(2 * k * PLACE) for k in whole(1))
    found = mpmath.jtheta(4, PLACE, NOME, 1) / mpmath.jtheta(4, PLACE, NOME)
    assert abs(slope - found) < 1e-35


@pytest.mark.parametrize("rho", [1, -1])
def test_the_angle_of_theta_4_off_the_real_line(rho):
    """Its imaginary part integrated from 0, where the angle is 0."""
    b, angle = mpmath.mpf("0.1"), mpmath.mpf(0)
    for k in whole(1):
        given = {"x": NOME**k, "k": k, "rho": rho, "sinh_b": mpmath.sinh(2 * k * b)}
        term = sequence("fourier_rest").evaluate(given, {"power": pow})["rest_k"]
        angle += term * mpmath.sin(2 * k * PLACE)
    exact = mpmath.arg(mpmath.jtheta(4, mpmath.mpc(PLACE, -rho * b), NOME))
    assert abs(angle - exact) < 1e-30


@pytest.mark.parametrize("wrong", ["x/(1 + e*x**2)", "2*x/(1 - x**2)", "x**2/(1 - e*x**2)", "x"])
def test_other_coefficients_are_none(wrong):
    """The step, which is homogeneous in a but for what is left over, tells these apart."""
    part = Part(COEFFICIENT.witness, (*COEFFICIENT.units, "1 + e*x**2", "1 - x**2"), {"a": wrong})
    builder = LedgerBuilder()
    builder.open(join("terms", sign("e", "a sign"), part, TERMS, static=True))
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("terms.step", {"next_term": "e*term + P/x"})


def test_a_term_of_another_size_has_another_rate():
    builder = LedgerBuilder()
    wrong = {**PHASE.definitions, "rest_k": "-rho*a*sinh_b/k"}
    part = Part(PHASE.witness, PHASE.units, wrong, PHASE.relations, PHASE.rates, PHASE.nonnegative)
    builder.open(join("phase", CIRCULATION, COEFFICIENT, part))
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("phase.term", {"D(rest_k*sine)": "rate*(4*a*shifted_im)"})
