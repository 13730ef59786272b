"""Rings of motions: where the turn is a symmetry of the body, each motion that arrives has a
circle of others beside it, with the same momentum and energy, all round its polhode (facts
ring.kinematics, ring.momentum, ring.euler).

They differ in their bursts where there are spins, and in their largest rates.
"""

from collections.abc import Callable
from itertools import product

import numpy as np

from rigidsym.manoeuvre.bursts import Burns
from rigidsym.manoeuvre.directions import is_symmetry
from rigidsym.manoeuvre.problem import IDENTITY
from rigidsym.manoeuvre.transit import phases

Values = Callable[[np.ndarray], np.ndarray]

_PHASES = 64
# Then to a part of 3e-14 of the ring.
_FINER, _ROUNDS = 8, 13
_ARRIVED = 1e-9
# Half turns about the principal axes take polhodes to polhodes.
_IMAGES = np.array([signs for signs in product((1, -1), repeat=3) if np.prod(signs) == 1])


def matter(burns: Burns) -> bool:
    """Whether motions of a ring differ in what they cost or in what they need."""
    return is_symmetry(burns.problem) and (burns.spin > 0 or bool(np.isfinite(burns.max_rate)))


def cheapest(burns: Burns, rates: np.ndarray, duration: float) -> np.ndarray:
    """Of the ring of each of the motions with rates (N, 3), the one within the limits whose bursts
    cost least, or the one that is nearest to the limits."""

    def excess(found: np.ndarray) -> np.ndarray:
        return burns.excess(found, duration)

    def cost(found: np.ndarray) -> np.ndarray:
        return np.where(excess(found) <= 1, burns.sizes(found, duration).sum(axis=1), np.inf)

    found = least(burns, rates, cost)
    beyond = ~burns.allowed(found, duration)
    found[beyond] = least(burns, rates[beyond], excess)
    return found


def least(burns: Burns, rates: np.ndarray, values: Values) -> np.ndarray:
    """Of the ring of each of the motions with rates (N, 3), the one of least value."""
    return np.array([_least(burns, one, values) for one in rates]).reshape(-1, 3)


def _least(burns: Burns, rates: np.ndarray, values: Values) -> np.ndarray:
    def of(found: np.ndarray) -> np.ndarray:
        missed = np.linalg.norm(burns.problem.misses(found), axis=1)
        return np.where(missed < _ARRIVED, values(found), np.inf)

    shares = np.arange(_PHASES) / _PHASES
    images = _along(burns, rates, shares) * _IMAGES[:, None]
    image, place = divmod(int(np.argmin(of(images.reshape(-1, 3)))), _PHASES)
    share, width, found = shares[place], 1 / _PHASES, images[image]
    for _ in range(_ROUNDS):
        near = share + width * np.arange(-_FINER, _FINER + 1) / _FINER
        found = _along(burns, rates, near) * _IMAGES[image]
        place = int(np.argmin(of(found)))
        share, width = near[place], width / _FINER
    return found[place] if np.isfinite(of(found[place : place + 1])[0]) else rates


def _along(burns: Burns, rates: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Rates (N, 3) on the ring of rates (3,), shares (N,) of it further on."""
    problem, size = burns.problem, burns.problem.momenta(rates)
    if size == 0:
        return np.zeros((len(shares), 3))
    period = phases(problem, (problem.inertia * rates / size)[None]).period[0] / size
    if not np.isfinite(period):
        return _turned(burns, rates, 2 * np.pi * shares)
    _, later = problem.engine.propagate(problem.inertia, rates, IDENTITY, shares * period)
    return later


def _turned(burns: Burns, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Rates (N, 3) of whole turns about other axes of the same moment; else the same rates."""
    frame = None if burns.problem.angle else _equal_axes(burns, rates)
    if frame is None:
        return np.tile(rates, (len(angles), 1))
    size = np.linalg.norm(rates)
    return size * np.stack([np.cos(angles), np.sin(angles)], axis=-1) @ frame


def _equal_axes(burns: Burns, rates: np.ndarray) -> np.ndarray | None:
    """Two axes (2, 3) of the moment of a spin: of a sphere, those next to the spins outside."""
    c = burns.problem.inertia
    if c.min() == c.max():
        return np.linalg.svd([burns.before, burns.after])[2][:2]
    equal = c == c[np.argmax(np.abs(rates))]
    return np.eye(3)[equal] if equal.sum() == 2 else None
