"""Taylor series of the equations of motion, against closed forms and against themselves."""

import ast
from fractions import Fraction
from pathlib import Path

import pytest
from boxes import BODY as GIVEN
from boxes import distance
from mpmath import mp, workdps

from rigidsym._inputs import exact
from rigidsym.precise import _taylor as taylor
from rigidsym.precise._taylor import integrate

BODY = tuple(map(Fraction, GIVEN))
RATES = tuple(map(Fraction, ("0.05", "0.03", "-0.02")))
ATTITUDE = (Fraction(1), Fraction(-2), Fraction(3, 7), Fraction(1, 2))


@pytest.mark.parametrize("digits", [5, 15, 60])
@pytest.mark.parametrize("time", [Fraction(40), Fraction(-40)])
def test_the_digits_asked_for_are_there(digits, time):
    with workdps(digits + 40):
        few, more = (integrate(BODY, RATES, ATTITUDE, time, d) for d in (digits, digits + 20))
        for a, b in zip(few, more, strict=True):
            assert 0 < distance(a, b) < mp.mpf(10) ** -digits


def test_a_spin_is_one_exponential():
    """The quaternion of a turn about a principal axis has half the angle."""
    with workdps(60):
        q, omega = integrate(BODY, (0, Fraction(2), 0), (1, 0, 0, 0), Fraction(25), 40)
        assert distance(q, (mp.cos(25), 0, mp.sin(25), 0)) < mp.mpf(10) ** -40
        assert distance(omega, (0, 2, 0)) < mp.mpf(10) ** -40


def test_a_symmetric_body_precesses():
    """For the moments (1, 1, 2), Omega_1 + i Omega_2 turns at the rate (2 - 1) Omega_3."""
    with workdps(60):
        t = Fraction(9, 2)
        _, omega = integrate((1, 1, 2), (Fraction(1), 0, Fraction(3)), ATTITUDE, t, 40)
        angle = mp.mpf(27) / 2
        assert distance(omega, (mp.cos(angle), mp.sin(angle), 3)) < mp.mpf(10) ** -40


def test_there_and_back_again():
    with workdps(60):
        there = integrate(BODY, RATES, (1, 0, 0, 0), Fraction(30), 40)
        attitude, rates = ([exact("x", x) for x in part] for part in there)
        q, omega = integrate(BODY, rates, attitude, Fraction(-30), 40)
        assert distance(q, (1, 0, 0, 0)) < mp.mpf(10) ** -38
        assert distance(omega, map(mp.convert, RATES)) < mp.mpf(10) ** -38


@pytest.mark.parametrize(("rates", "time"), [((0, 0, 0), 5), (RATES, 0)])
def test_nothing_moves_at_rest_or_at_once(rates, time):
    q, omega = integrate(BODY, rates, (0, 3, 0, 4), Fraction(time))
    assert distance(q, (0, 0.6, 0, 0.8)) < 1e-16
    assert distance(omega, map(mp.convert, rates)) < 1e-17


def test_it_imports_nothing_of_the_project():
    tree = ast.parse(Path(taylor.__file__).read_text("utf-8"))
    imported = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert not any(name.startswith("rigidsym") for name in imported)
