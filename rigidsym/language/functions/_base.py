"""The base class of special functions: cached values, and printed code that calls our tables."""

from functools import lru_cache
from typing import Any

from sympy.core.function import DefinedFunction

_STEP = 128  # bits


class Coded(DefinedFunction):
    """A function with implementations, by its name, in the tables `NUMPY` and `MPMATH`."""

    def _eval_evalf(self, prec: int) -> Any:
        return _evaluated(self, rounded_up(prec))

    def _number(self, prec: int) -> Any:
        """Return the value to so many bits; None for arguments outside of the domain."""
        raise NotImplementedError

    def _values(self) -> Any:
        """Return the arguments."""
        return self.args

    def _code(self, printer: Any, table: str) -> str:
        name = type(self).__name__
        if name in printer.known_functions:  # the caller's own implementation
            return printer._print_Function(self)
        arguments = ", ".join(printer._print(argument) for argument in self.args)
        return f"{printer._module_format(f'{__package__}.{table}')}['{name}']({arguments})"

    def _numpycode(self, printer: Any) -> str:
        return self._code(printer, "NUMPY")

    def _mpmathcode(self, printer: Any) -> str:
        return self._code(printer, "MPMATH")


def rounded_up(prec: int) -> int:
    """Round a precision up to one of a few values, so that cached values are reused."""
    return -(-prec // _STEP) * _STEP


@lru_cache(maxsize=4096)
def _evaluated(function: Coded, prec: int) -> Any:
    """Return a cached value: formulas have the same function in many places."""
    return function._number(prec)
