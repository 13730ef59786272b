"""Bodies where the modules go over from one series to the other, which is where both are worst.

The modules use the circular series up to k_1^2 = 1/2, k_1 the modulus after one Landen step, and
the hyperbolic ones beyond: what either leaves out is largest there.
"""

import math
from random import Random

from rigidsym.validate.strata.bodies import body, mixed
from rigidsym.validate.strata.sample import Motion
from rigidsym.validate.strata.spread import decade


def switch(random: Random, index: int) -> Motion:
    """k_1^2 is 1/2 but for 3e-1 to 1e-16 of it, on either side, by any phase."""
    moments = sorted(body(random), reverse=random.choice((True, False)))
    k_1 = math.sqrt((1 + random.choice((-1, 1)) * decade(index, 0.5, 16)) / 2)
    return mixed(random, moments, _rates(random, moments, k_1))


def _rates(random: Random, moments: list[float], k_1: float) -> list[float]:
    """A dn, B sn and D cn at any phase: the rates about the axes a, b and d of a body."""
    c_a, c_b, c_d = moments
    m = 1 - ((1 - k_1) / (1 + k_1)) ** 2
    size_d = math.sqrt(m * c_a * (c_a - c_b) / (c_d * (c_b - c_d)))
    size_b = size_d * math.sqrt(c_d * (c_a - c_d) / (c_b * (c_a - c_b)))
    sn, cn = math.sin(phase := random.uniform(-math.pi, math.pi)), math.cos(phase)
    return [math.sqrt(1 - m * sn * sn), size_b * sn, size_d * cn]
