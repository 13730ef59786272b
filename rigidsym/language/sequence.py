"""Formulas in order, each by those before it: made ready once, evaluated over any numbers."""

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cached_property
from types import CodeType
from typing import Any, TypeVar

from rigidsym.language.expression import Expression, by_products, names, to_text

# By name: what formulas call, and the constants that they name.
Functions = Mapping[str, object]
Value = TypeVar("Value")


class FormulaSequence:
    """Names set to expressions, in order of evaluation; numbers are whatever mixes with integers.

    Powers are calls of `power`, which the functions have to bring: not all numbers have powers to
    be trusted.
    """

    def __init__(self, formulas: Iterable[tuple[str, Expression]]) -> None:
        self.formulas = tuple(formulas)
        self._parts: dict[frozenset[str], FormulaSequence] = {}

    @cached_property
    def used(self) -> frozenset[str]:
        """The names that the expressions use."""
        return frozenset(name for _, expression in self.formulas for name in names(expression))

    def up_to(self, wanted: frozenset[str]) -> "FormulaSequence":
        """What of it some quantities need."""
        if wanted not in self._parts:
            needed, kept = set(wanted), []
            for name, expression in reversed(self.formulas):
                if name in needed:
                    needed.update(names(expression))
                    kept.append((name, expression))
            self._parts[wanted] = FormulaSequence(reversed(kept))
        return self._parts[wanted]

    def evaluate(self, values: Mapping[str, Value], functions: Functions) -> dict[str, Value]:
        """All quantities by name, among the values and functions given.

        Raises NameError for a value or function that is not given.
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
        """All quantities by name; those given are kept, those of rationals alone are rational.

        Where a formula uses anything else, all that it uses is converted first.
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
