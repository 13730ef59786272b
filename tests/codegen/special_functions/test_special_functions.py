"""Special functions of the generated code against mpmath, over mpmath's own numbers."""

import random
from fractions import Fraction
from functools import cache
from itertools import pairwise

import mpmath
import pytest
from mpmath import mpc, mpf
from values import value_of

from rigidsym._codegen.formats import BINARY32, BINARY64
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.special_functions import (
    angles,
    carlson,
    exponential,
    landen,
    nome,
    reduction,
    short_time,
    theta_circular,
    theta_hyperbolic,
)
from rigidsym.solution import sealed

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
    with mpmath.workdps(50):
        yield


FORMATS = pytest.mark.parametrize("binary", [BINARY64, BINARY32], ids=lambda x: x.name)


@cache
def by_name(binary):
    forms = ("theta", "pi") if binary is BINARY64 else ("theta",)
    return {f.name: f for form in forms for f in functions(sealed(), form, binary)}


def run(lets, values, binary=BINARY64):
    """Return the values of all lets over mpmath numbers: what they leave out, and no rounding."""
    found = {c.name: mpf(c.hi) + mpf(c.lo or 0) for c in constants(binary)} | {"pi": mpmath.pi()}
    found |= values
    table = PRIMITIVES | {
        name: lambda *x, n=name: call(n, *x, binary=binary) for name in by_name(binary)
    }
    for let in lets:
        value = value_of(let.expression, found, table)
        found |= dict(zip(let.targets, value if len(let.targets) > 1 else (value,), strict=True))
    return found


def call(name, *arguments, binary=BINARY64):
    function = by_name(binary)[name]
    found = run(function.lets, dict(zip(function.parameters, arguments, strict=True)), binary)
    results = tuple(found[result] for result in function.results)
    return results if len(results) > 1 else results[0]


# --- Landen's ladder, nome, angles, thetas


MODULI = [mpf(0), mpf("1e-12"), mpf("0.1"), mpf("0.5"), mpmath.sqrt(0.5)]


@FORMATS
@pytest.mark.parametrize("k", MODULI)
def test_the_ladder_gives_the_quarter_period_and_inverts_sn(k, binary):
    most = 2.0 ** (-2 * binary.digits)
    kc, u, b = mpmath.sqrt(1 - k * k), mpf("0.7"), mpf("0.3")
    sn, cn, dn = (mpmath.ellipfun(f, u, m=k * k) for f in ("sn", "cn", "dn"))
    x = mpmath.im(mpmath.ellipfun("sn", 1j * b, m=k * k))
    quarter, s, c, sinh = call("_ladder", k, kc, sn, cn, dn, k, x, binary=binary)
    assert abs(quarter - mpmath.ellipk(k * k)) < most
    scale = mpmath.pi / (2 * quarter)
    assert abs(s - mpmath.sin(scale * u)) < most
    assert abs(c - mpmath.cos(scale * u)) < most
    assert abs(sinh - mpmath.sinh(scale * b)) < most
    assert landen.modulus_left(binary.landen) < most


@FORMATS
@pytest.mark.parametrize("k", MODULI[1:])
def test_the_nome_is_regular_at_zero_and_right_to_all_digits_of_a_pair(k, binary):
    with mpmath.workdps(70):
        q = mpmath.exp(-mpmath.pi * mpmath.ellipk(1 - k * k) / mpmath.ellipk(k * k))
    ratio = call("_root_ratio", k, mpmath.sqrt(1 - k * k), binary=binary)
    assert abs(ratio * mpmath.sqrt(q) / k - 1) < 2.0 ** (-2 * binary.digits)
    assert call("_root_ratio", mpf(0), mpf(1), binary=binary) == 4


def test_the_coefficients_of_the_nome_are_the_known_ones():
    assert nome.coefficients(8) == [1, 2, 15, 150, 1707, 20910, 268616, 3567400]  # OEIS A002103


@FORMATS
def test_what_the_series_of_the_nome_leaves_out_is_within_its_bound(binary):
    worst = 3 / mpf(100)  # k_next^2 where k^2 = 1/2 is (3 - 2 sqrt(2))^2, k' and its root more
    assert (3 - 2 * mpmath.sqrt(2)) ** 2 < worst
    assert worst / (2 * (2 - worst) ** 3) < mpf(1) / nome.LARGEST.denominator
    e = mpf(1) / nome.LARGEST.denominator
    rest = nome.coefficients(12)[binary.nome :]
    left_out = sum(a * e ** (4 * n) for n, a in enumerate(rest, binary.nome))
    assert left_out < float(nome.series_tail(binary)) < 200 * left_out
    assert nome.series_tail(binary) < 2.0 ** (-2 * binary.digits)
    growth = [b / a for a, b in pairwise(nome.coefficients(12))]
    assert max(growth) < 21  # by Cauchy's estimate; it tends to 16


@FORMATS
@pytest.mark.parametrize("angle", ["0", "1e-30", "0.1", "-0.4999", "0.5", "-0.5", "0.25"])
def test_half_turns(angle, binary):
    theta = mpmath.pi * mpf(angle)
    found = call("_half_turns", mpmath.sin(theta), abs(mpmath.cos(theta)), binary=binary)
    # The coefficients are pairs, too.
    assert abs(found - mpf(angle)) < 2.0 ** (-2 * binary.digits)


@FORMATS
@pytest.mark.parametrize("x", ["1", "1e-290", "0.7072", "1.4142", "3", "1e150"])
def test_logarithm(x, binary):
    difference = call("_logarithm", mpf(x), binary=binary) - mpmath.log(mpf(x))
    # frexp halves at 1/2 here, which makes the argument of the series twice as large.
    most = (
        2.0 ** (20 - 2 * binary.digits) if binary is BINARY64 else 2.0 ** (10 - 2 * binary.digits)
    )
    assert abs(difference) < most * max(1, abs(mpmath.log(mpf(x))))
    assert angles.series_tail(binary) < 2.0 ** (-2 * binary.digits)


@pytest.mark.parametrize(
    ("count", "binary"), [(6, BINARY64), (7, BINARY64), (8, BINARY64), (4, BINARY32), (5, BINARY32)]
)
def test_sine_and_cosine_stay_within_their_bounds(count, binary):
    sines = reduction.sine_coefficients(count, binary)
    cosines = reduction.cosine_coefficients(count, binary)
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


@FORMATS
def test_sine_and_cosine_have_as_many_terms_as_their_format_needs(binary):
    count = binary.trigonometric
    most = 2.0**-binary.digits
    assert 2 * reduction.sine_bound(reduction.sine_coefficients(count, binary)) < most
    # With coefficients of 24 bits it is more than half a unit in the last place.
    assert reduction.cosine_bound(reduction.cosine_coefficients(count, binary)) < most


def theta(n, z, q):
    return mpmath.jtheta(n, z, q)


@FORMATS
@pytest.mark.parametrize("rho", [1, -1])
@pytest.mark.parametrize(
    ("root", "b"), [("0", "0"), ("0.02", "1.2"), ("0.2", "0.75"), ("0.207", "0.1")]
)
def test_circular_thetas(rho, root, b, binary):
    """Q is the nome of m, and 2 b < log(1/Q) since beta < K'/2."""
    q, b, g = mpf(root), mpf(b), mpf(1)
    h = [mpmath.sqrt(q) * mpmath.exp(sign * b) for sign in (1, -1)] if q else [mpf("0.3"), mpf(0)]
    lets = theta_circular.powers(binary) + theta_circular.zeta(binary)
    begin = run(
        [*lets, *theta_circular.coefficients(binary), *theta_circular.constants(binary)],
        {"Q": q, "h_plus": h[0], "h_minus": h[1], "rho": rho, "g": g},
    )
    tail = theta_circular.series_tail(binary)
    generator = random.Random(root)
    for _ in range(5):
        v = mpf(generator.uniform(-4, 4))
        found = run(
            theta_circular.values(binary), {**begin, "sin_v": mpmath.sin(v), "cos_v": mpmath.cos(v)}
        )
        if not q:
            assert abs(found["T1_re"] - h[0] * mpmath.sin(v)) < 1e-35
            continue
        z = v - 1j * rho * b
        four, one = theta(4, z, q * q), theta(1, z, q * q)
        assert abs(mpmath.mpc(found["T4_re"], found["T4_im"]) - four) < tail
        assert abs(mpmath.mpc(found["T1_re"], found["T1_im"]) - one) < tail
        for n in (3, 4):
            assert abs(found[f"theta{n}_v"] - theta(n, v, q)) < tail
        for n in (1, 2):
            assert abs(2 * q ** mpf("0.25") * found[f"theta{n}_v"] - theta(n, v, q)) < tail
        norm = abs(four) ** 2 + abs(one) ** 2
        assert abs(found["theta4_v"] * begin["watson"] - norm) < 20 * tail
    if q:
        slope = mpmath.jtheta(4, 1j * b, q * q, 1) / theta(4, 1j * b, q * q)
        assert abs(begin["zeta"] - mpmath.im(slope)) < 2.0 ** (-2 * binary.digits)


@FORMATS
@pytest.mark.parametrize("rho", [1, -1])
@pytest.mark.parametrize(("q", "a"), [("1e-30", "0.2"), ("0.001", "0.7"), ("0.0432", "0.6")])
def test_hyperbolic_thetas(rho, q, a, binary):
    q, a = mpf(q), mpf(a)
    lets = theta_hyperbolic.powers() + theta_hyperbolic.multiples(binary)
    lets += theta_hyperbolic.zeta(binary)
    begin = run(
        [*lets, *theta_hyperbolic.coefficients(binary), *theta_hyperbolic.constants(binary)],
        {"nome": q, "sin_a": mpmath.sin(a), "cos_a": mpmath.cos(a), "rho": rho, "gc": mpf(1)},
    )
    most = -mpmath.log(q) / 2
    tail = mpf(float(theta_hyperbolic.series_tail(binary)))
    assert float(theta_hyperbolic.LARGEST) > mpmath.exp(-mpmath.pi)
    for y in (0, most / 3, -most / 3, most, -most):
        w = mpmath.exp(-2 * abs(y))
        given = {"w": w, "p": q / w, "side": 1 if y >= 0 else -1}
        found = run(theta_hyperbolic.values(binary), begin | given)
        scale = 2 * mpmath.exp(-abs(y)) / (2 * q ** mpf("0.25"))
        z = rho * a + 1j * y
        two, one = scale * theta(2, z, q), -1j * scale * theta(1, z, q)
        assert abs(mpmath.mpc(found["T4_re"], found["T4_im"]) - two) < tail
        assert abs(mpmath.mpc(found["T1_re"], found["T1_im"]) - one) < tail
        real = [theta(n, 2j * y, q * q) for n in (2, 3, 4)]
        for n, value in zip((2, 3, 4), real, strict=True):
            over = 2 * mpmath.sqrt(q) if n == 2 else 1
            size = 1 if n == 2 else w
            assert abs(found[f"theta{n}_y"] - 2 * w * value / over) < tail * size
        norm = abs(two) ** 2 + abs(one) ** 2
        assert abs(2 * found["theta2_y"] * begin["watson"] / norm - 1) < 4 * tail
    slope = mpmath.jtheta(2, a, q, 1) / theta(2, a, q)
    assert abs(begin["zeta"] + slope) < 2.0 ** (-2 * binary.digits)


# --- the exponential

TERMS = exponential.coefficients()
NUMBERS = {constant.name: constant.hi for constant in exponential.constants()}
REACH = mpf("0.3467")


@FORMATS
@pytest.mark.parametrize("k", range(-20, 21))
def test_the_polynomial_is_within_its_bound(k, binary):
    terms = exponential.coefficients(binary)
    with mpmath.workdps(50):
        r = mpf(k) / 21 * REACH
        value = 1 + r + r**2 / 2 + sum(term * r ** (n + 3) for n, term in enumerate(terms))
        most = 2.0 ** -(binary.digits + 1)
        assert abs(value / mpmath.exp(r) - 1) <= exponential.bound(terms) < most


def test_a_wrong_coefficient_shows():
    wrong = (*TERMS[:4], TERMS[4] * (1 + 1e-9), *TERMS[5:])
    assert exponential.bound(wrong) > 2.0**-53


def test_log_2_in_two():
    assert (Fraction(NUMBERS["log_2_short"]) * 2**32).denominator == 1
    with mpmath.workdps(40):
        both = NUMBERS["log_2_short"] + mpf(NUMBERS["log_2_rest"])
        assert abs(both - mpmath.ln2) < mpf(2) ** -86
        assert mpmath.ln2 / 2 * (1 + mpf(2) ** -40) < REACH


@pytest.mark.parametrize(
    ("x", "bound"), [(0.0, 0), (-1e-300, 0), (-0.5, 1e-16), (-37.4, 1e-16), (-707.9, 1e-16)]
)
def test_the_lets_in_doubles(x, bound):
    found = in_doubles(x)
    with mpmath.workdps(40):
        assert abs(found / mpmath.exp(x) - 1) <= 2 * bound


@pytest.mark.parametrize("x", [-708.5, -1e300, float("-inf")])
def test_what_is_too_small_is_zero(x):
    assert in_doubles(x) == 0.0


def in_doubles(x):
    known = NUMBERS | {"x": x}
    functions = PRIMITIVES | {
        "nearest": lambda value: (value + 1.5 * 2.0**52) - 1.5 * 2.0**52,
        "power_of_two": lambda n: 2.0**n,
    }
    for let in exponential.function().lets:
        known[let.targets[0]] = value_of(let.expression, known, functions)
    return known["value"]


# --- series of a step at the shortest time


def shortest(binary):
    """Return the shortest time if |omega t| is 8 rad before doublings; p is 1."""
    return mpf(8) / 2**binary.doublings


def frequencies(r):
    """Return e_1, e_2 and h for p = 1, and X and Y of the time."""
    h = mpf(r) / 4
    e_1, e_2 = 1 - mpf(r) / 2, h**2
    mu_2 = (e_1 + mpmath.sqrt(e_1**2 - 4 * e_2)) / 2
    mu, m = mpmath.sqrt(mu_2), e_2 / mu_2**2

    def elapsed(t):
        sn, cn, dn = (mpmath.ellipfun(name, mu * t, m=m) for name in ("sn", "cn", "dn"))
        return sn / mu, cn * dn

    return e_1, e_2, h, elapsed


@pytest.mark.parametrize("r", ["0", "0.3", "0.7", "1"])
@pytest.mark.parametrize("share", [1, -0.6])
@FORMATS
def test_elapsed(r, share, binary):
    e_1, e_2, _, elapsed = frequencies(r)
    time = share * shortest(binary)
    found = run(short_time.elapsed(binary), {"e_1": e_1, "e_2": e_2, "first_t": time})
    left_out = [abs(found[name] / x - 1) for name, x in zip("XY", elapsed(time), strict=True)]
    assert max(left_out) <= float(short_time.elapsed_tail(binary))
    # It is a bound on something: a term less would break it.
    if (r, share) == ("1", 1):
        assert max(left_out) > float(short_time.elapsed_tail(binary)) / 1000


@pytest.mark.parametrize("r", ["0.2", "0.7", "1"])
@pytest.mark.parametrize("angle", ["0", "0.4", "0.785", "2"])
@pytest.mark.parametrize("slope", ["0.3", "1.9"])
@FORMATS
def test_third_kind_of_a_step(r, angle, slope, binary):
    """The bound holds for z on its circle and z' of any direction, both as large as possible."""
    e_1, e_2, h, elapsed = frequencies(r)
    z, rate = mpmath.expj(mpf(angle)), h * mpmath.expj(mpf(angle) + mpf(slope))
    nu = -h * z**2
    time = shortest(binary)
    X = elapsed(time)[0]
    parts = {"nu_re": nu.real, "nu_im": nu.imag, "rate_re": rate.real, "rate_im": rate.imag}
    found = run(short_time.third_kind(binary), {"e_1": e_1, "e_2": e_2, "X": X} | parts)

    def integrand(t):
        x = elapsed(t)[0] ** 2
        return x / (1 - nu * x)

    chi = (rate * mpmath.quad(integrand, [0, time])).imag
    off = mpmath.arg(mpc(found["E_re"], found["E_im"]) * mpmath.expj(-chi))
    assert abs(off) * 2**binary.doublings <= float(short_time.third_kind_tail(binary))


# --- Carlson's R_J and complete integrals


def jacobi(u, m):
    return [mpmath.ellipfun(name, u, m=m) for name in ("sn", "cn", "dn")]


def third_kind(s, c, d, n, k):
    """Return what the code finds, and the true value."""
    path = 1 - n * s**2
    spread = -n * (1 - n) * (k**2 - n)
    found = call("_third_kind", s, c, d, path, spread)
    return found, s**3 / 3 * mpmath.elliprj(c**2, d**2, 1, path)


@pytest.mark.parametrize("k", ["0.02", "0.3", "0.6", "0.70710678"])
@pytest.mark.parametrize("share", ["0", "0.4", "1"])
def test_third_kind_up_to_a_quarter_period(k, share):
    """For n between 0 and -k, kappa is at most 2 k (1 + k); half of it multiplies J in psi."""
    k = mpf(k)
    n = -k * mpf(share)
    for part in range(1, 9):
        s, c, d = jacobi(mpmath.ellipk(k**2) * part / 8, k**2)
        found, true = third_kind(s, c, d, n, k)
        assert abs(found - true) * k * (1 + k) <= carlson.MEASURED


@pytest.mark.parametrize("complement", ["0.707", "0.4", "0.1", "1e-2", "1e-5", "1e-12", "1e-60"])
@pytest.mark.parametrize("x", ["0.01", "0.5", "1"])
def test_third_kind_near_the_separatrix(complement, x):
    """The bound holds up to half a quarter period, times the larger of J's factors there."""
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
        quarter, total = call("_complete", kc, 1 - n)
        assert abs(quarter / mpmath.ellipk(m) - 1) <= landen.MEANS_MEASURED
        slope = total / (2 * (1 - n))
        true = (mpmath.ellippi(n, m) / mpmath.ellipk(m) - 1) / n
        assert abs(slope / true - 1) * quarter <= landen.MEANS_MEASURED
