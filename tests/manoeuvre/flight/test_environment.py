"""Tests of each disturbance by values worked out by hand, and of their sum as a torque."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import rigidsym
from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import Environment, Flight
from rigidsym.manoeuvre.flight._environment import LAYERS, Box, density, dipole, drag, radiation
from rigidsym.manoeuvre.flight._sky import ASTRONOMICAL_UNIT, MU
from rigidsym.splitting import Tide
from rigidsym.validate.peers._integrators import rates

INERTIA = np.array([0.0109, 0.04, 0.0506])
START, OMEGA0 = [1.0, 0.0, 0.0, 0.0], [0.05, 0.03, -0.02]


@pytest.fixture(scope="module")
def around():
    return Environment(Flight(), INERTIA)


def test_a_body_flies_through_it_as_another_integrator_says(around):
    def derivative(t, y):
        found = np.array(rates(y, INERTIA))
        found[4:] += around.total(t, y[:4] / np.linalg.norm(y[:4])) / INERTIA
        return found

    span = (0.0, 20.0)
    start = [*START, *OMEGA0]
    truth = solve_ivp(derivative, span, start, "DOP853", rtol=1e-11, atol=1e-13).y[:, -1]
    found = rigidsym.integrate(INERTIA, START, OMEGA0, around, span, step=2.0, method="aba84")
    free = rigidsym.propagate(INERTIA, OMEGA0, span, START)
    assert np.max(np.abs(found.q[-1] - truth[:4])) < 1e-7
    assert np.max(np.abs(free[0][-1] - truth[:4])) > 1e-4


def test_it_pushes_each_of_many(around):
    q = np.array([START, [0.5, 0.5, -0.5, 0.5]])
    both = around(3.0, q, np.zeros((2, 3)))
    assert np.array_equal(both, [around.total(3.0, x) for x in q])
    assert not np.array_equal(both[0], both[1])


@pytest.mark.parametrize("t", [-1.0, 181.0])
def test_beyond_the_flight_nothing_is_known(around, t):
    with pytest.raises(InputError, match=r"^t = .*must be of the flight, 0 to 180 s"):
        around(t, np.array(START), np.zeros(3))


CUBE = Box((1.0, 1.0, 1.0), (0.0, 0.1, 0.0))
DIRECTIONS = np.array([[1, 0, 0], [0, -1, 0], [1, 1, 1], [-3, 1, 2], [0.2, -5, 0.1], [-1, -2, 4]])
PRESSURE = 4.539806e-06  # 1361 / 299792458 N/m^2
TIDE, SUN = Tide(MU, np.array([1.0, 2.0, 3.0])), np.array([ASTRONOMICAL_UNIT, 0, 0])


@pytest.mark.parametrize(
    ("torque", "expected", "rtol", "atol"),
    [
        # 3 * 3.986004418e14 / (7e6)^3 * (2 - 1) / 2
        (TIDE(7e6 / np.sqrt(2) * np.array([1.0, 1.0, 0.0])), [0, 0, 1.7431507e-06], 1e-7, 0),
        *((TIDE(7e6 * axis), np.zeros(3), 0, 0) for axis in np.eye(3)),
        (dipole((0.5, 0.0, 0.0), np.array([1e-5, 2e-5, -3e-5])), [0, 1.5e-5, 1e-5], 1e-7, 0),
        # The face at x = 1/2 feels 1/2 1e-13 2 7500^2 = 5.625e-6 N along -x, 0.1 m off the centre.
        (drag(CUBE, np.array([7500.0, 0, 0]), 1e-13, 2.0), [0, 0, 5.625e-7], 1e-7, 1e-20),
        *(
            (
                radiation(CUBE, SUN, 1.0, specular, diffuse),
                [0, 0, 0.1 * times * PRESSURE],
                1e-6,
                1e-20,
            )
            for specular, diffuse, times in ((0, 0, 1), (1, 0, 2), (0, 1, 5 / 3), (0.3, 0.3, 1.5))
        ),
        (radiation(CUBE, SUN, 0.0, 0.1, 0.2), np.zeros(3), 0, 0),
    ],
)
def test_torques_by_hand(torque, expected, rtol, atol):
    np.testing.assert_allclose(torque, expected, rtol=rtol, atol=atol)


@pytest.mark.parametrize("direction", DIRECTIONS)
@pytest.mark.parametrize("offset", [(0.0, 0.0, 0.0), (0.02, -0.01, 0.03)])
def test_drag_by_the_force_and_the_lever(direction, offset):
    """Air meets as much on one side of the line through the middle as on the other."""
    v = 7500 * direction / np.linalg.norm(direction)
    area = abs(v / 7500) @ [0.1 * 0.2, 0.2 * 0.3, 0.3 * 0.1]
    force = -0.5 * 1e-13 * 2.2 * 7500 * v * area
    found = drag(Box((0.3, 0.1, 0.2), offset), v, 1e-13, 2.2)
    np.testing.assert_allclose(found, np.cross(offset, force), rtol=1e-12, atol=1e-22)


def test_radiation_by_distance_and_shadow():
    sun = np.array([0.4, -0.7, 0.2]) * ASTRONOMICAL_UNIT
    full = radiation(CUBE, sun, 1.0, 0.1, 0.2)
    np.testing.assert_allclose(radiation(CUBE, 2 * sun, 1.0, 0.1, 0.2), full / 4)
    np.testing.assert_allclose(radiation(CUBE, sun, 0.25, 0.1, 0.2), full / 4)


def test_a_mirror_is_pushed_along_its_normal():
    # Light at 60 degrees to the normal of the face y = 1/2: 2 P A cos^2 = P / 2, at x = 0.2.
    plate = Box((1.0, 1e-9, 1.0), (0.2, 0.0, 0.0))
    sun = ASTRONOMICAL_UNIT * np.array([0, 0.5, np.sqrt(0.75)])
    found = radiation(plate, sun, 1.0, 1.0, 0.0)
    np.testing.assert_allclose(found, [0, 0, -0.2 * PRESSURE / 2], rtol=1e-6, atol=1e-14)


def test_density():
    assert (density(600.0), density(0.0)) == (1.454e-13, 1.225)
    assert density(650.0) == pytest.approx(1.454e-13 * np.exp(-50 / 71.835))
    assert density(2000.0) == pytest.approx(3.019e-15 * np.exp(-1000 / 268))


@pytest.mark.parametrize("height", [layer[0] for layer in LAYERS[1:]])
def test_layers_meet(height):
    assert density(height - 1e-9) == pytest.approx(density(height), rel=0.01)
