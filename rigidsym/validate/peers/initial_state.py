"""Where a motion starts, in float64, and times on both sides of it."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import EngineError, States

Floats = tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Start:
    """Moments (3), rates (3) and a unit quaternion (4) at t = 0."""

    inertia: Floats
    omega0: Floats
    attitude0: Floats

    @classmethod
    def of(cls, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> "Start":
        """That of numbers as a peer gets them; raises EngineError where no motion starts so."""
        moments, rates = _vector("inertia", inertia, 3), _vector("omega0", omega0, 3)
        quaternion = _vector("attitude0", attitude0, 4)
        if min(moments) <= 0:
            raise EngineError("inertia", "principal moments must be positive")
        return cls(moments, rates, _unit(quaternion))

    @property
    def state(self) -> Floats:
        """Attitude, then rates."""
        return (*self.attitude0, *self.omega0)


def both_ways(start: Start, t: ArrayLike, follow: Callable[[np.ndarray], np.ndarray]) -> States:
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


def checked(t: ArrayLike) -> np.ndarray:
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


def _vector(field: str, values: ArrayLike, size: int) -> Floats:
    array = _numbers(field, values)
    if array.shape != (size,):
        raise EngineError(field, f"shape {array.shape}: one body's must be ({size},)")
    return tuple(array.tolist())


def _numbers(field: str, values: ArrayLike) -> np.ndarray:
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
