"""Finite burns: their impulses, their instants, and where they lead what nothing corrects."""

import numpy as np
import pytest
from manoeuvre_flights import NOTHING, known, short

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight.actuators import Burns, bursts, of_thrusters, of_wheels
from rigidsym.manoeuvre.flight.rotation import matrix
from rigidsym.manoeuvre.flight.settings import Thrusters

ALONE = {"controller": {"natural_frequency": 0.0}, "disturbances": NOTHING}
IMPULSES = np.array([[2e-3, -1e-3, 0.0], [-1e-3, 1e-3, 5e-4]])


def flown(thrusters, omega0=(0.01, 0.02, -0.01), duration=30, **parts):
    asked, transfer = known(duration, omega0)
    settings = short(duration + 5, thrusters=thrusters, **(ALONE | parts))
    return fly(asked, settings, transfer)


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
    errors = [flown(Thrusters(torque, 0.0)).last_burn()["error"] for torque in (1e-3, 4e-3, 0.1)]
    assert errors[0] > 3 * errors[1] > 9 * errors[2]
    late = flown(Thrusters(centred=False)).last_burn()["error"]
    assert late > 2 * errors[0]


def test_thrusters_push_against_the_outside():
    run = flown(Thrusters())
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
    run = flown(Thrusters(), controller={"natural_frequency": 0.3, "feedforward": True})
    assert run.error[-1] < flown(Thrusters()).error[-1] / 5
    assert np.abs(run.wheel_momentum).max() < 0.1 * np.abs(run.burns.impulses).max()


def test_bursts_ahead_of_errors():
    """Wheels that know the bursts stay near the motion, and their torque is that of the bursts."""
    asked, transfer = known(duration=60)
    ahead = {"feedforward": True, "track_feedforward": True}
    plain = fly(asked, short(80, disturbances=NOTHING), transfer)
    better = fly(asked, short(80, disturbances=NOTHING, controller=ahead), transfer)
    assert better.tracking()["max"] < plain.tracking()["max"] / 10
    # What thrusters would exert: all but the gyroscopic torque of the wheels.
    exerted = better.torque - np.cross(better.omega, better.wheel_momentum)
    summed = np.trapezoid(np.abs(exerted), better.t, axis=0).sum()
    assert summed == pytest.approx(np.abs(bursts(asked, transfer)).sum(), rel=0.05)
    assert np.abs(better.torque).max() <= 1e-3
