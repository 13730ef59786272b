"""Samples as a step is asked for them: numbers are doubles, and no time is beyond a turn."""

import math
from dataclasses import replace

from rigidsym.validate.strata.sample import Motion, Sample
from rigidsym.validate.strata.times import turning

# How far the documented bounds of a step go, rad.
TURN = 2 * math.pi
MEANING = (
    "A step takes doubles, and goes a turn at most: of each case the numbers are rounded to "
    "doubles, and times beyond |omega0 t| = 2 pi are halved until they are within."
)


def stepped(sample: Sample) -> Sample:
    """The sample with its numbers rounded to doubles, and times halved until |omega0 t| <= 2 pi."""
    inertia, omega0, attitude0 = (
        tuple(map(float, x)) for x in (sample.inertia, sample.omega0, sample.attitude0)
    )
    rate = turning(Motion(inertia, omega0))
    times = tuple(_halved(t, rate) for t in sample.times)
    return replace(sample, inertia=inertia, omega0=omega0, attitude0=attitude0, times=times)


def _halved(time: float, rate: float) -> float:
    """A time by the least power of two that brings it within a turn at `rate` rad/s."""
    while abs(time) * rate > TURN:
        time /= 2
    return time
