"""Observations against parameters: residuals in units of their errors, and their derivatives."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rigidsym.fitting.observations import Observations
from rigidsym.fitting.parameters import Parameters, Point, observed
from rigidsym.fitting.states import sensitivities, states


@dataclass(frozen=True, slots=True)
class Prior:
    """What is known of the moments: (3,) and the matrix (3, 3) that whitens their errors."""

    moments: np.ndarray
    weights: np.ndarray


@dataclass(frozen=True)
class Problem:
    """Which motion shows these observations?  One row of residuals for each number observed.

    Parameters are those of the state at `epoch`, s: in the midst of the observations, since next to
    a separatrix errors grow by exp(rate time) both ways, and doubles hold only so much of it.
    """

    sets: tuple[Observations, ...]
    parameters: Parameters
    prior: Prior | None = None
    engine: str = "numpy"
    epoch: float = 0.0

    @cached_property
    def times(self) -> np.ndarray:
        """All times of observation, each once, (N,), s."""
        return np.unique(np.concatenate([one.t for one in self.sets]))

    @cached_property
    def places(self) -> list[np.ndarray]:
        """Where the times of each set are in them."""
        return [np.searchsorted(self.times, one.t) for one in self.sets]

    @cached_property
    def since(self) -> np.ndarray:
        """The times, (N,), since the epoch, s."""
        return self.times - self.epoch

    @property
    def span(self) -> float:
        """From the first time to the last, and to the epoch if that is farther, s."""
        return float(max(np.ptp(self.times), np.max(np.abs(self.since))))

    @cached_property
    def rows(self) -> list[np.ndarray]:
        """Of each set the rows (N, width) of its observations among the residuals."""
        sizes = [one.count * one.width for one in self.sets]
        ends = np.cumsum([0, *sizes])
        return [
            np.arange(first, first + size).reshape(one.count, one.width)
            for first, size, one in zip(ends, sizes, self.sets, strict=False)
        ]

    @property
    def count(self) -> int:
        """How many residuals there are."""
        own = sum(one.count * one.width for one in self.sets)
        return own + (3 if self.prior else 0)

    def residuals(self, point: Point) -> np.ndarray:
        """(..., count)."""
        return self.missed(point, *states(point, self.since, self.engine))

    def missed(self, point: Point, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """The same by states of the principal axes at the times, (..., N, 4) and (..., N, 3)."""
        seen = point.seen(q, omega)
        parts = []
        for one, at in zip(self.sets, self.places, strict=True):
            found = one.residuals(*(x[..., at, :] for x in seen))
            parts.append(_flat(one.whitened(found[..., None]))[..., 0])
        if self.prior:
            parts.append((point.moments - self.prior.moments) @ self.prior.weights.T)
        return np.concatenate(parts, axis=-1)

    def linearised(self, point: Point, own: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Residuals (..., count) and their derivatives (..., count, p).

        own (..., 12, p): see `Parameters.own`.
        """
        q, omega, sensitivity = sensitivities(point, self.since, self.engine)
        seen = point.seen(q, omega)
        moved = observed(point, *seen, sensitivity, own)
        residuals, slopes = [], []
        for one, at in zip(self.sets, self.places, strict=True):
            state = [x[..., at, :] for x in seen]
            found = one.residuals(*state)
            slope = one.derivatives(*state, found) @ moved[..., at, :, :]
            residuals.append(_flat(one.whitened(found[..., None]))[..., 0])
            slopes.append(_flat(one.whitened(slope)))
        if self.prior:
            residuals.append((point.moments - self.prior.moments) @ self.prior.weights.T)
            slopes.append(self.prior.weights @ own[..., 6:9, :])
        return np.concatenate(residuals, axis=-1), np.concatenate(slopes, axis=-2)


def _flat(rows: np.ndarray) -> np.ndarray:
    """(..., N, width, p) as (..., N width, p)."""
    *leading, count, width, p = rows.shape
    return rows.reshape(*leading, count * width, p)
