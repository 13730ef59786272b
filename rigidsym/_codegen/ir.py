"""Intermediate representation: assignments with provenance, grouped into functions.

Input and output of every pass are tuples of `Let`; no pass looks at the target's language.

Numbers are of two kinds.  A double is what the machine has; an extended number is the unevaluated
sum of two, and carries about 31 digits.  An expression is extended as soon as a part of it is.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    children,
    names,
    parse,
    to_text,
)

# Functions that expressions may call, and the kind of their values; "as": that of the arguments.
CALLS = {
    "neg": "as",
    "sqrt": "as",
    "size": "as",
    "choose": "as",
    "rounded": "double",
    "exponent": "double",
    "mantissa": "extended",
    "fma": "double",
    "product_error": "double",
    "nearest": "double",
    "alternating": "double",
    "exp": "double",
    "power_of_two": "double",
}
# References for operations on doubles that leave nothing out.
EXACT_PRODUCT, EXACT_SUM, EXACT_DIFFERENCE = "Dekker 1971", "Knuth 4.2.2", "Sterbenz 1974"
_EXACT = {EXACT_PRODUCT, EXACT_SUM, EXACT_DIFFERENCE}
# The kinds of derived lines; all others are the runtime.
KINDS = ("fact", "classical", "arithmetic")


@dataclass(frozen=True, slots=True)
class Let:
    """Assignment `targets = expression`, with the facts, equations and references behind it.

    One target, unless the expression calls a function that returns several values.
    """

    targets: tuple[str, ...]
    expression: Expression
    source: tuple[str, ...]
    facts: tuple[str, ...]

    @property
    def kind(self) -> str:
        """Return the kind of the assignment: fact, classical or arithmetic."""
        if self.facts:
            return "fact"
        return "classical" if self.source and _EXACT.isdisjoint(self.source) else "arithmetic"

    def __str__(self) -> str:
        return f"{', '.join(self.targets)} = {to_text(self.expression)}"


@dataclass(frozen=True, slots=True)
class Constant:
    """Named numerical constant: a double, or an extended number.

    It is an extended number where `lo` is given.
    """

    name: str
    hi: float
    lo: float | None
    meaning: str


@dataclass(frozen=True, slots=True)
class Function:
    """Straight-line function: parameters, assignments, and names of the results.

    `extended` are the parameters that are extended numbers, and `split` the results that are handed
    on as two doubles, `<name>_hi` and `<name>_lo`; other results are rounded where `rounds`.
    `formulas` are the lets before anything was shared.
    """

    name: str
    summary: str
    parameters: tuple[str, ...]
    lets: tuple[Let, ...]
    results: tuple[str, ...]
    extended: frozenset[str] = field(default=frozenset())
    split: frozenset[str] = field(default=frozenset())
    rounds: bool = False
    formulas: tuple[Let, ...] = ()

    def all_extended(self) -> frozenset[str]:
        """Return the names of the parameters and targets that are extended numbers."""
        extended = set(self.extended)
        for let in self.lets:
            if is_extended(let.expression, extended):
                extended |= set(let.targets)
        return frozenset(extended)

    def used(self) -> set[str]:
        """Return the names that occur in the function's expressions."""
        return {name for let in self.lets for name in names(let.expression)}


def named(functions: Iterable[Function], constants: Iterable[Constant]) -> list[Constant]:
    """Select the named constants that occur in the functions."""
    used = {name for function in functions for name in function.used()}
    return [constant for constant in constants if constant.name in used]


def let(text: str, *source: str, facts: tuple[str, ...] = ()) -> Let:
    """Parse the assignment `a = expression` or `a, b = call`.

    >>> str(let("s, c = turn(x + 1)"))
    's, c = turn(x + 1)'
    """
    targets, _, expression = text.partition(" = ")
    return Let(tuple(targets.split(", ")), parse(expression), source, facts)


def is_extended(expression: Expression, extended: frozenset[str] | set[str]) -> bool:
    """Return True if the value of an expression is an extended number.

    extended: the names of extended numbers.
    """
    if isinstance(expression, Name):
        return expression.name in extended
    if isinstance(expression, Call):
        if (kind := CALLS.get(expression.function, "as")) != "as":
            return kind == "extended"
        # The first two arguments of `choose` are compared, and the value is one of the others.
        parts = expression.arguments[2 if expression.function == "choose" else 0 :]
    else:
        parts = children(expression)
    return any(is_extended(part, extended) for part in parts)
