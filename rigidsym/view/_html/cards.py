"""Parts of representations for notebooks: cards, badges, formulas, tables.

Text is escaped unless it is `Markup`.  Colours are those of the page, except for tints of badges
that are visible on light and on dark.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction

from markupsafe import Markup, escape

from rigidsym import _inputs as inputs
from rigidsym._inputs import Number
from rigidsym.view._style import BAD, FAIR, GOOD, OPEN

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
# The names by which Sphinx finds formulas.
_CLASSES = "rigidsym tex2jax_process mathjax_process"
_CELL = "text-align:left;vertical-align:top;padding:.2em .8em .2em 0;background:transparent"
_SCROLL = "overflow-x:auto;overflow-y:hidden"
# Text wraps within the width of the page; a wide formula scrolls by itself.
_ENTRIES = "display:grid;grid-template-columns:fit-content(30%) minmax(0,1fr);gap:.2em .8em"
_ENTRY = "margin:0;padding:0;float:none;width:auto;font-weight:normal;overflow-wrap:anywhere"

RATE, MOMENTUM = r"\mathrm{rad/s}", r"\mathrm{N\,m\,s}"
INERTIA = r"\mathrm{kg\,m^2}"
GIVEN, COMPUTED = 6, 4
"Digits of numbers that a user gave, and of computed ones."


def join(*parts: object) -> Markup:
    """Concatenate parts."""
    return Markup("".join(map(escape, parts)))


def tag(name: str, /, *children: object, **attributes: str) -> Markup:
    """Return an element; `class_` is the attribute class.

    >>> tag("p", "1 < 2 ", tag("b", "&"), class_="note")
    Markup('<p class="note">1 &lt; 2 <b>&amp;</b></p>')
    """
    given = join(*(Markup(' {}="{}"').format(k.rstrip("_"), x) for k, x in attributes.items()))
    return Markup(f"<{name}{given}>{join(*children)}</{name}>")


def card(*children: object) -> str:
    """Return a representation as a whole."""
    return str(tag("div", *children, class_=_CLASSES, style="line-height:1.5;max-width:72em"))


def badge(text: str) -> Markup:
    """Return a word with its tint."""
    tint = TINTS.get(text, OPEN)
    style = f"border:1px solid {tint};border-radius:1em;padding:0 .6em;background:{tint}2e"
    return tag("span", text, style=f"{style};font-size:.85em;white-space:nowrap")


def math(latex: str) -> Markup:
    """Return a formula in a line of text."""
    return tag("span", rf"\({latex}\)")


def formula(latex: str) -> Markup:
    """Return a formula on a line of its own, which scrolls where it is too wide."""
    style = f"{_SCROLL};max-width:58em;padding:.15em 0"
    return tag("div", rf"\(\displaystyle {latex}\)", style=style)


def formulas(parts: Sequence[str]) -> Markup:
    """Return formulas with commas between them, which wrap where a page ends."""
    ends = [","] * (len(parts) - 1) + [""]
    shown = (math(rf"\displaystyle {one}{end}") for one, end in zip(parts, ends, strict=True))
    style = "display:flex;flex-wrap:wrap;gap:.3em .9em;align-items:center;padding:.15em 0"
    return tag("div", *shown, style=style)


def head(title: object, *others: object) -> Markup:
    """Return the first line: a name in bold, then badges and remarks."""
    return tag("div", tag("strong", title), *(join(" ", other) for other in others))


def muted(*children: object) -> Markup:
    """Return text of less weight."""
    return tag("span", *children, style="opacity:.7")


def code(text: str) -> Markup:
    """Return a name as it is written in code."""
    return tag("code", text)


def table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> Markup:
    """Return a left-aligned table in the colours of the page; without `columns` it has no head."""
    heads = tag("thead", tag("tr", *(tag("th", name, style=_CELL) for name in columns)))
    body = [tag("tr", *(tag("td", cell, style=_CELL) for cell in row)) for row in rows]
    whole = tag("table", heads if columns else "", tag("tbody", *body), style="margin:.3em 0")
    return tag("div", whole, style=_SCROLL)


def entries(rows: Iterable[tuple[object, object]]) -> Markup:
    """Return a list of names with their descriptions."""
    parts = (
        tag(name, part, style=_ENTRY)
        for row in rows
        for name, part in zip(("dt", "dd"), row, strict=True)
    )
    return tag("dl", *parts, style=f"{_ENTRIES};margin:.3em 0")


def folded(summary: object, *children: object) -> Markup:
    """Return a collapsible section."""
    return tag("details", tag("summary", summary), *children, style="margin:.2em 0")


def bullets(items: Iterable[object]) -> Markup:
    """Return a list."""
    return tag("ul", *(tag("li", item) for item in items), style="margin:.2em 0")


def counted(count: int, thing: str) -> str:
    """Return a count with its noun, in the plural unless the count is one."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def decimal(value: Number | float, digits: int = GIVEN) -> str:
    """Return a number to some digits in LaTeX."""
    if isinstance(value, inputs.Uncertain):
        return rf"{decimal(value.middle)} \pm {decimal(value.radius)}"
    number, _, exponent = inputs.decimal(Fraction(value), digits).lower().partition("e")
    number = number.rstrip("0").rstrip(".") if "." in number else number
    number = f"{{{number}}}" if value < 0 else number
    return rf"{number} \cdot 10^{{{int(exponent)}}}" if exponent else number


def vector(values: Iterable[Number | float], digits: int = GIVEN) -> str:
    """Return the components of a vector in LaTeX."""
    inside = r",\ ".join(decimal(value, digits) for value in values)
    return f"({inside})"


def quantity(field: str, latex: str, unit: str) -> tuple[Markup, Markup, Markup]:
    """Return a row of a table: the name of a field, its value, and its unit or ""."""
    return muted(field), math(latex), math(unit or r"\,")
