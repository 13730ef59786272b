"""The exponential of the C target: its polynomial, its bound, and the whole of it as lets."""

from fractions import Fraction

import mpmath
import pytest
from mpmath import mpf
from values import value_of

from rigidsym._codegen.special_functions import exponential

TERMS = exponential.coefficients(exponential.TERMS)
NUMBERS = {constant.name: constant.hi for constant in exponential.constants()}
REACH = mpf("0.3467")


@pytest.mark.parametrize("k", range(-20, 21))
def test_the_polynomial_is_within_its_bound(k):
    with mpmath.workdps(50):
        r = mpf(k) / 21 * REACH
        value = 1 + r + r**2 / 2 + sum(term * r ** (n + 3) for n, term in enumerate(TERMS))
        assert abs(value / mpmath.exp(r) - 1) <= exponential.bound(TERMS) < 2.0**-54


def test_a_wrong_coefficient_shows():
    wrong = (*TERMS[:4], TERMS[4] * (1 + 1e-9), *TERMS[5:])
    assert exponential.bound(wrong) > 2.0**-53


def test_log_2_in_two():
    assert (Fraction(NUMBERS["log_2_short"]) * 2**32).denominator == 1
    with mpmath.workdps(40):
        both = NUMBERS["log_2_short"] + mpf(NUMBERS["log_2_rest"])
        assert abs(both - mpmath.ln2) < mpf(2) ** -86
        assert mpmath.ln2 / 2 * (1 + mpf(2) ** -40) < REACH


@pytest.mark.parametrize(
    ("x", "bound"), [(0.0, 0), (-1e-300, 0), (-0.5, 1e-16), (-37.4, 1e-16), (-707.9, 1e-16)]
)
def test_the_lets_in_doubles(x, bound):
    found = run(x)
    with mpmath.workdps(40):
        assert abs(found / mpmath.exp(x) - 1) <= 2 * bound


@pytest.mark.parametrize("x", [-708.5, -1e300, float("-inf")])
def test_what_is_too_small_is_zero(x):
    assert run(x) == 0.0


def run(x):
    known = NUMBERS | {"x": x}
    functions = {
        "choose": lambda x, y, one, other: one if x <= y else other,
        "nearest": lambda value: (value + 1.5 * 2.0**52) - 1.5 * 2.0**52,
        "power_of_two": lambda n: 2.0**n,
    }
    for let in exponential.function().lets:
        known[let.targets[0]] = value_of(let.expression, known, functions)
    return known["value"]
