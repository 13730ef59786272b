"""Taylor polynomials of symbolic solutions, and the start, where what is subtracted is the same."""

import mpmath
import pytest
import sympy as sp
from symbolic_motions import ATTITUDE, MOTIONS, motion_of

from rigidsym import InputError, symbolic
from rigidsym.solution.symbolic import FORMS

STEP = sp.Rational(1, 10**6)


@pytest.mark.parametrize("form", FORMS)
def test_taylor_polynomials_are_the_motion(form):
    """Eight terms leave out 1e-48 and less of a millionth of a second."""
    motion = motion_of(form)
    expected = motion.precise(STEP, 50)
    with mpmath.workdps(60):
        for column, values in zip(motion.symbolic(form).taylor(8), expected, strict=True):
            for entry, value in zip(column, values, strict=True):
                found = sp.N(entry.subs(motion.symbolic(form).t, STEP), 60)
                assert abs(found._to_mpmath(200) - value) < 1e-40


def test_coefficients_are_exact():
    q, omega = motion_of("pi").symbolic("pi").taylor(3)
    (c1, c2, c3), (w1, w2, w3) = MOTIONS["pi"]
    t = sp.Symbol("t", real=True)
    assert omega[0].coeff(t, 0) == w1
    assert omega[0].coeff(t, 1) == sp.Rational((c2 - c3) * w2 * w3, c1)
    assert not q.atoms(sp.Float) | omega.atoms(sp.Float)
    assert [sp.N(x, 30) for x in q.subs(t, 0)] == [
        sp.N(sp.Rational(x) / sp.sqrt(sum(sp.Rational(y) ** 2 for y in ATTITUDE)), 30)
        for x in ATTITUDE
    ]


@pytest.mark.parametrize("form", ["pi", "theta", "symmetric"])
def test_taylor_polynomials_with_free_symbols_take_numbers(form):
    """By the handedness of the axes a, b, d, whatever it is."""
    solution, own = symbolic(form), motion_of(form).symbolic(form)
    numbers = {**own.constants}
    free = solution.taylor(4)[1].subs(numbers).subs(solution.t, STEP)
    found = sorted(sp.N(x, 25) for x in free)
    expected = sorted(sp.N(x, 25) for x in own.taylor(4)[1].subs(own.t, STEP))
    assert all(abs(x - y) < 1e-20 for x, y in zip(found, expected, strict=True))


def test_about_another_instant():
    solution = motion_of("symmetric").symbolic("symmetric")
    q, omega = solution.taylor(2, at=2)
    later = 2 + STEP
    for one, other in ((q, solution.q(later)), (omega, solution.omega(later))):
        assert abs(sp.N(one[1].subs(solution.t, later) - other[1], 30)) < 1e-11


def test_a_series_has_a_term():
    with pytest.raises(InputError, match="n = 0: a series has at least one term"):
        symbolic("pi").taylor(0)


@pytest.mark.parametrize("form", ["pi", "separatrix", "symmetric"])
def test_the_start_is_the_attitude_itself(form):
    """psi vanishes there as an expression: its digits are not looked for one after the other."""
    found = motion_of(form).symbolic(form).q(0)
    assert not any(isinstance(x, sp.tanh) for x in found.atoms(sp.cos))
    size = sp.sqrt(sum(sp.Rational(x) ** 2 for x in ATTITUDE))
    for one, given in zip(found, ATTITUDE, strict=True):
        assert abs(sp.N(one, 50) - sp.N(sp.Rational(given) / size, 60)) < 1e-49
        assert not one.has(sp.cos, sp.sin) or form == "symmetric"
