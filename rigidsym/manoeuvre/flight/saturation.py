"""How long wheels are at their limits, and what a motion would have them store."""

from typing import TypedDict

import numpy as np

from rigidsym.manoeuvre.flight.rotation import matrix
from rigidsym.manoeuvre.flight.run import Run
from rigidsym.manoeuvre.flight.settings import Wheels

# What comes as near to a limit as that is at it.
_NEAR = 1e-6


class Saturation(TypedDict):
    """By wheel: times at the limits of torque and momentum (s), and the largest momentum (N m s)
    that wheels store which follow what is wanted exactly, without disturbances."""

    torque: list[float]
    momentum: list[float]
    momentum_needed: list[float]


def saturation(run: Run, wheels: Wheels) -> Saturation:
    """Of a flight with these wheels."""
    most = np.inf if wheels.max_momentum is None else wheels.max_momentum
    return {
        "torque": _at(run, run.torque, wheels.max_torque),
        "momentum": _at(run, run.wheel_momentum, most),
        "momentum_needed": np.abs(_needed(run)).max(axis=0).tolist(),
    }


def rows(run: Run, wheels: Wheels, missed: bool) -> list[tuple[str, str]]:
    """Pairs of name and figure: none where no limit is met; why, where the target is missed."""
    found = saturation(run, wheels)
    told = {
        "torque": (found["torque"], wheels.max_torque, "N m"),
        "momentum": (found["momentum"], wheels.max_momentum, "N m s"),
    }
    said = [
        (f"wheels at their limit of {name}", f"{_wheels(times)} ({limit:g} {unit})")
        for name, (times, limit, unit) in told.items()
        if any(times)
    ]
    if missed and any(found["momentum"]):
        k = int(np.argmax(found["momentum_needed"]))
        needed = f"wheel {k + 1} would have to store {found['momentum_needed'][k]:.2e} N m s"
        said.append(("why it misses", f"{needed}; thrusters, [thrusters], need no store"))
    elif missed and said:
        said.append(("why it misses", "wheels give less than control asks for"))
    return said


def _at(run: Run, values: np.ndarray, limit: float) -> list[float]:
    """Times (s) at a limit, by wheel."""
    period = float(run.t[1] - run.t[0])
    return (period * np.count_nonzero(np.abs(values) >= limit * (1 - _NEAR), axis=0)).tolist()


def _needed(run: Run) -> np.ndarray:
    """What wheels store (N, 3) where what is wanted is flown, N m s: in space momentum stays."""
    wanted = run.inertia * run.reference.omega
    whole = matrix(run.q[0]) @ (run.inertia * run.omega[0] + run.wheel_momentum[0])
    return np.array([whole @ matrix(q) for q in run.reference.q]) - wanted


def _wheels(times: list[float]) -> str:
    return ", ".join(f"{k} for {time:.1f} s" for k, time in enumerate(times, 1) if time)
