"""Theorem 1 as one motion: rates by Lemma 1, angles by (19) as mended, the quaternion by (18).

Each rate is zeta sn(xi t + C | mu), whichever root of (13) is zeta^2: its rate squared is the
quadratic that `sine.solves` is about.  `half` is Remark 1's sign.  With them, phi1 by the integral
of the third kind, the mended step to y* and every S_i = 1, (18) solves (3).  It divides by
sin(phi2), which only a spin about axis 1 makes zero; by Omega3; and by cos(phi3/2), where the
quaternion changes its sign and the motion does not.
"""

from dataclasses import replace

from sympy import cos, factor_terms, sin, sqrt

from derivations.conjugacy import PHI, Angles
from derivations.euler_lax import RATES, Dynamics, K_squared
from derivations.lemma1 import (
    INERTIA,
    RATE,
    C_i,
    Lemma1,
    alpha,
    mu,
    root_j,
    root_k,
    s_i,
    s_j,
    sn,
    xi,
    zeta,
)
from derivations.phi1_integral import ThirdKind
from derivations.theorem1 import Theorem1
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named, part_of, sign
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.algebra._quaternion import kinematics
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import expressions, symbols

Omega1, K, t, n, kappa, phi1, phi1_rate = symbols("Omega1 K t n kappa phi1 phi1_rate")
QBAR, half, root, Pi, Pi_0, C_1 = (
    symbols("qbar_0 qbar_1 qbar_2 qbar_3"),
    *symbols("half root Pi Pi_0 C_1"),
)
x, y, y_star, root_y, root_star, side = symbols("x y y_star root_y root_star side")
HALVES = F1, F2, F3, F4 = symbols("F1 F2 F3 F4")
HALF_ANGLES = symbols("cos_half_phi2 sin_half_phi2 cos_half_phi3 sin_half_phi3")
sin_phi2, cos_phi3 = symbols("sin_phi2 cos_phi3")

# Both square roots may be imaginary: what they are is their reading, and no sign is assumed.
SINE = Part(
    {zeta: sqrt(root_j), xi: half * sqrt(alpha * root_k)},
    units=(root_k, zeta),
    definitions={sn: RATE / zeta},
    rates={zeta: 0, xi: 0},
    reading={C_i: "arcsn(Omega_i/zeta, mu)", sn: "jacobi_sn(xi*t + C_i, mu)"},
)
ANGLES = Part(
    (zeta, xi, t, Pi),
    units=(zeta, xi, sin_phi2, cos_phi3, HALF_ANGLES[2], cos_phi3 + side**2),
    rates={zeta: 0, xi: 0, t: 1, Pi: xi / sin_phi2**2},
    nonnegative=(K, root_y, F1, F2, root_star),
    reading={
        t: "time, s",
        Pi: "elliptic_pi(n, jacobi_am(xi*t + C_1, mu), mu) - Pi_0",
        Pi_0: "elliptic_pi(n, jacobi_am(C_1, mu), mu)",
        "cos_half_phi1": cos(phi1 / 2),
        "sin_half_phi1": sin(phi1 / 2),
    },
)
SIDE = sign("side", "the sign of Omega3")


def derive(builder: LedgerBuilder) -> None:
    """Prove a rate by Lemma 1, the angles, and the quaternion."""
    _one_rate(builder)
    here = _angles(builder)
    _halves(here)
    names = " ".join(map(str, QBAR)), " ".join(map(str, RATES))
    solves = {sum(q**2 for q in QBAR): 1, **kinematics(*names)}
    law = "(3), q' = q (0, Omega)/2 with |q| = 1"
    here.claim("solution", solves, 3, 18, "Theorem 1", law=law)


def _one_rate(builder: LedgerBuilder) -> None:
    """Prove that zeta sn(xi t + C | mu) is a rate by Lemma 1."""
    lemma = builder.result(Lemma1)
    roots = {s_i: root_j, s_j: root_k}
    half = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    sine = replace(SINE, definitions={mu: lemma.parameter.subs(roots), **SINE.definitions})
    parts = (INERTIA, lemma.moving, lemma.quartic, lemma.roots, half, sine)
    here = Proofs.open(builder, "one_rate", *parts)
    here.formulas({RATE: compute(sn - RATE / zeta).solve_for(RATE)}, 10)
    quadratic = {rate_of(RATE) ** 2: lemma.quadratic.subs(roots)}
    here.claim("quartic", quadratic, 13, 14, "Lemma 1")


def _angles(builder: LedgerBuilder) -> Proofs:
    """Prove the rate of phi1 for the formulas of earlier chapters: (19), (27), (29), (36), (18)."""
    angles, theorem = builder.result(Angles), builder.result(Theorem1)
    third = {}
    for part in builder.result(ThirdKind).parts:
        third |= expressions(part.definitions)
    outer, inner = PHI[1] / 2, PHI[2] / 2
    halves = named((cos(outer), sin(outer), cos(inner), sin(inner)), HALVES)
    halves |= named((cos(phi1 / 2), sin(phi1 / 2)), symbols("cos_half_phi1 sin_half_phi1"))
    quaternion = (q.subs(halves).expand().apply(factor_terms) for q in theorem.quaternion)
    definitions = {
        sn: Omega1 / zeta,
        **{name: third[name] for name in (n, kappa, phi1)},
        x: angles.along,
        y: angles.tangent,
        root_y: side / cos_phi3,
        y_star: theorem.half_tangent.subs(root, side * root_y),
        **named(HALVES, HALF_ANGLES),
        root_star: 1 / F3,
        **named(QBAR, quaternion),
    }
    parts = (_without_matrices(builder), SIDE, ANGLES, Part(definitions=definitions))
    here = Proofs.open(builder, "theorem1_motion", *parts)
    across = (1 - angles.along**2).subs(Omega1, zeta * sn)
    here.claim("third_kind", {sin_phi2**2: across.subs(third[n], n)}, 27, 34)
    law = "phi1 has the rate (32), as `third_kind.phi1` says"
    here.claim("phi1", {rate_of(phi1): phi1_rate}, 19, 33, 36, law=law)
    return here


def _without_matrices(builder: LedgerBuilder) -> Part:
    """Return the motion by its three angles, without entries of matrices."""
    motion = part_of(builder.ledger.contexts["three_angle_motion"])
    entries = ("_re", "_im")
    kept = {name: x for name, x in motion.definitions.items() if not name.endswith(entries)}
    return replace(motion, definitions=kept)


def _halves(here: Proofs) -> None:
    """Solve for F1 to F4: cos and sin of phi2/2 by x = cos(phi2), of phi3/2 by their quotient."""
    here.root(K, here.builder.result(Dynamics).body.definitions[K_squared], 6, 15)
    halves = compute([F1**2 + F2**2 - 1, F1**2 - F2**2 - x]).solve_for(F1**2, F2**2)
    for half in (F1, F2):
        here.root(half, halves[half**2].together(), 19)
    # cos = 1/root and sin = tan/root are on the circle
    for root, tangent, source in ((root_y, y, [19]), (root_star, y_star, [19, "Remark 2"])):
        circle = compute((1 / root) ** 2 + (tangent / root) ** 2 - 1)
        here.root(root, circle.solve_for(root**2), *source)
    third = compute([F3 * root_star - 1, F4 * root_star - y_star]).solve_for(F3, F4)
    here.formulas(third, 19, "Remark 2")
