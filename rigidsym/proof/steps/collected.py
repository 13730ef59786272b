"""How an expression reads best: collected as people write it, decided by nobody."""

import sympy
from sympy import Expr, Mul


def collected(expression: Expr) -> Expr:
    """The expression as one fraction of factors, each of the sign and the form that is shorter."""
    above, below = sympy.fraction(sympy.factor(expression))
    sign_above, above = _side(above)
    sign_below, below = _side(below)
    return sign_above * sign_below * above / below


def positive(expression: Expr) -> Expr:
    """The expression or its negative: the one that begins with a plus."""
    return -expression if str(expression).startswith("-") else expression


def _side(side: Expr) -> tuple[int, Expr]:
    """A product with factors that begin with a plus, multiplied out where that is shorter."""
    sign, factors = 1, []
    for factor in Mul.make_args(side):
        base, power = factor.as_base_exp()
        if base.is_Add and str(base).startswith("-"):
            base, sign = -base, sign * (-1 if power % 2 else 1)
        factors.append(base**power)
    product = Mul(*factors)
    sums = [factor for factor in factors if factor.is_Add]
    whole = sympy.expand(Mul(*sums))
    if len(sums) > 1 and sympy.count_ops(whole) <= sympy.count_ops(Mul(*sums)):
        flip = -1 if str(whole).startswith("-") else 1
        rest = [factor for factor in factors if not factor.is_Add]
        return sign * flip, Mul(*rest, flip * whole)
    return sign, product
