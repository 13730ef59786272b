"""How far thirty digits say that a motion misses, and rates that miss it less than doubles."""

from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import manoeuvre as manoeuvre_at_random

from rigidsym import _engines as engines
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._manoeuvre import manoeuvre
from rigidsym.manoeuvre._problem import problem
from rigidsym.manoeuvre._refine import miss, verified
from rigidsym.motion import TorqueFreeMotion

BODY = ("1", "2", "2.5")
START = (1, 0, 0, 0)
# On the separatrix, towards the middle axis: in 1 s small differences grow by a factor 50 000.
SEPARATRIX = ("6", "24", "5.36656314599949527138201680495")


def led_to(rates):
    """The manoeuvre to where rates lead in 1 s, and its problem."""
    q = TorqueFreeMotion(BODY, rates, START).precise(1, 40)[0]
    asked = manoeuvre(BODY, START, list(q), 1)
    return asked, problem(asked.inertia, asked.start, asked.target, engines.engine("c"))


def test_a_motion_that_arrives_misses_by_nothing():
    asked, _ = led_to(("0.5", "-1", "2"))
    assert np.linalg.norm(miss(asked, (Fraction("0.5"), Fraction(-1), Fraction(2)))) < 1e-28


@pytest.mark.parametrize("axis", range(3))
def test_misses_are_rotation_vectors_in_the_axes_of_the_start(axis):
    turn = [np.cos(0.25), *(np.sin(0.25) * np.eye(3)[axis])]
    asked = manoeuvre(BODY, START, turn, 1)
    rates = tuple(Fraction(x) for x in ((0.5 + 1e-6) * np.eye(3)[axis]).tolist())
    assert miss(asked, rates) == pytest.approx(1e-6 * np.eye(3)[axis], abs=1e-15)


def test_doubles_are_kept_where_they_arrive():
    asked, posed = led_to(("0.5", "-1", "2"))
    rates, residual = verified(posed, asked, np.array([0.5, -1, 2]) + 1e-9)
    assert residual < 1e-13
    assert all(Fraction(float(x)) == x for x in rates)


def test_close_to_the_separatrix_decimals_arrive_where_doubles_do_not():
    asked, posed = led_to(SEPARATRIX)
    nearest = np.array([float(x) for x in SEPARATRIX])
    assert np.linalg.norm(miss(asked, tuple(map(Fraction, nearest.tolist())))) > 1e-13
    rates, residual = verified(posed, asked, nearest + 1e-9)
    assert residual <= 1e-13
    assert any(Fraction(float(x)) != x for x in rates)


def test_fast_spins_with_a_wobble_are_polished():
    """The misses bend within less than a thousandth of the rates."""
    found = solve(manoeuvre_at_random(858262, 11), 20)
    assert max(one.residual for one in found.transfers) <= 1e-12
