"""The validation report as a page that needs nothing but itself, and as a card for notebooks."""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from rigidsym.view import _formats as formats
from rigidsym.view._cards import (
    Markup,
    badge,
    bullets,
    card,
    code,
    head,
    join,
    muted,
    table,
)
from rigidsym.view._formats import number
from rigidsym.view._pages import render
from rigidsym.view._report_data import (
    ByPart,
    Case,
    Cell,
    Figure,
    Implementation,
    Report,
    Stratum,
)
from rigidsym.view._validation.figures import VIEWS, histograms, key, scatters

if TYPE_CHECKING:
    from rigidsym.validate._report import ValidationReport

PASSED, BROKEN = "passed", "NOT PASSED"
INPUTS = {"inertia": "kg m²", "omega0": "rad/s", "attitude0": "", "times": "s"}
NAMES = {"angle": "Angle error (rad)", "omega": "Rate error (relative to |ω|)"}


class Column(NamedTuple):
    """A column on strata: its key in the data, its title and its value.

    `shown` formats the value, `bad` marks strata, and `tables` are those that have the column:
    "page", "card", "markdown" and "terminal".  A new entry of `COLUMNS` needs no change elsewhere.
    """

    key: str
    title: str
    value: Callable[["ValidationReport", str], Figure]
    shown: Callable[[Figure], str]
    bad: Callable[[Stratum], bool]
    tables: Sequence[str]


COLUMNS = (
    Column(
        "cases",
        "cases",
        lambda report, stratum: report.tally.cases.get(stratum, 0),
        str,
        lambda stratum: not stratum["cases"],
        ("page", "card", "markdown", "terminal"),
    ),
    Column(
        "states",
        "states",
        lambda report, stratum: report.tally.states.get(stratum, 0),
        str,
        lambda stratum: not stratum["cases"],
        ("page", "card", "markdown", "terminal"),
    ),
    Column(
        "disagreement",
        "oracles",
        lambda report, stratum: report.agreement(stratum),
        formats.units,
        lambda stratum: number(stratum["disagreement"]) > 1,
        ("page",),
    ),
)


def columns_of(table: str) -> list[Column]:
    """Return the columns on strata that a table has."""
    return [column for column in COLUMNS if table in column.tables]


class Tile(NamedTuple):
    """A figure of the summary, with its title and a remark."""

    title: str
    shown: str
    remark: str
    beyond: bool = False


def page(data: Report) -> str:
    """Return the page of `ValidationReport.to_data()`: the same text for the same data."""
    everyone = data["implementations"]
    strata = [stratum["name"] for stratum in data["strata"]]
    cases = [(_nearest(data, found), found) for found in data["worst"]]
    return render(
        "validation.html",
        data=data,
        headline=_headline(data),
        peers=list(_peers(data)),
        tiles=list(_tiles(data)),
        measures=_measures(data),
        regimes=sorted({name for one in everyone for name in one["regimes"]}),
        columns=columns_of("page"),
        largest=_largest,
        anchors={case["case"]: f"case-{k}" for k, case in enumerate(data["worst"], 1)},
        inputs=INPUTS,
        keys=[key(k) for k in range(len(everyone))],
        views=[(view, scatters(everyone, view, data["bounds"])) for view in VIEWS],
        sizes=[
            (measure, heading, histograms(everyone, strata, measure, data["bounds"][measure]))
            for measure, heading in NAMES.items()
        ],
        cases=sorted(cases, key=lambda found: (-found[0][0], found[1]["case"])),
        UNIT=formats.UNIT,
    )


def _measures(data: Report) -> list[str]:
    """Return the names of the measures of a report, in the order of their definition."""
    return sorted(data["bounds"], key=_rank)


def _rank(measure: str) -> tuple[int, str]:
    # `rigidsym.validate` imports this module when it is imported itself.
    from rigidsym.validate._bounds import MEASURES

    return MEASURES.index(measure) if measure in MEASURES else len(MEASURES), measure


def _judged(data: Report) -> list[Implementation]:
    """Return the implementations that have to pass."""
    return [one for one in data["implementations"] if not one["peer"]]


def _headline(data: Report) -> str:
    *first, last = [one["name"] for one in _judged(data)] or ["nothing"]
    names = f"{', '.join(first)} and {last}" if first else last
    if data["passed"]:
        return f"{names} {'stay' if first else 'stays'} within every documented bound"
    count = len(data["complaints"])
    return f"{names}: {count} {'failure' if count == 1 else 'failures'}"


def _peers(data: Report) -> Iterator[str]:
    """Yield each peer with its worst angle error."""
    for one in data["implementations"]:
        if one["peer"] and (found := _worst([one], "strata", "angle")):
            name, _, cell = found
            unit = " rad" if math.isfinite(number(cell["units"])) else ""
            yield f"{name} {formats.plain(cell['units'])}{unit}"


def _cells(
    implementations: Sequence[Implementation], view: ByPart, measure: str
) -> Iterator[tuple[str, str, Cell]]:
    """Yield the name, part and cell of each cell of a view by a measure."""
    for one in implementations:
        for part, found in sorted(one[view].items()):
            if measure in found:
                yield one["name"], part, found[measure]


def _worst(
    implementations: Sequence[Implementation], view: ByPart, measure: str
) -> tuple[str, str, Cell] | None:
    """Return the worst cell of a view by a measure; None if nothing was measured."""
    listed = _cells(implementations, view, measure)
    return max(listed, key=lambda found: number(found[2]["units"]), default=None)


def _tiles(data: Report) -> Iterator[Tile]:
    yield _worst_tile(data, "Worst angle error", "angle", " rad")
    yield _worst_tile(data, "Worst rate error", "omega", " relative")
    shares = [
        (number(cell["units"]), measure, name, stratum)
        for measure in _measures(data)
        for name, stratum, cell in _cells(_judged(data), "shares", measure)
    ]
    if shares:
        part, measure, name, stratum = max(shares)
        remark = f"{measure}; {name} in {stratum}"
        yield Tile("Nearest to its bound", formats.share(part), remark, part > 1)
    else:
        yield Tile("Nearest to its bound", "not measured", "")
    apart = [(number(one["disagreement"]), one["name"]) for one in data["strata"]]
    if apart:
        (part, name), allowed = max(apart), data["agreement"]
        shown = f"{part * allowed:.2g}" if math.isfinite(part) else "not compared"
        remark = f"at most, of {allowed:g} allowed; {name}"
        yield Tile("Oracles differ by", shown, remark, part > 1)
    else:
        yield Tile("Oracles differ by", "not compared", "")
    cases, states = (sum(one[key] for one in data["strata"]) for key in ("cases", "states"))
    yield Tile("Tested", f"{cases:,} cases", f"{states:,} states in {len(data['strata'])} strata")


def _worst_tile(data: Report, title: str, measure: str, unit: str) -> Tile:
    found = _worst(_judged(data), "strata", measure)
    if found is None:
        return Tile(title, "not measured", "")
    (name, stratum, cell), bound = found, data["bounds"][measure]
    part = number(cell["units"]) / bound
    allowed = f"{formats.share(part)} of the bound {formats.plain(bound)}"
    remark = f"{formats.counted(cell['units'])}, {allowed}; {name} in {stratum}"
    return Tile(title, formats.scientific(cell["units"]) + unit, remark, part > 1)


def _largest(one: Implementation, stratum: str) -> tuple[str, Cell] | None:
    """Return the largest part of a bound that was used, with its measure."""
    shares = one["shares"].get(stratum, {})
    known = sorted(shares, key=_rank)
    name = max(known, key=lambda name: number(shares[name]["units"]), default=None)
    return None if name is None else (name, shares[name])


def _nearest(data: Report, case: Case) -> tuple[float, str, str]:
    """Return the largest part of a bound that a module used in a case, its name and the measure."""
    shares = (
        (number(cell["share"]), name, measure)
        for name, errors in case["errors"].items()
        for measure, cell in errors.items()
        if name in data["campaign"]["targets"]
    )
    return max(shares, default=(0.0, "", ""))


def report_html(report: "ValidationReport") -> str:
    """Return a card: the verdict and its reasons, then the strata with the worst errors."""
    data = report.to_data()
    title = head("Validation", badge(PASSED if data["passed"] else BROKEN), code(data["command"]))
    everyone = data["implementations"]
    columns = columns_of("card")
    heads = [column.title for column in columns]
    names = ("stratum", *heads, *(f"{one['name']}: angle, bound used" for one in everyone))
    rows = (
        (
            stratum["name"],
            *(column.shown(stratum[column.key]) for column in columns),
            *(_card_cell(one, stratum["name"]) for one in everyone),
        )
        for stratum in data["strata"]
    )
    said = [bullets(data["complaints"])] if data["complaints"] else []
    unit = muted("worst rotation angle in units of 2⁻⁵³ rad; the largest part used of any bound")
    return card(title, *said, table(names, rows), unit)


def _card_cell(one: Implementation, stratum: str) -> Markup:
    found = one["strata"].get(stratum, {}).get("angle")
    shares = [float(cell["units"]) for cell in one["shares"].get(stratum, {}).values()]
    if found is None or not shares:
        return muted("not asked")
    part = max(shares)
    text = f"{part:.0%}" if part < 10 else f"{part:.2g} times" if math.isfinite(part) else "∞"
    return join(f"{float(found['units']):.3g}, ", text if part <= 1 else badge(text))
