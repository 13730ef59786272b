"""One run by a rule for the steps; what stops it keeps the states that were reached."""

import numpy as np

from rigidsym.splitting.state import State
from rigidsym.splitting.stepping import Splitting
from rigidsym.splitting.trajectory import Mesh, Trajectory, states


def run(splitting: Splitting, start: State, times: np.ndarray, mesh: Mesh) -> Trajectory:
    """Return the trajectory at times that grow, from times[0] on."""
    q, omega = (np.empty((*x.shape[:-1], times.size, x.shape[-1])) for x in (start.q, start.omega))
    reached = 0

    def trajectory() -> Trajectory:
        found = times[:reached], q[..., :reached, :], omega[..., :reached, :]
        steps = Mesh(mesh.edges, mesh.steps)
        return Trajectory(*found, steps, splitting.evaluations, splitting, probes=splitting.probes)

    try:
        for state in states(splitting, start, float(times[0]), times, mesh):
            q[..., reached, :], omega[..., reached, :] = state.q, state.omega
            reached += 1
    except BaseException as stop:
        vars(stop)["trajectory"] = trajectory()
        raise
    return trajectory()
