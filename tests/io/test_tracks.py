"""Tracks normalise and check their states; splines through them converge."""

import math
import sys
from itertools import pairwise

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io import Track, rotation_spline, sampled

INERTIA, OMEGA0 = ("0.0109", "0.04", "0.0506"), (0.05, 0.03, -0.02)
ONE, STILL = (1, 0, 0, 0), (0, 0, 0)


def test_a_motion_sampled_is_the_motion():
    motion = TorqueFreeMotion(INERTIA, OMEGA0, (1, 2, -3, 4))
    times = np.linspace(-20, 180, 101)
    track = sampled(motion, times)
    q, omega = motion(times)
    assert np.array_equal(track.times, times)
    assert np.max(np.abs(track.q - q)) < 5e-16
    assert np.array_equal(track.omega, omega)
    assert sampled(motion, 2.5).times.tolist() == [2.5]


def test_a_track_is_a_copy_and_normalised_with_its_signs():
    q = np.array([[-2.0, 0, 0, 0], [3e-200, -4e-200, 0, 0], [1e300, 0, 0, -1e300]])
    track = Track([0, 1, 2], q, np.zeros((3, 3)))
    q[:] = 9
    root = math.sqrt(0.5)
    assert np.allclose(track.q, [[-1, 0, 0, 0], [0.6, -0.8, 0, 0], [root, 0, 0, -root]], 0, 2e-16)


@pytest.mark.parametrize(
    ("times", "q", "omega", "message"),
    [
        ([], [], [], "times = an array of shape (0,): must be a list of at least one time"),
        ([[0.0]], [ONE], [STILL], "times = an array of shape (1, 1): must be a list of at least"),
        ([0, 2, 1], [ONE] * 3, [STILL] * 3, "times[2] = 1.0: must be later than the time before"),
        ([0, 0], [ONE] * 2, [STILL] * 2, "times[1] = 0.0: must be later than the time before it"),
        ([0, math.nan], [ONE] * 2, [STILL] * 2, "times[1] = nan: must be finite"),
        ([0], [(1, 0, 0, math.inf)], [STILL], "q[0, 3] = inf: must be finite"),
        ([0], [ONE], [(0, 0, math.nan)], "omega[0, 2] = nan: must be finite"),
        (math.inf, [ONE], [STILL], "times = inf: must be finite"),
        ([0], [ONE, ONE], [STILL], "q = an array of shape (2, 4): must have the shape (1, 4)"),
        ([0], [ONE], STILL, "omega = an array of shape (3,): must have the shape (1, 3)"),
        ([0], [(0, 0, 0, 0)], [STILL], "q[0] = [0.0, 0.0, 0.0, 0.0]: must not be zero"),
        (["now"], [ONE], [STILL], "times = ['now']: must be an array of numbers"),
        ([0], None, [STILL], "q = None: must be an array of numbers"),
        ([0, 1], [ONE, (1, 0)], [STILL], "must be an array of numbers"),
        ([True], [ONE], [STILL], "times = [True]: must be an array of numbers"),
    ],
)
def test_bad_tracks_are_one_line(times, q, omega, message):
    with pytest.raises(InputError) as refused:
        Track(times, q, omega)
    assert message in str(refused.value)
    assert len(str(refused.value).splitlines()) == 1


MOTION = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), (0.05, 0.03, -0.02), (1, 2, -3, 4))
STEPS = (4.0, 2.0, 1.0)


def error(step, start, stop):
    """Return the largest angle between spline and motion from start to stop."""
    spline = rotation_spline(sampled(MOTION, np.arange(0, 160 + step / 2, step)))
    t = np.linspace(start, stop, 801)
    return np.max((MOTION.rotation(t).inv() * spline(t)).magnitude())


def orders(start, stop):
    errors = np.array([error(step, start, stop) for step in STEPS])
    return np.log2(errors[:-1] / errors[1:])


def test_the_error_falls_as_the_fourth_power_of_the_step_but_at_the_ends():
    assert np.all(np.abs(orders(40, 120) - 4) < 0.3)
    assert np.all(np.abs(orders(0, 4) - 2) < 0.3)
    assert np.all(np.abs(orders(156, 160) - 2) < 0.3)


def test_what_the_ends_do_falls_by_four_with_each_interval():
    errors = [error(1.0, k, k + 1) for k in range(6)]
    assert all(3 < a / b < 5 for a, b in pairwise(errors))


def test_it_goes_through_the_track_and_knows_its_rates():
    track = sampled(MOTION, np.arange(0, 161, 1.0))
    spline = rotation_spline(track)
    assert np.max((MOTION.rotation(track.times).inv() * spline(track.times)).magnitude()) < 1e-14
    assert np.max(np.abs(spline(track.times, 1) - track.omega)[20:-20]) < 1e-7


def test_signs_of_quaternions_do_not_matter():
    track = sampled(MOTION, np.arange(0, 21, 1.0))
    signs = np.where(track.q[:, :1] < 0, -1, 1)
    other = Track(track.times, track.q * signs, track.omega)
    t = np.linspace(0, 20, 101)
    angles = (rotation_spline(track)(t).inv() * rotation_spline(other)(t)).magnitude()
    assert np.max(angles) < 1e-14


def test_too_few_and_too_far_are_refused():
    with pytest.raises(InputError, match=r"^times = \[3.0\]: a spline needs at least two times"):
        rotation_spline(sampled(MOTION, 3.0))
    with pytest.raises(InputError, match=r"^times\[2\] = 60.0: must be less than half a turn"):
        rotation_spline(sampled(MOTION, [0, 10, 60]))


def test_without_scipy_it_says_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.spatial.transform", None)
    with pytest.raises(ImportError, match=r"pip install 'rigidsym\[app\]'"):
        rotation_spline(sampled(MOTION, [0, 1]))
