"""The intermediate form: named lets with provenance, grouped into functions.

Input and output of every pass are tuples of `Let`; no pass looks at the target's language.

Numbers are of two kinds.  A double is what the machine has; an extended number is the unevaluated
sum of two, and carries about 31 digits.  An expression is extended as soon as a part of it is.
"""

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

# What an expression may call, and whether the value is extended: "as" its arguments are.
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
# What a line is; what no let stands behind is runtime, written by hand.
KINDS = ("fact", "classical", "arithmetic")


@dataclass(frozen=True, slots=True)
class Let:
    """targets = expression, with the facts that say so, the equations that these carry, references.

    One target, unless the expression calls a function that returns several values.
    """

    targets: tuple[str, ...]
    expression: Expression
    source: tuple[str, ...]
    facts: tuple[str, ...]

    @property
    def kind(self) -> str:
        """Return one of KINDS: by a fact, by a classical formula, or arithmetic alone."""
        if self.facts:
            return "fact"
        return "classical" if self.source and _EXACT.isdisjoint(self.source) else "arithmetic"

    def __str__(self) -> str:
        return f"{', '.join(self.targets)} = {to_text(self.expression)}"


@dataclass(frozen=True, slots=True)
class Constant:
    """A named number: a double, or an extended one where `lo` is given."""

    name: str
    hi: float
    lo: float | None
    meaning: str


@dataclass(frozen=True, slots=True)
class Function:
    """A straight-line function: parameters, lets, and the names it returns.

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
        """Return the parameters and targets that are extended numbers."""
        extended = set(self.extended)
        for let in self.lets:
            if is_extended(let.expression, extended):
                extended |= set(let.targets)
        return frozenset(extended)

    def used(self) -> set[str]:
        """Return every name that a let uses."""
        return {name for let in self.lets for name in names(let.expression)}


def let(text: str, *source: str, facts: tuple[str, ...] = ()) -> Let:
    """Read `a = expression` or `a, b = call`.

    >>> str(let("s, c = turn(x + 1)"))
    's, c = turn(x + 1)'
    """
    targets, _, expression = text.partition(" = ")
    return Let(tuple(targets.split(", ")), parse(expression), source, facts)


def is_extended(expression: Expression, extended: frozenset[str] | set[str]) -> bool:
    """Return True where a value is an extended number, given the names that are."""
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
