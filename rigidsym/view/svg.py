"""Line plots as SVG text: no dependency, and the same bytes everywhere.

Kept to what a report needs: anything richer is for a plotting library.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from rigidsym.view.palette import SERIES

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 250, 70, 90, 28, 42


@dataclass(frozen=True, slots=True)
class Panel:
    """Lines over common abscissae, with a title and axis labels in units.

    With `log`, both axes are logarithmic, and a line leaves out what it has no number for (None).
    colours: of the lines, in their order, begun anew where they are too few.
    With `marked`, what was measured is a dot, and lines only lead from one to the next.
    """

    title: str
    x_label: str
    y_label: str
    x: Sequence[float]
    lines: Mapping[str, Sequence[float | None]]
    log: bool = False
    colours: Sequence[str] = SERIES
    marked: bool = False


def svg(panels: Sequence[Panel]) -> str:
    """Panels under each other, as one SVG document."""
    height = HEIGHT * len(panels)
    body = [_panel(panel, k * HEIGHT) for k, panel in enumerate(panels)]
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        f'width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="12">'
    )
    background = f'<rect width="{WIDTH}" height="{height}" fill="white"/>'
    return "\n".join([head, background, *body, "</svg>", ""])


def _panel(panel: Panel, offset: int) -> str:
    place = math.log10 if panel.log else float
    least, label = (1.0, "1e{:g}") if panel.log else (0.0, "{:g}")
    xs = [place(x) for x in panel.x]
    lines = {
        name: [(x, place(y)) for x, y in zip(xs, line, strict=True) if y is not None]
        for name, line in panel.lines.items()
    }
    values = [y for points in lines.values() for _, y in points]
    x_ticks = ticks(min(xs), max(xs), least)
    y_ticks = ticks(min(values), max(values), least)
    x_of = scale(x_ticks, LEFT, WIDTH - RIGHT)
    y_of = scale(y_ticks, offset + HEIGHT - BOTTOM, offset + TOP)
    parts = [_text((LEFT + WIDTH - RIGHT) / 2, offset + 18, panel.title, "middle")]
    for tick in x_ticks:
        parts.append(_line(x_of(tick), y_of(y_ticks[0]), x_of(tick), y_of(y_ticks[-1])))
        parts.append(_text(x_of(tick), offset + HEIGHT - BOTTOM + 16, label.format(tick), "middle"))
    for tick in y_ticks:
        parts.append(_line(LEFT, y_of(tick), WIDTH - RIGHT, y_of(tick)))
        parts.append(_text(LEFT - 6, y_of(tick) + 4, label.format(tick), "end"))
    parts.append(_text((LEFT + WIDTH - RIGHT) / 2, offset + HEIGHT - 8, panel.x_label, "middle"))
    middle = offset + (TOP + HEIGHT - BOTTOM) / 2
    turned = f' transform="rotate(-90 16 {middle:.1f})"'
    parts.append(_text(16, middle, panel.y_label, "middle", turned))
    for k, (name, line) in enumerate(lines.items()):
        points = " ".join(f"{x_of(x):.2f},{y_of(y):.2f}" for x, y in line)
        colour = panel.colours[k % len(panel.colours)]
        parts.append(
            f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"/>'
        )
        if panel.marked:
            parts += [
                f'<circle cx="{x_of(x):.2f}" cy="{y_of(y):.2f}" r="3" fill="{colour}"/>'
                for x, y in line
            ]
        legend = _text(WIDTH - RIGHT + 10, offset + TOP + 16 + 18 * k, name, "start")
        parts.append(legend.replace("<text", f'<text fill="{colour}"'))
    return "\n".join(parts)


def scale(ends: Sequence[float], first: float, last: float) -> Callable[[float], float]:
    """Where values lie in a picture: linear, the ends of their range at `first` and `last`."""
    span = ends[-1] - ends[0]
    return lambda value: first + (value - ends[0]) / span * (last - first)


def ticks(low: float, high: float, least: float) -> list[float]:
    """About six round numbers that cover low to high, at least so far apart."""
    span = (high - low) or abs(high) or 1.0
    raw = max(span / 5, least)
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(power * k for k in (1, 2, 5, 10) if power * k >= raw * (1 - 1e-9))
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [k * step for k in range(first, max(last, first + 1) + 1)]


def _line(x1: float, y1: float, x2: float, y2: float) -> str:
    return f'<line x1="{x1:.2f}" y1="{y1:.2f}" x2="{x2:.2f}" y2="{y2:.2f}" stroke="#ddd"/>'


def _text(x: float, y: float, text: str, anchor: str, extra: str = "") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{text}</text>'
