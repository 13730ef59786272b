"""Expressions of the C source read back: numbers have a point, and calls are of their kinds."""

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass

from rigidsym.codegen.ir import Function
from rigidsym.errors import InputError
from rigidsym.language.expression import Call, Expression, Name, Number, Operation, parse

_NUMBER = re.compile(r"(?<![\w.])[\d.][\w.]*")
_WHOLE = re.compile(r"(0|[1-9]\d*)\.0")
_OPERATIONS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
# Functions of doubles and what they compute.
_OF_DOUBLES = {
    **{"fused": "fma", "fabs": "size", "sqrt": "sqrt", "exponential": "exp", "choose": "choose"},
    **{name: name for name in ("nearest", "alternating", "power_of_two", "product_error")},
}
# Functions of extended numbers, after `dd_`: kinds of arguments (x: extended), and of the value.
_OF_EXTENDED = {
    **{"neg": ("x", "x"), "sqrt": ("x", "x"), "size": ("x", "x"), "mantissa": ("x", "x")},
    **{"rounded": ("x", "d"), "exponent": ("x", "d"), "choose": ("ddxx", "x"), "of": ("d", "x")},
}


@dataclass(frozen=True, slots=True)
class Reader:
    """Reads the expressions of one function: `extended` are the names of its extended numbers.

    number: what begins the names of their operations, `dd` or `exact`; functions: those of the
    module that may be called, by name.
    """

    place: str
    number: str
    extended: Collection[str]
    functions: Mapping[str, Function]

    def read(self, text: str) -> tuple[Expression, bool]:
        """An expression, and whether its value is extended; raises InputError for anything else."""
        for number in _NUMBER.findall(text):
            if not _WHOLE.fullmatch(number):
                raise InputError(self.place, text, f"{number} is no whole number with a point")
        if re.search(r"\bneg\(", text):
            raise InputError(self.place, text, "neg: called and not known")
        try:
            expression = parse(_WHOLE.sub(r"\1", text))
        except (SyntaxError, ValueError):
            raise InputError(self.place, text, "is no expression") from None
        whole, kind = self._read(expression)
        return whole, kind == "x"

    def _read(self, expression: Expression) -> tuple[Expression, str]:
        match expression:
            case Number():
                return expression, "d"
            case Name(name):
                return expression, "x" if name in self.extended else "d"
            case Operation(symbol, left, right) if symbol in _OPERATIONS.values():
                return Operation(symbol, *self._all((left, right), "dd", symbol)), "d"
            case Call("neg", arguments):
                return Call("neg", self._all(arguments, "d", "-")), "d"
            case Call(function, arguments):
                return self._call(function, arguments)
        raise InputError(self.place, expression, "is nothing that derived lines have")

    def _call(self, function: str, arguments: tuple[Expression, ...]) -> tuple[Expression, str]:
        number, _, verb = function.partition("_")
        if number == self.number:
            return self._extended(function, verb, arguments)
        if function in _OF_DOUBLES:
            kinds = "d" * len(arguments)
            return Call(_OF_DOUBLES[function], self._all(arguments, kinds, function)), "d"
        if function in self.functions:
            called = self.functions[function]
            kinds = "".join("x" if name in called.extended else "d" for name in called.parameters)
            value = "x" if called.extended else "d"
            return Call(called.name, self._all(arguments, kinds, function)), value
        raise InputError(self.place, function, "called and not known")

    def _extended(
        self, function: str, verb: str, arguments: tuple[Expression, ...]
    ) -> tuple[Expression, str]:
        operation, _, kinds = verb.partition("_")
        if operation in _OPERATIONS and kinds in ("xx", "xd", "dx"):
            parts = self._all(arguments, kinds, function)
            return Operation(_OPERATIONS[operation], *parts), "x"
        if verb not in _OF_EXTENDED:
            raise InputError(self.place, function, "called and not known")
        kinds, value = _OF_EXTENDED[verb]
        parts = self._all(arguments, kinds, function)
        return (parts[0] if verb == "of" else Call(verb, parts)), value

    def _all(
        self, arguments: tuple[Expression, ...], kinds: str, function: str
    ) -> tuple[Expression, ...]:
        """The arguments, which are of these kinds."""
        read = [self._read(argument) for argument in arguments]
        if "".join(kind for _, kind in read) != kinds:
            raise InputError(self.place, function, "is given another kind of numbers")
        return tuple(argument for argument, _ in read)
