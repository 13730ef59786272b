"""Direct collocation for optimal control in a fixed time.

Units: time 1 for the duration, moments of inertia over the largest, so that rates are in 1 over
the duration and impulses in the largest moment over the duration.  Attitudes are relative to the
start.  On each interval of the mesh a polynomial obeys the equations of motion at Gauss's points:
order 2s for s points; quadratic invariants, such as the length of a quaternion, are kept exactly.
Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, sections II.1 and IV.2.
"""

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from functools import cache, cached_property

import numpy as np
from scipy.integrate import OdeSolution, solve_ivp

from rigidsym.manoeuvre.flight._rotation import cross

STATES, AXES = 7, 3
"Sizes of a state, attitude (4) and rates (3), and of a torque."
_TOLERANCE = 1e-10

# Attitudes (N, 4) and rates (N, 3) at times (N,) from 0 to 1.
Guess = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


class Model(StrEnum):
    """Model of the actuators: thrusters or reaction wheels."""

    THRUSTERS = "thrusters"
    "The outside: J w' = -w x J w + u.  Coasting is a natural motion and free."
    WHEELS = "wheels"
    """Wheels that store the body's momentum, so that the total momentum is zero: J w' = u.
    Coasting is a turn at constant rates, about a fixed axis."""


class Cost(StrEnum):
    """Cost to minimise: the integral of |torque| (fuel) or of torque^2 (energy)."""

    FUEL = "fuel"
    "The integral of |u|."
    ENERGY = "energy"
    "The integral of u^2."


@dataclass(frozen=True, slots=True)
class Task:
    """An optimal-control problem, given by the actuators, the cost and the limits.

    limited: whether the torque of each axis is bounded; if not, bursts may be as short as the mesh
    allows.
    """

    model: Model
    cost: Cost
    limited: bool = True

    @property
    def name(self) -> str:
        """The name of the task in tables and files."""
        return f"{self.model}, {self.cost}" + ("" if self.limited else ", unlimited")


@dataclass(frozen=True)
class Tableau:
    """Coefficients of a collocation method.

    c (s,): points in [0, 1].  a (s, s), b (s,): integrals of Lagrange's polynomials on these
    points, to each point and to 1.
    """

    c: np.ndarray
    a: np.ndarray
    b: np.ndarray

    def __post_init__(self) -> None:
        count = len(self.c)
        if self.a.shape != (count, count) or self.b.shape != (count,):
            raise ValueError("a tableau is square, with a weight for each point")
        if not (np.allclose(self.a.sum(axis=1), self.c) and np.isclose(self.b.sum(), 1)):
            raise ValueError("a tableau integrates constants")


@cache
def gauss(points: int) -> Tableau:
    """Return the tableau of Gauss collocation with a number of points.

    >>> gauss(1)
    Tableau(c=array([0.5]), a=array([[0.5]]), b=array([1.]))
    """
    roots, _ = np.polynomial.legendre.leggauss(points)
    c = (roots + 1) / 2
    powers = np.arange(1, points + 1)
    # Lagrange's polynomials in powers of x are the columns of the inverse.
    inverse = np.linalg.inv(np.vander(c, points, increasing=True))
    return Tableau(c, c[:, None] ** powers / powers @ inverse, 1 / powers @ inverse)


@dataclass(frozen=True)
class Mesh:
    """A mesh of intervals of [0, 1], each with the same number of collocation points.

    They are short at both ends, where the torques act: with 80 intervals the first is 1e-4 long,
    those in the middle 0.02.
    """

    intervals: int = 80
    points: int = 2

    @cached_property
    def nodes(self) -> np.ndarray:
        """The N + 1 Chebyshev nodes, at which the intervals begin and end."""
        return (1 - np.cos(np.pi * np.arange(self.intervals + 1) / self.intervals)) / 2

    @cached_property
    def steps(self) -> np.ndarray:
        """Lengths (N,) of the intervals."""
        return np.diff(self.nodes)

    @property
    def inner(self) -> np.ndarray:
        """Collocation points (N, s) of the intervals."""
        return self.nodes[:-1, None] + self.steps[:, None] * gauss(self.points).c


MESH = Mesh()
"The mesh of the comparison."


@dataclass(frozen=True, slots=True)
class Trajectory:
    """States and impulses on a collocation mesh.

    nodes (N + 1, 7), inner (N, s, 7): attitude and rates.  impulses (N, 3): of the torque, which
    is constant in each interval.
    """

    nodes: np.ndarray
    inner: np.ndarray
    impulses: np.ndarray

    @classmethod
    def of_unknowns(cls, mesh: Mesh, unknowns: np.ndarray) -> "Trajectory":
        """Create a trajectory from the optimiser's vector of unknowns."""
        count, points = mesh.intervals, mesh.points
        sizes = [STATES * (count + 1), STATES * points * count, AXES * count]
        nodes, inner, up, down = np.split(unknowns, np.cumsum(sizes))
        return cls(
            nodes.reshape(count + 1, STATES),
            inner.reshape(count, points, STATES),
            (up - down).reshape(count, AXES),
        )

    def unknowns(self, split: bool) -> np.ndarray:
        """Return all states and impulses as the optimiser's vector of unknowns.

        split: impulses are written as positive and negative parts; else as they are, and zeros.
        """
        up, down = self.impulses, np.zeros_like(self.impulses)
        if split:
            up, down = np.maximum(up, 0), np.maximum(-up, 0)
        return np.concatenate([part.ravel() for part in (self.nodes, self.inner, up, down)])


def still(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the states of a body that rests in the start attitude, as a first guess."""
    return np.tile([1.0, 0.0, 0.0, 0.0], (len(t), 1)), np.zeros((len(t), 3))


def guessed(mesh: Mesh, inertia: np.ndarray, model: Model, motion: Guess) -> Trajectory:
    """Sample a motion on a mesh, with the torques that it would need without limits.

    The first and the last interval start and stop it where it does not begin and end at rest.
    """
    nodes = np.hstack(motion(mesh.nodes))
    nodes[[0, -1], 4:] = 0
    inner = np.hstack(motion(mesh.inner.ravel())).reshape(mesh.intervals, mesh.points, STATES)
    impulses = inertia * np.diff(nodes[:, 4:], axis=0)
    if model is Model.THRUSTERS:
        rates = inner[..., 4:]
        gyroscopic = np.cross(rates, inertia * rates)
        impulses += mesh.steps[:, None] * np.einsum("j,kja->ka", gauss(mesh.points).b, gyroscopic)
    return Trajectory(nodes, inner, impulses)


class Driven:
    """A motion from rest under given torques, integrated by SciPy's DOP853.

    It checks optima by another integrator than collocation.
    """

    def __init__(self, model: Model, inertia: np.ndarray, impulses: np.ndarray, mesh: Mesh) -> None:
        state, pieces = np.array([1.0, *np.zeros(6)]), []
        for k, torque in enumerate(impulses / mesh.steps[:, None]):

            def derivative(t: float, state: np.ndarray, torque: np.ndarray = torque) -> np.ndarray:
                q, w = state[:4], state[4:]
                felt = torque - cross(w, inertia * w) if model is Model.THRUSTERS else torque
                turn = [-(q[1:] @ w) / 2, *(q[0] * w + cross(q[1:], w)) / 2]
                return np.concatenate([turn, felt / inertia])

            found = solve_ivp(
                derivative,
                mesh.nodes[k : k + 2].tolist(),
                state,
                method="DOP853",
                rtol=_TOLERANCE,
                atol=_TOLERANCE,
                first_step=mesh.steps[k],
                dense_output=True,
            )
            state = found.y[:, -1]
            pieces.append(found.sol)
        # At a node the piece that begins there counts.
        self._states = OdeSolution(mesh.nodes, pieces, alt_segment=True)
        self.end = state[:4], state[4:]
        "Attitude (4,) and rates (3,) at time 1."

    def __call__(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the attitudes and rates at times from 0 to 1.

        Times have the shape (N,), attitudes (N, 4) and rates (N, 3).
        """
        states = self._states(np.clip(t, 0.0, 1.0)).T
        length = np.linalg.norm(states[:, :4], axis=1, keepdims=True)
        return states[:, :4] / length, states[:, 4:]
