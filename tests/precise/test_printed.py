"""Printed balls contain the balls that they print."""

from fractions import Fraction

import pytest
from flint import arb, ctx
from hypothesis import given
from hypothesis import strategies as st

from rigidsym.precise._printed import printed_ball, printed_rational


def rational(value):
    mantissa, exponent = map(int, value.man_exp())
    return mantissa * Fraction(2) ** exponent


def contains(shown, middle, radius):
    return abs(Fraction(shown["mid"]) - middle) + radius <= Fraction(shown["rad"])


@given(
    st.integers(-(2**200), 2**200), st.integers(-400, 400), st.integers(0, 2**40),
    st.integers(-900, 300),
)  # fmt: skip
def test_what_is_printed_contains_the_ball(mantissa, exponent, radius, smaller):
    with ctx.workprec(250):
        ball = arb((mantissa, exponent), (radius, smaller))
        middle, size = rational(ball.mid()), rational(ball.rad())
        shown = printed_ball(ball)
    assert contains(shown, middle, size)
    assert Fraction(shown["rad"]) <= size * Fraction(102, 100)
    if size:
        assert len(shown["rad"].partition("E")[0].replace(".", "").strip("0")) <= 3


@given(st.fractions(), st.integers(1, 60))
def test_rationals_too(value, digits):
    shown = printed_rational(value, digits)
    assert contains(shown, value, 0)
    assert Fraction(shown["rad"]) <= abs(value) * Fraction(10) ** (1 - digits)


# Arb rounds a radius up when it takes one over.
@pytest.mark.parametrize(
    ("ball", "mid", "rad"),
    [
        (arb(0), "0", "0"),
        (arb(0.375), "0.375", "0"),
        (arb(-12, 0), "-12", "0"),
        (arb(3, 2), "3.00", "2.01"),
        (arb(0, 0.5), "0", "0.501"),
        (arb(5, 1e-30), "5.00000000000000000000000000000000", "1.01E-30"),
        (arb(2) ** -3 + arb(0, 0.0625), "0.1250", "0.0626"),
    ],
)
def test_examples(ball, mid, rad):
    shown = printed_ball(ball)
    assert shown["mid"] == mid
    assert Fraction(shown["rad"]) == Fraction(rad)


def test_more_digits_than_python_prints_integers_with():
    with ctx.workprec(20_000):
        shown = printed_ball(arb(1) / 3)
    assert shown["mid"].startswith("0.33333")
    assert len(shown["mid"]) > 6000
