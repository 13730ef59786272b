"""Conditions of printed lines: where denominators vanish, and starts away from the identity.

Without the condition that a line has, or should have, it divides by zero, or two quantities that it
tells apart are the same.  The print itself is compared in `printed`.
"""

from sympy import MatAdd, UnevaluatedExpr

from derivations.conjugacy import MOMENTUM, K
from derivations.euler_lax import INERTIA as MOMENTS
from derivations.lemma1 import (
    FUNCTIONS_OF_JACOBI,
    INERTIA,
    OTHERS,
    RATE,
    SCALED,
    SINE,
    Lemma1,
    alpha,
    cn,
    dn,
    mu,
    root_j,
    s_i,
    s_j,
    sn,
    xi,
    zeta,
)
from derivations.lie_algebra import MOMENTUM_MATRIX, Algebra, M, R, commutator, from_quaternion
from derivations.phi1_integral import FUNCTIONS, constants
from derivations.phi1_integral import sine as sine_of
from derivations.setting import MOMENTS as NUMBERED
from derivations.setting import RATES
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named, part_of, sign
from rigidsym.proof.algebra._computation import compute, ordered
from rigidsym.proof.steps import Scope, multiply, rate_of
from rigidsym.proof.steps._names import symbols

S, C, E, cn_principal = symbols("S C E cn_principal")
half, cos_phi2, sin_phi2, cos_phi3, sin_phi3 = symbols("half cos_phi2 sin_phi2 cos_phi3 sin_phi3")
# zeta sn by itself, as (10) has it.
SINE_OF_10 = Part(definitions={mu: s_i / s_j, RATE: zeta * sn})
DIRECTION = (cos_phi2, sin_phi2 * sin_phi3, sin_phi2 * cos_phi3)
MOTION_RATES = named(RATES, (K * x / c for x, c in zip(DIRECTION, NUMBERED, strict=True)))
ON_CIRCLES = ("cos_phi2**2 + sin_phi2**2 - 1", "sin_phi3**2 + cos_phi3**2 - 1")
MOMENTUM_1 = UnevaluatedExpr(NUMBERED[0] * RATES[0])


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
    rotation = {"R": from_quaternion("q")}
    matrices = {**builder.result(Algebra).basis, **rotation, **MOMENTUM_MATRIX}
    body = part_of(builder.ledger.contexts["moving_body"])
    scope = Scope.open(builder, "any_start", body, matrices=matrices, static=True)
    at_e = Part(relations=("q0 - 1", "q1", "q2", "q3"))
    Scope.open(builder, "identity_start", body, at_e, matrices=matrices, static=True)
    gap = MatAdd(R * M * R.I, -M)
    why = "The gap between R M R^-1 and M, times R: none where R and M commute"
    multiply(scope, "commutes", gap * R, commutator(R, M), why, [9, 22])


def _degenerate(builder: LedgerBuilder) -> None:
    """Prove alpha = 0 for c_i equal to another moment, and s = 0 for a spin about axis j."""
    lemma = builder.result(Lemma1)
    for other in "jk":
        equal = Part(relations=(f"c_i - c_{other}",))
        parts = (INERTIA, lemma.moving, lemma.quartic, equal)
        here = Proofs.open(builder, f"equal_axes_{other}", *parts, static=True)
        here.evaluate("alpha", [alpha], 13)
    spin = Part(relations=(RATE, OTHERS[1]))
    here = Proofs.open(builder, "spinning", INERTIA, lemma.moving, lemma.roots, spin)
    here.evaluate("root", [root_j], 10, 11, 12, "footnote 1")


def _start(builder: LedgerBuilder) -> None:
    """Prove that Remark 1's sign is right for both real values of (12) in a period."""
    other = Part(
        units=(zeta,),
        definitions={cn_principal: compute(half * cn).ordered("half"), S: sn, C: -cn, E: dn},
        nonnegative=(cn_principal,),
    )
    half_ = sign("half", "+1 where C_i is the value with cn >= 0, -1 where it is the other one")
    here = Proofs.open(builder, "start", SINE, SCALED, SINE_OF_10, half_, other)
    point = {"sn": "3/5", "cn": "-4/5", "half": "-1", "zeta": "1", "s_j": "1", "root_s": "1"}
    left = {**point, "w": "4/5", "xi": "2"}
    principal = {rate_of(RATE): "xi*zeta*cn_principal*dn"}
    here.refute("principal_value", principal, "footnote 2", "Remark 1", point=left)
    slope = compute(zeta * sn).diff(sn) * SCALED.rates[sn]
    slope = slope.subs(cn, half * cn_principal).ordered("half xi zeta cn_principal")
    here.claim("sign", {rate_of(RATE): slope}, "Remark 1", 16)
    curves = {"C**2 + S**2": 1, E**2 + mu * S**2: 1}
    rates = {rate_of(S): -xi * C * E, rate_of(C): xi * S * E, rate_of(E): xi * mu * S * C}
    laws, law = ordered("xi mu S C E", curves | rates), FUNCTIONS_OF_JACOBI
    here.claim("other_value", laws, "footnote 2", "Remark 1", law=law)


def _poles(builder: LedgerBuilder) -> None:
    """Prove that denominators of (29), (32), (33) vanish with sin(phi2) and cos(phi3)."""
    across = "(c2*Omega2)**2 + (c3*Omega3)**2"
    below = [NUMBERED[2] * RATES[2], across, K**2 - MOMENTUM_1**2]
    whole = Part(definitions=MOTION_RATES)
    given, circles = (MOMENTS, MOMENTUM), Part(relations=ON_CIRCLES)
    on_axis = Part((sin_phi2, cos_phi2, cos_phi3, sin_phi3), relations=(sin_phi2,))
    here = Proofs.open(builder, "on_axis", *given, on_axis, whole, circles, static=True)
    here.evaluate("denominators", below, 29, 32, 33)
    on_side = Part((cos_phi2, sin_phi2, cos_phi3, sin_phi3), relations=(cos_phi3,))
    here = Proofs.open(builder, "across", *given, on_side, whole, circles, static=True)
    here.evaluate("denominator", below[:1], 29)


def _poles_of_34(builder: LedgerBuilder) -> None:
    """Prove that the denominators of (34) vanish for |c1 Omega1| = K."""
    names, rate = symbols("K c1 zeta sn cn mu dn"), Part(definitions=sine_of(1).definitions)
    for name, zero in zip(("plus", "minus"), sine_of(1).units, strict=True):
        pole = Part(names, relations=(zero,))
        parts = (constants(1), FUNCTIONS, rate, pole)
        here = Proofs.open(builder, f"pole_{name}", *parts, static=True)
        here.evaluate("denominator", [K**2 - MOMENTUM_1**2], 34)


def _amplitude_at_rest(builder: LedgerBuilder) -> None:
    """Prove that theta' = 0 for dn = 0, so that (36) cannot replace t by theta there."""
    rest = Part(relations=("mu*sn**2 - 1",))
    here = Proofs.open(builder, "amplitude_at_rest", constants(1), FUNCTIONS, rest, static=True)
    here.evaluate("denominator", [dn**2], 36)
