"""Named strata of cases: the motions where a numeric module could go wrong.

Every case is drawn from its own generator, seeded by seed, stratum and index, so that any case can
be drawn again alone.  Numbers are doubles or fractions and are taken at their exact value; all
bodies can exist.
"""

from rigidsym.validate.strata._sample import Sample, Stratum, stepped
from rigidsym.validate.strata._table import STRATA, count, draw, in_doubles, samples

__all__ = ["STRATA", "Sample", "Stratum", "count", "draw", "in_doubles", "samples", "stepped"]
