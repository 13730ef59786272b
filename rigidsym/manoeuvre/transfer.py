"""One natural motion from start to target, and the bursts that begin and end it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import TypedDict

import numpy as np

from rigidsym import inputs
from rigidsym.manoeuvre.manoeuvre import Manoeuvre
from rigidsym.manoeuvre.robustness import Robustness, exponent, robustness
from rigidsym.motion import TorqueFreeMotion

_SAMPLES = 181


class TransferData(TypedDict):
    """A transfer of the schema rigidsym.plan/1."""

    omega0: list[float]
    rates: list[str]
    omega1: list[float]
    bursts: list[list[float]]
    cost: float
    momentum: float
    energy: float
    peak_rate: float
    residual: float
    miss_burst_size: float
    miss_burst_direction: float
    growth_exponent: float


@dataclass(frozen=True)
class Transfer:
    """A natural motion that reaches the target at the end of the duration.

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
        """The motion, from t = 0 at `start`."""
        start = self.manoeuvre.start
        return TorqueFreeMotion(self.manoeuvre.inertia, self.rates, start, engine=self.engine)

    def faster(self, manoeuvre: Manoeuvre, ratio: Fraction) -> "Transfer":
        """The same motion `ratio` times as fast, for a manoeuvre that is shorter by it."""
        rates = tuple(ratio * x for x in self.rates)
        return replace(
            self, manoeuvre=manoeuvre, rates=rates, peak_rate=float(ratio) * self.peak_rate
        )

    @property
    def duration(self) -> float:
        """From the first burst to the last, s."""
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
        """Changes of momentum (2, 3) that start and end the motion, in body axes, N m s."""
        given = self.manoeuvre
        begin = self.omega0 - _doubles(given.start_spin)
        return _doubles(given.inertia) * [begin, _doubles(given.target_spin) - self.omega1]

    @cached_property
    def sensitivity(self) -> Robustness:
        """What it misses by where the first burst, the attitude or the moments are not exact.

        Raises InputError where that leaves binary64, beside the separatrix.
        """
        return robustness(self.motion, self.bursts[0], self.duration)

    @property
    def miss(self) -> str:
        """The residual in rad, as a bound where rounding alone decides its digits."""
        bounds = (f"< {bound:g}" for bound in (1e-14, 1e-12) if self.residual < bound)
        return next(bounds, f"{self.residual:.1e}")

    @property
    def missed(self) -> str:
        """By a first burst wrong by 1 % and by 1 degree, in the worst direction, in degrees."""
        found = self.sensitivity
        grown = ", grows exponentially" if self.growth_exponent else ""
        return f"{np.degrees(found.size):.3g}, {found.direction:.3g}{grown}"

    @property
    def growth_exponent(self) -> float:
        """The power of e by which errors grow on the way, 0 where they do not exponentially."""
        return exponent(_doubles(self.manoeuvre.inertia), self.omega0, self.duration)

    @property
    def cost(self) -> float:
        """Of both bursts together, |I omega(0)| + |I omega(T)| from rest to rest, N m s."""
        return float(np.linalg.norm(self.bursts, axis=1).sum())

    @property
    def momentum(self) -> float:
        """K, N m s."""
        return float(np.linalg.norm(_doubles(self.manoeuvre.inertia) * self.omega0))

    @property
    def energy(self) -> float:
        """Kinetic energy H, J."""
        return float(_doubles(self.manoeuvre.inertia) @ self.omega0**2 / 2)

    def to_case(self) -> str:
        """A case file of the motion, for `rigidsym propagate`."""
        given = self.manoeuvre
        lines = [
            f"{name} = {_listed(values)}"
            for name, values in (
                ("inertia", given.inertia),
                ("omega0", self.rates),
                ("attitude0", given.start),
            )
        ]
        stop = inputs.exact_text(given.duration or Fraction(0))
        times = ["", "[times]", "start = 0", f'stop = "{stop}"', f"count = {_SAMPLES}"]
        return "\n".join([*lines, *times, ""])

    def to_data(self) -> TransferData:
        """What `rigidsym.plan/1` holds of a transfer; `rates` are omega0 exactly."""
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
        from rigidsym.view.text import transfer_text

        return transfer_text(self)

    def _repr_html_(self) -> str:
        from rigidsym.view.html.plans import transfer_html

        return transfer_html(self)


def _listed(values: Sequence[Fraction]) -> str:
    return "[" + ", ".join(f'"{inputs.exact_text(x)}"' for x in values) + "]"


def _doubles(values: Sequence[Fraction]) -> np.ndarray:
    return np.array([float(x) for x in values])
