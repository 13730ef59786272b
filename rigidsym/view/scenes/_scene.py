"""Lines, surfaces, scenes and time sliders of three-dimensional plotly pictures.

Traces are dicts of plotly's settings.  Colours other than those of the data are grey and
translucent, for light and for dark pages.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym.view._geometry import rounded
from rigidsym.view._style import FAINT, GREY, GRID

if TYPE_CHECKING:
    from plotly.graph_objects import Figure as Figure

WIDTH, HEIGHT = 760, 680
_HEAD = 108
"Pixels above the axes, for the title and three rows of the legend."
_FRAME_MS = 60
Trace = dict[str, Any]


def coordinates(points: np.ndarray) -> Trace:
    """Return the coordinates of points as plotly's settings x, y and z."""
    return dict(zip("xyz", np.moveaxis(points, -1, 0), strict=True))


def line(points: np.ndarray, name: str, colour: str, width: float, **how: object) -> Trace:
    """Return the plotly trace of a curve through points."""
    style = {"color": colour, "width": width}
    return _scatter(rounded(points), name, mode="lines", line=style, **how)


def sketch(points: np.ndarray, name: str, colour: str, width: float, **how: object) -> Trace:
    """Return the plotly trace of a curve in single precision, without hover text."""
    style = {"color": colour, "width": width}
    return _scatter(_single(points), name, mode="lines", line=style, hoverinfo="skip", **how)


def dot(point: np.ndarray, name: str, colour: str, **how: object) -> Trace:
    """Return the plotly trace of a marker at a point."""
    marker = {"color": colour, "size": 5}
    return _scatter(rounded(point)[None], name, mode="markers", marker=marker, **how)


def _scatter(points: np.ndarray, name: str, **how: object) -> Trace:
    return {"type": "scatter3d", **coordinates(points), "name": name, **how}


def skin(points: np.ndarray, colour: str, opacity: float) -> Trace:
    """Return the plotly trace of a translucent surface in one colour.

    The shape of its points is (N, M, 3).
    """
    return {
        "type": "surface",
        **coordinates(_single(points)),
        "colorscale": [[0, colour], [1, colour]],
        "opacity": opacity,
        "showscale": False,
        "hoverinfo": "skip",
        "lighting": {"ambient": 0.75, "diffuse": 0.4, "specular": 0.05},
    }


def _single(points: np.ndarray) -> np.ndarray:
    """Round coordinates to six digits and convert them to float32."""
    size = float(np.nanmax(np.abs(points), initial=0.0)) or 1.0
    return (np.round(points / size, 6) * size + 0.0).astype(np.float32)


def ball(rows: int, columns: int) -> np.ndarray:
    """Return a grid of points on the unit sphere.

    Its shape is (rows, columns, 3).
    """
    polar, around = np.meshgrid(
        np.linspace(0, np.pi, rows), np.linspace(0, 2 * np.pi, columns), indexing="ij"
    )
    sine = np.sin(polar)
    return np.stack([sine * np.cos(around), sine * np.sin(around), np.cos(polar)], axis=2)


def figure(traces: Sequence[Trace], title: str, labels: Sequence[str], half: float) -> "Figure":
    """Return a plotly figure with traces in a cube with labelled axes.

    half: half the width of the cube.
    """
    # This import needs plotly, which the caller has.
    from rigidsym.view.scenes._still import Picture

    axis = {
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
    axes = {
        f"{letter}axis": {"title": {"text": label, "font": {"size": 11}}, **axis}
        for letter, label in zip("xyz", labels, strict=True)
    }
    scene = axes | {
        "aspectmode": "cube",
        "domain": {"x": [0.0, 1.0], "y": [0.0, 1.0]},
        "camera": {"center": {"x": 0, "y": 0, "z": -0.12}, "eye": {"x": 1.45, "y": 1.1, "z": 0.75}},
    }
    # The legend is above the axes, where it hides nothing.
    legend = {
        "orientation": "h",
        "x": 0.0,
        "y": 1.0,
        "yanchor": "bottom",
        "itemsizing": "constant",
        "bgcolor": "rgba(0,0,0,0)",
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
            "legend": legend,
            "template": "none",
        },
    )


def with_slider(
    figure: "Figure", times: np.ndarray, moving: Sequence[int], frames: Sequence[Sequence[Any]]
) -> "Figure":
    """Add a time slider and an animation with play and stop buttons to a figure.

    The figure gets a frame for each time.  moving: the indices of the traces that frames replace.
    """
    figure.frames = [
        {"name": str(k), "data": list(data), "traces": list(moving)}
        for k, data in enumerate(frames)
    ]

    def shown(frames: object, duration: int = 0, **more: bool) -> dict[str, object]:
        """Return the plotly settings of a control that shows the named frames."""
        how = {
            "mode": "immediate",
            "frame": {"duration": duration, "redraw": True},
            "transition": {"duration": 0},
        }
        return {"method": "animate", "args": [frames, how | more]}

    quiet = {"bgcolor": FAINT, "bordercolor": FAINT}
    slider = {
        "steps": [{"label": f"{t:.4g}", **shown([str(k)])} for k, t in enumerate(times)],
        "currentvalue": {"prefix": "t = ", "suffix": " s", "xanchor": "center"},
        "x": 0.14,
        "len": 0.82,
        "y": 0,
        "pad": {"t": 12, "b": 8},
        "ticklen": 0,
        "minorticklen": 0,
        "font": {"size": 10},
    }
    play = {"label": "▶", **shown(None, _FRAME_MS, fromcurrent=True)}
    buttons = {
        "type": "buttons",
        "direction": "left",
        "buttons": [play, {"label": "❚❚", **shown([None])}],
        "showactive": False,
        "x": 0.12,
        "y": 0,
        "xanchor": "right",
        "yanchor": "top",
        "pad": {"t": 22, "r": 8},
    }
    controls = {"sliders": [slider | quiet], "updatemenus": [buttons | quiet]}
    figure.update_layout(**controls, margin={"b": 70})
    return figure
