"""Transfers to fly that need no planner: the target is where a known motion arrives."""

from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from rigidsym import TorqueFreeMotion
from rigidsym.manoeuvre._manoeuvre import manoeuvre
from rigidsym.manoeuvre._transfer import robustness
from rigidsym.manoeuvre.flight import fly
from rigidsym.manoeuvre.flight._settings import Disturbances, Flight, Timing

INERTIA = ("0.0109", "0.04", "0.0506")
OMEGA0 = (-0.016, 0.019, -0.003)
NOTHING = Disturbances(drag=False, gravity_gradient=False, radiation=False, dipole=False)


@dataclass(frozen=True)
class Known:
    duration: float
    motion: TorqueFreeMotion

    @property
    def sensitivity(self):
        burst = [float(c) * w for c, w in zip(INERTIA, self.motion(0.0)[1], strict=True)]
        return robustness(self.motion, np.array(burst), self.duration)


def known(duration=20, omega0=OMEGA0, start_spin=(0, 0, 0), target_spin=(0, 0, 0)):
    """A manoeuvre and the transfer that solves it."""
    motion = TorqueFreeMotion(INERTIA, omega0)
    target = motion(float(duration))[0].tolist()
    spins = {"start_spin": start_spin, "target_spin": target_spin}
    asked = manoeuvre(INERTIA, (1, 0, 0, 0), target, duration, **spins)
    return asked, Known(float(duration), motion)


def flight(**parts):
    """The paper's flight with other settings: a dict of changes for each part."""
    base = Flight()
    changed = {
        name: change if not isinstance(change, dict) else replace(getattr(base, name), **change)
        for name, change in parts.items()
    }
    return replace(base, **changed)


def short(length=40, period="0.1", **parts):
    """A short flight."""
    timing = Timing(length=Fraction(length), period=Fraction(period), **parts.pop("run", {}))
    return flight(run=timing, **parts)


def flown(length=40, period="0.1", transfer=None, **parts):
    """A short flight along the motion of `known(**transfer)`."""
    asked, track = known(**(transfer or {}))
    return fly(asked, short(length, period, **parts), track)
