"""SymPy symbols for the names in formulas, and named constants with exact values."""

from functools import lru_cache
from typing import Any
from weakref import WeakValueDictionary

from sympy import AtomicExpr, N, Symbol, sympify
from sympy.core.evalf import prec_to_dps

from rigidsym.language import _latex as typeset
from rigidsym.language.functions._evaluated import rounded_up

TIME = Symbol("t", real=True)
_GUARD_DIGITS = 5
_POSITIVE = {"K", "nu", "omega", "W", "N", "y", "z", "g", "nome_1", "nome_m", "root_k", "beta"}
_NONNEGATIVE = {"A_a", "A_b", "A_d", "B_a", "B_d", "lambda_", "mu", "k_1", "k_c", "m_c", "m", "m_1"}
# The constants of Theorem 1 that may be complex.
_COMPLEX = ("zeta_", "xi_", "mu_", "C_", "alpha_", "root_")


def named(name: str) -> Any:
    """Return the SymPy symbol for a name of the ledger.

    `lambda_` becomes `lambda`.
    """
    text = name.rstrip("_")
    if name == "t":
        return TIME
    kind = Word if typeset.symbol(text).latex.startswith(r"\mathrm") else Symbol
    if name.startswith(_COMPLEX) and name[-1].isdigit():
        return kind(text)
    if name in _POSITIVE or (name.startswith("c") and name.lstrip("c_") in {*"abd123"}):
        return kind(text, positive=True)
    return kind(text, nonnegative=True) if name in _NONNEGATIVE else kind(text, real=True)


class Word(Symbol):
    """A SymPy symbol whose name is a word, such as phase.

    SymPy's LaTeX would show a product of five letters.
    """

    def _latex(self, printer: Any) -> str:
        return typeset.symbol(self.name).latex


class Constant(AtomicExpr):
    """A SymPy number that is printed as a name.

    `Constant("k_1", value)` is printed as k_1.

    The value is exact, may contain other constants, and is evaluated once for each precision.  To
    SymPy the constant is an atom and a number: it has no parts, free symbols or derivative.
    """

    __slots__ = ("__weakref__", "name", "value")
    is_commutative = True
    is_number = True
    name: str
    value: Any

    def __new__(cls, name: str, value: Any) -> "Constant":
        """Create a constant, or return the existing one with the same name and value."""
        key = str(name), sympify(value)
        known = _KNOWN.get(key)
        if known is None:
            known = AtomicExpr.__new__(cls)
            known.name, known.value = key
            _KNOWN[key] = known
        return known

    def __getnewargs__(self) -> tuple[str, Any]:
        return self.name, self.value

    def _hashable_content(self) -> tuple[str, Any]:
        return self.name, self.value

    def _eval_is_real(self) -> bool:
        if named(self.name).is_real:
            return True
        # SymPy does not know of an elliptic integral whether it is real.
        known = self.value.is_real
        return bool(_evaluated(self, rounded_up(1)).is_real) if known is None else known

    def _eval_is_positive(self) -> bool | None:
        return True if named(self.name).is_positive else None

    def _eval_is_nonnegative(self) -> bool | None:
        return True if named(self.name).is_nonnegative else None

    def _eval_is_finite(self) -> bool:
        return True

    def _eval_evalf(self, prec: int) -> Any:
        return _evaluated(self, rounded_up(prec))

    def _sympyrepr(self, printer: Any) -> str:
        return f"Constant({self.name!r}, {printer._print(self.value)})"

    def _as_symbol(self, printer: Any) -> Any:
        return printer._print(named(self.name))

    _sympystr = _latex = _pretty = _as_symbol

    def _numpycode(self, printer: Any) -> str:
        return f"({float(self)!r})"

    def _mpmathcode(self, printer: Any) -> str:
        return f"({printer._print(self.value)})"


# SymPy compares by content; of one object with itself that is quick.
_KNOWN: "WeakValueDictionary[tuple[str, Any], Constant]" = WeakValueDictionary()


@lru_cache(maxsize=4096)
def _evaluated(constant: Constant, prec: int) -> Any:
    return N(constant.value, prec_to_dps(prec) + _GUARD_DIGITS)
