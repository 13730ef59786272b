"""Classes of strata and samples, and functions that draw numbers and times."""

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
    """Inputs of a motion that a stratum draws.

    They are inertia (3), rates (3) and perhaps an attitude (4).
    """

    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers | None = None

    @property
    def turning(self) -> float:
        """The magnitude of the initial rates, or 1 at rest."""
        return math.hypot(*self.omega0) or 1.0


@dataclass(frozen=True, slots=True)
class Sample:
    """Case of a stratum, with the inputs of a motion and times.

    The inputs are inertia (3), rates (3) and attitude (4).
    """

    stratum: str
    index: int
    inertia: Numbers
    omega0: Numbers
    attitude0: Numbers
    times: Floats

    @property
    def name(self) -> str:
        """The sample's name, made of its stratum and index.

        `rigidsym validate --case` takes it.
        """
        return f"{self.stratum}:{self.index}"

    @property
    def exact(self) -> tuple[Exact, Exact, Exact]:
        """The exact values of inertia, rates and attitude."""
        return fractions(self.inertia), fractions(self.omega0), fractions(self.attitude0)

    @property
    def in_doubles(self) -> bool:
        """True if all inputs are doubles."""
        numbers = (*self.inertia, *self.omega0, *self.attitude0)
        return not any(isinstance(x, Fraction) for x in numbers)


Body = Callable[[Random, int], Motion]
Times = Callable[[Random, int, Motion], Floats]


@dataclass(frozen=True, slots=True)
class Stratum:
    """Named set of cases, which are drawn by index.

    about: a line on what the set covers.  size: how many different cases there are, or None for any
    number.
    """

    name: str
    about: str
    body: Body
    times: Times
    size: int | None = None


def fractions(values: Numbers) -> Exact:
    """Convert numbers to fractions of the same value."""
    return tuple(Fraction(x) for x in values)


def stepped(sample: Sample) -> Sample:
    """Return a sample with inputs in doubles and times within one turn of the body.

    Times are halved until |omega0 t| <= 2 pi.  A step is measured on such samples.
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
    """Return a term of a sequence that starts with 0 and 1 and then fills [0, 1] evenly.

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
    """Return a term of a sequence of doubles that is spread evenly over decades.

    Its terms are 10^-first to 10^-last.
    """
    return 10.0 ** -spread(index, first, last)


def exact_decade(index: int, first: int, last: int) -> Fraction:
    """Return a term of a sequence of exact negative powers of ten.

    Its terms are 10^-first to 10^-last.
    """
    return Fraction(1, 10 ** round(spread(index, first, last)))


def turns(most: float) -> Times:
    """Return a function that draws early and late times of a motion.

    The body turns by up to `most` rad until the early times.
    """

    def times(random: Random, index: int, motion: Motion) -> Floats:
        sign = random.choice((-1, 1))
        angles = [random.uniform(0, most) for _ in range(_EACH)]
        angles += [_LEAST * (most / _LEAST) ** random.random() for _ in range(_EACH)]
        early = _alternating(sign, angles, motion)
        return (0.0, *early, *late(random, motion, most))

    return times


def late(random: Random, motion: Motion, first: float) -> Floats:
    """Draw late times of a motion, up to the last that numeric modules allow.

    The body turns by at least `first` rad until then.
    """
    angles = [first * (MAX_ANGLE / first) ** random.random() for _ in range(_LATE)]
    angles.append(MAX_ANGLE * random.uniform(0.5, 1))
    return _alternating(random.choice((-1, 1)), angles, motion)


def _alternating(sign: int, angles: Sequence[float], motion: Motion) -> Floats:
    """Return times at which the body has turned by given angles, with alternating signs.

    Times end with the doubles: rates below 1e-294 rad/s turn less far than others.
    """
    sizes = [min(angle / motion.turning, _LATEST) for angle in angles]
    return tuple(sign * (-1) ** k * size for k, size in enumerate(sizes))
