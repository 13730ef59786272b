"""How often errors are how large: half octaves, a row of bars for each implementation."""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from rigidsym.view.html.markup import Markup, join, lines, tag
from rigidsym.view.report_data import Implementation
from rigidsym.view.validation import figures
from rigidsym.view.validation.axis import Axis, fitted
from rigidsym.view.validation.drawing import line, write
from rigidsym.view.validation.marks import colour

WIDTH, LEFT, RIGHT, TOP, ROW, BOTTOM, SLOT = 240, 8, 8, 6, 34, 34, 22.0
# Errors of less units than this are shown as one, in octaves.
LEAST = -3
STEP = 0.5
# How far apart labels have to be.
ROOM = 24.0
# Octaves up to which a tick is written as a number.
SHORT = 12


def common(implementations: Iterable[Implementation], measure: str, bound: float) -> Axis:
    """One axis for every stratum, so that pictures can be compared."""
    parts = {
        figures.half_octave(part)
        for one in implementations
        for sizes in one["sizes"].values()
        for part in sizes.get(measure, {})
    }
    ends = [part + STEP for part in parts]
    return fitted([math.log2(bound), *parts, *ends], LEFT, WIDTH - RIGHT, SLOT, LEAST)


def histogram(
    implementations: Sequence[Implementation],
    stratum: str,
    measure: str,
    bound: float,
    axis: Axis,
) -> Markup:
    """The SVG of one stratum by one measure; `bound` in units of 2^-53."""
    base = TOP + ROW * len(implementations)
    limit = axis.at(math.log2(bound))
    rows = [
        _row(k, one, one["sizes"].get(stratum, {}).get(measure, {}), axis)
        for k, one in enumerate(implementations)
    ]
    return tag(
        "svg",
        "\n",
        lines(*rows, line("bound", limit, TOP, limit, base), _labels(axis, base)),
        "\n",
        class_="plot",
        viewBox=f"0 0 {WIDTH} {base + BOTTOM}",
        role="img",
        aria_label=f"{stratum}: how often {measure} errors are how large",
    )


def _row(k: int, one: Implementation, sizes: Mapping[str, int], axis: Axis) -> Markup:
    """Bars above a base line, the highest of them as high as the row."""
    base = TOP + ROW * (k + 1)
    counts = _counts(sizes, axis)
    most, total = max(counts.values(), default=1), sum(counts.values())
    bars = [
        _bar(k, base, count / most, axis, exponent, f"{one['name']}: {count} of {total} states, ")
        for exponent, count in sorted(counts.items())
    ]
    return join(line("base", axis.first, base, axis.last, base), *bars)


def _counts(sizes: Mapping[str, int], axis: Axis) -> Counter[float]:
    counts: Counter[float] = Counter()
    for part, count in sizes.items():
        exponent = figures.half_octave(part)
        counts[-math.inf if exponent < axis.low else exponent] += count
    return counts


def _bar(k: int, base: float, part: float, axis: Axis, exponent: float, who: str) -> Markup:
    left, right = _extent(axis, exponent)
    height = max(part * (ROW - 6), 1.0)
    return tag(
        "rect",
        tag("title", who + _size(axis, exponent)),
        class_=f"bar {colour(k)}",
        x=left + 0.1 * (right - left),
        y=base - height,
        width=0.8 * (right - left),
        height=height,
    )


def _extent(axis: Axis, exponent: float) -> tuple[float, float]:
    if math.isfinite(exponent):
        return axis.at(exponent), axis.at(exponent + STEP)
    middle, half = axis.at(exponent), abs(axis.at(axis.low + STEP) - axis.at(axis.low)) / 2
    return middle - half, middle + half


def _size(axis: Axis, exponent: float) -> str:
    if math.isinf(exponent):
        return "no number" if exponent > 0 else f"less than {figures.counted(2**axis.low)}"
    return figures.counted(2**exponent, 2 ** (exponent + STEP))


def _labels(axis: Axis, base: float) -> Markup:
    written = [write(axis.at(x), base + 13, _tick(axis, x)) for x in axis.labelled(ROOM)]
    if axis.under:
        written.append(write(axis.at(-math.inf), base + 13, "less"))
    if axis.over:
        written.append(write(axis.at(math.inf), base + 13, "none"))
    middle = (axis.first + axis.last) / 2
    return join(*written, write(middle, base + 28, f"error / {figures.UNIT}", class_="label"))


def _tick(axis: Axis, tick: float) -> str:
    return f"{2.0**tick:g}" if axis.high - axis.low <= SHORT else figures.power(2, tick)
