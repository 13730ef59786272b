"""Formulas of the ledger as SymPy's expressions, name by name.

Functions of a parameter come with its complement as their last argument; SymPy's take m.  Integrals
and inverses that SymPy has under Legendre's names are given by these, thetas of a complex argument
by their real and imaginary parts.
"""

from collections.abc import Callable, Mapping
from typing import Any

import sympy
from sympy import I, Integer, asin, atan, atanh, elliptic_f, elliptic_k, elliptic_pi, exp, pi

from rigidsym.language.expression import Call, Expression, Name, Number, Operation
from rigidsym.language.functions import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_pi,
    jacobi_sn,
    theta_im,
    theta_re,
)

Known = Mapping[str, Any]
CONSTANTS: Known = {"pi": pi, "I": I}
_OPERATORS: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
    "**": lambda x, y: x**y,
}


def sympified(expression: Expression, known: Known) -> Any:
    """An expression of the ledger with values for its names; `pi` and `I` are SymPy's."""
    match expression:
        case Number(value):
            return Integer(value)
        case Name(name):
            return CONSTANTS[name] if name in CONSTANTS else known[name]
        case Operation(operator, left, right):
            return _OPERATORS[operator](sympified(left, known), sympified(right, known))
        case Call("jacobi_argument", (sn, _, _)):
            return _argument(sympified(sn, known), known["m"])
        case Call(function, arguments):
            return _FUNCTIONS[function](*(sympified(argument, known) for argument in arguments))
    raise TypeError(f"{expression!r} is not an expression")


def _argument(sn: Any, m: Any) -> Any:
    """u of sn where cn >= 0."""
    return atanh(sn) if m == 1 else elliptic_f(asin(sn), m)


def _theta(k: int, order: int = 0) -> Callable[[Any, Any], Any]:
    def of(z: Any, q: Any) -> Any:
        x, y = z.as_real_imag()
        return theta_re(k, x, y, q, order) + I * theta_im(k, x, y, q, order)

    return of


def _elliptic_j(u: Any, n: Any, mc: Any) -> Any:
    """The integral of sn^2/(1 - n sn^2): (Pi - u)/n, and elementary where n = 0 = m."""
    if n == 0:
        return (u - sympy.sin(u) * sympy.cos(u)) / 2
    return (jacobi_pi(n, u, 1 - mc) - u) / n


def _elliptic_pi(n: Any, *rest: Any) -> Any:
    """The complete integral, or that to an amplitude, as a function of Jacobi's argument."""
    if len(rest) == 1:
        return elliptic_pi(n, 1 - rest[0])
    amplitude, mc = rest
    return jacobi_pi(n, amplitude.args[0], 1 - mc)


_FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    "neg": lambda x: -x,
    "sqrt": sympy.sqrt,
    "cos": sympy.cos,
    "sin": sympy.sin,
    "re": lambda z: z.as_real_imag()[0],
    "im": lambda z: z.as_real_imag()[1],
    "jacobi_sn": lambda u, mc: jacobi_sn(u, 1 - mc),
    "jacobi_cn": lambda u, mc: jacobi_cn(u, 1 - mc),
    "jacobi_dn": lambda u, mc: jacobi_dn(u, 1 - mc),
    "jacobi_am": lambda u, mc: jacobi_am(u, 1 - mc, evaluate=False),
    "elliptic_j": _elliptic_j,
    "elliptic_k": lambda mc: elliptic_k(1 - mc),
    "elliptic_pi": _elliptic_pi,
    "nome": lambda mc: exp(-pi * elliptic_k(mc) / elliptic_k(1 - mc)),
    "arcsc": lambda x, mc: elliptic_f(atan(x), 1 - mc),
    "arcsn": lambda s, mc: elliptic_f(asin(s), 1 - mc),
    **{f"theta{k}": _theta(k) for k in range(1, 5)},
    **{f"dtheta{k}": _theta(k, 1) for k in range(1, 5)},
}
