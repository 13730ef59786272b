"""Rates in degrees a second, wherever rates are taken."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from rigidsym import InputError, Regime, TorqueFreeMotion, plan, propagate
from rigidsym.io.cases import parse_case
from rigidsym.manoeuvre._manoeuvre import parse

BODY, RATES = ("0.0109", "0.04", "0.0506"), ("3", "2", "-1")
TURNED = math.pi / 180


def test_rates_are_those_in_radians_to_three_hundred_digits():
    motion = TorqueFreeMotion(BODY, RATES, degrees=True)
    with mpmath.workdps(320):
        for rate, given in zip(motion.omega0, RATES, strict=True):
            exact = mpmath.mpf(rate.numerator) / rate.denominator
            assert abs(exact / mpmath.radians(mpmath.mpf(given)) - 1) < mpmath.mpf(10) ** -300
    radians = motion.replace(omega0=[TURNED * float(x) for x in RATES])
    assert np.allclose(motion(100.0)[0], radians(100.0)[0], rtol=0, atol=1e-14)
    assert np.allclose(motion(100.0)[1], radians(100.0)[1], rtol=0, atol=1e-16)


def test_ratios_stay_exact_and_the_regime_with_them():
    body, rates = (4, 5, 9), (3, 1, 1)
    assert 4 * (5 - 4) * rates[0] ** 2 == 9 * (9 - 5) * rates[2] ** 2
    assert TorqueFreeMotion(body, rates, degrees=True).regime == Regime.SEPARATRIX
    assert TorqueFreeMotion(body, np.deg2rad(rates)).regime != Regime.SEPARATRIX


def test_uncertain_rates_keep_their_part():
    motion = TorqueFreeMotion(BODY, ("3 +/- 0.03", 2, 1), degrees=True)
    assert motion.omega0[0].radius * 100 == motion.omega0[0].middle
    middle = motion.replace(omega0=(3, 2, 1), degrees=True).omega0[0]
    assert motion.omega0[0].middle == middle


def test_batches_take_them():
    body = [float(x) for x in BODY]
    q, omega = propagate(body, [3.0, 2.0, -1.0], [0.0, 10.0], degrees=True)
    same = propagate(body, np.deg2rad([3.0, 2.0, -1.0]), [0.0, 10.0])
    assert np.array_equal(q, same[0])
    assert np.array_equal(omega, same[1])


def test_files_take_them():
    text = "inertia = [1, 2, 2.5]\nomega0 = [10, 20, 30]\ntimes = [0]\ndegrees = true\n"
    motion = parse_case(text).motion
    assert motion == TorqueFreeMotion((1, 2, 2.5), (10, 20, 30), degrees=True)
    with pytest.raises(InputError, match=r"^degrees = 'yes': must be true or false$"):
        parse_case(text.replace("true", "'yes'"))


def test_plans_take_them_as_doubles():
    ends = BODY, (1, 0, 0, 0), ("0.5", "0.5", "0.5", "0.5"), 100
    limits = {"max_rate": 5, "target_spin": (1, 0, "0.5")}
    found = plan(*ends, **limits, degrees=True, engine="numpy").manoeuvre
    assert found.limits.max_rate == Fraction(5 * TURNED)
    assert np.allclose([float(x) for x in found.target_spin], [TURNED, 0, TURNED / 2], rtol=1e-16)
    tables = {
        "inertia": BODY, "start": ends[1], "target": ends[2], "duration": 100, "degrees": True,
        "spin": {"target": limits["target_spin"]}, "limits": {"max_rate": 5},
    }  # fmt: skip
    assert parse(tables) == found
    assert max(map(len, found.to_data()["spin"]["target"])) < 30


@pytest.mark.parametrize("wrong", [1, None, "deg"])
def test_other_values_are_refused(wrong):
    with pytest.raises(InputError, match=r"^degrees = .*: must be true or false$"):
        TorqueFreeMotion(BODY, RATES, degrees=wrong)
    with pytest.raises(InputError, match=r"^degrees = .*: must be true or false$"):
        propagate((1.0, 2.0, 2.5), (1.0, 2.0, 3.0), 1.0, degrees=wrong)


def test_replace_takes_degrees_with_rates_alone():
    motion = TorqueFreeMotion(BODY, RATES, degrees=True)
    assert motion.replace(engine="c").omega0 == motion.omega0
    with pytest.raises(InputError, match=r"^degrees = True: is about omega0, which is not given$"):
        motion.replace(degrees=True)
