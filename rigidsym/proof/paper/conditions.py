"""Conditions and flaws that several printed lines share."""

from collections.abc import Mapping
from dataclasses import replace

from rigidsym.proof.paper.equation import Condition, Flaw, Sense
from rigidsym.proof.paper.printed import Vocabulary
from rigidsym.proof.paper.words import MOMENTUM, ROTATION, algebra


def stated(context: str, texts: Mapping[str, str]) -> Sense:
    """Equations in the language of a context, which are no line of the paper."""
    return Sense(context, latex="", texts=texts)


def vanishing(context: str, *texts: str) -> Sense:
    """That quantities of a context are zero."""
    return stated(context, dict.fromkeys(texts, "0"))


_MOVING = {**ROTATION, **MOMENTUM}
CONSTANT = Sense(
    "printed_22",
    Vocabulary({**_MOVING, "at(M, 0)": algebra("N1", "N2", "N3")}),
    of="22",
    differentiated=True,
)
AT_START = Sense("identity_start", Vocabulary({**_MOVING, "at(M, 0)": MOMENTUM["M"]}), of="22")
COMMUTES = Condition(
    "R(0) M(0) = M(0) R(0)",
    needed_by=(
        Sense("moving_body", Vocabulary({**_MOVING, "at(M, 0)": MOMENTUM["M"]}), of="22"),
        Sense("moving_body", Vocabulary(_MOVING), latex=r"(RMR^{-1}-M)R=[R,M]"),
    ),
)
DISTINCT = (
    Condition("c_i != c_j", ("c_i - c_j",), (vanishing("equal_axes_j", "alpha"),)),
    Condition("c_i != c_k", ("c_i - c_k",), (vanishing("equal_axes_k", "alpha"),)),
)
SPINNING = vanishing("spinning", "root_j")
S_I = Condition("s_i != 0", ("zeta",), (SPINNING,))
S_J = Condition("s_j != 0", ("s_j", "root_s"), (SPINNING,))
OFF_AXIS = Condition(
    "sin_phi2 != 0",
    ("sin_phi2",),
    (
        vanishing(
            "on_axis", "c3*Omega3", "(c2*Omega2)**2 + (c3*Omega3)**2", "K**2 - (c1*Omega1)**2"
        ),
    ),
)
ACROSS = vanishing("across", "c3*Omega3")
POLES = Condition(
    "(c1*Omega1)**2 != K**2",
    ("K - c1*zeta*sn", "K + c1*zeta*sn"),
    (
        vanishing("pole_plus", "K**2 - (c1*Omega1)**2"),
        vanishing("pole_minus", "K**2 - (c1*Omega1)**2"),
    ),
)
RATE = Condition(
    "xi != 0", ("xi",), (vanishing("equal_axes_j", "alpha"), vanishing("equal_axes_k", "alpha"))
)
RATE_1 = replace(RATE, text="alpha*s_1 != 0", units=("xi", "s_2"))
RATE_2 = replace(RATE, text="alpha*s_2 != 0", units=("xi", "s_2"))
S_2 = Condition("s_2 != 0", ("zeta",), (SPINNING,))
OVER_C_I = {
    Flaw.VARIABLE: "s_i is a root in Omega_i^2; divided by c_i it would be in (c_i Omega_i)^2"
}
IMAGINARY = {
    Flaw.IMAGINARY: "alpha s < 0 for both roots of the circulation axis; s_i < 0 on the third axis"
}
C3_OMEGA3 = Condition("c3*Omega3 != 0", ("cos_half**2 - sin_half**2",), (ACROSS,))
HALF_TURN = Condition("cos(phi3/2) != 0", ("cos_half",), (vanishing("half_turn", "rho + side"),))
ROOT_IN_RATE = {Flaw.VARIABLE: "s_1 is a root in Omega_1^2; n expects one in (c_1 Omega_1)^2"}
CHANGING = {
    Flaw.SIGNS: "S1 S2 is the sign of c3 Omega3: no constant signs last through a period, unless "
    "axis 3 is the circulation axis"
}
JUMPS = {
    Flaw.JUMP: "mended, q changes its sign where phi3 passes pi, as cos(phi3/2) does; "
    "the attitude does not jump"
}
