"""A derivation as an article, line by line: for a terminal, in Markdown, LaTeX and HTML.

A line has a sentence on the step, its equations with the paper's numbers, the conditions under
which it holds, and the name of its fact.  `line_html`, `line_latex` and `line_text` return one
line, as notebooks show it where the step has just run.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import sympy

from rigidsym.language._latex import GREEK, dotted, symbol
from rigidsym.view._article.mathematics import latex, pretty
from rigidsym.view._html.cards import Markup, card, code, formula, math, muted, tag
from rigidsym.view._pages import render

if TYPE_CHECKING:
    from rigidsym.proof.derivation import Chapter
    from rigidsym.proof.steps._record import Step

# A row of more letters of LaTeX than these is broken, if it has more than one term.
LONG = 150
# Names of quantities in prose: phi1', Omega_i^2, R^-1; M alone, but not "A" of a sentence.
_GREEK = "|".join(sorted(GREEK, key=len, reverse=True))
NAMES = re.compile(
    rf"\b(?P<name>(?:(?:{_GREEK})[1-3]?(?:_[ijk])?|[AcqFMb][0-3](?![0-9])|b_free|K|H|M|R|B|S|sn))\b"
    r"(?P<prime>')?(?:\^(?P<power>-?[0-9]))?"
)
_ROW = "display:flex;justify-content:space-between;align-items:baseline;gap:1em"
_EQUATIONS = "min-width:0;padding-left:1.5em"


def article(chapters: Iterable["Chapter"], form: str) -> str:
    """Return chapters in one of `FORMATS`, without chapters that have no steps.

    Raises ImportError for HTML if latex2mathml is not installed.
    """
    return FORMATS[form]([chapter for chapter in chapters if chapter.steps])


def numbers(line: "Step") -> str:
    """Return the paper's numbers of a line: (31), (32)."""
    return ", ".join(f"({n})" if n[0].isdigit() else n for n in line.source)


def provided(line: "Step") -> Iterator[sympy.Basic]:
    """Return the expressions that must not be zero, as inequalities."""
    return (sympy.Ne(condition, 0, evaluate=False) for condition in line.conditions)


def _text(chapters: Sequence["Chapter"]) -> str:
    found: list[str] = []
    for chapter in chapters:
        found += [chapter.title, "=" * len(chapter.title), ""]
        found += [f"{line_text(line)}\n" for line in chapter.steps]
    return "\n".join(found)


def line_text(line: "Step") -> str:
    """Return a line for a terminal."""
    where = ["where " + pretty(condition) for condition in provided(line)]
    below = [*map(pretty, line.shown), *where, f"[{line.fact.id}]"]
    rows = [f"    {row}".rstrip() for text in below for row in text.split("\n")]
    return "\n".join([f"{sentence(line)}  {numbers(line)}".rstrip(), "", *rows])


def sentence(line: "Step") -> str:
    """Return a sentence on what a step did and chose."""
    formula = NAMES.match(line.why) or re.match(r"\w+\(", line.why)
    words = line.why if formula else line.why[:1].upper() + line.why[1:]
    whole = f"{words}; {line.choice}" if line.choice else words
    return whole if whole.endswith("?") else f"{whole}:"


def formulas(prose: str) -> str:
    """Return prose with the names of quantities in LaTeX."""

    def name(found: re.Match[str]) -> str:
        text = symbol(found["name"]).latex
        primed = dotted(text) if found["prime"] else text
        return f"${primed}^{{{found['power']}}}$" if found["power"] else f"${primed}$"

    return NAMES.sub(name, prose)


def _markdown(chapters: Sequence["Chapter"]) -> str:
    found: list[str] = []
    for chapter in chapters:
        found += [f"## {formulas(chapter.title)}", "", formulas(_prose(chapter)), ""]
        for line in chapter.steps:
            found += [formulas(sentence(line)), "", f"$${display(line)}$$", ""]
            found += [f"`{line.fact.id}`{_where(line)}", ""]
    return "\n".join(found)


def _where(line: "Step") -> str:
    conditions = ", ".join(f"${latex(c)}$" for c in provided(line))
    return f", where {conditions}" if conditions else ""


def display(line: "Step", fit: str = "") -> str:
    """Return the equations of a line with the paper's numbers, in the macro `fit` if given."""
    shown = f"{fit}{{{aligned(line)}}}" if fit else aligned(line)
    tags = numbers(line).replace("^-1", "^{-1}").replace("R^{-1} dR/dt", r"$R^{-1}\dot R$")
    return rf"{shown}\tag*{{{tags}}}" if tags else shown


def aligned(line: "Step") -> str:
    """Return the equations of a line in LaTeX, one below the other."""
    rows = [row for equation in line.shown for row in _rows(equation)]
    if len(rows) == 1:
        return rows[0].replace("&", "")
    below = r" \\ ".join(rows)
    return rf"\begin{{aligned}}{below}\end{{aligned}}"


def _rows(equation: sympy.Basic) -> list[str]:
    """Return the row left &= right; if that is long, one for each matrix term or side."""
    left, right = equation.args
    terms = right.args if isinstance(right, sympy.MatAdd) else ()
    if len(terms) < 2 and len(latex(equation)) > 2 * LONG:
        return [f"&{latex(left)}", rf"&\quad = {latex(right)}"]
    if len(terms) < 2 or len(latex(equation)) < LONG:
        return [f"{latex(left)} &= {latex(right)}"]
    first, *rest = map(latex, terms)
    signed = (text if text.startswith("-") else f"+ {text}" for text in rest)
    return [f"{latex(left)} &= {first}", *(rf"&\quad {text}" for text in signed)]


_PREAMBLE = r"""\documentclass[11pt]{article}
\usepackage[a4paper,left=22mm,right=42mm,top=22mm,bottom=24mm,marginparwidth=34mm]{geometry}
\usepackage[T1]{fontenc}
\usepackage{amsmath,amssymb,graphicx}
\allowdisplaybreaks
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt plus 2pt}
\newcommand{\fact}[1]{\marginpar{\raggedright\scriptsize\ttfamily #1}}
\newcommand{\step}{\par\vskip 0pt plus 6\baselineskip\penalty-200\vskip 0pt plus -6\baselineskip}
\newsavebox{\display}
\newcommand{\fit}[1]{\sbox{\display}{$\displaystyle #1$}%
  \ifdim\wd\display>\linewidth\resizebox{\linewidth}{!}{\usebox{\display}}\else#1\fi}
\title{The torque-free motion of a rigid body, derived}
\date{}
\begin{document}
\maketitle
"""


def _latex(chapters: Sequence["Chapter"]) -> str:
    found = [_PREAMBLE]
    for chapter in chapters:
        found += [rf"\section{{{_escaped(chapter.title)}}}", _escaped(_prose(chapter)), ""]
        for line in chapter.steps:
            name = line.fact.id.replace("_", r"\_\allowbreak ").replace(".", r".\allowbreak ")
            equations = ["\\begin{equation*}", display(line, r"\fit"), "\\end{equation*}"]
            found += [rf"\step {_escaped(sentence(line))}\fact{{{name}}}", *equations]
            if where := _where(line):
                found.append(f"{where[2:]}.")
            found.append("")
    return "\n".join([*found, r"\end{document}", ""])


def _prose(chapter: "Chapter") -> str:
    """Return the opening without its formulas, which the lines below have."""
    parts = chapter.opening.strip().split("\n\n")
    return "\n\n".join(" ".join(part.split()) for part in parts if not part.startswith("    "))


def _escaped(text: str) -> str:
    """Return prose in LaTeX: names of quantities as symbols, special characters escaped."""
    parts = re.split(r"(\$[^$]*\$)", formulas(text.replace("`", "")))
    special = {**{mark: f"\\{mark}" for mark in "_#%&"}, "^": r"\^{}", "|": r"$\mid$"}
    escapes = str.maketrans(special)
    return "".join(part if part.startswith("$") else part.translate(escapes) for part in parts)


def _html(chapters: Sequence["Chapter"]) -> str:
    from latex2mathml.converter import convert

    def line(step: "Step") -> dict[str, object]:
        return {
            "sentence": sentence(step),
            "fact": step.fact.id,
            "numbers": numbers(step),
            "equations": [convert(latex(equation), display="block") for equation in step.shown],
            "where": [convert(latex(c), display="inline") for c in provided(step)],
        }

    found = [
        {"title": x.title, "prose": _prose(x), "lines": [line(step) for step in x.steps]}
        for x in chapters
    ]
    return render("article.html", chapters=found)


def line_html(line: "Step") -> str:
    """Return a line as a card: the sentence and the fact, the equations, the conditions."""
    parts = re.split(r"(\$[^$]*\$)", formulas(sentence(line)))
    said = tag("span", *(math(x.strip("$")) if x.startswith("$") else x for x in parts))
    head = tag("div", said, muted(code(line.fact.id)), style=f"{_ROW};padding-top:.4em")
    equations = tag("div", formula(aligned(line)), style=_EQUATIONS)
    body = tag("div", equations, muted(numbers(line)), style=_ROW)
    where: list[Markup] = []
    for condition in provided(line):
        where += [muted(", " if where else "where "), math(latex(condition))]
    return card(head, body, tag("div", *where, style=_EQUATIONS) if where else "")


def line_latex(line: "Step") -> str:
    """Return the equations of a line as one display with the paper's numbers."""
    return f"$${display(line)}$$"


# The formats that a derivation can be written in, by name.
FORMATS: dict[str, Callable[[Sequence["Chapter"]], str]] = {
    "text": _text,
    "markdown": _markdown,
    "latex": _latex,
    "html": _html,
}
