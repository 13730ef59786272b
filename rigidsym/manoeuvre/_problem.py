"""The dimensionless boundary-value problem of a turn in time 1.

The axes are the body axes of the start, and the largest moment is 1.

Natural motions keep their momentum in space (fact moving_body.momentum_is_constant), and time only
scales their rates (facts faster.kinematics, faster.euler).  So the problem depends on two attitudes
only by the turn from one to the other in the body axes of the first, and on a duration only by the
rates times it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from rigidsym._engines import Engine
from rigidsym.quaternions import inverse_left_jacobian, matrices, rotation_vectors

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])


@dataclass(frozen=True, eq=False)
class Problem:
    """The problem of finding initial rates that turn a body by a given rotation in time 1.

    inertia (3,): moments over the largest of them.  turn (4,): unit quaternion from the body axes
    of the target to those of the start, with a scalar part that is not negative; motions may reach
    it or its negative.  engine: the generated module that states come from.
    """

    inertia: np.ndarray
    turn: np.ndarray
    engine: Engine

    @cached_property
    def axes(self) -> tuple[int, int, int]:
        """The indices of the axes of smallest, middle and largest moment."""
        low, middle, high = np.argsort(self.inertia, kind="stable").tolist()
        return low, middle, high

    @cached_property
    def angle(self) -> float:
        """Angle of the turn, from 0 to pi."""
        return float(2 * np.arctan2(np.linalg.norm(self.turn[1:]), self.turn[0]))

    @cached_property
    def axis(self) -> np.ndarray:
        """Axis (3,) of the turn.

        It is that of the largest moment where there is no turn.
        """
        length = np.linalg.norm(self.turn[1:])
        return self.turn[1:] / length if length else np.eye(3)[self.axes[2]]

    @cached_property
    def rotation(self) -> np.ndarray:
        """The rotation matrix (3, 3) of the turn.

        A momentum m at the start is m @ rotation at the end, in body axes.
        """
        return matrices(self.turn)

    @cached_property
    def _undo(self) -> np.ndarray:
        """The matrix (4, 4) that multiplies quaternions by the inverse of the turn.

        q turn^-1 = q @ _undo.
        """
        w, x, y, z = self.turn
        return np.array([[w, -x, -y, -z], [x, w, z, -y], [y, -z, w, x], [z, y, -x, w]])

    def arrivals(self, rates: np.ndarray) -> np.ndarray:
        """Return the rotations from the target to the attitudes that motions reach in time 1.

        They are quaternions (..., 4), for initial rates (..., 3).
        """
        q, _ = self.engine.propagate(self.inertia, rates, IDENTITY, np.ones(1))
        return q[..., 0, :] @ self._undo

    def misses(self, rates: np.ndarray) -> np.ndarray:
        """Return the rotation vectors by which motions miss the target in time 1.

        Their shape is (..., 3), in rad, for initial rates (..., 3).
        """
        return rotation_vectors(self.arrivals(rates))

    def slopes(self, rates: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the misses of motions, and derivatives of misses by the initial rates.

        Misses are rotation vectors (N, 3), for rates (N, 3); derivatives have the shape
        (N, 3, 3).

        Derivatives beyond binary64, as they may be beside the separatrix, are NaN.
        """
        given = self.inertia, rates, IDENTITY, np.ones(1)
        found = self.engine.propagate_sensitivities(*given, errors="nan")
        misses = rotation_vectors(found[0][:, 0] @ self._undo)
        by_rates = found[2][:, 0, :, 3:6]
        return misses, inverse_left_jacobian(misses) @ by_rates

    def momenta(self, rates: np.ndarray) -> np.ndarray:
        """Return the magnitude of the angular momentum for rates (..., 3)."""
        return np.linalg.norm(self.inertia * rates, axis=-1)


def problem(
    inertia: Sequence[Fraction],
    start: Sequence[Fraction],
    target: Sequence[Fraction],
    engine: Engine,
) -> Problem:
    """Create the dimensionless problem of a body from its start and target attitudes.

    Numbers are exact.
    """
    largest = max(inertia)
    moments = np.array([float(c / largest) for c in inertia])
    turn = unit(between(start, target))
    return Problem(moments, np.copysign(1.0, turn[0]) * turn, engine)


def between(p: Sequence[Fraction], q: Sequence[Fraction]) -> tuple[Fraction, ...]:
    """Return the quaternion product conj(p) q, which is p^-1 q up to its length."""
    p0, p1, p2, p3 = p
    q0, q1, q2, q3 = q
    return (
        p0 * q0 + p1 * q1 + p2 * q2 + p3 * q3,
        p0 * q1 - p1 * q0 - p2 * q3 + p3 * q2,
        p0 * q2 + p1 * q3 - p2 * q0 - p3 * q1,
        p0 * q3 - p1 * q2 + p2 * q1 - p3 * q0,
    )


def unit(quaternion: Sequence[Fraction]) -> np.ndarray:
    """Normalise an exact quaternion and round it to doubles."""
    largest = max(map(abs, quaternion))
    scaled = np.array([float(x / largest) for x in quaternion])
    return scaled / np.linalg.norm(scaled)
