"""The series of a step at the shortest time against mpmath, over mpmath's own numbers."""

import mpmath
import pytest
from mpmath import mpc, mpf
from values import value_of

from rigidsym._codegen.special_functions import short_time

# p is 1: then |omega t| of 8 rad before STEPS doublings are this.
TIME = mpf(8) / 2**short_time.STEPS


@pytest.fixture(autouse=True)
def _digits():
    with mpmath.workdps(50):
        yield


def run(lets, **given):
    found = {name: mpf(value) for name, value in given.items()} | {"unity": mpf(1)}
    for let in lets:
        found[let.targets[0]] = value_of(let.expression, found, {"rounded": lambda x: x})
    return found


def frequencies(r):
    """e_1, e_2 and h for p = 1, and X and Y of the time."""
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
def test_elapsed(r, share):
    e_1, e_2, _, elapsed = frequencies(r)
    found = run(short_time.elapsed(), e_1=e_1, e_2=e_2, first_t=share * TIME)
    left_out = [
        abs(found[name] / x - 1) for name, x in zip("XY", elapsed(share * TIME), strict=True)
    ]
    assert max(left_out) <= float(short_time.elapsed_tail())
    # It is a bound on something: a term less would break it.
    if (r, share) == ("1", 1):
        assert max(left_out) > float(short_time.elapsed_tail()) / 1000


@pytest.mark.parametrize("r", ["0.2", "0.7", "1"])
@pytest.mark.parametrize("angle", ["0", "0.4", "0.785", "2"])
@pytest.mark.parametrize("slope", ["0.3", "1.9"])
def test_third_kind(r, angle, slope):
    """z on its circle, z' of any direction: the largest there are."""
    e_1, e_2, h, elapsed = frequencies(r)
    z, rate = mpmath.expj(mpf(angle)), h * mpmath.expj(mpf(angle) + mpf(slope))
    nu = -h * z**2
    X = elapsed(TIME)[0]
    parts = {"nu_re": nu.real, "nu_im": nu.imag, "rate_re": rate.real, "rate_im": rate.imag}
    found = run(short_time.third_kind(), e_1=e_1, e_2=e_2, X=X, **parts)

    def integrand(t):
        x = elapsed(t)[0] ** 2
        return x / (1 - nu * x)

    chi = (rate * mpmath.quad(integrand, [0, TIME])).imag
    off = mpmath.arg(mpc(found["E_re"], found["E_im"]) * mpmath.expj(-chi))
    assert abs(off) * 2**short_time.STEPS <= float(short_time.third_kind_tail())
