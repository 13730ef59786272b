"""Printed equations and verdicts as notebooks show them."""

from collections.abc import Iterator, Mapping
from typing import Any

from rigidsym.language.latex import condition, point
from rigidsym.view.html.cards import (
    badge,
    bullets,
    card,
    code,
    entries,
    formula,
    formulas,
    head,
    muted,
)
from rigidsym.view.html.markup import Markup, join, tag

Row = tuple[Any, Any]


def equation_html(equation: Any) -> str:
    """An equation as printed, and how it is read."""
    return card(head(f"({equation.number})"), formula(equation.latex), muted(equation.reading))


def verdict_html(verdict: Any) -> str:
    """The verdict first; then the print, what mends it, when it holds, and where it fails."""
    title = head(f"({verdict.equation.number})", badge(str(verdict.ruling)))
    return card(title, entries(_rows(verdict)))


def _rows(verdict: Any) -> Iterator[Row]:
    equation = verdict.equation
    yield muted("as printed"), formula(equation.latex)
    yield muted("read as"), equation.reading
    if equation.repair:
        yield muted("as derived"), formula(equation.repair)
    if verdict.repairs:
        yield muted("found by search"), join(*(formula(_repair(r)) for r in verdict.repairs))
    if verdict.conditions:
        yield muted("holds if"), join(*map(_condition, verdict.conditions))
    for number in verdict.right_with:
        yield muted("right as printed"), f"once ({number}) is mended"
    if verdict.roots:
        yield muted("root cause"), bullets(map(str, verdict.roots))
    if verdict.counterexample:
        yield muted("fails at"), _fails(verdict.counterexample)
    if verdict.readings:
        yield muted("readings"), bullets(map(_reading, verdict.readings))
    if equation.flaws:
        yield muted("flaws"), bullets(f"{flaw}: {text}" for flaw, text in equation.flaws.items())
    yield from _facts(verdict)


def _facts(verdict: Any) -> Iterator[Row]:
    every = {
        "proved by": verdict.proved_by,
        "refuted by": verdict.refuted_by,
        "repaired by": verdict.repaired_by,
    }
    for what, names in every.items():
        if names:
            yield muted(what), join(*(join(code(name), " ") for name in names))


def _repair(text: str) -> str:
    return condition(text) or rf"\text{{{text}}}"


def _condition(text: str) -> Markup:
    found = condition(text)
    return formula(found) if found else join(text)


def _point(values: Mapping[str, str]) -> Markup:
    return formulas(point(values))


def _fails(found: Any) -> Markup:
    """The motion, if the point is of one; both sides there, and the point."""
    motion = [str(found.motion)] if found.motion else []
    lines = (tag("div", text) for text in (*motion, *found.sides))
    return join(*lines, _point(found.point))


def _reading(read: Any) -> Markup:
    said = join(
        read.reading.text,
        ": ",
        badge("holds" if read.holds else "fails"),
        " ",
        read.reading.implies,
    )
    return join(said, _point(read.counterexample.point)) if read.counterexample else said
