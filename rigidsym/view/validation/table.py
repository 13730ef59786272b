"""Tables that scroll by themselves where a window is narrow."""

from collections.abc import Iterable, Mapping

from rigidsym.view.html.markup import Markup, join, lines, tag
from rigidsym.view.report_data import Cell, Figure
from rigidsym.view.validation.figures import (
    NOTHING,
    brief,
    condition,
    number,
    plain,
)
from rigidsym.view.validation.source import place


def table(
    caption: str, head: Iterable[Markup], rows: Iterable[Markup], class_: str | None = None
) -> Markup:
    """Rows of header cells and of data under a caption, in a box that can be scrolled."""
    title = tag("caption", tag("span", caption))
    body = tag("tbody", lines(*rows))
    whole = tag("table", title, tag("thead", *head), body, class_=class_)
    return tag("div", whole, class_="scroll", tabindex=0, role="region", aria_label=caption)


def column(*title: object, span: int | None = None, rows: int | None = None) -> Markup:
    """The header of a column, or of a group of them."""
    scope = "col" if span is None else "colgroup"
    return tag("th", *title, scope=scope, colspan=span, rowspan=rows)


def row(*title: object) -> Markup:
    """The header of a row."""
    return tag("th", *title, scope="row")


def pairs(caption: str, named: Iterable[tuple[str, object]]) -> Markup:
    """Names and values."""
    rows = (tag("tr", row(name), tag("td", value)) for name, value in named)
    return table(caption, [tag("tr", column("name"), column("value"))], rows, "words")


def figure(cell: Cell | None, part: Figure | None, cases: Mapping[str, str], beyond: str) -> Markup:
    """A worst error in units, a bar for its part of the bound, and its condition beside it.

    `beyond` is the class of cells that are beyond their bound.
    """
    if cell is None:
        return tag("td", NOTHING, class_="none", title="not measured")
    anchor = cases.get(cell["case"])
    shown = tag("a", brief(cell["units"]), href=f"#{anchor}") if anchor else brief(cell["units"])
    title = f"{plain(cell['units'])}; {cell['count']} figures, worst {place(cell)}"
    return barred(shown, condition(cell["condition"]), part, beyond, title)


def barred(
    shown: object, beside: str, part: Figure | None, beyond: str, title: str | None = None
) -> Markup:
    """A cell with a remark beside its figure, over a bar for a part of a bound."""
    value = 0.0 if part is None else number(part)
    class_ = f"number {beyond}" if value > 1 else "number"
    remark = join(" ", tag("small", beside)) if beside else ""
    style = f"--part:{100 * min(value, 1):.0f}%"
    return tag("td", tag("span", shown, remark, style=style), class_=class_, title=title)
