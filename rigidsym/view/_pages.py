"""HTML and Markdown pages, rendered from Jinja templates.

HTML pages load no other files.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from rigidsym.view import _cards as cards
from rigidsym.view import _tables
from rigidsym.view._cards import Markup
from rigidsym.view._style import SERIES, SERIES_ON_DARK

if TYPE_CHECKING:
    from jinja2 import Environment

Table = tuple[str, Sequence[str], Sequence[Sequence[str]]]
"Caption, columns and rows."


def render(template: str, **values: object) -> str:
    """Render a Jinja template.

    In HTML, text is escaped unless it is `Markup`.
    """
    found = _environment().get_template(template)
    return found.render(values, series=SERIES, series_on_dark=SERIES_ON_DARK)


@cache
def _environment() -> "Environment":
    from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

    return Environment(
        loader=PackageLoader("rigidsym.view"),
        autoescape=select_autoescape(["html"]),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def scaled(svg: str, number: int = 0) -> Markup:
    """Extract the SVG element of a document, and limit its width to that of the page.

    number: the place of the picture on its page.  It becomes part of the picture's ids, for two
    pictures on one page would else be drawn with the clips and letters of the first.
    """
    _, begin, rest = svg.partition("<svg ")
    rest = re.sub(r'(?<=[ "(])((?:xlink:)?href="#|url\(#|id=")', rf"\1p{number}-", rest)
    return Markup(f'{begin}style="max-width:100%;height:auto" {rest}')


def fit_page(title: str, tables: Iterable[Table], pictures: Iterable[tuple[str, str]]) -> str:
    """Return the HTML page of a fit.

    pictures: pairs of a caption and an SVG document.
    """
    name, _, said = title.partition(": ")
    drawn = [(caption, scaled(svg, k)) for k, (caption, svg) in enumerate(pictures)]
    return render("fit.html", name=name, said=said, tables=tables, pictures=drawn)


def fit_card(title: str, tables: Sequence[Table]) -> str:
    """Return a notebook card with tables of a fit."""
    name, _, said = title.partition(": ")
    shown = (cards.table(columns, rows) for _, columns, rows in tables)
    return cards.card(cards.head(name, cards.muted(said)), *shown)


def report_markdown(results: Mapping[str, Any]) -> str:
    """Return the report of `rigidsym reproduce` in Markdown.

    results: the data that `report_page` describes.
    """
    return render("report.md", table=_tables.table, **results)


def report_page(results: Mapping[str, Any]) -> str:
    """Return the report of `rigidsym reproduce` as an HTML page.

    results: passed, headline and sentences; chapters, each with its name, title and number of
    facts; modules, the digest of each generated file; motion, a sentence, and picture, an SVG
    document of it; versions of Python and packages.
    """
    links = {
        "validation.html": "what was measured",
        "errata.html": "the paper's equations, one by one",
        "ledger.json": "the proofs, as certificates",
        **dict.fromkeys(results["modules"], "generated code"),
    }
    return render("report.html", **{**results, "picture": scaled(results["picture"])}, links=links)


def errata_page(counted: str, printed: Iterable[tuple[str, str, Sequence[tuple[str, str]]]]) -> str:
    """Return the HTML page with the verdicts on all equations of the paper.

    counted: the number of each verdict, in words.  printed: the number of an equation, its verdict,
    and remarks by their kind.
    """
    return render("errata.html", counted=counted, printed=printed)
