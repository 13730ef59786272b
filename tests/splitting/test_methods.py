"""The coefficients of splitting methods have the orders that are said of them."""

import pytest
from splitting_words import defect, weak

from rigidsym.errors import InputError
from rigidsym.splitting._methods import METHODS, Method, checked

ROUNDING = 1e-14
CASES = pytest.mark.parametrize("method", METHODS.values(), ids=METHODS)


@CASES
def test_a_method_has_its_orders(method):
    first, second = method.orders
    assert max(defect(method, n) for n in range(1, second + 1)) < ROUNDING
    assert max(defect(method, n, weak) for n in range(1, first + 1)) < ROUNDING


@CASES
def test_a_method_has_no_higher_orders(method):
    first, second = method.orders
    assert defect(method, second + 1) > 1e-6
    assert defect(method, first + 1, weak) > 1e-8


@CASES
def test_a_method_names_its_source(method):
    assert any(character.isdigit() for character in method.source)


def test_a_coefficient_that_is_wrong_is_noticed():
    saba2 = METHODS["saba2"]
    end = saba2.drifts[0] + 1e-6
    moved = Method((end, 1 - 2 * end, end), saba2.kicks, saba2.orders, "none")
    assert defect(moved, 3, weak) > 1e-7


@pytest.mark.parametrize(
    ("drifts", "kicks", "rule"),
    [
        ((0.5, 0.5), (0.5, 0.5), "begins and ends"),
        ((0.25, 0.75), (1.0,), "begins and ends"),
        ((0.5, 0.5), (0.9,), "whole step"),
    ],
)
def test_a_table_that_is_no_symmetric_splitting_is_refused(drifts, kicks, rule):
    with pytest.raises(ValueError, match=rule):
        Method(drifts, kicks, (2, 2), "none")


@pytest.mark.parametrize("name", ["saba3", None, 2])
def test_an_unknown_method_is_refused(name):
    with pytest.raises(InputError, match=r"method = .*must be one of: strang, saba2"):
        checked(name)
