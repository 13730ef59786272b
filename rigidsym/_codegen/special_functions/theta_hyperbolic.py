"""Theta functions as polynomials in exponentials, for moduli k_1^2 > 1/2.

By Jacobi's imaginary transformation (DLMF 20.7(viii)) the functions of v - i rho b become those of
rho a + i y with the nome q of 1 - k_1^2, which vanishes on the separatrix.  With w = e^(-2|y|) and
p = q/w <= 1, and both sides over q^(1/4) e^|y|,

    theta_2(rho a + i y | q)
        = sum q^(n^2) (C_n (p^n + w (q w)^n) - i rho sgn(y) S_n (p^n - w (q w)^n))

with C_n, S_n = cos, sin (2n+1)a; theta_1 likewise.  The rates and N^2 take nome q^2 and 2 i y.
q < 0.0433, so that what is left out, q^16, is below 2^-72.
"""

from fractions import Fraction

from rigidsym._codegen.ir import Let, let
from rigidsym._codegen.special_functions.polynomials import horner

STATE, SECULAR = 4, 6
# Above e^-pi, the nome where k_1^2 = 1/2.
LARGEST = Fraction(433, 10_000)
_SERIES, _WATSON = ("DLMF 20.2.1", "DLMF 20.2.2"), "DLMF 20.7.14"


def multiples() -> list[Let]:
    """Return assignments for C_n and S_n, the cosine and sine of (2n+1) a.

    They use cos_a and sin_a.
    """
    lets = [let("C_0 = cos_a", *_SERIES), let("S_0 = sin_a", *_SERIES)]
    lets.append(let("turn = 2*(1 - 2*(sin_a*sin_a))", "DLMF 4.21.27"))
    lets += [let("C_1 = (turn - 1)*C_0", *_SERIES), let("S_1 = (turn + 1)*S_0", *_SERIES)]
    for n in range(2, SECULAR):
        for name in "CS":
            lets.append(let(f"{name}_{n} = turn*{name}_{n - 1} - {name}_{n - 2}", *_SERIES))
    return lets


def powers() -> list[Let]:
    """Return assignments for the powers of the nome in the theta polynomials."""
    products = {2: "nome*nome", 4: "nome2*nome2", 6: "nome4*nome2", 8: "nome4*nome4"}
    products |= {12: "nome8*nome4", 20: "nome12*nome8", 30: "nome20*nome8*nome2"}
    return [let(f"nome{n} = {product}", *_SERIES) for n, product in products.items()]


def zeta() -> list[Let]:
    """Return assignments for zeta = -gc theta_2'/theta_2 at a."""
    falling = ("nome2", "nome6", "nome12", "nome20", "nome30")
    slope = "S_0 + " + " + ".join(f"{2 * n + 1}*{q}*S_{n}" for n, q in enumerate(falling, 1))
    value = "C_0 + " + " + ".join(f"{q}*C_{n}" for n, q in enumerate(falling, 1))
    return [let(f"zeta = gc*({slope})/({value})", "DLMF 20.2.2")]


def coefficients() -> list[Let]:
    """Return assignments for the coefficients q^(n^2) C_n and -rho q^(n^2) S_n."""
    lets = [let("re_0 = C_0", *_SERIES), let("im_0 = -(rho*S_0)", *_SERIES)]
    for n, power in enumerate(("nome", "nome4", "nome8*nome"), 1):
        lets.append(let(f"re_{n} = {power}*C_{n}", *_SERIES))
        lets.append(let(f"im_{n} = -(rho*{power}*S_{n})", *_SERIES))
    return lets


def constants() -> list[Let]:
    """Return assignments for the thetas at zero, and theta_3 at 2 a, with nome q^2."""
    return [
        *at_zero(),
        let("twice = turn*turn - 2", "DLMF 4.21.27"),
        let("twice2 = twice*twice - 2", "DLMF 4.21.27"),
        let("twice3 = twice*twice2 - twice", "DLMF 4.21.27"),
        let("watson = 1 + nome2*twice + nome8*twice2 + nome12*nome6*twice3", _WATSON),
    ]


def at_zero() -> list[Let]:
    """Return assignments for theta_2, theta_3 and theta_4 at zero, with nome q^2.

    theta_2 is divided by 2 q^(1/2).
    """
    return [
        let("two = 1 + nome4 + nome12", "DLMF 20.2.2"),
        let("three = 1 + 2*nome2 + 2*nome8 + 2*(nome12*nome6)", "DLMF 20.2.3"),
        let("four = 1 - 2*nome2 + 2*nome8 - 2*(nome12*nome6)", "DLMF 20.2.4"),
    ]


def values() -> list[Let]:
    """Return assignments that compute all theta functions of a state from w, p and sgn(y)."""
    lets = [
        let("p2 = p*p", *_SERIES),
        let("qw = nome*w", *_SERIES),
        let("qw2 = qw*qw", *_SERIES),
    ]
    for part in ("re", "im"):
        for name, variable in (("near", "p"), ("far", "qw")):
            square = f"{variable}2"
            lets.append(let(f"{name}_{part}_even = {part}_0 + {square}*{part}_2", *_SERIES))
            lets.append(
                let(f"{name}_{part}_odd = {variable}*({part}_1 + {square}*{part}_3)", *_SERIES)
            )
    for name, part, inner, outer, source in (
        ("T4_re", "re", "+", "+", "DLMF 20.2.2"),
        ("T4_im", "im", "+", "-", "DLMF 20.2.2"),
        ("T1_re", "re", "-", "-", "DLMF 20.2.1"),
        ("T1_im", "im", "-", "+", "DLMF 20.2.1"),
    ):
        near, far = (f"({x}_{part}_even {inner} {x}_{part}_odd)" for x in ("near", "far"))
        both = f"{near} {outer} w*{far}"
        lets.append(let(f"{name} = {both if outer == '+' else f'side*({both})'}", source))
    return [*lets, *rate_values()]


def rate_values() -> list[Let]:
    """Return assignments for the body rates' thetas: theta_1 to theta_4 at 2 i y, nome q^2.

    They are divided by q^(1/2) e^|2 y|.
    """
    return [
        let("w2 = w*w", *_SERIES),
        let(f"tall = {horner('p2', ['1', 'nome2', 'nome8'])}", "DLMF 20.2.2"),
        let("deep = w2*(1 + qw2*(nome2 + qw2*nome8))", "DLMF 20.2.2"),
        let("theta2_y = tall + deep", "DLMF 20.2.2"),
        let(
            "theta1_y = side*((1 + p2*(p2*nome8 - nome2)) - w2*(1 + qw2*(qw2*nome8 - nome2)))",
            "DLMF 20.2.1",
        ),
        let("ends = p2*(1 + nome12*(p2*p2)) + w2*nome2", "DLMF 20.2.3"),
        let("middle = 1 + nome4*(p2*p2) + w2*w2*nome8", "DLMF 20.2.3"),
        let("theta3_y = 2*(w*(middle + ends))", "DLMF 20.2.3"),
        let("theta4_y = 2*(w*(middle - ends))", "DLMF 20.2.4"),
    ]


def series_tail() -> Fraction:
    """Bound the truncation error of each theta function, divided by q^(1/4) e^|y|.

    The n-th term is at most q^(n^2) (p^n + w (q w)^n) <= 2 q^(n^2); these fall by q^(2 STATE + 1)
    at least from n = STATE on.  The thetas of nome q^2 leave out less, 2 (q^18 + 2 q^24) at most.
    """
    return 2 * LARGEST ** (STATE**2) / (1 - LARGEST ** (2 * STATE + 1))
