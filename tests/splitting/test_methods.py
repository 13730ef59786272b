"""Splitting methods have their documented orders, computed word by word.

A step is a product of exponentials of two operators that do not commute, A the free motion and B
the torque.  It has the order n when each word of up to n letters has the coefficient it has in
exp(A + B): 1 over the factorial of its length.  Words with one B make the terms of the first order
in a weak torque.
"""

from itertools import product
from math import factorial

import pytest

from rigidsym.errors import InputError
from rigidsym.splitting._methods import METHODS, Method, checked


def coefficients(method, longest, counts):
    """Return the coefficients of words up to `longest` letters that `counts` accepts."""
    found = {"": 1.0}
    for letter, part in letters(method):
        grown = {}
        for word, value in found.items():
            k = 0
            while len(word) <= longest and counts(word):
                grown[word] = grown.get(word, 0.0) + value
                k += 1
                word, value = word + letter, value * part / k
        found = grown
    return found


def letters(method):
    """Yield the operators of a step and their parts, in order."""
    for drift, kick in zip(method.drifts, method.kicks, strict=False):
        yield "A", drift
        yield "B", kick
    yield "A", method.drifts[-1]


def defect(method, order, counts=lambda word: True):
    """Return the largest difference from exp(A + B) among words of `order` letters."""
    found = coefficients(method, order, counts)
    words = filter(counts, map("".join, product("AB", repeat=order)))
    return max(abs(found.get(word, 0.0) - 1 / factorial(order)) for word in words)


def weak(word):
    """Return True for a word with at most one B."""
    return word.count("B") <= 1


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
