"""Vocabularies, conditions and flaws that several printed lines share."""

from collections.abc import Mapping

from rigidsym.proof.paper._equation import Condition, Flaw, Sense
from rigidsym.proof.paper._printed import Vocabulary

Words = Mapping[str, str]


def same(text: str) -> Words:
    """Map printed names to names without underscores, such as c_1 to c1."""
    return {name: name.replace("_", "") for name in text.split()}


def plain(text: str) -> Words:
    """Map printed names to themselves."""
    return {name: name for name in text.split()}


def su2(a: str, b: str, c: str, d: str) -> str:
    """Return the SU(2) matrix of the quaternion a + b i + c j + d k as text.

    This is equation (1).
    """
    first, second = f"{a} + imaginary*({b})", f"{c} + imaginary*({d})"
    return f"matrix({first}, {second}, -({c}) + imaginary*({d}), {a} - imaginary*({b}))"


def algebra(x: str, y: str, z: str) -> str:
    """Return the su(2) matrix x A_1 + y A_2 + z A_3 as text."""
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
BASIS = {f"A_{k}": f"A_{k}" for k in (1, 2, 3)}
THREE_TURNS = {**BASIS, "Rbar": "Rbar"}


def stated(context: str, texts: Mapping[str, str]) -> Sense:
    """Return a `Sense` that states given equations instead of a printed line."""
    return Sense(context, latex="", texts=texts)


def vanishing(context: str, *texts: str) -> Sense:
    """Return a `Sense` which states that given expressions are zero."""
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
SPINNING = vanishing("spinning", "root_j")
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
IMAGINARY = {
    Flaw.IMAGINARY: "alpha s < 0 for both roots of the circulation axis; s_i < 0 on the third axis"
}
