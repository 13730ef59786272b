"""Rings of motions: where the turn is a symmetry of the body, each motion that arrives has a
circle of others beside it, with the same momentum and energy, all round its polhode (facts
ring.kinematics, ring.momentum, ring.euler)."""

from itertools import product

import numpy as np
from scipy.optimize import minimize_scalar

from rigidsym.manoeuvre.burns import Burns
from rigidsym.manoeuvre.problem import IDENTITY, Problem
from rigidsym.manoeuvre.transit import phases

_PHASES = 64
_ARRIVED = 1e-9
# Half turns about the principal axes take polhodes to polhodes.
_IMAGES = np.array([signs for signs in product((1, -1), repeat=3) if np.prod(signs) == 1])


def cheapest(burns: Burns, rates: np.ndarray, duration: float) -> np.ndarray:
    """Of the ring of each of the motions with rates (N, 3), the one whose bursts cost least."""
    return np.array([_cheapest(burns, one, duration) for one in rates]).reshape(-1, 3)


def _cheapest(burns: Burns, rates: np.ndarray, duration: float) -> np.ndarray:
    problem = burns.problem

    def cost(found: np.ndarray) -> np.ndarray:
        return burns.sizes(found, duration).sum(axis=1)

    shares = np.arange(_PHASES) / _PHASES
    ring = _along(problem, rates, shares)
    images = ring[None] * _IMAGES[:, None]
    arrive = np.linalg.norm(problem.misses(images[:, 0]), axis=-1) < _ARRIVED
    costs = np.where(arrive[:, None], [cost(image) for image in images], np.inf)
    image, best = np.unravel_index(np.argmin(costs), costs.shape)
    near = shares[best] + np.array([-1, 1]) / _PHASES

    def at(share: float) -> np.ndarray:
        return _along(problem, rates, np.array([share])) * _IMAGES[image]

    found = minimize_scalar(
        lambda share: cost(at(share))[0], bounds=near, method="bounded", options={"xatol": 1e-12}
    )
    return at(found.x)[0] if found.fun < costs[image, best] else images[image, best]


def _along(problem: Problem, rates: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Rates (N, 3) on the polhode of rates (3,), shares (N,) of its period later."""
    size = problem.momenta(rates)
    if size == 0:
        return np.zeros((len(shares), 3))
    period = phases(problem, (problem.inertia * rates / size)[None]).period[0] / size
    if not np.isfinite(period):
        return np.tile(rates, (len(shares), 1))
    _, later = problem.engine.propagate(problem.inertia, rates, IDENTITY, shares * period)
    return later
