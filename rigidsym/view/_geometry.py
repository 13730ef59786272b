"""Geometry of motions for pictures: polhodes, great circles, separatrices and times.

Curves have the shape (N, 3).
"""

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym._inputs import Times
from rigidsym.errors import InputError
from rigidsym.precise import PreciseMotion
from rigidsym.solution._polhode import Regime
from rigidsym.view._style import BLUE, GOLD, GREEN, MAGENTA, OPEN, ORANGE

if TYPE_CHECKING:
    from rigidsym.motion import TorqueFreeMotion

REGIMES = {
    Regime.LARGEST: BLUE,
    Regime.SMALLEST: ORANGE,
    Regime.SEPARATRIX: MAGENTA,
    Regime.SYMMETRIC: GREEN,
    Regime.SPIN: GOLD,
    Regime.SPHERICAL: GOLD,
    Regime.REST: OPEN,
}
"The colour of each regime."
SEPARATRIX = REGIMES[Regime.SEPARATRIX]

CONSTANT_DIGITS, DRAWN_DIGITS = 15, 11
CIRCLE = 97
"Points of a circle."
DENSE = 12
"Times at which a polhode is computed, for each point of it that is drawn."
FAR = 8.0
"Time drawn on both sides of the middle of a separatrix motion, in units of 1/lambda."
MOST_TURNS = 24
SAMPLES_A_TURN = 12
"Fewer samples a turn do not look like turning."
AT_REST = 10.0
"Time drawn of a body at rest, s."


def once(motion: "TorqueFreeMotion") -> tuple[float, float]:
    """Return a time span, in s, during which the body rates trace the polhode once."""
    period = motion.period or 0.0
    if math.isfinite(period):
        return 0.0, period
    given = motion.exact
    precise = PreciseMotion(given["inertia"], given["omega0"], given["attitude0"])
    constants = precise.constants(("lambda_", "u"), CONSTANT_DIGITS)
    rate = float(constants["lambda_"])
    middle, far = -float(constants["u"]) / rate, FAR / rate
    return middle - far, middle + far


def chosen(motion: "TorqueFreeMotion", times: Times | None, count: int) -> np.ndarray:
    """Return the user's times for a picture, or default times, in s.

    Default times begin at zero and cover two periods or a few turns at the initial rate.  Raises
    InputError for fewer than two times.
    """
    if times is not None:
        found = np.array(inputs.doubles("t", inputs.times(times)[0]))
        if len(found) < 2:
            raise InputError("t", f"{len(found)} times", "a picture needs two or more")
        return found
    rate = math.hypot(*map(float, motion.exact["omega0"]))
    turn = 2 * math.pi / rate if rate else AT_REST / 3
    most = min(MOST_TURNS, count / SAMPLES_A_TURN) * turn
    first, last = once(motion)
    if motion.regime.steady:
        end = 3 * turn
    elif motion.regime == Regime.SEPARATRIX:
        end = min(max(last, (last - first) / 2), most)
    else:
        end = min(2 * (last - first), most)
    return np.linspace(0.0, end, count)


def moments(motion: "TorqueFreeMotion") -> np.ndarray:
    """Return the principal moments of a motion's body as floats, in kg m^2."""
    return np.array([float(x) for x in motion.exact["inertia"]])


def momentum(motion: "TorqueFreeMotion") -> np.ndarray:
    """Return the angular momentum at t = 0 in body axes, in kg m^2/s."""
    return moments(motion) * [float(x) for x in motion.exact["omega0"]]


def polhode(motion: "TorqueFreeMotion", count: int) -> np.ndarray:
    """Return points along the whole polhode, as body rates in rad/s.

    Their shape is (count, 3).  There is one row where the rates are constant.
    """
    if motion.regime.steady:
        return motion([0.0])[1]
    rates = motion(np.linspace(*once(motion), DENSE * count + 1))[1]
    # Near the separatrix almost all times are spent at two points: steps are equal in length.
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(rates, axis=0), axis=1))])
    return rates[np.searchsorted(along, np.linspace(0, along[-1], count))]


def upright(vector: np.ndarray) -> np.ndarray:
    """Return the quaternion of the shortest rotation that takes a vector to the third axis."""
    x, y, z = vector / np.linalg.norm(vector)
    if z < -1 + 1e-12:
        return np.array([0.0, 1.0, 0.0, 0.0])
    found = np.array([1 + z, y, -x, 0.0])
    return found / np.linalg.norm(found)


def great_circles(size: float) -> list[np.ndarray]:
    """Return three great circles of a sphere, one about each axis."""
    angle = np.linspace(0, 2 * math.pi, CIRCLE)
    flat = size * np.stack([0 * angle, np.cos(angle), np.sin(angle)], axis=1)
    return [np.roll(flat, k, axis=1) for k in range(3)]


def separatrix(inertia: Iterable[Fraction], size: float) -> list[np.ndarray]:
    """Return the circles of the separatrix on the momentum sphere.

    The sphere is |M| = K, and the circles go through the middle axis b.  There K^2 = 2H c_b, that
    is, M_a^2 (c_a - c_b)/c_a = M_d^2 (c_b - c_d)/c_d.  Symmetric bodies have one circle, of steady
    spins about transverse axes; a sphere has none.
    """
    given = list(inertia)
    d, b, a = sorted(range(3), key=given.__getitem__)
    across = (
        math.sqrt((given[b] - given[d]) / given[d]),
        math.sqrt((given[a] - given[b]) / given[a]),
    )
    if not any(across):
        return []
    angle = np.linspace(0, 2 * math.pi, CIRCLE)
    circles = []
    for sign in (1, -1) if all(across) else (1,):
        curve = np.zeros((CIRCLE, 3))
        curve[:, b] = np.cos(angle)
        curve[:, a] = np.sin(angle) * across[0] / math.hypot(*across)
        curve[:, d] = np.sin(angle) * sign * across[1] / math.hypot(*across)
        circles.append(size * curve)
    return circles


def members(motion: "TorqueFreeMotion", size: float, count: int) -> Iterator["TorqueFreeMotion"]:
    """Yield motions of a given motion's body with a given magnitude of angular momentum.

    There are `count` around each end of two axes.  They start between axis and separatrix, in the
    plane of the axes of largest and least inertia.
    """
    inertia = motion.exact["inertia"]
    d, _, a = sorted(range(3), key=inertia.__getitem__)
    circles = separatrix(inertia, size)
    if not circles:
        return
    quarter = circles[0][len(circles[0]) // 4]
    edge = math.atan2(abs(quarter[d]), abs(quarter[a]))
    for sign, axis, share in product((1, -1), (0.0, math.pi / 2), range(1, count + 1)):
        angle = axis + (edge - axis) * share / (count + 0.4)
        start = np.zeros(3)
        start[a], start[d] = sign * size * math.cos(angle), sign * size * math.sin(angle)
        if axis != edge:
            omega = (start / moments(motion)).tolist()
            yield motion.replace(omega0=omega)


def rounded(values: np.ndarray) -> np.ndarray:
    """Round coordinates to eleven digits, so that pictures are the same on every machine.

    Digits are those of the largest value.
    """
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if not size:
        return np.asarray(values, dtype=float)
    digits = DRAWN_DIGITS - 1 - math.floor(math.log10(size))
    return np.round(values, digits) + 0.0
