import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rigidsym.manoeuvre.flight.actuators import next_torque
from rigidsym.manoeuvre.flight.settings import (
    LEAST_RATE,
    LONGEST,
    MOST_MOMENTUM,
    MOST_RATE,
    SHORTEST,
    Wheels,
)

PAPER = Wheels()


@pytest.mark.parametrize(
    ("torque", "command", "expected"),
    [(0.0, 5e-4, 5e-4), (0.0, 2e-3, 1e-3), (9e-4, -1.0, -1e-4), (-1e-3, -2.0, -1e-3)],
)
def test_torque_and_its_rate_are_limited(torque, command, expected):
    told = next_torque(PAPER, np.full(3, torque), np.zeros(3), np.full(3, command), 0.1)
    np.testing.assert_allclose(told, expected)


@given(st.lists(st.floats(-2e-3, 2e-3), min_size=1, max_size=60), st.sampled_from([0.02, 0.1, 1.0]))
def test_no_wheel_stores_more_than_it_can(commands, period):
    wheels = Wheels(max_momentum=2e-4)
    torque, momentum = np.zeros(3), np.zeros(3)
    for command in commands:
        told = command * np.array([1.0, -1.0, 0.3])
        then = next_torque(wheels, torque, momentum, told, period)
        assert np.all(np.abs(then) <= wheels.max_torque)
        assert np.all(np.abs(then - torque) <= wheels.max_torque_rate * period * (1 + 1e-12))
        momentum = momentum - period * (torque + then) / 2
        torque = then
        assert np.all(np.abs(momentum) <= 2e-4 * (1 + 1e-9))


def test_a_wheel_can_be_filled():
    wheels, torque, momentum = Wheels(max_momentum=2e-4), np.zeros(3), np.zeros(3)
    for _ in range(400):
        then = next_torque(wheels, torque, momentum, np.full(3, -1e-3), 0.01)
        momentum = momentum - 0.01 * (torque + then) / 2
        torque = then
    np.testing.assert_allclose(momentum, 2e-4, rtol=0.01)
    np.testing.assert_allclose(torque, 0, atol=1e-7)


@pytest.mark.parametrize("period", [float(SHORTEST), LONGEST])
@pytest.mark.parametrize("most", [5e-324, 1.0, MOST_MOMENTUM])
@pytest.mark.parametrize("rate", [LEAST_RATE, MOST_RATE])
def test_what_files_may_ask_for_can_be_computed(rate, most, period):
    wheels = Wheels(max_torque_rate=rate, max_momentum=most)
    with np.errstate(over="raise", invalid="raise", divide="raise"):
        told = next_torque(wheels, np.zeros(3), np.zeros(3), np.array([1.0, 0, -1.0]), period)
    assert np.all(np.abs(told) <= wheels.max_torque)
