"""A number by its name: what it is stays out of sight, and is computed once a precision."""

from functools import lru_cache
from typing import Any
from weakref import WeakValueDictionary

from sympy import Expr, N
from sympy.core.evalf import prec_to_dps
from sympy.core.symbol import Str

from rigidsym.language.functions.base import rounded_up
from rigidsym.solution.symbolic.symbols import named

_GUARD_DIGITS = 5
# SymPy compares trees; of one object with itself that is quick.
_KNOWN: "WeakValueDictionary[tuple[str, Any], Constant]" = WeakValueDictionary()


class Constant(Expr):
    """`Constant(Str("k_1"), value)`: printed as k_1, and as real and as large as its value.

    The value may have other constants in it.  It is a number: no free symbols, no derivative.
    """

    is_commutative = True
    is_number = True

    def __new__(cls, name: Any, value: Any) -> "Constant":
        """Of a name, a text or SymPy's Str; the same object for the same number."""
        key = str(name), value
        known = _KNOWN.get(key)
        if known is None:
            _KNOWN[key] = known = Expr.__new__(cls, Str(key[0]), value)
        return known

    @property
    def name(self) -> str:
        """The ledger's name."""
        return str(self.args[0])

    @property
    def value(self) -> Any:
        """What it is, exactly."""
        return self.args[1]

    @property
    def free_symbols(self) -> set[Any]:
        """None."""
        return set()

    def _eval_is_real(self) -> bool | None:
        return True if named(self.name).is_real else self.value.is_real

    def _eval_evalf(self, prec: int) -> Any:
        return _evaluated(self, rounded_up(prec))

    def _sympystr(self, printer: Any) -> str:
        return printer._print(named(self.name))

    def _latex(self, printer: Any) -> str:
        return printer._print(named(self.name))

    def _pretty(self, printer: Any) -> Any:
        return printer._print(named(self.name))

    def _numpycode(self, printer: Any) -> str:
        return repr(complex(self)) if self.is_real is None else repr(float(self))

    def _mpmathcode(self, printer: Any) -> str:
        return printer._print(self.value)


@lru_cache(maxsize=4096)
def _evaluated(constant: Constant, prec: int) -> Any:
    return N(constant.value, prec_to_dps(prec) + _GUARD_DIGITS)
