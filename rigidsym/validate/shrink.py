"""The simplest case that still fails: numbers are replaced by simpler ones while it does."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from fractions import Fraction

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.motion import IDENTITY
from rigidsym.validate.strata import Sample
from rigidsym.validate.strata.sample import MAX_ANGLE

# Samples tried at most.
TRIALS = 200
DIGITS = 6

Fails = Callable[[Sample], bool]


def simplest(sample: Sample, fails: Fails) -> Sample:
    """A sample that fails as the given one does, and none of its simpler neighbours, or of as many
    as TRIALS allows."""
    tried = 0
    improved = True
    while improved:
        improved = False
        for simpler in _simpler(sample):
            tried += 1
            if tried > TRIALS:
                return sample
            if _is_bounded(simpler) and fails(simpler):
                sample, improved = simpler, True
                break
    return sample


def _simpler(sample: Sample) -> Iterator[Sample]:
    """Neighbours with one time, without an attitude, or with one simpler number."""
    if len(sample.times) > 1:
        yield from (replace(sample, times=(t,)) for t in sample.times)
    if sample.attitude0 != IDENTITY:
        yield replace(sample, attitude0=tuple(map(float, IDENTITY)))
    for name in ("omega0", "inertia", "times"):
        values = getattr(sample, name)
        for k, value in enumerate(values):
            for number in _simpler_numbers(value):
                yield replace(sample, **{name: (*values[:k], number, *values[k + 1 :])})


def _simpler_numbers(value: float | Fraction) -> Iterable[float | Fraction]:
    """0, 1, -1, then decimals of few digits, as far as these are simpler than the number."""
    ladder = [0.0, 1.0, -1.0, *(float(f"{float(value):.{k}e}") for k in range(DIGITS))]
    listed: list[float | Fraction] = list(dict.fromkeys(ladder))
    return listed[: listed.index(value)] if value in listed else listed


def _is_bounded(sample: Sample) -> bool:
    """Whether the documented bounds are about it: a body can be like that, and the times are not
    beyond those that modules follow, where to refuse is no failure."""
    try:
        inputs.inertia(sample.inertia)
    except InputError:
        return False
    turned = math.hypot(*sample.omega0) * max(map(abs, sample.times))
    # Decimals of the largest doubles can be infinite.
    return all(map(math.isfinite, (*sample.inertia, turned))) and turned <= MAX_ANGLE
