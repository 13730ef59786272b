"""Theta functions as polynomials in cos 2v, for moduli k_1^2 <= 1/2.

x is cos 2v, and the nome Q^2 is small.
Q is the nome of m, Q^2 that of k_1^2, and h+- = sqrt(Q) e^(+-b), so that in the series of DLMF 20.2

    theta_4(v - i rho b | Q^2) = 1 + sum (-1)^n (p_2n cos 2nv + i rho d_2n sin 2nv)
    theta_1(v - i rho b | Q^2) =     sum (-1)^n (p_2n+1 sin (2n+1)v - i rho d_2n+1 cos (2n+1)v)

the coefficients are p_k, d_k = Q^(k(k-1)/2) (h+^k +- h-^k).  The same with nome Q and b = 0 serves
the rates and N^2 (Watson's identity).  h+ < 1 since b is below a quarter of the period, and
Q < 0.208.  A format says how many terms there are: the largest k of p_k and d_k in a state, that in
`Lambda`, which needs more of them, and the largest power of the nome Q in the rates and N^2.
"""

from collections.abc import Mapping
from math import isqrt

from flint import fmpz_poly

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Let, let
from rigidsym._codegen.special_functions.polynomials import horner, linear

_SERIES, _WATSON = ("DLMF 20.2.1", "DLMF 20.2.4"), "DLMF 20.7.14"
# Powers of Q by their exponents, from those before.
_POWERS = {
    **{2: "Q*Q", 4: "Q2*Q2", 6: "Q4*Q2", 9: "Q4*Q4*Q", 12: "Q6*Q6", 16: "Q12*Q4"},
    **{20: "Q16*Q4"},
}
_NAMES = {0: "1", 1: "Q", **{n: f"Q{n}" for n in _POWERS}, 25: "Q9*Q16"}


def powers(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the coefficients p_k and d_k of the theta series.

    They use Q, h_plus and h_minus.
    """
    _, most, _ = binary.circular
    lets = [let("up1 = h_plus", *_SERIES), let("down1 = h_minus", *_SERIES)]
    lets += [let("step_up1 = h_plus*Q", *_SERIES), let("step_down1 = h_minus*Q", *_SERIES)]
    for k in range(2, most + 1):
        for way in ("up", "down"):
            lets.append(let(f"{way}{k} = {way}{k - 1}*step_{way}{k - 1}", *_SERIES))
            if k < most:
                lets.append(let(f"step_{way}{k} = step_{way}{k - 1}*Q", *_SERIES))
    for k in range(1, most + 1):
        lets += [let(f"p{k} = up{k} + down{k}", *_SERIES), let(f"d{k} = up{k} - down{k}", *_SERIES)]
    return lets


def zeta(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for zeta = g Im theta_4'/theta_4 at v = -i b."""
    even = range(2, binary.circular[1] + 1, 2)
    slope = linear({f"d{k}": -((-1) ** (k // 2)) * k for k in even})
    value = linear({"1": 1} | {f"p{k}": (-1) ** (k // 2) for k in even})
    return [let(f"zeta = g*({slope})/({value})", "DLMF 20.2.4")]


def coefficients(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the coefficients of the theta polynomials in x.

    They use p_k, d_k and Q.
    """
    most, _, _ = binary.circular
    even, odd = range(2, most + 1, 2), range(1, most + 1, 2)
    signs = {k: (-1) ** (k // 2) for k in range(most + 1)}
    cosines = {"1": _cosine(0)} | {f"p{k}": signs[k] * _cosine(k // 2) for k in even}
    sines = {f"d{k}": 2 * signs[k] * fmpz_poly.chebyshev_u(k // 2 - 1) for k in even}
    odd_sines = {f"p{k}": signs[k] * _odd_sine(k // 2) for k in odd}
    # cos (2n+1)v / cos v is (-1)^n sin (2n+1)v / sin v of -x.
    odd_cosines = {f"d{k}": -_odd_sine(k // 2)(fmpz_poly([0, -1])) for k in odd}
    return [
        *_table(names("T4_re", binary), cosines),
        *_table(names("T4_im", binary), sines, "rho"),
        *_table(names("T1_re", binary), odd_sines),
        *_table(names("T1_im", binary), odd_cosines, "rho"),
        *rates(binary),
    ]


def rates(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the coefficients of the theta polynomials that body rates need.

    These thetas have real v and the nome Q.
    """
    below = binary.circular[2] - 1
    squares = {_NAMES[n * n]: min(n + 1, 2) * _cosine(n) for n in range(isqrt(below) + 1)}
    even, odd = (dict(list(squares.items())[first::2]) for first in (0, 1))
    sines = {name: (-1) ** n * _odd_sine(n) for n, name in enumerate(_products(below))}
    return [
        *(let(f"Q{n} = {product}", *_SERIES) for n, product in _POWERS.items()),
        *_table(names("even", binary), even, step=2),
        *_table(names("odd", binary), odd, first=1, step=2),
        *_table(names("sine_even", binary), sines, step=2),
        *_table(names("sine_odd", binary), sines, first=1, step=2),
    ]


def _products(most: int) -> list[str]:
    """Return the names of the powers Q^(n (n + 1)) with exponents up to `most`."""
    return [name for n, name in _NAMES.items() if n <= most and 4 * n + 1 == isqrt(4 * n + 1) ** 2]


def at_zero(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for theta_2, theta_3 and theta_4 at zero, with nome Q.

    theta_2 is divided by 2 Q^(1/4).
    """
    most = binary.circular[2]
    squares = [f"2*{_NAMES[n * n]}" for n in range(1, isqrt(most) + 1)]
    return [
        let(f"two = {' + '.join(_products(most))}", "DLMF 20.2.2"),
        let(f"even_sum = {' + '.join(['1', *squares[1::2]])}", "DLMF 20.2.3"),
        let(f"odd_sum = {' + '.join(squares[::2])}", "DLMF 20.2.3"),
        let("three = even_sum + odd_sum", "DLMF 20.2.3"),
        let("four = even_sum - odd_sum", "DLMF 20.2.4"),
    ]


def constants(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the thetas at zero, and theta_3 at i b, with nome Q."""
    lets = at_zero(binary)
    # e^(2 n b) Q^(n^2) = Q^(n^2 - n) h_plus^(2 n)
    lets += [let("h2_plus = h_plus*h_plus", _WATSON), let("h2_minus = h_minus*h_minus", _WATSON)]
    for way in ("plus", "minus"):
        inner = f"h2_{way}"
        *ratios, last = [inner, *(f"Q{n}*{inner}" for n in (2, 4, 6)), f"Q4*Q4*{inner}"][
            : len(_products(binary.circular[2]))
        ]
        nested = "".join(f"{ratio}*(1 + " for ratio in ratios) + last + ")" * len(ratios)
        lets.append(let(f"side_{way} = {nested}", _WATSON))
    return [*lets, let("watson = 1 + side_plus + side_minus", _WATSON)]


def values(binary: Format = BINARY64) -> list[Let]:
    """Return assignments that compute all theta functions of a state from sin v and cos v."""
    return [
        *argument(),
        let(f"T4_re = {horner('x', names('T4_re', binary))}", "DLMF 20.2.4"),
        let(f"T4_im = sin_v*cos_v*({horner('x', names('T4_im', binary))})", "DLMF 20.2.4"),
        let(f"T1_re = sin_v*({horner('x', names('T1_re', binary))})", "DLMF 20.2.1"),
        let(f"T1_im = cos_v*({horner('x', names('T1_im', binary))})", "DLMF 20.2.1"),
        *rate_values(binary),
    ]


def argument() -> list[Let]:
    """Return assignments for x = cos 2v and its square."""
    return [
        let("x = 1 - 2*(sin_v*sin_v)", "DLMF 4.21.27"),
        let("x2 = x*x", "DLMF 20.2.1", "DLMF 20.2.4"),
    ]


def rate_values(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the body rates' thetas: theta_1 to theta_4 at v, with nome Q.

    The first two are divided by 2 Q^(1/4).
    """
    return [
        let(f"sum_even = {horner('x2', names('even', binary))}", "DLMF 20.2.4"),
        let(f"sum_odd = x*({horner('x2', names('odd', binary))})", "DLMF 20.2.4"),
        let("theta4_v = sum_even - sum_odd", "DLMF 20.2.4"),
        let("theta3_v = sum_even + sum_odd", "DLMF 20.2.3"),
        let(f"part_even = {horner('x2', names('sine_even', binary))}", "DLMF 20.2.1"),
        let(f"part_odd = x*({horner('x2', names('sine_odd', binary))})", "DLMF 20.2.1"),
        let("theta1_v = sin_v*(part_even + part_odd)", "DLMF 20.2.1"),
        let("theta2_v = cos_v*(part_even - part_odd)", "DLMF 20.2.2"),
    ]


def names(form: str, binary: Format = BINARY64) -> list[str]:
    """Return the names of a polynomial's coefficients, lowest first."""
    most, _, power = binary.circular
    squares, sines = isqrt(power - 1), len(_products(power - 1))
    lengths = {
        **{"T4_re": most // 2 + 1, "T4_im": most // 2},
        **dict.fromkeys(("T1_re", "T1_im"), (most + 1) // 2),
        **{"even": squares // 2 + 1, "odd": (squares + 1) // 2},
        **{"sine_even": (sines + 1) // 2, "sine_odd": sines // 2},
    }
    return [f"{form}_{j}" for j in range(lengths[form])]


def _table(
    names: list[str],
    rows: Mapping[str, fmpz_poly],
    factor: str = "",
    first: int = 0,
    step: int = 1,
) -> list[Let]:
    """Return assignments for the coefficients of a polynomial in x.

    These may be those of its even or odd powers alone: those from `first` on, `step` apart.
    rows: the polynomial that each symbol multiplies.
    """
    lets = []
    for j, name in enumerate(names):
        text = linear({symbol: int(row[first + step * j]) for symbol, row in rows.items()})
        lets.append(let(f"{name} = {f'{factor}*({text})' if factor else text}", *_SERIES))
    return lets


def _cosine(n: int) -> fmpz_poly:
    """Return cos 2nv as a polynomial in x = cos 2v."""
    return fmpz_poly.chebyshev_t(n)


def _odd_sine(n: int) -> fmpz_poly:
    """Return sin (2n+1)v / sin v as a polynomial in x = cos 2v."""
    return fmpz_poly.chebyshev_u(n) + (fmpz_poly.chebyshev_u(n - 1) if n else 0)


def series_tail(binary: Format = BINARY64) -> float:
    """Bound the truncation error of the theta polynomials.

    The bound is twice the first omitted term, for binary64 p_8 or Q^25.
    """
    largest, (most, _, power) = 0.208, binary.circular
    return 2 * max(2 * largest ** (most * (most + 1) // 2), 2 * largest**power)
