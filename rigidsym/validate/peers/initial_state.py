"""Where a motion starts, in float64, and times on both sides of it."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from rigidsym.engines import EngineError, States

Floats = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Start:
    """Moments (3), rates (3) and a unit quaternion (4) at t = 0; raises EngineError for no such."""

    inertia: Floats
    omega0: Floats
    attitude0: Floats

    def __post_init__(self) -> None:
        for field, size in (("inertia", 3), ("omega0", 3), ("attitude0", 4)):
            values = _numbers(field, getattr(self, field))
            if values.shape != (size,):
                raise EngineError(field, f"shape {values.shape}: one body's must be ({size},)")
            object.__setattr__(self, field, tuple(values.tolist()))
        if min(self.inertia) <= 0:
            raise EngineError("inertia", "principal moments must be positive")
        object.__setattr__(self, "attitude0", _unit(self.attitude0))

    @property
    def state(self) -> Floats:
        """Attitude, then rates."""
        return (*self.attitude0, *self.omega0)


def both_ways(start: Start, t: Any, follow: Callable[[np.ndarray], np.ndarray]) -> States:
    """States at times in any order, by what goes only one way from t = 0.

    follow: rows (n, 7) at n times that leave zero, each farther than the one before; fewer rows
    where it gets no farther, or an error of arithmetic, value or run time.
    """
    t = checked(t)
    rows = np.tile(start.state, (t.size, 1))
    for sign in (1, -1):
        side = sign * t > 0
        times, places = np.unique(sign * t[side], return_inverse=True)
        if times.size:
            try:
                found = follow(sign * times)
            except (ArithmeticError, ValueError, RuntimeError):
                found = np.empty((0, 7))
            rows[side] = _padded(found, times.size)[places]
    return rows[:, :4], rows[:, 4:]


def checked(t: Any) -> np.ndarray:
    """Times (N,); raises EngineError unless they are finite."""
    times = _numbers("t", t)
    if times.ndim != 1:
        raise EngineError("t", f"shape {times.shape}: must be (N,)")
    return times


def _padded(rows: np.ndarray, size: int) -> np.ndarray:
    """Rows that are numbers throughout, and NaN from the first that is not, or is missing."""
    good = np.logical_and.accumulate(np.all(np.isfinite(rows), axis=1))
    padded = np.full((size, 7), np.nan)
    padded[: good.sum()] = rows[good]
    return padded


def _numbers(field: str, values: Any) -> np.ndarray:
    try:
        array = np.asarray(values, float)
    except (TypeError, ValueError, OverflowError):
        raise EngineError(field, "must be numbers") from None
    if not np.all(np.isfinite(array)):
        raise EngineError(field, "every number must be finite")
    return array


def _unit(quaternion: Floats) -> Floats:
    """Over its length, scaled by a power of two first, so that no square leaves the range."""
    largest = max(map(abs, quaternion))
    if largest == 0:
        raise EngineError("attitude0", "must not be zero")
    exponent = math.frexp(largest)[1]
    scaled = [math.ldexp(x, -exponent) for x in quaternion]
    length = math.hypot(*scaled)
    return tuple(x / length for x in scaled)
