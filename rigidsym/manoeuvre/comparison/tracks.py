"""What can be followed to the target besides a natural motion: turns about the eigenaxis."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.manoeuvre.comparison.cases import Case
from rigidsym.manoeuvre.flight.control import Motion
from rigidsym.quaternions import product

# Of times from 0 to 1 (N,): shares of the turn, and of the turn over the duration as rates.
Profile = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True, slots=True)
class Followed:
    """A track that takes as long as the manoeuvre."""

    duration: float
    motion: Motion


def constant(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """At constant rate: it starts and stops at once, as natural motions do."""
    return x, np.ones_like(x)


def smooth(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """3 x^2 - 2 x^3: from rest to rest with a torque that is linear in time, that of least
    integral of its square for a single axis."""
    return x * x * (3 - 2 * x), 6 * x * (1 - x)


def step(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """At the target from the beginning."""
    return np.ones_like(x), np.zeros_like(x)


def eigenaxis(case: Case, profile: Profile) -> Followed:
    """The shorter way round, about the axis that start and target have in common."""
    return Followed(case.duration, placed(case, partial(turned, case.rotation_vector, profile)))


def turned(vector: np.ndarray, profile: Profile, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Attitudes (N, 4) and rates (N, 3) at times (N,) from 0 to 1, from the start's axes.

    vector (3,): axis times angle, rad.
    """
    share, rate = profile(np.asarray(t))
    angle = np.linalg.norm(vector)
    half, axis = share[:, None] * angle / 2, vector / angle
    return np.hstack([np.cos(half), np.sin(half) * axis]), rate[:, None] * vector


def placed(case: Case, motion: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]) -> Motion:
    """A motion of times from 0 to 1 and from the start's axes, in seconds and inertial axes."""

    def at(t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        x = np.atleast_1d(np.asarray(t, float)) / case.duration
        q, omega = motion(np.clip(x, 0.0, 1.0))
        found = product(case.start, q), omega / case.duration
        return found if np.ndim(t) else (found[0][0], found[1][0])

    return at
