"""The problem without units: what turn is left, and where rates lead."""

from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import manoeuvre, posed

from rigidsym import _engines as engines
from rigidsym.manoeuvre._problem import between, problem, unit
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import product, rotation_vectors

ENGINE = engines.engine("numpy")
BODY = (Fraction(1), Fraction(2), Fraction(5, 2))


def of(start, target):
    return problem(BODY, *(tuple(map(Fraction, q)) for q in (start, target)), ENGINE)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("sizes", [(1, 1), (Fraction(10) ** -400, Fraction(10) ** 400)])
def test_neither_signs_nor_lengths_of_attitudes_matter(sign, sizes):
    start, target = (3, 1, -2, 5), (1, 4, 2, -2)
    expected = of(start, target)
    found = of([sizes[0] * x for x in start], [sign * sizes[1] * x for x in target])
    assert np.array_equal(found.turn, expected.turn)
    assert found.turn[0] >= 0


def test_the_turn_leads_from_start_to_target():
    start, target = unit((3, 1, -2, 5)), unit((1, 4, 2, -2))
    turn = of((3, 1, -2, 5), (1, 4, 2, -2)).turn
    assert abs(product(start, turn) @ target) == pytest.approx(1, abs=1e-15)


def test_momenta_keep_their_place_in_space():
    """Rows m @ rotation are what m is in the body axes of the target."""
    posed = of((1, 0, 0, 0), (1, 4, 2, -2))
    momentum = np.array([0.3, -0.5, 0.8])
    vector = posed.turn * [1, -1, -1, -1]
    expected = product(product(vector, np.array([0, *momentum])), posed.turn)[1:]
    assert momentum @ posed.rotation == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("index", range(5))
def test_misses_are_those_of_the_motion(index):
    asked = manoeuvre(index)
    one = posed(asked, ENGINE)
    rates = np.random.default_rng(index).normal(size=3)
    q, _ = TorqueFreeMotion(asked.inertia, rates, asked.start)(1)
    missed = 2 * np.arccos(min(1, abs(q @ unit(asked.target))))
    assert np.linalg.norm(one.misses(rates)) == pytest.approx(missed, abs=1e-7)


def test_rotation_vectors_go_the_shorter_way_and_keep_small_ones():
    small = np.array([1.0, 3e-200, 0, -4e-200])
    assert rotation_vectors(small) == pytest.approx([6e-200, 0, -8e-200], rel=1e-15)
    far = np.array([-np.cos(0.5), 0, np.sin(0.5), 0])
    assert rotation_vectors(far) == pytest.approx([0, -1, 0])


def test_between_is_exact():
    p, q = (tuple(map(Fraction, x)) for x in ((3, 1, -2, 5), (1, 4, 2, -2)))
    assert between(p, p) == (39, 0, 0, 0)
    assert between(p, q) == (-7, 17, -14, -21)
