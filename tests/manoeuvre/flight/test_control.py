from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import pytest
from manoeuvre_flights import known

from rigidsym.manoeuvre.flight._control import (
    Wanted,
    feedback,
    feedforward,
    reference,
    torques,
)
from rigidsym.manoeuvre.flight._rotation import angle, cross, matrix, relative
from rigidsym.manoeuvre.flight._settings import Controller

INERTIA = np.array([1.0, 2.0, 3.0])
STILL = np.zeros(3)
IDENTITY = np.array([1.0, 0, 0, 0])
GAINS = Controller(natural_frequency=0.5, damping_ratio=0.7)


def command(controller, state, wanted, torque=STILL):
    """Both parts of what is told."""
    q, omega, momentum = state
    aim = Wanted(*wanted, torque)
    known_ahead = feedforward(controller, q, omega, momentum, aim)
    return feedback(controller, INERTIA, q, omega, aim) + known_ahead


def about_axis_1(degrees):
    half = np.radians(degrees) / 2
    return np.array([np.cos(half), np.sin(half), 0, 0])


def test_proportional():
    found = command(GAINS, (about_axis_1(1.0), STILL, STILL), (IDENTITY, STILL))
    np.testing.assert_allclose(found, [-0.25 * 2 * np.sin(np.radians(0.5)), 0, 0])


def test_derivative():
    found = command(GAINS, (IDENTITY, STILL, STILL), (IDENTITY, np.array([0, 0.1, 0.2])))
    np.testing.assert_allclose(found, [0, 2 * 0.7 * 0.5 * 2 * 0.1, 2 * 0.7 * 0.5 * 3 * 0.2])


@pytest.mark.parametrize("sign", [1, -1])
def test_the_shorter_way_back(sign):
    found = command(GAINS, (sign * about_axis_1(350.0), STILL, STILL), (IDENTITY, STILL))
    assert found[0] > 0


def test_rates_are_compared_in_the_same_axes():
    q = about_axis_1(90.0)
    # Turned by 90 degrees about axis 1, the body's axis 3 is minus the reference's axis 2.
    wanted = (IDENTITY, np.array([0, -0.1, 0]))
    found = command(GAINS, (q, np.array([0, 0, 0.1]), STILL), wanted)
    np.testing.assert_allclose(found, [-0.25 * np.sqrt(2), 0, 0], atol=1e-15)


def test_feedforward_is_the_wheels_gyroscopic_torque():
    stored, omega = np.array([0.1, 0.2, 0.3]), np.array([0.01, -0.02, 0.03])
    state, wanted = (IDENTITY, omega, stored), (IDENTITY, omega)
    np.testing.assert_allclose(
        command(Controller(feedforward=True), state, wanted), np.cross(omega, stored)
    )
    np.testing.assert_array_equal(command(Controller(), state, wanted), STILL)


def test_the_torque_of_the_track_is_turned_into_the_body():
    """By a quarter about axis 1, the body's axis 3 is minus the track's axis 2."""
    gains = Controller(natural_frequency=0.0, track_feedforward=True)
    state = about_axis_1(90.0), STILL, STILL
    found = command(gains, state, (IDENTITY, STILL), np.array([0, 0.1, 0]))
    np.testing.assert_allclose(found, [0, 0, -0.1], atol=1e-15)


def test_a_natural_motion_takes_no_torque():
    _, transfer = known(duration=60)
    inertia, t = np.array([0.0109, 0.04, 0.0506]), np.arange(-1, 70, 0.1)
    size = np.abs(inertia * transfer.motion(0.0)[1]).max()
    assert np.abs(torques(inertia, transfer, t)).max() < 1e-5 * size


def test_a_turn_takes_its_gyroscopic_torque_and_the_whole_change_of_its_momentum():
    axis, inertia = np.array([0.01, 0.02, 0.03]), np.array([0.0109, 0.04, 0.0506])
    t = np.arange(-10, 701) / 10
    rates = np.sin(t / 9)[:, None] * axis
    turn = Turn(60.0, lambda t: (np.zeros((len(t), 4)), np.sin(t / 9)[:, None] * axis))
    found = torques(inertia, turn, t)
    gyroscopic = np.cross(rates, inertia * rates)
    inside = (t > 0.1) & (t < 59.9)
    expected = inertia * np.cos(t / 9)[:, None] * axis / 9 + gyroscopic
    np.testing.assert_allclose(found[inside], expected[inside], atol=1e-8)
    assert not found[(t < -0.1) | (t > 60.1)].any()
    summed = np.trapezoid(found - np.where(inside[:, None], gyroscopic, 0), t, axis=0)
    np.testing.assert_allclose(summed, inertia * np.sin(60 / 9) * axis, rtol=1e-2)


@dataclass
class Turn:
    duration: float
    motion: Callable


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
