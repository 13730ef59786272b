"""Tracks of sampled states for export, and splines through their attitudes."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import batches
from rigidsym.errors import InputError

if TYPE_CHECKING:
    from scipy.spatial.transform import RotationSpline

    from rigidsym.motion import TorqueFreeMotion


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """Attitudes and body rates at a list of increasing times.

    There is at least one state.

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
        times = np.array(batches.array("times", self.times))
        if times.ndim != 1 or not times.size:
            rule = "must be a list of at least one time"
            raise InputError("times", f"an array of shape {times.shape}", rule)
        for k in np.flatnonzero(np.diff(times) <= 0)[:1] + 1:
            raise InputError(f"times[{k}]", times[k], "must be later than the time before it")
        object.__setattr__(self, "times", times)
        object.__setattr__(self, "q", _unit(self._rows("q", 4)))
        object.__setattr__(self, "omega", self._rows("omega", 3))

    def _rows(self, name: str, width: int) -> np.ndarray:
        """Check the shape of an array of the track, and return a copy.

        The shape must be (N, width).  Raises InputError for another shape.
        """
        array = np.array(batches.array(name, getattr(self, name)))
        if array.shape != (self.times.size, width):
            rule = f"must have the shape ({self.times.size}, {width}), a row for each time"
            raise InputError(name, f"an array of shape {array.shape}", rule)
        return array


def sampled(motion: "TorqueFreeMotion", times: ArrayLike) -> Track:
    """Evaluate a motion at times, and return the states as a track.

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
    given = np.atleast_1d(batches.array("times", times))
    return Track(given, *motion(given))


def _unit(q: np.ndarray) -> np.ndarray:
    """Normalise quaternions without overflow.

    Raises InputError for a zero quaternion.
    """
    most = np.max(np.abs(q), axis=1, keepdims=True)
    for k in np.flatnonzero(most == 0)[:1]:
        raise InputError(f"q[{k}]", q[k].tolist(), "must not be zero")
    scaled = np.ldexp(q, -np.frexp(most)[1])
    return scaled / np.linalg.norm(scaled, axis=1, keepdims=True)


def rotation_spline(track: Track) -> "RotationSpline":
    """Interpolate the attitudes of a track by a SciPy RotationSpline.

    The rotations are from body to inertial axes.  The spline is cubic between the times, with
    continuous rates and angular accelerations.  Where the times are h apart, the angle between it
    and the motion decreases as h^4, but at both ends as h^2, because SciPy takes the mean rates of
    the first and of the last interval for the rates at the ends.  This error decreases by a factor
    of about 4 with each interval, so sample some intervals further than needed.

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
    speed = np.linalg.norm(track.omega, axis=1)
    angles = np.maximum(speed[1:], speed[:-1]) * np.diff(track.times)
    for k in np.flatnonzero(angles >= np.pi)[:1] + 1:
        # SciPy takes the shorter way.
        raise InputError(f"times[{k}]", track.times[k], "must be less than half a turn later")
    return RotationSpline(track.times, Rotation.from_quat(np.roll(track.q, -1, axis=1)))
