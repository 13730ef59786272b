"""Taylor series at a step's shortest time: Jacobi sine X, its derivative Y, and integral J.

X' = Y and Y' = -e_1 X + 2 e_2 X^3 give X/t and Y as series in a = e_1 t^2 and b = e_2 t^4.  J, the
integral of X^2/(1 - nu X^2) dt, is one in x = X^2 by 1/Y (Legendre's, DLMF 18.12.11) and the
geometric series:

    J = X^3 sum of c_j x^j/(2 j + 3),    c_j = d_j + nu c_{j-1},    1/Y = sum of d_j x^j

Where e_1 = p - r/2 and e_2 = (r/4)^2, 0 <= r <= p <= |omega|^2 for bodies that can exist: l_a, l_b
and l_d are 1 at most by the triangle inequality of moments.  Doublings bring |omega t| of 8 rad to
p t^2 = `largest`, from which all bounds follow.
"""

from fractions import Fraction
from functools import cache
from typing import Any

from flint import fmpq_mpoly_ctx

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Let, let
from rigidsym._codegen.special_functions.polynomials import horner

_PARTS = 16
_TAYLOR, _LEGENDRE = "DLMF 22.10.1", "DLMF 18.12.11"
# A coefficient by the powers of e_1 and e_2.
Polynomial = dict[tuple[int, int], Fraction]


def largest(binary: Format = BINARY64) -> Fraction:
    """Return p t^2 at the shortest time."""
    return Fraction(8, 2**binary.doublings) ** 2


def _solution(linear: Any, cubic: Any, one: Any, count: int) -> list[Any]:
    """Return the Taylor coefficients of the solution of f'' = linear f + 2 cubic f^3.

    They are those of t, t^3, ... for f(0) = 0 and f'(0) = 1: numbers or polynomials, as linear,
    cubic and one are.
    """
    found, squares = [one], []
    for n in range(count - 1):
        cubes = sum((found[i] * squares[n - 1 - i] for i in range(n)), 0 * one)
        squares.append(sum((found[i] * found[n - i] for i in range(n + 1)), 0 * one))
        found.append((linear * found[n] + 2 * cubic * cubes) / ((2 * n + 2) * (2 * n + 3)))
    return found


@cache
def series(terms: int) -> tuple[Polynomial, ...]:
    """Return the coefficients of t, t^3, t^5, ... in the Taylor series of the Jacobi sine X."""
    context = fmpq_mpoly_ctx.get(("e_1", "e_2"), "lex")
    e_1, e_2 = context.gens()
    found = _solution(-e_1, e_2, context.constant(1), terms)
    return tuple(
        {power: Fraction(int(c.p), int(c.q)) for power, c in x.to_dict().items()} for x in found
    )


def elapsed(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the Jacobi sine X and its derivative Y at the shortest time."""
    terms = binary.elapsed
    return [
        let("a_1 = rounded(e_1)*(first_t*first_t)", _TAYLOR),
        let("a_2 = rounded(e_2)*(first_t*first_t*(first_t*first_t))", _TAYLOR),
        let(f"more_X = {_sum([1] * terms)}", _TAYLOR),
        let(f"more_Y = {_sum([2 * n + 1 for n in range(terms)])}", _TAYLOR),
        let("X = first_t*(unity + more_X)", _TAYLOR),
        let("Y = unity + more_Y", _TAYLOR),
    ]


def _sum(factors: list[int]) -> str:
    """Format the Taylor series of X, with a factor for each term, and without the first.

    factors: the numbers that its terms are multiplied by.
    """
    by_power: dict[int, dict[int, Fraction]] = {}
    for factor, coefficient in list(zip(factors, series(len(factors)), strict=True))[1:]:
        for (i, j), c in coefficient.items():
            by_power.setdefault(j, {})[i] = factor * c
    rows = []
    for j in range(max(by_power) + 1):
        row = by_power[j]
        values = [_number(row.get(i, Fraction(0))) for i in range(max(row) + 1)]
        rows.append(f"({horner('a_1', values)})")
    return horner("a_2", rows)


def _number(value: Fraction) -> str:
    if value.denominator == 1:
        return f"({value.numerator})" if value < 0 else str(value.numerator)
    return f"({value.numerator})/{value.denominator}"


def third_kind(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the cosine and sine of an angle from the third-kind integral J.

    The angle is Im(rate J), with complex rate and nu.
    """
    terms = binary.third_kind
    lets = [
        let("square_X = X*X", _LEGENDRE),
        let("d_0 = 1", _LEGENDRE),
        let("d_1 = e_1/2", _LEGENDRE),
    ]
    for j in range(2, terms):
        first, second = f"{2 * j - 1}/{2 * j}", f"{j - 1}/{j}"
        lets.append(
            let(f"d_{j} = ({first})*(e_1*d_{j - 1}) - ({second})*(e_2*d_{j - 2})", _LEGENDRE)
        )
    lets += [let("c_0_re = 1", _LEGENDRE), let("c_0_im = 0", _LEGENDRE)]
    for j in range(1, terms):
        b = j - 1
        lets += [
            let(f"c_{j}_re = d_{j} + (nu_re*c_{b}_re - nu_im*c_{b}_im)", _LEGENDRE),
            let(f"c_{j}_im = nu_re*c_{b}_im + nu_im*c_{b}_re", _LEGENDRE),
        ]
    for part in ("re", "im"):
        values = [f"(1/{2 * j + 3})*c_{j}_{part}" for j in range(terms)]
        lets.append(let(f"J_{part} = X*square_X*({horner('square_X', values)})", _LEGENDRE))
    return [
        *lets,
        let("chi = rate_re*J_im + rate_im*J_re"),
        let("E_re = 1 - chi*chi/2*(1 - chi*chi/12)", "DLMF 4.19.2"),
        let("E_im = chi*(1 - chi*chi/6*(1 - chi*chi/20))", "DLMF 4.19.1"),
    ]


@cache
def elapsed_tail(binary: Format = BINARY64) -> Fraction:
    """Bound the relative truncation error of the Taylor series of X and Y.

    With all signs positive, f'' = e_1 f + 2 e_2 f^3 has coefficients that are no smaller, and grow
    with e_1 and e_2: r is between 0 and p in `_PARTS` parts, in each of which both are at their
    largest.  Beyond four times as many terms it is f'' = f + f^3/2, p being 1, whose f is sqrt(2)
    tan(s/sqrt(2)): tan(x)/x has less than 2 (4/9)^n.  X/t and Y are 1 - p t^2 at least.
    """
    most, count = largest(binary), 4 * binary.elapsed
    share = 2 * most / 9
    beyond = 2 * (2 * count + 1) * share**count / (1 - share) ** 2
    worst = Fraction(0)
    for part in range(_PARTS):
        r, further = Fraction(part, _PARTS), Fraction(part + 1, _PARTS)
        found = _solution(1 - r / 2, further**2 / 16, Fraction(1), count)
        terms = ((2 * n + 1) * found[n] * most**n for n in range(binary.elapsed, count))
        worst = max(worst, sum(terms, Fraction(0)))
    return (worst + beyond) / (1 - most)


def third_kind_tail(binary: Format = BINARY64) -> Fraction:
    """Bound the error in psi/2 that truncating the third-kind integral leaves after a step.

    1/Y is a product of two (1 - a x)^(-1/2) with a <= p, so that d_j <= p^j; |nu| <= h <= p/4 then
    gives |c_j| <= (4/3) p^j.  X <= t; the rate is h z z' with |z| <= 1 and |z'| <= |omega|, since
    the momentum's direction turns no faster; an angle chi by three terms of sine and cosine each is
    wrong by chi^7/500 at most.
    """
    most, terms, shares = largest(binary), binary.third_kind, 2**binary.doublings
    rate = Fraction(1, 4) * Fraction(8, shares) ** 3
    left_out = Fraction(4, 3) * most**terms / (2 * terms + 3) / (1 - most)
    chi = rate * Fraction(1, 3) / (1 - most) ** 2
    return shares * (rate * left_out + chi**7 / 500)
