"""Vocabularies, conditions and flaws that several printed lines share."""

from collections.abc import Mapping
from dataclasses import replace

from rigidsym.proof.paper._equation import Condition, Flaw, Sense
from rigidsym.proof.paper._printed import Vocabulary

Words = Mapping[str, str]


def same(text: str) -> Words:
    """Map printed names such as c_1 to a context's names without "_", such as c1."""
    return {name: name.replace("_", "") for name in text.split()}


def plain(text: str) -> Words:
    """Map printed names to equal names of a context."""
    return {name: name for name in text.split()}


def su2(a: str, b: str, c: str, d: str) -> str:
    """Return the SU(2) matrix (1) of the quaternion a + b i + c j + d k."""
    first, second = f"{a} + imaginary*({b})", f"{c} + imaginary*({d})"
    return f"matrix({first}, {second}, -({c}) + imaginary*({d}), {a} - imaginary*({b}))"


def algebra(x: str, y: str, z: str) -> str:
    """Return the su(2) matrix x A_1 + y A_2 + z A_3."""
    return su2("0", f"{x}/2", f"{y}/2", f"{z}/2")


RATES = same("Omega_1 Omega_2 Omega_3")
INERTIA = same("c_1 c_2 c_3")
BODY: Words = {**RATES, **INERTIA}
MOMENTUM: Words = {"M": algebra("M1", "M2", "M3"), "at(M, t)": algebra("M1", "M2", "M3")}
ROTATION: Words = {name: su2("q0", "q1", "q2", "q3") for name in ("R", "at(R, t)")}
# R M R^-1, which is constant; M(0) as it is by (22).
SEEN_FROM_SPACE = "*".join((ROTATION["R"], MOMENTUM["M"], su2("q0", "-q1", "-q2", "-q3")))
ANGLES: Words = {
    **{f"{f}(phi_{k})": f"{f}_phi{k}" for f in ("cos", "sin") for k in (1, 2, 3)},
    **{f"{f}(phi_{k} / 2)": f"{f}_half_phi{k}" for f in ("cos", "sin") for k in (1, 2, 3)},
    "e**(imaginary * phi_3)": "cos_phi3 + imaginary*sin_phi3",
    "e**(-(imaginary * phi_3))": "cos_phi3 - imaginary*sin_phi3",
}
ANGLE_RATES: Words = {f"D(phi_{k})": f"phi{k}_rate" for k in (1, 2, 3)}
BASIS = {f"A_{k}": f"A_{k}" for k in (1, 2, 3)}
THREE_TURNS = {**BASIS, "Rbar": "Rbar"}
REDUCED = Vocabulary({**BODY, **MOMENTUM, **ANGLES, "K": "K"})
AXES: Words = {
    **plain("c_i c_j c_k Omega_i Omega_j Omega_k H delta_i"),
    "at(Omega_i, t)": "Omega_i",
    "K**2": "K_squared",
}
# A motion with Omega_i = sqrt(s_i) sn, s_i and s_j being roots in Omega_i^2.
SINE: Words = {
    **plain("c_i Omega_i C_i t"),
    "at(Omega_i, 0)": "Omega_i",
    "at(D(Omega_i), 0)": "D(Omega_i)",
}
IN_RATE: Words = {"s_i": "s_i", "s_j": "s_j", "alpha": "alpha"}
# What (14) makes of them, mended: roots in (c_i Omega_i)^2.
IN_MOMENTUM: Words = {"s_i": "c_i**2*s_i", "s_j": "c_i**2*s_j", "alpha": "alpha/c_i**2"}
QUARTIC_AS_PRINTED = {name: f"{name}_printed" for name in ("alpha", "beta", "chi")}


def exchanged(words: Words) -> Words:
    """Exchange the texts of the first two names."""
    first, second, *_ = words
    return {**words, first: words[second], second: words[first]}


def stated(context: str, texts: Mapping[str, str]) -> Sense:
    """Return a sense made of equations in a context that are no line of the paper."""
    return Sense(context, latex="", texts=texts)


def vanishing(context: str, *texts: str) -> Sense:
    """Return a sense which states that quantities of a context are zero."""
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
