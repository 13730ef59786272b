"""The regular form is Theorem 1 where both hold: R of (25) is a turn after the shortest rotation.

    exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) = exp(psi A1) exp(-phi3 A1) exp(phi2 A2) exp(phi3 A1)

with psi = phi1 + phi3.  The last three factors turn by phi2 about an axis across e_1, and take M/K
to e_1: they are the shortest rotation that does so.  psi' has lost the denominator sin(phi2)^2 of
(32); what is left, K + c1 Omega1, is zero only where phi2 = pi.
"""

from typing import Any

from sympy import factor_terms

from derivations.attitude import PULL_BACK, SHORTEST, TURN, M_a, M_b, M_d, epsilon, nu, sigma
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named, part_of
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.algebra._quaternion import conjugate, product
from rigidsym.proof.steps._names import symbols

K, psi_rate, phi1_rate, phi3_rate = symbols("K psi_rate phi1_rate phi3_rate")
c1, s1, c2, s2, c3, s3 = symbols(
    "cos_half_phi1 sin_half_phi1 cos_half_phi2 sin_half_phi2 cos_half_phi3 sin_half_phi3"
)
cos_phi2, sin_phi2, cos_phi3, sin_phi3 = symbols("cos_phi2 sin_phi2 cos_phi3 sin_phi3")
c, s, cos_psi, sin_psi = symbols("cos_half_psi sin_half_psi cos_psi sin_psi")
SHORT, WHOLE, P = (symbols(f"{q}_0 {q}_a {q}_b {q}_d") for q in "sqp")
# The regular form's names about axis 1: a, b, d = 1, 2, 3 are right-handed, sigma = 1, p = 1.
ABOUT_1 = Part(
    units=(c2,),
    definitions={
        epsilon: 1,
        sigma: 1,
        **named(symbols("c_a c_b c_d"), symbols("c1 c2 c3")),
        **named(symbols("Omega_a Omega_b Omega_d"), symbols("Omega1 Omega2 Omega3")),
        M_a: K * cos_phi2,
        M_b: K * sin_phi2 * sin_phi3,
        M_d: K * sin_phi2 * cos_phi3,
        nu: 2 * K * c2,
        c: c1 * c3 - s1 * s3,
        s: "sin_half_phi1*cos_half_phi3 + cos_half_phi1*sin_half_phi3",
        cos_psi: c**2 - s**2,
        sin_psi: "2*sin_half_psi*cos_half_psi",
        **named(P, (1, 0, 0, 0)),
        **SHORTEST.definitions,
        **TURN.definitions,
        **PULL_BACK.definitions,
    },
    nonnegative=(K, c2),
)


def times(*quaternions: tuple[Any, ...]) -> Computation:
    """Return the product of quaternions."""
    first, second, third = quaternions
    return compute(first).apply(product, second, 1).apply(product, third, 1)


def derive(builder: LedgerBuilder) -> None:
    """Prove that (25) with its angles is a model of the regular form, with (18) as quaternion."""
    angles = part_of(builder.ledger.contexts["three_angle_motion"])
    here = Proofs.open(builder, "both_forms", angles, ABOUT_1)
    here.model("attitude")
    sum_ = "psi is phi1 + phi3: two turns about one axis are one"
    here.claim("turn", {psi_rate: phi1_rate + phi3_rate}, 32, 33, why=sum_)
    first, middle, last = (c1, s1, 0, 0), (c2, 0, s2, 0), (c3, s3, 0, 0)
    doubled = {s3**2: 1 - c3**2, s3 * c3: sin_phi3 / 2}
    shortest = (x.expand().subs(doubled) for x in times(conjugate(last), middle, last))
    shortest = (x.expand().subs(c3**2, (1 + cos_phi3) / 2).expand() for x in shortest)
    claims = {x: form for x, form in named(SHORT, shortest).items() if x != SHORT[1]}
    here.claim("shortest", claims, 27, 28)
    quaternion = (x.expand().apply(factor_terms) for x in times(first, middle, last))
    here.claim("quaternion", named(WHOLE, quaternion), 18, 25)
