"""Which kind of motion it is, by the signs that the ledger proves to tell all kinds apart.

A context of the ledger is split by the sign of a quantity into cases, zero, above zero and, of
some, below; cases are split again, down to leaves.  That no body and no motion is in none of them,
or in two, is the fact `sorted_body.cases`.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TypedDict

from rigidsym.errors import LedgerError
from rigidsym.language.expression import names, parse
from rigidsym.language.sequence import FormulaSequence

# What is decided of: moments c_1 >= c_2 >= c_3 > 0, by their differences, and rates.
ROOT = "sorted_body"
INPUTS = ("c_3", "c_13", "c_23", "Omega_1", "Omega_2", "Omega_3")


class Certificate(TypedDict, total=False):
    """The cases that a context is split into, for zero, above zero and below."""

    cases: list[str]


class Fact(TypedDict):
    """What is read of a fact that contexts are split."""

    id: str
    context: str
    kind: str
    grade: str
    lhs: list[str]
    rhs: list[str]
    certificate: Certificate


class Context(TypedDict):
    """What is read of a context that is split: what its quantities are."""

    name: str
    generators: list[str]
    definitions: dict[str, str]


@dataclass(frozen=True, slots=True)
class Split:
    """The quantity whose sign decides, and the cases for zero, above zero and, of some, below."""

    quantity: str
    cases: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Partition:
    """The splits by context, the leaves they end in, and what their quantities are."""

    splits: Mapping[str, Split]
    leaves: tuple[str, ...]
    quantities: FormulaSequence

    def leaf(self, moments: tuple[Fraction, ...], rates: tuple[Fraction, ...]) -> str:
        """The leaf of a motion: moments, largest first, and the rates about the same axes."""
        c_1, c_2, c_3 = moments
        given = dict(zip(INPUTS, (c_3, c_1 - c_3, c_2 - c_3, *rates), strict=True))
        values = self.quantities.evaluate(given, {"power": pow})
        name = ROOT
        while name in self.splits:
            split = self.splits[name]
            value = values[split.quantity]
            name = split.cases[0 if value == 0 else 1 if value > 0 else 2]
        return name


def partition_of(facts: Iterable[Fact], contexts: Mapping[str, Context]) -> Partition:
    """The partition that a ledger proves; raises LedgerError where it proves none."""
    try:
        return _partition_of(facts, contexts)
    except (KeyError, TypeError, AttributeError) as error:
        raise LedgerError(f"ledger: its partition is not readable: {error!r}") from None


def _partition_of(facts: Iterable[Fact], contexts: Mapping[str, Context]) -> Partition:
    proved = {
        fact["context"]: fact
        for fact in facts
        if fact["kind"] == "partition" and fact["grade"] == "PROVED"
    }
    if ROOT not in proved:
        raise LedgerError(f"ledger: it does not prove the partition {ROOT}.cases")
    leaves = tuple(proved[ROOT]["rhs"])
    splits: dict[str, Split] = {}
    reached = _reached(proved, splits)
    if sorted(reached) != sorted(leaves):
        raise LedgerError(f"ledger: {ROOT}.cases: its leaves are not {', '.join(reached)}")
    decided = frozenset(split.quantity for split in splits.values())
    return Partition(splits, leaves, _quantities(splits, contexts).up_to(decided))


def _reached(proved: Mapping[str, Fact], splits: dict[str, Split]) -> list[str]:
    """The leaves, as often as splits lead to them; notes the splits."""
    leaves, todo = [], [ROOT]
    for name in todo:
        if name not in proved:
            leaves.append(name)
        elif name in splits:
            raise LedgerError(f"ledger: {name}.cases: splits lead to it twice")
        else:
            cases = tuple(proved[name]["certificate"]["cases"])
            splits[name] = Split(proved[name]["lhs"][0], cases)
            todo += splits[name].cases
    return leaves


def _quantities(splits: Collection[str], contexts: Mapping[str, Context]) -> FormulaSequence:
    """What the root defines; it means the same wherever something is split."""
    root = contexts[ROOT]
    for name in splits:
        if contexts[name]["definitions"] != root["definitions"]:
            raise LedgerError(f"ledger: {name}: its definitions are not those of {ROOT}")
    if tuple(root["generators"]) != INPUTS:
        raise LedgerError(f"ledger: {ROOT} is not about {', '.join(INPUTS)}")
    whole = [(name, parse(text)) for name, text in root["definitions"].items()]
    known = {*INPUTS}
    for name, expression in whole:
        missing = sorted({*names(expression)} - known)
        if missing:
            raise LedgerError(f"ledger: {ROOT}: {name} needs {', '.join(missing)}")
        known.add(name)
    return FormulaSequence(whole)
