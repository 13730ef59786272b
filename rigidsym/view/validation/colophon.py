"""The end of the page: what the measures mean, their bounds, and what it all ran on."""

import json

from rigidsym.view.html.markup import Markup, tag
from rigidsym.view.report_data import Figure, Report
from rigidsym.view.validation.figures import UNIT, measures, plain, units
from rigidsym.view.validation.table import column, pairs, row, table


def bounds(data: Report) -> Markup:
    """Measures, their bounds, and what they mean."""
    rows = (_bound(data, name) for name in measures(data))
    head = tag("tr", *map(column, ("measure", "bound", f"in {UNIT}", "meaning")))
    return tag(
        "section",
        tag("h2", "Measures and bounds"),
        table("What is measured, and its documented bound", [head], rows, "words"),
        tag(
            "p",
            f"Errors are in units of {UNIT} = {plain(1.0)}, half the distance of doubles above 1. "
            "Bounds on energy and momentum are times the condition number of H and K², which is "
            "why a figure above the bound's own can be within it. κ is the condition number of "
            "the state: how far a relative change of the inputs moves it.",
            class_="about",
        ),
        id="bounds",
    )


def environment(data: Report) -> Markup:
    """What the campaign ran on, and full digests."""
    run = [(name, _value(value)) for name, value in sorted(data["run"].items())]
    digests = [
        (f"digest of {one['name']}", tag("code", one["digest"]))
        for one in data["implementations"]
        if one["digest"]
    ]
    known = [("schema", data["schema"]), ("version", data["campaign"]["version"])]
    return tag(
        "section",
        tag("h2", "Environment"),
        pairs("What this campaign ran on", [*known, *run, *digests]),
        id="environment",
    )


def _bound(data: Report, name: str) -> Markup:
    bound = data["bounds"][name]
    return tag(
        "tr",
        row(name),
        tag("td", plain(bound), class_="number"),
        tag("td", units(bound), class_="number"),
        tag("td", data["meanings"].get(name, "")),
    )


def _value(value: Figure | None) -> str:
    return value if isinstance(value, str) else json.dumps(value, sort_keys=True)
