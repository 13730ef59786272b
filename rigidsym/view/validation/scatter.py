"""Worst errors against a property of their cases: both axes logarithmic, a mark for each decade."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from rigidsym.validate.bounds import ULP
from rigidsym.view.html.markup import Markup, join, lines, tag
from rigidsym.view.report_data import ByMeasure, Cell, Figure, Implementation
from rigidsym.view.validation import figures, source
from rigidsym.view.validation.axis import Axis, fitted
from rigidsym.view.validation.drawing import line, write
from rigidsym.view.validation.marks import colour, mark

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 480, 270, 76, 14, 12, 46
SLOT_X, SLOT_Y = 40.0, 22.0
# Errors below this are drawn as one, in decades: rounding of doubles ends above it.
LEAST = -18
# How far marks of one decade lie apart: all implementations together, and two of them at most.
SPREAD, MOST = 14.0, 5.0
# How far apart labels have to be.
ROOM_X, ROOM_Y = 33.0, 14.0


@dataclass(frozen=True, slots=True)
class Point:
    """The mark of implementation k: exponents, pixels aside of others, and what is said of it."""

    k: int
    x: float
    y: float
    aside: float
    title: str


@dataclass(frozen=True, slots=True)
class Labels:
    """What the axes show, and what zero is called on the first, and what is beyond its decades."""

    x: str
    y: str
    zero: str = "0"
    beyond: str = "∞"


def scatter(
    implementations: Sequence[Implementation],
    view: ByMeasure,
    measure: str,
    bound: float,
    labels: Labels,
) -> Markup:
    """The SVG of one view by one measure; `bound` in units of 2^-53."""
    points = [
        point
        for k, one in enumerate(implementations)
        for point in _points(k, one, len(implementations), view, measure)
    ]
    limit = math.log10(bound * ULP)
    x = fitted([p.x for p in points], LEFT, WIDTH - RIGHT, SLOT_X)
    y = fitted([limit, *(p.y for p in points)], HEIGHT - BOTTOM, TOP, SLOT_Y, LEAST)
    return tag(
        "svg",
        "\n",
        lines(
            _frame(x, y),
            _x_labels(x, labels),
            _y_labels(y, labels),
            line("bound", LEFT, y.at(limit), WIDTH - RIGHT, y.at(limit)),
            *(_trace(k, points, x, y) for k in range(len(implementations))),
            *(mark(p.k, x.at(p.x) + p.aside, y.at(p.y), p.title) for p in points),
            _limit(y.at(limit), bound),
        ),
        "\n",
        class_="plot",
        viewBox=f"0 0 {WIDTH} {HEIGHT}",
        role="img",
        aria_label=f"{labels.y} against {labels.x}, the worst of each decade",
    )


def _points(k: int, one: Implementation, count: int, view: ByMeasure, measure: str) -> list[Point]:
    """In the order of their decades, beside those of other implementations."""
    aside = (k - (count - 1) / 2) * min(SPREAD / count, MOST)
    found = sorted((figures.decade(part), cell) for part, cell in one[view][measure].items())
    return [
        Point(k, at + 0.5, _exponent(cell["units"]), aside, _title(one["name"], at, cell))
        for at, cell in found
    ]


def _exponent(figure: Figure) -> float:
    value = figures.number(figure) * ULP
    return math.log10(value) if value else -math.inf


def _title(name: str, exponent: float, cell: Cell) -> str:
    if math.isinf(exponent):
        decade = "beyond all" if exponent > 0 else "0"
    else:
        decade = f"{figures.power(10, exponent)} to {figures.power(10, exponent + 1)}"
    size = f"{figures.plain(cell['units'])} = {figures.counted(cell['units'])}"
    if math.isinf(figures.number(cell["units"])):
        size = "no number"
    return f"{name}, {decade}\n{cell['count']} states, worst {size}\n{source.place(cell)}"


def _frame(x: Axis, y: Axis) -> Markup:
    """The area, grid lines, and lines that part scales and places at the ends."""
    area = tag(
        "rect", class_="area", x=x.first, y=y.last, width=x.last - x.first, height=y.first - y.last
    )
    across = [line("grid", x.first, y.at(tick), x.last, y.at(tick)) for tick in y.ticks]
    up = [line("grid", x.at(tick), y.first, x.at(tick), y.last) for tick in x.ticks]
    parts = [line("part", edge, y.first, edge, y.last) for edge in x.edges]
    parts += [line("part", x.first, edge, x.last, edge) for edge in y.edges]
    return join(area, *across, *up, *parts)


def _x_labels(x: Axis, labels: Labels) -> Markup:
    below = HEIGHT - BOTTOM + 16
    ticks = x.labelled(ROOM_X)
    written = [write(x.at(tick), below, figures.power(10, tick)) for tick in ticks]
    if x.under:
        written.append(write(x.at(-math.inf), below, labels.zero))
    if x.over:
        written.append(write(x.at(math.inf), below, labels.beyond))
    title = write((x.first + x.last) / 2, HEIGHT - 8, labels.x, class_="label")
    return join(*written, title)


def _y_labels(y: Axis, labels: Labels) -> Markup:
    named = [(tick, figures.power(10, tick)) for tick in y.labelled(ROOM_Y)]
    if y.under:
        named.append((-math.inf, f"< {figures.power(10, y.low)}"))
    if y.over:
        named.append((math.inf, "none"))
    written = [write(LEFT - 6, y.at(exponent) + 4, name, "end") for exponent, name in named]
    middle = (y.first + y.last) / 2
    turned = f"rotate(-90 14 {middle:g})"
    return join(*written, write(14, middle, labels.y, class_="label", transform=turned))


def _limit(at: float, bound: float) -> Markup:
    """Over the marks, so that it can be read among them."""
    return write(WIDTH - RIGHT - 4, at - 5, f"bound {figures.plain(bound)}", "end", "limit")


def _trace(k: int, points: Sequence[Point], x: Axis, y: Axis) -> Markup:
    """A line through the marks of one implementation; what has a place of its own is not on it."""
    inside = [p for p in points if p.k == k and math.isfinite(p.x) and y.low <= p.y <= y.high]
    path = " ".join(f"{x.at(p.x) + p.aside:.2f},{y.at(p.y):.2f}" for p in inside)
    return tag("polyline", class_=f"trace {colour(k)}", points=path)
