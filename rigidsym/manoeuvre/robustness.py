"""By what a transfer misses where its first burst, or what is known of the body, is not exact."""

from dataclasses import dataclass

import numpy as np

from rigidsym.motion import TorqueFreeMotion

_PERCENT = 0.01
# Parameters 1 - m below this are beside the separatrix; errors that grow by less are like others'.
_BESIDE, _GROWN = 0.01, 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Robustness:
    """Small turns at arrival, vectors in space, rad, by small errors at the start; first order.

    burst (3,): the first burst, body axes, N m s.  by_burst (3, 3): by errors of it, per N m s.
    by_attitude (3, 3): by a small turn of the body at the start, in space, per rad; bursts are
    in body axes, so the whole motion turns with it.  by_moments (3, 3): by the principal moments,
    per kg m^2, at the burst as it is.
    """

    burst: np.ndarray
    by_burst: np.ndarray
    by_attitude: np.ndarray
    by_moments: np.ndarray

    @property
    def size(self) -> float:
        """The miss by a burst that is 1 % too strong or too weak, rad."""
        return _PERCENT * float(np.linalg.norm(self.by_burst @ self.burst))

    @property
    def direction(self) -> float:
        """The miss by a burst that points 1 rad off, as if it were first order, rad per rad.

        In the worst direction: what the body's attitude, as its thrusters know it, is wrong by.
        """
        across = np.cross(np.eye(3), self.burst)
        return float(np.linalg.norm(self.by_burst @ across, 2))


def robustness(motion: TorqueFreeMotion, burst: np.ndarray, duration: float) -> Robustness:
    """Of a motion that a burst (3,) begins, N m s in body axes, after `duration` s.

    Raises InputError as `motion.sensitivity` does.
    """
    inertia = np.array([float(c) for c in motion.exact["inertia"]])
    changed = motion.sensitivity(duration)[2].attitude
    by_rates = changed[:, 3:6]
    by_moments = changed[:, 6:] - by_rates * (burst / inertia**2)
    return Robustness(burst, by_rates / inertia, changed[:, :3], by_moments)


def exponent(inertia: np.ndarray, omega0: np.ndarray, duration: float) -> float:
    """By which power of e errors grow on the way where they do so exponentially; else 0.

    They do about the middle axis and beside the separatrix, where 1 - m is below 0.01, by e for
    each 1 / lambda of time; powers below 3 are as good as linear growth, and 0 here.  Inertia (3,)
    in kg m^2, omega0 (3,) in rad/s, duration in s.
    """
    low, middle, high = np.sort(inertia)
    if not low < middle < high:
        return 0.0

    def beyond(c: float) -> float:
        """K^2 - 2 H c."""
        return float(np.sum(inertia * (inertia - c) * omega0**2))

    a, d = (high, low) if beyond(middle) >= 0 else (low, high)
    if beyond(d) == 0:
        return 0.0
    complement = (a - d) * beyond(middle) / ((a - middle) * beyond(d))
    power = duration * np.sqrt((a - middle) * beyond(d) / (a * middle * d))
    return float(power) if complement < _BESIDE and power > _GROWN else 0.0
