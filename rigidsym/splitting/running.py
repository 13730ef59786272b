"""One run with a given step; what stops it keeps what was reached."""

import numpy as np

from rigidsym.splitting.state import State
from rigidsym.splitting.stepping import Splitting
from rigidsym.splitting.trajectory import Trajectory, states


def run(splitting: Splitting, start: State, times: np.ndarray, step: float) -> Trajectory:
    """The trajectory at times that grow, from times[0] on."""
    q, omega = (np.empty((*x.shape[:-1], times.size, x.shape[-1])) for x in (start.q, start.omega))
    reached = 0

    def trajectory() -> Trajectory:
        found = times[:reached], q[..., :reached, :], omega[..., :reached, :]
        return Trajectory(*found, step, splitting.evaluations, splitting)

    try:
        for state in states(splitting, start, float(times[0]), times, step):
            q[..., reached, :], omega[..., reached, :] = state.q, state.omega
            reached += 1
    except BaseException as stop:
        vars(stop)["trajectory"] = trajectory()
        raise
    return trajectory()
