"""Single cases in full: inputs, errors, and the command that runs them again."""

from collections.abc import Mapping
from typing import Literal

from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.report_data import Case, Implementation, Report, WorstError
from rigidsym.view.validation.figures import (
    NOTHING,
    UNIT,
    brief,
    condition,
    decimal,
    measures,
    number,
    seconds,
    share,
    units,
)
from rigidsym.view.validation.source import anchors, beyond
from rigidsym.view.validation.table import barred, column, row, table

INPUTS: Mapping[Literal["inertia", "omega0", "attitude0", "times"], str] = {
    "inertia": "kg m²",
    "omega0": "rad/s",
    "attitude0": "",
    "times": "s",
}


def worst(data: Report) -> Markup:
    """The cases that are worst somewhere."""
    where = anchors(data)
    listed = sorted(data["worst"], key=lambda found: (-_worst(data, found)[0], found["case"]))
    return tag(
        "section",
        tag("h2", "Worst cases"),
        tag(
            "p",
            "The worst of each stratum, by angle and by rate, for each module: inputs without "
            "loss, errors of everybody, and the command that measures the case again. "
            "Those nearest to a bound come first.",
        ),
        *(_folded(data, found, where[found["case"]]) for found in listed),
        id="worst",
    )


def replay(command: str) -> Markup:
    """A command, which one click selects."""
    return tag("code", command, class_="command")


def case(data: Report, found: Case) -> Markup:
    """Inputs, regime, errors and the command of one case."""
    about = f"{found['regime']}; distance from the separatrix {units(found['distance'])}"
    return join(
        tag("p", about, class_="about"),
        replay(found["replay"]),
        _inputs(found),
        _errors(data, found),
    )


def _folded(data: Report, found: Case, anchor: str) -> Markup:
    part, name, measure = _worst(data, found)
    remark = tag("small", f"{found['regime']}; {name} {measure} {share(part)} of its bound")
    title = tag("summary", tag("strong", found["case"]), " ", remark)
    return tag("details", title, tag("div", case(data, found), id=anchor), class_="case")


def _worst(data: Report, found: Case) -> tuple[float, str, str]:
    """The largest part of a bound that a module needs, who needs it, and of which."""
    shares = (
        (number(cell["share"]), name, measure)
        for name, errors in found["errors"].items()
        for measure, cell in errors.items()
        if name in data["campaign"]["targets"]
    )
    return max(shares, default=(0.0, "", ""))


def _inputs(found: Case) -> Markup:
    rows = (
        tag(
            "tr",
            row(name, tag("small", unit)),
            tag("td", *map(_value, found[name])),
        )
        for name, unit in INPUTS.items()
    )
    head = tag("tr", *map(column, ("input", "value, and exactly")))
    return table(f"Inputs of {found['case']}", [head], rows, "words")


def _value(written: str) -> Markup:
    return tag("div", tag("span", decimal(written)), tag("code", written), class_="both")


def _errors(data: Report, found: Case) -> Markup:
    names = measures(data)
    rows = (
        tag("tr", row(one["name"]), *(_error(one, errors.get(name)) for name in names))
        for one, errors in _in_order(data, found)
    )
    head = tag("tr", column("implementation"), *map(column, names))
    return table(f"Errors of {found['case']}, in units of {UNIT}", [head], rows)


def _in_order(data: Report, found: Case) -> list[tuple[Implementation, Mapping[str, WorstError]]]:
    errors = found["errors"]
    return [(one, errors[one["name"]]) for one in data["implementations"] if one["name"] in errors]


def _error(one: Implementation, cell: WorstError | None) -> Markup:
    if cell is None:
        return tag("td", NOTHING, class_="none")
    title = f"{share(cell['share'])} of the bound, at t = {seconds(cell['t'])}"
    shown, beside = brief(cell["units"]), condition(cell["condition"])
    return barred(shown, beside, cell["share"], beyond(one), title)
