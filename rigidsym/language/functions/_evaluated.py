"""Base class of special functions for SymPy, with cached values and refusing code printers.

It imports SymPy and mpmath alone.
"""

from functools import lru_cache
from typing import Any

from mpmath import mp
from sympy import Expr
from sympy.core.function import DefinedFunction
from sympy.printing.codeprinter import PrintMethodNotImplementedError

_STEP = 128  # bits


class Evaluated(DefinedFunction):
    """Base class of SymPy functions with a value over mpmath numbers.

    Languages without such a function get the name that the caller gives for it in
    `user_functions`, and are refused otherwise: SymPy would print a call of an unknown function.
    """

    def _eval_evalf(self, prec: int) -> Any:
        return _evaluated(self, rounded_up(prec))

    def _number(self, prec: int) -> Any:
        """Return the value of the function to `prec` bits.

        Return None for arguments outside of the domain.
        """
        try:
            wide = 2 * prec + 64 + self._guard(prec)  # 1 - m keeps enough digits when m is near 1
            with mp.workprec(prec):
                value = self._over_mpmath(*(x._to_mpmath(wide) for x in self._values()))
        except (TypeError, ValueError):
            return None
        return Expr._from_mpmath(value, prec)

    def _over_mpmath(self, *values: Any) -> Any:
        """Evaluate the function for mpmath numbers at the working precision."""
        raise NotImplementedError

    def _guard(self, prec: int) -> int:
        """Return how many extra bits the arguments need for a value of `prec` bits."""
        return 0

    def _eval_is_real(self) -> bool | None:
        return True if all(argument.is_real for argument in self._values()) else None

    def _values(self) -> Any:
        """Return the arguments of the function."""
        return self.args

    def _code(self, printer: Any) -> str:
        """Print a call of the function that the caller names, or raise an error."""
        name = type(self).__name__
        if name in printer.known_functions or not printer._settings["strict"]:
            return printer._print_Function(self)
        language = printer.language
        raise PrintMethodNotImplementedError(
            f"{name}: {language} has no such function; name yours: "
            f"user_functions={{{name!r}: 'my_{name}'}}"
        )

    _ccode = _cxxcode = _fcode = _numpycode = _mpmathcode = _pythoncode = _code
    _jaxcode = _cupycode = _torchcode = _tensorflowcode = _mcode = _maple = _code


def rounded_up(prec: int) -> int:
    """Round a precision up to a multiple of 128 bits, so that cached values are reused."""
    return -(-prec // _STEP) * _STEP


@lru_cache(maxsize=4096)
def _evaluated(function: Evaluated, prec: int) -> Any:
    """Return the value of a function to `prec` bits.

    Values are cached because formulas repeat functions.
    """
    return function._number(prec)
