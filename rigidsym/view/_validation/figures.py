"""Scatter plots and histograms of errors for the validation page.

matplotlib draws them.  Their elements have classes of the page's style sheet, which gives them
colours on light and on dark ground, and titles for the pointer.
"""

import math
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import TYPE_CHECKING, NamedTuple
from xml.etree import ElementTree as ET

import numpy as np
from markupsafe import Markup

from rigidsym.view import _report_data as formats
from rigidsym.view._pages import render
from rigidsym.view._plots.figure import defaults, svg
from rigidsym.view._report_data import MOST_CONDITION, ULP, Data
from rigidsym.view._style import SERIES

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.patches import Rectangle

# Exponents below this are drawn in this part of the axis, so that the others keep theirs.
KNEE, PART = -20.0, 0.22
# Errors below these are drawn as one, in decades and in octaves: rounding of doubles ends above.
LEAST_DECADE, LEAST_OCTAVE = -18, -3
# Offsets of the marks of one decade, in points: all implementations together, and two of them.
SPREAD, MOST = 14.0, 5.0
STEP = 0.5
"Octaves of a bar."
SHORT = 12
"Octaves up to which a tick is labelled by a number instead of a power."
Y_LABELS = {"angle": "angle error (rad)", "omega": "rate error (relative)"}
MARKERS = ("o", "s", "^", "D", "v", "d", "p")
_SVG = "{http://www.w3.org/2000/svg}"
_LINK = "{http://www.w3.org/1999/xlink}href"


@dataclass(frozen=True, slots=True)
class Axis:
    """Logarithmic axis with slots for zero and infinity at its ends.

    low, high: the range of exponents.  Slots are `under` and `over` of the axis long, from 0 to 1;
    0 where they are not needed.
    """

    low: float
    high: float
    under: float = 0.0
    over: float = 0.0

    @property
    def knots(self) -> list[tuple[float, float]]:
        """Points of the piecewise linear scale, as pairs of exponent and position."""
        begin, end = self.under, 1 - self.over
        knots = [(self.low, begin), (self.high, end)]
        if self.low < KNEE < self.high:
            knots.insert(1, (KNEE, begin + PART * (end - begin)))
        return knots

    @property
    def edges(self) -> list[float]:
        """The positions of lines that mark changes of scale and the slots at the ends."""
        ends = [self.under] * bool(self.under) + [1 - self.over] * bool(self.over)
        return ends + [place for _, place in self.knots[1:-1]]

    def at(self, exponent: float) -> float:
        """Return the position of an exponent on the axis, from 0 to 1."""
        if exponent < self.low:
            return self.under / 2
        if exponent > self.high:
            return 1 - self.over / 2
        exponents, places = zip(*self.knots, strict=True)
        return float(np.interp(exponent, exponents, places))

    @property
    def ticks(self) -> list[float]:
        """The exponents at the ticks of the axis.

        There are fewer where the scale is compressed.
        """
        from matplotlib.ticker import MaxNLocator

        def among(low: float, high: float, most: int) -> list[float]:
            locator = MaxNLocator(most, steps=[1, 2, 5, 10], integer=True, min_n_ticks=1)
            return [float(x) for x in locator.tick_values(low, high) if low <= x <= high]

        *far, low, high = [exponent for exponent, _ in self.knots]
        return [x for end in far for x in among(end, low, 2) if x < low] + among(low, high, 6)

    def labels(self, room: float, zero: str, beyond: str, base: int) -> dict[float, str]:
        """Return the labels of slots and ticks by their position.

        Ticks nearer than `room` to a slot have no label.
        """
        ends = {self.at(-math.inf): zero} if self.under else {}
        ends |= {self.at(math.inf): beyond} if self.over else {}
        numbers = base == 2 and self.high - self.low <= SHORT
        named = {x: f"{2.0**x:g}" if numbers else formats.power(base, x) for x in self.ticks}
        free = {self.at(x): name for x, name in named.items()}
        return {x: name for x, name in free.items() if all(abs(x - y) >= room for y in ends)} | ends


def fitted(exponents: Iterable[float], slot: float, least: float = -math.inf) -> Axis:
    """Return the axis that covers a set of exponents.

    Exponents below `least` count as that of zero.
    """
    known = list(exponents)
    inside = [x for x in known if x >= least and math.isfinite(x)] or [0.0]
    low, high = math.floor(min(inside)), math.ceil(max(inside))
    under = slot if min(known, default=low) < low else 0.0
    over = slot if max(known, default=high) > high else 0.0
    return Axis(low, max(high, low + 1), under, over)


class Drawing:
    """Matplotlib figure whose SVG elements have CSS classes and tooltips."""

    def __init__(
        self, size: tuple[float, float], margins: tuple[float, float, float, float]
    ) -> None:
        """Create a figure with axes of a given size and margins, in points.

        Margins are left, bottom, right and top.
        """
        from matplotlib.figure import Figure

        (width, height), (left, bottom, right, top) = size, margins
        self.inner = width - left - right, height - bottom - top
        self.figure = Figure(figsize=(width / 72, height / 72), dpi=72)
        self.axes = self.figure.add_axes(
            (left / width, bottom / height, self.inner[0] / width, self.inner[1] / height)
        )
        self.axes.set(xlim=(0, 1), ylim=(0, 1), xticks=[], yticks=[])
        self.axes.tick_params(length=0, labelsize=12)
        self._named: dict[str, tuple[str, Sequence[str]]] = {}

    def add(self, class_: str, artist: "Artist", titles: Sequence[str] = ()) -> None:
        """Assign a CSS class to an artist, and a tooltip to each of its shapes."""
        name = f"drawn-{len(self._named)}"
        artist.set(gid=name, clip_on=False)
        self._named[name] = class_, titles

    def line(self, class_: str, x: Sequence[float], y: Sequence[float]) -> None:
        """Draw a line, and assign a CSS class to it."""
        (line,) = self.axes.plot(x, y)
        self.add(class_, line)

    def mark(
        self, kind: str, k: int, x: Sequence[float], y: Sequence[float], titles: Sequence[str]
    ) -> None:
        """Draw the marks of the k-th implementation, with a tooltip for each."""
        shape = MARKERS[k % len(MARKERS)]
        (marks,) = self.axes.plot(x, y, marker=shape, markersize=8, linestyle="none")
        self.add(f"{kind} {colour(k)}", marks, titles)

    def svg(self, label: str, class_: str = "plot") -> Markup:
        """Convert the drawing to an SVG element with CSS classes instead of styles."""
        root = ET.fromstring(svg(self.figure, {"svg.fonttype": "none"}))
        markers = {f"#{x.get('id')}": x.get("d") for x in root.iter(f"{_SVG}path")}
        shapes: list[dict[str, str | None]] = []
        words: list[dict[str, str | None]] = []
        for group in root.iter(f"{_SVG}g"):
            class_of, titles = self._named.get(group.get("id") or "", (None, ()))
            texts = group.findall(f"{_SVG}text")
            for text in texts:
                anchor = re.search(r"text-anchor: (\w+)", text.get("style") or "")
                own = {"class": class_of, "anchor": anchor and anchor[1], "text": text.text}
                words.append({**text.attrib, **own})
            if class_of and not texts:
                uses = [*group.iter(f"{_SVG}use")] or [*group.iter(f"{_SVG}path")]
                for shape, title in zip_longest(uses, titles):
                    path = shape.get("d") or markers[shape.attrib[_LINK]] or ""
                    own = {"class": class_of, "title": title, "path": " ".join(path.split())}
                    shapes.append({**shape.attrib, **own})
        names = {"class_": class_, "box": root.get("viewBox"), "label": label}
        return Markup(render("drawing.html", **names, shapes=shapes, words=words))


class View(NamedTuple):
    """Property of cases on the horizontal axis of error plots.

    It has a key in the data, a label, and labels of zero and infinity.
    """

    key: str
    label: str
    zero: str
    beyond: str


VIEWS = (
    View("distance", "distance from the separatrix (1: nothing cancels, 0: on it)", "on it", "∞"),
    View("turned", "angle turned, |ω₀t| (rad)", "t = 0", "∞"),
    View(
        "condition",
        "condition number κ",
        "0",
        f"> {formats.power(10, math.log10(MOST_CONDITION))}",
    ),
)


@defaults()
def scatter(implementations: Sequence[Data], view: View, measure: str, bound: float) -> Markup:
    """Plot the worst error in each decade of a property of cases.

    bound: that of the errors, in units of 2^-53.
    """
    label = Y_LABELS[measure]
    # The exponents of the decade and of the error of each cell.
    found = []
    for one in implementations:
        cells = one[view.key][measure].items()
        marks = ((formats.exponent(part), _exponent(cell), cell) for part, cell in cells)
        found.append(sorted(marks, key=lambda mark: mark[0]))
    limit = math.log10(bound * ULP)
    x = fitted([at + 0.5 for marks in found for at, _, _ in marks], 0.1)
    y = fitted([limit, *(error for marks in found for _, error, _ in marks)], 0.1, LEAST_DECADE)
    drawing = Drawing((480, 270), (76, 46, 14, 12))
    axes, width = drawing.axes, drawing.inner[0]
    drawing.line("area", (0, 1, 1, 0, 0), (0, 0, 1, 1, 0))
    for axis, draw in ((x, axes.axvline), (y, axes.axhline)):
        for tick in axis.ticks:
            drawing.add("grid", draw(axis.at(tick)))
        for edge in axis.edges:
            drawing.add("part", draw(edge))
    drawing.line("bound", (0, 1), (y.at(limit),) * 2)
    apart = min(SPREAD / len(found), MOST) / width
    for k, (one, marks) in enumerate(zip(implementations, found, strict=True)):
        aside = (k - (len(found) - 1) / 2) * apart
        places = [(x.at(at + 0.5) + aside, y.at(error)) for at, error, _ in marks]
        # Marks in slots are not on the line.
        inside = [
            place
            for place, (at, error, _) in zip(places, marks, strict=True)
            if math.isfinite(at) and y.low <= error <= y.high
        ]
        if inside:
            drawing.line(f"trace {colour(k)}", *zip(*inside, strict=True))
        if places:
            titles = [_title(one["name"], at, cell) for at, _, cell in marks]
            drawing.mark("mark", k, *zip(*places, strict=True), titles)
    below = x.labels(33 / width, view.zero, view.beyond, 10)
    beside = y.labels(14 / drawing.inner[1], f"< {formats.power(10, y.low)}", "none", 10)
    axes.set_xticks([*below], [*below.values()])
    axes.set_yticks([*beside], [*beside.values()])
    drawing.add("label", axes.set_xlabel(view.label, fontsize=12))
    drawing.add("label", axes.set_ylabel(label, fontsize=12))
    axes.yaxis.set_label_coords(-62 / width, 0.5)
    limits = f"bound {formats.plain(bound)}"
    place = 0.99, y.at(limit) + 0.02
    drawing.add("limit", axes.text(*place, limits, ha="right", va="bottom", fontsize=12))
    return drawing.svg(f"{label} against {view.label}, the worst of each decade")


def _exponent(cell: Data) -> float:
    """Return the decimal logarithm of an error in the report."""
    value = formats.number(cell["units"]) * ULP
    return math.log10(value) if value else -math.inf


def _title(name: str, exponent: float, cell: Data) -> str:
    """Return the tooltip of a mark in a scatter plot.

    It has the decade, the number of states and the worst error.
    """
    if math.isinf(exponent):
        decade = "beyond all" if exponent > 0 else "0"
    else:
        decade = f"{formats.power(10, exponent)} to {formats.power(10, exponent + 1)}"
    size = formats.plain(cell["units"])
    if math.isfinite(formats.number(cell["units"])):
        size = f"{size} = {formats.counted(cell['units'])}"
    return f"{name}, {decade}\n{cell['count']} states, worst {size}\n{formats.place(cell)}"


@defaults()
def histograms(
    implementations: Sequence[Data], strata: Sequence[str], measure: str, bound: float
) -> list[tuple[str, Markup]]:
    """Draw a histogram of the errors in each stratum, with a row for each implementation.

    All have one axis, so that they can be compared.  The highest bar of a row is as high as the
    row.  `bound` is in units of 2^-53.
    """
    parts = {
        formats.exponent(part)
        for one in implementations
        for sizes in one["sizes"].values()
        for part in sizes.get(measure, {})
    }
    limit, rows = math.log2(bound), len(implementations)
    axis = fitted([limit, *parts, *(part + STEP for part in parts)], 0.1, LEAST_OCTAVE)
    drawing = Drawing((240, 40 + 34 * rows), (8, 34, 8, 6))
    bases = [1 - (k + 1) / rows for k in range(rows)]
    for base in bases:
        drawing.line("base", (0, 1), (base, base))
    drawing.line("bound", (axis.at(limit),) * 2, (0, 1))
    below = axis.labels(24 / drawing.inner[0], "less", "none", 2)
    drawing.axes.set(xticks=[*below], xticklabels=[*below.values()])
    drawing.add("label", drawing.axes.set_xlabel(f"error / {formats.UNIT}", fontsize=12))
    found = []
    for stratum in strata:
        bars: list[Rectangle] = []
        for k, (one, base) in enumerate(zip(implementations, bases, strict=True)):
            counts: Counter[float] = Counter()
            for part, count in one["sizes"].get(stratum, {}).get(measure, {}).items():
                exponent = formats.exponent(part)
                counts[-math.inf if exponent < axis.low else exponent] += count
            most, total = max(counts.values(), default=1), sum(counts.values())
            for exponent, count in sorted(counts.items()):
                left, right = _extent(axis, exponent)
                height = max(0.82 * count / most, 0.03) / rows
                (bar,) = drawing.axes.bar((left + right) / 2, height, 0.8 * (right - left), base)
                title = f"{one['name']}: {count} of {total} states, {_size(axis, exponent)}"
                drawing.add(f"bar {colour(k)}", bar, [title])
                bars.append(bar)
        drawing.axes.set(xlim=(0, 1), ylim=(0, 1))
        found.append((stratum, drawing.svg(f"{stratum}: how often {measure} errors are how large")))
        for bar in bars:
            bar.remove()
    return found


def _extent(axis: Axis, exponent: float) -> tuple[float, float]:
    """Return the left and right end of a histogram's bar.

    The bar is that of a half octave, or in a slot of the axis.
    """
    if math.isfinite(exponent):
        return axis.at(exponent), axis.at(exponent + STEP)
    middle, half = axis.at(exponent), abs(axis.at(axis.low + STEP) - axis.at(axis.low)) / 2
    return middle - half, middle + half


def _size(axis: Axis, exponent: float) -> str:
    """Format the range of errors that a histogram's bar counts."""
    if math.isinf(exponent):
        return "no number" if exponent > 0 else f"less than {formats.counted(2**axis.low)}"
    return formats.counted(2**exponent, 2 ** (exponent + STEP))


def colour(k: int) -> str:
    """Return the CSS class with the colour of the k-th implementation."""
    return f"c{k % len(SERIES)}"


@defaults()
def key(k: int) -> Markup:
    """Draw the legend's mark for the k-th implementation."""
    drawing = Drawing((12, 12), (0, 0, 0, 0))
    drawing.mark("key", k, [0.5], [0.5], [])
    return drawing.svg("", "")
