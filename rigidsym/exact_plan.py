"""The plan of a motion whose numbers are no doubles: decimals, fractions, mpmath numbers.

Rounding inertia and rates first would put the motion on another polhode, and near the separatrix,
or where moments nearly agree, that is another motion.  So the constants are computed from the exact
numbers and each is rounded once.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.generated import torque_free

DIGITS = 20
# Below this k' the distance to the separatrix is lost in binary64.
_FAINTEST = 1e-290


def exact_plan(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], attitude0: Sequence[Fraction]
) -> dict[str, Any]:
    """A plan for `torque_free.states`; raises InputError for what binary64 cannot hold."""
    from rigidsym.precise import PreciseMotion

    bodies, _ = _over_power_of_two("inertia", inertia)
    rates, rate = _over_power_of_two("omega0", omega0)
    quaternion, _ = _over_power_of_two("attitude0", attitude0)
    motion = PreciseMotion(bodies, rates, quaternion)
    start = motion.start(DIGITS)
    constants = None
    if not motion.polhode.regime.steady:
        names = [name for name in torque_free.RESULTS if name not in ("quarter_m_c", "complete_n")]
        constants = motion.constants(names, DIGITS)
        if 0 < constants["k_c"] < _FAINTEST:
            rule = "nearer to the separatrix than binary64 can follow"
            raise InputError("omega0", inputs.shown(omega0), rule)
    floats = list(map(float, rates))
    return torque_free.plan_from_constants(motion.polhode.axes, rate, floats, start, constants)


def _over_power_of_two(
    field: str, values: Sequence[Fraction]
) -> tuple[tuple[Fraction, ...], float]:
    """The values over a power of two near the largest, and that power as a double."""
    largest = max(map(abs, values))
    exponent = largest.numerator.bit_length() - largest.denominator.bit_length() if largest else 0
    if abs(exponent) > 1000:
        raise InputError(field, inputs.shown(values), "is beyond the range of binary64")
    return tuple(value / Fraction(2) ** exponent for value in values), 2.0**exponent
