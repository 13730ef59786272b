"""Reference vectors of the flight profile: correctly rounded states in all strata, and refusals."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations

from mpmath import mp, mpf
from mpmath.libmp import to_rational

from rigidsym.precise import PreciseMotion
from rigidsym.validate.strata import STRATA, Sample, draw, in_doubles, stepped

# Cases of each stratum, and times of each case: the first, the last and some between.
CASES, TIMES = 3, 4
# Digits of exact states, more where a number is near the middle between two doubles.
_DIGITS = (25, 40, 80)
Floats = tuple[float, ...]
# Moments and rates of motions that decisions are close for, the axis of middle moment second.
_EDGES: tuple[tuple[Floats, Floats], ...] = (
    # Spins about the middle axis whose other rates binary64 cannot follow.
    ((1.0, 2.0, 2.5), (5e-324, 1.0, 0.0)),
    ((1.0, 2.0, 2.5), (1e-200, 0.7, 1e-125)),
    ((1.0, 2.0, 2.5), (1e-119, 0.7, 1e-125)),
    ((1.0, 1.0000001, 1.5), (1e-125, 1.0, 1e-121)),
    ((0.01, 1.0, 1.005), (1e-300, 1.0, 1e-123)),
    ((1e-10, 1.0, 1.00000000005), (1e-310, 1.0, 1e-320)),
    # K^2 - 2 H c_b below the least that is followed: 3 x^2 - y^2 = -1 in whole numbers; a needle.
    ((1.0, 2.0, 3.0), (5170128475599457 * 2.0**-451, 1.0, 2984975067132296 * 2.0**-451)),
    ((2.0**-51, 1.0, 1.0 + 2.0**-51), (2.0**-400, 1.0, 2.0**-400)),
    # Nearly a sphere: a spin that would take longer than all times to turn over.
    ((1.0, 1.0 + 2.0**-52, 1.0 + 2.0**-51), (1e-125, 1.0, 1e-125)),
    # Rates that vanish in inner units, and bodies that exist but for rounding.
    ((1.0, 2.0, 2.5), (5e-324, 3.0, 5e-324)),
    ((1.0, 1.0, 2.0 + 2.0**-50), (0.3, 0.5, -0.7)),
    ((0.1, 0.2, 0.30000000000000004), (0.3, 0.5, -0.7)),
    ((1.0, 2.0, 3.0), (0.3, 0.5, -0.7)),
    # Symmetric bodies that spin about their axis of symmetry, or about another.
    ((1.0, 1.0, 1.0), (0.3, 1e-200, 0.0)),
    ((0.6, 1.0, 1.0), (0.7, 0.0, 0.0)),
    ((0.6, 1.0, 1.0), (0.0, 0.3, -0.4)),
    ((1.7, 1.0, 1.0), (-0.7, 0.0, 0.0)),
    ((1.7, 1.0, 1.0), (0.0, 0.3, 0.4)),
)
_ATTITUDES = (
    (0.5, -1.0, 2.0, 0.25),
    (0.0, 1.0, 0.0, 0.0),
    (0.0, 0.0, -2.0, 0.0),
    (0.0, 0.0, 0.0, 3.0),
)


@dataclass(frozen=True, slots=True)
class Vector:
    """Motion in doubles, a time, and its state there.

    given: inertia (3), rates (3) and attitude (4).  state: q (4) and omega (3) at time + more, each
    the double nearest to the exact number.
    """

    name: str
    given: tuple[Floats, Floats, Floats]
    time: float
    state: Floats
    more: float = 0.0


def of_motions(cases: int = CASES, times: int = TIMES) -> Iterator[Vector]:
    """Yield vectors of motions in all strata whose inputs are doubles, and beside their edges.

    The last time of each motion is a sum of two doubles.
    """
    for sample in (*_samples(cases), *_edges()):
        *first, last = _vectors(sample, times)
        yield from first
        more = 0.375 * math.ulp(last.time)
        time = Fraction(last.time) + Fraction(more)
        state = _rounded_state(PreciseMotion(*sample.exact), time)
        yield replace(last, name=f"{last.name} + {more!r} s", more=more, state=state)


def of_steps(cases: int = CASES, times: int = TIMES) -> Iterator[Vector]:
    """Yield vectors of single steps from the same states, within one turn of the body."""
    for sample in (*_samples(cases), *_edges()):
        yield from _vectors(stepped(sample), times)


def _samples(cases: int) -> Iterator[Sample]:
    for stratum in in_doubles():
        size = STRATA[stratum].size
        for index in range(cases if size is None else min(cases, size)):
            yield draw(stratum, index, seed=1)


def _edges() -> Iterator[Sample]:
    """Yield motions that binary64 cannot tell from the separatrix, or from spins, in all orders.

    They have states up to some time, which is later than those here.
    """
    for number, (inertia, omega0) in enumerate(_EDGES):
        for turn, order in enumerate(permutations(range(3))):
            yield Sample(
                "edges",
                6 * number + turn,
                tuple(inertia[k] for k in order),
                tuple(omega0[k] for k in order),
                _ATTITUDES[(number + turn) % len(_ATTITUDES)],
                (0.0, 1.0, -50.0),
            )


def _vectors(sample: Sample, times: int) -> Iterator[Vector]:
    exact = sample.exact
    inertia, omega0, attitude0 = (tuple(map(float, numbers)) for numbers in exact)
    given = (inertia, omega0, attitude0)
    motion = PreciseMotion(*exact)
    last = len(sample.times) - 1
    chosen = dict.fromkeys(round(k * last / max(times - 1, 1)) for k in range(times))
    for k in chosen:
        time = sample.times[k]
        state = _rounded_state(motion, Fraction(time))
        yield Vector(f"{sample.name} at {time!r} s", given, time, state)


def _rounded_state(motion: PreciseMotion, time: Fraction) -> Floats:
    """Return the doubles nearest to attitude and rates at a time.

    Raises ArithmeticError where that many digits do not tell to which double a number rounds.
    """
    for digits in _DIGITS:
        ((q, omega),) = motion.states([time], digits)
        near = [_fraction(x) for x in (*q, *omega)]
        less, more = (
            tuple(float(x + sign * x / 10 ** (digits - 1)) for x in near) for sign in (-1, 1)
        )
        if less == more:
            return less
    raise ArithmeticError(f"t = {float(time)!r}: a number lies between two doubles")


def _fraction(x: mpf) -> Fraction:
    """Return the exact value of a number, or 0 for one that is far below the least double."""
    return Fraction(0) if x == 0 or mp.mag(x) < -1200 else Fraction(*to_rational(x._mpf_))


@dataclass(frozen=True, slots=True)
class Refusal:
    """Input of a motion or of a step that is refused, and the name of the code.

    given: inertia (3), rates (3) and attitude (4).  time: of a state, or of a step.
    """

    code: str
    about: str
    given: tuple[Floats, Floats, Floats]
    time: float = 1.0


_NAN, _INF, _MOST, _LEAST = math.nan, math.inf, 2.0**1023, 5e-324
_BODY, _RATES, _ATTITUDE = (1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0)
# Rates about the first and last axis, that about the middle one grows to 1.05 2^990 rad/s.
_THIN, _GROWING = (0.2, 0.9, 1.0), (0.78 * 2.0**990, 0.0, 0.93 * 2.0**990)
_TENSE = (_BODY, _RATES, _ATTITUDE)


def _with_each(code: str, about: str, place: int, bad: float) -> Iterator[Refusal]:
    """Yield an input with a bad number in place of each number of a vector in turn."""
    for k in range(len(_TENSE[place])):
        given = [list(numbers) for numbers in _TENSE]
        given[place][k] = bad
        inertia, rates, attitude = map(tuple, given)
        yield Refusal(code, f"{about}[{k}] = {bad!r}", (inertia, rates, attitude))


def _of_both() -> Iterator[Refusal]:
    """Yield inputs that motions and steps refuse alike."""
    for place, about in enumerate(("inertia", "rates", "attitude")):
        for bad in (_NAN, _INF):
            yield from _with_each("NOT_FINITE", about, place, bad)
    for place, about in ((1, "rates"), (2, "attitude")):
        yield from _with_each("NOT_FINITE", about, place, -_INF)
    for bad in (0.0, -1.0):
        yield from _with_each("INERTIA", "inertia", 0, bad)
    for thin in ((2.0**-201, 1.0, 1.0), (1.0, 2.0**-201, 1.0), (1.0, 1.0, 2.0**-201)):
        yield Refusal("THIN", f"inertia = {thin}", (thin, _RATES, _ATTITUDE))
    for most in ((1.0, 1.0, 2.5), (1.0, 2.5, 1.0), (2.5, 1.0, 1.0)):
        yield Refusal("NONPHYSICAL", f"inertia = {most}", (most, _RATES, _ATTITUDE))
    yield Refusal("ATTITUDE", "attitude = 0", (_BODY, _RATES, (0.0, -0.0, 0.0, 0.0)))
    for bad in (_NAN, _INF, -_INF):
        yield Refusal("NOT_FINITE", f"time = {bad!r}", _TENSE, bad)


def refused_motions() -> tuple[Refusal, ...]:
    """Return inputs for each reason to refuse a motion or a time of it."""
    still, spin = (0.0, 0.0, 0.0), (0.0, 1.0, 1e-130)
    own = [
        Refusal("NOT_FINITE", "time of a body at rest", (_BODY, still, _ATTITUDE), _NAN),
        Refusal("TIME", "|omega t| > 2^46 rad", _TENSE, _MOST),
        Refusal("TIME", "|omega t| > 2^46 rad, before", _TENSE, -_MOST),
        Refusal("TIME", "inner times end at 2^46", _TENSE, math.nextafter(2.0**47, _INF)),
        # From 571.7 s on it may have turned over.
        Refusal("SEPARATRIX", "a spin followed too long", (_BODY, spin, _ATTITUDE), 575.0),
        Refusal("RATES", "rates near the largest double", (_BODY, (_MOST,) * 3, _ATTITUDE)),
        Refusal("RATES", "a rate that grows beyond 2^990", (_THIN, _GROWING, _ATTITUDE)),
    ]
    return (*_of_both(), *own)


def refused_steps() -> tuple[Refusal, ...]:
    """Return inputs for each reason to refuse a step."""
    rate = math.hypot(*_RATES)
    own = (
        Refusal("ANGLE", f"|omega dt| = {angle} rad", _TENSE, angle / rate)
        for angle in (8.01, -8.01, 1e3)
    )
    return (*_of_both(), *own)


@dataclass(frozen=True, slots=True)
class Vectors:
    """All reference vectors: states of motions, steps, and refusals of both."""

    states: tuple[Vector, ...]
    steps: tuple[Vector, ...]
    refused_motions: tuple[Refusal, ...]
    refused_steps: tuple[Refusal, ...]


def vectors() -> Vectors:
    """Compute all reference vectors."""
    return Vectors(tuple(of_motions()), tuple(of_steps()), refused_motions(), refused_steps())
