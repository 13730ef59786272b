"""Tests of limits, of the shortest duration, and of one-parameter families of motions."""

import re
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from random_manoeuvres import BODY, START, arriving, turn, turning

from rigidsym.errors import InputError
from rigidsym.manoeuvre import plan

BODIES = [BODY, (1, 1, 1.6), (2, 2, 2)]
TURNS = [(0.9, 0.1, -0.2, 0.3), (0, 0, 0, 1), (0, 0.6, 0, 0.8)]
LIMITS = [(0.1, None), (None, 0.004), (0.3, 0.004)]
SPINS = [(0, 0, 0), (0.02, 0.01, -0.01)]


@pytest.mark.parametrize(
    ("body", "turn", "limits", "spin"), [*product(BODIES, TURNS, LIMITS, SPINS)][::5]
)
def test_the_shortest_duration_keeps_to_the_limits_and_a_shorter_one_does_not(
    body, turn, limits, spin
):
    rate, burst = limits
    # Of the largest moment, so that every body can turn.
    burst = None if burst is None else burst * max(body) / 0.0506
    given = {"max_rate": rate, "max_burst": burst, "start_spin": spin, "target_spin": spin}
    found = plan(body, START, turn, **given)
    best, shortest = found.best, found.manoeuvre.duration
    rates = np.linalg.norm(best.motion(np.linspace(0, best.duration, 2001))[1], axis=1)
    over = [rates.max() / (rate or np.inf)]
    over.append(np.linalg.norm(best.bursts, axis=1).max() / (burst or np.inf))
    # One of them binds.
    assert max(over) == pytest.approx(1, rel=1e-4)
    assert max(over) < 1 + 1e-9
    assert best.residual <= 1e-12
    assert plan(body, START, turn, shortest, **given).best.cost > 0
    with pytest.raises(InputError, match="s would do") as refused:
        plan(body, START, turn, shortest * Fraction(999, 1000), **given)
    named = re.search(r"; (\S+) s would do", str(refused.value))
    assert named is not None
    assert float(named[1]) == pytest.approx(best.duration, rel=1e-5)
    assert plan(body, START, turn, named[1], **given).best.cost > 0


THIRD = {"target": turn((0, 0, 1), 2 * np.pi / 3), "start_spin": (0, 0, 0.1)}
THIRD |= {"target_spin": (0, 0, 0.1)}


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"duration": 1, "max_rate": 1e-3, "max_burst": 1e-5},
            r"^max_rate and max_burst = 0\.001, 1e-05: no natural",
        ),
        (
            {"max_burst": 1e-6, "start_spin": (0.1, 0.05, 0.02)},
            "found no natural motion that keeps to it",
        ),
        (
            THIRD | {"max_burst": 1e-3, "max_rate": 0.05},
            r"^max_rate and max_burst = 0\.05, 0\.001: found no",
        ),
        (
            {"target": (-1, 0, 0, 0), "max_rate": 1},
            "start equals target, which takes no time: give one",
        ),
    ],
)
def test_limits_that_bind_are_named(given, message):
    with pytest.raises(InputError, match=message):
        plan(**{"inertia": BODY, "start": START, "target": TURNS[0], **given})


@pytest.mark.parametrize("limit", [{"max_burst": 1e-3}, {"max_rate": 0.05}])
def test_each_of_two_limits_can_be_kept_that_cannot_be_kept_together(limit):
    assert plan(BODY, START, **THIRD, **limit).best.residual <= 1e-12


def test_all_families_keep_to_the_limits():
    unlimited = plan(BODY, START, TURNS[0], 60, families=20)
    rate = sorted(one.peak_rate for one in unlimited.transfers)[5]
    limited = plan(BODY, START, TURNS[0], 60, families=20, max_rate=rate * 1.0001)
    kept = [one for one in unlimited.transfers if one.peak_rate <= rate * 1.0001]
    assert len(limited.transfers) == len(kept) == 6
    assert max(one.peak_rate for one in limited.transfers) <= rate * 1.0001 * (1 + 1e-9)
    assert "6 of 20" in limited.title
    assert [x.cost for x in limited.transfers[:3]] == pytest.approx([x.cost for x in kept[:3]])


# Turns that are symmetries of the body.
UNEQUAL, SYMMETRIC = (1.0, 2.0, 2.5), (1.0, 1.0, 1.6)
HALF = np.eye(4).tolist()
SYMMETRIES = [
    *((UNEQUAL, HALF[k]) for k in (1, 2, 3, 0)),
    *((SYMMETRIC, turned) for turned in (HALF[3], HALF[0], (0.8, 0, 0, 0.6))),
    ((1.0, 1.0, 1.0), HALF[0]),
]


def costs_by_brute_force(inertia, turn, spins, most, rng):
    """Return the costs of motions that arrive, found from random rates by the engine alone."""
    moments = np.array(inertia)
    one = turning(inertia, turn)
    rates = arriving(one, rng, most / moments.max(), 12_000, 1500)
    _, end = one.engine.propagate(moments, rates, START, np.ones(1))
    first = np.linalg.norm(moments * (rates - spins[0]), axis=1)
    return first + np.linalg.norm(moments * (end[:, 0] - spins[1]), axis=1)


@pytest.mark.parametrize(("inertia", "turn"), SYMMETRIES)
@pytest.mark.parametrize(
    "spins", [((2.0, -1.5, 3.0), (0.5, 2.5, -2.0)), ((6.0, 1.0, 0.5), (5.0, -3.0, 0.5))]
)
def test_no_motion_is_cheaper_than_the_cheapest(inertia, turn, spins):
    found = plan(inertia, START, turn, 1, start_spin=spins[0], target_spin=spins[1]).best
    assert found.residual <= 1e-12
    most = (found.cost + sum(np.linalg.norm(np.multiply(inertia, s)) for s in spins)) / 2
    costs = costs_by_brute_force(inertia, turn, spins, most, np.random.default_rng(4))
    assert len(costs) > 10
    assert found.cost <= costs.min() * (1 + 1e-9)


def test_along_a_ring_the_cost_has_a_minimum_where_it_is_said_to_be():
    """A motion slightly further round the polhode also arrives, and costs more."""
    spins = ((5.0, 1.0, 4.5), (5.0, -1.0, -4.5))
    best = plan(UNEQUAL, START, HALF[1], 1, start_spin=spins[0], target_spin=spins[1]).best
    assert np.count_nonzero(np.abs(best.omega0) > 1e-3) == 3
    costs = []
    for later in (-1e-3, 0, 1e-3):
        bursts = [np.array(UNEQUAL) * (best.motion(t + later)[1] - spins[t]) for t in (0, 1)]
        costs.append(np.linalg.norm(bursts, axis=1).sum())
    assert costs[1] == pytest.approx(best.cost, rel=1e-12)
    assert costs[1] < min(costs[0], costs[2])


def test_a_ring_has_motions_that_keep_a_limit_when_its_cheapest_does_not():
    """The largest burst and the sum of both are least at different points of the ring."""
    given = {"start_spin": (5.0, 1.0, 4.5), "target_spin": (5.0, -2.0, -3.0)}
    free = plan(UNEQUAL, START, HALF[1], 1, **given).best
    most = float(np.linalg.norm(free.bursts, axis=1).max()) * 0.99
    limited = plan(UNEQUAL, START, HALF[1], 1, **given, max_burst=most).best
    assert limited.cost > free.cost
    assert limited.momentum == pytest.approx(free.momentum, rel=1e-6)
    assert np.linalg.norm(limited.bursts, axis=1).max() <= most * (1 + 1e-11)
