"""When a motion is wanted, by the angle it has turned."""

import math
from random import Random

from rigidsym.codegen.limits import LIMITS
from rigidsym.validate.strata.sample import Floats, Motion, Times

# A little less than |omega0 t| may be, since that product is rounded.
FARTHEST = 0.99 * 2.0 ** next(limit.exponent for limit in LIMITS if limit.name == "farthest")
_LEAST = 1e-6
# Times of each kind: a motion is worth many, since its constants cost more than a state.
_EACH = 8


def turns(most: float) -> Times:
    """t = 0, times evenly up to `most` radians of turning either way, and by decades."""

    def times(random: Random, index: int, motion: Motion) -> Floats:
        rate, sign = turning(motion), random.choice((-1, 1))
        angles = [random.uniform(0, most) for _ in range(_EACH)]
        angles += [_LEAST * (most / _LEAST) ** random.random() for _ in range(_EACH)]
        return (0.0, *(sign * (-1) ** k * angle / rate for k, angle in enumerate(angles)))

    return times


def turning(motion: Motion) -> float:
    """|omega0|, or 1 at rest."""
    return math.hypot(*motion.omega0) or 1.0
