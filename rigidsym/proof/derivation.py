"""Execution of the derivation's chapters, which produces the ledger."""

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, field
from importlib import import_module, resources
from itertools import chain
from pathlib import Path
from time import perf_counter
from typing import Any

from sympy.core import random

from derivations import CHAPTERS, FORWARD
from derivations.setting import Setting
from rigidsym.errors import LedgerError, unknown
from rigidsym.io.ledger import sealed_text, specification_text
from rigidsym.language._specification import Unproved, require
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._computation import Computed, Standing, joined, reasons, standing
from rigidsym.proof.claims import Claim, Claims
from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger
from rigidsym.proof.steps import Step, StepError
from rigidsym.view._proofs import chapter_html, derivation_html


class DerivationError(RuntimeError):
    """Error for a chapter of the derivation that fails.

    The message names the chapter and gives the reason in one line.
    """


@dataclass(frozen=True, slots=True)
class Chapter:
    """Result of one chapter: its facts, its derivation steps and its run time in seconds.

    `contexts` are those that its facts are about, and `matrices` the matrices that these name.
    """

    name: str
    title: str
    facts: tuple[Fact, ...]
    seconds: float
    steps: tuple[Step, ...] = ()
    opening: str = ""
    contexts: Mapping[str, Context] = field(default_factory=dict)
    matrices: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)

    @property
    def standings(self) -> Counter[Standing]:
        """The numbers of facts whose statements were computed, chosen, printed and guessed."""
        return Counter(map(standing, self.facts))

    def __repr__(self) -> str:
        return f"<Chapter {self.name}: {self.title}, {len(self.facts)} facts>"

    def _repr_html_(self) -> str:
        facts = Claims(Claim(asdict(fact)) for fact in self.facts)
        return chapter_html(self, facts._repr_html_())


@dataclass(frozen=True, slots=True)
class Derivation:
    """Result of a derivation: its chapters and the ledger as text.

    `published` has the numbers of published facts and definitions of each standing, and
    `formulas` the ids of these facts.
    """

    chapters: tuple[Chapter, ...]
    ledger: str
    recounted: int = 0
    published: Mapping[str, Counter[Standing]] = field(default_factory=dict)
    formulas: frozenset[str] = frozenset()

    @property
    def mutants(self) -> Mapping[str, Mapping[str, int]]:
        """Counts of refuted, refused and equivalent mutants of each fact.

        Those of `recounted` facts were counted in this run.
        """
        return json.loads(self.ledger)["published"].get("mutants", {})

    def to_json(self) -> str:
        """Return all facts with their grades and sources as JSON text.

        The schema is rigidsym.derive/3.
        """
        chapters = [
            {
                "chapter": chapter.name,
                "title": chapter.title,
                **{kind: chapter.standings[kind] for kind in Standing},
                "facts": [*map(_entry, chapter.facts)],
            }
            for chapter in self.chapters
        ]
        return json.dumps({"schema": "rigidsym.derive/3", "chapters": chapters}, indent=1) + "\n"

    def __repr__(self) -> str:
        facts = sum(len(chapter.facts) for chapter in self.chapters)
        return f"<Derivation: {facts} facts in {len(self.chapters)} chapters>"

    def _repr_html_(self) -> str:
        return derivation_html(self)


def _entry(fact: Fact) -> Mapping[str, object]:
    """Return a fact as an entry of JSON."""
    said = {"id": fact.id, "statement": statement(fact), "grade": fact.grade, "source": fact.source}
    typed = [*map(str, joined(fact))]
    return {**said, "standing": standing(fact), "reasons": reasons(fact), "joined": typed}


def _formulas(ledger: Ledger) -> frozenset[str]:
    """Return the ids of the facts that are published."""
    entries = chain.from_iterable(chain(*group.values()) for group in _groups(ledger))
    return frozenset(entry["fact"] for entry in entries if "fact" in entry)


def _groups(ledger: Ledger) -> list[Mapping[str, Any]]:
    return [ledger.published.get(group, {}) for group in ("sequences", "forms")]


def _published(ledger: Ledger) -> Mapping[str, Counter[Standing]]:
    """Return how many published facts and definitions have each standing.

    A definition is computed, or it is chosen: it gives a name to a formula.  Readings give a name
    to a standard function and are not counted.
    """
    found: dict[tuple[str, str], Standing] = {}
    for group in _groups(ledger):
        for entry in chain(*group.values()):
            if "fact" in entry:
                found["facts", entry["fact"]] = standing(ledger.facts[entry["fact"]])
            elif "definition" in entry:
                context, name = ledger.contexts[entry["context"]], entry["definition"]
                typed = not isinstance(context.definitions[name], Computed)
                place = f"{context.name}.{name}"
                found["definitions", place] = Standing.CHOSEN if typed else Standing.COMPUTED
    return {
        kind: Counter(value for (there, _), value in found.items() if there == kind)
        for kind in ("facts", "definitions")
    }


def sealed_path() -> Path:
    """Return the path of the installed sealed ledger."""
    return Path(str(resources.files("derivations").joinpath("ledger.json")))


def derive(
    wanted: Iterable[str] = (),
    progress: Callable[[int, int], None] = lambda done, total: None,
    setting: Setting | None = None,
    sealed: str = "",
) -> Derivation:
    """Run the chapters of the derivation and return them with the ledger.

    Parameters
    ----------
    wanted
        Chapters to report; the chapters before the last of them run too.  All if empty.
    progress
        Called with the number of chapters done and to do.
    setting
        Derive for this group, sequence of turns, basis and Lagrangian instead of the paper's: only
        the chapters up to Theorem 1.
    sealed
        Text of a ledger from which counts of mutants are taken for unchanged facts.

    Returns
    -------
    Derivation
        The chapters, and the ledger as text.

    Raises
    ------
    InputError
        If a chapter is unknown.
    DerivationError
        If a step cannot be done, a claim is not proved, or a theorem of the specification is
        missing.
    """
    chosen, known = tuple(wanted), CHAPTERS if setting is None else FORWARD
    for name in chosen:
        if name not in known:
            varied = setting is not None and name in CHAPTERS
            others = ": others are the paper's alone" if varied else ""
            raise unknown("chapter", name, known, others, plain=True)
    last = max(map(known.index, chosen), default=len(known) - 1)
    # SymPy factors by numbers that it draws, and some of them take it minutes: draw the same ones.
    random.seed(0)
    builder, ran = LedgerBuilder(sealed), []
    builder.keep(setting or Setting())
    try:
        for done, name in enumerate(known[: last + 1]):
            progress(done, last + 1)
            ran.append(_run(builder, name))
    finally:
        progress(last + 1, last + 1)
    text = builder.ledger.to_text()
    if setting is None and last == len(known) - 1:
        require_specified(text)
    reported = tuple(chapter for chapter in ran if not chosen or chapter.name in chosen)
    found = builder.ledger
    return Derivation(reported, text, builder.recounted, _published(found), _formulas(found))


def sealed_counts() -> str:
    """Return the text of the sealed ledger with its mutant counts, or "" if none is installed."""
    try:
        return sealed_text()
    except LedgerError:
        return ""


def require_specified(ledger: str) -> None:
    """Raise DerivationError unless a ledger proves every theorem of the specification."""
    try:
        require(specification_text(), json.loads(ledger))
    except Unproved as error:
        raise DerivationError(str(error)) from None


def _run(builder: LedgerBuilder, name: str) -> Chapter:
    facts, steps, start = len(builder.ledger.facts), len(builder.steps), perf_counter()
    try:
        module = import_module(f"derivations.{name}")
        module.derive(builder)
    except (KernelError, StepError) as error:
        raise DerivationError(f"chapter {name}: {error}") from None
    except Exception as error:
        raise DerivationError(f"chapter {name}: {type(error).__name__}: {error}") from error
    head, _, opening = (module.__doc__ or name).strip().partition("\n\n")
    # The title of a chapter ends at the first colon or full stop of its docstring.
    title = " ".join(re.split(r"[:.](?:\s|$)", head)[0].split())
    found = tuple(builder.ledger.facts.values())[facts:]
    seconds = perf_counter() - start
    about = chain.from_iterable(
        (*(fact.rhs if fact.kind in ("model", "partition") else ()), fact.context) for fact in found
    )
    contexts = {context: builder.ledger.contexts[context] for context in about}
    matrices = {context: builder.matrices.get(context, {}) for context in contexts}
    taken = tuple(builder.steps[steps:])
    return Chapter(name, title, found, seconds, taken, opening, contexts, matrices)


def statement(fact: Fact) -> str:
    """Return the statement of a fact as one line of text."""
    form = {
        "equal": "{} = {}",
        "unequal": "{} != {}",
        "root": "{} = sqrt({})",
        "nonnegative": "{} = {} >= 0",
    }.get(fact.kind)
    if fact.kind == "partition":
        return f"{fact.context}, by the sign of {fact.lhs[0]}: one of {', '.join(fact.rhs)}"
    if form is None:
        return f"{fact.context} is a model of {fact.rhs[0]}"
    return "; ".join(form.format(*sides) for sides in zip(fact.lhs, fact.rhs, strict=True))
