"""Tests of the classical angles in the paper's Figure 1, by the library's attitudes."""

import numpy as np
import pytest

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre._figures import difference, euler_angles
from rigidsym.manoeuvre.flight._rotation import matrix

INERTIA = (0.0109, 0.04, 0.0506)
MOTIONS = {
    "about the smallest": TorqueFreeMotion(INERTIA, (0.05, 0.03, -0.02)),
    "about the largest": TorqueFreeMotion(INERTIA, (0.01, 0.02, 0.05), (0.3, -0.4, 0.5, 0.7)),
    "downwards": TorqueFreeMotion(INERTIA, (0.01, -0.02, -0.05), (0.1, 0.4, 0.5, -0.7)),
    "symmetric": TorqueFreeMotion((0.03, 0.03, 0.05), (0.02, -0.01, 0.04)),
    "spherical": TorqueFreeMotion((1, 1, 1), (0.02, -0.01, 0.04)),
}


@pytest.fixture
def steady():
    """Angles of a symmetric body at 0, 0.1, .., 100 s."""
    return euler_angles(MOTIONS["symmetric"], np.linspace(0, 100, 1001))


@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS)
def test_the_angles_are_the_attitude(motion):
    t = np.linspace(0, 300, 601)
    angles = euler_angles(motion, t)
    assert difference(motion, t, angles) < 1e-12
    assert np.all((angles.nutation >= 0) & (angles.nutation <= np.pi))
    for angle in (angles.precession, angles.spin):
        assert np.all((angle > -np.pi) & (angle <= np.pi))


def test_the_quaternion_is_of_three_turns():
    angles = euler_angles(MOTIONS["downwards"], np.array([0.0, 7.0]))
    turns = zip(angles.precession, angles.nutation, angles.spin, strict=True)
    for q, (psi, theta, phi) in zip(angles.quaternion(), turns, strict=True):
        expected = about(2, psi) @ about(0, theta) @ about(2, phi)
        np.testing.assert_allclose(matrix(q), expected, atol=1e-14)


def about(axis, angle):
    q = np.zeros(4)
    q[0], q[1 + axis] = np.cos(angle / 2), np.sin(angle / 2)
    return matrix(q)


def test_a_symmetric_body_precesses_steadily(steady):
    size = np.linalg.norm([0.03 * 0.02, 0.03 * 0.01, 0.05 * 0.04])
    np.testing.assert_allclose(steady.nutation, np.arccos(0.05 * 0.04 / size), rtol=1e-12)
    precession, spin = (np.diff(np.unwrap(x)) / 0.1 for x in (steady.precession, steady.spin))
    np.testing.assert_allclose(precession, size / 0.03, rtol=1e-9)
    np.testing.assert_allclose(spin, 0.04 - 0.05 * 0.04 / 0.03, rtol=1e-9)


def test_jumps_are_counted(steady):
    whole = int(np.floor((np.unwrap(steady.precession)[-1] + np.pi) / (2 * np.pi)))
    assert steady.jumps()["precession"] == whole > 0
    assert steady.jumps()["nutation"] == 0
