"""Printed equations and verdicts as notebooks show them."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Protocol

from rigidsym.language.statement import condition, listed, point
from rigidsym.view.html.cards import badge, bullets, card, code, formula, head, muted, table
from rigidsym.view.html.markup import Markup, join

Row = tuple[Markup, Markup | str]


class Reading(Protocol):
    """One way to read the print, what follows from it, and the facts that refute it so read."""

    @property
    def text(self) -> str:
        """The reading."""
        ...

    @property
    def implies(self) -> str:
        """What follows."""
        ...

    @property
    def refuted_by(self) -> Sequence[str]:
        """Names of facts."""
        ...


class Flaws(Protocol):
    """Texts by what is wrong."""

    def items(self) -> Iterable[tuple[str, str]]:
        """Pairs of them."""
        ...


class Equation(Protocol):
    """One printed equation: its number, LaTeX, how it is read, and the facts that decide it."""

    @property
    def number(self) -> str:
        """As printed."""
        ...

    @property
    def latex(self) -> str:
        """As printed."""
        ...

    @property
    def reading(self) -> str:
        """How it is read."""
        ...

    @property
    def repair(self) -> str:
        """What mends it, in LaTeX; "" where nothing has to."""
        ...

    @property
    def readings(self) -> Sequence[Reading]:
        """Where there are several."""
        ...

    @property
    def flaws(self) -> Flaws:
        """What is wrong with the print besides."""
        ...

    @property
    def proved_by(self) -> Sequence[str]:
        """Names of facts."""
        ...

    @property
    def refuted_by(self) -> Sequence[str]:
        """Names of facts."""
        ...


class Verdict(Protocol):
    """The ruling on an equation, and what it rests on."""

    @property
    def equation(self) -> Equation:
        """What is ruled on."""
        ...

    @property
    def ruling(self) -> str:
        """In a word."""
        ...

    @property
    def repairs(self) -> Sequence[str]:
        """What the repair search found."""
        ...

    @property
    def conditions(self) -> Sequence[str]:
        """When it holds."""
        ...

    @property
    def counterexample(self) -> Mapping[str, str] | None:
        """Where it fails."""
        ...

    @property
    def points(self) -> Mapping[str, Mapping[str, str]]:
        """The counterexample of each refuting fact."""
        ...


def equation_html(equation: Equation) -> str:
    """An equation as printed, and how it is read."""
    return card(head(f"({equation.number})"), formula(equation.latex), muted(equation.reading))


def verdict_html(verdict: Verdict) -> str:
    """The verdict first; then the print, what mends it, when it holds, and where it fails."""
    title = head(f"({verdict.equation.number})", badge(str(verdict.ruling)))
    return card(title, table((), _rows(verdict)))


def _rows(verdict: Verdict) -> Iterator[Row]:
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


def _facts(equation: Equation) -> Iterator[Row]:
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


def _reading(verdict: Verdict, reading: Reading) -> Markup:
    fails = bool(reading.refuted_by)
    points = (verdict.points.get(name) for name in reading.refuted_by)
    where = next((p for p in points if p), None)
    said = join(reading.text, ": ", badge("fails" if fails else "holds"), " ", reading.implies)
    return join(said, _point(where)) if where else said
