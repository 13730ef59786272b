"""Spheres of angular momenta in body axes: of one motion with its family, and of transfers."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.errors import InputError
from rigidsym.solution._polhode import Regime
from rigidsym.view._geometry import (
    REGIMES,
    SEPARATRIX,
    great_circles,
    members,
    moments,
    momentum,
    polhode,
    separatrix,
)
from rigidsym.view._style import CONE, DIRECTION_AXES, GREY, GRID, MOMENTUM_AXES, TRANSFERS
from rigidsym.view.scenes._scene import (
    ball,
    body_axes,
    curves,
    dot,
    figure,
    line,
    plotly,
    sketch,
    skin,
)

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure

    from rigidsym.manoeuvre._transfer import Transfer
    from rigidsym.motion import TorqueFreeMotion

AROUND, ON_THE_WAY = 121, 361
"Points of a polhode, and of the part of it that a transfer runs through."


def momentum_sphere(motion: "TorqueFreeMotion", family: int = 5) -> "Figure":
    """Draw the sphere |M| = K in body axes with polhodes coloured by regime.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion whose polhode is drawn thick.
    family : int
        Number of further polhodes about each end of each axis.

    Returns
    -------
    plotly.graph_objects.Figure
        Momenta in kg m^2/s; on the separatrix K^2 = 2H c_b.

    Raises
    ------
    InputError
        For a body at rest.
    ImportError
        If plotly is not installed.
    """
    go = plotly("momentum_sphere")
    size = float(np.linalg.norm(momentum(motion)))
    if not size:
        raise InputError("omega0", "zero", "a body at rest has no momentum sphere")
    traces = globe(go, size)
    traces += _family(go, motion, size, family)
    circles = separatrix(motion.exact["inertia"], size)
    if circles:
        traces.append(line(go, curves(circles), "separatrix", SEPARATRIX, 5))
    traces += [*_own(go, motion), *body_axes(go, 1.15 * size)]
    title = f"Momentum sphere, |M| = {size:.4g} kg m²/s"
    return figure(traces, title, MOMENTUM_AXES, 1.15 * size)


def globe(go: ModuleType, radius: float) -> list["Trace"]:
    """Return a sphere and its great circles, a little below what is drawn on it."""
    circles = sketch(go, curves(great_circles(radius)), "sphere", GRID, 1, showlegend=False)
    return [skin(go, 0.985 * radius * ball(19, 37), GREY, 0.18), circles]


def _family(
    go: ModuleType, motion: "TorqueFreeMotion", size: float, count: int
) -> Iterator["Trace"]:
    """Yield the polhodes of `members`, a trace for each regime."""
    found: dict[Regime, list[np.ndarray]] = {}
    for other in members(motion, size, count):
        found.setdefault(other.regime, []).append(moments(motion) * polhode(other, AROUND))
    for regime, parts in found.items():
        yield line(go, curves(parts), str(regime), REGIMES[regime], 2.5)


def _own(go: ModuleType, motion: "TorqueFreeMotion") -> Iterator["Trace"]:
    """Yield the polhode of the motion itself, and its first point."""
    colour = REGIMES[motion.regime]
    if not motion.regime.steady:
        points = moments(motion) * polhode(motion, 2 * AROUND - 1)
        yield line(go, points, "this motion", colour, 8)
    yield dot(go, momentum(motion), "t = 0", colour)


def directions(
    inertia: Sequence[Fraction],
    cone: tuple[str, Sequence[np.ndarray]],
    transfers: Mapping[str, "Transfer"],
    title: str,
) -> "Figure":
    """Draw the unit sphere, its separatrix, a cone (name and curves), and transfers by name."""
    go = plotly("directions_of")
    traces = globe(go, 1.0)
    circles = separatrix(inertia, 1.0)
    if circles:
        traces.append(line(go, curves(circles), "separatrix", SEPARATRIX, 2))
    name, parts = cone
    if parts:
        traces.append(line(go, curves(parts), name, CONE, 7))
    for k, (called, transfer) in enumerate(transfers.items()):
        traces += _transfer(go, transfer, called, TRANSFERS[k % len(TRANSFERS)])
    traces += body_axes(go, 1.15)
    return figure(traces, title, DIRECTION_AXES, 1.15)


def _transfer(go: ModuleType, transfer: "Transfer", name: str, colour: str) -> Iterator["Trace"]:
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
