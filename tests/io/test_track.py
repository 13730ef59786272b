"""Tracks: what they keep, and what they refuse."""

import math

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io import Track, sampled

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
