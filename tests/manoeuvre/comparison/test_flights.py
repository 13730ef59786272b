"""Tests that every way has the same actuators, limits, disturbances, duration and hold."""

from dataclasses import replace
from fractions import Fraction
from functools import cache, partial

import extra_optimal  # noqa: F401
import numpy as np
import pytest
from manoeuvre_flights import NOTHING

from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison import flights
from rigidsym.manoeuvre._comparison.collocation import MESH, Model, guessed
from rigidsym.manoeuvre._comparison.flights import (
    METHODS,
    PAPER,
    Case,
    Ways,
    draw,
    exerted,
    ideals,
    measured,
)
from rigidsym.manoeuvre._manoeuvre import manoeuvre
from rigidsym.manoeuvre.flight._fly import fly
from rigidsym.manoeuvre.flight._rotation import angle
from rigidsym.manoeuvre.flight._settings import Controller, Flight

CASE = Case(0, "paper", manoeuvre(PAPER, (1, 0, 0, 0), (0.8, 0.4, -0.2, 0.3), 60))
STEPS = ("step", "step, slow")
BY_FEEDBACK = (*STEPS, "natural, feedback alone")


@pytest.fixture(autouse=True)
def _seldom(monkeypatch):
    """Make flights quick by a long period of control, at which they are still stable."""
    monkeypatch.setattr(flights, "PERIOD", Fraction(1, 2))
    monkeypatch.setattr(flights, "HOLD", 30)


@cache
def ways(actuators):
    """Return the ways to fly, with the eigenaxis and its bursts in place of the optimum."""
    inertia = CASE.inertia / CASE.inertia.max()
    motion = partial(flights.turned, CASE.rotation_vector, flights.constant)
    impulses = guessed(MESH, inertia, actuators, motion).impulses
    return Ways(CASE, actuators, solve(CASE.manoeuvre).best, impulses)


@pytest.mark.parametrize("actuators", Model)
@pytest.mark.parametrize("method", METHODS)
def test_ways_differ_in_their_tracks_alone(method, actuators):
    track, flight = METHODS[method](ways(actuators))
    assert track.duration == CASE.duration
    controller = Controller(feedforward=True, track_feedforward=True)
    if method in BY_FEEDBACK:
        controller = Controller(feedforward=actuators is Model.THRUSTERS)
    if method == "step, slow":
        frequency = flight.controller.natural_frequency
        assert 0.05 < frequency < 0.3
        controller = replace(controller, natural_frequency=frequency)
    timing = replace(Flight().run, length=Fraction(90), period=Fraction(1, 2))
    assert flight == replace(Flight(), run=timing, controller=controller)


@pytest.mark.parametrize("method", METHODS)
def test_tracks_lead_from_start_to_target(method):
    track, _ = METHODS[method](ways(Model.WHEELS))
    first, last = (track.motion(t)[0] for t in (0.0, CASE.duration))
    assert first.shape == last.shape == (4,)
    target = [float(x) for x in CASE.manoeuvre.target]
    # The optimum here needs time to speed up, 1e-4 of the duration.
    within = 1e-3 if method == "optimum" else 1e-9
    assert angle(np.array(target) / np.linalg.norm(target), last) < within
    assert method in STEPS or angle(CASE.start, first) < 1e-9


def test_rates_of_turns_are_those_of_their_attitudes():
    for profile in (flights.constant, flights.smooth):
        motion = flights.eigenaxis(CASE, profile).motion
        before, now, after = motion(np.array([29.9, 30.0, 30.1]))[0]
        _, rates = motion(30.0)
        assert angle(before, after) / 0.2 == pytest.approx(np.linalg.norm(rates), rel=1e-4)
        assert angle(before, now) == pytest.approx(angle(now, after), rel=1e-2)


@cache
def flown(method, actuators, still=False):
    """Return a flight by a way, undisturbed if `still`, and its settings."""
    track, flight = METHODS[method](ways(actuators))
    if still:
        flight = replace(flight, disturbances=NOTHING)
    return fly(CASE.manoeuvre, flight, track), flight


@pytest.mark.parametrize("method", METHODS)
def test_limits_of_the_wheels_are_kept(method):
    run, flight = flown(method, Model.WHEELS)
    assert np.abs(run.torque).max() <= flight.wheels.max_torque
    rates = np.abs(np.diff(run.torque, axis=0)) / np.diff(run.t)[:, None]
    assert rates.max() <= flight.wheels.max_torque_rate * (1 + 1e-9)
    found = measured(run, flight, Model.WHEELS)
    # The optimum of least fuel is all the wheels can give, at its ends.
    assert found.saturated == (method in ("step", "optimum"))
    assert found.torque_integral == pytest.approx(sum(run.effort()["torque_integral"]))
    assert found.error_at_duration == pytest.approx(np.degrees(run.error[run.t >= 60][0]))
    assert found.error_after_hold < (1.0 if method == "step, slow" else 0.05)


def test_thrusters_are_not_told_of_gyroscopic_torques():
    found = {}
    for actuators in Model:
        run, _ = flown("natural", actuators)
        coast = (run.t > 30) & (run.t < 55)
        found[actuators] = np.abs(exerted(run, actuators)[coast]).max()
    assert found[Model.THRUSTERS] < 0.2 * found[Model.WHEELS]


def test_fed_forward_a_natural_motion_costs_its_bursts():
    """Feedback alone costs more; without disturbances it adds nothing to what is fed forward."""
    natural, feedback_alone = (
        measured(*flown(method, Model.THRUSTERS, still=True), Model.THRUSTERS).torque_integral
        for method in ("natural", "natural, feedback alone")
    )
    bursts = np.abs(ways(Model.THRUSTERS).transfer.bursts).sum()
    assert natural == pytest.approx(bursts, rel=0.05)
    assert feedback_alone > 1.15 * bursts


def test_a_slow_step_comes_within_what_counts_as_settled():
    x = flights.slowest(2.0, 0.001)
    assert (1 + x) * np.exp(-x) == pytest.approx(0.001 / 2.0)


def test_ideal_bursts_are_cheap_where_coasting_is():
    transfer = ways(Model.THRUSTERS).transfer
    thrusters, wheels = ideals(CASE, transfer).values()
    assert thrusters["natural"] == pytest.approx(np.abs(transfer.bursts).sum())
    assert thrusters["natural"] < wheels["natural"]
    assert wheels["eigenaxis"] < thrusters["eigenaxis"]
    assert thrusters["natural, best of 10"] <= thrusters["natural"]


def test_manoeuvres_are_drawn_by_index_and_seed():
    some = [draw(k, 1) for k in range(6)]
    assert [case.body for case in some] == ["paper", "random"] * 3
    assert [draw(k, 1).manoeuvre for k in range(6)] == [case.manoeuvre for case in some]
    assert draw(0, 2).manoeuvre != some[0].manoeuvre
    for case in some:
        assert 0 < case.problem.angle <= np.pi
        assert case.duration % 10 == 0
        assert case.duration >= 60
        # What the duration is for: a burst about the heaviest axis is 1e-3 N m s at most.
        assert case.inertia.max() * case.problem.angle / case.duration <= 1e-3
        assert np.linalg.norm(case.rotation_vector) == pytest.approx(case.problem.angle)
