"""Any number of digits, by balls, mpmath and Theorem 1: against oracles and against each other."""

import json
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import permutations, product
from pathlib import Path

import mpmath
import numpy as np
import pytest
from boxes import PAPER, distance, numbers, overlap

from rigidsym import InputError, PrecisionError, TorqueFreeMotion
from rigidsym.precise import METHODS, PreciseMotion
from rigidsym.precise import _floating as floating
from rigidsym.precise import _theorem1 as theorem1
from rigidsym.precise._balls import has_digits, of_mpf, working
from rigidsym.precise._taylor import integrate
from rigidsym.solution._polhode import Regime
from rigidsym.validate.strata import STRATA, draw

SHORT = [name for name in STRATA if name != "long times"]
MOTION = TorqueFreeMotion(*PAPER)
EXACT = tuple(MOTION.exact.values())
DIGITS = 40


def are_first(few, more, digits):
    """Return True if numbers agree with more precise ones to all their digits."""
    with mpmath.workdps(digits + 30):
        unit = mpmath.mpf(10) ** -digits
        return all(abs(a - b) <= abs(b) * unit for a, b in zip(few, more, strict=True))


def agree(exact, times, digits=DIGITS):
    """Return True if every digit that mpmath gives is that of a ball."""
    by_mpmath = PreciseMotion(*exact, "mpmath").states(times, digits)
    by_balls = PreciseMotion(*exact, "landen").enclosures(times, digits + 10)
    for found, balls in zip(map(numbers, by_mpmath), map(numbers, by_balls), strict=True):
        with working(8000):
            for value, ball in zip(found, balls, strict=True):
                error = (of_mpf(value) - ball).abs_upper()
                assert error <= ball.abs_upper() * 10**-digits * 1.01 + 2 * ball.rad()
    return True


def apart(motion, times, digits=30):
    """Return the distance between states by Theorem 1 and by theta functions, with their signs."""
    found, expected = (motion.precise(times, digits, method=m) for m in ("theorem1", "theta"))
    with mpmath.workdps(digits + 10):
        return max(distance(a.flat, b.flat) for a, b in zip(found, expected, strict=True))


@pytest.mark.parametrize("stratum", SHORT)
@pytest.mark.parametrize("index", [0, 1])
def test_states_satisfy_the_equations_of_motion(stratum, index):
    sample = draw(stratum, index, seed=7)
    exact = [tuple(map(Fraction, x)) for x in (sample.inertia, sample.omega0, sample.attitude0)]
    scale = max(map(abs, exact[1])) or Fraction(1)
    time = Fraction(7) / (3 * scale)
    ((q, omega),) = PreciseMotion(*exact).states([time], 30)
    expected_q, expected_omega = integrate(*exact, time)
    assert distance(q, expected_q) < 1e-29
    assert distance(omega, expected_omega) < mpmath.mpf(scale.numerator) / scale.denominator * 1e-28


@pytest.mark.parametrize(
    ("t", "digits", "more"),
    [*((t, 50, 80) for t in ("180", "-1", "1e6", "1/3")),
     *((100, digits, digits + 20) for digits in (1, 15, 300))],
)  # fmt: skip
def test_few_digits_are_the_first_of_more(t, digits, more):
    found = (np.concatenate(MOTION.precise(t, count)) for count in (digits, more))
    assert are_first(*found, digits)


@pytest.mark.parametrize("digits", [1, 15, 150, 200])
def test_digits_from_one_to_hundreds(digits):
    assert agree(EXACT, [Fraction(180)], digits)
    assert apart(MOTION, [1, 180], digits) < mpmath.mpf(10) ** -(digits - 0.5)


@pytest.mark.parametrize("attitude", [(1, 0, 0, 0), (-1, 0, 0, 0), ("0.6", 0, "-0.8", 0)])
def test_a_trajectory_starts_at_the_given_attitude(attitude):
    q, omega = TorqueFreeMotion(*PAPER, attitude).precise(0, 30)
    assert [float(x) for x in q] == [float(x) for x in attitude]
    assert [float(x) for x in omega] == [0.05, 0.03, -0.02]


def test_tiny_components_keep_their_digits():
    """A rate 160 orders below the others has its own digits, not noise."""
    motion = TorqueFreeMotion((2, 3, 5), ("3.9e-162", 0, "0.2"))
    omega, more = (motion.precise("2", digits)[1] for digits in (20, 40))
    assert 0 < abs(omega[0]) < 1e-161
    assert are_first(omega[:1], more[:1], 20)


@pytest.mark.parametrize(
    ("inertia", "omega", "regime"),
    [
        ((1, 2, "2.25"), ("0.75", "0.5", 1), Regime.SEPARATRIX),
        ((1, 2, "2.25"), ("0.75", "0.5", "1.0000000000000000000000000001"), Regime.LARGEST),
        ((1, 2, "2.25"), ("0.75", "0.5", "0.9999999999999999999999999999"), Regime.SMALLEST),
        ((1, 1, 2), (1, 2, 3), Regime.SYMMETRIC),
        ((1, 1, 2), (1, 2, 0), Regime.SPIN),
        ((1, 1, 1), (1, 2, 3), Regime.SPHERICAL),
        ((1, 2, 3), (0, 1, 0), Regime.SPIN),
        ((1, 2, 3), (0, 0, 0), Regime.REST),
        ((1, 1, 1), (0, 0, 0), Regime.REST),
    ],
)
def test_the_regime_is_decided_exactly(inertia, omega, regime):
    assert TorqueFreeMotion(inertia, omega).regime == regime


@pytest.mark.parametrize("t", ["1", "-20", "100", "2000"])
@pytest.mark.parametrize("signs", [(1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1)])
def test_the_exact_separatrix_ends_in_spin_about_the_middle_axis(t, signs):
    omega0 = [Fraction(3, 4) * signs[0], Fraction(1, 2) * signs[1], Fraction(signs[2])]
    q, omega = TorqueFreeMotion((1, 2, Fraction(9, 4)), omega0).precise(t, 25)
    with mpmath.workdps(30):
        assert abs(sum(x * x for x in q) - 1) < 1e-24
        energy = omega[0] ** 2 + 2 * omega[1] ** 2 + mpmath.mpf(9) / 4 * omega[2] ** 2
        start = mpmath.mpf(9) / 16 + mpmath.mpf(1) / 2 + mpmath.mpf(9) / 4
        assert abs(energy - start) < 1e-23
        if abs(Fraction(t)) == 2000:
            assert abs(abs(omega[1]) - mpmath.sqrt(start / 2)) < 1e-20


@pytest.mark.parametrize("digits", [0, -1, 1.5, "10", True])
def test_digits_must_be_a_positive_whole_number(digits):
    with pytest.raises(InputError, match="digits = "):
        MOTION.precise(1, digits)


OWN = json.loads(Path(__file__).with_name("motions.json").read_text())


@pytest.mark.parametrize("motion", OWN["motions"], ids=lambda motion: motion["name"])
@pytest.mark.parametrize("method", METHODS)
def test_motions_of_every_kind_agree_with_their_taylor_series(motion, method):
    given = TorqueFreeMotion(*(motion[name] for name in ("inertia", "omega0", "attitude0")))
    found = given.precise(motion["t"], OWN["digits"], method=method)
    with mpmath.workdps(OWN["digits"] + 20):
        for values, printed in zip(found, (motion["q"], motion["omega"]), strict=True):
            expected = [mpmath.mpf(text) for text in printed]
            assert distance(values, expected) < max(map(abs, expected)) * mpmath.mpf(10) ** -38


def test_integers_of_numpy_are_integers():
    motion = TorqueFreeMotion(np.array([1, 2, 3]), (1, 2, 3))
    expected = TorqueFreeMotion((1, 2, 3), (1, 2, 3)).precise([0, 1], 30)
    for found, there in zip(motion.precise(np.arange(2), 30), expected, strict=True):
        assert (found == there).all()
    assert motion.enclose(np.int64(1), 20)[0][0].contains(motion.enclose(1, 30)[0][0])


# mpmath's functions.


@pytest.mark.parametrize("stratum", STRATA)
def test_mpmath_agrees_with_the_balls_in_every_stratum(stratum):
    sample = draw(stratum, 1, seed=19)
    assert agree(sample.exact, list(map(Fraction, sample.times))[:2])


@pytest.mark.slow
@pytest.mark.parametrize("stratum", STRATA)
def test_a_campaign_of_mpmath_over_every_stratum(stratum):
    for index in range(40):
        sample = draw(stratum, index, seed=20)
        assert agree(sample.exact, list(map(Fraction, sample.times))[:3])


def test_a_wrong_function_is_seen_by_the_two_forms(monkeypatch):
    exact = floating.Floating.elliptic_j
    monkeypatch.setattr(
        floating.Floating,
        "elliptic_j",
        lambda self, u, n, mc: exact(self, u, n, mc) + u * floating.CTX.mpf(10) ** -30,
    )
    with pytest.raises(PrecisionError, match="of 50 digits were reached"):
        MOTION.replace().precise(180, 50, method="mpmath", max_seconds=0.5)


@pytest.mark.parametrize("method", ["theta", "mpmath"])
def test_no_precision_is_changed_and_the_start_is_that_given(method):
    before = mpmath.mp.prec, floating.CTX.prec
    q, omega = MOTION.precise([0, 1], 60, method=method)
    assert (mpmath.mp.prec, floating.CTX.prec) == before
    assert list(map(float, q[0])) == [1, 0, 0, 0]
    assert [float(x) for x in omega[0]] == [0.05, 0.03, -0.02]


def test_threads_get_what_one_thread_gets():
    times = [Fraction(k, 7) for k in range(1, 9)]
    alone = [MOTION.precise(t, 30 + k, method="mpmath")[0] for k, t in enumerate(times)]
    with ThreadPoolExecutor(4) as pool:
        jobs = [pool.submit(MOTION.precise, t, 30 + k, method="mpmath")
                for k, t in enumerate(times)]  # fmt: skip
        together = [job.result()[0] for job in jobs]
    with working(200):
        for k, pair in enumerate(zip(alone, together, strict=True)):
            found = [of_mpf(x) - of_mpf(y) for x, y in zip(*pair, strict=True)]
            assert all(abs(x) < 10.0 ** -(29 + k) for x in found)


def test_the_constants_are_those_of_the_balls():
    names = ("lambda_", "m", "k_1", "psi_0")
    by_mpmath, by_balls = (
        PreciseMotion(*EXACT, method).constants(names, DIGITS) for method in ("mpmath", "theta")
    )
    with mpmath.workdps(50):
        for name in names:
            assert abs(by_mpmath[name] / by_balls[name] - 1) < mpmath.mpf(10) ** -(DIGITS - 1)


@pytest.mark.parametrize("method", ["mpmath", "theorem1"])
def test_many_digits_stop_where_the_seconds_are_over(method):
    with pytest.raises(PrecisionError, match="digits were reached"):
        MOTION.precise(180, 4000, method=method, max_seconds=0.2)


def test_mpmath_gives_no_enclosures_and_takes_no_uncertain_numbers():
    uncertain = MOTION.replace(omega0=("0.05 +/- 1e-9", "0.03", "-0.02"))
    for ask, message in (
        (lambda: MOTION.enclose(1, method="mpmath"),
         "no error bounds; balls and sensitivities take theta"),
        (lambda: MOTION.precise(1, method="flint"), r"must be one of: theta.*mpmath"),
        (lambda: uncertain.precise(1, method="mpmath"), r"omega0\[0\].*uncertain"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=message):
            ask()
    assert "mpmath" not in METHODS


def test_the_estimate_of_an_error_is_one():
    """The radius that comes with few bits covers the distance to what many bits give."""
    motion = PreciseMotion(*EXACT, "mpmath")
    few, many = (motion.numbers_here(Fraction(180), bits) for bits in (60, 300))
    with working(400):
        assert overlap(few, many)
        assert not any(has_digits(x, 25) for x in few)
    assert np.isfinite([float(x.rad()) for x in few]).all()


# Theorem 1 of the paper.
MOMENTS = ("2.1", "3", "4.3")
RATES = {"largest": ("0.4", "0.3", "0.9"), "smallest": ("0.9", "0.3", "0.4")}


@pytest.mark.parametrize("order", [*permutations(range(3))])
@pytest.mark.parametrize("circulation", RATES)
def test_theorem_1_with_every_order_of_axes_and_every_sign(order, circulation):
    for signs in product(("", "-"), repeat=3):
        rates = [sign + RATES[circulation][k] for sign, k in zip(signs, order, strict=True)]
        attitude = ("0.5", "-0.1", "0.7", "0.3")
        motion = TorqueFreeMotion([MOMENTS[k] for k in order], rates, attitude)
        assert apart(motion, ["17.3", "-41"]) < 1e-29


@pytest.mark.parametrize("time", ["1e12", "-12345.678"])
def test_theorem_1_at_long_times(time):
    assert apart(MOTION, time, 40) < 1e-39


@pytest.mark.parametrize(
    ("inertia", "omega", "said"),
    [
        ((1, 1, 2), (1, 0, 1), "symmetric"),
        ((1, 1, 1), (1, 2, 3), "spherical"),
        ((1, 2, "2.5"), (0, 1, 0), "spin"),
        ((1, 2, "2.5"), (0, 0, 0), "rest"),
        ((1, 2, "9/4"), (3, 1, 4), "separatrix"),
    ],
)
def test_motions_without_three_sines_are_refused(inertia, omega, said):
    motion = TorqueFreeMotion(inertia, omega)
    assert str(motion.regime).startswith(said)
    with pytest.raises(InputError, match=f"method = 'theorem1': has no sines.*{said}.*theta"):
        motion.precise(1, method="theorem1")


@pytest.mark.parametrize("omega", [("0.4", "0.3", 0), ("0.4", 0, "-0.9")])
def test_starts_at_which_theorem_1_divides_by_zero_are_refused(omega):
    with pytest.raises(InputError, match=r"omega0 = .*Theorem 1 divides by it"):
        TorqueFreeMotion(MOMENTS, omega).precise(1, method="theorem1")


def test_a_start_where_phi3_is_zero_is_none_of_them():
    assert apart(TorqueFreeMotion(MOMENTS, ("0.4", 0, "0.9")), ["1", "90"]) < 1e-29


def test_a_wrong_pi_is_seen_against_the_balls(monkeypatch):
    """The comparison of two precisions cannot show it."""
    exact = theorem1._Lines._real_third_kind
    monkeypatch.setattr(
        theorem1._Lines,
        "_real_third_kind",
        lambda self, n, u, mc: exact(self, n, u, mc) * (1 + theorem1.CTX.mpf(10) ** -9),
    )
    assert apart(MOTION.replace(), "180") > 1e-12
