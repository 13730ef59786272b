"""Printed equations and verdicts as notebooks show them."""

from collections.abc import Iterator, Mapping
from typing import Any

from rigidsym.language.statement import condition, listed, point
from rigidsym.view.html.cards import badge, bullets, card, code, formula, head, muted, table
from rigidsym.view.html.markup import Markup, join

Row = tuple[Any, Any]


def equation_html(equation: Any) -> str:
    """An equation as printed, and how it is read."""
    return card(head(f"({equation.number})"), formula(equation.latex), muted(equation.reading))


def verdict_html(verdict: Any) -> str:
    """The verdict first; then the print, what mends it, when it holds, and where it fails."""
    title = head(f"({verdict.equation.number})", badge(str(verdict.ruling)))
    return card(title, table((), _rows(verdict)))


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
    if verdict.counterexample:
        yield muted("fails at"), _point(verdict.counterexample)
    if equation.readings:
        yield muted("readings"), bullets(_reading(verdict, r) for r in equation.readings)
    if equation.flaws:
        yield muted("flaws"), bullets(f"{flaw}: {text}" for flaw, text in equation.flaws.items())
    yield from _facts(equation)


def _facts(equation: Any) -> Iterator[Row]:
    for what, names in (("proved by", equation.proved_by), ("refuted by", equation.refuted_by)):
        if names:
            yield muted(what), join(*(join(code(name), " ") for name in names))


def _repair(text: str) -> str:
    return condition(text) or rf"\text{{{text}}}"


def _condition(text: str) -> Markup:
    found = condition(text)
    return formula(found) if found else join(text)


def _point(values: Mapping[str, str]) -> Markup:
    return formula(listed(point(values)))


def _reading(verdict: Any, reading: Any) -> Markup:
    fails = bool(reading.refuted_by)
    points = (verdict.points.get(name) for name in reading.refuted_by)
    where = next((p for p in points if p), None)
    said = join(reading.text, ": ", badge("fails" if fails else "holds"), " ", reading.implies)
    return join(said, _point(where)) if where else said
