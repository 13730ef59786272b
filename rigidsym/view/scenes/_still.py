"""Plotly figures with a still image for readers without JavaScript."""

import io
import math
from base64 import b64encode
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np
from plotly.graph_objects import Figure

from rigidsym.view._style import GREY

if TYPE_CHECKING:
    from mpl_toolkits.mplot3d import Axes3D
    from plotly.graph_objs.layout import Scene

SIZE, DPI = (6.6, 5.8), 90
# plotly's widths are in pixels, matplotlib's in points; on a smaller picture lines are thinner.
_THINNER = 0.4


class Picture(Figure):
    """Plotly figure that also has a JPEG image for notebook readers without JavaScript.

    It is no PNG, because JupyterLab's extension would show that instead of the figure.
    """

    def show(self, *args: object, **kwargs: object) -> None:
        """Show the figure as plotly does, with its JPEG image in a notebook."""
        bundle = {} if args or kwargs else super()._repr_mimebundle_()
        if not bundle:
            super().show(*args, **kwargs)
            return
        from IPython.display import display

        # There is no still without matplotlib, nor of traces that it cannot draw.
        with suppress(ImportError, LookupError, TypeError, ValueError):
            bundle |= {"image/jpeg": b64encode(still(self)).decode()}
        display(bundle, raw=True)

    def _ipython_display_(self) -> None:
        self.show()


def still(picture: Figure) -> bytes:
    """Draw the initial view of a plotly figure as a JPEG image.

    Lines, points, surfaces and triangles are drawn, scenes beside each other.  Raises KeyError for
    other traces, and ImportError without matplotlib.
    """
    from matplotlib.figure import Figure as Flat

    scenes = sorted({trace.scene or "scene" for trace in picture.data}) or ["scene"]
    size = SIZE[0] * (1.5 if len(scenes) > 1 else 1.0), SIZE[1]
    figure = Flat(figsize=size, layout="constrained")
    for place, scene in enumerate(scenes, 1):
        axes = figure.add_subplot(1, len(scenes), place, projection="3d")
        for trace in picture.data:
            if (trace.scene or "scene") == scene:
                _draw(axes, trace)
        _dress(axes, picture.layout[scene])
    figure.suptitle(picture.layout.title.text or "", color=GREY, size=11)
    if any(axes.get_legend_handles_labels()[1] for axes in figure.axes):
        figure.legend(
            loc="outside lower center", ncols=3, frameon=False, labelcolor=GREY, fontsize=8
        )
    buffer = io.BytesIO()
    figure.savefig(buffer, format="jpeg", dpi=DPI, pil_kwargs={"quality": 80})
    return buffer.getvalue()


def _draw(axes: "Axes3D", trace: Any) -> None:
    """Draw one plotly trace of the type scatter3d, surface or mesh3d."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    points = [np.asarray(trace[name], dtype=float) for name in "xyz"]
    match trace.type:
        case "scatter3d":
            name = "_nolegend_" if trace.showlegend is False else trace.name
            if "lines" in (trace.mode or "lines"):
                width = _THINNER * (trace.line.width or 2)
                style = {"color": trace.line.color, "linewidth": width}
            else:
                style = {"color": trace.marker.color, "markersize": trace.marker.size or 5}
                style |= {"marker": "o", "linestyle": "none"}
            axes.plot(*points, label=name, **style)
        case "surface":
            colour, opacity = trace.colorscale[0][1], trace.opacity
            axes.plot_surface(*points, color=colour, alpha=opacity, linewidth=0, shade=False)
        case "mesh3d":
            corners = np.stack([trace.i, trace.j, trace.k], axis=1).astype(int)
            sides = np.stack(points, axis=1)[corners]
            colours = list(trace.facecolor)
            axes.add_collection3d(Poly3DCollection(sides, facecolors=colours, zsort="min"))
        case other:
            raise KeyError(other)


def _dress(axes: "Axes3D", scene: "Scene") -> None:
    """Apply the cube, the labels and the camera of a plotly scene to matplotlib axes."""
    from matplotlib.ticker import MaxNLocator

    eye = scene.camera.eye
    azimuth = math.degrees(math.atan2(eye.y, eye.x))
    axes.view_init(math.degrees(math.atan2(eye.z, math.hypot(eye.x, eye.y))), azimuth)
    axes.set_box_aspect((1, 1, 1))
    for letter in "xyz":
        one = getattr(axes, f"{letter}axis")
        given = scene[f"{letter}axis"]
        getattr(axes, f"set_{letter}lim")(*given.range)
        getattr(axes, f"set_{letter}label")(given.title.text, color=GREY, size=8)
        one.set_major_locator(MaxNLocator(4))
        one.set_pane_color((1, 1, 1, 0))
        one.set_tick_params(labelsize=7, labelcolor=GREY)
