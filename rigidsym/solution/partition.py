"""Which kind of motion it is, by the signs that the ledger proves to tell all kinds apart.

A context of the ledger is split by the sign of a quantity into cases, zero, above zero and, of
some, below; cases are split again, down to leaves.  That no body and no motion is in none of them,
or in two, is the fact `sorted_body.cases`; how it moves in a leaf, the specification says.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import TypedDict

from rigidsym.errors import LedgerError
from rigidsym.language.expression import names, parse
from rigidsym.language.sequence import FormulaSequence
from rigidsym.language.specification import Theorem

# What is decided of: moments c_1 >= c_2 >= c_3 > 0, by their differences, and rates.
ROOT = "sorted_body"
# What the specification has of leaves where the rates circulate about an axis, 1 being that of the
# largest moment; in all others momentum and rates are parallel.
_ABOUT = {1: "about_1", -1: "about_3"}
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
    source: list[str]
    certificate: Certificate


class Context(TypedDict):
    """What is read of a context that is split: what its quantities are."""

    name: str
    generators: list[str]
    definitions: dict[str, str]


@dataclass(frozen=True, slots=True)
class Split:
    """The quantity whose sign decides, the cases for zero, above zero and, of some, below, and the
    fact that there are no others."""

    quantity: str
    cases: tuple[str, ...]
    fact: str
    source: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """A kind of motion, and the fact that says how it moves.

    side: 1 where the rates circulate about the axis of largest moment, -1 where about that of the
    smallest, 0 where they are constant.
    """

    name: str
    fact: str
    source: tuple[str, ...]
    side: int


@dataclass(frozen=True, slots=True)
class Partition:
    """The splits by context, the leaves they end in, and what their quantities are."""

    splits: Mapping[str, Split]
    leaves: Mapping[str, Leaf]
    quantities: FormulaSequence

    def leaf(self, moments: tuple[Fraction, ...], rates: tuple[Fraction, ...]) -> Leaf:
        """The leaf of a motion: moments, largest first, and the rates about the same axes."""
        c_1, c_2, c_3 = moments
        given = dict(zip(INPUTS, (c_3, c_1 - c_3, c_2 - c_3, *rates), strict=True))
        values = self.quantities.evaluate(given, {"power": pow})
        return self.walk(lambda quantity: (values[quantity] > 0) - (values[quantity] < 0))

    def walk(self, sign_of: Callable[[str], int]) -> Leaf:
        """The leaf that signs of quantities, 0, 1 or -1, lead to."""
        name = ROOT
        while name in self.splits:
            split = self.splits[name]
            name = split.cases[sign_of(split.quantity)]
        return self.leaves[name]

    def path(self, case: str) -> tuple[tuple[str, int], ...]:
        """The quantities that lead to a case, from the root on, and the sign of each."""
        for name, split in self.splits.items():
            if case in split.cases:
                sign = (0, 1, -1)[split.cases.index(case)]
                return (*self.path(name), (split.quantity, sign))
        return ()


def partition_of(
    facts: Collection[Fact], contexts: Mapping[str, Context], specified: Mapping[str, Theorem]
) -> Partition:
    """The partition that a ledger proves; raises LedgerError where it proves none.

    specified: the blocks of the specification, which the ledger has been seen to prove.
    """
    try:
        return _partition_of(facts, contexts, specified)
    except (KeyError, TypeError, AttributeError) as error:
        raise LedgerError(f"ledger: its partition is not readable: {error!r}") from None


def _partition_of(
    facts: Collection[Fact], contexts: Mapping[str, Context], specified: Mapping[str, Theorem]
) -> Partition:
    proved = {
        fact["context"]: fact
        for fact in facts
        if fact["kind"] == "partition" and fact["grade"] == "PROVED"
    }
    if ROOT not in proved:
        raise LedgerError(f"ledger: it does not prove the partition {ROOT}.cases")
    leaves = proved[ROOT]["rhs"]
    splits: dict[str, Split] = {}
    reached = _reached(proved, splits)
    if sorted(reached) != sorted(leaves):
        raise LedgerError(f"ledger: {ROOT}.cases: its leaves are not {', '.join(reached)}")
    decided = frozenset(split.quantity for split in splits.values())
    quantities = _quantities(splits, contexts).up_to(decided)
    return Partition(splits, {x: _leaf(x, facts, specified) for x in leaves}, quantities)


def _leaf(name: str, facts: Iterable[Fact], specified: Mapping[str, Theorem]) -> Leaf:
    """How it moves in a leaf, by what the specification has there, and the fact that states it."""
    said = {lhs for relation, lhs, _ in specified[name].then if relation == ">="}
    stating = [fact for fact in _signs_in(name, facts) if said <= _sides(fact)]
    if not said or not stating:
        raise LedgerError(f"ledger: no fact states how it moves in {name}")
    about = (side for side, x in _ABOUT.items() if {*specified[x].then} <= {*specified[name].then})
    return Leaf(name, stating[0]["id"], tuple(stating[0]["source"]), next(about, 0))


def _signs_in(name: str, facts: Iterable[Fact]) -> Iterator[Fact]:
    """What is proved not to be negative in a context."""
    wanted = (name, "nonnegative", "PROVED")
    return (x for x in facts if (x["context"], x["kind"], x["grade"]) == wanted)


def _sides(fact: Fact) -> set[str]:
    return {lhs.replace(" ", "") for lhs in fact["lhs"]}


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
            fact = proved[name]
            splits[name] = Split(fact["lhs"][0], cases, fact["id"], tuple(fact["source"]))
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
