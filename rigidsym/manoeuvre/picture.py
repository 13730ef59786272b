"""Where the momentum of a transfer can lie: the cone of directions, and the motions found on it."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.engines import engine
from rigidsym.manoeuvre.directions import Arcs, arcs, is_symmetry
from rigidsym.manoeuvre.planning import Plan
from rigidsym.manoeuvre.problem import problem
from rigidsym.view.scenes.directions import scene

if TYPE_CHECKING:
    from rigidsym.view.scenes.scene import Figure

AN_ARC = 49


def directions_of(plan: Plan) -> "Figure":
    """The sphere of momentum directions, in the body axes of the start, of a plan.

    On it are the cone, from whose directions alone a natural motion can arrive; of each transfer
    the polhode, thin, and the way of the momentum on it, thick, from a dot on the cone on.  A turn
    that is a symmetry of the body allows every direction: it has one of each polhode drawn.
    Raises ImportError without plotly.
    """
    asked = plan.manoeuvre
    posed = problem(asked.inertia, asked.start, asked.target, engine("numpy"))
    # None for a sphere, whose momentum has the direction of its rates.
    name = "one of each polhode" if is_symmetry(posed) else "cone of directions"
    moving = {f"transfer {k}": x for k, x in enumerate(plan.transfers, 1) if x.momentum}
    title = f"Momenta that arrive in {plan.best.duration:g} s"
    return scene(asked.inertia, (name, cone(arcs(posed))), moving, title)


def cone(curves_of: Arcs) -> list[np.ndarray]:
    """The arcs as curves (N, 3)."""
    return [
        curves_of.direction(np.linspace(begin, end, AN_ARC), np.full(AN_ARC, k))
        for k, (begin, end) in enumerate(curves_of.ends)
    ]
