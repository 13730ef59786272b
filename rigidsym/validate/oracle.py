"""What is true of a sample: enclosures of its states, and how much they depend on the inputs."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from flint import arb

from rigidsym.precise import PreciseMotion
from rigidsym.precise.adaptive import GUARD_BITS
from rigidsym.precise.balls import working
from rigidsym.solution.polhode import Regime, discriminant
from rigidsym.validate.condition import condition
from rigidsym.validate.strata.sample import Numbers, Sample


@dataclass(frozen=True, slots=True)
class Reference:
    """The truth about a sample at N times; q (2, N, 4) and omega (2, N, 3) are sums of two doubles.

    radius: within which every true q, and omega over |omega|, lies, but for what the second of the
    doubles leaves out (2^-105, more only where omega is near the least double).
    distance: from the separatrix, 0 on it and 1 where nothing cancels in K^2 - 2 H c_b.
    rate: |omega0|, rad/s.  condition: of angle and of omega, (N,) each, as `condition` has it.
    """

    sample: Sample
    regime: Regime
    distance: float
    rate: float
    q: np.ndarray
    omega: np.ndarray
    radius: float
    condition: Mapping[str, np.ndarray]

    @property
    def turned(self) -> np.ndarray:
        """|omega0 t| (N,), rad."""
        return np.abs(self.sample.times) * self.rate

    def within(self, reach: float) -> "Reference":
        """The same at the times up to which the body has turned by `reach` radians, no further."""
        near = self.turned <= reach
        if near.all():
            return self
        times = tuple(t for t, kept in zip(self.sample.times, near, strict=True) if kept)
        return replace(
            self,
            sample=replace(self.sample, times=times),
            q=self.q[:, near],
            omega=self.omega[:, near],
            condition={name: values[near] for name, values in self.condition.items()},
        )


def enclose(sample: Sample, digits: int, with_condition: bool = True) -> Reference:
    """The states of a sample in balls of radius 10^-digits, and the condition of each; without it
    there are no numbers, in half the time."""
    motion, times = precise_motion(sample), list(map(Fraction, sample.times))
    if with_condition:
        rows = list(motion.sensitivities(times, column_digits(sample, digits)))
    else:
        # Balls are small in rad/s, and have to be so beside |omega|.
        more = digits + decades_below_one(sample.omega0)
        rows = [[*q, *omega] for q, omega in motion.enclosures(times, more)]
    states = [row[:7] for row in rows]
    with working(max((x.bits() for state in states for x in state), default=0) + GUARD_BITS):
        high = np.array(_table(float, states)).reshape(-1, 7)
        low = np.array(_table(lambda x, y: float(x - y), states, high.tolist())).reshape(-1, 7)
        radii = np.array(_table(lambda x: float(x.rad()), states)).reshape(-1, 7)
    radii[:, 4:] /= lengths(high[:, 4:])[:, None]
    unknown = dict.fromkeys(("angle", "omega"), np.full(len(times), np.nan))
    omega, columns = [row[4:7] for row in rows], [row[7:] for row in rows]
    return Reference(
        sample,
        motion.polhode.regime,
        distance(*sample.exact[:2]),
        math.hypot(*map(float, sample.omega0)),
        np.stack([high[:, :4], low[:, :4]]),
        np.stack([high[:, 4:], low[:, 4:]]),
        float(np.max(radii, initial=0.0)) * 2,
        condition(sample, omega, columns) if with_condition else unknown,
    )


def column_digits(sample: Sample, digits: int) -> int:
    """Digits of balls in kg m^2 and rad/s that make sensitivities so small in the inputs' own."""
    heavy = len(str(int(max(sample.inertia))))
    return digits + heavy + 2 * decades_below_one(sample.omega0)


def precise_motion(sample: Sample) -> PreciseMotion:
    """The motion of a sample, from the exact values of its numbers."""
    return PreciseMotion(*sample.exact)


def decades_below_one(omega0: Numbers) -> int:
    """How many digits more balls need to be as small beside the rates as they are beside 1."""
    largest = max(abs(Fraction(x)) for x in omega0)
    return max(0, -math.floor(math.log10(largest))) if largest else 0


def distance(inertia: Sequence[Fraction], omega0: Sequence[Fraction]) -> float:
    """|K^2 - 2 H c_b| over what its terms add up to: 0 on the separatrix, 1 far from it."""
    middle = sorted(inertia)[1]
    terms = sum(c * abs(c - middle) * w * w for c, w in zip(inertia, omega0, strict=True))
    return float(abs(discriminant(inertia, omega0)) / terms) if terms else 1.0


def lengths(vectors: np.ndarray, of_zero: float = 1.0) -> np.ndarray:
    """Lengths of the rows (N, k) -> (N,), safe from overflow; `of_zero` for rows of zeros."""
    largest = np.max(np.abs(vectors), axis=-1, initial=0.0)
    scale = np.where(largest == 0, 1.0, largest)
    length = scale * np.linalg.norm(vectors / scale[:, None], axis=-1)
    return np.where(largest == 0, of_zero, length)


def _table(
    compute: Callable[..., float], *tables: Sequence[Sequence[arb | float]]
) -> list[list[float]]:
    """compute, entry by entry."""
    return [list(map(compute, *rows)) for rows in zip(*tables, strict=True)]
