"""Where an optimiser begins: a motion put on the mesh, or no motion at all."""

from collections.abc import Callable

import numpy as np

from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.comparison.collocation.task import Model
from rigidsym.manoeuvre.comparison.collocation.trajectory import Trajectory

# Attitudes (N, 4) and rates (N, 3) at times (N,) from 0 to 1.
Guess = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


def still(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """At the start all along."""
    return np.tile([1.0, 0.0, 0.0, 0.0], (len(t), 1)), np.zeros((len(t), 3))


def guessed(mesh: Mesh, inertia: np.ndarray, model: Model, motion: Guess) -> Trajectory:
    """A motion from rest to rest: its torques are those that its rates need, whatever the limits.

    What a motion does not stop at its ends by itself, the first and the last interval do.
    """
    nodes = np.hstack(motion(mesh.nodes))
    nodes[[0, -1], 4:] = 0
    shape = mesh.intervals, mesh.points, nodes.shape[1]
    inner = np.hstack(motion(mesh.inner.ravel())).reshape(shape)
    impulses = inertia * np.diff(nodes[:, 4:], axis=0)
    if model is Model.THRUSTERS:
        rates = inner[..., 4:]
        gyroscopic = np.cross(rates, inertia * rates)
        impulses += mesh.steps[:, None] * np.einsum("j,kja->ka", mesh.tableau.b, gyroscopic)
    return Trajectory(nodes, inner, impulses)
