"""Directions of momenta on a sphere: where they can begin, and the ways that they take."""

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from types import ModuleType
from typing import TYPE_CHECKING, Protocol

import numpy as np

from rigidsym.view.geometry import moments, momentum, polhode, separatrix
from rigidsym.view.labels import DIRECTION_AXES
from rigidsym.view.palette import CONE, GREY, TRANSFERS
from rigidsym.view.protocols import Motion
from rigidsym.view.scenes.scene import body_axes, curves, dot, figure, line, plotly
from rigidsym.view.scenes.sphere import SEPARATRIX, globe

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure

AROUND, ON_THE_WAY = 121, 361


class Transfer(Protocol):
    """A motion that is followed for some time."""

    @property
    def motion(self) -> Motion:
        """What it is a part of."""
        ...

    @property
    def duration(self) -> float:
        """From t = 0 on, s."""
        ...


def scene(
    inertia: Sequence[Fraction],
    cone: tuple[str, Sequence[np.ndarray]],
    transfers: Mapping[str, Transfer],
    title: str,
) -> "Figure":
    """The unit sphere with its separatrix, the curves of a cone by their name, and transfers."""
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


def _transfer(go: ModuleType, transfer: Transfer, name: str, colour: str) -> Iterator["Trace"]:
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
