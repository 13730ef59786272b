"""The regular form is Theorem 1 where both hold: R of (25) is a turn after the shortest rotation.

    exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) = exp(psi A1) exp(-phi3 A1) exp(phi2 A2) exp(phi3 A1)

with psi = phi1 + phi3.  The last three factors turn by phi2 about an axis across e_1, and take M/K
to e_1: they are the shortest rotation that does so.  psi' has lost the denominator sin(phi2)^2 of
(32); what is left, K + c1 Omega1, is zero only where phi2 = pi.
"""

from sympy import factor_terms

from derivations.attitude import PULL_BACK, SHORTEST, TURN
from rigidsym.proof.algebra import LedgerBuilder, Part, join, part_of
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.algebra._quaternion import conjugate, product
from rigidsym.proof.steps._names import symbols

# The regular form's names about axis 1: a, b, d = 1, 2, 3 are right-handed, sigma = 1, p = 1.
AXES = {"a": 1, "b": 2, "d": 3}
ABOUT_1 = Part(
    units=("cos_half_phi2",),
    definitions={
        "epsilon": "1",
        "sigma": "1",
        **{f"c_{x}": f"c{k}" for x, k in AXES.items()},
        **{f"Omega_{x}": f"Omega{k}" for x, k in AXES.items()},
        "M_a": "K*cos_phi2",
        "M_b": "K*sin_phi2*sin_phi3",
        "M_d": "K*sin_phi2*cos_phi3",
        "nu": "2*K*cos_half_phi2",
        "cos_half_psi": "cos_half_phi1*cos_half_phi3 - sin_half_phi1*sin_half_phi3",
        "sin_half_psi": "sin_half_phi1*cos_half_phi3 + cos_half_phi1*sin_half_phi3",
        "cos_psi": "cos_half_psi**2 - sin_half_psi**2",
        "sin_psi": "2*sin_half_psi*cos_half_psi",
        "p_0": "1",
        **{f"p_{x}": "0" for x in AXES},
        **SHORTEST.definitions,
        **TURN.definitions,
        **PULL_BACK.definitions,
    },
    nonnegative=("K", "cos_half_phi2"),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that (25) with its angles is a model of the regular form, with (18) as quaternion."""
    angles = part_of(builder.ledger.contexts["three_angle_motion"])
    builder.open(join("both_forms", angles, ABOUT_1))
    builder.model("both_forms", "attitude")
    sum_ = "psi is phi1 + phi3: two turns about one axis are one"
    turn = {"psi_rate": "phi1_rate + phi3_rate"}
    builder.claim("both_forms.turn", turn, ["32", "33"], why=sum_)
    turns = [symbols(f"cos_half_phi{k} sin_half_phi{k}") for k in (1, 2, 3)]
    first, last = ((c, s, 0, 0) for c, s in (turns[0], turns[2]))
    middle = turns[1][0], 0, turns[1][1], 0
    shortest = compute(conjugate(last)).apply(product, middle, 1).apply(product, last, 1)
    whole, (c, s) = symbols("cos_phi3 sin_phi3"), turns[2]
    doubled = {s**2: 1 - c**2, s * c: whole[1] / 2}
    found = [x.expand().subs(doubled).expand().subs(c**2, (1 + whole[0]) / 2) for x in shortest]
    claims = dict(zip(("s_0", "s_a", "s_b", "s_d"), (x.expand() for x in found), strict=True))
    claims.pop("s_a")
    builder.claim("both_forms.shortest", claims, ["27", "28"])
    quaternion = compute(first).apply(product, middle, 1).apply(product, last, 1)
    claims = dict(
        zip(
            ("q_0", "q_a", "q_b", "q_d"),
            (x.expand().apply(factor_terms) for x in quaternion),
            strict=True,
        )
    )
    builder.claim("both_forms.quaternion", claims, ["18", "25"])
