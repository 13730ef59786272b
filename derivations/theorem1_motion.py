"""Theorem 1 as one motion: rates by Lemma 1, angles by (19) as mended, the quaternion by (18).

Each rate is zeta sn(xi t + C | mu), whichever root of (13) is zeta^2: its rate squared is the
quadratic that `sine.solves` is about.  `half` is Remark 1's sign.  With them, phi1 by the integral
of the third kind, the mended step to y* and every S_i = 1, (18) solves (3).  It divides by
sin(phi2), which only a spin about axis 1 makes zero; by Omega3; and by cos(phi3/2), where the
quaternion changes its sign and the motion does not.
"""

from dataclasses import replace

from sympy import solve

from derivations.euler_lax import Dynamics
from derivations.lemma1 import INERTIA, RATE, Lemma1
from rigidsym.proof.algebra import LedgerBuilder, Part, join, part_of, sign
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.algebra._quaternion import kinematics
from rigidsym.proof.steps._names import symbols

ZETA, SN = symbols("zeta sn")

# Both square roots may be imaginary: what they are is their reading, and no sign is assumed.
SINE = Part(
    witness={"zeta": "1", "xi": "1"},
    units=("root_k", "zeta"),
    definitions={"mu": "root_j/root_k", "sn": "Omega_i/zeta"},
    rates={"zeta": "0", "xi": "0"},
    reading={
        "zeta": "sqrt(root_j)",
        "xi": "half*sqrt(alpha*root_k)",
        "C_i": "arcsn(Omega_i/zeta, mu)",
        "sn": "jacobi_sn(xi*t + C_i, mu)",
    },
)
ANGLES = Part(
    witness={"zeta": "1", "xi": "1", "t": "0", "Pi": "0"},
    units=("zeta", "xi", "sin_phi2", "cos_phi3", "cos_half_phi3", "cos_phi3 + side**2"),
    definitions={
        "sn": "Omega1/zeta",
        "n": "c1**2*zeta**2/K**2",
        "kappa": "(2*H*c1 - K**2)/(K*c1*xi)",
        "phi1": "K/c1*t + kappa*Pi",
        "x": "c1*Omega1/K",
        "y": "c2*Omega2/(c3*Omega3)",
        "root_y": "side/cos_phi3",
        "y_star": "y/(1 + side*root_y)",
        "F1": "cos_half_phi2",
        "F2": "sin_half_phi2",
        "F3": "cos_half_phi3",
        "F4": "sin_half_phi3",
        "root_star": "1/F3",
        "qbar_0": "F1*(cos_half_phi1*F3 - sin_half_phi1*F4)",
        "qbar_1": "F1*(sin_half_phi1*F3 + cos_half_phi1*F4)",
        "qbar_2": "F2*(cos_half_phi1*F3 + sin_half_phi1*F4)",
        "qbar_3": "F2*(sin_half_phi1*F3 - cos_half_phi1*F4)",
    },
    rates={"zeta": "0", "xi": "0", "t": "1", "Pi": "xi/sin_phi2**2"},
    nonnegative=("K", "root_y", "F1", "F2", "root_star"),
    reading={
        "t": "time, s",
        "Pi": "elliptic_pi(n, jacobi_am(xi*t + C_1, mu), mu) - Pi_0",
        "Pi_0": "elliptic_pi(n, jacobi_am(C_1, mu), mu)",
        "cos_half_phi1": "cos(phi1/2)",
        "sin_half_phi1": "sin(phi1/2)",
    },
)
SIDE = sign("side", "the sign of Omega3")


def derive(builder: LedgerBuilder) -> None:
    """Prove a rate by Lemma 1, the angles, and the quaternion."""
    lemma = builder.result(Lemma1)
    half = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    builder.open(join("one_rate", INERTIA, lemma.moving, lemma.quartic, lemma.roots, half, SINE))
    rate = compute(SN - RATE / ZETA).apply(solve, RATE, simplify=False)[0]
    builder.claim("one_rate.Omega_i", {RATE: rate}, ["10"])
    quadratic = {"D(Omega_i)**2": "alpha*(root_j - Omega_i**2)*(root_k - Omega_i**2)"}
    builder.claim("one_rate.quartic", quadratic, ["13", "14", "Lemma 1"])

    builder.open(join("theorem1_motion", _without_matrices(builder), SIDE, ANGLES))
    below = {"sin_phi2**2": "1 - n*sn**2"}
    builder.claim("theorem1_motion.third_kind", below, ["27", "34"])
    builder.claim("theorem1_motion.phi1", {"D(phi1)": "phi1_rate"}, ["19", "33", "36"])
    _halves(builder)
    names = "qbar_0 qbar_1 qbar_2 qbar_3", "Omega1 Omega2 Omega3"
    unit = {" + ".join(f"{q}**2" for q in names[0].split()): "1"}
    solves = {**unit, **kinematics(*names)}
    builder.claim("theorem1_motion.solution", solves, ["3", "18", "Theorem 1"])


def _without_matrices(builder: LedgerBuilder) -> Part:
    """Return the motion by its three angles, without entries of matrices."""
    motion = part_of(builder.ledger.contexts["three_angle_motion"])
    entries = ("_re", "_im")
    kept = {name: x for name, x in motion.definitions.items() if not name.endswith(entries)}
    return replace(motion, definitions=kept)


def _halves(builder: LedgerBuilder) -> None:
    """Solve for F1 to F4: cos and sin of phi2/2 by x = cos(phi2), of phi3/2 by their quotient."""
    x, y, y_star, root_y, root_star, F1, F2, F3, F4 = symbols(
        "x y y_star root_y root_star F1 F2 F3 F4"
    )
    size = builder.result(Dynamics).body.definitions["K_squared"]
    builder.root("theorem1_motion.K", "K", size, ["6", "15"])
    halves = compute([F1**2 + F2**2 - 1, F1**2 - F2**2 - x]).apply(solve, [F1**2, F2**2])
    for half in (F1, F2):
        builder.root(f"theorem1_motion.{half}", half, halves[half**2].together(), ["19"])
    # cos = 1/root and sin = tan/root are on the circle
    for root, tangent, source in ((root_y, y, ["19"]), (root_star, y_star, ["19", "Remark 2"])):
        circle = compute((1 / root) ** 2 + (tangent / root) ** 2 - 1)
        square = circle.apply(solve, root**2, simplify=False)[0]
        builder.root(f"theorem1_motion.{root}", root, square, source)
    third = compute([F3 * root_star - 1, F4 * root_star - y_star]).apply(solve, [F3, F4])
    for half in (F3, F4):
        builder.claim(f"theorem1_motion.{half}", {half: third[half]}, ["19", "Remark 2"])
