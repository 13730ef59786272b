"""The language of ledgers.  It is read in one way; what its words mean is up to who reads.

Text is made of natural numbers, names, ``+ - * /``, powers that are written as integers, and calls
``f(x, y)``.  Nothing is kept of it: each part is given its meaning as soon as it is read.
"""

import re
from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from rigidsym.independent.records import Refused

Meaning = TypeVar("Meaning")
NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
_TOKEN = re.compile(rf" *(0|[1-9][0-9]*|{NAME.pattern}|\*\*|[-+*/(),])")
_BINDS = {"+": 1, "-": 1, "*": 2, "/": 2, "**": 3}


class Language(ABC, Generic[Meaning]):
    """A reader: it knows the grammar, and a subclass says what numbers, names and signs mean."""

    @abstractmethod
    def number(self, number: int) -> Meaning:
        """What a natural number means."""

    @abstractmethod
    def name(self, name: str) -> Meaning:
        """What a name means, or Refused."""

    @abstractmethod
    def call(self, function: str, arguments: list[Meaning]) -> Meaning:
        """What ``function(*arguments)`` means, or Refused."""

    @abstractmethod
    def combine(self, operator: str, left: Meaning, right: Meaning) -> Meaning:
        """What two things with one of ``+ - * /`` between them mean."""

    @abstractmethod
    def negative(self, operand: Meaning) -> Meaning:
        """What ``-operand`` means."""

    @abstractmethod
    def power(self, base: Meaning, exponent: int) -> Meaning:
        """What ``base**exponent`` means."""

    def read(self, text: str) -> Meaning:
        """The meaning of an expression, all of it."""
        if text.startswith(" ") or _TOKEN.sub("", text).strip(" "):
            raise Refused(f"{text!r:.80} is not made of what expressions are made of")
        tokens = ["", *reversed(_TOKEN.findall(text))]
        value = self._read(tokens)
        _expect(tokens, "")
        return value

    def _read(self, tokens: list[str], binding: int = 0) -> Meaning:
        """Read on, up to an operator that binds no tighter than the one before."""
        value = self._operand(tokens)
        while _BINDS.get(tokens[-1], 0) > binding:
            operator = tokens.pop()
            if operator == "**":
                value = self.power(value, _exponent(tokens))
            else:
                value = self.combine(operator, value, self._read(tokens, _BINDS[operator]))
        return value

    def _operand(self, tokens: list[str]) -> Meaning:
        token = tokens.pop()
        if token == "-":  # takes the whole power after it: -x**2 is -(x**2)
            return self.negative(self._read(tokens, _BINDS["*"]))
        if token.isdigit():
            return self.number(int(token))
        if token == "(":
            value = self._read(tokens)
            _expect(tokens, ")")
            return value
        if not NAME.fullmatch(token):
            raise Refused(f"{token!r} stands where a quantity is due")
        return self.call(token, self._arguments(tokens)) if tokens[-1] == "(" else self.name(token)

    def _arguments(self, tokens: list[str]) -> list[Meaning]:
        tokens.pop()
        arguments = [self._read(tokens)]
        while tokens[-1] == ",":
            tokens.pop()
            arguments.append(self._read(tokens))
        _expect(tokens, ")")
        return arguments


def is_formula(text: str) -> bool:
    """Whether a text is made of what expressions are made of, no two names side by side."""
    spelled = not _TOKEN.sub("", text).strip(" ") and "," not in text.split("(")[0]
    return spelled and not re.search(r"\w +\w", text)


def _exponent(tokens: list[str]) -> int:
    sign = -1 if tokens[-1] == "-" else 1
    if sign < 0:
        tokens.pop()
    if not tokens[-1].isdigit() or tokens[-2] == "**":
        raise Refused("an exponent is not written as an integer")
    return sign * int(tokens.pop())


def _expect(tokens: list[str], due: str) -> None:
    if (token := tokens.pop()) != due:
        raise Refused(f"{token!r} stands where {due!r} is due")
