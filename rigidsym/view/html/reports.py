"""Validation reports and derivations as notebooks show them: the verdict first."""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Protocol

from rigidsym.view.html.cards import badge, bullets, card, code, counted, head, muted, table
from rigidsym.view.html.markup import Markup, join
from rigidsym.view.report_data import Implementation, Report

PASSED, BROKEN = "passed", "NOT PASSED"


class Reported(Protocol):
    """A validation report."""

    def to_data(self) -> Report:
        """All that it says."""
        ...


class Fact(Protocol):
    """What was proved."""

    @property
    def grade(self) -> str:
        """How well."""
        ...


class Chapter(Protocol):
    """A chapter that ran, and its facts."""

    @property
    def name(self) -> str:
        """Of its file."""
        ...

    @property
    def title(self) -> str:
        """For readers."""
        ...

    @property
    def facts(self) -> Sequence[Fact]:
        """In their order."""
        ...


class Derivation(Protocol):
    """Chapters that ran."""

    @property
    def chapters(self) -> Sequence[Chapter]:
        """In their order."""
        ...


def report_html(report: Reported) -> str:
    """Passed or not and why, then the strata: cases, and the worst of each implementation."""
    data = report.to_data()
    title = head("Validation", badge(PASSED if data["passed"] else BROKEN), code(data["command"]))
    names = [implementation["name"] for implementation in data["implementations"]]
    columns = ("stratum", "cases", "states", *(f"{name}: angle, bound used" for name in names))
    said = [bullets(data["complaints"])] if data["complaints"] else []
    unit = muted("worst rotation angle in units of 2⁻⁵³ rad; the largest part used of any bound")
    return card(title, *said, table(columns, _strata(data)), unit)


def _strata(data: Report) -> Iterator[tuple[object, ...]]:
    for stratum in data["strata"]:
        cells = [
            _cell(implementation, stratum["name"]) for implementation in data["implementations"]
        ]
        yield stratum["name"], stratum["cases"], stratum["states"], *cells


def _cell(implementation: Implementation, stratum: str) -> Markup:
    found = implementation["strata"].get(stratum, {}).get("angle")
    shares = [float(cell["units"]) for cell in implementation["shares"].get(stratum, {}).values()]
    if found is None or not shares:
        return join(muted("not asked"))
    share = _part(max(shares))
    return join(f"{float(found['units']):.3g}, ", share if max(shares) <= 1 else badge(share))


def _part(share: float) -> str:
    """Per cent, or how many times as much as there is."""
    if share == float("inf"):
        return "∞"
    return f"{share:.0%}" if share < 10 else f"{share:.2g} times"


def derivation_html(derivation: Derivation) -> str:
    """The chapters that ran, with the facts each of them proved and their grades."""
    rows = [(code(c.name), c.title, len(c.facts), _grades(c)) for c in derivation.chapters]
    total = sum(len(chapter.facts) for chapter in derivation.chapters)
    title = head(f"{counted(total, 'fact')} in {counted(len(derivation.chapters), 'chapter')}")
    return card(title, table(("chapter", "", "facts", "grades"), rows))


def chapter_html(chapter: Chapter, facts: str) -> str:
    """A chapter's title, and its facts as they are shown."""
    return join(card(head(chapter.title, _grades(chapter))), Markup(facts))


def _grades(chapter: Chapter) -> Markup:
    counts = Counter(str(fact.grade) for fact in chapter.facts)
    return join(*(join(badge(grade), f" {count} ") for grade, count in sorted(counts.items())))
