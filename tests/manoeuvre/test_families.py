"""All motions up to a momentum: none is missing, none is twice, all arrive."""

import numpy as np
import pytest
from random_manoeuvres import BODIES, TARGETS, arriving, manoeuvre, posed

from rigidsym import _engines as engines
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._families import families, least
from rigidsym.manoeuvre._manoeuvre import manoeuvre as ask
from rigidsym.manoeuvre._problem import problem
from rigidsym.manoeuvre._search import TooManyError

ENGINE = engines.engine("c")
KINDS = len(BODIES) * len(TARGETS)
# A motion close to the bound may be found by one search and not by the other.
INSIDE = 1 - 1e-6
# Brute force leaves the rates where they miss by 1e-9, which is farther off for flat minima.
APART = 1e-3


def compare(index, seed, bound, starts, refined):
    """The planner's motions and those that random starts find."""
    one = posed(manoeuvre(index, seed), ENGINE)
    most = bound * (least(one) + 1)
    known = families(one, most)
    found = arriving(one, np.random.default_rng(index), most, starts, refined)
    found = found[(one.momenta(found) < INSIDE * most)]
    found = found[np.linalg.norm(one.misses(found), axis=1) < 1e-12]
    return one, known, found


def check_complete(one, known, found):
    if is_symmetry(one):
        known, found = (one.momenta(x)[:, None] for x in (known, found))
    for rates in found:
        near = np.linalg.norm(known - rates, axis=1).min()
        assert near < APART * (1 + np.linalg.norm(rates)), rates


@pytest.mark.parametrize("index", range(KINDS))
def test_none_is_missing_none_is_twice_and_all_arrive(index):
    one, known, found = compare(index, 21, 1.5, 8000, 500)
    assert len(found) > 0
    check_complete(one, known, found)
    assert np.linalg.norm(one.misses(known), axis=1).max() < 1e-9
    assert np.all(np.diff(one.momenta(known)) >= 0)
    apart = np.linalg.norm(known[:, None] - known, axis=-1) + np.eye(len(known))
    assert apart.min() > 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("index", range(10 * KINDS))
def test_none_is_missing_of_many(index):
    check_complete(*compare(index, 22, 3, 60_000, 5000))


def test_a_motion_whose_start_is_hard_to_refine_is_found():
    """Nearly symmetric body, turn close to a symmetry: Gauss-Newton from afar lost it."""
    one = posed(manoeuvre(799721, 11), ENGINE)
    rates = np.array([-2.92506568, 7.44249348, 39.96993593])
    assert np.linalg.norm(families(one, 31.0) - rates, axis=1).min() < 1e-6


@pytest.mark.parametrize("inertia", [("0.4", "0.6", "1"), (0.001, 1, 1.001)])
@pytest.mark.parametrize("scalar", [0, 1e-14, 1e-10, 1e-8])
def test_where_misses_hardly_depend_on_rates_only_motions_that_arrive_are_given(inertia, scalar):
    """Flat bodies, half turns about the axis of largest moment: zeros of the third order."""
    asked = ask(inertia, (1, 0, 0, 0), (scalar, 0, 0, 1), 1)
    one = problem(asked.inertia, asked.start, asked.target, ENGINE)
    known = families(one, 1.01 * least(one))
    assert len(known) > 0
    assert np.linalg.norm(one.misses(known), axis=1).max() < 2e-12


@pytest.mark.parametrize("angle", [1e-3, 1e-9, 1e-12])
def test_small_turns_are_as_right_as_others(angle):
    """All is linear in them: the average inertia is what it is for a whole turn of none."""
    axis, size = np.array([2.0, -1.0, 2.0]) / 3, angle / 2
    asked = ask((1, 2, 2.5), (1, 0, 0, 0), (1, *(size * axis)), 1)
    one = problem(asked.inertia, asked.start, asked.target, ENGINE)
    cheapest = families(one, 1.001 * least(one))[0]
    assert cheapest == pytest.approx(angle * axis, rel=max(2 * angle, 1e-3), abs=0)


@pytest.mark.parametrize("turn", [(0.8, 0, 0, 0.6), (0.8, 0.3, 0.3, 0.2)])
def test_needles_that_turn_too_often_are_refused(turn):
    asked = ask((1e-6, 1, 1), (1, 0, 0, 0), turn, 1)
    one = problem(asked.inertia, asked.start, asked.target, ENGINE)
    with pytest.raises(TooManyError):
        families(one, least(one))


@pytest.mark.parametrize("difference", [1e-15, 3e-14, 1e-12, 1e-8])
@pytest.mark.parametrize("angle", [1e-9, 0.1, 3])
def test_near_spheres_turn_about_the_axis_of_the_turn(difference, angle):
    axis = np.array([2.0, -1.0, 2.0]) / 3
    turn = (np.cos(angle / 2), *(np.sin(angle / 2) * axis))
    asked = ask((1, 1 + difference, 1 - difference), (1, 0, 0, 0), turn, 1)
    one = problem(asked.inertia, asked.start, asked.target, ENGINE)
    assert families(one, 1.001 * least(one))[0] == pytest.approx(angle * axis, rel=1e-6)
