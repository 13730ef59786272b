"""Limits: they are kept, they decide the shortest duration, and what breaks them is refused."""

import re
from fractions import Fraction
from itertools import product

import numpy as np
import pytest

from rigidsym.errors import InputError
from rigidsym.manoeuvre import plan

BODIES = [(0.0109, 0.04, 0.0506), (1, 1, 1.6), (2, 2, 2)]
TURNS = [(0.9, 0.1, -0.2, 0.3), (0, 0, 0, 1), (0, 0.6, 0, 0.8)]
LIMITS = [(0.1, None), (None, 0.004), (0.3, 0.004)]
SPINS = [(0, 0, 0), (0.02, 0.01, -0.01)]
START = (1, 0, 0, 0)


def asked(body, turn, limits, spin, duration=None, families=1):
    rate, impulse = limits
    # Of the largest moment, so that every body can turn.
    impulse = None if impulse is None else impulse * max(body) / 0.0506
    given = {"max_rate": rate, "max_burst": impulse, "start_spin": spin, "target_spin": spin}
    return plan(body, START, turn, duration, **given, families=families), rate, impulse


@pytest.mark.parametrize(
    ("body", "turn", "limits", "spin"), [*product(BODIES, TURNS, LIMITS, SPINS)][::5]
)
def test_the_shortest_duration_keeps_to_the_limits_and_a_shorter_one_does_not(
    body, turn, limits, spin
):
    found, rate, impulse = asked(body, turn, limits, spin)
    best = found.best
    rates = np.linalg.norm(best.motion(np.linspace(0, best.duration, 2001))[1], axis=1)
    over = [rates.max() / (rate or np.inf)]
    over.append(np.linalg.norm(best.bursts, axis=1).max() / (impulse or np.inf))
    # One of them binds.
    assert max(over) == pytest.approx(1, rel=1e-4)
    assert max(over) < 1 + 1e-9
    assert best.residual <= 1e-12
    assert asked(body, turn, limits, spin, found.manoeuvre.duration)[0].best.cost > 0
    with pytest.raises(InputError, match="s would do") as refused:
        asked(body, turn, limits, spin, found.manoeuvre.duration * Fraction(999, 1000))
    named = re.search(r"; (\S+) s would do", str(refused.value))
    assert named is not None
    assert float(named[1]) == pytest.approx(best.duration, rel=1e-5)
    assert asked(body, turn, limits, spin, named[1])[0].best.cost > 0


def test_both_limits_are_named_where_both_bind():
    with pytest.raises(InputError, match=r"^max_rate and max_burst = 0\.001, 1e-05: no natural"):
        plan(BODIES[0], START, TURNS[0], 1, max_rate=1e-3, max_burst=1e-5)


def test_all_families_keep_to_the_limits():
    unlimited = plan(BODIES[0], START, TURNS[0], 60, families=20)
    rate = sorted(one.peak_rate for one in unlimited.transfers)[5]
    limited = plan(BODIES[0], START, TURNS[0], 60, families=20, max_rate=rate * 1.0001)
    kept = [one for one in unlimited.transfers if one.peak_rate <= rate * 1.0001]
    assert len(limited.transfers) == len(kept) == 6
    assert max(one.peak_rate for one in limited.transfers) <= rate * 1.0001 * (1 + 1e-9)
    assert "6 of 20" in limited.title
    assert [x.cost for x in limited.transfers[:3]] == pytest.approx([x.cost for x in kept[:3]])


def test_spins_beyond_a_limit_have_no_duration():
    with pytest.raises(InputError, match="found no natural motion that keeps to it"):
        plan(BODIES[0], START, TURNS[0], max_burst=1e-6, start_spin=(0.1, 0.05, 0.02))


def test_limits_that_only_together_cannot_be_kept_are_both_named():
    turn = (np.cos(np.pi / 3), 0, 0, np.sin(np.pi / 3))
    spins = {"start_spin": (0, 0, 0.1), "target_spin": (0, 0, 0.1)}
    for one in ({"max_burst": 1e-3}, {"max_rate": 0.05}):
        assert plan(BODIES[0], START, turn, **one, **spins).best.residual <= 1e-12
    with pytest.raises(InputError, match=r"^max_rate and max_burst = 0\.05, 0\.001: found no"):
        plan(BODIES[0], START, turn, max_burst=1e-3, max_rate=0.05, **spins)


def test_what_takes_no_time_is_refused_without_a_duration():
    with pytest.raises(InputError, match="start equals target, which takes no time: give one"):
        plan(BODIES[0], START, (-1, 0, 0, 0), max_rate=1)
