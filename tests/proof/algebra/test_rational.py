"""Factors, quotients and roots by FLINT are those that SymPy finds."""

import pytest
import sympy
from sympy import I, S, cos, exp, sin, sqrt, srepr, symbols

from rigidsym.proof.algebra import _rational
from rigidsym.proof.algebra._computation import compute

x, y, z, c_10, c_2 = symbols("x y z c_10 c_2", real=True)
RATIONAL = [
    *(S(3), S(0), x, 2 * x, x - x, -1 / x, x / (1 - x), 1 / (2 - 2 * x), -x - y, y - x),
    *(x / 2 + y / 3, (x / 2 + y / 3) / 7, 2 / (3 * x + 6 * y), (1 / x + 1 / y) ** -2),
    *(
        (x**2 - y**2) / (2 * x - 2 * y),
        (x - y) * (1 - x) ** 3 / (3 - x) / 5,
        (x + 1) ** 2 / (x + 1),
    ),
    *(c_10 * c_2 - c_2**2, (c_10 - x) / (c_2 - c_10) + 1, x**4 + 4 * y**4 - z * (x - z) * 0),
    x / (y + z) + y / (x + z) + z / (x + y) + S(1) / 6,
]
# Functions are variables; what is no rational function is SymPy's.
OTHERS = [
    *(cos(x) ** 2 / 2 - sin(x) / (2 * cos(x)) * x, cos(x / y) * x - x**2, I * x - y, I * x**2),
    *(exp(2 * x) - 1, sqrt(x) * x - x, 0.5 * x + y, x ** S("1/2")),
]


@pytest.mark.parametrize("value", [*RATIONAL, *OTHERS], ids=str)
def test_factors_and_quotients_are_those_of_sympy(value):
    assert srepr(_rational.factor(value)) == srepr(sympy.factor(value))
    assert srepr(_rational.cancel(value)) == srepr(sympy.cancel(value))


@pytest.mark.parametrize(
    ("value", "root"),
    [
        (x * y - 1 + x, 1 / (y + 1)),
        (x / (x + y) - 2, -2 * y),
        (x * (y - 1) - (y - 1) * y, y),
        (x * cos(y) - 3, 3 / cos(y)),
        (x**2 - 1, None),
        (y - 1, None),
        (x * y / x - 1, None),
        (sqrt(x) - 1, None),
    ],
    ids=str,
)
def test_the_root_of_what_is_linear_is_a_quotient(value, root):
    assert _rational.root(value, x) == root


def test_only_one_solution_is_taken():
    assert compute(x * y - y**2).solve_for(x).value == y
    assert compute(1 - 2 * x**2).solve_for(x**2).value == S("1/2")
    with pytest.raises(ValueError, match="x: 2 solutions"):
        compute(x**2 - 1).solve_for(x)
    with pytest.raises(ValueError, match="x: 0 solutions"):
        compute(y - 1).solve_for(x)


def test_what_is_put_in_is_what_sympy_puts_in():
    turned = compute(x - 2 * y).subs({x: y, y: x})
    assert turned.value == (x - 2 * y).subs({x: y, y: x})
    assert compute(x - 2 * y).subs({x: z, y: 2}).value == z - 4
    area = sympy.Integral(x * y, (x, 0, y))
    assert compute(area).subs({x: z, y: 1}).value == area.subs({x: z, y: 1})
