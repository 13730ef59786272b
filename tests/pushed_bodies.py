"""Rigid bodies under a torque by a potential, with reference states by DOP853."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

from rigidsym.quaternions import conjugate, rotated
from rigidsym.splitting import Torque
from rigidsym.validate.peers._integrators import rates

LEVER = np.array([0.1, 0.2, 0.3])


def energy(t, q):
    """Return the potential energy of a lever in a time-dependent field along z, in J."""
    up = np.broadcast_to([0.0, 0.0, 1.0], (*q.shape[:-1], 3))
    return np.cos(0.3 * t) * np.sum(LEVER * rotated(conjugate(q), up), axis=-1)


def gradient(t, q):
    """Return the gradient of the energy as a quadratic form of the quaternion."""
    a, b, c, d = np.moveaxis(q, -1, 0)
    x, y, z = 2 * np.cos(0.3 * t) * LEVER
    parts = z * a + y * b - x * c, y * a - z * b + x * d, -x * a - z * c + y * d
    return np.stack([*parts, x * b + y * c + z * d], axis=-1)


@dataclass(frozen=True)
class Pushed:
    inertia: tuple[float, ...]
    q0: tuple[float, ...]
    omega0: tuple[float, ...]
    torque: Torque
    times: tuple[float, ...]

    @property
    def arguments(self):
        return self.inertia, self.q0, self.omega0, self.torque, self.times

    def derivative(self, t, y):
        found = np.array(rates(y, self.inertia), dtype=float)
        found[4:] += self.torque(t, y[:4], y[4:]) / np.array(self.inertia)
        return found

    def reference(self):
        """Return the reference attitudes and rates at all times, integrated by DOP853.

        q has the shape (N, 4), and omega (N, 3).
        """
        span, start = (self.times[0], self.times[-1]), [*self.q0, *self.omega0]
        found = solve_ivp(
            self.derivative, span, start, "DOP853", self.times, rtol=1e-13, atol=1e-14
        )
        q, omega = found.y[:4].T, found.y[4:].T
        return q / np.linalg.norm(q, axis=-1, keepdims=True), omega
