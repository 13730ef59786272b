"""When a motion is wanted, by the angle it turned: in every stratum to the end of the domain."""

import math
from collections.abc import Sequence
from random import Random

from rigidsym.codegen.limits import LIMITS
from rigidsym.validate.strata.sample import Floats, Motion, Times

# A little less than |omega0 t| may be, since that product is rounded.
MAX_ANGLE = 0.99 * 2.0 ** next(limit.exponent for limit in LIMITS if limit.name == "max_angle")
_LEAST = 1e-6
# Times of each kind: a motion is worth many, since its constants cost more than a state.
_EACH = 8
_LATE = 4
# Measures look at times that are a little later, too.
_LATEST = 2.0**1023


def turns(most: float) -> Times:
    """t = 0, times evenly up to `most` radians of turning either way, by decades, and late ones."""

    def times(random: Random, index: int, motion: Motion) -> Floats:
        sign = random.choice((-1, 1))
        angles = [random.uniform(0, most) for _ in range(_EACH)]
        angles += [_LEAST * (most / _LEAST) ** random.random() for _ in range(_EACH)]
        early = _signed(sign, angles, motion)
        return (0.0, *early, *late(random, motion, most))

    return times


def late(random: Random, motion: Motion, first: float) -> Floats:
    """Times by decades from `first` radians of turning to the last allowed, and near that."""
    angles = [first * (MAX_ANGLE / first) ** random.random() for _ in range(_LATE)]
    angles.append(MAX_ANGLE * random.uniform(0.5, 1))
    return _signed(random.choice((-1, 1)), angles, motion)


def _signed(sign: int, angles: Sequence[float], motion: Motion) -> Floats:
    """When these angles are turned, every second one backwards; rates below 1e-294 rad/s do not
    turn as far as others while doubles last."""
    rate = turning(motion)
    sizes = [min(angle / rate, _LATEST) for angle in angles]
    return tuple(sign * (-1) ** k * size for k, size in enumerate(sizes))


def turning(motion: Motion) -> float:
    """|omega0|, or 1 at rest."""
    return math.hypot(*motion.omega0) or 1.0
