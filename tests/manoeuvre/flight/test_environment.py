"""What surrounds a flight is a torque for splitting methods."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import rigidsym
from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import Environment, Flight
from rigidsym.validate.peers.integrators import rates

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
