"""What a fit found, as a page of its own."""

from collections.abc import Iterable, Sequence

from rigidsym.view.html.cards import card, head, muted
from rigidsym.view.html.cards import table as card_table
from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.validation.document import document
from rigidsym.view.validation.table import column, row, table

Table = tuple[str, Sequence[str], Sequence[Sequence[str]]]


def fit_page(title: str, tables: Iterable[Table], pictures: Iterable[tuple[str, str]]) -> str:
    """Tables, a caption, columns and rows each, and pictures, a caption and SVG each."""
    name, _, said = title.partition(": ")
    return document(
        name,
        tag("header", tag("p", name, class_="kind"), tag("h1", said)),
        *(_section(*one) for one in tables),
        *(_picture(*one) for one in pictures),
    )


def fit_card(title: str, tables: Sequence[Table]) -> str:
    """For notebooks: some of the tables."""
    name, _, said = title.partition(": ")
    return card(head(name, muted(said)), join(*(card_table(x[1], x[2]) for x in tables)))


def _section(title: str, names: Sequence[str], rows: Sequence[Sequence[str]]) -> Markup:
    top = tag("tr", *map(column, names))
    body = (tag("tr", row(first), *(tag("td", x) for x in rest)) for first, *rest in rows)
    return tag("section", tag("h2", title.capitalize()), table(title, [top], body, "words"))


def _picture(title: str, drawing: str) -> Markup:
    """As wide as there is room; a document of its own begins with a size."""
    _, begin, rest = drawing.partition("<svg ")
    sized = f'{begin}style="max-width:100%;height:auto" {rest}'
    return tag("section", tag("h2", title), Markup(sized))
