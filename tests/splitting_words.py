"""Order conditions of splittings, decided word by word.

A step is a product of exponentials of two operators that do not commute, A the free motion and B
the torque.  It has the order n when each word of up to n letters has the coefficient it has in
exp(A + B): 1 over the factorial of its length.  Words with one B make the terms of the first order
in a weak torque.
"""

from itertools import product
from math import factorial


def coefficients(method, longest, counts):
    """Of the words of a step, up to so many letters, that `counts` lets pass."""
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
    """The operators of a step and their parts, in their order."""
    for drift, kick in zip(method.drifts, method.kicks, strict=False):
        yield "A", drift
        yield "B", kick
    yield "A", method.drifts[-1]


def defect(method, order, counts=lambda word: True):
    """The largest difference from exp(A + B) among words of exactly so many letters."""
    found = coefficients(method, order, counts)
    words = filter(counts, map("".join, product("AB", repeat=order)))
    return max(abs(found.get(word, 0.0) - 1 / factorial(order)) for word in words)


def weak(word):
    """Of the first order in B."""
    return word.count("B") <= 1
