"""A page of the tool, which needs nothing but itself: head, style sheet, and what it is given."""

from importlib import resources

from rigidsym.view.html.markup import Markup, lines, tag
from rigidsym.view.validation.marks import palette

# Even a mistake in this package could load nothing.
POLICY = "default-src 'none'; style-src 'unsafe-inline'"


def document(title: str, *parts: Markup) -> str:
    """The whole text of a page."""
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=POLICY),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("title", title),
        tag("style", _style()),
    )
    body = tag("body", "\n", tag("main", "\n", lines(*parts), "\n"), "\n")
    return lines(Markup("<!DOCTYPE html>"), tag("html", head, body, lang="en"), "")


def _style() -> Markup:
    sheet = resources.files(__package__ or "").joinpath("style.css").read_text(encoding="utf-8")
    return Markup(f"\n{sheet}{palette()}\n")
