"""Tests of all motions up to a momentum: none is missing, none is twice, all arrive."""

import numpy as np
import pytest
from random_manoeuvres import KINDS, SKEW, arriving, manoeuvre, posed, turn, turning

from rigidsym import _engines as engines
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._families import families, least
from rigidsym.manoeuvre._search import TooManyError

ENGINE = engines.engine("c")
# A motion close to the bound may be found by one search and not by the other.
INSIDE = 1 - 1e-6
# Brute force leaves the rates where they miss by 1e-9, which is farther off for flat minima.
APART = 1e-3


def complete(index, seed, bound, starts, refined):
    """Check that the planner finds all motions that random starts find; return all of both."""
    one = posed(manoeuvre(index, seed), ENGINE)
    most = bound * (least(one) + 1)
    known = families(one, most)
    found = arriving(one, np.random.default_rng(index), most, starts, refined)
    found = found[(one.momenta(found) < INSIDE * most)]
    found = found[np.linalg.norm(one.misses(found), axis=1) < 1e-12]
    ours, others = known, found
    if is_symmetry(one):
        ours, others = (one.momenta(x)[:, None] for x in (known, found))
    for rates in others:
        near = np.linalg.norm(ours - rates, axis=1).min()
        assert near < APART * (1 + np.linalg.norm(rates)), rates
    return one, known, found


@pytest.mark.parametrize("index", range(KINDS))
def test_none_is_missing_none_is_twice_and_all_arrive(index):
    one, known, found = complete(index, 21, 1.5, 8000, 500)
    assert len(found) > 0
    assert np.linalg.norm(one.misses(known), axis=1).max() < 1e-9
    assert np.all(np.diff(one.momenta(known)) >= 0)
    apart = np.linalg.norm(known[:, None] - known, axis=-1) + np.eye(len(known))
    assert apart.min() > 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("index", range(10 * KINDS))
def test_none_is_missing_of_many(index):
    complete(index, 22, 3, 60_000, 5000)


def test_a_motion_whose_start_is_hard_to_refine_is_found():
    """Gauss-Newton from afar lost it: body and turn are both close to a symmetry."""
    one = posed(manoeuvre(799721, 11), ENGINE)
    rates = np.array([-2.92506568, 7.44249348, 39.96993593])
    assert np.linalg.norm(families(one, 31.0) - rates, axis=1).min() < 1e-6


@pytest.mark.parametrize("inertia", [("0.4", "0.6", "1"), (0.001, 1, 1.001)])
@pytest.mark.parametrize("scalar", [0, 1e-14, 1e-10, 1e-8])
def test_where_misses_hardly_depend_on_rates_only_motions_that_arrive_are_given(inertia, scalar):
    """Half turns of flat bodies about the axis of largest moment are zeros of third order."""
    one = turning(inertia, (scalar, 0, 0, 1))
    known = families(one, 1.01 * least(one))
    assert len(known) > 0
    assert np.linalg.norm(one.misses(known), axis=1).max() < 2e-12


@pytest.mark.parametrize(
    ("inertia", "angle", "target", "within"),
    [
        # All is linear in small turns: the average inertia is what it is for a whole turn of none.
        *(((1, 2, 2.5), angle, (1, *(angle / 2 * SKEW)), max(2 * angle, 1e-3))
          for angle in (1e-3, 1e-9, 1e-12)),
        *(((1, 1 + apart, 1 - apart), angle, turn(SKEW, angle), 1e-6)
          for apart in (1e-15, 3e-14, 1e-12, 1e-8) for angle in (1e-9, 0.1, 3)),
    ],
)  # fmt: skip
def test_small_turns_and_near_spheres_turn_about_the_axis_of_the_turn(
    inertia, angle, target, within
):
    one = turning(inertia, target)
    cheapest = families(one, 1.001 * least(one))[0]
    assert cheapest == pytest.approx(angle * SKEW, rel=within, abs=0)


@pytest.mark.parametrize("target", [(0.8, 0, 0, 0.6), (0.8, 0.3, 0.3, 0.2)])
def test_needles_that_turn_too_often_are_refused(target):
    one = turning((1e-6, 1, 1), target)
    with pytest.raises(TooManyError):
        families(one, least(one))
