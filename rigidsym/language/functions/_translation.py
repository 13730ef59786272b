"""Translation of the ledger's expressions to SymPy.

SymPy's functions take the parameter m.  The ledger's facts write it, too; formulas for numbers have
its complement 1 - m as the last argument (`BY_COMPLEMENT`).  Integrals and inverses that SymPy has
under Legendre's names become these; thetas of a complex argument become their real and imaginary
parts.
"""

from collections.abc import Callable, Mapping
from operator import add, mul, neg, sub, truediv
from typing import Any

import sympy
from sympy import I, Integer, asin, atan, elliptic_f, elliptic_k, elliptic_pi, exp, pi

from rigidsym.language._expression import Call, Expression, Name, Number, Operation
from rigidsym.language.functions._jacobi import jacobi_am, jacobi_cn, jacobi_dn, jacobi_sn
from rigidsym.language.functions._thetas import theta_im, theta_re
from rigidsym.language.functions._third_kind import jacobi_pi

Function = Callable[..., Any]
Functions = Mapping[str, Function]
_OPERATORS: Functions = {"+": add, "-": sub, "*": mul, "/": truediv, "**": pow}


def sympified(
    expression: Expression, value_of: Callable[[str], Any], functions: Functions
) -> sympy.Expr:
    """Translate an expression of the ledger to SymPy, with values for its names.

    Raises ValueError for a function that is not in the table.
    """
    match expression:
        case Number(value):
            return Integer(value)
        case Name(name):
            return value_of(name)
        case Operation(operator, left, right):
            parts = (sympified(part, value_of, functions) for part in (left, right))
            return _OPERATORS[operator](*parts)
        case Call(function, arguments) if function in functions:
            return functions[function](*(sympified(x, value_of, functions) for x in arguments))
    raise ValueError(f"{expression}: not a function that has a counterpart in SymPy")


BY_PARAMETER: Functions = {
    **{"neg": neg, "sqrt": sympy.sqrt, "cos": sympy.cos, "sin": sympy.sin},
    **{"jacobi_sn": jacobi_sn, "jacobi_cn": jacobi_cn, "jacobi_dn": jacobi_dn},
    **{"jacobi_am": jacobi_am, "elliptic_pi": elliptic_pi},
}
"""Functions as the facts of the ledger have them, with the parameter m last."""


def _elliptic_j(u: Any, n: Any, m: Any) -> Any:
    """Return the integral of sn^2/(1 - n sn^2) from 0 to u in SymPy.

    n is 0 only where m is 0; there the integral is elementary.
    """
    if n == 0:
        return (u - sympy.sin(u) * sympy.cos(u)) / 2
    return (jacobi_pi(n, u, m) - u) / n


def _elliptic_pi(n: Any, *rest: Any) -> Any:
    """Return Legendre's Pi in SymPy, complete for two arguments and incomplete for three.

    The incomplete integral is written as a function of Jacobi's argument.
    """
    if len(rest) == 1:
        return elliptic_pi(n, *rest)
    amplitude, m = rest
    return jacobi_pi(n, amplitude.args[0], m)


def _theta(k: int, order: int = 0) -> Function:
    def of(z: Any, q: Any) -> Any:
        x, y = z.as_real_imag()
        return theta_re(k, x, y, q, order) + I * theta_im(k, x, y, q, order)

    return of


def _by_complement(function: Function) -> Function:
    return lambda *arguments: function(*arguments[:-1], 1 - arguments[-1])


BY_COMPLEMENT: Functions = {
    **BY_PARAMETER,
    "re": lambda z: z.as_real_imag()[0],
    "im": lambda z: z.as_real_imag()[1],
    **{f: _by_complement(BY_PARAMETER[f]) for f in ("jacobi_sn", "jacobi_cn", "jacobi_dn")},
    "jacobi_am": _by_complement(lambda u, m: jacobi_am(u, m, evaluate=False)),
    "elliptic_j": _by_complement(_elliptic_j),
    "elliptic_k": _by_complement(elliptic_k),
    "elliptic_pi": _by_complement(_elliptic_pi),
    "nome": lambda mc: exp(-pi * elliptic_k(mc) / elliptic_k(1 - mc)),
    "arcsc": _by_complement(lambda x, m: elliptic_f(atan(x), m)),
    "arcsn": _by_complement(lambda s, m: elliptic_f(asin(s), m)),
    **{f"theta{k}": _theta(k) for k in range(1, 5)},
    **{f"dtheta{k}": _theta(k, 1) for k in range(1, 5)},
}
"""Functions as formulas for numbers have them, with the complement 1 - m last."""
