"""The closed loop against physics: momentum, energy, limits, and the natural motion itself."""

import numpy as np
import pytest
from manoeuvre_flights import NOTHING, OMEGA0, flight, known, short

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight.rotation import angle, matrix
from rigidsym.manoeuvre.flight.settings import Flight

NO_CONTROL = {"natural_frequency": 0.0}


@pytest.fixture(scope="module")
def paper_like():
    """The paper's flight, along a motion that is known."""
    return fly(known(duration=120)[0], Flight(), known(duration=120)[1])


def test_without_torques_the_natural_motion_is_flown():
    asked, transfer = known(start_spin=OMEGA0)
    run = fly(asked, short(disturbances=NOTHING, controller=NO_CONTROL), transfer)
    q, omega = transfer.motion(run.t)
    np.testing.assert_allclose(run.q, q, atol=1e-12)
    np.testing.assert_allclose(run.omega, omega, atol=1e-14)
    np.testing.assert_array_equal(run.torque, np.zeros_like(run.torque))
    assert run.disturbances == {}


def test_with_feedforward_wheels_that_turn_are_not_felt():
    asked, transfer = known(start_spin=OMEGA0)
    wheels = {"momentum": (1e-3, -2e-3, 5e-4), "max_torque_rate": 1.0}
    settings = short(
        20, "0.01", disturbances=NOTHING, wheels=wheels, controller={"feedforward": True}
    )
    felt = short(20, "0.1", disturbances=NOTHING, wheels=wheels, controller=NO_CONTROL)
    error = fly(asked, settings, transfer).error[:-1]
    assert error.max() < 1e-4
    assert fly(asked, felt, transfer).error[:-1].max() > 0.05


def test_the_momentum_changes_by_the_disturbances_alone(paper_like):
    run = paper_like
    size = np.linalg.norm(run.inertia * run.track.omega[0])
    assert np.linalg.norm(run.impulse[-1]) > 1e-3 * size
    assert run.momentum_defect() < 1e-10 * size
    assert run.energy_defect() < 1e-10 * size * 0.02


def test_the_impulse_is_that_of_the_torques_recorded(paper_like):
    run = paper_like
    inertial = np.array(
        [
            matrix(q) @ sum(parts)
            for q, *parts in zip(run.q, *run.disturbances.values(), strict=True)
        ]
    )
    summed = np.trapezoid(inertial, run.t, axis=0)
    np.testing.assert_allclose(summed, run.impulse[-1], rtol=1e-4)


def test_no_momentum_from_nowhere():
    asked, transfer = known()
    run = fly(asked, short(disturbances=NOTHING), transfer)
    whole = run.inertia * run.omega + run.wheel_momentum
    # Spacecraft and wheels began at rest; the wheels turn against the body all the way.
    np.testing.assert_allclose(whole, np.zeros_like(whole), atol=1e-15)


def test_the_limits_of_the_wheels(paper_like):
    wheels = Flight().wheels
    for run in (paper_like, _hasty()):
        assert np.abs(run.torque).max() <= wheels.max_torque
        steps = np.abs(np.diff(run.torque, axis=0)) / np.diff(run.t)[:, None]
        assert steps.max() <= wheels.max_torque_rate * (1 + 1e-9)


def _hasty():
    """A loop that wants more than the wheels can do."""
    asked, transfer = known()
    run = fly(asked, short(30, controller={"natural_frequency": 3.0}), transfer)
    assert np.abs(run.torque).max() == Flight().wheels.max_torque
    return run


def test_wheels_that_are_full_give_no_more():
    asked, transfer = known()
    run = fly(asked, short(30, wheels={"max_momentum": 3e-4}), transfer)
    assert 2.9e-4 < np.abs(run.wheel_momentum).max() <= 3e-4 * (1 + 1e-9)
    assert run.momentum_defect() < 1e-13


def test_the_target_is_reached_and_held(paper_like):
    holding = paper_like.holding(np.radians(0.1))
    assert holding["final_error"] < np.radians(0.05)
    assert 120 < holding["settled_at"] < 150
    tracking = paper_like.tracking()
    assert tracking["last"] < tracking["max"] < np.radians(3)
    assert np.abs(paper_like.torque).max() < 6e-4


def test_attitudes_are_continuous_and_of_unit_length(paper_like):
    assert np.abs(np.diff(paper_like.q, axis=0)).max() < 2e-3
    np.testing.assert_allclose(np.linalg.norm(paper_like.q, axis=1), 1, rtol=1e-15)
    np.testing.assert_array_equal(paper_like.q[0], [1, 0, 0, 0])


def test_feedforward_follows_closer():
    asked, transfer = known(duration=60)
    plain, better = (
        fly(asked, short(60, disturbances=NOTHING, controller={"feedforward": on}), transfer)
        for on in (False, True)
    )
    assert better.tracking()["last"] < plain.tracking()["last"] / 5


def test_the_tolerance_does_not_matter():
    asked, transfer = known()
    loose, tight = (
        fly(asked, short(40, "0.5", run={"tolerance": tolerance}), transfer)
        for tolerance in (2e-10, 1e-10)
    )
    np.testing.assert_allclose(loose.q, tight.q, atol=1e-11)
    np.testing.assert_allclose(loose.omega, tight.omega, atol=1e-12)


def test_control_at_half_the_period_flies_much_the_same():
    asked, transfer = known()
    slow, fast = (fly(asked, short(40, period), transfer) for period in ("0.1", "0.05"))
    assert angle(slow.q, fast.q[::2]).max() < 2e-3


def test_a_start_and_a_target_that_spin():
    spins = {"start_spin": (0.01, 0, 0), "target_spin": (0, 0.01, 0.005)}
    asked, transfer = known(**spins)
    run = fly(asked, short(80), transfer)
    np.testing.assert_array_equal(run.omega[0], [0.01, 0, 0])
    np.testing.assert_allclose(run.omega[-1], run.reference.omega[-1], atol=1e-4)


@pytest.mark.parametrize("name", ["drag", "gravity_gradient", "radiation", "dipole"])
def test_each_disturbance_has_its_switch(name):
    from dataclasses import replace

    asked, transfer = known()
    run = fly(asked, short(2, disturbances=replace(NOTHING, **{name: True})), transfer)
    assert list(run.disturbances) == [name]
    assert np.abs(run.disturbances[name]).max() > 1e-10
    assert np.linalg.norm(run.impulse[-1]) > 0


def test_a_flight_that_ends_before_the_target():
    asked, transfer = known(duration=20)
    run = fly(asked, short(10), transfer)
    assert run.t[-1] == 10
    assert run.holding(1.0) == {"final_error": None, "greatest_error": None, "settled_at": None}


def test_progress_is_told():
    asked, transfer = known()
    told = []
    fly(asked, short(1), transfer, lambda done, total: told.append((done, total)))
    assert told == [(k, 10) for k in range(1, 11)]


def test_settings_are_the_papers_by_default():
    paper = flight()
    assert (paper.orbit.altitude, paper.orbit.inclination) == (600, 97.79)
    assert (paper.wheels.max_torque, paper.wheels.max_torque_rate) == (1e-3, 1e-2)


def test_what_cannot_be_followed_is_refused():
    asked, transfer = known()
    wheels = {"max_torque": 1e300, "max_torque_rate": 1e305}
    settings = short(5, wheels=wheels, controller={"natural_frequency": 1e150})
    with pytest.raises(InputError, match=r"run = beyond \S+ s: torques .* control \(lower gains"):
        fly(asked, settings, transfer)


@pytest.mark.parametrize(
    ("settings", "name"),
    [
        ({"orbit": {"altitude": 50.0}}, "drag"),
        ({"spacecraft": {"drag_coefficient": 1e300}}, "drag"),
        ({"spacecraft": {"dipole": (1e308, 0.0, 0.0)}}, "dipole"),
        ({"wheels": {"momentum": (1e200, 0.0, 0.0)}}, "wheels.momentum"),
    ],
)
def test_what_turns_the_spacecraft_too_fast_is_named(settings, name):
    asked, transfer = known()
    with pytest.raises(InputError) as refused:
        fly(asked, short(5, **settings), transfer)
    assert str(refused.value).startswith("run = beyond ")
    assert str(refused.value).endswith(f" N m, is that of {name}")
