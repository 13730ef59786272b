"""Grammar of ledger expressions, and a parser that evaluates them.

Text is made of natural numbers, names, ``+ - * /``, powers whose exponents are natural numbers, and
calls ``f(x, y)``, with optional spaces between them.  Names are not Python's keywords; numbers have
up to 1000 digits, texts up to 20,000 characters, and up to 50 brackets and signs are open at once.
Each part is evaluated as soon as it is read; no tree is built.
"""

import keyword
import re
from abc import ABC, abstractmethod
from collections.abc import Callable
from operator import add, mul, sub, truediv
from typing import Any, Generic, TypeAlias, TypeVar

from rigidsym.proof.checker._records import Refused

Meaning = TypeVar("Meaning")
NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
_NUMBER = r"(?:0|[1-9][0-9]{0,999})(?!\w)"
_TOKEN = re.compile(rf" *({_NUMBER}|{NAME.pattern}|\*\*|[-+*/(),])", re.ASCII)
_BINDS = {"+": 1, "-": 1, "*": 2, "/": 2, "**": 3}
_ARITHMETIC: dict[str, Callable[[Any, Any], Any]]
_ARITHMETIC = {"+": add, "-": sub, "*": mul, "/": truediv}
_LENGTH = 20_000
_OPEN = 50
# An expression tree: a number, a name, or an operator with its operands.
Form: TypeAlias = int | str | tuple["Form", ...]


def is_name(text: object) -> bool:
    """Return whether a value is a valid name of a quantity or of a context."""
    return isinstance(text, str) and bool(NAME.fullmatch(text)) and not keyword.iskeyword(text)


class Language(ABC, Generic[Meaning]):
    """Parser of ledger expressions, with evaluation left to subclasses.

    Subclasses evaluate numbers, names and calls.
    Operators are Python's own unless a subclass evaluates them in another way.
    """

    @abstractmethod
    def number(self, number: int) -> Meaning:
        """Return the value of a natural number."""

    @abstractmethod
    def name(self, name: str) -> Meaning:
        """Return the value of a name, or raise Refused."""

    @abstractmethod
    def call(self, function: str, arguments: list[Meaning]) -> Meaning:
        """Return the value of ``function(*arguments)``, or raise Refused."""

    def combine(self, operator: str, left: Any, right: Any) -> Meaning:
        """Return the value of ``left operator right`` for one of ``+ - * /``."""
        return _ARITHMETIC[operator](left, right)

    def negative(self, operand: Any) -> Meaning:
        """Return the value of ``-operand``."""
        return -operand

    def power(self, base: Any, exponent: int) -> Meaning:
        """Return the value of ``base**exponent``."""
        return base**exponent

    def read(self, text: str) -> Meaning:
        """Parse and evaluate an expression.

        Raises Refused unless the text is one expression.
        """
        if len(text) > _LENGTH:
            raise Refused(f"an expression of {len(text)} characters")
        if text != text.strip(" ") or _TOKEN.sub("", text):
            raise Refused(f"{text!a:.80} is not made of what expressions are made of")
        tokens = ["", *reversed(_TOKEN.findall(text))]
        value = self._read(tokens)
        _expect(tokens, "")
        return value

    def _read(self, tokens: list[str], binding: int = 0, depth: int = 0) -> Meaning:
        """Parse and evaluate a chain of operators with a precedence above `binding`."""
        value = self._operand(tokens, depth)
        while _BINDS.get(tokens[-1], 0) > binding:
            operator = tokens.pop()
            if operator == "**":
                if not tokens[-1].isdigit() or tokens[-2] == "**":
                    raise Refused("an exponent is not one natural number")
                value = self.power(value, int(tokens.pop()))
            else:
                value = self.combine(operator, value, self._read(tokens, _BINDS[operator], depth))
        return value

    def _operand(self, tokens: list[str], depth: int) -> Meaning:
        if depth > _OPEN:
            raise Refused(f"more than {_OPEN} brackets and signs are open")
        token = tokens.pop()
        if token == "-":  # takes the whole power after it: -x**2 is -(x**2)
            return self.negative(self._read(tokens, _BINDS["*"], depth + 1))
        if token.isdigit():
            return self.number(int(token))
        if token == "(":
            value = self._read(tokens, depth=depth + 1)
            _expect(tokens, ")")
            return value
        if not token[:1].isidentifier() or keyword.iskeyword(token):
            raise Refused(f"{token!r} stands where a quantity is due")
        if tokens[-1] == "(":
            return self.call(token, self._arguments(tokens, depth + 1))
        return self.name(token)

    def _arguments(self, tokens: list[str], depth: int) -> list[Meaning]:
        tokens.pop()
        arguments = [self._read(tokens, depth=depth)]
        while tokens[-1] == ",":
            tokens.pop()
            arguments.append(self._read(tokens, depth=depth))
        _expect(tokens, ")")
        return arguments


class Forms(Language[Form]):
    """Parser of expressions into trees of tuples."""

    def number(self, number: int) -> Form:
        """Return a number, which is its own syntax tree."""
        return number

    def name(self, name: str) -> Form:
        """Return a name, which is its own syntax tree."""
        return name

    def call(self, function: str, arguments: list[Form]) -> Form:
        """Return the syntax tree of a function call."""
        return ("call", function, *arguments)

    def combine(self, operator: str, left: Form, right: Form) -> Form:
        """Return the syntax tree of a binary operation."""
        return operator, left, right

    def negative(self, operand: Form) -> Form:
        """Return the syntax tree of a negation."""
        return "-", operand

    def power(self, base: Form, exponent: int) -> Form:
        """Return the syntax tree of a power."""
        return "**", base, exponent


def is_formula(text: str) -> bool:
    """Return whether a text is an expression of the grammar.

    Its names may have any meaning.
    """
    try:
        Forms().read(text)
    except Refused:
        return False
    return True


def _expect(tokens: list[str], due: str) -> None:
    if (token := tokens.pop()) != due:
        raise Refused(f"{token!r} stands where {due!r} is due")
