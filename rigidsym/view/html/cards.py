"""What representations for notebooks are made of: cards, badges, formulas, tables.

Colours are those of the page, but for tints of badges that are seen on light and on dark.
"""

from collections.abc import Iterable, Sequence

from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.palette import BAD, FAIR, GOOD, OPEN

TINTS = {
    "PROVED": GOOD,
    "ENCLOSED": FAIR,
    "ASSUMED": BAD,
    "holds": GOOD,
    "holds if": GOOD,
    "misprint": BAD,
    "ambiguous": FAIR,
    "open": OPEN,
    "passed": GOOD,
    "NOT PASSED": BAD,
    "settled": GOOD,
    "under way": OPEN,
    "missed": BAD,
}
# What Sphinx needs to know that there are formulas inside.
_CLASSES = "rigidsym tex2jax_process mathjax_process"
_CELL = "text-align:left;vertical-align:top;padding:.2em .8em .2em 0;background:transparent"
_SCROLL = "overflow-x:auto;overflow-y:hidden"
# Names beside what they are: words wrap within the width of the page, a wide formula scrolls alone.
_ENTRIES = "display:grid;grid-template-columns:fit-content(30%) minmax(0,1fr);gap:.2em .8em"
_ENTRY = "margin:0;padding:0;float:none;width:auto;font-weight:normal;overflow-wrap:anywhere"


def card(*children: object) -> str:
    """A representation as a whole."""
    return tag("div", *children, class_=_CLASSES, style="line-height:1.5;max-width:72em")


def badge(text: str) -> Markup:
    """A word with its tint."""
    tint = TINTS.get(text, OPEN)
    style = f"border:1px solid {tint};border-radius:1em;padding:0 .6em;background:{tint}2e"
    return tag("span", text, style=f"{style};font-size:.85em;white-space:nowrap")


def math(latex: str) -> Markup:
    """A formula in a line of text."""
    return tag("span", rf"\({latex}\)")


def formula(latex: str) -> Markup:
    """A formula on a line of its own, which scrolls where it is too wide."""
    style = f"{_SCROLL};max-width:58em;padding:.15em 0"
    return tag("div", rf"\(\displaystyle {latex}\)", style=style)


def formulas(parts: Sequence[str]) -> Markup:
    """Formulas with commas between them, which go on in the next line where a page ends."""
    ends = [","] * (len(parts) - 1) + [""]
    shown = (math(rf"\displaystyle {one}{end}") for one, end in zip(parts, ends, strict=True))
    style = "display:flex;flex-wrap:wrap;gap:.3em .9em;align-items:center;padding:.15em 0"
    return tag("div", *shown, style=style)


def head(title: object, *others: object) -> Markup:
    """The first line: a name in bold, then badges and remarks."""
    return tag("div", tag("strong", title), *(join(" ", other) for other in others))


def muted(*children: object) -> Markup:
    """What is not the first thing to read."""
    return tag("span", *children, style="opacity:.7")


def code(text: str) -> Markup:
    """A name as it is written in code."""
    return tag("code", text)


def table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> Markup:
    """A table to read from left to right, in the colours of the page; columns may be unnamed."""
    heads = tag("thead", tag("tr", *(tag("th", name, style=_CELL) for name in columns)))
    body = [tag("tr", *(tag("td", cell, style=_CELL) for cell in row)) for row in rows]
    whole = tag("table", heads if columns else "", tag("tbody", *body), style="margin:.3em 0")
    return tag("div", whole, style=_SCROLL)


def entries(rows: Iterable[tuple[object, object]]) -> Markup:
    """Names, and beside each what it is."""
    parts = (
        tag(name, part, style=_ENTRY)
        for row in rows
        for name, part in zip(("dt", "dd"), row, strict=True)
    )
    return tag("dl", *parts, style=f"{_ENTRIES};margin:.3em 0")


def folded(summary: object, *children: object) -> Markup:
    """What opens at a click."""
    return tag("details", tag("summary", summary), *children, style="margin:.2em 0")


def counted(count: int, thing: str) -> str:
    """So many of a thing, in the plural where it has to be."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def bullets(items: Iterable[object]) -> Markup:
    """A list."""
    return tag("ul", *(tag("li", item) for item in items), style="margin:.2em 0")
