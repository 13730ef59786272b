"""The two periods of a tumbling body, as astronomers give them."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rigidsym.solution.polhode import Mode

if TYPE_CHECKING:
    from rigidsym.motion import TorqueFreeMotion


@dataclass(frozen=True, slots=True)
class Periods:
    """s; None where there is none.

    rotation: of the rates, in which a long-axis mode turns once about the long axis, and in which
    the long axis of a short-axis mode rolls to and fro.  precession: in which the circulation axis
    goes round the momentum, on average.
    """

    rotation: float | None
    precession: float | None


def periods(motion: "TorqueFreeMotion") -> Periods:
    """Of a motion; constant rates have one period, that of the turn, given as the precession.

    A body turns about its momentum by psi and about its circulation axis by phi: in one period of
    the rates they differ by a whole turn, one way for each mode.
    """
    rotation, mean = motion.period, motion.precession_rate
    if mean is None or mean == 0:
        return Periods(None, None)
    if rotation is None or not math.isfinite(rotation) or motion.mode is None:
        return Periods(None, 2 * math.pi / abs(mean))
    turn = 2 * math.pi / rotation
    rate = mean - turn if motion.mode is Mode.LONG_AXIS else mean + turn
    return Periods(rotation, 2 * math.pi / abs(rate) if rate else math.inf)
