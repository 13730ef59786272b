"""A branch of SymPy's `simplify` for Jacobi's functions.

`simplify` has a branch for each family of functions (trigsimp, besselsimp, combsimp, ...), and no
way to add one from outside, so `join` sets a function in its module that calls `jacobisimp` first.
In SymPy itself this would be two lines there.  It imports SymPy and `_jacobi` alone.
"""

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import wraps
from typing import Any

from sympy import (
    Add,
    Dummy,
    I,
    Mul,
    PolynomialError,
    S,
    bottom_up,
    cancel,
    cos,
    count_ops,
    default_sort_key,
    exp,
    expand_trig,
    factor_terms,
    fraction,
    rem,
    sin,
    sympify,
    tan,
    together,
)
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from rigidsym.language.functions._jacobi import (
    JacobiFunction,
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_sn,
)


def jacobisimp(expression: Any) -> Any:
    """Simplify by sn^2 + cn^2 = 1, dn^2 + m sn^2 = 1, sin am = sn and cos am = cn.

    Examples
    --------
    >>> from sympy import cos, symbols
    >>> u, m = symbols("u m")
    >>> jacobisimp(1 - jacobi_sn(u, m)**2), jacobisimp(1 - cos(jacobi_am(u, m))**2)
    (jacobi_cn(u, m)**2, jacobi_sn(u, m)**2)
    """
    expression = sympify(expression)
    if not expression.has(JacobiFunction):
        return expression
    return bottom_up(_without_amplitude(expression), _reduced)


def _without_amplitude(expression: Any) -> Any:
    """Write sines, cosines and exponentials of amplitudes by sn and cn."""
    expression = expression.replace(
        lambda x: isinstance(x, TrigonometricFunction) and x.has(jacobi_am), expand_trig
    )
    plain = {sin: jacobi_sn, cos: jacobi_cn, tan: lambda u, m: jacobi_sn(u, m) / jacobi_cn(u, m)}
    expression = expression.replace(
        lambda x: x.func in plain and isinstance(x.args[0], jacobi_am),
        lambda x: plain[x.func](*x.args[0].args),
    )
    return expression.replace(
        lambda x: isinstance(x, exp) and x.exp.has(jacobi_am),
        lambda x: Mul(*map(_turn, Add.make_args(x.exp))),
    )


def _turn(exponent: Any) -> Any:
    """Return exp(i n am) as (cn + i sn)^n, and other exponentials unchanged."""
    turns, factors = exponent.as_independent(jacobi_am)
    number = turns / I
    if isinstance(factors, jacobi_am) and number.is_Integer:
        return (jacobi_cn(*factors.args) + I * jacobi_sn(*factors.args)) ** number
    return exp(exponent)


def _reduced(expression: Any) -> Any:
    """Return the shortest form of a sum or quotient by the two identities.

    The functions of all arguments are reduced together, then those of each by itself.
    """
    if not isinstance(expression, (Add, Mul)):
        return expression
    if isinstance(expression, Mul) and not fraction(expression)[1].has(Add, JacobiFunction):
        return expression
    found = expression.atoms(jacobi_sn, jacobi_cn, jacobi_dn)
    arguments = sorted({x.args for x in found}, key=default_sort_key)
    for some in dict.fromkeys([tuple(arguments), *((one,) for one in arguments)]):
        try:
            expression = min([expression, *_forms(expression, some)], key=count_ops)
        except PolynomialError:  # under a root or in another function
            continue
    return expression


def _forms(expression: Any, arguments: Sequence[tuple[Any, Any]]) -> Iterator[Any]:
    """Yield an expression with two of the three squares eliminated, in the three ways."""
    masks = {
        f(*argument): Dummy() for argument in arguments for f in (jacobi_sn, jacobi_cn, jacobi_dn)
    }
    back = {symbol: function for function, symbol in masks.items()}
    parts = fraction(together(expression.xreplace(masks)))
    for way in range(3):
        rules = [rule for argument in arguments for rule in _rules(argument, masks)[way]]
        top, under = (_remainder(part, rules) for part in parts)
        if top == 0:
            yield S.Zero
            return
        yield from (form(top / under).xreplace(back) for form in (cancel, factor_terms))


def _rules(argument: tuple[Any, Any], masks: Mapping[Any, Any]) -> list[list[tuple[Any, Any]]]:
    """List the squares of two functions by the third, in the three ways."""
    _, m = argument
    sn, cn, dn = (masks[f(*argument)] for f in (jacobi_sn, jacobi_cn, jacobi_dn))
    return [
        [(cn, 1 - sn**2), (dn, 1 - m * sn**2)],
        [(sn, 1 - cn**2), (dn, 1 - m + m * cn**2)],
        [(sn, (1 - dn**2) / m), (cn, (dn**2 + m - 1) / m)],
    ]


def _remainder(part: Any, rules: Iterable[tuple[Any, Any]]) -> Any:
    for symbol, square in rules:
        part = rem(part, symbol**2 - square, symbol) if part.has(symbol) else part
    return cancel(part)


def join() -> None:
    """Let SymPy's `simplify` call `jacobisimp`, before its step for hypergeometric functions."""
    module: Any = sys.modules["sympy.simplify.simplify"]
    step = module.hyperexpand
    if not hasattr(step, "jacobisimp"):

        @wraps(step)
        def hyperexpand(expression: Any, **hints: Any) -> Any:
            return step(jacobisimp(expression), **hints)

        hyperexpand.jacobisimp = jacobisimp  # ty: ignore[missing-attribute]
        module.hyperexpand = hyperexpand
