"""Formulas and formula sequences, which can be evaluated with any kind of numbers."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import CodeType
from typing import Any, TypeVar

from rigidsym.language._expression import Expression, by_products, names, to_text

# Functions by the names that formulas call, and constants.
Functions = Mapping[str, object]
CONSTANTS = ("pi", "I")
Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula that sets a name to an expression, with its origin in the ledger.

    `fact` is the id of a proved fact, or "definition context.name" or "reading context.name" where
    that context says so, or "choice context.name" of a sign that makes its hypotheses hold;
    `context` has its hypotheses.  Functions of a parameter m take its complement 1 - m as their
    last argument.
    """

    name: str
    expression: Expression
    fact: str
    context: str
    source: tuple[str, ...]

    @property
    def is_reading(self) -> bool:
        """True if the formula gives a name to the value of a standard function."""
        return self.fact.startswith("reading ")


class FormulaSequence:
    """A sequence of formulas, in the order of their evaluation.

    The numbers may be of any kind that mixes with integers.

    Powers are calls of `power`, which the functions must include: the own powers of some kinds of
    numbers cannot be trusted.
    """

    def __init__(self, formulas: Iterable[tuple[str, Expression]]) -> None:
        self.formulas = tuple(formulas)
        self._parts: dict[frozenset[str], FormulaSequence] = {}

    @cached_property
    def used(self) -> frozenset[str]:
        """The names that occur in the formulas' expressions."""
        return frozenset(name for _, expression in self.formulas for name in names(expression))

    @cached_property
    def inputs(self) -> frozenset[str]:
        """The names that the formulas need as inputs.

        They occur in an expression and no formula sets them.  Constants are not among them.
        """
        return self.used - {name for name, _ in self.formulas} - {*CONSTANTS}

    def up_to(self, wanted: frozenset[str]) -> "FormulaSequence":
        """Return only the formulas that the wanted quantities need."""
        if wanted not in self._parts:
            needed, kept = set(wanted), []
            for name, expression in reversed(self.formulas):
                if name in needed:
                    needed.update(names(expression))
                    kept.append((name, expression))
            self._parts[wanted] = FormulaSequence(reversed(kept))
        return self._parts[wanted]

    def evaluate(self, values: Mapping[str, Value], functions: Functions) -> dict[str, Value]:
        """Evaluate all formulas and return their results by name.

        The returned dictionary also contains the given values and functions.

        Raises NameError for a missing value or function.
        """
        known: dict[str, Any] = {"__builtins__": {}, **functions, **values}
        exec(self._whole, known)
        return known

    def evaluate_exactly(
        self,
        values: Mapping[str, Value],
        functions: Functions,
        convert: Callable[[Value], Value],
    ) -> dict[str, Value]:
        """Evaluate all formulas, using exact arithmetic wherever all operands are rational.

        A quantity that `values` has is not computed again.  Where a formula uses any number that is
        not rational, all that it uses is converted first.
        """
        known, namespace = dict(values), {**functions, "__builtins__": {}}
        for name, code, taken in self._steps:
            if name in known:
                continue
            given = {other: known[other] for other in taken}
            if not all(isinstance(value, int | Fraction) for value in given.values()):
                given = {other: convert(value) for other, value in given.items()}
            known[name] = eval(code, namespace, given)
        return known

    @cached_property
    def _whole(self) -> CodeType:
        lines = [f"{name} = {_text(expression)}" for name, expression in self.formulas]
        return compile("\n".join(lines), "<formulas>", "exec")

    @cached_property
    def _steps(self) -> list[tuple[str, CodeType, tuple[str, ...]]]:
        return [
            (name, compile(_text(expression), f"<{name}>", "eval"), tuple(names(expression)))
            for name, expression in self.formulas
        ]


def _text(expression: Expression) -> str:
    return to_text(by_products(expression))
