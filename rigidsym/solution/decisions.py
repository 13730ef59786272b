"""The decisions that every runtime takes, as formulas: which kind of motion it is.

They are given 0 for what is zero and 1 for what is not: differences of moments, largest first, and
rates about the same axes; and a number with the sign of E_2, which is decided exactly before.
Every other quantity that the ledger's partition asks for is seen to be a sum of products of what is
not negative.  Such a sum vanishes where it does with ones in place of what is not zero.
"""

from collections.abc import Iterator

from rigidsym.errors import LedgerError
from rigidsym.language.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    children,
    to_text,
)
from rigidsym.solution.formula import Formula
from rigidsym.solution.partition import ROOT, Partition, Split

# The sequence's inputs; the last is the one whose sign is asked for.
SIGNED = "E_2"
DIFFERENCES = ("c_12", "c_13", "c_23")
GIVEN = (*DIFFERENCES, "Omega_1", "Omega_2", "Omega_3", SIGNED)
# What is not zero anyway: the smallest moment.
ONES = {"c_3": 1}


def decisions(partition: Partition) -> tuple[Formula, ...]:
    """The sequence of formulas whose last, ROOT, is the side of a motion (see Leaf).

    Raises LedgerError where a quantity is not seen to have one sign.
    """
    leaves = (
        Formula(leaf.name, _whole(leaf.side), leaf.fact, leaf.name, leaf.source)
        for leaf in partition.leaves.values()
    )
    splits = (
        Formula(name, _chosen(split), split.fact, name, split.source)
        for name, split in reversed(list(partition.splits.items()))
    )
    return (*_quantities(partition), *leaves, *splits)


def _quantities(partition: Partition) -> Iterator[Formula]:
    """What splits ask for, by what is given."""
    asked = {split.quantity for split in partition.splits.values()} - {*GIVEN}
    for name, expression in partition.quantities.up_to(frozenset(asked)).formulas:
        if name not in GIVEN:
            _check(expression)
            fact = f"definition {ROOT}.{name}"
            yield Formula(name, expression, fact, ROOT, ())


def _check(expression: Expression) -> None:
    """A sum of products of moments, differences and squares is not negative."""
    match expression:
        case Operation("+" | "*"):
            for part in children(expression):
                _check(part)
        case Operation("**", Name(), Number(2)):
            pass
        case Name(name) if name.startswith("c_"):
            pass
        case _:
            raise LedgerError(f"ledger: {to_text(expression)}: it is not seen to have one sign")


def _whole(number: int) -> Expression:
    return Call("neg", (Number(-number),)) if number < 0 else Number(number)


def _chosen(split: Split) -> Expression:
    """The case of the sign of a quantity: zero, above, or below where there is that."""
    quantity, (zero, above, *below) = Name(split.quantity), map(Name, split.cases)
    if below:
        zero = Call("choose", (Number(0), quantity, zero, below[0]))
    return Call("choose", (quantity, Number(0), zero, above))
