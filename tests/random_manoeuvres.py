"""Random manoeuvres, and a brute-force search for the cheapest transfer.

The search does not use the planner's geometry.
"""

from fractions import Fraction

import numpy as np

from rigidsym import _engines as engines
from rigidsym.manoeuvre import _manoeuvre as asked_for
from rigidsym.manoeuvre._families import least, refine
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._problem import Problem, problem

BODIES = ("any", "near symmetric", "flat", "rod", "near sphere")
TARGETS = ("any", "half turn", "middle axis", "small", "near symmetry")
# The planner evaluates some 150 motions before it refines any; this is a hundred times as many.
STARTS = 15_000
REFINED = 1000
KINDS = len(BODIES) * len(TARGETS)
BODY, START = (0.0109, 0.04, 0.0506), (1, 0, 0, 0)
SKEW = np.array([2.0, -1.0, 2.0]) / 3


def turn(axis, angle) -> tuple:
    """Return the quaternion of a rotation by an angle about a unit vector."""
    return (np.cos(angle / 2), *(np.sin(angle / 2) * np.asarray(axis)))


def turning(inertia, target, engine="c") -> Problem:
    """Return the transfer problem from the identity to a target in 1 s."""
    return posed(asked_for.manoeuvre(inertia, START, target, 1), engines.engine(engine))


def manoeuvre(index: int, seed: int = 1) -> Manoeuvre:
    """Return a random manoeuvre; its index selects the kinds of body and target."""
    rng = np.random.default_rng([seed, index])
    inertia = _body(rng, BODIES[index % len(BODIES)])
    start = rng.normal(size=4)
    turn = _turn(rng, inertia, TARGETS[index // len(BODIES) % len(TARGETS)])
    p, v = turn[0], turn[1:]
    target = [
        start[0] * p - start[1:] @ v,
        *(start[0] * v + p * start[1:] + np.cross(start[1:], v)),
    ]
    exact = [tuple(map(Fraction, map(float, x))) for x in (inertia, start, target)]
    return Manoeuvre(exact[0], exact[1], exact[2], Fraction(1))


def posed(asked: Manoeuvre, engine) -> Problem:
    return problem(asked.inertia, asked.start, asked.target, engine)


def _body(rng, kind):
    """Return random principal moments of a physical body of a given kind, in any order."""
    a, b = rng.uniform(0.1, 1, size=2)
    c = rng.uniform(abs(a - b), a + b)
    if kind == "near symmetric":
        b = a * (1 + 10 ** rng.uniform(-8, -1) * rng.choice([-1, 1]))
        c = rng.uniform(0.05, 1) * (a + b)
    elif kind == "flat":
        c = (a + b) * (1 - 10 ** rng.uniform(-8, -1))
    elif kind == "rod":
        b = a * rng.uniform(0.98, 1.02)
        c = a * 10 ** rng.uniform(-1.3, -0.5)
        c = max(c, abs(a - b) * 1.01)
    elif kind == "near sphere":
        a, b, c = 1 + 10 ** rng.uniform(-8, -1) * rng.uniform(-1, 1, size=3)
    return rng.permutation([a, b, c]) * 10 ** rng.uniform(-2, 3)


def _turn(rng, inertia, kind):
    turn = rng.normal(size=4)
    if kind == "half turn":
        turn[0] = 0
    elif kind == "middle axis":
        turn = np.eye(4)[1 + np.argsort(inertia)[1]] + 10 ** rng.uniform(-9, -0.5) * turn
    elif kind == "small":
        turn = np.eye(4)[0] + 10 ** rng.uniform(-6, -1) * turn
    elif kind == "near symmetry":
        turn = np.eye(4)[rng.integers(1, 4)] + 10 ** rng.uniform(-9, -0.5) * turn
    return turn / np.linalg.norm(turn)


def brute(problem: Problem, rng, starts: int = STARTS, refined: int = REFINED) -> float:
    """Return the least momentum of a transfer found by a search from random rates.

    The best of the random rates are refined.
    """
    found = arriving(problem, rng, 1.05 * least(problem), starts, refined)
    return float(np.min(problem.momenta(found), initial=np.inf))


def arriving(problem: Problem, rng, bound: float, starts: int, refined: int) -> np.ndarray:
    """Return initial rates (N, 3) that reach the target, refined from random rates.

    bound: that of the momenta of the random rates.  Some rates are there many times.
    """
    direction = rng.normal(size=(starts, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    size = bound * rng.random(starts) ** (1 / 3)
    rates = size[:, None] * direction / problem.inertia
    misses = np.linalg.norm(problem.misses(rates), axis=1)
    best = rates[np.argsort(misses)[:refined]]
    rates, misses = refine(problem, best, rounds=25)
    return rates[misses < 1e-9]
