"""The tumbling body in inertial space, alone and beside its momentum sphere.

The body is a box of uniform density with the moments of inertia of the motion.
"""

from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym._inputs import Times
from rigidsym.quaternions import rotated
from rigidsym.view._geometry import chosen, moments, momentum
from rigidsym.view._style import AXES, GREY, MARK, SIDES
from rigidsym.view.scenes._scene import (
    dot,
    figure,
    line,
    plotly,
    with_slider,
)
from rigidsym.view.scenes._sphere import momentum_sphere

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure

    from rigidsym.motion import TorqueFreeMotion

FRAMES, PATH = 145, 1201
"Frames of the slider, and points of the path of an axis."
THINNEST = 0.04
"The least edge of a box, its longest being 1."
PAIR_FRAMES, PAIR_FAMILY, PAIR_WIDTH, PAIR_HEIGHT = 73, 3, 980, 640
_LEFT, _RIGHT = [0.0, 0.49], [0.51, 1.0]
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2
# Two triangles a side, sides in the order of the axes they lie across.
_TRIANGLES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1)]
_TRIANGLES += [(2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def edges(inertia: np.ndarray) -> np.ndarray:
    """Return the edges (3,) of a box with these moments: a_1^2 ~ c_2 + c_3 - c_1.

    The longest is 1; none is shorter than `THINNEST`.
    """
    squares = np.maximum(np.sum(inertia) - 2 * inertia, 0.0)
    return np.maximum(np.sqrt(squares / np.max(squares)), THINNEST)


def tumbling_body(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the body in inertial space, with the path of one axis and a slider for the time.

    The axis is the body axis nearest to the momentum at t = 0, which flips where a motion nears
    the separatrix.  Lengths are relative.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion to draw.
    times : array_like, shape (N,), optional
        Times of the slider, s; by default they cover two periods or a few turns.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    InputError
        For fewer than two times.
    ImportError
        If plotly is not installed.
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
    """Return the box, the followed axis, and its end, at an attitude."""
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


def _momentum(go: ModuleType, motion: "TorqueFreeMotion") -> list["Trace"]:
    """Return the constant direction of the momentum; nothing for a body at rest."""
    vector = rotated(motion(0.0)[0], momentum(motion))
    length = float(np.linalg.norm(vector))
    if not length:
        return []
    ends = np.outer((-1.0, 1.0), vector / length)
    return [line(go, ends, "momentum", GREY, 3)]


def sphere_and_body(motion: "TorqueFreeMotion", times: Times | None = None) -> "Figure":
    """Draw the momentum sphere in body axes beside the body in inertial space.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion to draw; the title is its regime.
    times : array_like, shape (N,), optional
        Times of the slider that moves both, s; by default they cover two periods or a few turns.

    Returns
    -------
    plotly.graph_objects.Figure

    Raises
    ------
    InputError
        For a body at rest, and for fewer than two times.
    ImportError
        If plotly is not installed.
    """
    go = plotly("sphere_and_body")
    shown = chosen(motion, times, PAIR_FRAMES)
    whole, body = momentum_sphere(motion, PAIR_FAMILY), tumbling_body(motion, shown)
    here = moments(motion) * motion(shown)[1]
    dots = [dot(go, point, "momentum now", MARK) for point in here]
    count = len(whole.data)
    whole.add_traces([dots[0], *(trace.update(scene="scene2") for trace in body.data)])
    moving = [count, *(count + 1 + k for k in body.frames[0].traces)]
    frames = [
        [now, *(trace.update(scene="scene2") for trace in frame.data)]
        for now, frame in zip(dots, body.frames, strict=True)
    ]
    whole.update_layout(
        title={"text": str(motion.regime)},
        width=PAIR_WIDTH,
        height=PAIR_HEIGHT,
        scene={"domain": {"x": _LEFT, "y": [0.0, 1.0]}},
        scene2=body.layout.scene.to_plotly_json() | {"domain": {"x": _RIGHT, "y": [0.0, 1.0]}},
    )
    return with_slider(go, whole, np.asarray(shown), moving, frames)
