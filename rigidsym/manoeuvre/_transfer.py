"""Torque-free motions from start to target, with their bursts and error sensitivities."""

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.motion import TorqueFreeMotion

_SAMPLES = 181
_PERCENT = 0.01
# Greatest 1 - m beside the separatrix; least power of e that counts as exponential growth.
_BESIDE, _GROWN = 0.01, 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Robustness:
    """First-order effects of small errors at the start on the attitude at arrival.

    Effects are small turns, vectors in space, rad.

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
        """Miss in rad caused by a first burst that is 1 % too strong or too weak."""
        return _PERCENT * float(np.linalg.norm(self.by_burst @ self.burst))

    @property
    def direction(self) -> float:
        """Largest miss caused by an error in the direction of the first burst, in rad per rad.

        A burst points off where the attitude is not known exactly.
        """
        across = np.cross(np.eye(3), self.burst)
        return float(np.linalg.norm(self.by_burst @ across, 2))


def robustness(motion: TorqueFreeMotion, burst: np.ndarray, duration: float) -> Robustness:
    """Return the first-order effects of small initial errors on a motion.

    They are those after `duration` s; burst (3,) is in N m s.

    Raises InputError as `motion.sensitivity` does.
    """
    inertia = np.array([float(c) for c in motion.exact["inertia"]])
    changed = motion.sensitivity(duration)[2].attitude
    by_rates = changed[:, 3:6]
    by_moments = changed[:, 6:] - by_rates * (burst / inertia**2)
    return Robustness(burst, by_rates / inertia, changed[:, :3], by_moments)


def exponent(inertia: np.ndarray, omega0: np.ndarray, duration: float) -> float:
    """Return the exponent x of the factor e^x by which errors grow during a motion.

    It is 0 where they grow linearly.

    They grow exponentially about the middle axis and beside the separatrix, where 1 - m is below
    0.01, by e for each 1 / lambda of time; powers below 3 count as linear growth.  Inertia (3,) in
    kg m^2, omega0 (3,) in rad/s, duration in s.
    """
    low, middle, high = np.sort(inertia)
    if not low < middle < high:
        return 0.0

    def beyond(c: float) -> float:
        """Return K^2 - 2 H c for a moment c, with momentum K and energy H."""
        return float(np.sum(inertia * (inertia - c) * omega0**2))

    a, d = (high, low) if beyond(middle) >= 0 else (low, high)
    if beyond(d) == 0:
        return 0.0
    complement = (a - d) * beyond(middle) / ((a - middle) * beyond(d))
    power = duration * np.sqrt((a - middle) * beyond(d) / (a * middle * d))
    return float(power) if complement < _BESIDE and power > _GROWN else 0.0


@dataclass(frozen=True)
class Transfer:
    """A torque-free motion that reaches the target at the end of the duration.

    manoeuvre: what it is for, with its duration.  rates: body rates at its start, exact, rad/s.
    residual: the angle by which the derived solution, at thirty digits, misses the target for
    these rates, either sign of the quaternion, rad.  peak_rate: the largest |omega| on the way,
    rad/s.  engine: the generated module that computes states.
    """

    manoeuvre: Manoeuvre
    rates: tuple[Fraction, ...]
    residual: float
    peak_rate: float
    engine: str

    @cached_property
    def motion(self) -> TorqueFreeMotion:
        """The torque-free motion, which begins at `start` at t = 0."""
        start = self.manoeuvre.start
        return TorqueFreeMotion(self.manoeuvre.inertia, self.rates, start, engine=self.engine)

    def faster(self, manoeuvre: Manoeuvre, ratio: Fraction) -> "Transfer":
        """Return the transfer that follows the same path `ratio` times as fast.

        It is for a shorter manoeuvre.
        """
        rates = tuple(ratio * x for x in self.rates)
        return replace(
            self, manoeuvre=manoeuvre, rates=rates, peak_rate=float(ratio) * self.peak_rate
        )

    @property
    def duration(self) -> float:
        """Time from the first burst to the last, in s."""
        return float(self.manoeuvre.duration or 0)

    @property
    def omega0(self) -> np.ndarray:
        """Body rates (3,) after the first burst, rad/s."""
        return np.array([float(x) for x in self.rates])

    @cached_property
    def omega1(self) -> np.ndarray:
        """Body rates (3,) before the last burst, rad/s."""
        return self.motion(self.duration)[1]

    @cached_property
    def bursts(self) -> np.ndarray:
        """The two bursts (2, 3) that start and end the motion, in body axes, N m s.

        They are changes of angular momentum.
        """
        given = self.manoeuvre
        begin = self.omega0 - _doubles(given.start_spin)
        return _doubles(given.inertia) * [begin, _doubles(given.target_spin) - self.omega1]

    @cached_property
    def sensitivity(self) -> Robustness:
        """Effects of small errors in the first burst, the attitude and the moments.

        Raises InputError where that leaves binary64, beside the separatrix.
        """
        return robustness(self.motion, self.bursts[0], self.duration)

    @property
    def miss(self) -> str:
        """The angle, in rad, by which the transfer misses the target, as text.

        It is an upper bound where the digits are rounding errors.
        """
        bounds = (f"< {bound:g}" for bound in (1e-14, 1e-12) if self.residual < bound)
        return next(bounds, f"{self.residual:.1e}")

    @property
    def missed(self) -> str:
        """The misses in degrees that errors of the first burst cause, as text.

        The first is for 1 % of its size, the second for 1 degree of its direction.
        """
        found = self.sensitivity
        grown = ", grows exponentially" if self.growth_exponent else ""
        return f"{np.degrees(found.size):.3g}, {found.direction:.3g}{grown}"

    @property
    def growth_exponent(self) -> float:
        """Exponent x of the factor e^x by which errors grow during the motion.

        It is 0 where they grow linearly.
        """
        return exponent(_doubles(self.manoeuvre.inertia), self.omega0, self.duration)

    @property
    def cost(self) -> float:
        """Sum of the sizes of both bursts, in N m s.

        From rest to rest it is |I omega(0)| + |I omega(T)|.
        """
        return float(np.linalg.norm(self.bursts, axis=1).sum())

    @property
    def momentum(self) -> float:
        """Magnitude of the angular momentum K, in N m s."""
        return float(np.linalg.norm(_doubles(self.manoeuvre.inertia) * self.omega0))

    @property
    def energy(self) -> float:
        """Kinetic energy H, in J."""
        return float(_doubles(self.manoeuvre.inertia) @ self.omega0**2 / 2)

    def to_case(self) -> str:
        """Return the motion as the text of a case file for `rigidsym propagate`."""
        given = self.manoeuvre
        vectors = {"inertia": given.inertia, "omega0": self.rates, "attitude0": given.start}
        lines = [
            f"{name} = {json.dumps([inputs.exact_text(x) for x in values])}"
            for name, values in vectors.items()
        ]
        stop = inputs.exact_text(given.duration or Fraction(0))
        times = ["", "[times]", "start = 0", f'stop = "{stop}"', f"count = {_SAMPLES}"]
        return "\n".join([*lines, *times, ""])

    def to_data(self) -> dict[str, Any]:
        """Return the entry of this transfer in the schema rigidsym.plan/1.

        `rates` are the exact values of omega0.
        """
        return {
            "omega0": self.omega0.tolist(),
            "rates": [inputs.exact_text(x) for x in self.rates],
            "omega1": self.omega1.tolist(),
            "bursts": self.bursts.tolist(),
            "cost": self.cost,
            "momentum": self.momentum,
            "energy": self.energy,
            "peak_rate": self.peak_rate,
            "residual": self.residual,
            "miss_burst_size": self.sensitivity.size,
            "miss_burst_direction": self.sensitivity.direction,
            "growth_exponent": self.growth_exponent,
        }

    def __repr__(self) -> str:
        from rigidsym.view._motions import transfer_text

        return transfer_text(self)

    def _repr_html_(self) -> str:
        from rigidsym.view._motions import transfer_html

        return transfer_html(self)


def _doubles(values: Sequence[Fraction]) -> np.ndarray:
    return np.array([float(x) for x in values])
