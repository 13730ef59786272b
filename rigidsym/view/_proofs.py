"""Notebook cards of derivations, equations of the paper, and verdicts on them."""

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rigidsym.language._latex import condition, point
from rigidsym.view import _cards as cards
from rigidsym.view._cards import (
    Markup,
    badge,
    card,
    code,
    counted,
    formula,
    head,
    join,
    math,
    muted,
)

if TYPE_CHECKING:
    from rigidsym.proof.derivation import Chapter, Derivation
    from rigidsym.proof.paper._equation import Equation
    from rigidsym.proof.paper._verdicts import Verdict


def derivation_html(derivation: "Derivation") -> str:
    """Return a notebook card that lists the chapters of a derivation with counts of their facts.

    The counts are for each grade of a fact: assumed, enclosed or proved.
    """
    rows = [(code(c.name), c.title, len(c.facts), _grades(c)) for c in derivation.chapters]
    total = sum(len(chapter.facts) for chapter in derivation.chapters)
    title = head(f"{counted(total, 'fact')} in {counted(len(derivation.chapters), 'chapter')}")
    return card(title, cards.table(("chapter", "", "facts", "grades"), rows))


def chapter_html(chapter: "Chapter", facts: str) -> str:
    """Return a notebook card with a chapter's title and counts of facts by grade, then its facts.

    facts: their HTML.
    """
    return join(Markup(card(head(chapter.title, _grades(chapter)))), Markup(facts))


def _grades(chapter: "Chapter") -> Markup:
    counts = Counter(str(fact.grade) for fact in chapter.facts)
    return join(*(join(badge(grade), f" {count} ") for grade, count in sorted(counts.items())))


def equation_html(equation: "Equation") -> str:
    """Return a notebook card with an equation as the paper prints it, and its interpretation."""
    return card(head(f"({equation.number})"), formula(equation.latex), muted(equation.reading))


def verdict_html(verdict: "Verdict") -> str:
    """Return a notebook card with the verdict on an equation of the paper.

    It shows the equation as printed, its repairs, and where it fails.
    """
    title = head(f"({verdict.equation.number})", badge(str(verdict.ruling)))
    return card(title, cards.entries((muted(name), said) for name, said in _rows(verdict)))


def _rows(verdict: "Verdict") -> Iterator[tuple[str, object]]:
    equation = verdict.equation
    yield "as printed", formula(equation.latex)
    yield "read as", equation.reading
    if equation.repair:
        yield "as derived", formula(equation.repair)
    if verdict.repairs:
        mended = (condition(text) or rf"\text{{{text}}}" for text in verdict.repairs)
        yield "found by search", join(*map(formula, mended))
    if verdict.conditions:
        needed = ((condition(text), text) for text in verdict.conditions)
        yield "holds if", join(*(formula(latex) if latex else text for latex, text in needed))
    for number in verdict.right_with:
        yield "right as printed", f"once ({number}) is mended"
    if verdict.roots:
        yield "root cause", cards.bullets(map(str, verdict.roots))
    if found := verdict.counterexample:
        motion = [str(found.motion)] if found.motion else []
        lines = (cards.tag("div", text) for text in (*motion, *found.sides))
        yield "fails at", join(*lines, cards.formulas(point(found.point)))
    if verdict.readings:
        said = []
        for read in verdict.readings:
            decided = badge("holds" if read.holds else "fails")
            at = read.counterexample and cards.formulas(point(read.counterexample.point))
            said.append(join(read.reading.text, ": ", decided, " ", read.reading.implies, at or ""))
        yield "readings", cards.bullets(said)
    if equation.flaws:
        # Of a symbol that is not defined, the text is the symbol in LaTeX.
        shown = (
            (x, math(text) if x.name == "UNDEFINED" else text) for x, text in equation.flaws.items()
        )
        yield "flaws", cards.bullets(join(str(flaw), ": ", text) for flaw, text in shown)
    for what, names in (
        ("proved by", verdict.proved_by),
        ("refuted by", verdict.refuted_by),
        ("repaired by", verdict.repaired_by),
    ):
        if names:
            yield what, join(*(join(code(name), " ") for name in names))
