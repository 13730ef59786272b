"""What these functions share: code that is printed calls the tables of this package."""

from functools import lru_cache
from typing import Any

from sympy.core.function import DefinedFunction

_STEP = 128  # bits


class Coded(DefinedFunction):
    """A function with implementations, by its name, in the tables `NUMPY` and `MPMATH`."""

    def _eval_evalf(self, prec: int) -> Any:
        return _evaluated(self, rounded_up(prec))

    def _number(self, prec: int) -> Any:
        """The value to so many bits, None where the arguments are no numbers it is known for."""
        raise NotImplementedError

    def _values(self) -> Any:
        """The arguments."""
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
    """The next of few precisions, so that what was computed for one serves its neighbours."""
    return -(-prec // _STEP) * _STEP


@lru_cache(maxsize=4096)
def _evaluated(function: Coded, prec: int) -> Any:
    """Kept, because formulas have the same function in many places."""
    return function._number(prec)
