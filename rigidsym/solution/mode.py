"""Which axis of the body keeps to the momentum: the long one or the short one."""

from collections.abc import Sequence
from enum import StrEnum
from fractions import Fraction

from rigidsym.solution.polhode import Polhode, Regime


class Mode(StrEnum):
    """The axis that the momentum goes round, as astronomers name it by the shape of the body.

    The long axis is that of the smallest moment, the short axis that of the largest.  Source:
    Samarasinha and A'Hearn, Icarus 93 (1991), 194-225.
    """

    SHORT_AXIS = "short-axis mode"
    LONG_AXIS = "long-axis mode"


def mode(polhode: Polhode, inertia: Sequence[Fraction], omega: Sequence[Fraction]) -> Mode | None:
    """The mode of a motion, spins about one of these axes included, decided exactly.

    None on the separatrix, for spin about the middle axis, for spheres, and at rest.
    """
    moments = sorted(inertia)
    if polhode.regime == Regime.SPIN:
        turned = next(c for c, rate in zip(inertia, omega, strict=True) if rate)
        return {moments[2]: Mode.SHORT_AXIS, moments[0]: Mode.LONG_AXIS}.get(turned)
    if polhode.regime in (Regime.SEPARATRIX, Regime.SPHERICAL, Regime.REST):
        return None
    return Mode.SHORT_AXIS if polhode.rho > 0 else Mode.LONG_AXIS
