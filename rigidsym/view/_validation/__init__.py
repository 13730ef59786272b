"""The validation report as an HTML page and as a card for notebooks."""

import json
import math
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from rigidsym.view import _cards as cards
from rigidsym.view import _report_data as formats
from rigidsym.view._pages import render
from rigidsym.view._report_data import Data, columns_of, number
from rigidsym.view._validation.figures import VIEWS, histograms, key, scatter

if TYPE_CHECKING:
    from rigidsym.validate._report import ValidationReport

PASSED, BROKEN = "passed", "NOT PASSED"
INPUTS = {"inertia": "kg m²", "omega0": "rad/s", "attitude0": "", "times": "s"}
HEADINGS = {"angle": "Angle error (rad)", "omega": "Rate error (relative to |ω|)"}
# Formats that the template uses.
_FORMATS = (
    *("brief", "condition", "counted", "decimal", "number", "place", "plain", "seconds", "share"),
    *("units", "UNIT"),
)


def page(data: Data) -> str:
    """Return the HTML page of a validation report.

    data: the report's `to_data()`.
    """
    everyone, bounds = data["implementations"], data["bounds"]
    judged = [one for one in everyone if not one["peer"]]
    strata = [stratum["name"] for stratum in data["strata"]]
    cases = [(_nearest(data, found), found) for found in data["worst"]]
    apart = ((number(one["disagreement"]), one["name"]) for one in data["strata"])
    shares = (
        (number(cell["units"]), measure, name, stratum)
        for measure in bounds
        for name, stratum, cell in _cells(judged, "shares", measure)
    )
    return render(
        "validation.html",
        data=data,
        judged=judged,
        worst_of=_worst,
        nearest=max(shares, default=None),
        disagreement=max(apart, default=None),
        measures=sorted(bounds, key=_rank),
        regimes=sorted({name for one in everyone for name in one["regimes"]}),
        columns=columns_of("page"),
        largest=_largest,
        anchors={case["case"]: f"case-{k}" for k, case in enumerate(data["worst"], 1)},
        inputs=INPUTS,
        keys=[key(k) for k in range(len(everyone))],
        views={x.key: [scatter(everyone, x, m, bounds[m]) for m in HEADINGS] for x in VIEWS},
        sizes=[
            (measure, heading, histograms(everyone, strata, measure, bounds[measure]))
            for measure, heading in HEADINGS.items()
        ],
        cases=sorted(cases, key=lambda found: (-found[0][0], found[1]["case"])),
        json=partial(json.dumps, sort_keys=True),
        **{name: getattr(formats, name) for name in _FORMATS},
    )


def _rank(measure: str) -> tuple[int, str]:
    """Return a sort key that puts error measures in the order of their definition."""
    # `rigidsym.validate` imports this module when it is imported itself.
    from rigidsym.validate._bounds import MEASURES

    return MEASURES.index(measure) if measure in MEASURES else len(MEASURES), measure


def _cells(
    implementations: Sequence[Data], view: str, measure: str
) -> Iterator[tuple[str, str, Data]]:
    """Yield the entries of a report for one error measure.

    An entry has the implementation, the part such as a stratum, and the cell of errors.  view: the
    data's key of parts, such as strata.
    """
    for one in implementations:
        for part, found in sorted(one[view].items()):
            if measure in found:
                yield one["name"], part, found[measure]


def _worst(
    implementations: Sequence[Data], view: str, measure: str
) -> tuple[str, str, Data] | None:
    """Return the entry of a report that has the largest error by one measure.

    An entry has the implementation, the part such as a stratum, and the cell of errors.  view: the
    data's key of parts, such as strata.  Returns None if nothing was measured.
    """
    listed = _cells(implementations, view, measure)
    return max(listed, key=lambda found: number(found[2]["units"]), default=None)


def _largest(one: Data, stratum: str) -> tuple[str, Data] | None:
    """Return the measure with the largest ratio of error to bound in a stratum.

    Returns the measure's name and cell, or None if nothing was measured.
    """
    shares = one["shares"].get(stratum, {})
    known = sorted(shares, key=_rank)
    name = max(known, key=lambda name: number(shares[name]["units"]), default=None)
    return None if name is None else (name, shares[name])


def _nearest(data: Data, case: Data) -> tuple[float, str, str]:
    """Return a case's largest ratio of error to bound, with its module and measure."""
    shares = (
        (number(cell["share"]), name, measure)
        for name, errors in case["errors"].items()
        for measure, cell in errors.items()
        if name in data["campaign"]["targets"]
    )
    return max(shares, default=(0.0, "", ""))


def report_html(report: "ValidationReport") -> str:
    """Return a notebook card of a validation report.

    It has the verdict, its reasons, and the worst errors of the strata.
    """
    data = report.to_data()
    everyone, columns = data["implementations"], columns_of("card")
    verdict = cards.badge(PASSED if data["passed"] else BROKEN)
    names = ["stratum", *(column.title for column in columns)]
    names += [f"{one['name']}: angle, bound used" for one in everyone]
    rows = (
        (
            stratum["name"],
            *(column.shown(stratum[column.key]) for column in columns),
            *(_card_cell(one, stratum["name"]) for one in everyone),
        )
        for stratum in data["strata"]
    )
    unit = "worst rotation angle in units of 2⁻⁵³ rad; the largest part used of any bound"
    return cards.card(
        cards.head("Validation", verdict, cards.code(data["command"])),
        cards.bullets(data["complaints"]) if data["complaints"] else "",
        cards.table(names, rows),
        cards.muted(unit),
    )


def _card_cell(one: Data, stratum: str) -> cards.Markup:
    """Format an implementation's worst error of the attitude in a stratum.

    It is followed by the largest part of a bound used.
    """
    found = one["strata"].get(stratum, {}).get("angle")
    largest = _largest(one, stratum)
    if found is None or largest is None:
        return cards.muted("not asked")
    part = float(largest[1]["units"])
    text = f"{part:.0%}" if part < 10 else f"{part:.2g} times" if math.isfinite(part) else "∞"
    shown = text if part <= 1 else cards.badge(text)
    return cards.join(f"{float(found['units']):.3g}, ", shown)
