"""Tests of the reference, of feedback and feedforward, and of rotations of single vectors."""

from dataclasses import replace

import numpy as np
import pytest
from manoeuvre_flights import MOMENTS, known

from rigidsym.manoeuvre.flight._control import (
    Track,
    Wanted,
    feedback,
    feedforward,
    reference,
    torques,
)
from rigidsym.manoeuvre.flight._rotation import angle, cross, matrix, relative
from rigidsym.manoeuvre.flight._settings import Controller

INERTIA = np.array([1.0, 2.0, 3.0])
STILL, IDENTITY = np.zeros(3), np.array([1.0, 0, 0, 0])
GAINS = Controller(natural_frequency=0.5, damping_ratio=0.7)
RATES, STORED = np.array([0.01, -0.02, 0.03]), np.array([0.1, 0.2, 0.3])


def about_axis_1(degrees):
    half = np.radians(degrees) / 2
    return np.array([np.cos(half), np.sin(half), 0, 0])


QUARTER = about_axis_1(90.0)


@pytest.mark.parametrize(
    ("controller", "state", "wanted", "expected"),
    [
        # Proportional, and derivative.
        (
            GAINS, (about_axis_1(1.0), STILL, STILL), (IDENTITY, STILL, STILL),
            [-0.25 * 2 * np.sin(np.radians(0.5)), 0, 0],
        ),
        (
            GAINS, (IDENTITY, STILL, STILL), (IDENTITY, np.array([0, 0.1, 0.2]), STILL),
            [0, 2 * 0.7 * 0.5 * 2 * 0.1, 2 * 0.7 * 0.5 * 3 * 0.2],
        ),
        # Turned by 90 degrees about axis 1, the body's axis 3 is minus the reference's axis 2.
        (
            GAINS, (QUARTER, np.array([0, 0, 0.1]), STILL),
            (IDENTITY, np.array([0, -0.1, 0]), STILL), [-0.25 * np.sqrt(2), 0, 0],
        ),
        (
            Controller(natural_frequency=0.0, track_feedforward=True), (QUARTER, STILL, STILL),
            (IDENTITY, STILL, np.array([0, 0.1, 0])), [0, 0, -0.1],
        ),
        # The wheels' gyroscopic torque.
        (
            Controller(feedforward=True), (IDENTITY, RATES, STORED), (IDENTITY, RATES, STILL),
            np.cross(RATES, STORED),
        ),
    ],
    ids=["proportional", "derivative", "same axes", "track's torque", "gyroscopic"],
)  # fmt: skip
def test_commands_are_those_worked_out_by_hand(controller, state, wanted, expected):
    np.testing.assert_allclose(command(controller, state, wanted), expected, atol=1e-15)


def command(controller, state, wanted):
    """Return the sum of feedback and feedforward."""
    q, omega, momentum = state
    known_ahead = feedforward(controller, q, omega, momentum, Wanted(*wanted))
    return feedback(controller, INERTIA, q, omega, Wanted(*wanted)) + known_ahead


def test_without_errors_and_feedforward_nothing_is_commanded():
    found = command(Controller(), (IDENTITY, RATES, STORED), (IDENTITY, RATES, STILL))
    np.testing.assert_array_equal(found, STILL)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_shorter_way_back(sign):
    state = sign * about_axis_1(350.0), STILL, STILL
    assert command(GAINS, state, (IDENTITY, STILL, STILL))[0] > 0


def test_a_natural_motion_takes_no_torque():
    _, transfer = known(duration=60)
    size = np.abs(MOMENTS * transfer.motion(0.0)[1]).max()
    assert np.abs(torques(MOMENTS, transfer, np.arange(-1, 70, 0.1))).max() < 1e-5 * size


def test_a_turn_takes_its_gyroscopic_torque_and_the_whole_change_of_its_momentum():
    axis, t = np.array([0.01, 0.02, 0.03]), np.arange(-10, 701) / 10
    rates = np.sin(t / 9)[:, None] * axis
    turn = Track(60.0, lambda t: (np.zeros((len(t), 4)), np.sin(t / 9)[:, None] * axis))
    found = torques(MOMENTS, turn, t)
    gyroscopic = np.cross(rates, MOMENTS * rates)
    inside = (t > 0.1) & (t < 59.9)
    expected = MOMENTS * np.cos(t / 9)[:, None] * axis / 9 + gyroscopic
    np.testing.assert_allclose(found[inside], expected[inside], atol=1e-8)
    assert not found[(t < -0.1) | (t > 60.1)].any()
    summed = np.trapezoid(found - np.where(inside[:, None], gyroscopic, 0), t, axis=0)
    np.testing.assert_allclose(summed, MOMENTS * np.sin(60 / 9) * axis, rtol=1e-2)


def test_the_target_follows_without_a_jump():
    asked, transfer = known(duration=300)
    t = np.linspace(0, 400, 4001)
    wanted = reference(asked, transfer, t)
    assert np.max(np.abs(np.diff(wanted.q, axis=0))) < 2e-3
    assert np.all(wanted.omega[t >= 300] == 0)
    np.testing.assert_array_equal(wanted.q[t < 300], transfer.motion(t)[0][t < 300])


@pytest.mark.parametrize("sign", [1, -1])
def test_of_two_quaternions_the_target_is_the_nearer(sign):
    asked, transfer = known(duration=20)
    turned = replace(asked, target=tuple(sign * x for x in asked.target))
    wanted = reference(turned, transfer, np.array([0.0, 19.9, 20.0, 30.0]))
    assert wanted.q[1] @ wanted.q[2] > 0.99


def test_a_target_that_spins_goes_on_as_a_free_body():
    asked, transfer = known(duration=20, target_spin=(0.01, 0.02, 0.03))
    wanted = reference(asked, transfer, np.array([20.0, 50.0]))
    np.testing.assert_allclose(wanted.omega[0], [0.01, 0.02, 0.03])
    assert angle(wanted.q[0], wanted.q[1]) > 0.5


def test_rotations():
    q, p = np.array([0.5, -0.5, 0.1, 0.7]), np.array([0.1, 0.9, -0.4, 0.1])
    p, q = p / np.linalg.norm(p), q / np.linalg.norm(q)
    np.testing.assert_allclose(matrix(q) @ matrix(q).T, np.eye(3), atol=1e-15)
    np.testing.assert_allclose(matrix(relative(p, q)), matrix(p).T @ matrix(q), atol=1e-15)
    turn = np.arccos((np.trace(matrix(p).T @ matrix(q)) - 1) / 2)
    assert angle(p, q) == pytest.approx(turn)
    assert angle(p, -p) < 1e-15
    np.testing.assert_allclose(cross([1, 2, 3], [-4, 5, 7]), np.cross([1, 2, 3], [-4, 5, 7]))
