"""Tests of finite burns, their impulses and instants, and of wheels and their limits."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from manoeuvre_flights import CALM, MOMENTS, NO_CONTROL, NOTHING, flown, known, short

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._actuators import Burns, bursts, next_torque, planned
from rigidsym.manoeuvre.flight._rotation import matrix
from rigidsym.manoeuvre.flight._settings import (
    LEAST_RATE,
    LONGEST,
    MOST_MOMENTUM,
    MOST_RATE,
    SHORTEST,
    Thrusters,
    Wheels,
)

IMPULSES = np.array([[2e-3, -1e-3, 0.0], [-1e-3, 1e-3, 5e-4]])
AHEAD = {"controller": {"track_feedforward": True}}


def burns(before=0.5):
    return Burns(np.array([0.0, 60.0]), IMPULSES, 1e-3, before)


def burnt(thrusters, **parts):
    """Fly for 35 s with thrusters, by default without feedback, along a motion of 30 s."""
    transfer = {"duration": 30, "omega0": (0.01, 0.02, -0.01)}
    alone = {"controller": NO_CONTROL, "disturbances": NOTHING}
    return flown(35, transfer=transfer, thrusters=thrusters, **(alone | parts))


@pytest.fixture(scope="module")
def alone():
    """A flight by the usual thrusters alone."""
    return burnt(Thrusters())


@pytest.mark.parametrize(("before", "begin"), [(0.5, -1.0), (0.0, 0.0)])
def test_spans(before, begin):
    found = burns(before)
    assert found.begin == begin
    length = np.diff(found.spans, axis=2)[..., 0]
    np.testing.assert_allclose(length, np.abs(IMPULSES) / 1e-3)
    starts = found.spans[..., 0] + before * length
    np.testing.assert_allclose(starts, [[0.0] * 3, [60.0] * 3], atol=1e-15)
    assert not found.overlap


def test_all_pieces_together_have_the_impulse():
    found = burns()
    pieces = found.pieces(-2.0, 62.0)
    assert pieces[0][0] == -2.0
    assert pieces[-1][1] == 62.0
    summed = sum((end - begin) * found.between(begin, end) for begin, end in pieces)
    np.testing.assert_allclose(summed, IMPULSES.sum(axis=0), atol=1e-18)
    sizes = np.abs([found.between(*piece) for piece in pieces])
    assert set(np.round(sizes, 12).ravel()) == {0.0, 1e-3}


def test_bursts_change_the_momentum_from_spin_to_spin():
    asked, transfer = known(start_spin=(0.01, 0, 0), target_spin=(0, 0.02, 0))
    _, omega = transfer.motion(np.array([0.0, 20.0]))
    expected = MOMENTS * [omega[0] - [0.01, 0, 0], [0, 0.02, 0] - omega[1]]
    np.testing.assert_allclose(bursts(asked, transfer), expected)


def test_the_minimum_impulse():
    asked, transfer = known()
    wanted = np.abs(bursts(asked, transfer))
    least = float(1.5 * wanted.min())
    found = np.abs(planned(short(thrusters=Thrusters(1e-3, least)), asked, transfer).impulses)
    np.testing.assert_allclose(found, np.where(2 * wanted < least, 0, np.maximum(wanted, least)))
    assert (found >= least).any()
    assert found.min() == least
    none = planned(short(thrusters=Thrusters(1e-3, 1.0)), asked, transfer)
    assert not none.impulses.any()


@pytest.mark.parametrize(
    ("field", "settings"),
    [
        ("thrusters.torque", {"thrusters": Thrusters(1e-5)}),
        ("wheels.max_torque", {"wheels": {"max_torque": 1e-5}, **AHEAD}),
    ],
)
def test_burns_that_last_too_long_are_refused(field, settings):
    asked, transfer = known(duration=3)
    with pytest.raises(InputError, match=rf"{field} = .*e-0.: makes burns of .* s, too long"):
        fly(asked, short(**settings), transfer)


@pytest.mark.parametrize(
    ("settings", "torque"),
    [({}, None), (AHEAD, 8e-4), ({"thrusters": Thrusters(2e-3), **AHEAD}, 2e-3)],
)
def test_thrusters_burn_or_wheels_that_feed_the_track_forward(settings, torque):
    found = planned(short(**settings), *known())
    assert (found and found.torque) == torque


def test_the_shorter_the_burns_the_nearer():
    """Errors are in proportion to the length of centred burns; late burns miss by more."""
    errors = [burnt(Thrusters(torque, 0.0)).last_burn()["error"] for torque in (1e-3, 4e-3, 0.1)]
    assert errors[0] > 3 * errors[1] > 9 * errors[2]
    late = burnt(Thrusters(centred=False)).last_burn()["error"]
    assert late > 2 * errors[0]


def test_thrusters_push_against_the_outside(alone):
    run = alone
    assert run.t[0] <= run.burns.begin < 0
    assert run.t[0] == pytest.approx(np.floor(10 * run.burns.begin) / 10)
    np.testing.assert_array_equal(run.wheel_momentum, np.zeros_like(run.wheel_momentum))
    assert run.momentum_defect() < 1e-12 * np.abs(run.impulse).max()
    # Between the bursts the momentum stays where the first one brought it.
    coast = (run.t > 5) & (run.t < 25)
    states = zip(run.q[coast], (run.inertia * run.omega)[coast], strict=True)
    whole = np.array([matrix(q) @ m for q, m in states])
    np.testing.assert_allclose(whole, whole[:1].repeat(len(whole), 0), rtol=0, atol=1e-13)


def test_wheels_take_what_thrusters_leave(alone):
    run = burnt(Thrusters(), controller={"natural_frequency": 0.3, "feedforward": True})
    assert run.error[-1] < alone.error[-1] / 5
    assert np.abs(run.wheel_momentum).max() < 0.1 * np.abs(run.burns.impulses).max()


def test_bursts_ahead_of_errors():
    """Wheels that know the bursts stay near the motion, and their torque is that of the bursts."""
    ahead = {"feedforward": True, "track_feedforward": True}
    plain, better = (
        flown(80, transfer={"duration": 60}, controller=gains, **CALM) for gains in ({}, ahead)
    )
    assert better.tracking()["max"] < plain.tracking()["max"] / 10
    # What thrusters would exert: all but the gyroscopic torque of the wheels.
    exerted = better.torque - np.cross(better.omega, better.wheel_momentum)
    summed = np.trapezoid(np.abs(exerted), better.t, axis=0).sum()
    assert summed == pytest.approx(np.abs(bursts(*known(duration=60))).sum(), rel=0.05)
    assert np.abs(better.torque).max() <= 1e-3


@pytest.mark.parametrize(
    ("torque", "command", "expected"),
    [(0.0, 5e-4, 5e-4), (0.0, 2e-3, 1e-3), (9e-4, -1.0, -1e-4), (-1e-3, -2.0, -1e-3)],
)
def test_torque_and_its_rate_are_limited(torque, command, expected):
    told = next_torque(Wheels(), np.full(3, torque), np.zeros(3), np.full(3, command), 0.1)
    np.testing.assert_allclose(told, expected)


def turned(wheels, commands, period):
    """Yield torque before, torque after and momentum of wheels under commands in turn."""
    torque, momentum = np.zeros(3), np.zeros(3)
    for command in commands:
        then = next_torque(wheels, torque, momentum, command, period)
        momentum = momentum - period * (torque + then) / 2
        yield torque, then, momentum
        torque = then


@given(st.lists(st.floats(-2e-3, 2e-3), min_size=1, max_size=60), st.sampled_from([0.02, 0.1, 1.0]))
def test_no_wheel_stores_more_than_it_can(commands, period):
    wheels = Wheels(max_momentum=2e-4)
    told = [command * np.array([1.0, -1.0, 0.3]) for command in commands]
    for torque, then, momentum in turned(wheels, told, period):
        assert np.all(np.abs(then) <= wheels.max_torque)
        assert np.all(np.abs(then - torque) <= wheels.max_torque_rate * period * (1 + 1e-12))
        assert np.all(np.abs(momentum) <= 2e-4 * (1 + 1e-9))


def test_a_wheel_can_be_filled():
    *_, (_, torque, momentum) = turned(Wheels(max_momentum=2e-4), [np.full(3, -1e-3)] * 400, 0.01)
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
