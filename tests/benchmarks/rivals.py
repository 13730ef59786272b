"""Other methods for the same states, each with the best settings that we found.

A rival is given sorted times and returns what to run: from the start of the motion to q (N, 4) and
omega (N, 3).  Its compilation, where it has one, is over by then.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from bench import heyoka_system
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipkinc, elliprf, elliprj

from rigidsym.quaternions import product
from rigidsym.validate.peers._integrators import rates

States = tuple[np.ndarray, np.ndarray]
Run = Callable[[], States]
LANES = 8


@dataclass(frozen=True, slots=True)
class Motion:
    inertia: tuple[float, float, float]
    omega0: tuple[float, float, float]

    @property
    def start(self) -> np.ndarray:
        """The state at t = 0: the identity as attitude, then the rates."""
        return np.array([1.0, 0, 0, 0, *self.omega0])


def _split(y: np.ndarray) -> States:
    return y[:, :4], y[:, 4:]


# heyoka: Taylor's method of order 20, compiled for the machine.


@cache
def _integrators(inertia):
    """Compile integrators of one motion, and of LANES at once."""
    import heyoka as hy

    _, system = heyoka_system(inertia)
    start = np.zeros((7, LANES))
    start[0] = 1
    one = hy.taylor_adaptive(system, [1.0] + [0.0] * 6, tol=1e-16)
    return one, hy.taylor_adaptive_batch(system, start, tol=1e-16)


def _started(motion: Motion):
    integrator, _ = _integrators(motion.inertia)
    integrator.time = 0.0
    integrator.state[:] = motion.start
    return integrator


def heyoka_grid(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by `propagate_grid`, whose grid must begin at the integrator's time."""
    grid = np.concatenate(([0.0], t))
    return lambda: _split(_started(motion).propagate_grid(grid)[-1][1:])


def heyoka_dense(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by continuous output, which each call compiles again."""
    return lambda: _split(_started(motion).propagate_until(t[-1], c_output=True)[4](t))


def _in_lanes(motion: Motion, t: np.ndarray):
    """Return times by lane, and a function that starts each lane at its first time."""
    columns = np.ascontiguousarray(t[: t.size // LANES * LANES].reshape(LANES, -1).T)
    _, integrator = _integrators(motion.inertia)

    def begin():
        heads = np.concatenate(([0.0], columns[0]))
        integrator.set_time(columns[0].copy())
        integrator.state[:] = _started(motion).propagate_grid(heads)[-1][1:].T
        return integrator

    return columns, begin


def _gathered(found: np.ndarray) -> States:
    """Return states in the order of the times from an array (N/LANES, 7, LANES)."""
    rows = found.transpose(2, 0, 1)
    return rows[..., :4], rows[..., 4:]


def heyoka_lanes_grid(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by `propagate_grid` in lanes."""
    columns, begin = _in_lanes(motion, t)
    return lambda: _gathered(begin().propagate_grid(columns)[1])


def heyoka_lanes_dense(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by continuous output in lanes."""
    columns, begin = _in_lanes(motion, t)
    return lambda: _gathered(begin().propagate_until(columns[-1].copy(), c_output=True)[0](columns))


def heyoka_evaluation(motion: Motion, t: np.ndarray) -> Run:
    """Return a run that only evaluates continuous output in lanes."""
    columns, begin = _in_lanes(motion, t)
    output = begin().propagate_until(columns[-1].copy(), c_output=True)[0]
    return lambda: _gathered(output(columns))


def heyoka_bodies(inertia: np.ndarray, omega0: np.ndarray, time: float) -> Run:
    """Return a run of many bodies to one time, LANES at once."""
    import heyoka as hy

    integrator = hy.taylor_adaptive_batch(
        heyoka_system([hy.par[k] for k in range(3)])[1],
        np.zeros((7, LANES)),
        tol=1e-16,
        pars=np.ones((3, LANES)),
    )
    moments, starts = (
        np.ascontiguousarray(rows.reshape(-1, LANES, 3).transpose(0, 2, 1))
        for rows in (inertia, omega0)
    )

    def run():
        found = np.empty((len(starts), 7, LANES))
        for k, (moment, start) in enumerate(zip(moments, starts, strict=True)):
            integrator.set_time(0.0)
            integrator.pars[:] = moment
            integrator.state[:4] = [[1.0], [0], [0], [0]]
            integrator.state[4:] = start
            integrator.propagate_until(time)
            found[k] = integrator.state
        return _split(found.transpose(0, 2, 1).reshape(-1, 7))

    return run


# SciPy: Dormand and Prince's method of order 8, and the paper's formulas.


def dop853(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by SciPy's DOP853 at 1e-12 with dense output."""

    def run():
        found = solve_ivp(
            lambda _, y: rates(y, motion.inertia),
            (0.0, float(t[-1])),
            motion.start,
            "DOP853",
            t,
            rtol=1e-12,
            atol=1e-12,
        )
        return _split(found.y.T)

    return run


def paper(motion: Motion, t: np.ndarray) -> Run:
    """Return a run by the paper's formulas (10) and (18) to (21), corrected."""
    return lambda: Paper(motion).states(t)


class Paper:
    """The paper's solution in its own names, for i = 1 the middle axis and 3 that of circulation.

    Written for what is measured here: those axes in a right-handed order, and Omega_3 > 0.
    """

    def __init__(self, motion: Motion) -> None:
        c, w = np.array(motion.inertia), np.array(motion.omega0)
        self.axes = _axes(c, w)
        (c1, c2, c3), (w1, w2, _) = c[self.axes], w[self.axes]
        H, K2 = np.sum(c * w**2) / 2, np.sum((c * w) ** 2)
        e_2, e_3 = K2 - 2 * H * c2, 2 * H * c3 - K2
        s_1 = e_3 / (c1 * (c3 - c1))
        self.c, self.K = (c1, c2, c3), np.sqrt(K2)
        squares = s_1, e_3 / (c2 * (c3 - c2)), e_2 / (c3 * (c3 - c2))
        self.amplitudes = np.sqrt(squares)
        self.m = e_3 * (c2 - c1) / (e_2 * (c1 - c3))
        self.n = c1**2 * s_1 / K2
        self.sign = np.sign(w2)
        # The sign of the rate of f, by Euler's equation for Omega_1.
        self.rate = np.sqrt((c3 - c1) * e_2 / (c1 * c2 * c3)) * self.sign * np.sign(c2 - c3)
        self.kappa = (2 * H * c1 - K2) / (self.K * c1 * self.rate)
        self.C1 = ellipkinc(np.arcsin(w1 / self.amplitudes[0]), self.m)

    def states(self, t: np.ndarray) -> States:
        """Return states at times, with the identity as attitude at t = 0."""
        turned, omega = self._oriented(t)
        first, _ = self._oriented(np.zeros(1))
        q = np.empty_like(turned)
        q[:, np.append(0, 1 + self.axes)] = product(first[0] * [1, -1, -1, -1], turned)
        return q, omega

    def _oriented(self, t: np.ndarray) -> States:
        """Return attitudes by (18), for angular momentum along axis 1, and rates."""
        sn, cn, dn, theta = ellipj(self.rate * t + self.C1, self.m)
        A1, A2, A3 = self.amplitudes
        w = A1 * sn, self.sign * A2 * cn, A3 * dn
        phi1 = self.K / self.c[0] * t + self.kappa * self._third_kind(theta)
        x, y = self.c[0] * w[0] / self.K, self.c[1] * w[1] / (self.c[2] * w[2])
        F1, F2 = np.sqrt((1 + x) / 2), np.sqrt((1 - x) / 2)
        y_star = y / (1 + np.sqrt(1 + y * y))
        F3 = 1 / np.sqrt(1 + y_star**2)
        F4, cos, sin = y_star * F3, np.cos(phi1 / 2), np.sin(phi1 / 2)
        parts = F1 * (cos * F3 - sin * F4), F1 * (sin * F3 + cos * F4)
        parts += F2 * (cos * F3 + sin * F4), F2 * (sin * F3 - cos * F4)
        omega = np.empty((t.size, 3))
        omega[:, self.axes] = np.stack(w, axis=-1)
        return np.stack(parts, axis=-1), omega

    def _third_kind(self, theta: np.ndarray) -> np.ndarray:
        """Return Pi(n; theta | m) for any theta."""
        turns = np.rint(theta / np.pi)
        # On the separatrix the complete integral is infinite, and theta stays within a half turn.
        whole = self._within(np.array(np.pi / 2)) if np.any(turns) else 0.0
        return 2 * turns * whole + self._within(theta - turns * np.pi)

    def _within(self, phi: np.ndarray) -> np.ndarray:
        """Return Pi(n; phi | m) for |phi| <= pi/2 by Carlson's integrals (DLMF 19.25.14)."""
        s, c = np.sin(phi), np.cos(phi)
        x, y, p = c * c, 1 - self.m * s * s, 1 - self.n * s * s
        return s * elliprf(x, y, 1.0) + self.n / 3 * s**3 * elliprj(x, y, 1.0, p)


def _axes(c: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Return the middle axis, the third one, and the axis of circulation."""
    low, middle, high = np.argsort(c)
    third = high if np.sum(c * (c - c[middle]) * w**2) > 0 else low
    return np.array([middle, low + high - third, third])
