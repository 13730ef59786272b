"""Which quantities show by their form that they are not negative, all names being real."""

from typing import Any

from rigidsym.independent.language import Language
from rigidsym.independent.records import Hypotheses


class _Forms(Language[Any]):
    """An expression means its own form: a number, a name, or a tuple of a sign and its parts."""

    def number(self, number: int) -> Any:
        return number

    def name(self, name: str) -> Any:
        return name

    def call(self, function: str, arguments: list[Any]) -> Any:
        return ("call", function, *arguments)

    def combine(self, operator: str, left: Any, right: Any) -> Any:
        return operator, left, right

    def negative(self, operand: Any) -> Any:
        return "-", operand

    def power(self, base: Any, exponent: int) -> Any:
        return "**", base, exponent


class Signs:
    """What a context lets see: sums, products, quotients of what is seen, and even powers."""

    def __init__(self, given: Hypotheses) -> None:
        self._read = _Forms().read
        self._definitions = given.definitions
        self._seen = {self._read(text) for text in given.nonnegative}

    def show(self, text: str) -> bool:
        """Whether the quantity is seen to be nonnegative, wherever it is defined."""
        return self._shown(self._read(text))

    def _shown(self, form: Any) -> bool:
        if form in self._seen:
            return True
        match form:
            case int():
                shown = True
            case str(name):
                shown = name in self._definitions and self.show(self._definitions[name])
            case ("**", base, exponent):
                shown = exponent % 2 == 0 or self._shown(base)
            case ("+" | "*" | "/", left, right):
                shown = self._shown(left) and self._shown(right)
            case _:
                shown = False
        if shown:  # once is enough, however often it occurs
            self._seen.add(form)
        return shown
