"""Finite burns, their impulses and instants; wheels and their limits."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from manoeuvre_flights import NOTHING, flown, known, short

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._actuators import Burns, bursts, next_torque, of_thrusters, of_wheels
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

ALONE = {"controller": {"natural_frequency": 0.0}, "disturbances": NOTHING}
IMPULSES = np.array([[2e-3, -1e-3, 0.0], [-1e-3, 1e-3, 5e-4]])


def burnt(thrusters, **parts):
    """A flight of 35 s with thrusters, by default alone, along a motion of 30 s."""
    transfer = {"duration": 30, "omega0": (0.01, 0.02, -0.01)}
    return flown(35, transfer=transfer, thrusters=thrusters, **(ALONE | parts))


@pytest.mark.parametrize(("before", "begin"), [(0.5, -1.0), (0.0, 0.0)])
def test_spans(before, begin):
    burns = Burns(np.array([0.0, 60.0]), IMPULSES, 1e-3, before)
    assert burns.begin == begin
    length = np.diff(burns.spans, axis=2)[..., 0]
    np.testing.assert_allclose(length, np.abs(IMPULSES) / 1e-3)
    np.testing.assert_allclose(
        burns.spans[..., 0] + before * length, [[0.0] * 3, [60.0] * 3], atol=1e-15
    )
    assert not burns.overlap


def test_all_pieces_together_have_the_impulse():
    burns = Burns(np.array([0.0, 60.0]), IMPULSES, 1e-3)
    pieces = burns.pieces(-2.0, 62.0)
    assert pieces[0][0] == -2.0
    assert pieces[-1][1] == 62.0
    summed = sum((end - begin) * burns.between(begin, end) for begin, end in pieces)
    np.testing.assert_allclose(summed, IMPULSES.sum(axis=0), atol=1e-18)
    sizes = np.abs([burns.between(*piece) for piece in pieces])
    assert set(np.round(sizes, 12).ravel()) == {0.0, 1e-3}


def test_bursts_change_the_momentum_from_spin_to_spin():
    asked, transfer = known(start_spin=(0.01, 0, 0), target_spin=(0, 0.02, 0))
    inertia = np.array([float(x) for x in asked.inertia])
    _, omega = transfer.motion(np.array([0.0, 20.0]))
    expected = inertia * [omega[0] - [0.01, 0, 0], [0, 0.02, 0] - omega[1]]
    np.testing.assert_allclose(bursts(asked, transfer), expected)


def test_the_minimum_impulse():
    asked, transfer = known()
    wanted = np.abs(bursts(asked, transfer))
    least = float(1.5 * wanted.min())
    found = np.abs(of_thrusters(short(thrusters=Thrusters(1e-3, least)), asked, transfer).impulses)
    np.testing.assert_allclose(found, np.where(2 * wanted < least, 0, np.maximum(wanted, least)))
    assert (found >= least).any()
    assert found.min() == least
    none = of_thrusters(short(thrusters=Thrusters(1e-3, 1.0)), asked, transfer)
    assert not none.impulses.any()


def test_what_lasts_too_long():
    asked, transfer = known(duration=3)
    for field, settings in (
        ("thrusters.torque", short(thrusters=Thrusters(1e-5))),
        (
            "wheels.max_torque",
            short(wheels={"max_torque": 1e-5}, controller={"track_feedforward": True}),
        ),
    ):
        with pytest.raises(InputError, match=rf"{field} = .*e-0.: makes burns of .* s, too long"):
            fly(asked, settings, transfer)


def test_who_burns():
    asked, transfer = known()
    ahead = {"controller": {"track_feedforward": True}}
    assert of_wheels(short(), asked, transfer) is None
    assert of_thrusters(short(), asked, transfer) is None
    assert of_wheels(short(**ahead), asked, transfer).torque == 8e-4
    assert of_wheels(short(thrusters=Thrusters(), **ahead), asked, transfer) is None


def test_the_shorter_the_burns_the_nearer():
    """What is missed goes with the length of centred burns, and late ones miss by more."""
    errors = [burnt(Thrusters(torque, 0.0)).last_burn()["error"] for torque in (1e-3, 4e-3, 0.1)]
    assert errors[0] > 3 * errors[1] > 9 * errors[2]
    late = burnt(Thrusters(centred=False)).last_burn()["error"]
    assert late > 2 * errors[0]


def test_thrusters_push_against_the_outside():
    run = burnt(Thrusters())
    assert run.t[0] <= run.burns.begin < 0
    assert run.t[0] == pytest.approx(np.floor(10 * run.burns.begin) / 10)
    np.testing.assert_array_equal(run.wheel_momentum, np.zeros_like(run.wheel_momentum))
    assert run.momentum_defect() < 1e-12 * np.abs(run.impulse).max()
    # Between the bursts the momentum stays where the first one brought it.
    coast = (run.t > 5) & (run.t < 25)
    whole = [matrix(q) @ m for q, m in zip(run.q, run.inertia * run.omega, strict=True)]
    np.testing.assert_allclose(np.array(whole)[coast], np.array(whole)[coast][:1].repeat(200, 0)[
        : coast.sum()], rtol=0, atol=1e-13)  # fmt: skip


def test_wheels_take_what_thrusters_leave():
    run = burnt(Thrusters(), controller={"natural_frequency": 0.3, "feedforward": True})
    assert run.error[-1] < burnt(Thrusters()).error[-1] / 5
    assert np.abs(run.wheel_momentum).max() < 0.1 * np.abs(run.burns.impulses).max()


def test_bursts_ahead_of_errors():
    """Wheels that know the bursts stay near the motion, and their torque is that of the bursts."""
    ahead = {"feedforward": True, "track_feedforward": True}
    plain, better = (
        flown(80, transfer={"duration": 60}, disturbances=NOTHING, controller=gains)
        for gains in ({}, ahead)
    )
    assert better.tracking()["max"] < plain.tracking()["max"] / 10
    # What thrusters would exert: all but the gyroscopic torque of the wheels.
    exerted = better.torque - np.cross(better.omega, better.wheel_momentum)
    summed = np.trapezoid(np.abs(exerted), better.t, axis=0).sum()
    assert summed == pytest.approx(np.abs(bursts(*known(duration=60))).sum(), rel=0.05)
    assert np.abs(better.torque).max() <= 1e-3


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
