"""Types of strata and samples, numbers spread over ranges, and times by angle."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random

from rigidsym._codegen.forms import LIMITS

Floats = tuple[float, ...]
Numbers = tuple[float | Fraction, ...]
Exact = tuple[Fraction, ...]

# A little less than the largest |omega0 t|, since that product is rounded.
MAX_ANGLE = 0.99 * 2.0 ** next(limit.exponent for limit in LIMITS if limit.name == "max_angle")
# The documented bounds of a step end there, rad.
TURN = 2 * math.pi
_LEAST = 1e-6
# How many times of each kind: a motion has many, since its constants cost more than a state.
_EACH = 8
_LATE = 4
# Measures also look at times a little later.
_LATEST = 2.0**1023


@dataclass(frozen=True, slots=True)
class Motion:
    """Motion that a stratum draws: inertia (3), rates (3) and perhaps an attitude (4)."""

    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers | None = None

    @property
    def turning(self) -> float:
        """|omega0|, or 1 at rest."""
        return math.hypot(*self.omega0) or 1.0


@dataclass(frozen=True, slots=True)
class Sample:
    """Case of a stratum: inertia (3), rates (3), attitude (4) and times."""

    stratum: str
    index: int
    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers
    times: Floats

    @property
    def name(self) -> str:
        """The stratum and the index, as `rigidsym validate --case` takes them."""
        return f"{self.stratum}:{self.index}"

    @property
    def exact(self) -> tuple[Exact, Exact, Exact]:
        """The exact values of inertia, rates and attitude."""
        return fractions(self.inertia), fractions(self.omega0), fractions(self.attitude0)

    @property
    def in_doubles(self) -> bool:
        """True if all of its numbers are doubles."""
        numbers = (*self.inertia, *self.omega0, *self.attitude0)
        return not any(isinstance(x, Fraction) for x in numbers)


Body = Callable[[Random, int], Motion]
Times = Callable[[Random, int, Motion], Floats]


@dataclass(frozen=True, slots=True)
class Stratum:
    """Source of cases by index, with a line `about` on what it covers.

    size: how many different cases there are, or None for any number.
    """

    name: str
    about: str
    body: Body
    times: Times
    size: int | None = None


def fractions(values: Numbers) -> Exact:
    """Return the exact values of numbers."""
    return tuple(Fraction(x) for x in values)


def stepped(sample: Sample) -> Sample:
    """Return the sample in doubles, with times halved until |omega0 t| <= 2 pi.

    A step is measured on such samples.
    """
    inertia, omega0, attitude0 = (
        tuple(map(float, x)) for x in (sample.inertia, sample.omega0, sample.attitude0)
    )
    rate, times = Motion(inertia, omega0).turning, list(sample.times)
    for k in range(len(times)):
        while abs(times[k]) * rate > TURN:
            times[k] /= 2
    return replace(sample, inertia=inertia, omega0=omega0, attitude0=attitude0, times=tuple(times))


def share(index: int, base: int = 2) -> float:
    """Return a term of a sequence that fills [0, 1] evenly and begins with both ends.

    After the ends it is van der Corput's, whose bases make independent coordinates.

    >>> [share(index) for index in range(7)]
    [0.0, 1.0, 0.5, 0.25, 0.75, 0.125, 0.625]
    """
    if index < 2:
        return float(index)
    index, value, unit = index - 1, 0.0, 1.0
    while index:
        index, digit = divmod(index, base)
        unit /= base
        value += digit * unit
    return value


def spread(index: int, first: float, last: float, base: int = 2) -> float:
    """Return a term of a sequence that fills the interval from first to last evenly."""
    return first + (last - first) * share(index, base)


def decade(index: int, first: float, last: float) -> float:
    """Return a term of a sequence of doubles, 10^-first to 10^-last, evenly over decades."""
    return 10.0 ** -spread(index, first, last)


def exact_decade(index: int, first: int, last: int) -> Fraction:
    """Return a term of a sequence of exact powers of ten, 10^-first to 10^-last."""
    return Fraction(1, 10 ** round(spread(index, first, last)))


def turns(most: float) -> Times:
    """Return a function that draws early times, up to `most` rad, and late times."""

    def times(random: Random, index: int, motion: Motion) -> Floats:
        sign = random.choice((-1, 1))
        angles = [random.uniform(0, most) for _ in range(_EACH)]
        angles += [_LEAST * (most / _LEAST) ** random.random() for _ in range(_EACH)]
        early = _alternating(sign, angles, motion)
        return (0.0, *early, *late(random, motion, most))

    return times


def late(random: Random, motion: Motion, first: float) -> Floats:
    """Draw late times, from `first` rad of turning to the last allowed."""
    angles = [first * (MAX_ANGLE / first) ** random.random() for _ in range(_LATE)]
    angles.append(MAX_ANGLE * random.uniform(0.5, 1))
    return _alternating(random.choice((-1, 1)), angles, motion)


def _alternating(sign: int, angles: Sequence[float], motion: Motion) -> Floats:
    """Return the times at which the body has turned by these angles, with alternating signs.

    Times end with the doubles: rates below 1e-294 rad/s turn less far than others.
    """
    sizes = [min(angle / motion.turning, _LATEST) for angle in angles]
    return tuple(sign * (-1) ** k * size for k, size in enumerate(sizes))
