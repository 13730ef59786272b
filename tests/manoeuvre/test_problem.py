"""Tests of the dimensionless problem, and of rates refined to arrive to thirty digits."""

from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import START, manoeuvre, posed, turn

from rigidsym import _engines as engines
from rigidsym.manoeuvre import _manoeuvre as asked_for
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._families import miss, verified
from rigidsym.manoeuvre._problem import between, problem, unit
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import product, rotation_vectors

ENGINE = engines.engine("numpy")
BODY = (Fraction(1), Fraction(2), Fraction(5, 2))
P, Q = (3, 1, -2, 5), (1, 4, 2, -2)
# On the separatrix, towards the middle axis: in 1 s small differences grow by a factor 50 000.
SEPARATRIX = ("6", "24", "5.36656314599949527138201680495")


def of(start, target):
    return problem(BODY, *(tuple(map(Fraction, q)) for q in (start, target)), ENGINE)


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("sizes", [(1, 1), (Fraction(10) ** -400, Fraction(10) ** 400)])
def test_neither_signs_nor_lengths_of_attitudes_matter(sign, sizes):
    found = of([sizes[0] * x for x in P], [sign * sizes[1] * x for x in Q])
    assert np.array_equal(found.turn, of(P, Q).turn)
    assert found.turn[0] >= 0


def test_the_turn_leads_from_start_to_target():
    assert abs(product(unit(P), of(P, Q).turn) @ unit(Q)) == pytest.approx(1, abs=1e-15)


def test_momenta_keep_their_place_in_space():
    """A momentum m has the components m @ rotation in the body axes of the target."""
    posed = of(START, Q)
    momentum = np.array([0.3, -0.5, 0.8])
    vector = posed.turn * [1, -1, -1, -1]
    expected = product(product(vector, np.array([0, *momentum])), posed.turn)[1:]
    assert momentum @ posed.rotation == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("index", range(5))
def test_misses_are_those_of_the_motion(index):
    asked = manoeuvre(index)
    rates = np.random.default_rng(index).normal(size=3)
    q, _ = TorqueFreeMotion(asked.inertia, rates, asked.start)(1)
    missed = 2 * np.arccos(min(1, abs(q @ unit(asked.target))))
    assert np.linalg.norm(posed(asked, ENGINE).misses(rates)) == pytest.approx(missed, abs=1e-7)


def test_rotation_vectors_go_the_shorter_way_and_keep_small_ones():
    small = np.array([1.0, 3e-200, 0, -4e-200])
    assert rotation_vectors(small) == pytest.approx([6e-200, 0, -8e-200], rel=1e-15)
    far = np.array([-np.cos(0.5), 0, np.sin(0.5), 0])
    assert rotation_vectors(far) == pytest.approx([0, -1, 0])


def test_between_is_exact():
    p, q = (tuple(map(Fraction, x)) for x in (P, Q))
    assert between(p, p) == (39, 0, 0, 0)
    assert between(p, q) == (-7, 17, -14, -21)


def led_to(rates):
    """Return the manoeuvre to the attitude that rates lead to in 1 s, and its problem."""
    q = TorqueFreeMotion(BODY, rates, START).precise(1, 40)[0]
    asked = asked_for.manoeuvre(BODY, START, list(q), 1)
    return asked, posed(asked, engines.engine("c"))


def test_a_motion_that_arrives_misses_by_nothing_and_its_doubles_are_kept():
    asked, one = led_to(("0.5", "-1", "2"))
    assert np.linalg.norm(miss(asked, (Fraction("0.5"), Fraction(-1), Fraction(2)))) < 1e-28
    rates, residual = verified(one, asked, np.array([0.5, -1, 2]) + 1e-9)
    assert residual < 1e-13
    assert all(Fraction(float(x)) == x for x in rates)


@pytest.mark.parametrize("axis", range(3))
def test_misses_are_rotation_vectors_in_the_axes_of_the_start(axis):
    asked = asked_for.manoeuvre(BODY, START, turn(np.eye(3)[axis], 0.5), 1)
    rates = tuple(Fraction(x) for x in ((0.5 + 1e-6) * np.eye(3)[axis]).tolist())
    assert miss(asked, rates) == pytest.approx(1e-6 * np.eye(3)[axis], abs=1e-15)


def test_close_to_the_separatrix_decimals_arrive_where_doubles_do_not():
    asked, one = led_to(SEPARATRIX)
    nearest = np.array([float(x) for x in SEPARATRIX])
    assert np.linalg.norm(miss(asked, tuple(map(Fraction, nearest.tolist())))) > 1e-13
    rates, residual = verified(one, asked, nearest + 1e-9)
    assert residual <= 1e-13
    assert any(Fraction(float(x)) != x for x in rates)


def test_fast_spins_with_a_wobble_are_polished():
    """Misses are nonlinear within a thousandth of the rates."""
    found = solve(manoeuvre(858262, 11), 20)
    assert max(one.residual for one in found.transfers) <= 1e-12
