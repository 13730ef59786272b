from dataclasses import replace

import numpy as np
import pytest
from manoeuvre_flights import known

from rigidsym.manoeuvre.flight.control import along, command, reference
from rigidsym.manoeuvre.flight.rotation import angle, cross, matrix, relative
from rigidsym.manoeuvre.flight.settings import Controller

INERTIA = np.array([1.0, 2.0, 3.0])
STILL = np.zeros(3)
IDENTITY = np.array([1.0, 0, 0, 0])
GAINS = Controller(natural_frequency=0.5, damping_ratio=0.7)


def about_axis_1(degrees):
    half = np.radians(degrees) / 2
    return np.array([np.cos(half), np.sin(half), 0, 0])


def test_proportional():
    found = command(GAINS, INERTIA, (about_axis_1(1.0), STILL, STILL), (IDENTITY, STILL))
    np.testing.assert_allclose(found, [-0.25 * 2 * np.sin(np.radians(0.5)), 0, 0])


def test_derivative():
    found = command(GAINS, INERTIA, (IDENTITY, STILL, STILL), (IDENTITY, np.array([0, 0.1, 0.2])))
    np.testing.assert_allclose(found, [0, 2 * 0.7 * 0.5 * 2 * 0.1, 2 * 0.7 * 0.5 * 3 * 0.2])


@pytest.mark.parametrize("sign", [1, -1])
def test_the_shorter_way_back(sign):
    found = command(GAINS, INERTIA, (sign * about_axis_1(350.0), STILL, STILL), (IDENTITY, STILL))
    assert found[0] > 0


def test_rates_are_compared_in_the_same_axes():
    q = about_axis_1(90.0)
    # Turned by 90 degrees about axis 1, the body's axis 3 is minus the reference's axis 2.
    wanted = (IDENTITY, np.array([0, -0.1, 0]))
    found = command(GAINS, INERTIA, (q, np.array([0, 0, 0.1]), STILL), wanted)
    np.testing.assert_allclose(found, [-0.25 * np.sqrt(2), 0, 0], atol=1e-15)


def test_feedforward_is_the_wheels_gyroscopic_torque():
    stored, omega = np.array([0.1, 0.2, 0.3]), np.array([0.01, -0.02, 0.03])
    state, wanted = (IDENTITY, omega, stored), (IDENTITY, omega)
    np.testing.assert_allclose(
        command(Controller(feedforward=True), INERTIA, state, wanted), np.cross(omega, stored)
    )
    np.testing.assert_array_equal(command(Controller(), INERTIA, state, wanted), STILL)


def test_the_target_follows_without_a_jump():
    asked, transfer = known(duration=300)
    t = np.linspace(0, 400, 4001)
    wanted = reference(asked, transfer, t)
    assert np.max(np.abs(np.diff(wanted.q, axis=0))) < 2e-3
    assert np.all(wanted.omega[t >= 300] == 0)
    np.testing.assert_array_equal(wanted.q[t < 300], along(transfer, t).q[t < 300])


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
