"""Where time is cut: finely at both ends, where the torques act."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rigidsym.manoeuvre.comparison.collocation.gauss import Tableau, gauss

INTERVALS, POINTS = 80, 2


@dataclass(frozen=True)
class Mesh:
    """So many intervals of [0, 1], so many points of collocation in each.

    The first interval is 1e-4 long, the middle ones 0.02, with 80 of them.
    """

    intervals: int = INTERVALS
    points: int = POINTS

    @cached_property
    def nodes(self) -> np.ndarray:
        """Ends of the intervals (N + 1,): those of Chebyshev."""
        return (1 - np.cos(np.pi * np.arange(self.intervals + 1) / self.intervals)) / 2

    @cached_property
    def steps(self) -> np.ndarray:
        """Lengths of the intervals (N,)."""
        return np.diff(self.nodes)

    @property
    def tableau(self) -> Tableau:
        """Of each interval."""
        return gauss(self.points)

    @property
    def inner(self) -> np.ndarray:
        """Points of collocation (N, s)."""
        return self.nodes[:-1, None] + self.steps[:, None] * self.tableau.c
