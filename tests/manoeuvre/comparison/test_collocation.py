"""Tests of collocation by optima known by hand and by natural motions."""

from functools import cache

import extra_optimal  # noqa: F401
import numpy as np
import pytest

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre._comparison.collocation import (
    MESH,
    Cost,
    Driven,
    Mesh,
    Model,
    Tableau,
    Task,
    gauss,
    guessed,
    still,
)
from rigidsym.manoeuvre._comparison.optimiser import SETTINGS, Posed, defects, optimum

INERTIA = np.array([0.3, 1.0, 0.8])
ANGLE, LIMIT = 1.0, 10.0
# A turn about the second axis alone.
TARGET = np.array([np.cos(ANGLE / 2), 0, np.sin(ANGLE / 2), 0])
POSED = Posed(INERTIA, TARGET, LIMIT)


@cache
def slew(task, mesh=MESH, settings="default"):
    """Return the optimum of a turn about one principal axis, searched from rest."""
    return optimum(task, POSED, guessed(mesh, INERTIA, task.model, still), settings, mesh)


@pytest.mark.parametrize("points", [1, 2, 3])
def test_gauss_integrates_polynomials(points):
    tableau = gauss(points)
    for degree in range(2 * points):
        assert tableau.b @ tableau.c**degree == pytest.approx(1 / (degree + 1))
    for degree in range(points):
        np.testing.assert_allclose(
            tableau.a @ tableau.c**degree, tableau.c ** (degree + 1) / (degree + 1)
        )


def test_a_tableau_that_is_none_is_refused():
    good = gauss(2)
    with pytest.raises(ValueError, match="square"):
        Tableau(good.c, good.a[:1], good.b)
    with pytest.raises(ValueError, match="constants"):
        Tableau(good.c, good.a, 2 * good.b)


@pytest.mark.parametrize("model", Model)
def test_least_energy_about_one_axis_is_a_torque_linear_in_time(model):
    found = slew(Task(model, Cost.ENERGY))
    assert found.converged
    # Integral of u^2 for u = 6 J angle (1 - 2 t).
    assert found.cost == pytest.approx(12 * ANGLE**2, rel=1e-3)
    torque = found.trajectory.impulses / MESH.steps[:, None]
    middle = (MESH.nodes[1:] + MESH.nodes[:-1]) / 2
    np.testing.assert_allclose(torque[:, 1], 6 * ANGLE * (1 - 2 * middle), atol=0.02)
    np.testing.assert_allclose(torque[:, [0, 2]], 0, atol=1e-5)


def test_torques_constant_in_intervals_cost_what_their_squares_differ():
    coarse, fine = (slew(Task(Model.WHEELS, Cost.ENERGY), Mesh(n)).cost for n in (20, 40))
    assert (coarse - 12) / (fine - 12) == pytest.approx(4, rel=0.05)


@pytest.mark.parametrize("model", Model)
def test_least_fuel_about_one_axis_is_bang_coast_bang(model):
    found = slew(Task(model, Cost.FUEL))
    assert found.converged
    # angle = limit t (1 - t) / J for bursts of length t.
    burst = (1 - np.sqrt(1 - 4 * ANGLE / LIMIT)) / 2
    assert found.cost == pytest.approx(2 * LIMIT * burst, rel=1e-3)
    torque = (found.trajectory.impulses / MESH.steps[:, None])[:, 1]
    begins, ends = MESH.nodes[:-1], MESH.nodes[1:]
    # The mesh cannot switch within an interval: one of them, or the next, is in between.
    longest = MESH.steps.max()
    np.testing.assert_allclose(torque[ends < burst - longest], LIMIT, rtol=1e-4)
    coast = (begins > burst + longest) & (ends < 1 - burst - longest)
    np.testing.assert_allclose(torque[coast], 0, atol=1e-4)
    np.testing.assert_allclose(torque[begins > 1 - burst + longest], -LIMIT, rtol=1e-4)
    assert found.trajectory.impulses[ends < 0.5, 1].sum() == pytest.approx(LIMIT * burst, rel=1e-3)


def test_least_fuel_without_limits_is_two_bursts():
    found = slew(Task(Model.WHEELS, Cost.FUEL, limited=False))
    assert found.cost == pytest.approx(2 * ANGLE, rel=1e-3)
    impulses = found.trajectory.impulses[:, 1]
    np.testing.assert_allclose(impulses[[0, -1]], [ANGLE, -ANGLE], rtol=1e-3)


@pytest.mark.parametrize("settings", SETTINGS)
def test_limits_are_kept_and_attitudes_stay_of_unit_length(settings):
    found = slew(Task(Model.THRUSTERS, Cost.FUEL), settings=settings)
    # IPOPT relaxes bounds by 1e-8.
    most = LIMIT * MESH.steps[:, None] + 2e-8
    assert (np.abs(found.trajectory.impulses) <= most).all()
    np.testing.assert_allclose(np.linalg.norm(found.trajectory.nodes[:, :4], axis=1), 1, atol=1e-7)


@pytest.mark.parametrize("model", Model)
def test_torques_found_lead_to_the_target_by_another_integrator(model):
    found = slew(Task(model, Cost.FUEL))
    driven = Driven(model, INERTIA, found.trajectory.impulses, MESH)
    q, omega = driven(MESH.nodes)
    np.testing.assert_allclose(q, found.trajectory.nodes[:, :4], atol=1e-6)
    np.testing.assert_allclose(omega, found.trajectory.nodes[:, 4:], atol=1e-6)
    np.testing.assert_allclose(driven.end[0], TARGET, atol=1e-6)


def natural(t):
    return TorqueFreeMotion(INERTIA.tolist(), (2.0, -1.5, 1.0), (1, 0, 0, 0))(t)


def natural_defects(intervals):
    """Return the largest defects of a natural motion inside intervals and at their ends."""
    mesh = Mesh(intervals)
    found = guessed(mesh, INERTIA, Model.THRUSTERS, natural)
    inner = found.inner.reshape(intervals, -1)
    nodes = np.hstack(natural(mesh.nodes))
    function = defects(Model.THRUSTERS, mesh).map(intervals)
    missed = np.array(
        function(
            nodes[:-1].T,
            inner.T,
            nodes[1:].T,
            np.zeros((3, intervals)),
            mesh.steps[None],
            np.tile(INERTIA[:, None], intervals),
        )
    )
    return np.abs(missed[:-7]).max(), np.abs(missed[-7:]).max()


def test_natural_motions_obey_the_constraints_to_their_order():
    coarse, fine = natural_defects(40), natural_defects(80)
    # Two points: inside the polynomial is of third order in the step, at its end of fifth.
    assert coarse[0] / fine[0] == pytest.approx(2**3, rel=0.15)
    assert coarse[1] / fine[1] == pytest.approx(2**5, rel=0.15)
    assert fine[0] < 1e-4
    assert fine[1] < 1e-7


def test_natural_motions_are_guessed_with_two_bursts():
    found = guessed(MESH, INERTIA, Model.THRUSTERS, natural)
    first, last = (INERTIA * natural(t)[1] for t in (0.0, 1.0))
    np.testing.assert_allclose(found.impulses[0], first, atol=1e-3)
    np.testing.assert_allclose(found.impulses[-1], -last, atol=1e-3)
    np.testing.assert_allclose(found.impulses[1:-1], 0, atol=1e-6)
