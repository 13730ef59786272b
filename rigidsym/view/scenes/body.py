"""The tumbling body: a box of uniform density with the moments of inertia, as it turns in space."""

from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.inputs import Times
from rigidsym.quaternions import rotated
from rigidsym.view.geometry import moments, momentum
from rigidsym.view.palette import AXES, GREY, SIDES
from rigidsym.view.protocols import Motion
from rigidsym.view.scenes.scene import (
    dot,
    figure,
    line,
    plotly,
    with_slider,
)
from rigidsym.view.times import chosen

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure

FRAMES = 145
PATH = 1201
THINNEST = 0.04
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2
# Two triangles a side, sides in the order of the axes they lie across.
_TRIANGLES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1)]
_TRIANGLES += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def edges(inertia: np.ndarray) -> np.ndarray:
    """The edges of a box with these moments, up to a common factor: a_1^2 ~ c_2 + c_3 - c_1.

    The longest is 1; none is thinner than can be seen.
    """
    squares = np.maximum(np.sum(inertia) - 2 * inertia, 0.0)
    return np.maximum(np.sqrt(squares / np.max(squares)), THINNEST)


def tumbling_body(motion: Motion, times: Times | None = None) -> "Figure":
    """The body in inertial space, with the path of one axis; a slider moves `times` (N,), s.

    The axis is the body axis nearest to the momentum at t = 0, which flips where a motion nears
    the separatrix.  Lengths are relative.  Raises ImportError without plotly.
    """
    go = plotly("tumbling_body")
    shown = chosen(motion, times, FRAMES)
    q, _ = motion(shown)
    path, _ = motion(np.linspace(shown[0], shown[-1], PATH))
    size, axis = edges(moments(motion)), int(np.argmax(np.abs(momentum(motion))))
    tip = np.eye(3)[axis] * (0.5 * size[axis] + 0.3)
    frames = [_moving(go, attitude, size, tip, axis) for attitude in q]
    trail = line(go, rotated(path, tip), f"path of axis {axis + 1}", AXES[axis], 3)
    fixed = [trail, *_momentum(go, motion)]
    half = 1.1 * max(float(np.linalg.norm(size)) / 2, float(np.max(tip)), 0.75)
    labels = [f"{k} (inertial)" for k in "xyz"]
    whole = figure([*frames[0], *fixed], f"Tumbling: {motion.regime}", labels, half)
    return with_slider(go, whole, shown, range(len(frames[0])), frames)


def _moving(
    go: ModuleType, q: np.ndarray, size: np.ndarray, tip: np.ndarray, axis: int
) -> list["Trace"]:
    """The box, the axis that is followed, and its end."""
    x, y, z = np.round(rotated(q, size * _CORNERS), 6).T + 0.0
    i, j, k = np.array(_TRIANGLES).T
    box = go.Mesh3d(
        x=x,
        y=y,
        z=z,
        i=i,
        j=j,
        k=k,
        facecolor=[colour for colour in SIDES for _ in range(2)],
        flatshading=True,
        hoverinfo="skip",
        lighting={"ambient": 0.8, "diffuse": 0.35, "specular": 0.1},
    )
    end, colour = rotated(q, tip), AXES[axis]
    return [
        box,
        line(go, np.stack([0 * end, end]), f"axis {axis + 1}", colour, 6),
        dot(go, end, f"axis {axis + 1}", colour, showlegend=False),
    ]


def _momentum(go: ModuleType, motion: Motion) -> list["Trace"]:
    """The direction of the momentum, which stays; nothing for a body at rest."""
    vector = rotated(motion(0.0)[0], momentum(motion))
    length = float(np.linalg.norm(vector))
    if not length:
        return []
    ends = np.outer((-1.0, 1.0), vector / length)
    return [line(go, ends, "momentum", GREY, 3)]
