"""Reference states of samples, computed by enclosures and checked by Taylor series.

A condition number is the length (Frobenius norm) of a matrix: relative changes of rates, moments
and the time turn into the small turn of the attitude, in rad, or the change of the rates over
|omega|.  It is the root mean square of what independent changes of one come to, and at most sqrt(3)
times the most that changes of length one can.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np
from flint import arb

from rigidsym import _inputs as inputs
from rigidsym.precise import PreciseMotion
from rigidsym.precise._balls import GUARD_BITS, ball, bits_of, power, working
from rigidsym.precise._taylor import integrate
from rigidsym.solution._polhode import Regime, discriminant
from rigidsym.validate.strata._sample import Numbers, Sample

# Digits of the Taylor series, and the agreement they need, relative to 1 or to |omega0|.
SECOND_DIGITS, AGREEMENT = 20, 1e-20
# How far the Taylor series go, rad: their cost grows with it.
SECOND_REACH = 1.0
# Two cases in so many are checked by Taylor series: the first two of each stratum, its ends, first.
SECOND_SHARE = 256


@dataclass(frozen=True, slots=True)
class Reference:
    """True states of a sample as sums of two doubles.

    q (2, N, 4), omega (2, N, 3): the states at N times.  radius: bound on the errors of q, and of
    omega over |omega|, apart from the rounding of the second of the doubles (2^-105, more only
    where omega is near the least double).  distance: from the separatrix, 0 on it and 1 where
    nothing cancels in K^2 - 2 H c_b.  rate: |omega0|, rad/s.  condition: numbers of angle and of
    omega, (N,) each.
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
        """The angles |omega0 t| by which the body has turned at each time, in rad."""
        return np.abs(self.sample.times) * self.rate

    def within(self, reach: float) -> "Reference":
        """Restrict the reference to times at which the body has turned by at most `reach` rad."""
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
    """Compute the true states of a sample by enclosures of radius 10^-digits.

    Without condition numbers, which are then NaN, it takes half the time.
    """
    motion, times = precise_motion(sample), list(map(Fraction, sample.times))
    if with_condition:
        rows = list(motion.sensitivities(times, column_digits(sample, digits)))
    else:
        # The radii are in rad/s, and have to be small relative to |omega|.
        more = digits + decades_below_one(sample.omega0)
        rows = [[*q, *omega] for q, omega in motion.enclosures(times, more)]
    states = np.array([row[:7] for row in rows], object).reshape(-1, 7)
    with working(max((x.bits() for x in states.flat), default=0) + GUARD_BITS):
        high = states.astype(float)
        low = (states - high).astype(float)
        radii = np.array([float(x.rad()) for x in states.flat]).reshape(-1, 7)
    radii[:, 4:] /= lengths(high[:, 4:])[:, None]
    unknown = dict.fromkeys(("angle", "omega"), np.full(len(times), np.nan))
    return Reference(
        sample,
        motion.polhode.regime,
        distance(*sample.exact[:2]),
        math.hypot(*map(float, sample.omega0)),
        np.stack([high[:, :4], low[:, :4]]),
        np.stack([high[:, 4:], low[:, 4:]]),
        float(np.max(radii, initial=0.0)) * 2,
        condition(sample, rows) if with_condition else unknown,
    )


def column_digits(sample: Sample, digits: int) -> int:
    """Return the number of digits to which derivatives have to be computed for a sample.

    Columns are then correct to `digits` in the inputs' own units.
    """
    heavy = len(str(int(max(sample.inertia))))
    return digits + heavy + 2 * decades_below_one(sample.omega0)


def precise_motion(sample: Sample) -> PreciseMotion:
    """Return the arbitrary-precision motion of a sample's exact inputs."""
    return PreciseMotion(*sample.exact)


def decades_below_one(omega0: Numbers) -> int:
    """Return how many decades the largest rate is below 1 rad/s, rounded up."""
    largest = max(abs(Fraction(x)) for x in omega0)
    return max(0, -math.floor(math.log10(largest))) if largest else 0


def distance(inertia: Sequence[Fraction], omega0: Sequence[Fraction]) -> float:
    """Return the relative distance of a motion from the separatrix.

    It is 0 on the separatrix and 1 far away.  Its value is |K^2 - 2 H c_b| over the sum of the
    sizes of its terms.
    """
    middle = sorted(inertia)[1]
    terms = sum(c * abs(c - middle) * w * w for c, w in zip(inertia, omega0, strict=True))
    return float(abs(discriminant(inertia, omega0)) / terms) if terms else 1.0


def lengths(vectors: np.ndarray, of_zero: float = 1.0) -> np.ndarray:
    """Return the Euclidean norms of the rows of a matrix, without overflow.

    of_zero: the result for rows of zeros.
    """
    largest = np.max(np.abs(vectors), axis=-1, initial=0.0)
    scale = np.where(largest == 0, 1.0, largest)
    length = scale * np.linalg.norm(vectors / scale[:, None], axis=-1)
    return np.where(largest == 0, of_zero, length)


def condition(sample: Sample, rows: Sequence[Sequence[arb]]) -> Mapping[str, np.ndarray]:
    """Return the condition numbers of attitude and rates at the times of a sample.

    There are (N,) of each, infinite where they are beyond binary64. rows: of each time the list
    that `PreciseMotion.sensitivities` returns.
    """
    inertia, omega0, _ = sample.exact
    given = list(map(ball, (*omega0, *inertia)))
    found: dict[str, list[list[float]]] = {"angle": [], "omega": []}
    for time, row in zip(sample.times, rows, strict=True):
        size = sum((power(x, 2) for x in row[4:7]), arb(0)).sqrt()
        inputs = [*given, ball(Fraction(time))]
        over = inputs if size.is_zero() else [x / size for x in inputs]
        # Small turns and rates (3 each) by nine inputs, then by the time.
        slopes = np.array(row[7:61], object).reshape(2, 3, 9)[..., 3:]
        by_time = np.array(row[61:], object).reshape(2, 3, 1)
        entries = np.concatenate([slopes, by_time], axis=-1)
        for values, part, units in zip(found.values(), entries, (inputs, over), strict=True):
            values.append([float(x) for x in (part * np.array(units, object)).flat])
    return {name: _norms(np.array(values)) for name, values in found.items()}


def _norms(rows: np.ndarray) -> np.ndarray:
    """Return the Euclidean norms of rows, with infinity for rows that have an infinite entry."""
    infinite = np.isinf(np.max(np.abs(rows), axis=1, initial=0.0))
    return np.where(infinite, np.inf, lengths(np.where(infinite[:, None], 0.0, rows), 0.0))


def is_due(index: int) -> bool:
    """Return True if Taylor series check the true states of the case with a given index."""
    return index % SECOND_SHARE in (0, 1)


def disagreement(motion: PreciseMotion, backwards: bool) -> float:
    """Return the difference of Taylor series from enclosures, divided by the allowed difference.

    The allowed distance is AGREEMENT.  The series of the equations of motion use no elliptic
    function.  Compared is the state after SECOND_REACH radians.
    """
    inertia, omega0, attitude0 = motion.exact
    rate = math.hypot(*map(float, omega0)) or 1.0
    time = Fraction(-SECOND_REACH / rate if backwards else SECOND_REACH / rate)
    series = integrate(inertia, omega0, attitude0, time, SECOND_DIGITS)
    digits = SECOND_DIGITS + decades_below_one(omega0)
    ((q, omega),) = motion.enclosures([time], digits)
    with working(bits_of(2 * digits)):
        sizes = (1, ball(Fraction(rate)))
        differences = [
            abs(balls - ball(inputs.exact("series", x))) / size
            for part, numbers, size in zip((q, omega), series, sizes, strict=True)
            for balls, x in zip(part, numbers, strict=True)
        ]
        found = [float(x.upper()) for x in differences]
    return math.inf if any(map(math.isnan, found)) else max(found) / AGREEMENT
