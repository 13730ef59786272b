"""The validation report as one HTML page, which needs nothing but itself."""

from rigidsym.view.html.markup import Markup, tag
from rigidsym.view.report_data import Report
from rigidsym.view.validation import cases, plots, strata, summary
from rigidsym.view.validation import colophon as environment
from rigidsym.view.validation.document import document
from rigidsym.view.validation.source import passed

CONTENTS = {
    "regimes": "Regimes",
    "strata": "Strata",
    "plots": "Where errors are large",
    "sizes": "How large",
    "worst": "Worst cases",
    "bounds": "Bounds",
    "environment": "Environment",
}


def page(data: Report) -> str:
    """The page of `ValidationReport.to_data()`: the same text for the same data."""
    verdict = "passed" if passed(data) else "failed"
    return document(f"rigidsym validation: {verdict}", *_sections(data))


def _sections(data: Report) -> list[Markup]:
    return [
        summary.summary(data),
        summary.failures(data),
        _contents(),
        strata.regimes(data),
        strata.strata(data),
        plots.views(data),
        plots.sizes(data),
        cases.worst(data),
        environment.bounds(data),
        environment.environment(data),
    ]


def _contents() -> Markup:
    links = (tag("a", name, href=f"#{anchor}") for anchor, name in CONTENTS.items())
    return tag("nav", *links, aria_label="Contents")
