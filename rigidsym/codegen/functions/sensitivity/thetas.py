"""Theta functions of the elapsed time where m > 1/2: those of `theta_hyperbolic`, a term further.

Their nome is that of m_1 itself, below 0.0433, and no square as a state's: nome2 is q here.  Rates
are multiplied by times, and leave out 2 q^25, below 2^-112; functions leave out q^12.
"""

from rigidsym.codegen.ir import Let, let
from rigidsym.codegen.special_functions.text import horner

_SERIES = ("DLMF 20.2.1", "DLMF 20.2.2")


def powers() -> list[Let]:
    """q^2, q^3, ... as far as anything needs them."""
    made = {4: (2, 2), 6: (4, 2), 8: (4, 4), 12: (8, 4), 16: (8, 8), 18: (12, 6), 32: (16, 16)}
    return [let(f"nome{n} = nome{i}*nome{j}", "DLMF 20.2.2") for n, (i, j) in made.items()]


def at_zero() -> list[Let]:
    """theta_2, theta_3, theta_4 of zero, the first over 2 q^(1/4)."""
    return [
        let("two = 1 + nome4 + nome12 + nome12*nome12", "DLMF 20.2.2"),
        let("three = 1 + 2*nome2 + 2*nome8 + 2*nome18 + 2*nome32", "DLMF 20.2.3"),
        let("four = 1 - 2*nome2 + 2*nome8 - 2*nome18 + 2*nome32", "DLMF 20.2.4"),
    ]


def values() -> list[Let]:
    """theta_1 to theta_4 of i y, over q^(1/4) e^|y|, from w, p2, qw2 and sgn(y)."""
    falling, turning = ["1", "nome2", "nome8", "nome18"], ["1", "-nome2", "nome8", "-nome18"]
    return [
        let("w2 = w*w", *_SERIES),
        let(f"tall = {horner('p2', falling)}", "DLMF 20.2.2"),
        let(f"deep = w2*({horner('qw2', falling)})", "DLMF 20.2.2"),
        let("theta2_y = tall + deep", "DLMF 20.2.2"),
        let(f"tall_1 = {horner('p2', turning)}", "DLMF 20.2.1"),
        let(f"deep_1 = w2*({horner('qw2', turning)})", "DLMF 20.2.1"),
        let("theta1_y = side*(tall_1 - deep_1)", "DLMF 20.2.1"),
        let(f"ends = {_ends('w2', 'p2')}", "DLMF 20.2.3"),
        let(f"middle = {_middle('w2', 'p2')}", "DLMF 20.2.3"),
        let("theta3_y = 2*(w*(middle + ends))", "DLMF 20.2.3"),
        let("theta4_y = 2*(w*(middle - ends))", "DLMF 20.2.4"),
    ]


def third(w2: str, p2: str) -> str:
    """theta_3 of i z over 2 q^(1/4), from e^(-2 |z|) and that from the other end of the period."""
    return f"({_middle(w2, p2)}) + ({_ends(w2, p2)})"


def _ends(w2: str, p2: str) -> str:
    return f"{p2}*(1 + nome12*({p2}*{p2})) + {w2}*(nome2 + nome18*({w2}*{w2}))"


def _middle(w2: str, p2: str) -> str:
    return f"1 + nome4*({p2}*{p2}) + {w2}*{w2}*nome8"
