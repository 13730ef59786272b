"""Bursts of a plan made finite: torques of one size along the axes, for as long as it takes."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre.flight.control import Track
from rigidsym.manoeuvre.flight.settings import Flight
from rigidsym.manoeuvre.manoeuvre import Manoeuvre

WHEELS = 0.8
"Of their limit that wheels exert in a burst; the rest is for what else is asked of them."


@dataclass(frozen=True)
class Burns:
    """Each axis has a burn for each burst, that lasts as long as its impulse takes.

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
        """From when to when each axis burns, (2, 3, 2), s."""
        length = np.abs(self.impulses) / self.torque
        begin = self.instants[:, None] - self.before * length
        return np.stack([begin, begin + length], axis=2)

    @property
    def begin(self) -> float:
        """When the first burn begins, s; zero where no burn comes before."""
        return min(0.0, float(self.spans.min()))

    @property
    def end(self) -> float:
        """When the last burn is over, s."""
        return float(self.spans.max())

    @property
    def overlap(self) -> bool:
        """Whether a burn of the last burst begins before all those of the first are over."""
        first, last = self.spans
        return bool(last[:, 0].min() < first[:, 1].max())

    def between(self, begin: float, end: float) -> np.ndarray:
        """The mean torque (3,) from one time to another, N m."""
        low = np.maximum(self.spans[..., 0], begin)
        shared = np.maximum(np.minimum(self.spans[..., 1], end) - low, 0.0)
        return self.torque * np.sum(np.sign(self.impulses) * shared, axis=0) / (end - begin)

    def pieces(self, begin: float, end: float) -> list[tuple[float, float]]:
        """The spans between two times in which the torque is constant."""
        inner = [x for x in np.unique(self.spans).tolist() if begin < x < end]
        ends = [begin, *inner, end]
        return [*pairwise(ends)]


def of_thrusters(flight: Flight, manoeuvre: Manoeuvre, track: Track) -> Burns | None:
    """What thrusters burn; None where there are none.

    A component that is less than half of the minimum impulse is left out, and none is less than it.
    Raises InputError where burns last too long.
    """
    thrusters = flight.thrusters
    if thrusters is None:
        return None
    wanted = bursts(manoeuvre, track)
    size, least = np.abs(wanted), thrusters.min_impulse
    fired = np.where(2 * size < least, 0.0, np.copysign(np.maximum(size, least), wanted))
    instants = np.array([0.0, track.duration])
    before = 0.5 if thrusters.centred else 0.0
    return _fitting("thrusters.torque", Burns(instants, fired, thrusters.torque, before))


def of_wheels(flight: Flight, manoeuvre: Manoeuvre, track: Track) -> Burns | None:
    """What wheels are told ahead: with `track_feedforward`, unless thrusters burn."""
    if flight.thrusters is not None or not flight.controller.track_feedforward:
        return None
    instants = np.array([0.0, track.duration])
    found = Burns(instants, bursts(manoeuvre, track), WHEELS * flight.wheels.max_torque)
    return _fitting("wheels.max_torque", found)


def bursts(manoeuvre: Manoeuvre, track: Track) -> np.ndarray:
    """The changes of momentum (2, 3) with which a track begins and ends, body axes, N m s."""
    inertia, before, after = (
        np.array([float(x) for x in values])
        for values in (manoeuvre.inertia, manoeuvre.start_spin, manoeuvre.target_spin)
    )
    _, omega = track.motion(np.array([0.0, track.duration]))
    return inertia * np.stack([omega[0] - before, after - omega[1]])


def _fitting(field: str, burns: Burns) -> Burns:
    if burns.overlap:
        took = float(np.ptp(burns.spans, axis=2).max())
        rule = f"makes burns of {took:.3g} s, too long for {burns.instants[1]:g} s"
        raise InputError(field, burns.torque, rule)
    return burns
