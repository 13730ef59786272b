"""How long to look at a motion: periods of the rates, and turns where they have none."""

import math

import numpy as np

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.inputs import Times
from rigidsym.precise import PreciseMotion
from rigidsym.precise.quantities import Quantities
from rigidsym.solution.polhode import Regime
from rigidsym.view.protocols import Motion

DIGITS = 15
# On the separatrix this many times 1/lambda on both sides are all that can be seen of it.
FAR = 8.0
MOST_TURNS = 24
# Fewer samples a turn than these do not look like turning.
A_TURN = 12
AT_REST = 10.0


def period(motion: Motion) -> float:
    """The time after which the rates come back; infinite on the separatrix, s.

    Zero where the rates are constant.
    """
    return Quantities(_precise(motion)).period


def once(motion: Motion) -> tuple[float, float]:
    """From when to when the whole polhode is run through once, s."""
    found = period(motion)
    if math.isfinite(found):
        return 0.0, found
    known = _constants(motion)
    middle, far = -known["u"] / known["lambda_"], FAR / known["lambda_"]
    return middle - far, middle + far


def chosen(motion: Motion, times: Times | None, count: int) -> np.ndarray:
    """The times given as doubles, or `count` by `grid`; InputError for fewer than two, s."""
    if times is None:
        return grid(motion, count)
    found = np.array(inputs.doubles("t", inputs.times(times)[0]))
    if len(found) < 2:
        raise InputError("t", f"{len(found)} times", "a picture needs two or more")
    return found


def grid(motion: Motion, count: int) -> np.ndarray:
    """Times from zero on that show what there is to see: two periods, or a few turns, s."""
    first, last = once(motion)
    most = min(MOST_TURNS, count / A_TURN) * _turn(motion)
    if motion.regime.steady:
        end = 3 * _turn(motion)
    elif motion.regime == Regime.SEPARATRIX:
        end = min(max(last, (last - first) / 2), most)
    else:
        end = min(2 * (last - first), most)
    return np.linspace(0.0, end, count)


def _turn(motion: Motion) -> float:
    """The time of one turn at the first rate, s."""
    rate = math.hypot(*map(float, motion.exact["omega0"]))
    return 2 * math.pi / rate if rate else AT_REST / 3


def _constants(motion: Motion) -> dict[str, float]:
    found = _precise(motion).constants(("lambda_", "u"), DIGITS)
    return {name: float(value) for name, value in found.items()}


def _precise(motion: Motion) -> PreciseMotion:
    given = motion.exact
    return PreciseMotion(given["inertia"], given["omega0"], given["attitude0"])
