"""Figures of the validation page: errors against a property of their cases, and their sizes.

matplotlib draws them.  Their elements have classes of the page's style sheet, which gives them
colours on light and on dark ground, and titles for the pointer.
"""

import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import TYPE_CHECKING, NamedTuple
from xml.etree import ElementTree as ET

import numpy as np
from markupsafe import Markup

from rigidsym.view import _formats as formats
from rigidsym.view._formats import ULP
from rigidsym.view._pages import render
from rigidsym.view._plots.figure import defaults, svg
from rigidsym.view._report_data import MOST_CONDITION, ByMeasure, Cell, Implementation
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
    """A scale of exponents from `low` to `high`, between slots for zero and for infinity.

    Slots are `under` and `over` of the axis long, from 0 to 1; 0 where they are not needed.
    """

    low: float
    high: float
    under: float = 0.0
    over: float = 0.0

    @property
    def knots(self) -> list[tuple[float, float]]:
        """Exponents and their places, between which the scale is even."""
        begin, end = self.under, 1 - self.over
        knots = [(self.low, begin), (self.high, end)]
        if self.low < KNEE < self.high:
            knots.insert(1, (KNEE, begin + PART * (end - begin)))
        return knots

    @property
    def edges(self) -> list[float]:
        """The places of lines that separate slots, and parts with different scales."""
        ends = [self.under] * bool(self.under) + [1 - self.over] * bool(self.over)
        return ends + [place for _, place in self.knots[1:-1]]

    def at(self, exponent: float) -> float:
        """Return the place of an exponent, from 0 to 1."""
        if exponent < self.low:
            return self.under / 2
        if exponent > self.high:
            return 1 - self.over / 2
        exponents, places = zip(*self.knots, strict=True)
        return float(np.interp(exponent, exponents, places))

    @property
    def ticks(self) -> list[float]:
        """Round exponents, few where the scale is small."""
        *far, low, high = [exponent for exponent, _ in self.knots]
        near = [x for x in _round(low, high, 6) if low <= x <= high]
        return [x for end in far for x in _round(end, low, 2) if end <= x < low] + near

    def labels(self, room: float, zero: str, beyond: str, base: int) -> dict[float, str]:
        """Return places and labels of the slots, and of ticks that are `room` apart from them."""
        ends = {self.at(-math.inf): zero} if self.under else {}
        ends |= {self.at(math.inf): beyond} if self.over else {}
        numbers = base == 2 and self.high - self.low <= SHORT
        named = {x: f"{2.0**x:g}" if numbers else formats.power(base, x) for x in self.ticks}
        free = {self.at(x): name for x, name in named.items()}
        return {x: name for x, name in free.items() if all(abs(x - y) >= room for y in ends)} | ends


def fitted(exponents: Iterable[float], slot: float, least: float = -math.inf) -> Axis:
    """Return the axis that shows all exponents; those below `least` count as zero."""
    known = list(exponents)
    inside = [x for x in known if x >= least and math.isfinite(x)] or [0.0]
    low, high = math.floor(min(inside)), math.ceil(max(inside))
    under = slot if min(known, default=low) < low else 0.0
    over = slot if max(known, default=high) > high else 0.0
    return Axis(low, max(high, low + 1), under, over)


def _round(low: float, high: float, most: int) -> list[float]:
    from matplotlib.ticker import MaxNLocator

    locator = MaxNLocator(most, steps=[1, 2, 5, 10], integer=True, min_n_ticks=1)
    return list(map(float, locator.tick_values(low, high)))


class Drawing:
    """A figure of fixed margins whose artists have classes and titles."""

    def __init__(
        self, size: tuple[float, float], margins: tuple[float, float, float, float]
    ) -> None:
        """Make axes in a figure, sizes in points; the margins are left, bottom, right and top."""
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
        """Give an artist of the axes a class, and each of its shapes a title."""
        name = f"drawn-{len(self._named)}"
        artist.set(gid=name, clip_on=False)
        self._named[name] = class_, titles

    def line(self, class_: str, x: Sequence[float], y: Sequence[float]) -> None:
        """Draw a line."""
        (line,) = self.axes.plot(x, y)
        self.add(class_, line)

    def grid(self, x: Axis, y: Axis) -> None:
        """Draw lines at the ticks, and between parts of the axes."""
        for axis, draw in ((x, self.axes.axvline), (y, self.axes.axhline)):
            for tick in axis.ticks:
                self.add("grid", draw(axis.at(tick)))
            for edge in axis.edges:
                self.add("part", draw(edge))

    def svg(self, label: str, class_: str = "plot") -> Markup:
        """Return the drawing as an element of a page, with classes instead of styles."""
        root = ET.fromstring(svg(self.figure, {"svg.fonttype": "none"}))
        markers = {f"#{x.get('id')}": x.get("d") for x in root.iter(f"{_SVG}path")}
        shapes: list[dict[str, str | None]] = []
        words: list[dict[str, str | None]] = []
        for group in root.iter(f"{_SVG}g"):
            class_of, titles = self._named.get(group.get("id") or "", (None, ()))
            texts = group.findall(f"{_SVG}text")
            for text in texts:
                anchor = re.search(r"text-anchor: (\w+)", text.get("style") or "")
                words.append(
                    {**text.attrib, "class": class_of, "anchor": anchor and anchor[1]}
                    | {"text": text.text}
                )
            if class_of and not texts:
                found = [x.attrib for x in group.iter(f"{_SVG}use")]
                found = found or [x.attrib for x in group.iter(f"{_SVG}path")]
                for shape, title in zip_longest(found, titles):
                    path = shape.get("d") or markers[shape[_LINK]] or ""
                    known = {"class": class_of, "title": title, "path": " ".join(path.split())}
                    shapes.append({**shape, **known})
        box = root.get("viewBox")
        names = {"class_": class_, "box": box, "label": label, "shapes": shapes, "words": words}
        return Markup(render("drawing.html", **names))


class View(NamedTuple):
    """A pair of figures: labels of the abscissa, of its zero, and of values beyond its decades."""

    view: ByMeasure
    heading: str
    label: str
    zero: str
    beyond: str
    remark: str


VIEWS = (
    View(
        "distance",
        "Error and distance from the separatrix",
        "distance from the separatrix (1: nothing cancels, 0: on it)",
        "on it",
        "∞",
        "On the separatrix itself (left) and ever nearer to it, where solutions fly apart: "
        "a sound module shows no rise to the left.",
    ),
    View(
        "turned",
        "Error and time",
        "angle turned, |ω₀t| (rad)",
        "t = 0",
        "∞",
        "Times from the start on (left), as the angle that the body has turned by: "
        "errors that accumulate rise to the right.",
    ),
    View(
        "condition",
        "Error and condition number",
        "condition number κ",
        "0",
        f"> {formats.power(10, math.log10(MOST_CONDITION))}",
        "κ is how far a relative change of the inputs moves the true state, by its derivatives. "
        "A module that is no better than its inputs rises with κ; one that solves the given "
        "problem stays below the bound: what is ill-conditioned is told apart from what is "
        "computed badly.",
    ),
)


@defaults()
def scatters(
    implementations: Sequence[Implementation], view: View, bounds: Mapping[str, float]
) -> list[Markup]:
    """Draw the worst angle and rate error of each decade; `bounds` in units of 2^-53."""
    return [
        _scatter(implementations, view, measure, label, bounds[measure])
        for measure, label in Y_LABELS.items()
    ]


def _scatter(
    implementations: Sequence[Implementation], view: View, measure: str, label: str, bound: float
) -> Markup:
    found = [
        sorted((formats.decade(part), cell) for part, cell in one[view.view][measure].items())
        for one in implementations
    ]
    limit = math.log10(bound * ULP)
    x = fitted([at + 0.5 for cells in found for at, _ in cells], 0.1)
    errors = [_exponent(cell) for cells in found for _, cell in cells]
    y = fitted([limit, *errors], 0.1, LEAST_DECADE)
    drawing = Drawing((480, 270), (76, 46, 14, 12))
    axes, width = drawing.axes, drawing.inner[0]
    drawing.line("area", (0, 1, 1, 0, 0), (0, 0, 1, 1, 0))
    drawing.grid(x, y)
    drawing.line("bound", (0, 1), (y.at(limit),) * 2)
    apart = min(SPREAD / len(found), MOST) / width
    for k, (one, cells) in enumerate(zip(implementations, found, strict=True)):
        aside = (k - (len(found) - 1) / 2) * apart
        points = [
            (at, _exponent(cell), x.at(at + 0.5) + aside, y.at(_exponent(cell)))
            for at, cell in cells
        ]
        # Marks in slots are not on the line.
        inside = [p[2:] for p in points if math.isfinite(p[0]) and y.low <= p[1] <= y.high]
        if inside:
            drawing.line(f"trace {colour(k)}", *zip(*inside, strict=True))
        if points:
            _, _, *places = zip(*points, strict=True)
            marker = MARKERS[k % len(MARKERS)]
            (marks,) = axes.plot(*places, marker=marker, markersize=8, linestyle="none")
            drawing.add(f"mark {colour(k)}", marks, [_title(one["name"], *each) for each in cells])
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


def _exponent(cell: Cell) -> float:
    value = formats.number(cell["units"]) * ULP
    return math.log10(value) if value else -math.inf


def _title(name: str, exponent: float, cell: Cell) -> str:
    if math.isinf(exponent):
        decade = "beyond all" if exponent > 0 else "0"
    else:
        decade = f"{formats.power(10, exponent)} to {formats.power(10, exponent + 1)}"
    size = f"{formats.plain(cell['units'])} = {formats.counted(cell['units'])}"
    if math.isinf(formats.number(cell["units"])):
        size = "no number"
    return f"{name}, {decade}\n{cell['count']} states, worst {size}\n{formats.place(cell)}"


@defaults()
def histograms(
    implementations: Sequence[Implementation], strata: Sequence[str], measure: str, bound: float
) -> list[tuple[str, Markup]]:
    """Draw for each stratum how often errors have each size, a row of bars an implementation.

    All have one axis, so that they can be compared.  The highest bar of a row is as high as the
    row.  `bound` is in units of 2^-53.
    """
    parts = {
        formats.half_octave(part)
        for one in implementations
        for sizes in one["sizes"].values()
        for part in sizes.get(measure, {})
    }
    ends = [part + STEP for part in parts]
    axis = fitted([math.log2(bound), *parts, *ends], 0.1, LEAST_OCTAVE)
    rows = len(implementations)
    drawing = Drawing((240, 40 + 34 * rows), (8, 34, 8, 6))
    bases = [1 - (k + 1) / rows for k in range(rows)]
    for base in bases:
        drawing.line("base", (0, 1), (base, base))
    limit = axis.at(math.log2(bound))
    drawing.line("bound", (limit, limit), (0, 1))
    below = axis.labels(24 / drawing.inner[0], "less", "none", 2)
    drawing.axes.set(xticks=[*below], xticklabels=[*below.values()])
    drawing.add("label", drawing.axes.set_xlabel(f"error / {formats.UNIT}", fontsize=12))
    found = []
    for stratum in strata:
        bars: list[Rectangle] = []
        for k, (one, base) in enumerate(zip(implementations, bases, strict=True)):
            counts = _counts(one["sizes"].get(stratum, {}).get(measure, {}), axis)
            most, total = max(counts.values(), default=1), sum(counts.values())
            for exponent, number in sorted(counts.items()):
                left, right = _extent(axis, exponent)
                height = max(0.82 * number / most, 0.03) / rows
                (bar,) = drawing.axes.bar((left + right) / 2, height, 0.8 * (right - left), base)
                title = f"{one['name']}: {number} of {total} states, {_size(axis, exponent)}"
                drawing.add(f"bar {colour(k)}", bar, [title])
                bars.append(bar)
        drawing.axes.set(xlim=(0, 1), ylim=(0, 1))
        found.append((stratum, drawing.svg(f"{stratum}: how often {measure} errors are how large")))
        for bar in bars:
            bar.remove()
    return found


def _counts(sizes: Mapping[str, int], axis: Axis) -> Counter[float]:
    counts: Counter[float] = Counter()
    for part, number in sizes.items():
        exponent = formats.half_octave(part)
        counts[-math.inf if exponent < axis.low else exponent] += number
    return counts


def _extent(axis: Axis, exponent: float) -> tuple[float, float]:
    """Return the left and right place of the bar of a half octave, or of a slot."""
    if math.isfinite(exponent):
        return axis.at(exponent), axis.at(exponent + STEP)
    middle, half = axis.at(exponent), abs(axis.at(axis.low + STEP) - axis.at(axis.low)) / 2
    return middle - half, middle + half


def _size(axis: Axis, exponent: float) -> str:
    if math.isinf(exponent):
        return "no number" if exponent > 0 else f"less than {formats.counted(2**axis.low)}"
    return formats.counted(2**exponent, 2 ** (exponent + STEP))


def colour(k: int) -> str:
    """Return the class of elements in the colour of implementation k."""
    return f"c{k % len(SERIES)}"


@defaults()
def key(k: int) -> Markup:
    """Draw the mark of implementation k by itself, for a legend."""
    drawing = Drawing((12, 12), (0, 0, 0, 0))
    (marks,) = drawing.axes.plot([0.5], [0.5], marker=MARKERS[k % len(MARKERS)], markersize=8)
    drawing.add(f"key {colour(k)}", marks)
    return drawing.svg("", "")
