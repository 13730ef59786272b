"""The regular form is Theorem 1 where both hold: R of (25) is a turn after the shortest rotation.

    exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) = exp(psi A1) exp(-phi3 A1) exp(phi2 A2) exp(phi3 A1)

with psi = phi1 + phi3.  The last three factors turn by phi2 about an axis across e_1, and take M/K
to e_1: they are the shortest rotation that does so.  psi' has lost the denominator sin(phi2)^2 of
(32); what is left, K + c1 Omega1, is zero only where phi2 = pi.
"""

from derivations.attitude import PULL_BACK, SHORTEST, TURN
from rigidsym.proof.algebra import LedgerBuilder, Part, join, part_of

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
    builder.claim("both_forms.turn", {"psi_rate": "phi1_rate + phi3_rate"}, ["32", "33"])
    builder.claim(
        "both_forms.shortest",
        {
            "s_0": "cos_half_phi2",
            "s_b": "sin_half_phi2*cos_phi3",
            "s_d": "-sin_half_phi2*sin_phi3",
        },
        ["27", "28"],
    )
    F1, F2, F3, F4 = "cos_half_phi2", "sin_half_phi2", "cos_half_phi3", "sin_half_phi3"
    builder.claim(
        "both_forms.quaternion",
        {
            "q_0": f"{F1}*(cos_half_phi1*{F3} - sin_half_phi1*{F4})",
            "q_a": f"{F1}*(sin_half_phi1*{F3} + cos_half_phi1*{F4})",
            "q_b": f"{F2}*(cos_half_phi1*{F3} + sin_half_phi1*{F4})",
            "q_d": f"{F2}*(sin_half_phi1*{F3} - cos_half_phi1*{F4})",
        },
        ["18", "25"],
    )
