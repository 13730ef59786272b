"""Nome of a modulus, computed by a series after one further Landen step.

q(k_next) = q(k)^2, and with e = k^2/(2 (1 + k') (1 + root k')^2) at that level

    q = e (1 + 2 e^4 + 15 e^8 + 150 e^12 + ...)        (DLMF 19.5.5 with 20.9)

All terms are positive.  For k^2 <= 1/2 above, k_next^2 is below 3/100 at that level, so that k' and
its root, which are no less than 1 - k_next^2, leave e < 1/500.
"""

from fractions import Fraction
from math import isqrt

from flint import ctx, fmpz_series

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Function, let
from rigidsym._codegen.special_functions.polynomials import horner

_SOURCE = "DLMF 20.9.1"
LARGEST = Fraction(1, 500)


def series_tail(binary: Format = BINARY64) -> Fraction:
    """Bound the relative truncation error of the nome's series q/e for e up to LARGEST.

    q/e is at least 1.
    With e = q R(q^4) as in `coefficients`, let L be a lower bound for |R| where |q| = r = 3/5; |e|
    is at least r L there, and e has the zero q = 0 alone within.  By Rouche's theorem q is analytic
    in e where |e| < r L, with |q| < r, and by Cauchy's estimate the coefficient of e^(4 n) in q/e
    is at most (r L)^(-4 n)/L: a geometric series.
    """
    radius = Fraction(3, 5)
    p = radius**4
    over, under = 1 - p**2 / (1 - p**4), 1 + 2 * p / (1 - p**3)
    least = over / under
    ratio = (LARGEST / (radius * least)) ** 4
    return ratio**binary.nome / (1 - ratio) / least


def coefficients(count: int) -> list[int]:
    """Return the coefficients 1, 2, 15, 150, ... of e^(4 n) in the nome's series q/e.

    >>> coefficients(6)
    [1, 2, 15, 150, 1707, 20910]
    """
    # e = q R(q^4), where R is a quotient of thetas, is solved for q.
    length, before = 4 * count, ctx.cap
    over, under = [0] * length, [0] * length
    for n in range(isqrt(length)):
        if (power := 4 * n * (n + 1)) < length:
            over[power] = 1
        if (power := 4 * n * n) < length:
            under[power] = 2 if n else 1
    try:
        ctx.cap = length
        q = (fmpz_series([0, 1]) * fmpz_series(over) / fmpz_series(under)).reversion()
    finally:
        ctx.cap = before
    return [int(q[4 * n + 1]) for n in range(count)]


def root_ratio(binary: Format = BINARY64) -> Function:
    """Build the function that computes r = k/sqrt(q) from the modulus k with nome q.

    r is 4 at k = 0.
    """
    terms = [str(value) for value in coefficients(binary.nome)]
    lets = (
        let("root_kc = sqrt(kc)", "DLMF 19.8.12"),
        let("k_next = (k/(1 + kc))*(k/(1 + kc))", "DLMF 19.8.12", facts=("landen.k_next",)),
        let(
            "kc_next = 2*root_kc/(1 + kc)",
            "DLMF 19.8.12",
            facts=("definition landen.kc_next",),
        ),
        let("root = 1 + sqrt(kc_next)", _SOURCE),
        let("f = 2*(1 + kc_next)*root*root", _SOURCE),
        let("e = k_next*k_next/f", _SOURCE),
        let("e2 = e*e", _SOURCE),
        let("e4 = e2*e2", _SOURCE),
        let(f"r = (1 + kc)/sqrt(sqrt(({horner('e4', terms)})/f))", _SOURCE),
    )
    summary = "k/sqrt(q) where q is the nome of modulus k, kc its complement, k^2 <= 1/2."
    return Function("_root_ratio", summary, ("k", "kc"), lets, ("r",), frozenset(("k", "kc")))
