"""Turns that are symmetries of the body, with spins: the cheapest of each ring."""

import numpy as np
import pytest

from rigidsym.manoeuvre import plan

START = (1, 0, 0, 0)
HALF = np.eye(4).tolist()
CASES = [
    ((1.0, 2.0, 2.5), HALF[1]),
    ((1.0, 2.0, 2.5), HALF[2]),
    ((1.0, 2.0, 2.5), HALF[3]),
    ((1.0, 2.0, 2.5), HALF[0]),
    ((1.0, 1.0, 1.6), HALF[3]),
    ((1.0, 1.0, 1.6), HALF[0]),
    ((1.0, 1.0, 1.6), (0.8, 0, 0, 0.6)),
    ((1.0, 1.0, 1.0), HALF[0]),
]
SPINS = [((2.0, -1.5, 3.0), (0.5, 2.5, -2.0)), ((6.0, 1.0, 0.5), (5.0, -3.0, 0.5))]


def costs_by_brute_force(inertia, turn, spins, most, rng):
    """The least cost that random rates lead to, by the engine alone."""
    from random_manoeuvres import arriving

    from rigidsym import _engines as engines
    from rigidsym.manoeuvre._manoeuvre import manoeuvre
    from rigidsym.manoeuvre._problem import problem

    asked = manoeuvre(inertia, START, turn, 1)
    one = problem(asked.inertia, asked.start, asked.target, engines.engine("c"))
    moments = np.array(inertia)
    rates = arriving(one, rng, most / moments.max(), 12_000, 1500)
    _, end = one.engine.propagate(moments, rates, START, np.ones(1))
    first = np.linalg.norm(moments * (rates - spins[0]), axis=1)
    return first + np.linalg.norm(moments * (end[:, 0] - spins[1]), axis=1)


@pytest.mark.parametrize(("inertia", "turn"), CASES)
@pytest.mark.parametrize("spins", SPINS)
def test_no_motion_is_cheaper_than_the_cheapest(inertia, turn, spins):
    found = plan(inertia, START, turn, 1, start_spin=spins[0], target_spin=spins[1]).best
    assert found.residual <= 1e-12
    moments = np.array(inertia)
    most = (found.cost + sum(np.linalg.norm(moments * np.array(s)) for s in spins)) / 2
    costs = costs_by_brute_force(inertia, turn, spins, most, np.random.default_rng(4))
    assert len(costs) > 10
    assert found.cost <= costs.min() * (1 + 1e-9)


def test_along_a_ring_the_cost_has_a_minimum_where_it_is_said_to_be():
    """A little further round the polhode the same motion arrives and costs more."""
    spins = ((5.0, 1.0, 4.5), (5.0, -1.0, -4.5))
    best = plan((1, 2, 2.5), START, HALF[1], 1, start_spin=spins[0], target_spin=spins[1]).best
    moments = np.array([1, 2, 2.5])
    assert np.count_nonzero(np.abs(best.omega0) > 1e-3) == 3
    costs = []
    for later in (-1e-3, 0, 1e-3):
        begin, end = (best.motion(t + later)[1] for t in (0, 1))
        first, last = begin - spins[0], end - spins[1]
        costs.append(np.linalg.norm(moments * first) + np.linalg.norm(moments * last))
    assert costs[1] == pytest.approx(best.cost, rel=1e-12)
    assert costs[1] < min(costs[0], costs[2])


def test_a_ring_has_motions_that_keep_a_limit_when_its_cheapest_does_not():
    """The largest burst is least elsewhere on the ring than the sum of both."""
    given = {"start_spin": (5.0, 1.0, 4.5), "target_spin": (5.0, -2.0, -3.0)}
    free = plan((1, 2, 2.5), START, HALF[1], 1, **given).best
    most = float(np.linalg.norm(free.bursts, axis=1).max()) * 0.99
    limited = plan((1, 2, 2.5), START, HALF[1], 1, **given, max_burst=most).best
    assert limited.cost > free.cost
    assert limited.momentum == pytest.approx(free.momentum, rel=1e-6)
    assert np.linalg.norm(limited.bursts, axis=1).max() <= most * (1 + 1e-11)
