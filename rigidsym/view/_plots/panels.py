"""Panels of lines over common abscissae, below each other, as the text of an SVG."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rigidsym.view._plots.figure import blank, defaults, legend, svg, tidy
from rigidsym.view._style import SERIES


@dataclass(frozen=True, slots=True)
class Panel:
    """Lines over common abscissae, with a title and axis labels in units.

    A line leaves out values that are None.  With `log`, both axes are logarithmic.  `colours`
    repeat where there are more lines.  With `marked`, each value is a dot.
    """

    title: str
    x_label: str
    y_label: str
    x: Sequence[float]
    lines: Mapping[str, Sequence[float | None]]
    log: bool = False
    colours: Sequence[str] = SERIES
    marked: bool = False


@defaults()
def panels_svg(panels: Sequence[Panel]) -> str:
    """Return panels below each other as one SVG document."""
    figure = blank("drawing", 10.0, 3.2 * len(panels))
    for axes, panel in zip(figure.subplots(len(panels), squeeze=False)[:, 0], panels, strict=True):
        for k, (name, values) in enumerate(panel.lines.items()):
            points = [(x, y) for x, y in zip(panel.x, values, strict=True) if y is not None]
            axes.plot(
                *zip(*points, strict=True) if points else ((), ()),
                color=panel.colours[k % len(panel.colours)],
                label=name,
                linewidth=1.5,
                marker="o" if panel.marked else "",
                markersize=4,
                gid=f"line {panel.title}: {name}",
            )
        axes.set(title=panel.title, xlabel=panel.x_label, ylabel=panel.y_label)
        if panel.log:
            axes.set(xscale="log", yscale="log")
        tidy(axes)
        legend(axes)
    return svg(figure, {"svg.fonttype": "none"})
