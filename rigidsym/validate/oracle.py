"""What is true of a sample: enclosures of its states, and how much they depend on the inputs."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random

import numpy as np
from flint import arb

from rigidsym.precise import PreciseMotion
from rigidsym.precise.adaptive import GUARD_BITS
from rigidsym.precise.balls import bits_of, working
from rigidsym.solution.polhode import Regime, discriminant
from rigidsym.validate.strata.sample import Numbers, Sample

# Normal deviates are rounded to parts of this, so that exact arithmetic with them stays quick.
GRAIN = 1024
# The least relative change is 2^-FINEST: doubles have to hold what is over it.
FINEST = 1000


@dataclass(frozen=True, slots=True)
class Reference:
    """The truth about a sample at N times; q (2, N, 4) and omega (2, N, 3) are sums of two doubles.

    radius: within which every true q, and omega over |omega|, lies, but for what the second of the
    doubles leaves out (2^-105, more only where omega is near the least double).
    distance: from the separatrix, 0 on it and 1 where nothing cancels in K^2 - 2 H c_b.
    rate: |omega0|, rad/s.  condition: of angle and of omega, (N,) each; a number that is beyond
    10^(digits/2) is not told from one that is larger still.
    """

    sample: Sample
    regime: Regime
    distance: float
    rate: float
    q: np.ndarray
    omega: np.ndarray
    radius: float
    condition: dict[str, np.ndarray]

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


def enclose(sample: Sample, digits: int) -> Reference:
    """The states of a sample in balls of radius 10^-digits, and the condition of each."""
    motion, times = precise_motion(sample), list(map(Fraction, sample.times))
    # Balls are small in rad/s, and have to be so beside |omega|.
    more = digits + decades_below_one(sample.omega0)
    step = Fraction(1, 2 ** min(bits_of(digits // 2), FINEST))
    moved = _perturbed(motion, step, Random(repr(sample)))
    states = [[*q, *omega] for q, omega in motion.enclosures(times, more)]
    others = [[*q, *omega] for q, omega in moved.enclosures(times, more)]
    with working(bits_of(more) + GUARD_BITS):
        changes = np.array(_table(lambda x, y: float(x - y), states, others)).reshape(-1, 7)
        high = np.array(_table(float, states)).reshape(-1, 7)
        low = np.array(_table(lambda x, y: float(x - y), states, high.tolist())).reshape(-1, 7)
        radii = np.array(_table(lambda x: float(x.rad()), states)).reshape(-1, 7)
    size = lengths(high[:, 4:])[:, None]
    radii[:, 4:] /= size
    changes[:, 4:] /= size
    return Reference(
        sample,
        motion.polhode.regime,
        distance(*sample.exact[:2]),
        math.hypot(*map(float, sample.omega0)),
        np.stack([high[:, :4], low[:, :4]]),
        np.stack([high[:, 4:], low[:, 4:]]),
        float(np.max(radii, initial=0.0)) * 2,
        _condition(motion, np.array(sample.times), high[:, 4:], changes / float(step)),
    )


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


def _perturbed(motion: PreciseMotion, step: Fraction, random: Random) -> PreciseMotion:
    """Moments and rates changed by about step of themselves, by normal deviates.

    The mean square of the change this causes, over step, is the squared Frobenius norm of the
    derivatives; one draw is within a factor of ten of that nine times of ten and more: least often
    where one derivative outweighs all others, as near the separatrix (Gudmundsson, Kenney and Laub,
    SIAM J. Matrix Anal. Appl. 16, 1995).  Where changes of the inputs grow beyond 1/step, the
    states are as far apart as they can be, and the quotient stays there.
    """

    def changed(values: Sequence[Fraction]) -> tuple[Fraction, ...]:
        deviates = (Fraction(round(random.gauss(0, GRAIN)), GRAIN) for _ in values)
        return tuple(x * (1 + dx * step) for x, dx in zip(values, deviates, strict=True))

    inertia, omega0, attitude0 = motion.exact
    return PreciseMotion(changed(inertia), changed(omega0), attitude0)


def _condition(
    motion: PreciseMotion, times: np.ndarray, omega: np.ndarray, slopes: np.ndarray
) -> dict[str, np.ndarray]:
    """What relative changes make of angle and rates, by derivatives (N, 7) of the states, those of
    rates over |omega|.

    Those by time are added here: |omega t|, and |omega' t| / |omega|.
    """
    size = lengths(omega)[:, None]
    turned = lengths(omega, 0.0) * np.abs(times)
    bend = _bend(motion.exact[0], omega / size)
    return {
        "angle": np.hypot(turned, 2 * lengths(slopes[:, :4], 0.0)),
        "omega": np.hypot(turned * bend, lengths(slopes[:, 4:], 0.0)),
    }


def _bend(inertia: Sequence[Fraction], unit: np.ndarray) -> np.ndarray:
    """|omega'| / |omega|^2 by Euler's equations, for rates over their size (N, 3)."""
    factors = [float((inertia[k - 2] - inertia[k - 1]) / inertia[k]) for k in range(3)]
    return lengths(np.array(factors) * np.roll(unit, -1, axis=1) * np.roll(unit, -2, axis=1), 0.0)


def _table(
    compute: Callable[..., float], *tables: Sequence[Sequence[arb | float]]
) -> list[list[float]]:
    """compute, entry by entry."""
    return [list(map(compute, *rows)) for rows in zip(*tables, strict=True)]
