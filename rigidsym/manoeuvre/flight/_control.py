"""Reference attitudes of a flight, and the torque commands of feedback and feedforward."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._rotation import cross, matrix, relative
from rigidsym.manoeuvre.flight._settings import Controller
from rigidsym.motion import TorqueFreeMotion

# Attitude and body rates at a time (4,), (3,), or at N of them, (N, 4), (N, 3).
Motion = Callable[[ArrayLike], tuple[np.ndarray, np.ndarray]]


@dataclass(frozen=True, slots=True)
class Track:
    """A motion to follow from the start to the target, with its duration in s."""

    duration: float
    motion: Motion


@dataclass(frozen=True, slots=True)
class Reference:
    """Attitudes and body rates at the sampling times of a flight.

    q has the shape (N, 4), omega (N, 3).
    """

    q: np.ndarray
    omega: np.ndarray


@dataclass(frozen=True, slots=True)
class Wanted:
    """The wanted attitude and rates at one sample, and the torque of the track.

    The torque is that at the next sample, when the wheels exert it.
    """

    q: np.ndarray
    omega: np.ndarray
    torque: np.ndarray


def reference(manoeuvre: Manoeuvre, track: Transfer | Track, t: np.ndarray) -> Reference:
    """Return the reference of a flight: the start, then the track, then the target.

    The track begins at t = 0 and ends after its duration.

    A start and a target that spin do so as free bodies.  The attitudes are continuous in the double
    cover: of the two quaternions of the target it is the one at which the track arrives.
    """
    arrived = track.motion(track.duration)[0]
    target = np.array([float(x) for x in manoeuvre.target])
    held = target if arrived @ target >= 0 else -target
    before = TorqueFreeMotion(manoeuvre.inertia, manoeuvre.start_spin, manoeuvre.start)
    after = TorqueFreeMotion(manoeuvre.inertia, manoeuvre.target_spin, held.tolist())
    early, late = t < 0, t >= track.duration
    parts = before(t[early]), track.motion(t[~early & ~late]), after(t[late] - track.duration)
    return Reference(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def torques(inertia: np.ndarray, track: Transfer | Track, t: np.ndarray) -> np.ndarray:
    """Return the torques that a track needs at evenly spaced times.

    They are I omega' + omega x I omega, (N, 3), in N m.

    It vanishes on a natural motion.  Values are means about each time, so that lines between them
    have the track's impulse, without its bursts.
    """
    half = (t[1] - t[0]) / 2
    low, now, high = (np.clip(x, 0.0, track.duration) for x in (t - half, t, t + half))
    (_, begin), (_, omega), (_, end) = (track.motion(x) for x in (low, now, high))
    share = ((high - low) / (2 * half))[:, None]
    return inertia * (end - begin) / (2 * half) + share * np.cross(omega, inertia * omega)


def feedback(
    controller: Controller, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, wanted: Wanted
) -> np.ndarray:
    """Return the torque of quaternion feedback, in N m.

    It is -2 Kp sign(d0) d - Kd (omega - omega wanted), d being the error's quaternion.

    The way back is the shorter one.
    """
    error = relative(wanted.q, q)
    slip = omega - wanted.omega @ matrix(error)
    towards = np.copysign(2.0, error[0]) * error[1:]
    frequency, damping = controller.natural_frequency, controller.damping_ratio
    return -inertia * (frequency**2 * towards + 2 * damping * frequency * slip)


def feedforward(
    controller: Controller, q: np.ndarray, omega: np.ndarray, momentum: np.ndarray, wanted: Wanted
) -> np.ndarray:
    """Return the feedforward torque, in N m, which does not depend on errors.

    With `feedforward`, omega x h of the wheels' momentum h: the body then moves as if it had no
    wheels, and needs no torque on a natural motion.  With `track_feedforward`, the torque of the
    track.
    """
    torque = cross(omega, momentum) if controller.feedforward else np.zeros(3)
    if controller.track_feedforward:
        torque = torque + wanted.torque @ matrix(relative(wanted.q, q))
    return torque
