"""Conversion of exact inputs to unevaluated sums of two doubles.

Rounding inertia and rates to doubles would put the motion on another polhode, which is a different
motion near the separatrix or where moments nearly agree.  So each number becomes two doubles, right
to 32 digits.  The differences of moments and the discriminant, which lose digits by subtraction,
are computed from the exact numbers.
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from rigidsym import _inputs as inputs
from rigidsym._engines.arrays import Sensitivities
from rigidsym.errors import InputError
from rigidsym.generated import torque_free
from rigidsym.solution._polhode import discriminant

DoubleDouble = tuple[float, float]

# Moments closer than this fraction of the smallest count as equal: products of two differences
# would leave binary64, and so would the rates that could tell the circulations apart.  The error of
# the motion is the difference times the square of the angle turned, less than 2^-150 in all.
INDISTINCT = Fraction(1, 2**250)


class ExactInputs(NamedTuple):
    """Inputs of a motion as sums of two doubles, for a numeric module.

    They are the arguments of its function `prepare_from_double_doubles`.
    """

    inertia: list[DoubleDouble]
    differences: list[DoubleDouble]
    omega0: list[DoubleDouble]
    attitude0: list[DoubleDouble]
    discriminant: DoubleDouble
    unit: float


def exact_inputs(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], attitude0: Sequence[Fraction]
) -> ExactInputs:
    """Scale exact inputs by powers of two, and round each to a sum of two doubles.

    Raises InputError for numbers out of range.
    """
    moments = _merged(_over_power_of_two(inertia)[0])
    rates, exponent = _over_power_of_two(omega0)
    quaternion, _ = _over_power_of_two(attitude0)
    if min(moments) < torque_free.MIN_MOMENT_RATIO:
        rule = "principal moments differ by more than binary64 can follow"
        raise InputError("inertia", inputs.shown(inertia), rule)
    if not -1074 <= exponent <= 1020:
        raise InputError("omega0", inputs.shown(omega0), "is beyond the range of binary64")
    differences = [moments[k] - moments[(k + 1) % 3] for k in range(3)]
    given = moments, differences, rates, quaternion
    decides = pair(discriminant(moments, rates))
    return ExactInputs(*([pair(x) for x in xs] for xs in given), decides, 2.0**exponent)


def by_exact_moments(found: Sensitivities, inertia: Sequence[Fraction]) -> None:
    """Undo the scaling of moments of inertia in derivatives with respect to moments.

    Moments are then in kg m^2.  The arrays are changed in place.  `exact_inputs` has divided the
    moments by a power of two.
    """
    unit = 2.0 ** _over_power_of_two(inertia)[1]
    for derivatives in found[2:4]:
        derivatives[..., -3:] /= unit


def pair(value: Fraction) -> DoubleDouble:
    """Round a number to a sum of two doubles.

    These are the double nearest to the number, and the double nearest to the remainder.  The first
    is zero only if the number is zero.

    >>> pair(Fraction(1, 10))
    (0.1, -5.551115123125783e-18)
    """
    high = float(value)
    if value and not high:
        return (math.ulp(0.0) if value > 0 else -math.ulp(0.0)), 0.0
    return high, float(value - Fraction(high))


def _merged(moments: Sequence[Fraction]) -> Sequence[Fraction]:
    """Make moments of inertia equal where their relative difference is below INDISTINCT.

    The difference is relative to the smallest moment.
    """
    merged, least = list(moments), min(moments) * INDISTINCT
    order = sorted(range(3), key=lambda k: moments[k])
    for low, high in pairwise(order):
        if merged[high] - merged[low] < least:
            merged[high] = merged[low]
    return merged


def _over_power_of_two(values: Sequence[Fraction]) -> tuple[tuple[Fraction, ...], int]:
    """Scale numbers by a power of two so that the largest absolute value is in [1, 2).

    Returns the scaled numbers and the exponent of the divisor.
    """
    largest = max(map(abs, values))
    exponent = largest.numerator.bit_length() - largest.denominator.bit_length() if largest else 0
    if largest and largest < Fraction(2) ** exponent:
        exponent -= 1
    return tuple(value / Fraction(2) ** exponent for value in values), exponent
