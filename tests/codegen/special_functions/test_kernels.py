"""Special functions of the generated code against mpmath, over mpmath's own numbers."""

import random
from itertools import pairwise

import mpmath
import pytest
from mpmath import mpf
from values import value_of

from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.special_functions import (
    angles,
    landen,
    nome,
    reduction,
    theta_circular,
    theta_hyperbolic,
)
from rigidsym.solution import sealed

FUNCTIONS = {function.name: function for function in functions(sealed())}
PRIMITIVES = {
    "sqrt": mpmath.sqrt,
    "size": abs,
    "choose": lambda x, y, one, other: one if x <= y else other,
    "rounded": lambda x: x,
    "exponent": lambda x: mpmath.frexp(x)[1],
    "mantissa": lambda x: mpmath.frexp(x)[0],
    "product_error": lambda a, b, p: a * b - p,
    "nearest": mpmath.nint,
    "alternating": lambda n: (-1) ** int(n),
    "exp": mpmath.exp,
}


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(40):
        yield


def known():
    return {c.name: mpf(c.hi) + mpf(c.lo or 0) for c in constants()} | {"pi": mpmath.pi()}


def run(lets, values):
    """All lets over mpmath numbers."""
    found = known() | values
    table = PRIMITIVES | {name: lambda *x, n=name: call(n, *x) for name in FUNCTIONS}
    for let in lets:
        value = value_of(let.expression, found, table)
        found |= dict(zip(let.targets, value if len(let.targets) > 1 else (value,), strict=True))
    return found


def call(name, *arguments):
    function = FUNCTIONS[name]
    found = run(function.lets, dict(zip(function.parameters, arguments, strict=True)))
    results = tuple(found[result] for result in function.results)
    return results if len(results) > 1 else results[0]


MODULI = [mpf(0), mpf("1e-12"), mpf("0.1"), mpf("0.5"), mpmath.sqrt(0.5)]


@pytest.mark.parametrize("k", MODULI)
def test_the_ladder_gives_the_quarter_period_and_inverts_sn(k):
    kc, u, b = mpmath.sqrt(1 - k * k), mpf("0.7"), mpf("0.3")
    sn, cn, dn = (mpmath.ellipfun(f, u, m=k * k) for f in ("sn", "cn", "dn"))
    x = mpmath.im(mpmath.ellipfun("sn", 1j * b, m=k * k))
    quarter, s, c, sinh = call("_ladder", k, kc, sn, cn, dn, k, x)
    assert abs(quarter - mpmath.ellipk(k * k)) < 1e-32
    scale = mpmath.pi / (2 * quarter)
    assert abs(s - mpmath.sin(scale * u)) < 1e-32
    assert abs(c - mpmath.cos(scale * u)) < 1e-32
    assert abs(sinh - mpmath.sinh(scale * b)) < 1e-32
    assert landen.modulus_left() < 2.0**-106


@pytest.mark.parametrize("k", MODULI[1:])
def test_the_nome_is_regular_at_zero_and_right_to_31_digits(k):
    with mpmath.workdps(70):
        q = mpmath.exp(-mpmath.pi * mpmath.ellipk(1 - k * k) / mpmath.ellipk(k * k))
    assert abs(call("_root_ratio", k, mpmath.sqrt(1 - k * k)) * mpmath.sqrt(q) / k - 1) < 1e-30
    assert call("_root_ratio", mpf(0), mpf(1)) == 4


def test_the_coefficients_of_the_nome_are_the_known_ones():
    assert nome.coefficients(8) == [1, 2, 15, 150, 1707, 20910, 268616, 3567400]  # OEIS A002103


def test_what_the_series_of_the_nome_leaves_out_is_within_its_bound():
    worst = 3 / mpf(100)  # k_next^2 where k^2 = 1/2 is (3 - 2 sqrt(2))^2, k' and its root more
    assert (3 - 2 * mpmath.sqrt(2)) ** 2 < worst
    assert worst / (2 * (2 - worst) ** 3) < mpf(1) / nome.LARGEST.denominator
    e = mpf(1) / nome.LARGEST.denominator
    rest = nome.coefficients(12)[nome.TERMS :]
    left_out = sum(a * e ** (4 * n) for n, a in enumerate(rest, nome.TERMS))
    assert left_out < float(nome.series_tail()) < 200 * left_out
    assert nome.series_tail() < 2.0**-106
    growth = [b / a for a, b in pairwise(nome.coefficients(12))]
    assert max(growth) < 21  # by Cauchy's estimate; it tends to 16


@pytest.mark.parametrize("angle", ["0", "1e-30", "0.1", "-0.4999", "0.5", "-0.5", "0.25"])
def test_half_turns(angle):
    theta = mpmath.pi * mpf(angle)
    assert abs(call("_half_turns", mpmath.sin(theta), abs(mpmath.cos(theta))) - mpf(angle)) < 1e-32


@pytest.mark.parametrize("x", ["1", "1e-290", "0.7072", "1.4142", "3", "1e150"])
def test_logarithm(x):
    difference = call("_logarithm", mpf(x)) - mpmath.log(mpf(x))
    assert abs(difference) < 1e-26 * max(1, abs(mpmath.log(mpf(x))))  # frexp halves at 1/2 here
    assert angles.series_tail() < 2.0**-106


@pytest.mark.parametrize("count", [6, 7, 8])
def test_sine_and_cosine_stay_within_their_bounds(count):
    sines, cosines = reduction.sine_coefficients(count), reduction.cosine_coefficients(count)
    worst = {"sine": mpf(0), "cosine": mpf(0)}
    for k in range(2001):
        f = mpf(k) / 4000
        z = f * f
        s = f * (mpmath.pi + z * mpmath.polyval(list(map(mpf, sines[::-1])), z))
        c = 1 + z * mpmath.polyval(list(map(mpf, cosines[::-1])), z)
        worst["sine"] = max(worst["sine"], abs(s - mpmath.sin(mpmath.pi * f)))
        worst["cosine"] = max(worst["cosine"], abs(c - mpmath.cos(mpmath.pi * f)))
    for found, proved in zip(
        worst.values(), (reduction.sine_bound(sines), reduction.cosine_bound(cosines)), strict=True
    ):
        assert found <= proved <= 2 * float(found)
    assert reduction.TERMS == 8
    assert reduction.sine_bound(reduction.sine_coefficients(8)) < 2.0**-54


def theta(n, z, q):
    return mpmath.jtheta(n, z, q)


@pytest.mark.parametrize("rho", [1, -1])
@pytest.mark.parametrize(
    ("root", "b"), [("0", "0"), ("0.02", "1.2"), ("0.2", "0.75"), ("0.207", "0.1")]
)
def test_circular_thetas(rho, root, b):
    """Q is the nome of m, and 2 b < log(1/Q) since beta < K'/2."""
    q, b, g = mpf(root), mpf(b), mpf(1)
    h = [mpmath.sqrt(q) * mpmath.exp(sign * b) for sign in (1, -1)] if q else [mpf("0.3"), mpf(0)]
    lets = theta_circular.powers() + theta_circular.zeta() + theta_circular.coefficients()
    begin = run(
        [*lets, *theta_circular.constants()],
        {"Q": q, "h_plus": h[0], "h_minus": h[1], "rho": rho, "g": g},
    )
    generator = random.Random(root)
    for _ in range(5):
        v = mpf(generator.uniform(-4, 4))
        found = run(
            theta_circular.values(), {**begin, "sin_v": mpmath.sin(v), "cos_v": mpmath.cos(v)}
        )
        if not q:
            assert abs(found["T1_re"] - h[0] * mpmath.sin(v)) < 1e-35
            continue
        z = v - 1j * rho * b
        four, one = theta(4, z, q * q), theta(1, z, q * q)
        assert abs(mpmath.mpc(found["T4_re"], found["T4_im"]) - four) < 1e-18
        assert abs(mpmath.mpc(found["T1_re"], found["T1_im"]) - one) < 1e-18
        for n in (3, 4):
            assert abs(found[f"theta{n}_v"] - theta(n, v, q)) < theta_circular.series_tail()
        for n in (1, 2):
            assert abs(2 * q ** mpf("0.25") * found[f"theta{n}_v"] - theta(n, v, q)) < 1e-18
        norm = abs(four) ** 2 + abs(one) ** 2
        assert abs(found["theta4_v"] * begin["watson"] - norm) < 1e-16
    if q:
        slope = mpmath.jtheta(4, 1j * b, q * q, 1) / theta(4, 1j * b, q * q)
        assert abs(begin["zeta"] - mpmath.im(slope)) < 1e-30


@pytest.mark.parametrize("rho", [1, -1])
@pytest.mark.parametrize(("q", "a"), [("1e-30", "0.2"), ("0.001", "0.7"), ("0.0432", "0.6")])
def test_hyperbolic_thetas(rho, q, a):
    q, a = mpf(q), mpf(a)
    lets = theta_hyperbolic.powers() + theta_hyperbolic.multiples() + theta_hyperbolic.zeta()
    begin = run(
        [*lets, *theta_hyperbolic.coefficients(), *theta_hyperbolic.constants()],
        {"nome": q, "sin_a": mpmath.sin(a), "cos_a": mpmath.cos(a), "rho": rho, "gc": mpf(1)},
    )
    most = -mpmath.log(q) / 2
    tail = mpf(float(theta_hyperbolic.series_tail()))
    assert float(theta_hyperbolic.LARGEST) > mpmath.exp(-mpmath.pi)
    for y in (0, most / 3, -most / 3, most, -most):
        w = mpmath.exp(-2 * abs(y))
        given = {"w": w, "p": q / w, "side": 1 if y >= 0 else -1}
        found = run(theta_hyperbolic.values(), begin | given)
        scale = 2 * mpmath.exp(-abs(y)) / (2 * q ** mpf("0.25"))
        z = rho * a + 1j * y
        two, one = scale * theta(2, z, q), -1j * scale * theta(1, z, q)
        assert abs(mpmath.mpc(found["T4_re"], found["T4_im"]) - two) < 1e-20
        assert abs(mpmath.mpc(found["T1_re"], found["T1_im"]) - one) < 1e-20
        assert abs(mpmath.mpc(found["T4_re"], found["T4_im"]) - two) < tail
        assert abs(mpmath.mpc(found["T1_re"], found["T1_im"]) - one) < tail
        real = [theta(n, 2j * y, q * q) for n in (2, 3, 4)]
        for n, value in zip((2, 3, 4), real, strict=True):
            over = 2 * mpmath.sqrt(q) if n == 2 else 1
            size = 1 if n == 2 else w
            assert abs(found[f"theta{n}_y"] - 2 * w * value / over) < tail * size
        norm = abs(two) ** 2 + abs(one) ** 2
        assert abs(2 * found["theta2_y"] * begin["watson"] / norm - 1) < 1e-20
    slope = mpmath.jtheta(2, a, q, 1) / theta(2, a, q)
    assert abs(begin["zeta"] + slope) < 1e-30
