"""Decisions of the hand-written runtimes are those of the ledger's partition of motions.

Which motion it is depends on nothing but the order of the moments and which are equal, the signs of
the rates, and the sign of E_b: each combination is tried, in NumPy, one body and many, and in C.
"""

import ctypes
from collections import Counter
from fractions import Fraction
from functools import cache
from itertools import permutations, product

import numpy as np
import pytest
from compilers import PORTABLE, Library, needed

from rigidsym._codegen.functions import functions
from rigidsym._codegen.lines import flat_results
from rigidsym.generated import torque_free
from rigidsym.solution import sealed
from rigidsym.solution._polhode import Regime, classify

# Moments, largest first; E_b is 9/16 Omega_1^2 - Omega_3^2 for the first.
BODIES = ((2.25, 2.0, 1.0), (2.0, 2.0, 1.0), (2.0, 1.0, 1.0), (1.0, 1.0, 1.0))
RATES = tuple(
    (4.0 * x, 0.5 * y, size * z)
    for x, y, z in product((-1, 0, 1), repeat=3)
    for size in ((1.0, 3.0, 6.0) if z else (1.0,))
)
PATTERNS = [
    (tuple(body[k] for k in order), tuple(rates[k] for k in order))
    for body, rates, order in product(BODIES, RATES, permutations(range(3)))
]
BRANCHES = ("steady", "circular", "hyperbolic")
SIZES = {
    function.name.split("_")[1]: len(flat_results(function))
    for function in functions(sealed())
    if function.rounds
}


@cache
def decided(inertia, omega):
    return classify([Fraction(x) for x in inertia], [Fraction(x) for x in omega])


def in_numpy(*given):
    """Return branch, axes and gains of every body, in order."""
    made = torque_free.prepare(*given)
    found = {}
    for branch, index, constants in made["groups"]:
        for place, body in enumerate(index.tolist()):
            gains = [float(constants[f"gain_{x}"][place]) for x in "abd" if branch != "steady"]
            found[body] = branch, tuple(made["axes"][body].tolist()), gains
    return [found[body] for body in range(len(found))]


@cache
def at_once():
    return in_numpy(*map(np.array, zip(*PATTERNS, strict=True)))


class Head(ctypes.Structure):
    """The first members of torque_free_motion."""

    _fields_ = (
        *(("branch", ctypes.c_int), ("axis", ctypes.c_int * 3), ("blurred", ctypes.c_int)),
        ("prepared", ctypes.c_int),
        *(("unit", ctypes.c_double), ("max_angle", ctypes.c_double)),
        *(("q0", ctypes.c_double * 4), ("omega0", ctypes.c_double * 3)),
    )


def in_c(here):
    library = Library(needed("gcc"), here, *PORTABLE)
    for inertia, omega in PATTERNS:
        code, prepared = library.prepare(inertia, omega)
        assert code == 0
        head = Head.from_buffer(prepared)
        branch = BRANCHES[head.branch]
        constants = np.frombuffer(prepared, float, SIZES[branch], ctypes.sizeof(Head))
        yield branch, tuple(head.axis), constants[-3:].tolist()


@pytest.fixture(scope="module", params=["one by one", "at once", "in C"])
def found(request, here):
    """Return branch, axes and gains of the rates for every pattern."""
    if request.param == "in C":
        return list(in_c(here))
    if request.param == "at once":
        return at_once()
    return [one for pattern in PATTERNS for one in in_numpy(*pattern)]


def test_every_regime_is_tried():
    count = Counter(decided(*pattern).regime for pattern in PATTERNS)
    assert set(count) == set(Regime)
    assert len(PATTERNS) == 4 * 9 * 7 * 6


def test_steadiness_and_the_axis_of_circulation_are_those_of_the_partition(found):
    for (inertia, omega), (branch, axes, _) in zip(PATTERNS, found, strict=True):
        polhode = decided(inertia, omega)
        assert (branch == "steady") == polhode.regime.steady, (inertia, omega)
        if not polhode.regime.steady:
            assert axes[0] == polhode.axes[0], (inertia, omega)
            assert len(set(inertia)) < 3 or axes == polhode.axes, (inertia, omega)


def test_signs_are_those_of_the_moments_and_rates_about_these_axes(found):
    """gain_a, gain_b and gain_d have the signs sigma, chi and chi tau, tau = -rho epsilon sigma."""
    for (inertia, omega), (branch, axes, gains) in zip(PATTERNS, found, strict=True):
        if branch == "steady":
            continue
        a, b, d = axes
        epsilon = 1 if (b - a) % 3 == 1 else -1
        sigma = -1 if omega[a] < 0 else 1
        rho = -1 if inertia[a] < inertia[d] else 1
        tau = -rho * epsilon * sigma
        chi = -1 if tau * omega[d] < 0 else 1
        assert [np.sign(x) for x in gains] == [sigma, chi, chi * tau], (inertia, omega)
        polhode = decided(inertia, omega)
        if len(set(inertia)) == 3:
            assert (epsilon, sigma, rho, chi) == (
                *(polhode.epsilon, polhode.sigma),
                *(polhode.rho, polhode.chi),
            )


def test_all_take_the_same_branch(found):
    """k_1^2 <= 1/2 takes the circular one."""
    for pattern, (branch, _, _), (other, _, _) in zip(PATTERNS, found, at_once(), strict=True):
        assert branch == other, pattern
    assert {branch for branch, _, _ in found} == set(BRANCHES)
