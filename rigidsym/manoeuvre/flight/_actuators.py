"""Actuators: burns of finite length for the bursts of a plan, and reaction wheels with limits.

A burn is a torque of one size along an axis, for as long as its impulse takes.
"""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._control import Track
from rigidsym.manoeuvre.flight._settings import Flight, Wheels

WHEELS = 0.8
"Share of their limit that wheels exert in a burst; the rest is for feedback and disturbances."


@dataclass(frozen=True)
class Burns:
    """Burns of finite length that replace the two bursts of a plan.

    There is one for each burst and axis.

    instants (2,): of the bursts, s.  impulses (2, 3): in body axes, N m s.  torque: of an axis
    while it burns, N m.  before: the share of a burn that lies before its instant; a half, where
    burns are centred on their instants.
    """

    instants: np.ndarray
    impulses: np.ndarray
    torque: float
    before: float = 0.5

    @cached_property
    def spans(self) -> np.ndarray:
        """Start and end times (2, 3, 2) of all burns, in s."""
        length = np.abs(self.impulses) / self.torque
        begin = self.instants[:, None] - self.before * length
        return np.stack([begin, begin + length], axis=2)

    @property
    def begin(self) -> float:
        """Start time of the first burn, in s, or zero if that is earlier."""
        return min(0.0, float(self.spans.min()))

    @property
    def end(self) -> float:
        """End time of the last burn, in s."""
        return float(self.spans.max())

    @property
    def overlap(self) -> bool:
        """True if burns of the two bursts overlap in time.

        This is so where any burn of the last begins before all those of the first have ended.
        """
        first, last = self.spans
        return bool(last[:, 0].min() < first[:, 1].max())

    def between(self, begin: float, end: float) -> np.ndarray:
        """Return the mean torque (3,) of the burns between two times, in N m."""
        low = np.maximum(self.spans[..., 0], begin)
        shared = np.maximum(np.minimum(self.spans[..., 1], end) - low, 0.0)
        return self.torque * np.sum(np.sign(self.impulses) * shared, axis=0) / (end - begin)

    def pieces(self, begin: float, end: float) -> list[tuple[float, float]]:
        """Split a time span into pieces during which the torque is constant."""
        inner = [x for x in np.unique(self.spans).tolist() if begin < x < end]
        return [*pairwise([begin, *inner, end])]


def planned(flight: Flight, manoeuvre: Manoeuvre, track: Transfer | Track) -> Burns | None:
    """Return the burns of thrusters or wheels that realise the bursts of a track.

    Return None where bursts are not commanded.

    Thrusters leave out a component below half of the minimum impulse; others are at least that
    impulse.  Raises InputError where burns last too long.
    """
    instants, wanted = np.array([0.0, track.duration]), bursts(manoeuvre, track)
    if thrusters := flight.thrusters:
        size, least = np.abs(wanted), thrusters.min_impulse
        fired = np.where(2 * size < least, 0.0, np.copysign(np.maximum(size, least), wanted))
        before = 0.5 if thrusters.centred else 0.0
        field, burns = "thrusters.torque", Burns(instants, fired, thrusters.torque, before)
    elif flight.controller.track_feedforward:
        field, burns = (
            "wheels.max_torque",
            Burns(instants, wanted, WHEELS * flight.wheels.max_torque),
        )
    else:
        return None
    if burns.overlap:
        took = float(np.ptp(burns.spans, axis=2).max())
        rule = f"makes burns of {took:.3g} s, too long for {burns.instants[1]:g} s"
        raise InputError(field, burns.torque, rule)
    return burns


def bursts(manoeuvre: Manoeuvre, track: Transfer | Track) -> np.ndarray:
    """Return the changes of momentum (2, 3) that a track needs at its start and end.

    They are in body axes, in N m s.
    """
    inertia, before, after = (
        np.array([float(x) for x in values])
        for values in (manoeuvre.inertia, manoeuvre.start_spin, manoeuvre.target_spin)
    )
    _, omega = track.motion(np.array([0.0, track.duration]))
    return inertia * np.stack([omega[0] - before, after - omega[1]])


def next_torque(
    wheels: Wheels, torque: np.ndarray, momentum: np.ndarray, command: np.ndarray, period: float
) -> np.ndarray:
    """Return the torque that wheels reach at the end of a control period under a command.

    Torques (3,) are in N m, the period is in s.

    It goes there along a straight line from `torque`, so that neither the torque nor its rate
    ever is beyond its limit.  `momentum` (3,) is that of the wheels at the beginning, N m s.
    """
    change = wheels.max_torque_rate * period
    if (most := wheels.max_momentum) is not None:
        below, above = (
            _gain(change, period, most - side * momentum + side * torque * period / 2)
            for side in (1.0, -1.0)
        )
        command = np.clip(command, -below, above)
    limited = np.clip(command, -wheels.max_torque, wheels.max_torque)
    return np.clip(limited, torque - change, torque + change)


def _gain(change: float, period: float, room: np.ndarray) -> np.ndarray:
    """Return the largest rates g at which wheels may gain momentum at the end of a period.

    `room` is the momentum that they can still store.

    Wheels that gain no faster can stop gaining before they are full.  In that period g adds
    period g / 2.  Then it goes down by `change` in each period, and to zero in the last: k periods
    and one add the trapezoids of g, g - change, .., g - k change, 0.  All of it, as a function of
    g, has straight pieces between the multiples k change, where it is change period k (k + 1) / 2.
    """
    left = np.maximum(room, 0.0)
    unit = change * period
    k = np.floor((np.sqrt(1 + 8 * left / unit) - 1) / 2)
    return k * change + (left - unit * k * (k + 1) / 2) / (period * (k + 1))
