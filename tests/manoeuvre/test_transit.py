"""Tests of the cone, transit times and largest rates, on motions that are propagated."""

from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import BODIES, KINDS, START, manoeuvre, turning

from rigidsym.manoeuvre import plan, solve
from rigidsym.manoeuvre._directions import arcs, quadratic_form
from rigidsym.manoeuvre._transit import transits
from rigidsym.motion import TorqueFreeMotion


def flown(index):
    """Return the problem that a random motion solves, its momentum and its direction."""
    rng = np.random.default_rng([3, index])
    inertia = manoeuvre(index).inertia
    moments = np.array([float(x / max(inertia)) for x in inertia])
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    size = rng.uniform(1, 30)
    q, _ = TorqueFreeMotion(moments, size * direction / moments)(1)
    return turning(moments, q, "numpy"), size, direction


@pytest.mark.parametrize("index", range(6 * len(BODIES)))
def test_motions_begin_on_the_cone_and_arrive_after_a_transit_and_whole_periods(index):
    posed, size, direction = flown(index)
    form = quadratic_form(posed)
    assert abs(direction @ form @ direction) < 1e-12 * max(np.abs(form).max(), 1e-3)
    first, period = transits(posed, direction[None])
    turns = (size - first[0]) / period[0]
    # Positions on the polhode are known to rounding over how fast the momentum leaves its place.
    assert turns == pytest.approx(round(turns), abs=1e-5)
    assert round(turns) >= 0


@pytest.mark.parametrize("index", range(3 * len(BODIES)))
def test_directions_of_arcs_lie_on_the_cone(index):
    posed, _, _ = flown(index)
    curves, form = arcs(posed), quadratic_form(posed)
    arc = np.repeat(np.arange(len(curves.ends)), 9)
    found = curves.at(arc, np.tile(np.linspace(-30, 30, 9), len(curves.ends)))
    assert len(arc) >= 18
    assert np.linalg.norm(found, axis=1) == pytest.approx(np.ones(len(arc)))
    energies = np.einsum("ni,ij,nj->n", found, form, found)
    assert np.abs(energies).max() < 1e-12 * np.abs(form).max()


@pytest.mark.parametrize("axis", [0, 2])
def test_a_momentum_that_does_not_move_has_no_transit(axis):
    posed = turning((1, 2, Fraction(5, 2)), (3, 1, 2, 1), "numpy")
    first, period = transits(posed, np.eye(3)[[axis]])
    assert np.isnan(first[0]) or not np.isfinite(period[0])


@pytest.mark.parametrize("index", range(KINDS))
def test_no_sample_is_faster_and_one_is_as_fast(index):
    for one in solve(manoeuvre(index, 31), 4).transfers:
        omega = one.motion(np.linspace(0, one.duration, 4001))[1]
        sampled = np.linalg.norm(omega, axis=1).max()
        assert sampled <= one.peak_rate * (1 + 1e-12)
        assert sampled == pytest.approx(one.peak_rate, rel=1e-4)


@pytest.mark.parametrize("size", [1e-6, 1e-12, 1e-15])
def test_it_is_no_less_than_at_the_start(size):
    best = plan((1, 2, 2.5), START, (1, size, 0, -size), 10).best
    assert best.peak_rate >= np.linalg.norm(best.omega0) * (1 - 1e-12) > 0
