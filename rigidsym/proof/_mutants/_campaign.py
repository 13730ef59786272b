"""The campaign: every mutant is refuted, refused, shown to be equivalent, or unnoticed."""

import json
import re
import tomllib
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from random import Random
from typing import Any, TypeAlias

import numpy as np

from rigidsym.language._specification import Proved, theorems
from rigidsym.proof._mutants._edits import Edit
from rigidsym.proof._mutants._forger import Forger
from rigidsym.proof._mutants._publications import meanings, publications, rates
from rigidsym.proof._mutants._screen import Mutant, Screen

Ledger: TypeAlias = Mapping[str, Any]
Submit: TypeAlias = Callable[..., Future[str]]
REFUTED, SPECIFICATION, NUMBERS = "refuted at a point", "by the specification", "by numbers"
EQUIVALENT, UNNOTICED = "equivalent", "unnoticed"
FATES = (REFUTED, SPECIFICATION, NUMBERS, EQUIVALENT, UNNOTICED)


@dataclass(frozen=True, slots=True)
class Checks:
    """A ledger, its specification, and what decides whether another ledger is refused.

    The `readers` compare a ledger with the specification, and all of them have to refuse a mutant.
    `numbers` evaluates the formulas that the text of a ledger publishes.  Both raise `refusals`.
    """

    text: str
    specification: str
    readers: tuple[Callable[[str, Ledger], object], ...]
    numbers: Callable[[str], object]
    refusals: tuple[type[Exception], ...]

    def fate(self, ledger: Ledger) -> str:
        """Return what refuses a ledger."""
        specification = concerning(self.specification, _sealed(self.text), ledger)
        if not _fits(self, specification):
            specification = self.specification
        if all(self.refuses(reader, specification, ledger) for reader in self.readers):
            return SPECIFICATION
        text = json.dumps(ledger, indent=1, ensure_ascii=False) + "\n"
        return NUMBERS if self.refuses(self.numbers, text) else UNNOTICED

    def refuses(self, check: Callable[..., object], *arguments: Any) -> bool:
        try:
            check(*arguments)
        except self.refusals:
            return True
        return False


@dataclass(slots=True)
class Tally:
    """Numbers of mutants by kind and fate, and the mutants that nothing noticed."""

    counts: dict[str, Counter[str]] = field(default_factory=dict)
    unnoticed: list[str] = field(default_factory=list)

    def add(self, kind: str, fate: str, told: str = "", count: int = 1) -> None:
        """Count mutants of one fate."""
        if fate == UNNOTICED and told in equivalents():
            fate = EQUIVALENT
        elif fate == UNNOTICED:
            self.unnoticed.append(f"{kind}: {told}")
        self.counts.setdefault(kind, Counter())[fate] += count


def run(checks: Checks, submit: Submit, sample: int = 0) -> Tally:
    """Decide all mutants of a ledger, or a sample of each kind that a seed draws.

    `submit` runs a function, perhaps in another process, and returns a future.
    """
    tally, random, ledger = Tally(), Random(sample), _sealed(checks.text)
    screen, proved = Screen(checks.specification, ledger), Proved(ledger)
    total, left = 0, dict[Mutant, str]()
    for name, mutants in screen.mutants():
        mutants = mutants._replace(rows=np.array(_drawn(mutants.rows, sample, random)))
        total += len(mutants.rows)
        left |= dict.fromkeys(mutants.each(~screen.refuted(name, mutants)), name)
    left = screen.survivors(left)
    tally.add("definitions", REFUTED, count=total - len(left))
    waiting = [
        ("definitions", f"{name}: {'; '.join(map(str, edits))}", submit(_forged, checks, edits))
        for edits, name in left.items()
    ]
    for kind in (meanings, publications):
        for told, changed in _drawn(kind(ledger), sample, random):
            waiting.append((kind.__name__, told, submit(checks.fate, changed)))
    places = {place for name in screen.theorems for place in proved.modelled(name)}
    for edit, changed in _drawn(rates(ledger, places), sample, random):
        waiting.append(("rates", str(edit), submit(_forged, checks, (edit,), changed)))
    for kind, told, future in waiting:
        tally.add(kind, future.result(), told)
    return tally


def _forged(checks: Checks, edits: tuple[Edit, ...], quick: Ledger | None = None) -> str:
    """Return what refuses the ledger with some definitions changed.

    The `quick` ledger still has facts that may no longer follow: if the specification refuses it,
    no proof has to be redone.
    """
    if quick and checks.fate(quick) == SPECIFICATION:
        return SPECIFICATION
    return checks.fate(_forger(checks.text).forge(edits))


@cache
def _fits(checks: Checks, specification: str) -> bool:
    """Return whether the readers accept the sealed ledger with a part of its specification."""
    sealed = _sealed(checks.text)
    return not any(checks.refuses(reader, specification, sealed) for reader in checks.readers)


@cache
def _forger(text: str) -> Forger:
    return Forger(text)


@cache
def _sealed(text: str) -> Ledger:
    return json.loads(text)


def concerning(specification: str, sealed: Ledger, ledger: Ledger) -> str:
    """Return a specification without the theorems that a change of the sealed ledger leaves alone.

    They rest on no changed context, directly or by a model, and on no changed formula.
    """
    contexts = {context["name"]: context for context in ledger["contexts"]}
    changed = {x["name"] for x in sealed["contexts"] if contexts.get(x["name"]) != x}
    before, after = Proved(sealed), Proved(ledger)
    formulas = {
        name
        for name, entries in before.sequences.items()
        if after.sequences.get(name) != entries
        or any(before.formula(entry).context in changed for entry in entries)
    }
    left = {
        name
        for name, theorem in theorems(specification).items()
        if not changed & {*before.modelled(name)}
        and not formulas & {sequence for sequence, _ in theorem.formulas}
    }
    blocks = re.split(r"\n(?=theorem |hypotheses )", specification)
    return "\n".join(x for x in blocks if re.split(r"\W+", x)[1] not in left)


def _drawn(mutants: Iterable[Any], sample: int, random: Random) -> list[Any]:
    every = [*mutants]
    return random.sample(every, min(sample or len(every), len(every)))


@cache
def equivalents() -> Mapping[str, str]:
    """Return the mutants that publish the same numbers, with the reason for each."""
    text = resources.files("rigidsym.proof._mutants").joinpath("equivalent.toml").read_text("utf-8")
    return {told: one["reason"] for one in tomllib.loads(text)["mutants"] for told in one["edits"]}
