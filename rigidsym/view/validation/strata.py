"""Tables: implementations by regime and by stratum."""

from rigidsym.view.html.markup import Markup, lines, tag
from rigidsym.view.report_data import ByPart, Cell, Figure, Implementation, Report, Stratum
from rigidsym.view.validation.figures import (
    NOTHING,
    UNIT,
    measures,
    number,
    plain,
    share,
    units,
)
from rigidsym.view.validation.source import anchors, beyond, place
from rigidsym.view.validation.table import barred, column, figure, row, table

SHOWN = {"angle": "angle", "omega": "rate"}


def regimes(data: Report) -> Markup:
    """The worst errors by regime of motion, implementations side by side."""
    names = sorted({name for one in data["implementations"] for name in one["regimes"]})
    cases = anchors(data)
    rows = (_regime(data, name, cases) for name in names)
    caption = (
        f"Worst errors by regime of motion, in units of {UNIT} = {plain(1.0)}: "
        f"angle (rad) and rate (relative), of {units(data['bounds']['angle'])} allowed; "
        "κ: condition number of that state"
    )
    return tag(
        "section",
        tag("h2", "Regimes of motion"),
        table(caption, _two_lines("regime", data), rows),
        id="regimes",
    )


def strata(data: Report) -> Markup:
    """What was tested, how much of the bounds it takes, and all measures of implementations."""
    rows = (_stratum(data, stratum) for stratum in data["strata"])
    names = (one["name"] for one in data["implementations"])
    head = ["stratum", *names, "cases", "states", "oracles"]
    caption = (
        "Largest part of a documented bound that was needed, of all measures; oracles: their "
        f"disagreement, as part of the {data['agreement']:g} allowed"
    )
    return tag(
        "section",
        tag("h2", "Strata"),
        table(caption, [tag("tr", *map(column, head))], rows),
        *(_all_measures(data, one) for one in data["implementations"]),
        id="strata",
    )


def _two_lines(first: str, data: Report) -> list[Markup]:
    groups = [column(one["name"], span=len(SHOWN)) for one in data["implementations"]]
    under = [column(shown) for _ in groups for shown in SHOWN.values()]
    return [tag("tr", column(first, rows=2), *groups), tag("tr", *under)]


def _regime(data: Report, name: str, cases: dict[str, str]) -> Markup:
    found = (
        figure(cell, _part(cell, data["bounds"][measure]), cases, beyond(one))
        for one in data["implementations"]
        for measure in SHOWN
        for cell in [_cell(one, "regimes", name, measure)]
    )
    return tag("tr", row(name), *found)


def _part(cell: Cell | None, bound: float) -> Figure | None:
    """Of angle and of rates, whose allowance depends on nothing else."""
    return None if cell is None else number(cell["units"]) / bound


def _cell(one: Implementation, view: ByPart, part: str, measure: str) -> Cell | None:
    return one[view].get(part, {}).get(measure)


def _stratum(data: Report, stratum: Stratum) -> Markup:
    oracles = stratum["disagreement"]
    tested = "number" if stratum["cases"] else "number beyond"
    apart = "number" if number(oracles) <= 1 else "number beyond"
    return tag(
        "tr",
        row(stratum["name"], tag("small", stratum["about"], class_="about")),
        *(_largest(one, stratum["name"], data) for one in data["implementations"]),
        tag("td", stratum["cases"], class_=tested),
        tag("td", stratum["states"], class_=tested),
        tag("td", units(oracles), class_=apart),
    )


def _largest(one: Implementation, stratum: str, data: Report) -> Markup:
    shares = one["shares"].get(stratum, {})
    known = [name for name in measures(data) if name in shares]
    if not known:
        return tag("td", NOTHING, class_="none", title="not measured")
    name = max(known, key=lambda known: number(shares[known]["units"]))
    part, count = shares[name]["units"], shares[name]["count"]
    title = f"{place(shares[name])}; {count} figures beyond the bound"
    return barred(share(part), name, part, beyond(one), title)


def _all_measures(data: Report, one: Implementation) -> Markup:
    cases, names = anchors(data), measures(data)
    rows = (_every(one, stratum["name"], names, cases) for stratum in data["strata"])
    caption = f"{one['name']}: the worst of each measure, in units of {UNIT}; κ: condition number"
    limits = [column(units(data["bounds"][name])) for name in names]
    head = [
        tag("tr", column("stratum"), *map(column, names)),
        tag("tr", column("bound"), *limits, class_="limits"),
    ]
    summary = tag("summary", tag("h3", f"{one['name']}: every measure"))
    return tag("details", summary, table(caption, head, rows), open=not one["peer"])


def _every(one: Implementation, stratum: str, names: list[str], cases: dict[str, str]) -> Markup:
    found = (
        figure(_cell(one, "strata", stratum, name), _needed(one, stratum, name), cases, beyond(one))
        for name in names
    )
    return tag("tr", row(stratum), lines(*found))


def _needed(one: Implementation, stratum: str, measure: str) -> Figure | None:
    cell = _cell(one, "shares", stratum, measure)
    return None if cell is None else cell["units"]
