"""Pages from templates: a page of HTML needs nothing but itself, and loads nothing."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from rigidsym.view import _cards as cards
from rigidsym.view._cards import Markup
from rigidsym.view._style import SERIES, SERIES_ON_DARK
from rigidsym.view._tables import table as markdown_table

if TYPE_CHECKING:
    from jinja2 import Environment

CHAPTERS = ("chapter", "", "facts")
Table = tuple[str, Sequence[str], Sequence[Sequence[str]]]
"Caption, columns and rows."


def render(template: str, **values: object) -> str:
    """Return a page by its template; in HTML, text is escaped unless it is `Markup`."""
    return (
        _environment()
        .get_template(template)
        .render(values, series=SERIES, series_on_dark=SERIES_ON_DARK)
    )


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


def scaled(svg: str) -> Markup:
    """Return an SVG document for a page: as wide as there is room, without its prologue."""
    _, begin, rest = svg.partition("<svg ")
    return Markup(f'{begin}style="max-width:100%;height:auto" {rest}')


def fit_page(title: str, tables: Iterable[Table], pictures: Iterable[tuple[str, str]]) -> str:
    """Return the page of a fit; pictures have a caption and an SVG document each."""
    name, _, said = title.partition(": ")
    drawn = [(caption, scaled(svg)) for caption, svg in pictures]
    return render("fit.html", name=name, said=said, tables=tables, pictures=drawn)


def fit_card(title: str, tables: Sequence[Table]) -> str:
    """Return some tables of a fit as a card for notebooks."""
    name, _, said = title.partition(": ")
    shown = (cards.table(columns, rows) for _, columns, rows in tables)
    return cards.card(cards.head(name, cards.muted(said)), *shown)


@dataclass(frozen=True, slots=True)
class Results:
    """The results of `rigidsym reproduce`.

    chapters: name, title and number of facts.  modules: the digest of each generated file.
    motion: a sentence on the motion, and its picture as SVG.  versions: of Python and packages.
    """

    passed: bool
    sentences: Sequence[str]
    chapters: Sequence[tuple[str, str, str]]
    modules: Mapping[str, str]
    motion: tuple[str, str]
    versions: Mapping[str, str]

    @property
    def headline(self) -> str:
        """The verdict, in a sentence."""
        if self.passed:
            return "All that is claimed is proved, and the generated code is valid."
        return "NOT all that is claimed is proved, current and valid."


@dataclass(frozen=True, slots=True)
class Printed:
    """A printed equation: its number, its verdict, and remarks by their kind."""

    number: str
    verdict: str
    said: Sequence[tuple[str, str]]


def report_markdown(results: Results) -> str:
    """Return the report of `rigidsym reproduce` in Markdown."""
    proved = "\n".join(markdown_table(CHAPTERS, results.chapters))
    return render("report.md", results=results, proved=proved)


def report_page(results: Results) -> str:
    """Return the report of `rigidsym reproduce` as a page with links to its other files."""
    links = {
        "validation.html": "what was measured",
        "errata.html": "the paper's equations, one by one",
        "ledger.json": "the proofs, as certificates",
        **dict.fromkeys(results.modules, "generated code"),
    }
    picture = scaled(results.motion[1])
    return render("report.html", results=results, links=links, chapters=CHAPTERS, picture=picture)


def errata_page(counted: str, printed: Iterable[Printed]) -> str:
    """Return the page of all printed equations, each with its verdict and remarks."""
    return render("errata.html", counted=counted, printed=printed)
