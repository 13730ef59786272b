"""One line of a derivation as a notebook shows it, where the step has just run.

What was done stands first, the name of the fact on the right; then the equations with the paper's
numbers, and what must not be zero.
"""

import re
from collections.abc import Iterator

from rigidsym.view.article.formats import (
    Line,
    aligned,
    display,
    formulas,
    numbers,
    provided,
    sentence,
)
from rigidsym.view.article.mathematics import latex
from rigidsym.view.html.cards import card, code, formula, math, muted
from rigidsym.view.html.markup import Markup, tag

_ROW = "display:flex;justify-content:space-between;align-items:baseline;gap:1em"
_EQUATIONS = "min-width:0;padding-left:1.5em"


def line_html(line: Line) -> str:
    """A line as a card."""
    said = tag("span", *_prose(sentence(line)))
    head = tag("div", said, muted(code(line.fact.id)), style=f"{_ROW};padding-top:.4em")
    equations = tag("div", formula(aligned(line)), style=_EQUATIONS)
    body = tag("div", equations, muted(numbers(line)), style=_ROW)
    return card(head, body, *_where(line))


def line_latex(line: Line) -> str:
    """A line's equations as one display with the paper's numbers."""
    return f"$${display(line)}$$"


def _prose(text: str) -> Iterator[str | Markup]:
    """Prose with its formulas between dollars as mathematics."""
    for part in re.split(r"(\$[^$]*\$)", formulas(text)):
        yield math(part.strip("$")) if part.startswith("$") else part


def _where(line: Line) -> Iterator[Markup]:
    """What must not be zero, where there is something."""
    between = "where "
    parts: list[Markup] = []
    for condition in provided(line):
        parts += [muted(between), math(latex(condition))]
        between = ", "
    if parts:
        yield tag("div", *parts, style=_EQUATIONS)
