"""Tracks: attitudes and rates at increasing times, for export; splines through them."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.errors import InputError

if TYPE_CHECKING:
    from scipy.spatial.transform import RotationSpline

    from rigidsym.motion import TorqueFreeMotion


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """Attitudes and rates at increasing times; at least one state.

    Parameters
    ----------
    times : (N,)
        Times, s, increasing.
    q : (N, 4)
        Quaternions, scalar first, body to inertial; they are normalised here and keep their signs.
    omega : (N, 3)
        Rates along the axes of the body, rad/s.

    Raises
    ------
    InputError
        For other shapes, numbers that are not finite, times that do not increase, and a quaternion
        that is zero.
    """

    times: np.ndarray
    q: np.ndarray
    omega: np.ndarray

    def __post_init__(self) -> None:
        times = _array("times", self.times)
        if times.ndim != 1 or not times.size:
            raise InputError("times", _shape(times), "must be a list of at least one time")
        for k in np.flatnonzero(np.diff(times) <= 0)[:1] + 1:
            raise InputError(f"times[{k}]", times[k], "must be later than the time before it")
        object.__setattr__(self, "times", times)
        object.__setattr__(self, "q", _unit(_rows("q", self.q, times.size, 4)))
        object.__setattr__(self, "omega", _rows("omega", self.omega, times.size, 3))


def sampled(motion: "TorqueFreeMotion", times: ArrayLike) -> Track:
    """Return the track of a motion.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion.
    times : (N,)
        Times, s, increasing.

    Returns
    -------
    Track
        The states at the times.

    Raises
    ------
    InputError
        As the motion and `Track` do.
    """
    given = np.atleast_1d(_array("times", times))
    return Track(given, *motion(given))


def _array(field: str, value: ArrayLike) -> np.ndarray:
    """Return a copy of finite doubles."""
    try:
        array = np.array(value)
        if value is None or array.dtype.kind in "bmMcSU":
            raise TypeError(array.dtype)
        array = array.astype(float)
    except (TypeError, ValueError, OverflowError):
        raise InputError(field, repr(value), "must be an array of numbers") from None
    for place in np.argwhere(~np.isfinite(array))[:1]:
        index = f"[{', '.join(map(str, place))}]" if place.size else ""
        raise InputError(f"{field}{index}", array[tuple(place)], "must be finite")
    return array


def _rows(field: str, value: ArrayLike, count: int, width: int) -> np.ndarray:
    array = _array(field, value)
    if array.shape != (count, width):
        rule = f"must have the shape ({count}, {width}), a row for each time"
        raise InputError(field, _shape(array), rule)
    return array


def _unit(q: np.ndarray) -> np.ndarray:
    """Return unit quaternions, scaled first by powers of two so that no square overflows."""
    most = np.max(np.abs(q), axis=1, keepdims=True)
    for k in np.flatnonzero(most == 0)[:1]:
        raise InputError(f"q[{k}]", q[k].tolist(), "must not be zero")
    scaled = np.ldexp(q, -np.frexp(most)[1])
    return scaled / np.linalg.norm(scaled, axis=1, keepdims=True)


def _shape(array: np.ndarray) -> str:
    return f"an array of shape {array.shape}"


def rotation_spline(track: Track) -> "RotationSpline":
    """Return a SciPy RotationSpline through the attitudes of a track, body to inertial.

    It is cubic between the times, with continuous rates and angular accelerations.  Where the times
    are h apart, the angle between it and the motion decreases as h^4, but at both ends as h^2,
    because SciPy takes the mean rates of the first and of the last interval for the rates at the
    ends.  This error decreases by a factor of about 4 with each interval, so sample some intervals
    further than needed.

    Parameters
    ----------
    track : Track
        At least two states, less than half a turn apart, |omega| h < pi.

    Returns
    -------
    scipy.spatial.transform.RotationSpline
        spline(t), spline(t, 1) in rad/s along the axes of the body, spline(t, 2).

    Raises
    ------
    InputError
        For a single state and for larger steps.
    ImportError
        Without SciPy.
    """
    try:
        from scipy.spatial.transform import Rotation, RotationSpline
    except ImportError:
        raise ImportError("rotation_spline needs SciPy: pip install 'rigidsym[app]'") from None
    if track.times.size < 2:
        raise InputError("times", track.times.tolist(), "a spline needs at least two times")
    _check_steps(track)
    return RotationSpline(track.times, Rotation.from_quat(np.roll(track.q, -1, axis=1)))


def _check_steps(track: Track) -> None:
    """Raise InputError where a step is half a turn or more, since SciPy takes the shorter way."""
    speed = np.linalg.norm(track.omega, axis=1)
    angles = np.maximum(speed[1:], speed[:-1]) * np.diff(track.times)
    for k in np.flatnonzero(angles >= np.pi)[:1] + 1:
        raise InputError(f"times[{k}]", track.times[k], "must be less than half a turn later")
