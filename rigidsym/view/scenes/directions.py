"""Where the momentum of a transfer can lie: the cone of directions, and the motions found on it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.engines import engine
from rigidsym.manoeuvre.directions import Arcs, arcs, is_symmetry
from rigidsym.manoeuvre.problem import Problem, problem
from rigidsym.view.geometry import moments, momentum, polhode, separatrix
from rigidsym.view.scenes.scene import GREY, body_axes, curves, dot, figure, line, plotly
from rigidsym.view.scenes.sphere import SEPARATRIX, globe

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from rigidsym.manoeuvre.planning import Plan
    from rigidsym.manoeuvre.transfer import Transfer

AN_ARC, AROUND, ON_THE_WAY = 49, 121, 361
CONE = "#c9a227"
# Colours of transfers, told apart by all readers; more of them begin anew.
COLOURS = ("#d62f5f", "#1f83c4", "#139a6f", "#e0682a", "#7a5cc4")


def directions_of(plan: "Plan") -> "Figure":
    """The sphere of momentum directions, in the body axes of the start, of a plan.

    On it are the cone, from whose directions alone a natural motion can arrive; of each transfer
    the polhode, thin, and the way of the momentum on it, thick, from a dot on the cone on.  A turn
    that is a symmetry of the body allows every direction: it has one of each polhode drawn.
    Raises ImportError without plotly.
    """
    go = plotly("directions_of")
    asked = plan.manoeuvre
    posed = problem(asked.inertia, asked.start, asked.target, engine("numpy"))
    traces = globe(go, 1.0)
    circles = separatrix(asked.inertia, 1.0)
    if circles:
        traces.append(line(go, curves(circles), "separatrix", SEPARATRIX, 2))
    traces += _cone(go, posed)
    for k, transfer in enumerate(plan.transfers):
        if transfer.momentum:
            traces += _transfer(go, transfer, f"transfer {k + 1}", COLOURS[k % len(COLOURS)])
    traces += body_axes(go, 1.15)
    labels = [f"M{k}/|M|" for k in "₁₂₃"]
    return figure(traces, f"Momenta that arrive in {plan.best.duration:g} s", labels, 1.15)


def cone(curves_of: Arcs) -> list[np.ndarray]:
    """The arcs as curves (N, 3)."""
    return [
        curves_of.direction(np.linspace(begin, end, AN_ARC), np.full(AN_ARC, k))
        for k, (begin, end) in enumerate(curves_of.ends)
    ]


def _cone(go: Any, posed: Problem) -> Iterator[Any]:
    """Nothing for a sphere, whose momentum has the direction of its rates."""
    parts = cone(arcs(posed))
    if parts:
        name = "one of each polhode" if is_symmetry(posed) else "cone of directions"
        yield line(go, curves(parts), name, CONE, 7)


def _transfer(go: Any, transfer: "Transfer", name: str, colour: str) -> Iterator[Any]:
    motion = transfer.motion
    size = float(np.linalg.norm(momentum(motion)))
    rates = motion(np.linspace(0, transfer.duration, ON_THE_WAY))[1]
    way = moments(motion) * rates / size
    begin = dot(go, way[0], f"{name}, begins", colour, showlegend=motion.regime.steady)
    if motion.regime.steady:
        yield begin
        return
    whole = moments(motion) * polhode(motion, AROUND) / size
    yield line(go, whole, f"{name}, polhode", colour, 2, showlegend=False)
    yield line(go, way, name, colour, 8)
    yield from (begin, dot(go, way[-1], f"{name}, ends", GREY, showlegend=False))
