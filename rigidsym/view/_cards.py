"""HTML parts of notebook cards, such as badges, formulas, tables and lists.

Text is escaped unless it is `Markup`.  Colours are those of the page, except for tints of badges
that are visible on light and on dark.
"""

from collections.abc import Iterable, Sequence

from markupsafe import Markup, escape

from rigidsym.view._style import BAD, FAIR, GOOD, OPEN

TINTS = {
    **dict.fromkeys(("PROVED", "holds", "holds if", "passed", "settled"), GOOD),
    **dict.fromkeys(("ENCLOSED", "ambiguous"), FAIR),
    **dict.fromkeys(("ASSUMED", "misprint", "NOT PASSED", "missed"), BAD),
    **dict.fromkeys(("open", "under way"), OPEN),
}
# The names by which Sphinx finds formulas.
_CLASSES = "rigidsym tex2jax_process mathjax_process"
_CELL = "text-align:left;vertical-align:top;padding:.2em .8em .2em 0;background:transparent"
_SCROLL = "overflow-x:auto;overflow-y:hidden"
# Text wraps within the width of the page; a wide formula scrolls by itself.
_ENTRIES = "display:grid;grid-template-columns:fit-content(30%) minmax(0,1fr);gap:.2em .8em"
_ENTRY = "margin:0;padding:0;float:none;width:auto;font-weight:normal;overflow-wrap:anywhere"


def join(*parts: object) -> Markup:
    """Concatenate HTML parts of a card."""
    return Markup("".join(map(escape, parts)))


def tag(name: str, /, *children: object, **attributes: str) -> Markup:
    """Return an HTML element with given children and attributes.

    The argument `class_` is the attribute class.

    >>> tag("p", "1 < 2 ", tag("b", "&"), class_="note")
    Markup('<p class="note">1 &lt; 2 <b>&amp;</b></p>')
    """
    given = join(*(Markup(' {}="{}"').format(k.rstrip("_"), x) for k, x in attributes.items()))
    return Markup(f"<{name}{given}>{join(*children)}</{name}>")


def card(*children: object) -> str:
    """Return the HTML of a notebook card with given content."""
    return str(tag("div", *children, class_=_CLASSES, style="line-height:1.5;max-width:72em"))


def badge(text: str) -> Markup:
    """Return the HTML of a word in a coloured frame."""
    tint = TINTS.get(text, OPEN)
    style = f"border:1px solid {tint};border-radius:1em;padding:0 .6em;background:{tint}2e"
    return tag("span", text, style=f"{style};font-size:.85em;white-space:nowrap")


def math(latex: str) -> Markup:
    """Return the HTML of an inline LaTeX formula."""
    return tag("span", rf"\({latex}\)")


def formula(latex: str) -> Markup:
    """Return the HTML of a LaTeX formula on a line of its own.

    The line scrolls if the formula is too wide.
    """
    style = f"{_SCROLL};max-width:58em;padding:.15em 0"
    return tag("div", rf"\(\displaystyle {latex}\)", style=style)


def formulas(parts: Sequence[str]) -> Markup:
    """Return the HTML of several LaTeX formulas, separated by commas.

    Lines break between formulas.
    """
    ends = [","] * (len(parts) - 1) + [""]
    shown = (math(rf"\displaystyle {one}{end}") for one, end in zip(parts, ends, strict=True))
    style = "display:flex;flex-wrap:wrap;gap:.3em .9em;align-items:center;padding:.15em 0"
    return tag("div", *shown, style=style)


def head(title: object, *others: object) -> Markup:
    """Return a card's heading: a bold title followed by badges and remarks."""
    return tag("div", tag("strong", title), *(join(" ", other) for other in others))


def muted(*children: object) -> Markup:
    """Return HTML text in a lighter colour."""
    return tag("span", *children, style="opacity:.7")


def code(text: str) -> Markup:
    """Return HTML text in a monospaced font."""
    return tag("code", text)


def table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> Markup:
    """Return a left-aligned HTML table.

    Without `columns` it has no head.
    """
    heads = tag("thead", tag("tr", *(tag("th", name, style=_CELL) for name in columns)))
    body = [tag("tr", *(tag("td", cell, style=_CELL) for cell in row)) for row in rows]
    whole = tag("table", heads if columns else "", tag("tbody", *body), style="margin:.3em 0")
    return tag("div", whole, style=_SCROLL)


def entries(rows: Iterable[tuple[object, object]]) -> Markup:
    """Return an HTML list of names with their descriptions."""
    parts = (
        tag(name, part, style=_ENTRY)
        for row in rows
        for name, part in zip(("dt", "dd"), row, strict=True)
    )
    return tag("dl", *parts, style=f"{_ENTRIES};margin:.3em 0")


def folded(summary: object, *children: object) -> Markup:
    """Return a collapsible HTML section."""
    return tag("details", tag("summary", summary), *children, style="margin:.2em 0")


def bullets(items: Iterable[object]) -> Markup:
    """Return an HTML list with bullets."""
    return tag("ul", *(tag("li", item) for item in items), style="margin:.2em 0")


def counted(count: int, thing: str) -> str:
    """Return a count followed by its noun in the singular or plural."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
