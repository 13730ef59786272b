"""Quantities of a fit: the state at t = 0, the moments and the axes, against the parameters."""

from dataclasses import dataclass

import numpy as np

from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.states import sensitivities, states
from rigidsym.quaternions import conjugate, inverse_left_jacobian, product, rotation_vectors

NAMES = (
    *("attitude 1", "attitude 2", "attitude 3", "omega 1", "omega 2", "omega 3"),
    *("moment 1", "moment 2", "moment 3", "axes 1", "axes 2", "axes 3"),
)


@dataclass(frozen=True, slots=True)
class Quantities:
    """Quantities of motions near the best point: a turn at t = 0 along inertial axes, rad; omega0,
    rad/s; the moments; and, where they are estimated, the turn of the axes, rad.

    The observations do not tell the scale of the moments without a prior: their unit is then what
    is the largest moment of the best point.
    """

    problem: Problem
    best: Point

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities, k of them."""
        return NAMES if self.problem.parameters.axes else NAMES[:9]

    def rows(self, point: Point, own: np.ndarray) -> np.ndarray:
        """Return the derivatives (..., k, p) by the parameters, at points.

        own (..., 12, p): see `Parameters.own` and `Parameters.linear`.  The turns are those at the
        points themselves.
        """
        _, _, since = sensitivities(point, self._zero, self.problem.engine)
        found = own.copy()
        found[..., :6, :] = since[..., 0, :, :] @ own[..., :9, :]
        if self.problem.prior is None:
            largest, unit = self._unit(point)
            share = (point.moments / point.moments[..., [largest]])[..., None]
            alone = own[..., [6 + largest], :]
            found[..., 6:9, :] = unit[..., None] * (own[..., 6:9, :] - share * alone)
        return found[..., : len(self.names), :]

    def apart(self, points: Point) -> np.ndarray:
        """Return how far the quantities of motions (B,) are from those of the best, (B, k)."""
        q, omega = states(points, self._zero, self.problem.engine)
        best_q, best_omega = states(self.best, self._zero, self.problem.engine)
        moments = points.moments
        if self.problem.prior is None:
            moments = self._unit(points)[1] * moments
        parts = [
            rotation_vectors(product(q[:, 0], conjugate(best_q[0]))),
            omega[:, 0] - best_omega[0],
            moments - self.best.moments,
            rotation_vectors(product(points.mount, conjugate(self.best.mount))),
        ]
        return np.hstack(parts)[:, : len(self.names)]

    def near(self, points: Point, own: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return `apart`, and how it goes with the parameters (B, k, p), at motions (B,)."""
        apart, rows = self.apart(points), self.rows(points, own)
        for first in (0, 9)[: 1 + self.problem.parameters.axes]:
            turn = slice(first, first + 3)
            rows[:, turn] = inverse_left_jacobian(apart[:, turn]) @ rows[:, turn]
        return apart, rows

    def _unit(self, point: Point) -> tuple[int, np.ndarray]:
        """Which moment is the unit, and what makes it as large as that of the best, (..., 1)."""
        largest = int(np.argmax(self.best.moments))
        return largest, self.best.moments[largest] / point.moments[..., [largest]]

    @property
    def _zero(self) -> np.ndarray:
        """t = 0, since the epoch."""
        return np.array([-self.problem.epoch])
