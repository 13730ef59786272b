"""The step that a tolerance asks for."""

from dataclasses import replace

import numpy as np

from rigidsym.errors import PrecisionError
from rigidsym.quaternions import conjugate, product, rotation_vectors
from rigidsym.splitting.running import run
from rigidsym.splitting.state import State
from rigidsym.splitting.stepping import Splitting
from rigidsym.splitting.trajectory import Trajectory

# The first step, which is halved, of the fastest body, rad.
_FIRST = 1.0
_MOST_HALVINGS = 24
# So many in a row that gain less than half: errors fall by four in the limit of short steps, unless
# rounding, noise or chaos is as large.
_IN_VAIN = 4


def chosen(splitting: Splitting, start: State, times: np.ndarray, tolerance: float) -> Trajectory:
    """The first of runs, each with half the step of the one before, below the tolerance.

    The error of a run is what parts it from the one before, over 2^order - 1, as it is in the limit
    of short steps.  All runs before the last take as many evaluations as that does.  Raises
    PrecisionError where halving no longer helps; its `trajectory` is the best.
    """
    runs = [run(splitting, start, times, _first_step(start, times))]
    best, in_vain = replace(runs[0], error=np.inf), 0
    for _ in range(_MOST_HALVINGS):
        runs = [runs[-1], run(splitting, start, times, runs[-1].step / 2)]
        error = gap(*runs) / (2**splitting.method.order - 1)
        if error <= tolerance:
            return replace(runs[1], error=error)
        in_vain = 0 if error < _error(best) / 2 else in_vain + 1
        if error < _error(best):
            best = replace(runs[1], error=error)
        if in_vain == _IN_VAIN:
            break
    refused = PrecisionError(
        f"tolerance = {tolerance:g}: no step reaches it, the best is {best.step:g} s with "
        f"{_error(best):.1e} rad"
    )
    vars(refused)["trajectory"] = best
    raise refused


def gap(one: Trajectory, other: Trajectory) -> float:
    """The largest rotation between two trajectories, rad, or difference of rates as a part of the
    largest rate of that body."""
    turns = np.linalg.norm(rotation_vectors(product(conjugate(one.q), other.q)), axis=-1)
    rates = np.linalg.norm(one.omega - other.omega, axis=-1)
    sizes = np.max(np.linalg.norm(other.omega, axis=-1), axis=-1, keepdims=True)
    parts = np.divide(rates, sizes, out=np.zeros_like(rates), where=sizes > 0)
    return float(max(np.max(turns), np.max(parts)))


def _error(trajectory: Trajectory) -> float:
    return np.inf if trajectory.error is None else trajectory.error


def _first_step(start: State, times: np.ndarray) -> float:
    fastest = float(np.max(np.linalg.norm(start.omega, axis=-1)))
    span = float(times[-1] - times[0]) or 1.0
    return min(span, _FIRST / fastest) if fastest else span
