"""Other integrators of a rigid body under a torque, each with its count of evaluations.

A rival takes the problem to its end in so many equal steps, or at a tolerance, and returns the
attitude (4,), the rates (3,) and how often it asked for the torque.
"""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy.integrate import solve_ivp

from rigidsym.quaternions import of_rotation_vectors, product
from rigidsym.splitting import GravityGradient, KeplerOrbit
from rigidsym.validate.peers._integrators import rates

State = tuple[np.ndarray, np.ndarray]
Result = tuple[np.ndarray, np.ndarray, int]
_CONVERGED = 1e-15


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """A body under the tide of a planet, from the identity as attitude."""

    inertia: np.ndarray
    omega0: np.ndarray
    orbit: KeplerOrbit
    end: float

    @property
    def torque(self) -> GravityGradient:
        return GravityGradient(self.inertia, self.orbit)

    @property
    def start(self) -> np.ndarray:
        return np.array([1.0, 0.0, 0.0, 0.0, *self.omega0])


def dop853(problem: Problem, tolerance: float) -> Result:
    """Dormand and Prince's method of order 8, of SciPy."""
    torque = problem.torque

    def derivative(t, y):
        found = np.array(rates(y, problem.inertia))
        found[4:] += torque(t, y[:4] / np.linalg.norm(y[:4]), y[4:]) / problem.inertia
        return found

    span = (0.0, problem.end)
    found = solve_ivp(derivative, span, problem.start, "DOP853", rtol=tolerance, atol=tolerance)
    q = found.y[:4, -1]
    return q / np.linalg.norm(q), found.y[4:, -1], found.nfev


def no_squish(problem: Problem, steps: int) -> Result:
    """Rotations about one principal axis after the other between half kicks (Miller and others,
    J. Chemical Physics 116, 8649-8659)."""
    h, q, momentum = problem.end / steps, problem.start[:4], problem.inertia * problem.omega0
    torque = problem.torque
    push = torque(0.0, q, momentum)
    for k in range(steps):
        momentum = momentum + h / 2 * push
        for axis, part in ((2, 0.5), (1, 0.5), (0, 1.0), (1, 0.5), (2, 0.5)):
            q, momentum = _turned(q, momentum, axis, part * h / problem.inertia[axis])
        push = torque((k + 1) * h, q, momentum)
        momentum = momentum + h / 2 * push
    return q, momentum / problem.inertia, steps + 1


def _turned(q: np.ndarray, momentum: np.ndarray, axis: int, dt: float) -> State:
    """A rotation about one axis, by dt times the momentum along it."""
    angle = dt * momentum[axis]
    i, j = (axis + 1) % 3, (axis + 2) % 3
    c, s, turned = math.cos(angle), math.sin(angle), momentum.copy()
    turned[i], turned[j] = c * momentum[i] + s * momentum[j], c * momentum[j] - s * momentum[i]
    turn = np.zeros(4)
    turn[0], turn[1 + axis] = math.cos(angle / 2), math.sin(angle / 2)
    return product(q, turn), turned


def implicit_midpoint(problem: Problem, steps: int) -> Result:
    """Rates of the middle of a step turn the attitude by an exponential; solved to rounding."""
    h, q, omega, count = problem.end / steps, problem.start[:4], problem.omega0, 0
    torque, inertia = problem.torque, problem.inertia
    for k in range(steps):
        middle, change = omega, np.inf
        while change > _CONVERGED * np.max(np.abs(omega)):
            halfway = product(q, of_rotation_vectors(h / 2 * middle))
            push = torque((k + 0.5) * h, halfway, middle)
            better = omega + h / 2 * (np.cross(inertia * middle, middle) + push) / inertia
            change, middle, count = np.max(np.abs(better - middle)), better, count + 1
        q, omega = product(q, of_rotation_vectors(h * middle)), 2 * middle - omega
    return q, omega, count


def heyoka(problem: Problem, tolerance: float) -> Result:
    """Taylor's method; each order of each step computes the right sides once."""
    integrator = compiled(problem, tolerance)
    integrator.time, integrator.state[:] = 0.0, problem.start
    steps = integrator.propagate_until(problem.end)[3]
    y = np.array(integrator.state)
    return y[:4] / np.linalg.norm(y[:4]), y[4:], steps * integrator.order


@cache
def compiled(problem: Problem, tolerance: float):
    """heyoka's integrator of a problem on a circular orbit in the plane of x and y."""
    import heyoka as hy

    names = hy.make_vars("q0", "q1", "q2", "q3", "w1", "w2", "w3")
    angle = problem.orbit.mean_motion * hy.time
    towards = _in_body(names[:4], hy.cos(angle), hy.sin(angle))
    system, moments = list(rates(names, problem.inertia)), problem.inertia
    strength = 3 * problem.orbit.mu / problem.orbit.periapsis**3
    for axis in range(3):
        i, j = (axis + 1) % 3, (axis + 2) % 3
        tide = strength * (moments[j] - moments[i]) / moments[axis]
        system[4 + axis] = system[4 + axis] + tide * towards[i] * towards[j]
    equations = list(zip(names, system, strict=True))
    return hy.taylor_adaptive(equations, list(problem.start), tol=tolerance)


def _in_body(q, x, y):
    """Components in body axes of a vector in the plane of x and y."""
    a, b, c, d = q
    return (
        (a * a + b * b - c * c - d * d) * x + 2 * (b * c + a * d) * y,
        2 * (b * c - a * d) * x + (a * a - b * b + c * c - d * d) * y,
        2 * (b * d + a * c) * x + 2 * (c * d - a * b) * y,
    )
