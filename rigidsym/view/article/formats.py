"""The lines of chapters, each with what was done, its equations, conditions, numbers and fact."""

import re
from collections.abc import Callable, Iterable, Iterator, Sequence

import sympy

from rigidsym.language.latex import GREEK, dotted, symbol
from rigidsym.view.article.mathematics import latex, pretty
from rigidsym.view.article.protocols import Chapter, Line
from rigidsym.view.html.markup import Markup, join, lines, tag

# A row that is longer than so many letters of LaTeX is broken where it can be.
LONG = 150


# Names of quantities in prose: phi1', Omega_i^2, R^-1; M alone, but not "A" of a sentence.
_GREEK = "|".join(sorted(GREEK, key=len, reverse=True))
NAMES = re.compile(
    rf"\b(?P<name>(?:(?:{_GREEK})[1-3]?(?:_[ijk])?|[AcqFMb][0-3](?![0-9])|b_free|K|H|M|R|B|S|sn))\b"
    r"(?P<prime>')?(?:\^(?P<power>-?[0-9]))?"
)


def article(chapters: Iterable[Chapter], form: str) -> str:
    """Chapters in one of `FORMATS`; those without steps are left out.

    Raises ImportError where HTML is asked for and latex2mathml is not installed.
    """
    return FORMATS[form]([chapter for chapter in chapters if chapter.steps])


def numbers(line: Line) -> str:
    """The paper's numbers of a line: (31), (32)."""
    return ", ".join(f"({n})" if n[0].isdigit() else n for n in line.source)


def provided(line: Line) -> Iterator[sympy.Basic]:
    """What must not be zero, as inequalities."""
    return (sympy.Ne(condition, 0, evaluate=False) for condition in line.conditions)


def _text(chapters: Sequence[Chapter]) -> str:
    found: list[str] = []
    for chapter in chapters:
        found += [chapter.title, "=" * len(chapter.title), ""]
        found += [f"{line_text(line)}\n" for line in chapter.steps]
    return "\n".join(found)


def line_text(line: Line) -> str:
    """A line for a terminal."""
    where = ["where " + pretty(condition) for condition in provided(line)]
    below = [*map(pretty, line.shown), *where, f"[{line.fact.id}]"]
    return "\n".join([f"{sentence(line)}  {numbers(line)}".rstrip(), "", *map(_indented, below)])


def _indented(text: str) -> str:
    return "\n".join(f"    {row}".rstrip() for row in text.split("\n"))


def sentence(line: Line) -> str:
    """What was done, and what was chosen."""
    formula = NAMES.match(line.why) or re.match(r"\w+\(", line.why)
    words = line.why if formula else line.why[:1].upper() + line.why[1:]
    whole = f"{words}; {line.choice}" if line.choice else words
    return whole if whole.endswith("?") else f"{whole}:"


def formulas(prose: str) -> str:
    """Prose with the names of quantities in LaTeX."""
    return NAMES.sub(lambda found: f"${_name(found)}$", prose)


def _name(found: re.Match[str]) -> str:
    text = symbol(found["name"]).latex
    primed = dotted(text) if found["prime"] else text
    return f"{primed}^{{{found['power']}}}" if found["power"] else primed


def _markdown(chapters: Sequence[Chapter]) -> str:
    found: list[str] = []
    for chapter in chapters:
        found += [f"## {formulas(chapter.title)}", "", formulas(_prose(chapter)), ""]
        for line in chapter.steps:
            found += [formulas(sentence(line)), "", f"$${display(line)}$$", ""]
            found += [f"`{line.fact.id}`{_where(line)}", ""]
    return "\n".join(found)


def _where(line: Line) -> str:
    conditions = ", ".join(f"${latex(c)}$" for c in provided(line))
    return f", where {conditions}" if conditions else ""


def display(line: Line, fit: str = "") -> str:
    """The equations of a line with the paper's numbers; in the macro `fit` if given."""
    shown = f"{fit}{{{aligned(line)}}}" if fit else aligned(line)
    tags = numbers(line).replace("^-1", "^{-1}")
    return rf"{shown}\tag*{{{_tag(tags)}}}" if tags else shown


def aligned(line: Line) -> str:
    """The equations of a line, under each other where there are several."""
    rows = [row for equation in line.shown for row in _rows(equation)]
    if len(rows) == 1:
        return rows[0].replace("&", "")
    below = r" \\ ".join(rows)
    return rf"\begin{{aligned}}{below}\end{{aligned}}"


def _rows(equation: sympy.Basic) -> list[str]:
    """left &= right; where that is long, a row for each term of matrices, or one for each side."""
    left, right = equation.args
    terms = right.args if isinstance(right, sympy.MatAdd) else ()
    if len(terms) < 2 and len(latex(equation)) > 2 * LONG:
        return [f"&{latex(left)}", rf"&\quad = {latex(right)}"]
    if len(terms) < 2 or len(latex(equation)) < LONG:
        return [f"{latex(left)} &= {latex(right)}"]
    first, *rest = map(latex, terms)
    signed = (text if text.startswith("-") else f"+ {text}" for text in rest)
    return [f"{latex(left)} &= {first}", *(rf"&\quad {text}" for text in signed)]


def _tag(text: str) -> str:
    return re.sub(r"R\^\{-1\} dR/dt", r"$R^{-1}\\dot R$", text)


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


def _latex(chapters: Sequence[Chapter]) -> str:
    found = [_PREAMBLE]
    for chapter in chapters:
        found += [rf"\section{{{_escaped(chapter.title)}}}", _escaped(_prose(chapter)), ""]
        for line in chapter.steps:
            name = line.fact.id.replace("_", r"\_\allowbreak ").replace(".", r".\allowbreak ")
            found += [rf"\step {_escaped(sentence(line))}\fact{{{name}}}", _environment(line)]
            if where := _where(line):
                found.append(f"{where[2:]}.")
            found.append("")
    return "\n".join([*found, r"\end{document}", ""])


def _environment(line: Line) -> str:
    return "\\begin{equation*}\n" + display(line, r"\fit") + "\n\\end{equation*}"


def _prose(chapter: Chapter) -> str:
    """The opening without its formulas, which the lines below have."""
    parts = chapter.opening.strip().split("\n\n")
    return "\n\n".join(" ".join(part.split()) for part in parts if not part.startswith("    "))


def _escaped(text: str) -> str:
    """Prose for LaTeX: names of quantities in their letters, what is special escaped."""
    parts = re.split(r"(\$[^$]*\$)", formulas(text.replace("`", "")))
    return "".join(part if part.startswith("$") else _plain(part) for part in parts)


def _plain(text: str) -> str:
    for mark in "_#%&":
        text = text.replace(mark, f"\\{mark}")
    return text.replace("^", r"\^{}").replace("|", r"$\mid$")


def _html(chapters: Sequence[Chapter]) -> str:
    from latex2mathml.converter import convert

    def mathematics(text: str, display: str = "block") -> Markup:
        return Markup(convert(text, display=display))

    body: list[Markup] = []
    for chapter in chapters:
        body += [tag("h2", chapter.title), tag("p", _prose(chapter))]
        for line in chapter.steps:
            rows = [mathematics(latex(equation)) for equation in line.shown]
            where = [mathematics(latex(c), "inline") for c in provided(line)]
            note = join(" where ", *where) if where else ""
            body.append(tag("p", sentence(line), tag("code", line.fact.id, class_="fact")))
            body.append(
                tag("div", *rows, tag("span", numbers(line), class_="number"), class_="line")
            )
            body += [tag("p", note, class_="where")] if note else []
    title = "The torque-free motion of a rigid body, derived"
    head = lines(tag("meta", charset="utf-8"), tag("title", title), tag("style", Markup(_STYLE)))
    page = tag("html", tag("head", head), tag("body", tag("h1", title), lines(*body)), lang="en")
    return f"<!doctype html>\n{page}\n"


_STYLE = """
body { font: 1rem/1.5 Georgia, serif; max-width: 52rem; margin: 2rem auto; padding: 0 1rem; }
.line { display: flex; flex-wrap: wrap; align-items: center; overflow-x: auto; }
.line math { flex: 1 1 100%; } .number { margin-left: auto; }
.fact { float: right; font-size: 0.75rem; color: #666; } .where { margin-left: 2rem; }
"""

# What a derivation can be written as.
FORMATS: dict[str, Callable[[Sequence[Chapter]], str]] = {
    "text": _text,
    "markdown": _markdown,
    "latex": _latex,
    "html": _html,
}
