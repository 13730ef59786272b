"""States and impulses on a mesh, and how they follow one another in a vector of unknowns."""

from dataclasses import dataclass

import numpy as np

from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh

STATES, AXES = 7, 3
"Attitude (4) and rates (3); of torques."


@dataclass(frozen=True, slots=True)
class Trajectory:
    """nodes (N + 1, 7), inner (N, s, 7): attitude and rates.  impulses (N, 3): of the torque,
    which is constant in each interval."""

    nodes: np.ndarray
    inner: np.ndarray
    impulses: np.ndarray

    def unknowns(self, split: bool) -> np.ndarray:
        """One vector: nodes, inner, and impulses: up u+ and down u-, or as they are and zeros."""
        up, down = self.impulses, np.zeros_like(self.impulses)
        if split:
            up, down = np.maximum(up, 0), np.maximum(-up, 0)
        return np.concatenate([part.ravel() for part in (self.nodes, self.inner, up, down)])


def trajectory(mesh: Mesh, unknowns: np.ndarray) -> Trajectory:
    """From such a vector."""
    count, points = mesh.intervals, mesh.points
    sizes = [STATES * (count + 1), STATES * points * count, AXES * count]
    nodes, inner, up, down = np.split(unknowns, np.cumsum(sizes))
    return Trajectory(
        nodes.reshape(count + 1, STATES),
        inner.reshape(count, points, STATES),
        (up - down).reshape(count, AXES),
    )
