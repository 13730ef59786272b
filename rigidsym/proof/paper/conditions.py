"""Conditions and flaws that several printed lines share."""

from dataclasses import replace

from rigidsym.proof.paper.equation import Condition, Flaw, Reading

COMMUTES = Condition("R(0) M(0) = M(0) R(0)", needed_by=("moving_body.any_start",))
DISTINCT = (
    Condition("c_i != c_j", ("c_i - c_j",), ("equal_axes_j.alpha",)),
    Condition("c_i != c_k", ("c_i - c_k",), ("equal_axes_k.alpha",)),
)
S_I = Condition("s_i != 0", ("zeta", "sqrt_mu"), ("spinning.root",))
S_J = Condition("s_j != 0", ("s_j", "root_s"), ("spinning.root",))
OFF_AXIS = Condition("sin_phi2 != 0", ("sin_phi2",), ("on_axis.denominators",))
POLES = Condition(
    "(c1*Omega1)**2 != K**2",
    ("K - c1*zeta*sn", "K + c1*zeta*sn"),
    ("pole_plus.denominator", "pole_minus.denominator"),
)
RATE = Condition("xi != 0", ("xi",), ("equal_axes_j.alpha", "equal_axes_k.alpha"))
RATE_1 = replace(RATE, text="alpha*s_1 != 0")
RATE_2 = replace(RATE, text="alpha*s_2 != 0")
S_2 = Condition("s_2 != 0", ("sqrt_mu",), ("spinning.root",))
OVER_C_I = {
    Flaw.VARIABLE: "s_i is a root in Omega_i^2; divided by c_i it would be in (c_i Omega_i)^2"
}
IMAGINARY = {
    Flaw.IMAGINARY: "alpha s < 0 for both roots of the circulation axis; s_i < 0 on the third axis"
}
C3_OMEGA3 = Condition("c3*Omega3 != 0", ("cos_half**2 - sin_half**2",), ("across.denominator",))
HALF_TURN = Condition("cos(phi3/2) != 0", ("cos_half",), ("half_turn.denominator",))
ROOT_IN_RATE = {Flaw.VARIABLE: "s_1 is a root in Omega_1^2; n expects one in (c_1 Omega_1)^2"}
CHANGING = {Flaw.SIGNS: "S1 S2 is the sign of c3 Omega3"}
ROOTS_OF_N = (
    Reading(
        "s_1 and s_2 by (13) and (14) as they are printed",
        "n lacks the factor c_1^2",
        ("theorem1_phi1.n",),
        ("theorem1_printed.n",),
    ),
    Reading(
        "s_1 and s_2 are roots in (c_1 Omega_1)^2, by (14) as mended for Lemma 1",
        "n is right as it is printed",
        ("theorem1_printed.with_14_mended",),
    ),
)
