"""Optimal control as a nonlinear programme in CasADi's symbols, solved by IPOPT.

One programme serves all bodies and targets: they are its parameters.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np

from rigidsym.manoeuvre._comparison.collocation import (
    AXES,
    STATES,
    Cost,
    Mesh,
    Model,
    Task,
    Trajectory,
)

TOLERANCE = 1e-8
"Of optimality and constraints, IPOPT's own default."
MOST_ITERATIONS = 500
SETTINGS: Mapping[str, Mapping[str, float | str]] = {
    # An interior-point method moves its first guess away from the bounds and begins with a high
    # barrier, so that little is left of the guess.
    "default": {},
    # Closer to the bounds and with a lower barrier, it begins at the guess.
    "near the guess": {
        "ipopt.mu_init": 1e-3,
        "ipopt.bound_push": 1e-4,
        "ipopt.bound_frac": 1e-4,
        "ipopt.bound_mult_init_method": "mu-based",
    },
}
"Settings of IPOPT, by name: the worth of a guess depends on them."
_PARAMETERS = 7


@dataclass(frozen=True, slots=True)
class Posed:
    """A body and its target.

    inertia (3,): over the largest.  target (4,): relative to the start.  limit: of the torque of
    each axis.
    """

    inertia: np.ndarray
    target: np.ndarray
    limit: float


@dataclass(frozen=True, slots=True)
class Optimum:
    """A result of IPOPT: its cost, its iterations, and whether it converged to the tolerance."""

    cost: float
    iterations: int
    converged: bool
    trajectory: Trajectory


def optimum(
    task: Task, posed: Posed, begin: Trajectory, settings: str = "default", mesh: Mesh | None = None
) -> Optimum:
    """Search a local optimum from a trajectory on the same mesh."""
    mesh = mesh or Mesh()
    solve = _solver(task, settings, mesh.intervals, mesh.points)
    low, high = _bounds(task, posed, mesh)
    found = solve(
        x0=begin.unknowns(task.cost is Cost.FUEL),
        p=np.concatenate([posed.inertia, posed.target]),
        lbx=low,
        ubx=high,
        lbg=0,
        ubg=0,
    )
    statistics = solve.stats()
    return Optimum(
        float(found["f"]),
        int(statistics["iter_count"]),
        bool(statistics["success"]),
        Trajectory.of_unknowns(mesh, np.array(found["x"]).ravel()),
    )


@cache
def _solver(task: Task, settings: str, intervals: int, points: int) -> ca.Function:
    options = {
        "print_time": False,
        "ipopt.print_level": 0,
        "ipopt.sb": "yes",
        "ipopt.tol": TOLERANCE,
        "ipopt.max_iter": MOST_ITERATIONS,
    }
    nlp = _programme(task, Mesh(intervals, points))
    return ca.nlpsol("optimum", "ipopt", nlp, {**options, **SETTINGS[settings]})


def _bounds(task: Task, posed: Posed, mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the bounds of all unknowns: fixed start, rest at both ends, limited impulses."""
    most = posed.limit if task.limited else np.inf
    room = np.repeat(most * mesh.steps, AXES)
    size = STATES * ((mesh.points + 1) * mesh.intervals + 1)
    low, high = np.full(size, -np.inf), np.full(size, np.inf)
    low[:STATES] = high[:STATES] = [1.0, *np.zeros(6)]
    end = STATES * mesh.intervals
    low[end + 4 : end + STATES] = high[end + 4 : end + STATES] = 0
    none = np.zeros_like(room)
    if task.cost is Cost.FUEL:
        return np.concatenate([low, none, none]), np.concatenate([high, room, room])
    return np.concatenate([low, -room, none]), np.concatenate([high, room, none])


def _programme(task: Task, mesh: Mesh) -> dict[str, ca.MX]:
    """Return the programme of a task: from rest to rest, either sign of the target's quaternion.

    For fuel, torques are the difference of two parts, u = u+ - u-, neither of them negative: where
    the sum u+ + u- is least, one of them is zero, and the sum is |u|.
    """
    count = mesh.intervals
    steps = ca.DM(mesh.steps).T
    nodes = ca.MX.sym("nodes", STATES, count + 1)
    inner = ca.MX.sym("inner", STATES * mesh.points, count)
    up, down = ca.MX.sym("up", AXES, count), ca.MX.sym("down", AXES, count)
    parameters = ca.MX.sym("given", _PARAMETERS)
    inertia, p, q = parameters[:3], parameters[3:], nodes[:4, -1]
    obeyed = defects(task.model, mesh).map(count)(
        nodes[:, :-1], inner, nodes[:, 1:], up - down, steps, ca.repmat(inertia, 1, count)
    )
    # The vector part of conj(p) q: zero where p and q are the same attitude.
    missed = p[0] * q[1:] - q[0] * p[1:] - ca.cross(p[1:], q[1:])
    cost = up + down if task.cost is Cost.FUEL else (up - down) ** 2 / ca.repmat(steps, AXES, 1)
    return {
        "x": ca.veccat(nodes, inner, up, down),
        "p": parameters,
        "f": ca.sum1(ca.vec(cost)),
        "g": ca.vertcat(ca.vec(obeyed), missed),
    }


def defects(model: Model, mesh: Mesh) -> ca.Function:
    """Return the function of one interval that vanishes where its states obey the equations.

    Its arguments: the state at the begin, those inside, that at the end, the impulse, the length
    of the interval, and the moments of inertia.
    """
    tableau = mesh.tableau
    begin, end = ca.SX.sym("begin", STATES), ca.SX.sym("end", STATES)
    inner = ca.SX.sym("inner", STATES, mesh.points)
    impulse, step, inertia = ca.SX.sym("p", AXES), ca.SX.sym("h"), ca.SX.sym("J", 3)
    slopes = [_derivative(model, inertia, impulse / step, x) for x in ca.horzsplit(inner)]
    # (points + 1) sums: to each point, and to the end.
    rows = [*tableau.a, tableau.b]
    sums = [sum(w * f for w, f in zip(row.tolist(), slopes, strict=True)) for row in rows]
    states = [*ca.horzsplit(inner), end]
    found = [x - begin - step * total for x, total in zip(states, sums, strict=True)]
    arguments = [begin, ca.vec(inner), end, impulse, step, inertia]
    return ca.Function("defects", arguments, [ca.vertcat(*found)])


def _derivative(model: Model, inertia: ca.SX, torque: ca.SX, state: ca.SX) -> ca.SX:
    """Return q' = q (0, w) / 2 and w', of a state (7,)."""
    q, w = state[:4], state[4:]
    turn = ca.vertcat(-ca.dot(q[1:], w), q[0] * w + ca.cross(q[1:], w)) / 2
    felt = torque - ca.cross(w, inertia * w) if model is Model.THRUSTERS else torque
    return ca.vertcat(turn, felt / inertia)
