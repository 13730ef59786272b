"""Special functions that SymPy lacks, such as Jacobi's elliptic functions.

Legendre's Pi of Jacobi's argument and theta functions are the others.  `_jacobi` and what it needs
could be offered to SymPy; the implementations for printed code are joined to it here.

Printed code reaches the implementations through the tables `NUMPY` and `MPMATH`, so `lambdify`
works with "numpy", "scipy", "math" and "mpmath"; an entry in a dictionary of the caller's comes
first.
"""

from functools import partialmethod
from typing import Any

from rigidsym.language.functions import _arrays as arrays
from rigidsym.language.functions import _jacobi as jacobi
from rigidsym.language.functions import _simplification
from rigidsym.language.functions import _thetas as thetas
from rigidsym.language.functions import _third_kind as third_kind
from rigidsym.language.functions._evaluated import Evaluated
from rigidsym.language.functions._jacobi import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_sn,
)
from rigidsym.language.functions._simplification import jacobisimp
from rigidsym.language.functions._thetas import theta_im, theta_re
from rigidsym.language.functions._third_kind import jacobi_pi

__all__ = [
    "MPMATH",
    "NUMPY",
    "jacobi_am",
    "jacobi_cn",
    "jacobi_dn",
    "jacobi_epsilon",
    "jacobi_pi",
    "jacobi_sn",
    "jacobisimp",
    "theta_im",
    "theta_re",
]

NUMPY = {**arrays.NUMPY, **third_kind.NUMPY, **thetas.NUMPY}
"""All implementations over NumPy arrays by name; `lambdify` finds them by itself."""

MPMATH = {**jacobi.MPMATH, **third_kind.MPMATH, **thetas.MPMATH}
"""All implementations over mpmath numbers."""


def _code(function: Evaluated, printer: Any, table: str) -> str:
    """Print a call of an implementation in a table."""
    name = type(function).__name__
    if name in printer.known_functions:  # the caller's own implementation
        return printer._print_Function(function)
    arguments = ", ".join(printer._print(argument) for argument in function.args)
    return f"{printer._module_format(f'{__name__}.{table}')}['{name}']({arguments})"


for _function in (*jacobi.FUNCTIONS, jacobi_pi, theta_re, theta_im):
    for _method, _table in (("_numpy", "NUMPY"), ("_python", "NUMPY"), ("_mpmath", "MPMATH")):
        setattr(_function, f"{_method}code", partialmethod(_code, table=_table))

_simplification.join()
