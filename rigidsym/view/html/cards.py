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


def folded(summary: object, *children: object) -> Markup:
    """What opens at a click."""
    return tag("details", tag("summary", summary), *children, style="margin:.2em 0")


def counted(count: int, thing: str) -> str:
    """So many of a thing, in the plural where it has to be."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def bullets(items: Iterable[object]) -> Markup:
    """A list."""
    return tag("ul", *(tag("li", item) for item in items), style="margin:.2em 0")
