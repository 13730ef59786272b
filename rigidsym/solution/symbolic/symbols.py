"""The names of formulas as SymPy's symbols, with what is known of their signs."""

from typing import Any

from sympy import Symbol

TIME = Symbol("t", real=True)
_POSITIVE = {"K", "nu", "omega", "W", "N", "y", "z", "g", "nome_1", "nome_m", "root_k", "beta"}
_NONNEGATIVE = {"A_a", "A_b", "A_d", "B_a", "B_d", "lambda_", "mu", "k_1", "k_c", "m_c", "m", "m_1"}
# What Theorem 1 has over complex numbers.
_COMPLEX = ("zeta_", "xi_", "mu_", "C_", "alpha_", "root_")


def named(name: str) -> Any:
    """The symbol of a name, `lambda` for `lambda_`."""
    text = name.rstrip("_")
    if name == "t":
        return TIME
    if name.startswith(_COMPLEX) and name[-1].isdigit():
        return Symbol(text)
    if name in _POSITIVE or (name.startswith("c") and name.lstrip("c_") in {*"abd123"}):
        return Symbol(text, positive=True)
    return Symbol(text, nonnegative=True) if name in _NONNEGATIVE else Symbol(text, real=True)
