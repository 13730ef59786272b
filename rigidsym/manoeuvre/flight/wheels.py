"""What reaction wheels can do of what they are told."""

import numpy as np

from rigidsym.manoeuvre.flight.settings import Wheels


def next_torque(
    wheels: Wheels, torque: np.ndarray, momentum: np.ndarray, command: np.ndarray, period: float
) -> np.ndarray:
    """The torque (3,) on the spacecraft at the end of a period (s), N m, if `command` is wanted.

    It goes there along a straight line from `torque`, so that neither the torque nor its rate
    ever is beyond its limit.  `momentum` (3,) is what the wheels store, N m s, at the beginning.
    """
    change = wheels.max_torque_rate * period
    wanted = command
    if wheels.max_momentum is not None:
        wanted = _storable(wheels, wheels.max_momentum, torque, momentum, command, period)
    limited = np.clip(wanted, -wheels.max_torque, wheels.max_torque)
    return np.clip(limited, torque - change, torque + change)


def _storable(
    wheels: Wheels,
    most: float,
    torque: np.ndarray,
    momentum: np.ndarray,
    wanted: np.ndarray,
    period: float,
) -> np.ndarray:
    """As much of a torque as lets the wheels stop gaining before they store more than `most`."""
    below, above = (
        _gain(
            wheels.max_torque_rate * period,
            period,
            most - side * momentum + side * torque * period / 2,
        )
        for side in (1.0, -1.0)
    )
    return np.clip(wanted, -below, above)


def _gain(change: float, period: float, room: np.ndarray) -> np.ndarray:
    """The greatest rates g of gaining momentum at the end of a period that `room` allows.

    In that period g adds period g / 2.  Then it goes down by `change` in each period, and to zero
    in the last: k periods and one add the trapezoids of g, g - change, .., g - k change, 0.  All
    of it, as a function of g, has straight pieces between the multiples k change, where it is
    change period k (k + 1) / 2.
    """
    left = np.maximum(room, 0.0)
    unit = change * period
    k = np.floor((np.sqrt(1 + 8 * left / unit) - 1) / 2)
    return k * change + (left - unit * k * (k + 1) / 2) / (period * (k + 1))
