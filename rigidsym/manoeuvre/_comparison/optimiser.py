"""Optimal control as a nonlinear programme, built with CasADi and solved by IPOPT.

One programme serves all bodies and targets: they are its parameters.  A case is solved for each
task from each first guess, with each of the optimiser's settings.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import casadi as ca
import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre._comparison.collocation import (
    AXES,
    MESH,
    STATES,
    Cost,
    Driven,
    Guess,
    Mesh,
    Model,
    Task,
    Trajectory,
    gauss,
    guessed,
    still,
)
from rigidsym.manoeuvre._comparison.flights import Case, constant, turned
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._rotation import angle, relative
from rigidsym.manoeuvre.flight._settings import Wheels

TASKS = tuple(
    Task(model, cost, limited)
    for model in Model
    for cost, limited in ((Cost.FUEL, True), (Cost.FUEL, False), (Cost.ENERGY, True))
)
SAME = 1e-4
"Relative difference below which two costs count as the same."
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
    """The inertia, the target and the torque limit of an optimal-control problem.

    inertia (3,): over the largest.  target (4,): relative to the start.  limit: of the torque of
    each axis.
    """

    inertia: np.ndarray
    target: np.ndarray
    limit: float


@dataclass(frozen=True, slots=True)
class Optimum:
    """The result of one run of IPOPT.

    `converged` is true where it reached the tolerance.
    """

    cost: float
    iterations: int
    converged: bool
    trajectory: Trajectory


def solved(case: Case, transfer: Transfer, task: Task) -> tuple[dict[str, Any], np.ndarray]:
    """Solve an optimal-control task from each first guess.

    Return the results and the impulses of the best.

    The results are the entries of the schema rigidsym.comparison/1: the least cost of all attempts
    that converged, N m s for fuel, N^2 m^2 s for energy; the miss of the best torques by another
    integrator, degrees; the attempts by setting and guess.  Impulses are without units, on the
    mesh.  The limit of torques is the wheels'.  Raises InputError where no attempt converges.
    """
    largest = float(case.inertia.max())
    inertia, target = case.inertia / largest, case.problem.turn
    posed = Posed(inertia, target, Wheels().max_torque * case.duration**2 / largest)
    points = {
        name: guessed(MESH, inertia, task.model, motion)
        for name, motion in guesses(case, transfer).items()
    }
    found = {
        setting: {name: optimum(task, posed, point, setting) for name, point in points.items()}
        for setting in SETTINGS
    }
    every = [one for several in found.values() for one in several.values() if one.converged]
    if not every:
        rule = f"{task.name}: no optimum was found; another seed has other manoeuvres"
        raise InputError("manoeuvre", case.index, rule)
    best = min(every, key=lambda one: one.cost)
    impulses = best.trajectory.impulses
    arrived, _ = Driven(task.model, inertia, impulses, MESH).end
    # Impulses are in the largest moment over the duration.
    impulse = largest / case.duration
    unit = impulse if task.cost is Cost.FUEL else impulse**2 / case.duration
    least = best.cost * unit
    attempts = {
        setting: {name: attempt(one, unit, least) for name, one in several.items()}
        for setting, several in found.items()
    }
    miss = float(np.degrees(angle(target, arrived)))
    return {"best": least, "miss": miss, "attempts": attempts}, impulses


def attempt(found: Optimum, unit: float, least: float) -> dict[str, Any]:
    """Return one run of the optimiser as an entry in the schema rigidsym.comparison/1.

    `best` is true where the attempt found the least cost.
    """
    cost = found.cost * unit
    return {
        "cost": cost,
        "iterations": found.iterations,
        "converged": found.converged,
        "best": found.converged and cost <= least * (1 + SAME),
    }


def guesses(case: Case, transfer: Transfer) -> Mapping[str, Guess]:
    """Return the first guesses for the optimiser by name.

    They are functions of times from 0 to 1, with attitudes relative to the start.
    """

    def natural(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, omega = transfer.motion(t * case.duration)
        return relative(case.start, q), omega * case.duration

    eigenaxis = partial(turned, case.rotation_vector, constant)
    return {"natural": natural, "eigenaxis": eigenaxis, "still": still}


def optimum(
    task: Task, posed: Posed, begin: Trajectory, settings: str = "default", mesh: Mesh = MESH
) -> Optimum:
    """Search for a local optimum, starting from a trajectory on the same mesh."""
    solve = _solver(task, settings, mesh)
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
def _solver(task: Task, settings: str, mesh: Mesh) -> ca.Function:
    options = {
        "print_time": False,
        "ipopt.print_level": 0,
        "ipopt.sb": "yes",
        "ipopt.tol": TOLERANCE,
        "ipopt.max_iter": MOST_ITERATIONS,
    }
    return ca.nlpsol("optimum", "ipopt", _programme(task, mesh), {**options, **SETTINGS[settings]})


def _bounds(task: Task, posed: Posed, mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the lower and upper bounds of all unknowns.

    They fix the initial attitude and rest at both ends, and limit the impulses.
    """
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
    """Return the nonlinear programme of a task for CasADi.

    Motions are from rest to rest; they may reach either sign of the target's quaternion.

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
    """Return the collocation defects of one interval as a CasADi function.

    They vanish where the states satisfy the equations of motion.

    Its arguments: the state at the begin, those inside, that at the end, the impulse, the length
    of the interval, and the moments of inertia.
    """
    begin, end = ca.SX.sym("begin", STATES), ca.SX.sym("end", STATES)
    inner = ca.SX.sym("inner", STATES, mesh.points)
    impulse, step, inertia = ca.SX.sym("p", AXES), ca.SX.sym("h"), ca.SX.sym("J", 3)

    def derivative(state: ca.SX) -> ca.SX:
        """Return the time derivatives of the attitude and of the rates."""
        q, w, torque = state[:4], state[4:], impulse / step
        turn = ca.vertcat(-ca.dot(q[1:], w), q[0] * w + ca.cross(q[1:], w)) / 2
        felt = torque - ca.cross(w, inertia * w) if model is Model.THRUSTERS else torque
        return ca.vertcat(turn, felt / inertia)

    slopes = [derivative(x) for x in ca.horzsplit(inner)]
    # (points + 1) sums: to each point, and to the end.
    rows = [*gauss(mesh.points).a, gauss(mesh.points).b]
    sums = [sum(w * f for w, f in zip(row.tolist(), slopes, strict=True)) for row in rows]
    states = [*ca.horzsplit(inner), end]
    found = [x - begin - step * total for x, total in zip(states, sums, strict=True)]
    arguments = [begin, ca.vec(inner), end, impulse, step, inertia]
    return ca.Function("defects", arguments, [ca.vertcat(*found)])
