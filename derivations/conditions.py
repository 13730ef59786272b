"""Conditions of printed lines: where denominators vanish, and starts away from the identity.

Without the condition that a line has, or should have, it divides by zero, or two quantities that it
tells apart are the same.  The print itself is compared in `printed`.
"""

from sympy import MatAdd

from derivations.conjugacy import MOMENTUM
from derivations.euler_lax import INERTIA as MOMENTS
from derivations.lemma1 import FUNCTIONS_OF_JACOBI, INERTIA, SCALED, SINE, Lemma1
from derivations.lie_algebra import Algebra, M, R, combination, commutator, from_quaternion
from derivations.phi1_integral import FUNCTIONS, constants
from derivations.phi1_integral import sine as sine_of
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, part_of, sign
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import Scope, multiply
from rigidsym.proof.steps._names import read, symbol, symbols

# zeta sn by itself, as (10) has it.
SINE_OF_10 = Part(definitions={"mu": "s_i/s_j", "Omega_i": "zeta*sn"})
MOTION_RATES = {
    "Omega1": "K*cos_phi2/c1",
    "Omega2": "K*sin_phi2*sin_phi3/c2",
    "Omega3": "K*sin_phi2*cos_phi3/c3",
}
ON_CIRCLES = ("cos_phi2**2 + sin_phi2**2 - 1", "sin_phi3**2 + cos_phi3**2 - 1")


def derive(builder: LedgerBuilder) -> None:
    """(9), (22); (10) to (13); (12) and Remark 1; (29), (32), (33); (34) to (36)."""
    _start_of_motion(builder)
    _degenerate(builder)
    _start(builder)
    _poles(builder)
    _poles_of_34(builder)
    _amplitude_at_rest(builder)


def _start_of_motion(builder: LedgerBuilder) -> None:
    """Prove that R M R^-1 = M at the start means R M = M R, which holds at R = e only."""
    matrices = {"R": from_quaternion("q"), "M": combination("M1 M2 M3")}
    body = part_of(builder.ledger.contexts["moving_body"])
    matrices = {**builder.result(Algebra).basis, **matrices}
    scope = Scope.open(builder, "any_start", body, matrices=matrices, static=True)
    conjugated, start = R * M * R.I, [9, 22]
    at_e = Part(relations=("q0 - 1", "q1", "q2", "q3"))
    Scope.open(builder, "identity_start", body, at_e, matrices=matrices, static=True)
    gap = MatAdd(conjugated, -M)
    why = "The gap between R M R^-1 and M, times R: none where R and M commute"
    multiply(scope, "any_start.commutes", gap * R, commutator(R, M), why, start)


def _degenerate(builder: LedgerBuilder) -> None:
    """Prove alpha = 0 for c_i equal to another moment, and s = 0 for a spin about axis j."""
    lemma = builder.result(Lemma1)
    moving, quartic = lemma.moving, lemma.quartic
    for other in "jk":
        equal = Part(relations=(f"c_i - c_{other}",))
        here = Proofs.open(
            builder, f"equal_axes_{other}", INERTIA, moving, quartic, equal, static=True
        )
        here.evaluate("alpha", ["alpha"], 13)
    spin = Part(relations=("Omega_i", "Omega_k"))
    here = Proofs.open(builder, "spinning", INERTIA, moving, lemma.roots, spin)
    here.evaluate("root", ["root_j"], 10, 11, 12, "footnote 1")


def _start(builder: LedgerBuilder) -> None:
    """Prove that Remark 1's sign is right for both real values of (12) in a period."""
    half = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    other = Part(
        units=("zeta",),
        definitions={"cn_principal": "half*cn", "S": "sn", "C": "-cn", "E": "dn"},
        nonnegative=("cn_principal",),
    )
    here = Proofs.open(builder, "start", SINE, SCALED, SINE_OF_10, half, other)
    point = {"sn": "3/5", "cn": "-4/5", "half": "-1", "zeta": "1", "s_j": "1", "root_s": "1"}
    left = {**point, "w": "4/5", "xi": "2"}
    principal = {"D(Omega_i)": "xi*zeta*cn_principal*dn"}
    here.refute("principal_value", principal, "footnote 2", "Remark 1", point=left)
    sn, cn, cn_principal = symbols("sn cn cn_principal")
    slope = compute(symbol("zeta") * sn).diff(sn) * read(SCALED.rates["sn"])
    slope = slope.subs(cn, symbol("half") * cn_principal).ordered("half xi zeta cn_principal")
    here.claim("sign", {"D(Omega_i)": slope}, "Remark 1", 16)
    here.claim(
        "other_value",
        {
            "C**2 + S**2": "1",
            "E**2 + mu*S**2": "1",
            "D(S)": "-xi*C*E",
            "D(C)": "xi*S*E",
            "D(E)": "xi*mu*S*C",
        },
        "footnote 2",
        "Remark 1",
        law=FUNCTIONS_OF_JACOBI,
    )


def _poles(builder: LedgerBuilder) -> None:
    """Prove that denominators of (29), (32), (33) vanish with sin(phi2) and cos(phi3)."""
    on_axis = Part(
        ("sin_phi2", "cos_phi2", "cos_phi3", "sin_phi3"),
        definitions=MOTION_RATES,
        relations=("sin_phi2",),
    )
    here = Proofs.open(
        builder, "on_axis", MOMENTS, MOMENTUM, on_axis, Part(relations=ON_CIRCLES), static=True
    )
    below = ["c3*Omega3", "(c2*Omega2)**2 + (c3*Omega3)**2", "K**2 - (c1*Omega1)**2"]
    here.evaluate("denominators", below, 29, 32, 33)
    across = Part(
        ("cos_phi2", "sin_phi2", "cos_phi3", "sin_phi3"),
        definitions=MOTION_RATES,
        relations=("cos_phi3",),
    )
    here = Proofs.open(
        builder, "across", MOMENTS, MOMENTUM, across, Part(relations=ON_CIRCLES), static=True
    )
    here.evaluate("denominator", ["c3*Omega3"], 29)


def _poles_of_34(builder: LedgerBuilder) -> None:
    """Prove that the denominators of (34) vanish for |c1 Omega1| = K."""
    for name, side in (("plus", "K - c1*zeta*sn"), ("minus", "K + c1*zeta*sn")):
        pole = Part(
            ("K", "c1", "zeta", "sn", "cn", "mu", "dn"),
            definitions=sine_of(1).definitions,
            relations=(side,),
        )
        here = Proofs.open(builder, f"pole_{name}", constants(1), FUNCTIONS, pole, static=True)
        here.evaluate("denominator", ["K**2 - (c1*Omega1)**2"], 34)


def _amplitude_at_rest(builder: LedgerBuilder) -> None:
    """Prove that theta' = 0 for dn = 0, so that (36) cannot replace t by theta there."""
    rest = Part(relations=("mu*sn**2 - 1",))
    here = Proofs.open(builder, "amplitude_at_rest", constants(1), FUNCTIONS, rest, static=True)
    here.evaluate("denominator", ["dn**2"], 36)
