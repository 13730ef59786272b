"""Any number of digits: against an oracle without elliptic functions, and against itself."""

import json
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.precise import METHODS, PreciseMotion
from rigidsym.precise._taylor import integrate
from rigidsym.solution._polhode import Regime
from rigidsym.validate.strata import STRATA, draw

REFERENCE = Path(__file__).parents[3] / "shared" / "reference" / "reference_cases.json"
PAPER = (("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
SHORT = [name for name in STRATA if name != "long times"]


def distance(given, expected):
    return max(abs(a - b) for a, b in zip(given, expected, strict=True))


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


@pytest.mark.skipif(not REFERENCE.exists(), reason="shared reference data is not here")
def test_reference_motions_from_other_systems():
    cases = json.loads(REFERENCE.read_text())["cases"]
    assert len(cases) == 31
    for case in cases:
        given = (case["inertia"], case["omega0"], case["q0"])
        motion = TorqueFreeMotion(*given, allow_nonphysical=True)
        q, omega = motion.precise([row["t"] for row in case["hp"]], 30)
        for k, row in enumerate(case["hp"]):
            with mpmath.workdps(40):
                assert distance(q[k], map(mpmath.mpf, row["q"])) < 3e-26, case["id"]
                assert distance(omega[k], map(mpmath.mpf, row["omega"])) < 3e-26, case["id"]


@pytest.mark.parametrize("t", ["180", "-1", "1e6", "1/3"])
def test_fifty_digits_are_the_first_fifty_of_eighty(t):
    motion = TorqueFreeMotion(*PAPER)
    fifty, eighty = (np.concatenate(motion.precise(t, digits)) for digits in (50, 80))
    with mpmath.workdps(90):
        for a, b in zip(fifty, eighty, strict=True):
            assert abs(a - b) <= abs(b) * mpmath.mpf(10) ** -50


@pytest.mark.parametrize("digits", [1, 15, 300])
def test_digits_from_one_to_hundreds(digits):
    motion = TorqueFreeMotion(*PAPER)
    few, more = (motion.precise(100, d)[0] for d in (digits, digits + 20))
    with mpmath.workdps(digits + 30):
        assert all(
            abs(a - b) <= abs(b) * mpmath.mpf(10) ** -digits for a, b in zip(few, more, strict=True)
        )


def test_global_precision_is_left_alone():
    before = mpmath.mp.dps
    TorqueFreeMotion(*PAPER).precise(1, 60)
    assert mpmath.mp.dps == before


@pytest.mark.parametrize("attitude", [(1, 0, 0, 0), (-1, 0, 0, 0), ("0.6", 0, "-0.8", 0)])
def test_a_trajectory_starts_at_the_given_attitude(attitude):
    q, omega = TorqueFreeMotion(*PAPER, attitude).precise(0, 30)
    assert [float(x) for x in q] == [float(x) for x in attitude]
    assert [float(x) for x in omega] == [0.05, 0.03, -0.02]


def test_tiny_components_keep_their_digits():
    """A rate 160 orders below the others has its own digits, not noise."""
    motion = TorqueFreeMotion((2, 3, 5), ("3.9e-162", 0, "0.2"))
    _, omega = motion.precise("2", 20)
    more = motion.precise("2", 40)[1]
    assert 0 < abs(omega[0]) < 1e-161
    with mpmath.workdps(50):
        assert abs(omega[0] - more[0]) < abs(more[0]) * mpmath.mpf(10) ** -20


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
        TorqueFreeMotion(*PAPER).precise(1, digits)


OWN = json.loads(Path(__file__).with_name("motions.json").read_text())


@pytest.mark.parametrize("motion", OWN["motions"], ids=lambda motion: motion["name"])
@pytest.mark.parametrize("method", METHODS)
def test_motions_of_every_kind_agree_with_their_taylor_series(motion, method):
    given = TorqueFreeMotion(*(motion[name] for name in ("inertia", "omega0", "attitude0")))
    found = given.precise(motion["t"], OWN["digits"], method=method)
    with mpmath.workdps(OWN["digits"] + 20):
        for numbers, printed in zip(found, (motion["q"], motion["omega"]), strict=True):
            expected = [mpmath.mpf(text) for text in printed]
            assert distance(numbers, expected) < max(map(abs, expected)) * mpmath.mpf(10) ** -38


def test_integers_of_numpy_are_integers():
    motion = TorqueFreeMotion(np.array([1, 2, 3]), (1, 2, 3))
    expected = TorqueFreeMotion((1, 2, 3), (1, 2, 3)).precise([0, 1], 30)
    for found, there in zip(motion.precise(np.arange(2), 30), expected, strict=True):
        assert (found == there).all()
    assert motion.enclose(np.int64(1), 20)[0][0].contains(motion.enclose(1, 30)[0][0])
