"""Parts of the pictures in three dimensions: lines, surfaces, scenes and the time slider.

Colours other than those of the data are grey and translucent, for light and for dark pages.
"""

from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from rigidsym.errors import package
from rigidsym.view._geometry import rounded
from rigidsym.view._style import AXES, FAINT, GREY, GRID

if TYPE_CHECKING:
    from plotly.basedatatypes import BaseTraceType as Trace
    from plotly.graph_objects import Figure as Figure

WIDTH, HEIGHT = 760, 680
_HEAD = 108
"Pixels above the axes, for the title and three rows of the legend."
_FRAME_MS = 60
# Nested settings of plotly, by name.
Layout = dict[str, object]


def plotly(user: str) -> ModuleType:
    """Return plotly's graph objects; raises ImportError in the name of `user` without plotly."""
    return package("plotly.graph_objects", user)


def line(
    go: ModuleType, points: np.ndarray, name: str, colour: str, width: float, **how: bool
) -> "Trace":
    """Return a curve (N, 3)."""
    x, y, z = rounded(points).T
    style = {"color": colour, "width": width}
    return go.Scatter3d(x=x, y=y, z=z, mode="lines", name=name, line=style, **how)


def sketch(
    go: ModuleType, points: np.ndarray, name: str, colour: str, width: float, **how: bool
) -> "Trace":
    """Return a curve (N, 3) in four bytes a number, without values under the pointer."""
    x, y, z = _single(points).T
    style = {"color": colour, "width": width}
    return go.Scatter3d(x=x, y=y, z=z, mode="lines", name=name, line=style, hoverinfo="skip", **how)


def curves(parts: Sequence[np.ndarray]) -> np.ndarray:
    """Join several curves into one, with gaps."""
    gap = np.full((1, 3), np.nan)
    return np.concatenate([piece for part in parts for piece in (part, gap)][:-1])


def dot(go: ModuleType, point: np.ndarray, name: str, colour: str, **how: bool) -> "Trace":
    """Return a point (3,)."""
    x, y, z = rounded(point).reshape(3, 1)
    marker = {"color": colour, "size": 5}
    return go.Scatter3d(x=x, y=y, z=z, mode="markers", name=name, marker=marker, **how)


def skin(go: ModuleType, points: np.ndarray, colour: str, opacity: float) -> "Trace":
    """Return a surface (N, M, 3) in one colour, translucent."""
    x, y, z = np.moveaxis(_single(points), 2, 0)
    return go.Surface(
        x=x,
        y=y,
        z=z,
        colorscale=[[0, colour], [1, colour]],
        opacity=opacity,
        showscale=False,
        hoverinfo="skip",
        lighting={"ambient": 0.75, "diffuse": 0.4, "specular": 0.05},
    )


def _single(points: np.ndarray) -> np.ndarray:
    """Round to six digits in four bytes, which is as much as can be seen."""
    size = float(np.nanmax(np.abs(points), initial=0.0)) or 1.0
    return (np.round(points / size, 6) * size + 0.0).astype(np.float32)


def ball(rows: int, columns: int) -> np.ndarray:
    """Return the unit sphere as a grid (rows, columns, 3)."""
    polar, around = np.meshgrid(
        np.linspace(0, np.pi, rows), np.linspace(0, 2 * np.pi, columns), indexing="ij"
    )
    sine = np.sin(polar)
    return np.stack([sine * np.cos(around), sine * np.sin(around), np.cos(polar)], axis=2)


def body_axes(go: ModuleType, length: float) -> list["Trace"]:
    """Return the positive halves of the three axes."""
    tips = length * np.eye(3)
    return [
        line(go, np.stack([0 * tip, tip]), f"axis {k}", colour, 5, showlegend=False)
        for k, (tip, colour) in enumerate(zip(tips, AXES, strict=True), 1)
    ]


def figure(traces: Sequence["Trace"], title: str, labels: Sequence[str], half: float) -> "Figure":
    """Return a figure whose scene is a cube of half width `half`, axes labelled with units."""
    # This import needs plotly, which the caller has.
    from rigidsym.view.scenes._still import Picture

    names = ("xaxis", "yaxis", "zaxis")
    axes = {name: _axis(label, half) for name, label in zip(names, labels, strict=True)}
    scene = axes | {
        "aspectmode": "cube",
        "domain": {"x": [0.0, 1.0], "y": [0.0, 1.0]},
        "camera": {"center": {"x": 0, "y": 0, "z": -0.12}, "eye": {"x": 1.45, "y": 1.1, "z": 0.75}},
    }
    return Picture(
        data=list(traces),
        layout={
            "title": {"text": title, "x": 0.01, "y": 0.975, "yanchor": "top", "font": {"size": 15}},
            "scene": scene,
            "width": WIDTH,
            "height": HEIGHT,
            "margin": {"l": 0, "r": 0, "t": _HEAD, "b": 0},
            "paper_bgcolor": "rgba(0,0,0,0)",
            "font": {"color": GREY},
            "legend": _LEGEND,
            "template": "none",
        },
    )


# Above the axes, where it hides nothing.
_LEGEND: Layout = {
    "orientation": "h",
    "x": 0.0,
    "y": 1.0,
    "yanchor": "bottom",
    "itemsizing": "constant",
    "bgcolor": "rgba(0,0,0,0)",
}


def _axis(label: str, half: float) -> Layout:
    return {
        "title": {"text": label, "font": {"size": 11}},
        "range": [-half, half],
        "showbackground": False,
        "gridcolor": GRID,
        "showgrid": True,
        "zeroline": False,
        "showline": True,
        "linecolor": GRID,
        "color": GREY,
        "nticks": 5,
        "tickfont": {"size": 10},
        "exponentformat": "power",
    }


def with_slider(
    go: ModuleType,
    figure: "Figure",
    times: np.ndarray,
    moving: Sequence[int],
    frames: Sequence[Sequence["Trace"]],
) -> "Figure":
    """Add a frame for each time and a slider: `moving` are the traces that frames replace."""
    names = [f"{t:.4g}" for t in times]
    figure.frames = [
        go.Frame(name=str(k), data=list(data), traces=list(moving)) for k, data in enumerate(frames)
    ]
    steps = [
        {"label": name, "method": "animate", "args": [[str(k)], _at_once(0)]}
        for k, name in enumerate(names)
    ]
    figure.update_layout(
        sliders=[
            {
                "steps": steps,
                "currentvalue": {"prefix": "t = ", "suffix": " s", "xanchor": "center"},
                "x": 0.14,
                "len": 0.82,
                "y": 0,
                "pad": {"t": 12, "b": 8},
                "ticklen": 0,
                "minorticklen": 0,
                "font": {"size": 10},
                "bgcolor": FAINT,
                "bordercolor": FAINT,
            }
        ],
        updatemenus=[_buttons()],
        margin={"b": 70},
    )
    return figure


def _at_once(duration: int) -> Layout:
    return {
        "mode": "immediate",
        "frame": {"duration": duration, "redraw": True},
        "transition": {"duration": 0},
    }


def _buttons() -> Layout:
    going = [None, _at_once(_FRAME_MS) | {"fromcurrent": True}]
    play = {"label": "▶", "method": "animate", "args": going}
    stop = {"label": "❚❚", "method": "animate", "args": [[None], _at_once(0)]}
    return {
        "type": "buttons",
        "direction": "left",
        "buttons": [play, stop],
        "showactive": False,
        "x": 0.12,
        "y": 0,
        "xanchor": "right",
        "yanchor": "top",
        "pad": {"t": 22, "r": 8},
        "bgcolor": FAINT,
        "bordercolor": FAINT,
    }
