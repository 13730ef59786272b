"""Functions of elapsed time: two methods agree, and boxes hold the values of their points."""

from fractions import Fraction
from random import Random

import pytest
from flint import arb, arb_mat

from rigidsym.precise._balls import ball, working
from rigidsym.precise._functions import Quadrature, Theta
from rigidsym.precise._sensitivity.elapsed import Elapsed, Range, elapsed, until_quarter

PARAMETERS = [("2", "1"), ("2", "1.999999"), ("1", "1e-20"), ("1", "0"), ("1", "1"), ("0", "0")]


def found(t, p, r, functions):
    p, r = Fraction(p), Fraction(r)
    return elapsed(ball(Fraction(t)), *map(ball, (p, r, p - r)), functions)


@pytest.mark.parametrize(("p", "r"), PARAMETERS)
@pytest.mark.parametrize("t", ["0.3", "-1.7", "25"])
def test_two_methods_agree_and_rates_are_theirs(p, r, t):
    step = Fraction(1, 2**80)
    with working(300):
        now = found(t, p, r, Theta())
        for one, other in zip(now, found(t, p, r, Quadrature()), strict=True):
            assert one.overlaps(other)
            assert one.rad() < 1e-30
        before, after = (found(Fraction(t) + x, p, r, Theta()) for x in (-step, step))
        s, c, d, _, f = now
        by_p, by_r = -ball(Fraction(p)) * s * d, -ball(Fraction(r)) * s * c
        rates = c * d, by_p, by_r, s * s, (s * s + by_r * f) / d
        for rate, x, y in zip(rates, before, after, strict=True):
            assert abs((y - x) / (2 * ball(step)) - rate) < 1e-40 * (1 + abs(rate))


BOXES = {
    "regular": ("2", "1", "1e-3", "1e-3"),
    "wide": ("2", "1", "0.1", "0.05"),
    "symmetric inside": ("1", "1e-5", "1e-3", "1e-4"),
    "separatrix inside": ("1", "1", "1e-4", "1e-4"),
    "near it": ("1", "0.9999", "1e-5", "1e-6"),
    "about zero": ("0", "0", "1e-4", "5e-5"),
}


@pytest.mark.parametrize("box", BOXES)
@pytest.mark.parametrize("t", ["0.5", "-3", "7", "40"])
def test_functions_over_a_box_hold_those_of_its_points(box, t):
    p, r, wide_p, wide_r = map(Fraction, BOXES[box])
    with working(150):
        time, middle = ball(Fraction(t)), found(t, p, r, Theta())
        apart = [arb(0, ball(x).upper()) for x in (wide_p, wide_p + wide_r)]
        balls = [ball(x) + arb(0, ball(y)) for x, y in (
            (p, wide_p), (r, wide_r), (p - r, wide_p + wide_r))]  # fmt: skip
        whole = Range(time, *balls, until_quarter(time, *map(ball, (p, r, p - r))))
        over = whole.over(middle, arb_mat([[x] for x in apart]))
        if over is None:
            # Where D may be zero, or functions may be anything.
            assert box in ("wide", "separatrix inside", "near it")
            assert abs(Fraction(t)) > 5
            return
        values, slopes = over
        random = Random(5)
        for _ in range(20):
            shifts = [Fraction(random.choice((-1, 1, random.uniform(-1, 1)))) for _ in "pr"]
            x, y = p + shifts[0] * wide_p, r + shifts[1] * wide_r
            if y < 0 or y > x:
                continue  # other axes, or none of this function's
            point = found(t, x, y, Theta())
            moved = slopes * arb_mat([[ball(x - p)], [ball((x - y) - (p - r))]])
            for k in range(5):
                assert values[k].contains(point[k])
                assert (middle[k] + moved[k, 0]).overlaps(point[k])


def test_slopes_are_what_differences_tend_to():
    p, r, t, step = Fraction(2), Fraction(13, 10), "2.7", Fraction(1, 2**90)
    with working(400):
        middle = found(t, p, r, Theta())
        slopes = Range(ball(Fraction(t)), ball(p), ball(r), ball(p - r)).slopes(middle)
        ends = found(t, p + step, r + step, Theta()), found(t, p, r - step, Theta())
        for j, end in enumerate(ends):
            for k, _ in enumerate(Elapsed._fields):
                difference = (end[k] - middle[k]) / ball(step)
                assert abs(difference - slopes[k, j]) < arb(2) ** -80
