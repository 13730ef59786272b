"""States between the times that were asked for."""

import numpy as np
import pytest

import rigidsym
from rigidsym.errors import InputError


@pytest.fixture(scope="module")
def trajectory(pushed):
    return rigidsym.integrate(*pushed.arguments, step=0.5, method="bm6")


def test_it_is_attitudes_and_rates(trajectory):
    q, omega = trajectory
    assert q is trajectory.q
    assert omega is trajectory.omega


def test_between_times_it_is_as_good_as_at_them(trajectory, pushed):
    times = np.array([1.1, 1.5, 2.4, 2.5, 3.3, 5.0])
    every = rigidsym.integrate(*pushed.arguments[:4], [1.0, *times], step=0.5, method="bm6")
    q, omega = trajectory(times)
    assert np.allclose(q, every.q[1:], rtol=0, atol=1e-5)
    assert np.allclose(omega, every.omega[1:], rtol=0, atol=1e-5)


def test_at_its_own_times_it_is_what_it_has(trajectory):
    q, omega = trajectory(trajectory.times)
    assert np.array_equal(q, trajectory.q)
    assert np.array_equal(omega, trajectory.omega)


def test_times_may_come_in_any_order(trajectory):
    times = np.array([4.0, 1.2, 2.6, 1.2])
    q, _ = trajectory(times)
    assert np.array_equal(q[::-1], trajectory(times[::-1])[0])


def test_a_number_is_one_state(trajectory):
    q, omega = trajectory(2.0)
    assert q.shape == (4,)
    assert omega.shape == (3,)
    assert np.array_equal(q, trajectory([2.0])[0][0])


@pytest.mark.parametrize("t", [0.5, [2.0, 5.5], [[2.0]], "soon"])
def test_other_times_are_refused(trajectory, t):
    with pytest.raises(InputError, match=r"^t(\[\d\])? = "):
        trajectory(t)
