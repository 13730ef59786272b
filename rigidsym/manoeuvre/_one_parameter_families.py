"""One-parameter families of motions, where the turn is a symmetry of the body.

Each motion that arrives then has others beside it, with the same momentum and energy, all round its
polhode (facts ring.kinematics, ring.momentum, ring.euler).  They differ in their bursts where there
are spins, and in their largest rates.
"""

from collections.abc import Callable
from itertools import product

import numpy as np

from rigidsym.manoeuvre._bursts import Bursts
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._problem import IDENTITY
from rigidsym.manoeuvre._transit import phases

Values = Callable[[np.ndarray], np.ndarray]

_PHASES = 64
# These rounds reach a part of 3e-14 of the family.
_FINER, _ROUNDS = 8, 13
_ARRIVED = 1e-9
# Half turns about the principal axes take polhodes to polhodes.
_IMAGES = np.array([signs for signs in product((1, -1), repeat=3) if np.prod(signs) == 1])


def matter(bursts: Bursts) -> bool:
    """Return whether motions of a family differ in cost or in the limits they need."""
    return is_symmetry(bursts.problem) and (bursts.spin > 0 or bool(np.isfinite(bursts.max_rate)))


def cheapest(bursts: Bursts, rates: np.ndarray, duration: float) -> np.ndarray:
    """Return the cheapest motion within the limits of the family of each motion, rates (N, 3).

    Where none is within them, it is the one nearest to the limits.
    """

    def excess(found: np.ndarray) -> np.ndarray:
        return bursts.excess(found, duration)

    def cost(found: np.ndarray) -> np.ndarray:
        return np.where(excess(found) <= 1, bursts.sizes(found, duration).sum(axis=1), np.inf)

    found = least(bursts, rates, cost)
    beyond = ~bursts.allowed(found, duration)
    found[beyond] = least(bursts, rates[beyond], excess)
    return found


def least(bursts: Bursts, rates: np.ndarray, values: Values) -> np.ndarray:
    """Return the motion of least value of the family of each motion, rates (N, 3)."""
    return np.array([_least(bursts, one, values) for one in rates]).reshape(-1, 3)


def _least(bursts: Bursts, rates: np.ndarray, values: Values) -> np.ndarray:
    def of(found: np.ndarray) -> np.ndarray:
        missed = np.linalg.norm(bursts.problem.misses(found), axis=1)
        return np.where(missed < _ARRIVED, values(found), np.inf)

    shares = np.arange(_PHASES) / _PHASES
    images = _along(bursts, rates, shares) * _IMAGES[:, None]
    image, place = divmod(int(np.argmin(of(images.reshape(-1, 3)))), _PHASES)
    share, width, found = shares[place], 1 / _PHASES, images[image]
    for _ in range(_ROUNDS):
        near = share + width * np.arange(-_FINER, _FINER + 1) / _FINER
        found = _along(bursts, rates, near) * _IMAGES[image]
        place = int(np.argmin(of(found)))
        share, width = near[place], width / _FINER
    return found[place] if np.isfinite(of(found[place : place + 1])[0]) else rates


def _along(bursts: Bursts, rates: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Return rates (N, 3) in the family of rates (3,), shares (N,) of it further on."""
    problem, size = bursts.problem, bursts.problem.momenta(rates)
    if size == 0:
        return np.zeros((len(shares), 3))
    period = phases(problem, (problem.inertia * rates / size)[None]).period[0] / size
    if not np.isfinite(period):
        return _turned(bursts, rates, 2 * np.pi * shares)
    _, later = problem.engine.propagate(problem.inertia, rates, IDENTITY, shares * period)
    return later


def _turned(bursts: Bursts, rates: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """Return rates (N, 3) of whole turns about other axes of the same moment; else the same."""
    frame = None if bursts.problem.angle else _equal_axes(bursts, rates)
    if frame is None:
        return np.tile(rates, (len(angles), 1))
    size = np.linalg.norm(rates)
    return size * np.stack([np.cos(angles), np.sin(angles)], axis=-1) @ frame


def _equal_axes(bursts: Bursts, rates: np.ndarray) -> np.ndarray | None:
    """Return two axes (2, 3) of the moment of a spin; of a sphere, those nearest to both spins."""
    c = bursts.problem.inertia
    if c.min() == c.max():
        return np.linalg.svd([bursts.before, bursts.after])[2][:2]
    equal = c == c[np.argmax(np.abs(rates))]
    return np.eye(3)[equal] if equal.sum() == 2 else None
