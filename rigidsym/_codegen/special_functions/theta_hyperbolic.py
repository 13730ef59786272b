"""Theta functions as polynomials in exponentials, for moduli k_1^2 > 1/2.

By Jacobi's imaginary transformation (DLMF 20.7(viii)) the functions of v - i rho b become those of
rho a + i y with the nome q of 1 - k_1^2, which vanishes on the separatrix.  With w = e^(-2|y|) and
p = q/w <= 1, and both sides over q^(1/4) e^|y|,

    theta_2(rho a + i y | q)
        = sum q^(n^2) (C_n (p^n + w (q w)^n) - i rho sgn(y) S_n (p^n - w (q w)^n))

with C_n, S_n = cos, sin (2n+1)a; theta_1 likewise.  The rates and N^2 take nome q^2 and 2 i y.
q < 0.0433.  A format says how many terms there are in a state and in `Lambda`, and the largest
power of the nome q in the rates and N^2.
"""

from fractions import Fraction
from math import isqrt

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Let, let
from rigidsym._codegen.special_functions.polynomials import horner

# Above e^-pi, the nome where k_1^2 = 1/2.
LARGEST = Fraction(433, 10_000)
_SERIES, _WATSON = ("DLMF 20.2.1", "DLMF 20.2.2"), "DLMF 20.7.14"


def multiples(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for C_n and S_n, the cosine and sine of (2n+1) a.

    They use cos_a and sin_a.
    """
    lets = [let("C_0 = cos_a", *_SERIES), let("S_0 = sin_a", *_SERIES)]
    lets.append(let("turn = 2*(1 - 2*(sin_a*sin_a))", "DLMF 4.21.27"))
    lets += [let("C_1 = (turn - 1)*C_0", *_SERIES), let("S_1 = (turn + 1)*S_0", *_SERIES)]
    for n in range(2, binary.hyperbolic[1]):
        for name in "CS":
            lets.append(let(f"{name}_{n} = turn*{name}_{n - 1} - {name}_{n - 2}", *_SERIES))
    return lets


def powers() -> list[Let]:
    """Return assignments for the powers of the nome in the theta polynomials."""
    products = {2: "nome*nome", 4: "nome2*nome2", 6: "nome4*nome2", 8: "nome4*nome4"}
    products |= {12: "nome8*nome4", 20: "nome12*nome8", 30: "nome20*nome8*nome2"}
    return [let(f"nome{n} = {product}", *_SERIES) for n, product in products.items()]


def zeta(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for zeta = -gc theta_2'/theta_2 at a."""
    falling = [f"nome{n * (n + 1)}" for n in range(1, binary.hyperbolic[1])]
    slope = "S_0 + " + " + ".join(f"{2 * n + 1}*{q}*S_{n}" for n, q in enumerate(falling, 1))
    value = "C_0 + " + " + ".join(f"{q}*C_{n}" for n, q in enumerate(falling, 1))
    return [let(f"zeta = gc*({slope})/({value})", "DLMF 20.2.2")]


def coefficients(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the coefficients q^(n^2) C_n and -rho q^(n^2) S_n."""
    lets = [let("re_0 = C_0", *_SERIES), let("im_0 = -(rho*S_0)", *_SERIES)]
    for n, power in enumerate(("nome", "nome4", "nome8*nome")[: binary.hyperbolic[0] - 1], 1):
        lets.append(let(f"re_{n} = {power}*C_{n}", *_SERIES))
        lets.append(let(f"im_{n} = -(rho*{power}*S_{n})", *_SERIES))
    return lets


def constants(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the thetas at zero, and theta_3 at 2 a, with nome q^2."""
    waves = _squares(binary, "nome2*twice", "nome8*twice2", "nome12*nome6*twice3")
    return [
        *at_zero(binary),
        let("twice = turn*turn - 2", "DLMF 4.21.27"),
        let("twice2 = twice*twice - 2", "DLMF 4.21.27"),
        let("twice3 = twice*twice2 - twice", "DLMF 4.21.27"),
        let(f"watson = {' + '.join(['1', *waves])}", _WATSON),
    ]


def at_zero(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for theta_2, theta_3 and theta_4 at zero, with nome q^2.

    theta_2 is divided by 2 q^(1/2).
    """
    most = binary.hyperbolic[2]
    products = [name for n, name in ((4, "nome4"), (12, "nome12")) if n <= most]
    squares = _squares(binary, "2*nome2", "2*nome8", "2*(nome12*nome6)")
    signed = "".join(f" {sign} {x}" for sign, x in zip("-+-", squares, strict=False))
    return [
        let(f"two = {' + '.join(['1', *products])}", "DLMF 20.2.2"),
        let(f"three = {' + '.join(['1', *squares])}", "DLMF 20.2.3"),
        let(f"four = 1{signed}", "DLMF 20.2.4"),
    ]


def _squares(binary: Format, *terms: str) -> tuple[str, ...]:
    """Select the terms with nome^2, nome^8, nome^18 that a format needs."""
    return terms[: isqrt(binary.hyperbolic[2] // 2)]


def values(binary: Format = BINARY64) -> list[Let]:
    """Return assignments that compute all theta functions of a state from w, p and sgn(y)."""
    lets = [
        let("p2 = p*p", *_SERIES),
        let("qw = nome*w", *_SERIES),
        let("qw2 = qw*qw", *_SERIES),
    ]
    for part in ("re", "im"):
        for name, variable in (("near", "p"), ("far", "qw")):
            terms = [f"{part}_{n}" for n in range(binary.hyperbolic[0])]
            even, odd = (horner(f"{variable}2", terms[first::2]) for first in (0, 1))
            odd = f"({odd})" if len(terms) > 3 else odd
            lets.append(let(f"{name}_{part}_even = {even}", *_SERIES))
            lets.append(let(f"{name}_{part}_odd = {variable}*{odd}", *_SERIES))
    for name, part, inner, outer, source in (
        ("T4_re", "re", "+", "+", "DLMF 20.2.2"),
        ("T4_im", "im", "+", "-", "DLMF 20.2.2"),
        ("T1_re", "re", "-", "-", "DLMF 20.2.1"),
        ("T1_im", "im", "-", "+", "DLMF 20.2.1"),
    ):
        near, far = (f"({x}_{part}_even {inner} {x}_{part}_odd)" for x in ("near", "far"))
        both = f"{near} {outer} w*{far}"
        lets.append(let(f"{name} = {both if outer == '+' else f'side*({both})'}", source))
    return [*lets, *rate_values(binary)]


def rate_values(binary: Format = BINARY64) -> list[Let]:
    """Return assignments for the body rates' thetas: theta_1 to theta_4 at 2 i y, nome q^2.

    They are divided by q^(1/2) e^|2 y|.
    """
    terms = ["1", *_squares(binary, "nome2", "nome8")]
    if len(terms) > 2:
        one = "(1 + p2*(p2*nome8 - nome2)) - w2*(1 + qw2*(qw2*nome8 - nome2))"
        ends, middle = "p2*(1 + nome12*(p2*p2))", "1 + nome4*(p2*p2) + w2*w2*nome8"
    else:
        one, ends, middle = "(1 - p2*nome2) - w2*(1 - qw2*nome2)", "p2", "1 + nome4*(p2*p2)"
    return [
        let("w2 = w*w", *_SERIES),
        let(f"tall = {horner('p2', terms)}", "DLMF 20.2.2"),
        let(f"deep = w2*({horner('qw2', terms)})", "DLMF 20.2.2"),
        let("theta2_y = tall + deep", "DLMF 20.2.2"),
        let(f"theta1_y = side*({one})", "DLMF 20.2.1"),
        let(f"ends = {ends} + w2*nome2", "DLMF 20.2.3"),
        let(f"middle = {middle}", "DLMF 20.2.3"),
        let("theta3_y = 2*(w*(middle + ends))", "DLMF 20.2.3"),
        let("theta4_y = 2*(w*(middle - ends))", "DLMF 20.2.4"),
    ]


def kept(binary: Format = BINARY64) -> list[str]:
    """Return the names of the powers of the nome that states need."""
    return ["nome", *(f"nome{n}" for n in (2, 4, 8, 12) if n <= binary.hyperbolic[2])]


def series_tail(binary: Format = BINARY64) -> Fraction:
    """Bound the truncation error of each theta function, divided by q^(1/4) e^|y|.

    The n-th term is at most q^(n^2) (p^n + w (q w)^n) <= 2 q^(n^2); these fall by q^(2 terms + 1)
    at least from n = terms on.  The thetas of nome q^2 have terms of 2 q^n at most; of these, the
    powers q^n beyond the format's, which fall by q^6 at least, are left out.
    """
    terms, _, power = binary.hyperbolic
    state = 2 * LARGEST ** (terms**2) / (1 - LARGEST ** (2 * terms + 1))
    return max(state, 2 * LARGEST ** (power + 1) / (1 - LARGEST**4))
