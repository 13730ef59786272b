"""The attitude to follow at each time, and the torque that brings the spacecraft there."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.manoeuvre.flight.rotation import cross, matrix, relative
from rigidsym.manoeuvre.flight.settings import Controller
from rigidsym.manoeuvre.manoeuvre import Manoeuvre
from rigidsym.motion import TorqueFreeMotion


class Motion(Protocol):
    """Attitude and body rates at a time (4,), (3,), or at N of them, (N, 4), (N, 3)."""

    def __call__(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """At t, s."""
        ...


class Track(Protocol):
    """What can be followed to the target."""

    @property
    def duration(self) -> float:
        """From the start to the target, s."""
        ...

    @property
    def motion(self) -> Motion:
        """Where to be, and how fast to turn, until then."""
        ...


@dataclass(frozen=True, slots=True)
class Reference:
    """Attitudes q (N, 4) and body rates omega (N, 3) along the times of a flight."""

    q: np.ndarray
    omega: np.ndarray


def along(track: Track, t: np.ndarray) -> Reference:
    """The track at times (N,), on beyond the end of the manoeuvre."""
    return Reference(*track.motion(t))


def reference(manoeuvre: Manoeuvre, track: Track, t: np.ndarray) -> Reference:
    """The track until the target is reached; then the target.

    A target that spins goes on as a free body does.  The attitudes are continuous in the double
    cover: of the two quaternions of the target it is the one at which the track arrives.
    """
    arrived = track.motion(track.duration)[0]
    target = np.array([float(x) for x in manoeuvre.target])
    held = target if arrived @ target >= 0 else -target
    after = TorqueFreeMotion(manoeuvre.inertia, manoeuvre.target_spin, held.tolist())
    late = t >= track.duration
    ahead, then = track.motion(t[~late]), after(t[late] - track.duration)
    return Reference(*(np.concatenate(pair) for pair in zip(ahead, then, strict=True)))


def command(
    controller: Controller,
    inertia: np.ndarray,
    state: tuple[np.ndarray, np.ndarray, np.ndarray],
    wanted: tuple[np.ndarray, np.ndarray],
) -> np.ndarray:
    """The torque (3,), N m, for q, omega and the wheels' momentum, where q and omega are wanted.

    -2 Kp sign(d0) d - Kd (omega - omega wanted) with d the error's quaternion: the way back is
    the shorter one.  With `feedforward`, omega x h of the wheels' momentum h on top: the body
    then feels them as if they were not there, and needs no torque on a natural motion.
    """
    q, omega, momentum = state
    error = relative(wanted[0], q)
    slip = omega - wanted[1] @ matrix(error)
    towards = np.copysign(2.0, error[0]) * error[1:]
    frequency, damping = controller.natural_frequency, controller.damping_ratio
    torque = -inertia * (frequency**2 * towards + 2 * damping * frequency * slip)
    return torque + cross(omega, momentum) if controller.feedforward else torque
