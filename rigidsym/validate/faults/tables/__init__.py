"""The faults, by target: those written by hand, and those drawn from the derived lines.

By hand are faults of runtime text and of what no change of one place of a tree says: quadrants,
double-cover signs, lengths, some units in the last place.
"""

from functools import cache

from rigidsym.validate.faults.drawn import drawn
from rigidsym.validate.faults.fault import FILES, Fault
from rigidsym.validate.faults.tables import c, numpy, steps

BY_HAND: tuple[Fault, ...] = (*numpy.FAULTS, *c.FAULTS, *steps.FAULTS)


@cache
def all_faults() -> tuple[Fault, ...]:
    """Those by hand, and those that are drawn, which takes a second or two."""
    return (*BY_HAND, *(fault for target in FILES for fault in drawn(target)))
