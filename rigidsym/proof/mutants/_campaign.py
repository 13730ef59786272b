"""The campaign: every mutant is refuted, refused, shown to be equivalent, or unnoticed."""

import json
import tomllib
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from importlib import resources
from random import Random
from typing import Any, TypeAlias

import numpy as np

from rigidsym.language._specification import Proved
from rigidsym.proof.mutants._forger import Forger
from rigidsym.proof.mutants._publications import meanings, publications, rates
from rigidsym.proof.mutants._screen import Mutant, Screen

# Why a ledger is refused, "" if it is not.
Decider: TypeAlias = Callable[[Mapping[str, Any]], str]
REFUTED, SPECIFICATION, NUMBERS = "refuted at a point", "by the specification", "by numbers"
EQUIVALENT, UNNOTICED = "equivalent", "unnoticed"
FATES = (REFUTED, SPECIFICATION, NUMBERS, EQUIVALENT, UNNOTICED)


@dataclass(slots=True)
class Tally:
    """Numbers of mutants by kind and fate, and the mutants that nothing noticed."""

    counts: dict[str, Counter[str]] = field(default_factory=dict)
    unnoticed: list[str] = field(default_factory=list)
    equivalent: list[str] = field(default_factory=list)

    def add(self, kind: str, fate: str, count: int = 1) -> None:
        """Count mutants of one fate."""
        self.counts.setdefault(kind, Counter())[fate] += count


class Campaign:
    """Mutants of a ledger, and what decides them.

    `readers` compare a ledger with the specification, and all of them have to refuse a mutant.
    `numbers` evaluates the published formulas.
    """

    def __init__(
        self, text: str, specification: str, readers: list[Decider], numbers: Decider
    ) -> None:
        self.ledger, self.readers, self.numbers = json.loads(text), readers, numbers
        self.screen, self.forger = Screen(specification, self.ledger), Forger(text)

    def run(self, sample: int = 0) -> Tally:
        """Decide all mutants, or a sample of each kind drawn by a seed."""
        tally, random = Tally(), Random(sample)
        self._definitions(tally, sample, random)
        for kind in (meanings, publications):
            for told, ledger in _drawn(kind(self.ledger), sample, random):
                self._decide(tally, kind.__name__, told, ledger)
        names = {place for x in self.screen.theorems for place in Proved(self.ledger).modelled(x)}
        for edit, ledger in _drawn(rates(self.ledger, names), sample, random):
            if not self._specified(ledger):  # with all facts: fewer might follow
                tally.add("rates", SPECIFICATION)
            else:
                self._decide(tally, "rates", str(edit), self.forger.forge([edit]))
        return tally

    def _definitions(self, tally: Tally, sample: int, random: Random) -> None:
        """Decide mutants of definitions: points refute most, and the others are forged."""
        total, left = 0, dict[Mutant, str]()
        for name, mutants in self.screen.mutants():
            if sample:
                mutants = mutants._replace(rows=np.array(_drawn(mutants.rows, sample, random)))
            total += len(mutants.rows)
            refuted = self.screen.refuted(name, mutants)
            left |= dict.fromkeys(mutants.each(~refuted), name)
        left = self.screen.survivors(left)
        tally.add("definitions", REFUTED, total - len(left))
        for mutant, name in left.items():
            told = f"{name}: {'; '.join(map(str, mutant))}"
            self._decide(tally, "definitions", told, self.forger.forge(mutant))

    def _specified(self, ledger: Mapping[str, Any]) -> bool:
        return not all(reader(ledger) for reader in self.readers)

    def _decide(self, tally: Tally, kind: str, told: str, ledger: Mapping[str, Any]) -> None:
        if not self._specified(ledger):
            fate = SPECIFICATION
        elif self.numbers(ledger):
            fate = NUMBERS
        elif told in equivalents():
            fate = EQUIVALENT
            tally.equivalent.append(told)
        else:
            fate = UNNOTICED
            tally.unnoticed.append(told)
        tally.add(kind, fate)


def _drawn(mutants: Iterable[Any], sample: int, random: Random) -> list[Any]:
    every = [*mutants]
    return random.sample(every, min(sample or len(every), len(every)))


def equivalents() -> Mapping[str, str]:
    """Return the mutants that publish the same numbers, with the reason for each."""
    text = resources.files("rigidsym.proof.mutants").joinpath("equivalent.toml").read_text("utf-8")
    return {told: one["reason"] for one in tomllib.loads(text)["mutants"] for told in one["edits"]}
