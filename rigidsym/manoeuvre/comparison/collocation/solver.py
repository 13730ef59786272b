"""IPOPT on such programmes: the cost, the motion, and how many iterations it took."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np

from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.comparison.collocation.task import Cost, Task
from rigidsym.manoeuvre.comparison.collocation.trajectory import (
    STATES,
    Trajectory,
    trajectory,
)
from rigidsym.manoeuvre.comparison.collocation.transcription import PARAMETERS, programme

TOLERANCE = 1e-8
"Of optimality and constraints, IPOPT's own default."
MOST_ITERATIONS = 500

_QUIET = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes"}
SETTINGS: Mapping[str, Mapping[str, float | str]] = {
    # An interior-point method pushes what it is given away from the bounds, and begins with a
    # barrier so high that little is left of it.
    "default": {},
    # Closer to the bounds and with a lower barrier, it begins where it is told to.
    "near the guess": {
        "ipopt.mu_init": 1e-3,
        "ipopt.bound_push": 1e-4,
        "ipopt.bound_frac": 1e-4,
        "ipopt.bound_mult_init_method": "mu-based",
    },
}
"""IPOPT's, by name: what a guess is worth depends on them."""


@dataclass(frozen=True, slots=True)
class Posed:
    """inertia (3,): over the largest.  target (4,): from the start's axes.  limit: of the torque
    of each axis."""

    inertia: np.ndarray
    target: np.ndarray
    limit: float


@dataclass(frozen=True, slots=True)
class Optimum:
    """cost: what the optimiser found.  iterations: of IPOPT.  converged: to the tolerance."""

    cost: float
    iterations: int
    converged: bool
    trajectory: Trajectory


def optimum(
    task: Task, posed: Posed, begin: Trajectory, settings: str = "default", mesh: Mesh | None = None
) -> Optimum:
    """A local optimum, searched from a trajectory on the same mesh."""
    mesh = mesh or Mesh()
    solve = _solver(task, settings, mesh.intervals, mesh.points)
    low, high = _bounds(task, posed, mesh)
    first = begin.unknowns(task.cost is Cost.FUEL)
    given = np.concatenate([posed.inertia, posed.target])
    found = solve(x0=first, p=given, lbx=low, ubx=high, lbg=0, ubg=0)
    told = solve.stats()
    states = trajectory(mesh, np.array(found["x"]).ravel())
    return Optimum(float(found["f"]), int(told["iter_count"]), bool(told["success"]), states)


@cache
def _solver(task: Task, settings: str, intervals: int, points: int) -> ca.Function:
    found = programme(task, Mesh(intervals, points))
    if found.parameters.numel() != PARAMETERS:
        raise ValueError("a programme is given a body and a target")
    options = {"ipopt.tol": TOLERANCE, "ipopt.max_iter": MOST_ITERATIONS}
    nlp = {
        "x": found.unknowns,
        "p": found.parameters,
        "f": found.objective,
        "g": found.constraints,
    }
    return ca.nlpsol("optimum", "ipopt", nlp, {**_QUIET, **options, **SETTINGS[settings]})


def _bounds(task: Task, posed: Posed, mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Of all unknowns: the start and rest at both ends are given, impulses are limited."""
    most = posed.limit if task.limited else np.inf
    room = np.repeat(most * mesh.steps, 3)
    size = STATES * ((mesh.points + 1) * mesh.intervals + 1)
    low, high = np.full(size, -np.inf), np.full(size, np.inf)
    low[:STATES] = high[:STATES] = [1.0, *np.zeros(6)]
    end = STATES * mesh.intervals
    low[end + 4 : end + STATES] = high[end + 4 : end + STATES] = 0
    none = np.zeros_like(room)
    if task.cost is Cost.FUEL:
        return np.concatenate([low, none, none]), np.concatenate([high, room, room])
    return np.concatenate([low, -room, none]), np.concatenate([high, room, none])
