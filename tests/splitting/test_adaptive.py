"""Steps that a tolerance chooses."""

import numpy as np
import pytest

import rigidsym
from rigidsym.errors import PrecisionError


def rotation(p, q):
    return np.max(2 * np.linalg.norm(p - q, axis=-1))


def run(pushed, tolerance, method="bm4"):
    return rigidsym.integrate(*pushed.arguments, step=None, tolerance=tolerance, method=method)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_the_error_is_below_the_tolerance_and_near_its_estimate(pushed, reference, tolerance):
    found = run(pushed, tolerance)
    truth = rotation(found.q, reference[0])
    assert found.error <= tolerance
    assert truth <= tolerance
    assert found.error / 10 < truth < 3 * found.error


def test_a_step_is_as_long_as_the_tolerance_lets_it(pushed, reference):
    found = run(pushed, 1e-5)
    twice = rigidsym.integrate(*pushed.arguments, step=2 * found.step, method="bm4")
    assert rotation(twice.q, reference[0]) > 1e-5


def test_all_evaluations_are_counted(pushed):
    found = run(pushed, 1e-3)
    last = rigidsym.integrate(*pushed.arguments, step=found.step, method="bm4")
    assert last.evaluations < found.evaluations < 3 * last.evaluations


def test_a_given_step_has_no_estimate(pushed):
    assert rigidsym.integrate(*pushed.arguments, step=0.5).error is None


def test_a_body_at_rest_is_moved_by_its_torque(pushed):
    found = rigidsym.integrate(
        pushed.inertia, pushed.q0, (0.0, 0.0, 0.0), pushed.torque, [0.0, 1.0], step=None
    )
    assert found.error <= 1e-6
    assert np.all(found.omega[-1] != 0)


def noise():
    """Another torque at each call, which no step resolves."""
    random = np.random.default_rng(1)
    return lambda t, q, omega: random.normal(size=omega.shape)


def test_what_no_step_reaches_is_refused_and_the_best_is_kept(pushed):
    start = pushed.inertia, pushed.q0, pushed.omega0, noise(), [0.0, 0.5]
    with pytest.raises(PrecisionError, match="tolerance = 1e-09: no step reaches it") as refused:
        rigidsym.integrate(*start, step=None, tolerance=1e-9, method="strang", rate_dependent=True)
    best = refused.value.trajectory
    assert 1e-9 < best.error < 0.1
    assert best.times.tolist() == [0.0, 0.5]
