"""States of many motions with their sensitivities: the one door from fits to the solution."""

import numpy as np

from rigidsym.fitting.parameters import Point
from rigidsym.motion import TorqueFreeMotion, propagate


def motion(point: Point) -> TorqueFreeMotion:
    """Of the principal axes, from the state of one point."""
    parts = (point.moments, point.omega, point.attitude)
    return TorqueFreeMotion(*(x.tolist() for x in parts))


def states(point: Point, times: np.ndarray, engine: str) -> tuple[np.ndarray, np.ndarray]:
    """q (..., N, 4), omega (..., N, 3) of the principal axes; NaN where there are none."""
    found = propagate(
        point.moments, point.omega, times, point.attitude, engine=engine, errors="nan"
    )
    return found[0], found[1]


def sensitivities(
    point: Point, times: np.ndarray, engine: str
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The same, and how turn and rates go with (eta0, omega0, moments): (..., N, 6, 9)."""
    q, omega, found = propagate(
        point.moments,
        point.omega,
        times,
        point.attitude,
        engine=engine,
        errors="nan",
        sensitivity=True,
    )
    return q, omega, np.concatenate([found.attitude, found.rates], axis=-2)
