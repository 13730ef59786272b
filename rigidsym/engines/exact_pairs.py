"""Exact numbers as the unevaluated sums of two doubles that numeric modules take.

Rounding inertia and rates to doubles would put the motion on another polhode, and near the
separatrix, or where moments nearly agree, that is another motion.  So each number becomes two
doubles, right to 32 digits, and what decides the regime is found from the exact ones.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.solution.polhode import excess

Pair = tuple[float, float]
_FAINTEST = Fraction(1, 2**900)


class ExactPairs(NamedTuple):
    """The arguments of `plan_from_pairs`."""

    inertia: list[Pair]
    omega0: list[Pair]
    attitude0: list[Pair]
    excess: Pair
    unit: float


def exact_pairs(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], attitude0: Sequence[Fraction]
) -> ExactPairs:
    """Scale by powers of two and round to pairs; raises InputError for what is out of range."""
    moments, _ = _over_power_of_two("inertia", inertia)
    rates, unit = _over_power_of_two("omega0", omega0)
    quaternion, _ = _over_power_of_two("attitude0", attitude0)
    decides = excess(_distinguished(moments), rates)
    if 0 < abs(decides) < _FAINTEST:
        rule = "nearer to the separatrix than binary64 can follow"
        raise InputError("omega0", inputs.shown(omega0), rule)
    pairs = ([pair(value) for value in values] for values in (moments, rates, quaternion))
    return ExactPairs(*pairs, pair(decides), unit)


def pair(value: Fraction) -> Pair:
    """The nearest double and the nearest double to what is left.

    >>> pair(Fraction(1, 10))
    (0.1, -5.551115123125783e-18)
    """
    high = float(value)
    return high, float(value - Fraction(high))


def _distinguished(moments: Sequence[Fraction]) -> Sequence[Fraction]:
    """The moments; as pairs have them where no pair tells two of them apart.

    Those are equal for all that is computed from pairs, so they must be for the regime.
    """
    rounded = [sum(map(Fraction, pair(moment)), Fraction(0)) for moment in moments]
    return rounded if len(set(rounded)) < len(set(moments)) else moments


def _over_power_of_two(
    field: str, values: Sequence[Fraction]
) -> tuple[tuple[Fraction, ...], float]:
    """The values over a power of two near the largest, and that power as a double."""
    largest = max(map(abs, values))
    exponent = largest.numerator.bit_length() - largest.denominator.bit_length() if largest else 0
    if abs(exponent) > 1000:
        raise InputError(field, inputs.shown(values), "is beyond the range of binary64")
    return tuple(value / Fraction(2) ** exponent for value in values), 2.0**exponent
