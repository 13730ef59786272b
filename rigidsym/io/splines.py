"""Splines through the attitudes of a track, for those who need them between its times."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.errors import InputError
from rigidsym.io.tracks import Track

if TYPE_CHECKING:
    from scipy.spatial.transform import RotationSpline


def rotation_spline(track: Track) -> "RotationSpline":
    """scipy.spatial.transform.RotationSpline through the attitudes of a track, body to inertial.

    It is cubic between the times, with continuous rates and angular accelerations: spline(t),
    spline(t, 1) in rad/s along the axes of the body, spline(t, 2).  Where the times are h apart,
    the angle between it and the motion falls as h^4, but at both ends as h^2: SciPy takes the
    mean rates of the first and of the last interval for the rates at the ends.  The trouble dies
    out by a factor of about 4 with each interval, so sample some intervals further than needed.

    Raises InputError for a single state and for steps of half a turn and more, |omega| h >= pi,
    and ImportError without SciPy.
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
    """Between two attitudes SciPy goes the shorter way round."""
    speed = np.linalg.norm(track.omega, axis=1)
    angles = np.maximum(speed[1:], speed[:-1]) * np.diff(track.times)
    for k in np.flatnonzero(angles >= np.pi)[:1] + 1:
        raise InputError(f"times[{k}]", track.times[k], "must be less than half a turn later")
