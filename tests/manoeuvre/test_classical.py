"""Euler's angles of the classical solution against the library's attitudes and by definition."""

import numpy as np
import pytest

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre._classical import difference, euler_angles
from rigidsym.manoeuvre.flight._rotation import matrix

INERTIA = (0.0109, 0.04, 0.0506)
MOTIONS = {
    "about the smallest": TorqueFreeMotion(INERTIA, (0.05, 0.03, -0.02)),
    "about the largest": TorqueFreeMotion(INERTIA, (0.01, 0.02, 0.05), (0.3, -0.4, 0.5, 0.7)),
    "downwards": TorqueFreeMotion(INERTIA, (0.01, -0.02, -0.05), (0.1, 0.4, 0.5, -0.7)),
    "symmetric": TorqueFreeMotion((0.03, 0.03, 0.05), (0.02, -0.01, 0.04)),
    "spherical": TorqueFreeMotion((1, 1, 1), (0.02, -0.01, 0.04)),
}


@pytest.fixture(params=MOTIONS)
def motion(request):
    return MOTIONS[request.param]


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


def test_a_symmetric_body_precesses_steadily():
    t = np.linspace(0, 100, 1001)
    angles = euler_angles(MOTIONS["symmetric"], t)
    size = np.linalg.norm([0.03 * 0.02, 0.03 * 0.01, 0.05 * 0.04])
    np.testing.assert_allclose(angles.nutation, np.arccos(0.05 * 0.04 / size), rtol=1e-12)
    rate = np.diff(np.unwrap(angles.precession)) / 0.1
    np.testing.assert_allclose(rate, size / 0.03, rtol=1e-9)
    np.testing.assert_allclose(np.diff(np.unwrap(angles.spin)) / 0.1, 0.04 - size * (
        0.05 * 0.04 / size) / 0.03, rtol=1e-9)  # fmt: skip


def test_jumps_are_counted():
    t = np.linspace(0, 100, 1001)
    angles = euler_angles(MOTIONS["symmetric"], t)
    turned = np.unwrap(angles.precession)
    whole = int(np.floor((turned[-1] + np.pi) / (2 * np.pi)))
    assert angles.jumps()["precession"] == whole > 0
    assert angles.jumps()["nutation"] == 0
