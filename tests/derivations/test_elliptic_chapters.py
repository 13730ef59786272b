"""Chapters on elliptic functions by numbers: Landen's step, Fourier series, and Pi's windings."""

from random import Random

import pytest
from ledgers import LEDGER
from mpmath import mp, workdps
from values import value_of

from derivations.fourier_form import COEFFICIENT, PHASE, TERMS
from derivations.regular_form import CIRCULATION
from rigidsym.language._expression import parse
from rigidsym.proof.algebra import LedgerBuilder, Part, join, sign
from rigidsym.proof.kernel import KernelError
from rigidsym.solution._formulas import sequence

# Landen's step by its published sequence, from step to step.

STEPS = 8
NUMBERS = {"sqrt": mp.sqrt, "power": lambda x, n: x**n}
MODULI = ["1e-9", "0.2", "0.7", "0.95", "0.999999"]


def descend(k, u, beta, w):
    """Return the results of eight steps from Jacobi's functions of u and i*beta."""
    here = {f"{x}": mp.ellipfun(f"{x}n", u, m=k**2) for x in "scd"}
    here |= {"k": k, "kc": mp.sqrt(1 - k**2), "r": k / w**2, "K_next": mp.mpf(1)}
    here["Y"] = w * mp.ellipfun("sc", beta, m=1 - k**2)
    found = []
    for _ in range(STEPS):
        found.append(sequence("landen").evaluate(here, NUMBERS))
        here |= {x: found[-1][f"{x}_next"] for x in ("k", "kc", "s", "c", "d", "r", "Y")}
    return found


def draw(modulus, seed):
    """Draw a modulus, an argument below K and a shift below K'/2, with the scale root_Q."""
    random, k = Random(f"{modulus}/{seed}"), mp.mpf(modulus)
    u = mp.ellipk(k**2) * random.uniform(-0.99, 0.99)
    beta = mp.ellipk(1 - k**2) / 2 * random.uniform(0, 0.99)
    return k, u, beta, mp.qfrom(k=k) ** 0.25


def drawn(test):
    """Run a test for each modulus and three draws."""
    by_modulus = pytest.mark.parametrize("modulus", MODULI)
    return by_modulus(pytest.mark.parametrize("seed", range(3))(test))


@drawn
def test_one_step_is_that_of_jacobi_functions(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        first = descend(k, u, beta, w)[0]
        k_next = first["k_next"]
        scale, m = 1 + k_next, k_next**2
        for x in "scd":
            right = mp.ellipfun(f"{x}n", u / scale, m=m)
            assert abs(first[f"{x}_next"] - right) < 1e-40
        assert abs(first["Y_next"] / w - mp.ellipfun("sc", beta / scale, m=1 - m)) < 1e-38
        assert abs(first["r_next"] * w**2 - k_next) < 1e-40
        assert abs(first["kc_next"] - mp.sqrt(1 - m)) < 1e-40


@drawn
def test_eight_steps_invert_jacobi_functions(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        found = descend(k, u, beta, w)
        last, quarter = found[-1], mp.pi / 2 * mp.fprod(step["K"] for step in found)
        assert last["k_next"] < 1e-30
        assert abs(quarter / mp.ellipk(k**2) - 1) < 1e-30
        scale = mp.pi / (2 * quarter)
        angle = mp.atan2(last["s_next"], last["c_next"])
        assert abs(angle - scale * u) < 1e-30
        assert abs(mp.asinh(last["Y_next"] / w) - scale * beta) < 1e-30


@drawn
def test_the_scale_gives_the_exponentials_at_the_bottom(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        last = descend(k, u, beta, w)[-1]
        x = mp.ellipfun("sc", beta, m=1 - k**2)
        part = k * x * x  # (K - B_a)/(K + B_a)
        momentum = {"K": 1 + part, "B_a": 1 - part, "B_d": 2 * mp.sqrt(part)}
        given = {**momentum, "k_1": k, "r": k / w**2, "Y_b": last["Y_next"]}
        scaled = sequence("scaling").evaluate(given, NUMBERS)
        b = mp.pi * beta / (2 * mp.ellipk(k**2))
        assert abs(scaled["Y"] - w * x) < 1e-38
        assert abs(scaled["Q"] - w**2) < 1e-38
        assert abs(scaled["h_plus"] - w * mp.exp(b)) < 1e-30
        assert abs(scaled["h_minus"] - w * mp.exp(-b)) < 1e-30
        shift = sequence("shift").evaluate({**momentum, "k_1": k}, NUMBERS)
        for name in "scd":
            right = mp.ellipfun(f"{name}n", beta, m=1 - k**2)
            assert abs(shift[f"{name}_beta"] - right) < 1e-38


def test_the_ends_of_the_modulus_are_no_exceptions():
    half = {"r": 4, "Y": mp.mpf(1) / 3, "K_next": mp.mpf(1)}
    begin = {**half, "s": 0.6, "c": 0.8}
    circular = sequence("landen").evaluate({**begin, "k": 0, "kc": 1, "d": 1}, NUMBERS)
    assert (circular["k_next"], circular["r_next"], circular["kc_next"]) == (0, 0, 1)
    assert [circular[f"{x}_next"] for x in "scd"] == pytest.approx([0.6, 0.8, 1])
    assert circular["Y_next"] == pytest.approx(1 / 3)
    hyperbolic = sequence("landen").evaluate({**begin, "k": 1, "kc": 0, "d": 0.8}, NUMBERS)
    assert (hyperbolic["k_next"], hyperbolic["kc_next"], hyperbolic["r_next"]) == (1, 0, 4)
    assert hyperbolic["s_next"] == pytest.approx(mp.tanh(mp.atanh(0.6) / 2))


# Fourier series: the coefficients against Jacobi's functions, and what is wrong with others.

NOME, PLACE = mp.mpf("0.3"), mp.mpf("0.7")
# How far sums go: what is left out is below the nome to this power.
MANY = 80


def coefficient(e, k):
    """Return a(k) by the ledger's formula."""
    return sequence("fourier").evaluate({"e": e, "x": NOME**k}, {"power": pow})["a"]


def quotient(index):
    """Return theta_index/theta_4 at PLACE."""
    return mp.jtheta(index, PLACE, NOME) / mp.jtheta(4, PLACE, NOME)


def whole(first):
    """List first, first + 1, ..."""
    return [first + mp.mpf(n) for n in range(MANY)]


def sums(at):
    """Return the series of sn, cn and dn, each up to a factor."""
    odd = whole(mp.mpf(1) / 2)
    return {
        1: sum(coefficient(1, k) * mp.sin(2 * k * at) for k in odd),
        2: sum(coefficient(-1, k) * mp.cos(2 * k * at) for k in odd),
        3: coefficient(-1, 0) / 2 + sum(coefficient(-1, k) * mp.cos(2 * k * at) for k in whole(1)),
    }


@pytest.fixture
def forty_digits():
    """Compute with forty digits, so that thirty can be compared."""
    with workdps(40):
        yield


forty = pytest.mark.usefixtures("forty_digits")


@forty
@pytest.mark.parametrize("index", [1, 2, 3])
def test_series_are_multiples_of_quotients_of_thetas(index):
    other = mp.mpf("-1.1")
    ratio = mp.jtheta(index, other, NOME) / mp.jtheta(4, other, NOME) / quotient(index)
    assert abs(sums(other)[index] / sums(PLACE)[index] - ratio) < 1e-35


@forty
def test_the_logarithmic_derivative_of_theta_4():
    slope = 4 * sum(coefficient(1, k) * mp.sin(2 * k * PLACE) for k in whole(1))
    found = mp.jtheta(4, PLACE, NOME, 1) / mp.jtheta(4, PLACE, NOME)
    assert abs(slope - found) < 1e-35


@forty
@pytest.mark.parametrize("rho", [1, -1])
def test_the_angle_of_theta_4_off_the_real_line(rho):
    """Sum the terms of the rest from 0, where the angle is 0."""
    b, angle = mp.mpf("0.1"), mp.mpf(0)
    for k in whole(1):
        given = {"x": NOME**k, "k": k, "rho": rho, "sinh_b": mp.sinh(2 * k * b)}
        term = sequence("fourier_rest").evaluate(given, {"power": pow})["rest_k"]
        angle += term * mp.sin(2 * k * PLACE)
    exact = mp.arg(mp.jtheta(4, mp.mpc(PLACE, -rho * b), NOME))
    assert abs(angle - exact) < 1e-30


@pytest.mark.parametrize("wrong", ["x/(1 + e*x**2)", "2*x/(1 - x**2)", "x**2/(1 - e*x**2)", "x"])
def test_other_coefficients_are_none(wrong):
    """Refute other coefficients by the step, whose remainder is not homogeneous in a."""
    part = Part(COEFFICIENT.names, (*COEFFICIENT.units, "1 + e*x**2", "1 - x**2"), {"a": wrong})
    builder = LedgerBuilder()
    builder.open(join("terms", sign("e", "a sign"), part, TERMS, static=True))
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("terms.step", {"next_term": "e*term + P/x"})


def test_a_term_of_another_size_has_another_rate():
    builder = LedgerBuilder()
    wrong = {**PHASE.definitions, "rest_k": "-rho*a*sinh_b/k"}
    part = Part(PHASE.names, PHASE.units, wrong, PHASE.relations, PHASE.rates, PHASE.nonnegative)
    builder.open(join("phase", CIRCULATION, COEFFICIENT, part))
    with pytest.raises(KernelError, match="undecided"):
        builder.claim("phase.term", {"D(rest_k*sine)": "rate*(4*a*shifted_im)"})


# The rule for Pi beyond half a turn, against quadrature of its integrand.

# One half turn more, and that k of them and one are k + 1.
((ONCE, ONE_MORE),) = {
    tuple(fact["rhs"])
    for fact in LEDGER["facts"]
    if fact["lhs"] == ["Pi_later", "Pi_later + 2*k*Pi_c"]
}
PARAMETERS = [
    ("0.5", "0.5", "0.7"),
    ("-3", "0.9", "-1.2"),
    ("0.8", "-2", "1.5"),
    ("-40", "0.3", "0"),
]


def by_quadrature(n, theta, m):
    def integrand(angle):
        square = mp.sin(angle) ** 2
        return 1 / ((1 - n * square) * mp.sqrt(1 - m * square))

    pieces = int(abs(theta) / mp.pi * 4) + 1
    return mp.quad(integrand, mp.linspace(0, theta, pieces + 1))


@pytest.mark.parametrize("k", range(-5, 6))
@pytest.mark.parametrize(("n", "m", "theta"), PARAMETERS)
def test_pi_winds_as_stated(n, m, theta, k):
    with workdps(22):
        n, m, theta = map(mp.mpf, (n, m, theta))
        values = {"k": k - 1, "Pi_c": mp.ellippi(n, m), "Pi": mp.ellippi(n, theta, m)}
        wound = value_of(parse(ONE_MORE), values, {})
        assert k != 1 or wound == value_of(parse(ONCE), values, {})
        assert abs(wound - by_quadrature(n, theta + k * mp.pi, m)) < 1e-18 * (1 + abs(wound))
