"""Tests of the closed loop: momentum, energy, limits, and the natural motion itself."""

from dataclasses import replace

import numpy as np
import pytest
from manoeuvre_flights import CALM, NO_CONTROL, NOTHING, OMEGA0, flown, known, short

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._rotation import angle, matrix
from rigidsym.manoeuvre.flight._settings import Flight


@pytest.fixture(scope="module")
def paper_like():
    """The paper's flight along a known motion."""
    asked, transfer = known(duration=120)
    return fly(asked, Flight(), transfer)


def test_without_torques_the_natural_motion_is_flown():
    run = flown(transfer={"start_spin": OMEGA0}, controller=NO_CONTROL, **CALM)
    q, omega = known()[1].motion(run.t)
    np.testing.assert_allclose(run.q, q, atol=1e-12)
    np.testing.assert_allclose(run.omega, omega, atol=1e-14)
    np.testing.assert_array_equal(run.torque, np.zeros_like(run.torque))
    assert run.disturbances == {}


def test_with_feedforward_wheels_that_turn_are_not_felt():
    wheels = {"momentum": (1e-3, -2e-3, 5e-4), "max_torque_rate": 1.0}
    errors = [
        flown(20, period, {"start_spin": OMEGA0}, wheels=wheels, controller=gains, **CALM).error
        for period, gains in (("0.01", {"feedforward": True}), ("0.1", NO_CONTROL))
    ]
    assert errors[0][:-1].max() < 1e-4
    assert errors[1][:-1].max() > 0.05


def test_the_momentum_changes_by_the_disturbances_alone_which_are_recorded(paper_like):
    run = paper_like
    size = np.linalg.norm(run.inertia * run.track.omega[0])
    assert np.linalg.norm(run.impulse[-1]) > 1e-3 * size
    assert run.momentum_defect() < 1e-10 * size
    assert run.energy_defect() < 1e-10 * size * 0.02
    whole = sum(run.disturbances.values())
    inertial = np.array([matrix(q) @ torque for q, torque in zip(run.q, whole, strict=True)])
    summed = np.trapezoid(inertial, run.t, axis=0)
    np.testing.assert_allclose(summed, run.impulse[-1], rtol=1e-4)


def test_no_momentum_from_nowhere():
    run = flown(**CALM)
    whole = run.inertia * run.omega + run.wheel_momentum
    # Spacecraft and wheels began at rest; the wheels turn against the body all the way.
    np.testing.assert_allclose(whole, np.zeros_like(whole), atol=1e-15)


def test_the_limits_of_the_wheels(paper_like):
    wheels = Flight().wheels
    # A loop that wants more than the wheels can do.
    hasty = flown(30, controller={"natural_frequency": 3.0})
    assert np.abs(hasty.torque).max() == wheels.max_torque
    for run in (paper_like, hasty):
        assert np.abs(run.torque).max() <= wheels.max_torque
        steps = np.abs(np.diff(run.torque, axis=0)) / np.diff(run.t)[:, None]
        assert steps.max() <= wheels.max_torque_rate * (1 + 1e-9)


def test_wheels_that_are_full_give_no_more():
    run = flown(30, wheels={"max_momentum": 3e-4})
    assert 2.9e-4 < np.abs(run.wheel_momentum).max() <= 3e-4 * (1 + 1e-9)
    assert run.momentum_defect() < 1e-13


def test_the_target_is_reached_and_held_by_continuous_attitudes(paper_like):
    holding = paper_like.holding(np.radians(0.1))
    assert holding["final_error"] < np.radians(0.05)
    assert 120 < holding["settled_at"] < 150
    tracking = paper_like.tracking()
    assert tracking["last"] < tracking["max"] < np.radians(3)
    assert np.abs(paper_like.torque).max() < 6e-4
    assert np.abs(np.diff(paper_like.q, axis=0)).max() < 2e-3
    np.testing.assert_allclose(np.linalg.norm(paper_like.q, axis=1), 1, rtol=1e-15)
    np.testing.assert_array_equal(paper_like.q[0], [1, 0, 0, 0])


def test_feedforward_follows_closer():
    plain, better = (
        flown(60, "0.1", {"duration": 60}, controller={"feedforward": on}, **CALM)
        for on in (False, True)
    )
    assert better.tracking()["last"] < plain.tracking()["last"] / 5


def test_the_tolerance_does_not_matter():
    loose, tight = (flown(40, "0.5", run={"tolerance": x}) for x in (2e-10, 1e-10))
    np.testing.assert_allclose(loose.q, tight.q, atol=1e-11)
    np.testing.assert_allclose(loose.omega, tight.omega, atol=1e-12)


def test_control_at_half_the_period_flies_much_the_same():
    slow, fast = (flown(40, period) for period in ("0.1", "0.05"))
    assert angle(slow.q, fast.q[::2]).max() < 2e-3


def test_a_start_and_a_target_that_spin():
    run = flown(80, transfer={"start_spin": (0.01, 0, 0), "target_spin": (0, 0.01, 0.005)})
    np.testing.assert_array_equal(run.omega[0], [0.01, 0, 0])
    np.testing.assert_allclose(run.omega[-1], run.reference.omega[-1], atol=1e-4)


@pytest.mark.parametrize("name", ["drag", "gravity_gradient", "radiation", "dipole"])
def test_each_disturbance_has_its_switch(name):
    run = flown(2, disturbances=replace(NOTHING, **{name: True}))
    assert list(run.disturbances) == [name]
    assert np.abs(run.disturbances[name]).max() > 1e-10
    assert np.linalg.norm(run.impulse[-1]) > 0


def test_a_flight_that_ends_before_the_target():
    run = flown(10)
    assert run.t[-1] == 10
    assert run.holding(1.0) == {"final_error": None, "greatest_error": None, "settled_at": None}


def test_progress_is_told():
    asked, transfer = known()
    calls = []
    fly(asked, short(1), transfer, lambda done, total: calls.append((done, total)))
    assert calls == [(k, 10) for k in range(1, 11)]


def test_settings_are_the_papers_by_default():
    paper = Flight()
    assert (paper.orbit.altitude, paper.orbit.inclination) == (600, 97.79)
    assert (paper.wheels.max_torque, paper.wheels.max_torque_rate) == (1e-3, 1e-2)


@pytest.mark.parametrize(
    ("settings", "name"),
    [
        (
            {
                "wheels": {"max_torque": 1e300, "max_torque_rate": 1e305},
                "controller": {"natural_frequency": 1e150},
            },
            "control (lower gains or limits)",
        ),
        ({"orbit": {"altitude": 50.0}}, "drag"),
        ({"spacecraft": {"drag_coefficient": 1e300}}, "drag"),
        ({"spacecraft": {"dipole": (1e308, 0.0, 0.0)}}, "dipole"),
        ({"wheels": {"momentum": (1e200, 0.0, 0.0)}}, "wheels.momentum"),
    ],
)
def test_what_turns_the_spacecraft_too_fast_is_named(settings, name):
    with pytest.raises(InputError, match=r"^run = beyond \S+ s: torques ") as refused:
        flown(5, **settings)
    assert str(refused.value).endswith(f" N m, is that of {name}")
