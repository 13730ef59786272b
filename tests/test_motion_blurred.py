"""Tests of motions that doubles cannot tell from the separatrix or from middle-axis spin.

They are right up to a time, and refused beyond it.
"""

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, propagate
from rigidsym import _engines as engines
from rigidsym._engines import exactly
from rigidsym.validate._oracle import lengths

ORDERS, SIGNS = (list(itertools.permutations(range(3))), list(itertools.product((1, -1), repeat=3)))
# Rates about the axes of smallest, middle and largest inertia of a body.
GENERAL, CLOSE, THIN = (1.0, 2.0, 2.5), (1.0, 1.0000001, 1.5), (0.01, 1.0, 1.005)
NEEDLE, WHOLE = (1e-10, 1.0, 1.00000000005), (3, 4, 6)
CASES = {
    "the least tilt": (GENERAL, (5e-324, 1.0, 0.0)),
    "the least tilts of a fast spin": (GENERAL, (5e-324, 3.0, 5e-324)),
    "tilts of two sizes": (GENERAL, (1e-200, 0.7, 1e-125)),
    "one taken for zero": (CLOSE, (1e-125, 1.0, 1e-121)),
    "a thin body": (THIN, (1e-300, 1.0, 1e-123)),
    "a needle": (NEEDLE, (1e-310, 1.0, 1e-320)),
    "decimals below binary64": (GENERAL, (Fraction(1, 10**600), 1, Fraction(2, 10**400))),
    "beside the separatrix": (WHOLE, (2 + Fraction(1, 10**400), Fraction(1, 7), 1)),
    "inside the separatrix": (WHOLE, (2 - Fraction(1, 10**700), -3, 1)),
    "beside it, unstable axis at rest": (WHOLE, (2 + Fraction(1, 10**300), 0, 1)),
    "beside it and its spin": (
        WHOLE,
        (Fraction(2, 10**100) * (1 + Fraction(1, 10**200)), 1, Fraction(1, 10**100)),
    ),
}


def shuffled(case, number):
    """Return a test case with its axes permuted and signs of its rates changed."""
    inertia, omega = CASES[case]
    order, signs = ORDERS[number % len(ORDERS)], SIGNS[(5 * number + 3) % len(SIGNS)]
    return [inertia[k] for k in order], [signs[k] * omega[k] for k in order]


def last_time(motion):
    with pytest.raises(InputError, match=r"nearer to the separatrix .* beyond [\d.e+]+ s$") as told:
        motion(1e12)
    return float(str(told.value).split()[-2])


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("number", range(0, 6, 2))
def test_states_are_right_up_to_the_time_that_is_told(case, number, engine):
    number += list(CASES).index(case) % 2
    motion = TorqueFreeMotion(*shuffled(case, number), (0.5, -1, 2, 0.25), engine=engine)
    last = last_time(motion)
    assert last > 100
    times = [1.0, 0.5 * last, -0.9 * last, last, -last]
    q, omega = motion(times)
    true_q, true_omega = motion.precise(times, 22)
    assert np.max(lengths((q - true_q).astype(float), 0.0)) < 1e-15
    size = lengths(true_omega.astype(float))
    assert np.max(lengths((omega - true_omega).astype(float), 0.0) / size) < 2e-15
    with pytest.raises(InputError, match="nearer to the separatrix"):
        motion([0.0, -math.nextafter(last, math.inf)])


@pytest.mark.parametrize("case", ["the least tilts of a fast spin", "tilts of two sizes"])
def test_the_time_is_not_much_too_short(case, engine):
    """Soon after the last time, the body leaves its spin."""
    motion = TorqueFreeMotion(*CASES[case], engine=engine)
    last = last_time(motion)
    _, omega = motion.precise([last, 1.05 * last], 10)
    assert abs(omega[0, 0] / omega[0, 1]) < 1e-15
    assert abs(omega[1, 0] / omega[1, 1]) > 1e-15


def test_a_tilt_that_decides_by_far_is_followed_at_all_times(engine):
    motion = TorqueFreeMotion(GENERAL, (5e-324, 1.0, 1e-110), engine=engine)
    times = [300.0, 3000.0, -1e6]
    assert np.max(np.abs(motion(times)[0] - motion.precise(times, 20)[0].astype(float))) < 1e-15


def test_engines_agree_on_the_time():
    for case in CASES:
        times = [last_time(TorqueFreeMotion(*CASES[case], engine=x)) for x in engines.ENGINES]
        assert times[0] == pytest.approx(times[1], rel=1e-12)


def test_grids_end_there_too():
    c = exactly("c")
    prepared = c.prepare(GENERAL, (5e-324, 1.0, 0.0), (1.0, 0.0, 0.0, 0.0))
    assert c.grid(prepared, 0.0, 1.0, 500)[0].shape == (500, 4)
    with pytest.raises(ValueError, match=r"^t: nearer to the separatrix"):
        c.grid(prepared, 0.0, 10.0, 500)


def test_one_of_many_does_not_stop_the_others(engine):
    rates = np.array([[5e-324, 1.0, 0.0], [0.5, 1.0, 0.2]])
    with pytest.raises(InputError, match=r"^t\[1\] = 10000.0: nearer .* s \(body 0\)$"):
        propagate(GENERAL, rates, [1.0, 1e4], engine=engine)
    q, omega = propagate(GENERAL, rates, [1.0, 1e4], engine=engine, errors="nan")
    assert np.isnan(q[..., 0]).tolist() == np.isnan(omega[..., 0]).tolist()
    assert np.isnan(q[..., 0]).tolist() == [[False, True], [False, False]]
