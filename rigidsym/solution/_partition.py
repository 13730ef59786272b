"""The ledger's partition of all motions into kinds, by the signs of quantities.

The ledger splits a context by the sign of a quantity into cases: zero, above zero and, for some
quantities, below.  It splits cases again, down to leaves.  The fact `sorted_body.cases` says that
every motion is in exactly one leaf; the specification says how a motion of a leaf moves.

Every runtime decides the leaf by formulas (`decisions`).  Their inputs are 0 for zero and 1 for
anything else: differences of moments, largest first, and the rates about the same axes; and one
number with the sign of E_2, which is decided exactly before.  All other quantities that decide are
sums of products of numbers that are not negative.  Such a sum vanishes exactly where it vanishes
with ones in the place of what is not zero.
"""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from rigidsym.errors import LedgerError
from rigidsym.language._expression import (
    Expression,
    Name,
    Number,
    Operation,
    children,
    names,
    parse,
    put,
    to_text,
)
from rigidsym.language._sequence import Formula, FormulaSequence
from rigidsym.language._specification import Proved, Theorem

# The context that all splits begin with: moments c_1 >= c_2 >= c_3 > 0, and rates.
ROOT = "sorted_body"
INPUTS = ("c_3", "c_13", "c_23", "Omega_1", "Omega_2", "Omega_3")
# Theorems of the specification on rates that circulate about an axis, by the side of a leaf.
_ABOUT = {1: "about_1", -1: "about_3"}
# The inputs of `decisions`; the last is the one whose sign matters.
SIGNED = "E_2"
DIFFERENCES = ("c_12", "c_13", "c_23")
GIVEN = (*DIFFERENCES, "Omega_1", "Omega_2", "Omega_3", SIGNED)
# The smallest moment is never zero.
ONES = {"c_3": 1}

# The theorem of the specification on the signs of a motion.  Its hypotheses say that
# sigma Omega_a, rho (c_a - c_d) and chi tau Omega_d are not negative; its conclusion, that dn, cn
# and Delta of the formulas are not negative, either.
SIGNS_OF = "start_signs"
# The signs in the order of evaluation; the first depends on the axes alone.
SIGNS = ("epsilon", "sigma", "rho", "chi")
HANDEDNESS = "(axis_b - axis_a)*(axis_d - axis_a)*(axis_d - axis_b)/2"
_SIGN_OF = parse("choose(0, x, 1, -1)")

# A fact or a context, as it is in the ledger.
Record = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Split:
    """The split of one context of the ledger into cases, by the sign of a quantity.

    cases: those for zero, above zero and, for some quantities, below.
    fact: the fact that there are no other cases.
    """

    quantity: str
    cases: tuple[str, ...]
    fact: str
    source: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """A kind of motion that the ledger does not split any further.

    fact: the fact of the ledger that states the signs of its formulas.

    side: 1 where the rates circulate about the axis of largest moment, -1 where about that of the
    smallest, 0 where they are constant.
    """

    name: str
    fact: str
    source: tuple[str, ...]
    side: int


@dataclass(frozen=True, slots=True)
class Partition:
    """The decision tree that finds the kind of a motion from the signs of quantities.

    splits: the inner nodes, by context.  leaves: the kinds of motion.  quantities: the formulas of
    the quantities whose signs decide.
    """

    splits: Mapping[str, Split]
    leaves: Mapping[str, Leaf]
    quantities: FormulaSequence

    def leaf(self, moments: tuple[Fraction, ...], rates: tuple[Fraction, ...]) -> Leaf:
        """Return the leaf of the motion with the given moments and rates.

        Moments are sorted, largest first; rates are about the same axes.
        """
        c_1, c_2, c_3 = moments
        given = dict(zip(INPUTS, (c_3, c_1 - c_3, c_2 - c_3, *rates), strict=True))
        values = self.quantities.evaluate(given, {"power": pow})
        return self.walk(lambda quantity: (values[quantity] > 0) - (values[quantity] < 0))

    def walk(self, sign_of: Callable[[str], int]) -> Leaf:
        """Follow the splits by the signs of their quantities and return the leaf.

        A sign is 0, 1 or -1.
        """
        name = ROOT
        while name in self.splits:
            split = self.splits[name]
            name = split.cases[sign_of(split.quantity)]
        return self.leaves[name]

    def path(self, case: str) -> tuple[tuple[str, int], ...]:
        """Return the quantities and signs that lead from the root to a case."""
        for name, split in self.splits.items():
            if case in split.cases:
                sign = (0, 1, -1)[split.cases.index(case)]
                return (*self.path(name), (split.quantity, sign))
        return ()


def partition_of(ledger: Proved, specified: Mapping[str, Theorem]) -> Partition:
    """Read the partition of all motions from a ledger.

    Raises LedgerError if the ledger does not prove one.

    specified: the blocks of the specification, all of which the ledger proves.
    """
    try:
        proved = {x["context"]: x for x in ledger.proved if x["kind"] == "partition"}
        if ROOT not in proved:
            raise LedgerError(f"ledger: it does not prove the partition {ROOT}.cases")
        leaves = proved[ROOT]["rhs"]
        splits, reached = _splits(proved)
        if sorted(reached) != sorted(leaves):
            raise LedgerError(f"ledger: {ROOT}.cases: its leaves are not {', '.join(reached)}")
        decided = frozenset(split.quantity for split in splits.values())
        quantities = _quantities(splits, ledger.contexts).up_to(decided)
        return Partition(splits, {x: _leaf(x, ledger, specified) for x in leaves}, quantities)
    except (KeyError, TypeError, AttributeError) as error:
        raise LedgerError(f"ledger: its partition is not readable: {error!r}") from None


def _splits(proved: Mapping[str, Record]) -> tuple[dict[str, Split], list[str]]:
    """Return the splits by context, and the names of all leaves that they lead to."""
    splits: dict[str, Split] = {}
    leaves, todo = [], [ROOT]
    for name in todo:
        if name not in proved:
            leaves.append(name)
        elif name in splits:
            raise LedgerError(f"ledger: {name}.cases: splits lead to it twice")
        else:
            fact = proved[name]
            cases = tuple(fact["certificate"]["cases"])
            splits[name] = Split(fact["lhs"][0], cases, fact["id"], tuple(fact["source"]))
            todo += cases
    return splits, leaves


def _quantities(splits: Collection[str], contexts: Mapping[str, Record]) -> FormulaSequence:
    """Return the formulas of the quantities whose signs decide the kind of a motion.

    They are the definitions of the root context.

    Raises LedgerError unless every split context has the same definitions.
    """
    root = contexts[ROOT]
    for name in splits:
        if contexts[name]["definitions"] != root["definitions"]:
            raise LedgerError(f"ledger: {name}: its definitions are not those of {ROOT}")
    if tuple(root["generators"]) != INPUTS:
        raise LedgerError(f"ledger: {ROOT} is not about {', '.join(INPUTS)}")
    formulas = [(name, parse(text)) for name, text in root["definitions"].items()]
    check_order(ROOT, formulas, INPUTS)
    return FormulaSequence(formulas)


def check_order(
    place: str, formulas: Iterable[tuple[str, Expression]], inputs: Iterable[str]
) -> None:
    """Check that formulas use only inputs and the results of earlier formulas.

    Raises LedgerError for any other name.
    """
    known = {*inputs}
    for name, expression in formulas:
        if missing := sorted({*names(expression)} - known):
            raise LedgerError(f"ledger: {place}: {name} needs {', '.join(missing)}")
        known.add(name)


def _leaf(name: str, ledger: Proved, specified: Mapping[str, Theorem]) -> Leaf:
    """Read one leaf of the partition from the ledger."""
    theorem = specified[name]
    values = ledger.values(theorem)
    required = {values.said(statement) for statement in theorem.then if statement[0] == ">="}
    stating = [
        fact
        for fact in ledger.proved
        if (fact["context"], fact["kind"]) == (name, "nonnegative")
        and required <= {values.said((">=", lhs, "0")) for lhs in fact["lhs"]}
    ]
    if not required or not stating:
        raise LedgerError(f"ledger: no fact states how it moves in {name}")
    about = (side for side, x in _ABOUT.items() if {*specified[x].then} <= {*theorem.then})
    return Leaf(name, stating[0]["id"], tuple(stating[0]["source"]), next(about, 0))


def decisions(partition: Partition) -> tuple[Formula, ...]:
    """Return formulas that decide about which axis, if any, the rates of a motion circulate.

    The last formula sets `side`, which `Leaf` explains.

    Raises LedgerError for a quantity that might have either sign.
    """
    wanted = {split.quantity for split in partition.splits.values()} - {*GIVEN}
    decided = [
        (name, expression)
        for name, expression in partition.quantities.up_to(frozenset(wanted)).formulas
        if name not in GIVEN
    ]
    for _, expression in decided:
        _check_sign(expression)
    return (
        *(Formula(name, x, f"definition {ROOT}.{name}", ROOT, ()) for name, x in decided),
        *(
            Formula(leaf.name, parse(str(leaf.side)), leaf.fact, leaf.name, leaf.source)
            for leaf in partition.leaves.values()
        ),
        *(
            Formula(name, _chosen(split), split.fact, name, split.source)
            for name, split in reversed(list(partition.splits.items()))
        ),
    )


def _check_sign(expression: Expression) -> None:
    """Check that an expression cannot be negative.

    It has to be a sum of products of squares and of names that begin with `c_`.
    """
    match expression:
        case Operation("+" | "*"):
            for part in children(expression):
                _check_sign(part)
        case Operation("**", Name(), Number(2)):
            pass
        case Name(name) if name.startswith("c_"):
            pass
        case _:
            raise LedgerError(f"ledger: {to_text(expression)}: it is not seen to have one sign")


def _chosen(split: Split) -> Expression:
    """Return an expression that selects the case of a split by the sign of its quantity."""
    quantity, (zero, above, *below) = split.quantity, split.cases
    if below:
        zero = f"choose(0, {quantity}, {zero}, {below[0]})"
    return parse(f"choose({quantity}, 0, {zero}, {above})")


def handedness(a: int, b: int, d: int) -> int:
    """Return the Levi-Civita symbol of three axis indices.

    Each is 0, 1 or 2.
    """
    return (b - a) * (d - a) * (d - b) // 2


def sign_rules(nonnegative: Iterable[str]) -> dict[str, Expression]:
    """Derive formulas for the signs sigma, rho and chi from the theorem `SIGNS_OF`.

    The theorem states that certain products are nonnegative.

    Each product starts with a sign.  The sign is that of the other factors, or 1 where they
    vanish.
    """
    rules = {}
    for product in nonnegative:
        name, times, rest = product.partition(" * ")
        if name in SIGNS and times:
            rules[name] = put(_SIGN_OF, {"x": parse(rest)})
    if {*rules} != {*SIGNS[1:]}:
        raise LedgerError(f"ledger: {SIGNS_OF} is not about {', '.join(SIGNS[1:])}")
    return {name: rules[name] for name in SIGNS[1:]}
