"""Strata, which are named sets of random motions that test numeric modules.

Every case is drawn from its own generator, seeded by seed, stratum and index, so that any case can
be drawn again alone.  Numbers are doubles or fractions and are taken at their exact value; all
bodies can exist.
"""

from collections.abc import Iterator
from functools import cache
from random import Random

from rigidsym.validate.strata._motions import STRATA
from rigidsym.validate.strata._sample import Numbers, Sample, Stratum, stepped

__all__ = ["STRATA", "Sample", "Stratum", "count", "draw", "in_doubles", "samples", "stepped"]


def count(stratum: str, cases: int) -> int:
    """Return a stratum's number of cases, limited to `cases`."""
    size = STRATA[stratum].size
    return cases if size is None else min(cases, size)


@cache
def in_doubles() -> tuple[str, ...]:
    """Return the names of the strata whose inputs are all doubles."""
    return tuple(name for name in STRATA if draw(name, 0, 0).in_doubles)


def samples(cases: int, seed: int) -> Iterator[Sample]:
    """Yield the first `cases` samples of every stratum."""
    for stratum in STRATA:
        for index in range(count(stratum, cases)):
            yield draw(stratum, index, seed)


def draw(stratum: str, index: int, seed: int) -> Sample:
    """Draw one random sample of a stratum.

    The same arguments always give the same sample.

    Parameters
    ----------
    stratum : a key of `STRATA`
    index : the number of the case, below the size of a finite stratum
    seed : of all cases

    Returns
    -------
    Sample
        Inertia (3) in kg m^2, omega0 (3) in rad/s, attitude0 (4) and times in s.

    Examples
    --------
    >>> draw("paper", 0, seed=1).inertia
    (0.0109, 0.04, 0.0506)
    """
    random = Random(f"{seed}/{stratum}/{index}")
    chosen = STRATA[stratum]
    motion = chosen.body(random, index)
    drawn: Numbers = tuple(random.gauss(0, 1) for _ in range(4))
    attitude = drawn if motion.attitude0 is None else motion.attitude0
    times = chosen.times(random, index, motion)
    return Sample(stratum, index, motion.inertia, motion.omega0, attitude, times)
