"""mpmath's functions alone against Arb's balls: every stratum, the edges, threads, and refusals."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from rigidsym import InputError, PrecisionError, TorqueFreeMotion
from rigidsym.precise import METHODS, PreciseMotion
from rigidsym.precise import _floating as floating
from rigidsym.precise._balls import has_digits, of_mpf, working
from rigidsym.validate.strata import STRATA, draw

PAPER = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
DIGITS = 40


def agree(exact, times, digits=DIGITS):
    """Whether every digit that mpmath gives is that of a ball."""
    by_mpmath = PreciseMotion(*exact, "mpmath").states(times, digits)
    by_balls = PreciseMotion(*exact, "landen").enclosures(times, digits + 10)
    for found, balls in zip(by_mpmath, by_balls, strict=True):
        with working(8000):
            for value, ball in zip((*found[0], *found[1]), (*balls[0], *balls[1]), strict=True):
                error = (of_mpf(value) - ball).abs_upper()
                assert error <= ball.abs_upper() * 10**-digits * 1.01 + 2 * ball.rad()
    return True


@pytest.mark.parametrize("stratum", STRATA)
def test_every_stratum_agrees_with_the_balls(stratum):
    sample = draw(stratum, 1, seed=19)
    assert agree(sample.exact, list(map(Fraction, sample.times))[:2])


@pytest.mark.slow
@pytest.mark.parametrize("stratum", STRATA)
def test_a_campaign_over_every_stratum(stratum):
    for index in range(40):
        sample = draw(stratum, index, seed=20)
        assert agree(sample.exact, list(map(Fraction, sample.times))[:3])


@pytest.mark.parametrize("digits", [1, 15, 200])
def test_digits_from_one_to_hundreds(digits):
    assert agree(tuple(PAPER.exact.values()), [Fraction(180)], digits)


def test_a_wrong_function_is_seen_by_the_two_forms(monkeypatch):
    exact = floating.Floating.elliptic_j
    monkeypatch.setattr(
        floating.Floating,
        "elliptic_j",
        lambda self, u, n, mc: exact(self, u, n, mc) + u * floating.CTX.mpf(10) ** -30,
    )
    with pytest.raises(PrecisionError, match="of 50 digits were reached"):
        PAPER.replace().precise(180, 50, method="mpmath", max_seconds=0.5)


def test_no_precision_is_changed_and_the_start_is_that_given():
    before = mpmath.mp.prec, floating.CTX.prec
    q, omega = PAPER.precise([0, 1], 60, method="mpmath")
    assert (mpmath.mp.prec, floating.CTX.prec) == before
    assert list(map(float, q[0])) == [1, 0, 0, 0]
    assert [float(x) for x in omega[0]] == [0.05, 0.03, -0.02]


def test_threads_get_what_one_thread_gets():
    times = [Fraction(k, 7) for k in range(1, 9)]
    alone = [PAPER.precise(t, 30 + k, method="mpmath")[0] for k, t in enumerate(times)]
    with ThreadPoolExecutor(4) as pool:
        jobs = [pool.submit(PAPER.precise, t, 30 + k, method="mpmath") for k, t in enumerate(times)]
        together = [job.result()[0] for job in jobs]
    with working(200):
        for one, other, k in zip(alone, together, range(8), strict=True):
            found = [of_mpf(x) - of_mpf(y) for x, y in zip(one, other, strict=True)]
            assert all(abs(x) < 10.0 ** -(29 + k) for x in found)


def test_the_constants_are_those_of_the_balls():
    names = ("lambda_", "m", "k_1", "psi_0")
    exact = tuple(PAPER.exact.values())
    by_mpmath = PreciseMotion(*exact, "mpmath").constants(names, DIGITS)
    by_balls = PreciseMotion(*exact).constants(names, DIGITS)
    with mpmath.workdps(50):
        for name in names:
            assert abs(by_mpmath[name] / by_balls[name] - 1) < mpmath.mpf(10) ** -(DIGITS - 1)


def test_many_digits_stop_where_the_seconds_are_over():
    with pytest.raises(PrecisionError, match="digits were reached"):
        PAPER.precise(180, 4000, method="mpmath", max_seconds=0.2)


def test_it_gives_no_enclosures_and_takes_no_uncertain_numbers():
    with pytest.raises(InputError, match="no error bounds; balls and sensitivities take theta"):
        PAPER.enclose(1, method="mpmath")
    with pytest.raises(InputError, match=r"must be one of: theta.*mpmath"):
        PAPER.precise(1, method="flint")
    uncertain = PAPER.replace(omega0=("0.05 +/- 1e-9", "0.03", "-0.02"))
    with pytest.raises(InputError, match=r"omega0\[0\].*uncertain"):
        uncertain.precise(1, method="mpmath")
    assert "mpmath" not in METHODS


def test_the_estimate_of_an_error_is_one(monkeypatch):
    """The radius that comes with few bits covers the distance to what many bits give."""
    motion = PreciseMotion(*PAPER.exact.values(), "mpmath")
    few, many = (motion.numbers_here(Fraction(180), bits) for bits in (60, 300))
    with working(400):
        assert all(a.overlaps(b) and not has_digits(a, 25) for a, b in zip(few, many, strict=True))
    assert np.isfinite([float(x.rad()) for x in few]).all()
