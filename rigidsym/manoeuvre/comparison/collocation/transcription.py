"""Optimal control as a nonlinear programme in CasADi's symbols, one for all bodies and targets."""

from dataclasses import dataclass

import casadi as ca

from rigidsym.manoeuvre.comparison.collocation.mesh import Mesh
from rigidsym.manoeuvre.comparison.collocation.task import Cost, Model, Task
from rigidsym.manoeuvre.comparison.collocation.trajectory import AXES, STATES

PARAMETERS = 7
"Of a programme: moments of inertia (3) and target (4)."


@dataclass(frozen=True, slots=True)
class Programme:
    """Minimise `objective` over `unknowns` where `constraints` vanish; `parameters` are given."""

    unknowns: ca.MX
    parameters: ca.MX
    objective: ca.MX
    constraints: ca.MX


def derivative(model: Model, inertia: ca.SX, torque: ca.SX, state: ca.SX) -> ca.SX:
    """q' = q (0, w) / 2 and w', of a state (7,)."""
    q, w = state[:4], state[4:]
    turn = ca.vertcat(-ca.dot(q[1:], w), q[0] * w + ca.cross(q[1:], w)) / 2
    felt = torque - ca.cross(w, inertia * w) if model is Model.THRUSTERS else torque
    return ca.vertcat(turn, felt / inertia)


def defects(model: Model, mesh: Mesh) -> ca.Function:
    """A function of one interval: by how much its states do not obey the equations.

    Of the state at its begin, those inside, that at its end, the impulse, its length and the
    moments of inertia.
    """
    tableau = mesh.tableau
    begin, end = ca.SX.sym("begin", STATES), ca.SX.sym("end", STATES)
    inner = ca.SX.sym("inner", STATES, mesh.points)
    impulse, step, inertia = ca.SX.sym("p", AXES), ca.SX.sym("h"), ca.SX.sym("J", 3)
    slopes = [derivative(model, inertia, impulse / step, x) for x in ca.horzsplit(inner)]
    # (points + 1) sums: to each point, and to the end.
    rows = [*tableau.a, tableau.b]
    sums = [sum(w * f for w, f in zip(row.tolist(), slopes, strict=True)) for row in rows]
    there = [*ca.horzsplit(inner), end]
    found = [x - begin - step * total for x, total in zip(there, sums, strict=True)]
    given = [begin, ca.vec(inner), end, impulse, step, inertia]
    return ca.Function("defects", given, [ca.vertcat(*found)])


def programme(task: Task, mesh: Mesh) -> Programme:
    """Of a task on a mesh: from rest to rest, either sign of the target's quaternion.

    With fuel, torques are split into what turns one way and what turns the other, u = u+ - u-,
    both of them not negative: where the sum u+ + u- is least, one of them is zero, and it is |u|.
    """
    count = mesh.intervals
    steps = ca.DM(mesh.steps).T
    nodes = ca.MX.sym("nodes", STATES, count + 1)
    inner = ca.MX.sym("inner", STATES * mesh.points, count)
    up, down = ca.MX.sym("up", AXES, count), ca.MX.sym("down", AXES, count)
    given = ca.MX.sym("given", PARAMETERS)
    inertia, target = given[:3], given[3:]
    intervals = defects(task.model, mesh).map(count)
    obeyed = intervals(
        nodes[:, :-1], inner, nodes[:, 1:], up - down, steps, ca.repmat(inertia, 1, count)
    )
    missed = _vector_part(target, nodes[:4, -1])
    cost = up + down if task.cost is Cost.FUEL else (up - down) ** 2 / ca.repmat(steps, AXES, 1)
    return Programme(
        ca.veccat(nodes, inner, up, down),
        given,
        ca.sum1(ca.vec(cost)),
        ca.vertcat(ca.vec(obeyed), missed),
    )


def _vector_part(p: ca.MX, q: ca.MX) -> ca.MX:
    """Of conj(p) q: zero where p and q are the same attitude."""
    return p[0] * q[1:] - q[0] * p[1:] - ca.cross(p[1:], q[1:])
