"""Every kind of time and number, on both engines; what is refused, and what it costs."""

import copy
import pickle
import tracemalloc
import warnings
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion, generate, propagate

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
ENGINES = ["numpy", "c"]


@pytest.fixture(params=ENGINES)
def engine(request):
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        try:
            TorqueFreeMotion(BODY, RATES, engine=request.param)(0.5)
        except RuntimeWarning as warning:
            pytest.skip(str(warning))
    return request.param


@pytest.mark.parametrize(
    "t", [2, 2.0, np.float64(2), np.float32(2), np.int16(2), np.array(2.0), Fraction(2), "2"]
)
def test_one_time_of_any_kind(t, engine):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    q, omega = motion(t)
    assert (q.shape, omega.shape) == ((4,), (3,))
    exact = motion.precise(2, 25)
    np.testing.assert_allclose(q, exact[0].astype(float), rtol=0, atol=1e-15)
    np.testing.assert_allclose(omega, exact[1].astype(float), rtol=0, atol=1e-16)


def test_motions_can_be_copied_and_sent_elsewhere(engine):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    expected = motion([1.0, 2.0])
    for other in (copy.copy(motion), copy.deepcopy(motion), pickle.loads(pickle.dumps(motion))):
        for a, b in zip(other([1.0, 2.0]), expected, strict=True):
            np.testing.assert_array_equal(a, b)


def test_memory_beyond_the_output_is_small_for_any_number_of_times(engine):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    t = np.linspace(0, 100, 2_000_000)
    out = np.empty((t.size, 4)), np.empty((t.size, 3))
    motion(0.0)
    tracemalloc.start()
    assert motion(t, out)[0] is out[0]
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 12e6  # less than one more array of times


@pytest.mark.parametrize(
    ("inertia", "omega0"),
    [
        (("1.1", "2.2", "2.2"), ("1e-140", "1", "0")),
        (("2.2", "1.1", "2.2"), ("1", "0", "1e-140")),
        (("1.1", "1.1", "1e-50"), ("0.1", "0.2", "0.3")),
        (("1.1e305", "1.5e305", "1.2e305"), ("0.1", "0.2", "0.3")),
        (("1.1e-305", "1.5e-305", "1.2e-305"), ("0.1", "0.2", "0.3")),
        (("1", "2", "2.5"), ("1e-307", "2e-307", "3e-307")),
    ],
)
def test_decimals_anywhere_in_the_range_of_doubles(inertia, omega0, engine):
    motion = TorqueFreeMotion(inertia, omega0, engine=engine)
    times = [0.5, 3.0]
    exact = motion.precise(times, 25)
    np.testing.assert_allclose(motion(times)[0], exact[0].astype(float), rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("inertia", "omega0", "message"),
    [
        (("1.1", "1.1", "1e-70"), ("1", "1", "1"), "inertia = .*differ by more than binary64"),
        (("1.1", "1.2", "1.3"), ("1e-330", "0", "1e-330"), "omega0 = .*beyond the range"),
        (("1.1", "1.2", "1.3"), ("1e309", "0", "1"), "omega0 = .*beyond the range"),
    ],
)
def test_decimals_that_doubles_cannot_hold(inertia, omega0, message, engine):
    with pytest.raises(InputError, match=message):
        TorqueFreeMotion(inertia, omega0, engine=engine)(1.0)


def test_a_batch_names_the_body_and_the_time_it_is_refused_for(engine):
    rates = np.tile(RATES, (3, 4, 1))
    rates[1, 2] = (1e-130, 1.0, 1e-135)
    rule = r"nearer to the separatrix than binary64 can follow beyond \d+\.\d+ s \(body 1, 2\)"
    with pytest.raises(InputError, match=rf"^t\[1\] = 5000.0: {rule}$"):
        propagate((1.0, 2.0, 2.5), rates, [1.0, 5e3, 6e3], engine=engine)
    rates[2, 1] = (1e307, 1e306, 1e305)
    with pytest.raises(InputError, match=r"^omega0\[2, 1\] = \[1.*: rates beyond"):
        propagate((1.0, 2.0, 2.5), rates, [0.0], engine=engine)


def test_engines_and_targets_that_do_not_exist():
    with pytest.raises(InputError, match="engine = 'fortran': must be one of: numpy, c"):
        TorqueFreeMotion(BODY, RATES, engine="fortran")
    with pytest.raises(InputError, match=r"target = \['c'\]: must be one of: numpy, c"):
        generate(["c"])
    with pytest.raises(InputError, match="engine = 'rust': must be one of"):
        propagate(BODY, RATES, 1.0, engine="rust")
