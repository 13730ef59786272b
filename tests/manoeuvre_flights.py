"""Transfers for flight tests, made from known motions and not by the planner.

The target is where the known motion arrives.
"""

from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre._manoeuvre import manoeuvre
from rigidsym.manoeuvre._transfer import robustness
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._results import Tracked
from rigidsym.manoeuvre.flight._settings import Disturbances, Flight, Timing

INERTIA = ("0.0109", "0.04", "0.0506")
MOMENTS = np.array([float(x) for x in INERTIA])
OMEGA0 = (-0.016, 0.019, -0.003)
NOTHING = Disturbances(drag=False, gravity_gradient=False, radiation=False, dipole=False)
CALM = {"disturbances": NOTHING}
NO_CONTROL = {"natural_frequency": 0.0}


@dataclass(frozen=True)
class Known:
    """Known motion in place of a planned transfer."""

    duration: float
    motion: TorqueFreeMotion

    @property
    def sensitivity(self):
        return robustness(self.motion, MOMENTS * self.motion(0.0)[1], self.duration)


def known(duration=20, omega0=OMEGA0, start_spin=(0, 0, 0), target_spin=(0, 0, 0)):
    """Return a manoeuvre and the motion that solves it."""
    motion = TorqueFreeMotion(INERTIA, omega0)
    target = motion(float(duration))[0].tolist()
    spins = {"start_spin": start_spin, "target_spin": target_spin}
    asked = manoeuvre(INERTIA, (1, 0, 0, 0), target, duration, **spins)
    return asked, Known(float(duration), motion)


def short(length=40, period="0.1", **parts):
    """Return the settings of a short flight, with a dict of changes for each part."""
    timing = Timing(length=Fraction(length), period=Fraction(period), **parts.pop("run", {}))
    base = Flight(run=timing)
    changed = {
        name: change if not isinstance(change, dict) else replace(getattr(base, name), **change)
        for name, change in parts.items()
    }
    return replace(base, **changed)


def flown(length=40, period="0.1", transfer=None, **parts):
    """Fly along the known motion of a manoeuvre for a short time.

    transfer: the arguments of `known`.
    """
    asked, track = known(**(transfer or {}))
    return fly(asked, short(length, period, **parts), track)


def tracked(length=40, message=None, **parts):
    """Fly along a known motion of 10 s, and return the flight as a `Tracked` result.

    It has the manoeuvre and the settings of the flight, too.
    """
    asked, transfer = known(duration=10, omega0=(0.01, 0.02, -0.01))
    flight = replace(short(length, **parts), message=message or {})
    return Tracked(asked, flight, transfer, fly(asked, flight, transfer))
