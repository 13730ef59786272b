"""Splines through tracks: how near they are, and how that falls with the step."""

import sys
from itertools import pairwise

import numpy as np
import pytest

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.io import Track, rotation_spline, sampled

MOTION = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), (0.05, 0.03, -0.02), (1, 2, -3, 4))
STEPS = (4.0, 2.0, 1.0)


def error(step, start, stop):
    """The largest angle between the spline over 160 s and the motion, from start to stop."""
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
