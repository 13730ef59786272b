"""The motion that the torques of an optimum make, integrated by other means than collocation."""

from bisect import bisect_right
from collections.abc import Callable

import numpy as np
from scipy.integrate import OdeSolution, solve_ivp

from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.comparison.collocation.task import Model
from rigidsym.manoeuvre.flight.rotation import cross

_TOLERANCE = 1e-10


class Driven:
    """From rest and the start's axes, by SciPy's DOP853 from interval to interval."""

    def __init__(self, model: Model, inertia: np.ndarray, impulses: np.ndarray, mesh: Mesh) -> None:
        self._nodes = mesh.nodes.tolist()
        self._pieces: list[OdeSolution] = []
        state = np.array([1.0, *np.zeros(6)])
        for k, torque in enumerate(impulses / mesh.steps[:, None]):
            span = self._nodes[k], self._nodes[k + 1]
            found = solve_ivp(
                _equations(model, inertia, torque),
                span,
                state,
                method="DOP853",
                rtol=_TOLERANCE,
                atol=_TOLERANCE,
                first_step=span[1] - span[0],
                dense_output=True,
            )
            state = found.y[:, -1]
            self._pieces.append(found.sol)
        self.end = state[:4], state[4:]
        "Attitude (4,) and rates (3,) at time 1."

    def __call__(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Attitudes (N, 4) and rates (N, 3) at times (N,) from 0 to 1."""
        states = np.array([self._at(x) for x in np.clip(t, 0.0, 1.0).tolist()])
        length = np.linalg.norm(states[:, :4], axis=1, keepdims=True)
        return states[:, :4] / length, states[:, 4:]

    def _at(self, t: float) -> np.ndarray:
        piece = min(bisect_right(self._nodes, t), len(self._pieces)) - 1
        return self._pieces[piece](t)


def _equations(
    model: Model, inertia: np.ndarray, torque: np.ndarray
) -> Callable[[float, np.ndarray], np.ndarray]:
    def derivative(t: float, state: np.ndarray) -> np.ndarray:
        q, w = state[:4], state[4:]
        felt = torque - cross(w, inertia * w) if model is Model.THRUSTERS else torque
        turn = [-(q[1:] @ w) / 2, *(q[0] * w + cross(q[1:], w)) / 2]
        return np.concatenate([turn, felt / inertia])

    return derivative
