"""The validation report as one HTML page, which needs nothing but itself."""

from importlib import resources

from rigidsym.view.html.markup import Markup, lines, tag
from rigidsym.view.report_data import Report
from rigidsym.view.validation import cases, plots, strata, summary
from rigidsym.view.validation import colophon as environment
from rigidsym.view.validation.marks import palette
from rigidsym.view.validation.source import passed

# Even a mistake in this package could load nothing.
POLICY = "default-src 'none'; style-src 'unsafe-inline'"
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
    body = tag("body", "\n", tag("main", "\n", lines(*_sections(data)), "\n"), "\n")
    return lines(Markup("<!DOCTYPE html>"), tag("html", _head(data), body, lang="en"), "")


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


def _head(data: Report) -> Markup:
    verdict = "passed" if passed(data) else "failed"
    return tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("title", f"rigidsym validation: {verdict}"),
        tag("style", _style()),
    )


def _style() -> Markup:
    sheet = resources.files(__name__).joinpath("style.css").read_text(encoding="utf-8")
    return Markup(f"\n{sheet}{palette()}\n")


def _contents() -> Markup:
    links = (tag("a", name, href=f"#{anchor}") for anchor, name in CONTENTS.items())
    return tag("nav", *links, aria_label="Contents")
