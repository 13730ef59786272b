"""The classical solution of the free rigid body: Euler's angles about the fixed momentum.

Conventions: the third axis of the fixed frame lies along the angular momentum, of size K; the
rotation from body to fixed axes is Rz(precession) Rx(nutation) Rz(spin).  Then the momentum's body
components are K sin(nutation) (sin(spin), cos(spin)) and K cos(nutation), so that

    nutation   = arccos(I3 w3 / K)
    spin       = arctan(I1 w1 / (I2 w2))
    precession = constant + integral of K (I1 w1^2 + I2 w2^2) / ((I1 w1)^2 + (I2 w2)^2)

(Landau and Lifshitz, Mechanics, sections 35 and 37; Whittaker, Analytical Dynamics, section 69).
Angles are principal values, as inverse functions give them: nutation from 0 to pi, the others
above -pi and up to pi, with the arctangent of two arguments; that of one would jump still more.
"""

from dataclasses import dataclass

import numpy as np

from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import product, rotated
from rigidsym.view._geometry import moments, momentum, upright

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True, slots=True)
class EulerAngles:
    """Euler's angles (N,) in rad."""

    precession: np.ndarray
    nutation: np.ndarray
    spin: np.ndarray

    def quaternion(self) -> np.ndarray:
        """Return quaternions (N, 4), body to fixed axes, of either sign."""
        total, difference = self.precession + self.spin, self.precession - self.spin
        cosine, sine = np.cos(self.nutation / 2), np.sin(self.nutation / 2)
        parts = (
            cosine * np.cos(total / 2),
            sine * np.cos(difference / 2),
            sine * np.sin(difference / 2),
            cosine * np.sin(total / 2),
        )
        return np.stack(parts, axis=-1)

    def jumps(self) -> dict[str, int]:
        """Count the jumps of each angle, by more than half a turn from one sample to the next."""
        angles = {"precession": self.precession, "nutation": self.nutation, "spin": self.spin}
        return {name: int(np.sum(np.abs(np.diff(x)) > np.pi)) for name, x in angles.items()}


def euler_angles(motion: TorqueFreeMotion, t: np.ndarray) -> EulerAngles:
    """Return the angles at increasing times (N,), the precession integrated by Gauss's rule.

    The momentum must never lie along the third axis of the body.
    """
    fixed = upright(_fixed_momentum(motion))
    body = moments(motion) * motion(t)[1]
    size = np.linalg.norm(body, axis=1)
    # The rotation is Rz(precession) Rx(nutation) Rz(spin).
    a, b, c, d = product(fixed, motion(t[:1])[0])[0]
    first = float(np.arctan2(b * d + a * c, a * b - c * d))
    nutation = np.arccos(np.clip(body[:, 2] / size, -1, 1))
    spin = np.arctan2(body[:, 0], body[:, 1])
    half = np.diff(t) / 2
    nodes = (t[:-1] + half)[:, None] + half[:, None] * NODES
    rate = _rate(motion, nodes.ravel()).reshape(nodes.shape)
    turned = first + np.concatenate([[0.0], np.cumsum(half * (rate @ WEIGHTS))])
    # Above -pi and up to pi.
    precession = np.pi - np.mod(np.pi - turned, 2 * np.pi)
    return EulerAngles(precession, nutation, spin)


def difference(motion: TorqueFreeMotion, t: np.ndarray, angles: EulerAngles) -> float:
    """Return the largest angle (rad) between attitudes by Euler's angles and the library's own."""
    found = product(upright(_fixed_momentum(motion)), motion(t)[0])
    # The sines of half the angles: small ones are not lost beside one.
    sides = [np.linalg.norm(found - side * angles.quaternion(), axis=1) for side in (1, -1)]
    apart = np.minimum(*sides)
    return float(np.max(2 * apart))


def _fixed_momentum(motion: TorqueFreeMotion) -> np.ndarray:
    """Return the momentum in inertial axes."""
    return rotated(motion(0.0)[0], momentum(motion))


def _rate(motion: TorqueFreeMotion, t: np.ndarray) -> np.ndarray:
    """Return the rate (N,) of the precession, rad/s."""
    body, rates = moments(motion)[:2], motion(t)[1][:, :2]
    size = float(np.linalg.norm(momentum(motion)))
    across = body * rates
    return size * np.sum(across * rates, axis=1) / np.sum(across**2, axis=1)
