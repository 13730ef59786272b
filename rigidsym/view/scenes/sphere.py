"""The momentum sphere: all motions of one body with one momentum, and where they part."""

from collections.abc import Iterator
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.errors import InputError
from rigidsym.solution.polhode import Regime
from rigidsym.view.geometry import (
    great_circles,
    members,
    moments,
    momentum,
    polhode,
    separatrix,
)
from rigidsym.view.labels import MOMENTUM_AXES
from rigidsym.view.palette import GREY, GRID
from rigidsym.view.protocols import Motion
from rigidsym.view.regimes import REGIMES
from rigidsym.view.scenes.scene import (
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

AROUND = 121
SEPARATRIX = REGIMES[Regime.SEPARATRIX]


def momentum_sphere(motion: Motion, family: int = 5) -> "Figure":
    """The sphere |M| = K in body axes with polhodes coloured by regime, and this motion's own.

    `family` polhodes about each end of each axis; on the separatrix K^2 = 2H c_b.  Momenta in
    kg m^2/s.  Raises InputError for a body at rest, and ImportError without plotly.
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
    """A sphere with its great circles, which what is drawn on it stands out from."""
    circles = sketch(go, curves(great_circles(radius)), "sphere", GRID, 1, showlegend=False)
    return [skin(go, 0.985 * radius * ball(19, 37), GREY, 0.18), circles]


def _family(go: ModuleType, motion: Motion, size: float, count: int) -> Iterator["Trace"]:
    """One trace for each regime."""
    found: dict[Regime, list[np.ndarray]] = {}
    for other in members(motion, size, count):
        found.setdefault(other.regime, []).append(moments(motion) * polhode(other, AROUND))
    for regime, parts in found.items():
        yield line(go, curves(parts), str(regime), REGIMES[regime], 2.5)


def _own(go: ModuleType, motion: Motion) -> Iterator["Trace"]:
    """The polhode of the motion itself, and where it begins."""
    colour = REGIMES[motion.regime]
    if not motion.regime.steady:
        points = moments(motion) * polhode(motion, 2 * AROUND - 1)
        yield line(go, points, "this motion", colour, 8)
    yield dot(go, momentum(motion), "t = 0", colour)
