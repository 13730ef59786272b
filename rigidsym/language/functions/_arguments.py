"""Arguments of Jacobi's functions: quarter periods, sums, multiples and imaginary ones.

It imports SymPy alone.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from sympy import Add, I, S, elliptic_e, elliptic_k, gamma, sqrt


class Argument(NamedTuple):
    """An argument u = rest + quarters K + imaginary i K'."""

    rest: Any
    quarters: int
    imaginary: int


class Values(NamedTuple):
    """Values of sn, cn, dn and epsilon for one argument."""

    sn: Any
    cn: Any
    dn: Any
    epsilon: Any


AT_ZERO = Values(S.Zero, S.One, S.One, S.Zero)


def split(u: Any, m: Any) -> Argument:
    """Count the quarter periods K(m) and i K(1 - m) among the terms of an argument."""
    rest, counts = [], [0, 0]
    if not u.has(elliptic_k, gamma):  # K is a gamma function for some m
        return Argument(u, *counts)
    periods = (elliptic_k(m), I * elliptic_k(1 - m))
    for term in Add.make_args(u):
        ratios = [term / period for period in periods]
        if not any(ratio.is_Integer for ratio in ratios):
            rest.append(term)
        for k, ratio in enumerate(ratios):
            counts[k] += int(ratio) if ratio.is_Integer else 0
    return Argument(Add(*rest), *counts)


def joined(argument: Argument, m: Any) -> Any:
    """Return the sum that `split` took apart."""
    rest, quarters, imaginary = argument
    return rest + quarters * elliptic_k(m) + imaginary * I * elliptic_k(1 - m)


def shifted(values: Values, m: Any, quarters: int, imaginary: int) -> Values:
    """Translate an argument by quarter periods (DLMF 22.4(iii)).

    Whole and half periods come first: they change signs alone, also where a value is infinite.
    """
    sn, cn, dn, epsilon = values
    (halves, quarters), (others, imaginary) = divmod(quarters, 2), divmod(imaginary, 2)
    p, q = 1 - 2 * (halves % 2), 1 - 2 * (others % 2)
    first, second = elliptic_e(m), I * (elliptic_k(1 - m) - elliptic_e(1 - m))
    sn, cn, dn = p * sn, p * q * cn, q * dn
    epsilon += 2 * halves * first + 2 * others * second
    if quarters:
        epsilon += first - m * sn * cn / dn
        sn, cn, dn = cn / dn, -sqrt(1 - m) * sn / dn, sqrt(1 - m) / dn
    if imaginary:
        k, epsilon = sqrt(m), epsilon + second + cn * dn / sn
        sn, cn, dn = 1 / (k * sn), -I * dn / (k * sn), -I * cn / sn
    return Values(sn, cn, dn, epsilon)


def expanded(u: Any, m: Any, functions: Callable[[Any, Any], Values]) -> Values:
    """Write the values at a sum, a multiple or an imaginary argument by those at its parts.

    Addition is DLMF 22.8.1 to 22.8.3 and 22.16.28, Jacobi's imaginary transformation is 22.6(iv).
    """
    rest, *periods = split(u.expand(), m)
    number, part = rest.as_coeff_Mul()
    across = rest.as_coefficient(I)
    if rest.is_zero:
        values = AT_ZERO
    elif rest.is_Add:
        values = _sum(m, *(expanded(x, m, functions) for x in rest.as_two_terms()))
    elif number.is_Integer and abs(number) > 1:
        half = number // 2
        pieces = (half * part, (number - half) * part)
        values = _sum(m, *(expanded(x, m, functions) for x in pieces))
    elif across is not None:
        sn, cn, dn, epsilon = expanded(across, 1 - m, functions)
        values = Values(I * sn / cn, 1 / cn, dn / cn, I * (across + dn * sn / cn - epsilon))
    else:
        values = functions(rest, m)
    return shifted(values, m, *periods)


def _sum(m: Any, first: Values, second: Values) -> Values:
    (s1, c1, d1, e1), (s2, c2, d2, e2) = first, second
    under = 1 - m * s1**2 * s2**2
    sn = (s1 * c2 * d2 + s2 * c1 * d1) / under
    cn = (c1 * c2 - s1 * d1 * s2 * d2) / under
    dn = (d1 * d2 - m * s1 * c1 * s2 * c2) / under
    return Values(sn, cn, dn, e1 + e2 - m * s1 * s2 * sn)
