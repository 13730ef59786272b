"""The signs of Theorem 1: where (19) is right, which signs match, and where no signs do.

The step to y* is the half-angle step only where c3 Omega3 > 0.  Where it is negative, S1 S2 = -1
makes up for it: R still has the momentum M.  But no constant signs do for a motion in which Omega3
changes sign, and when S1 S2 follows it phi1 has to jump by pi.  The sign of c3 Omega3 before the
square root in y* mends all of that.
"""

from typing import Any

from sympy import MatMul, Symbol, UnevaluatedExpr, cos, sin, sqrt
from sympy.matrices.expressions.adjoint import Adjoint

from derivations.conjugacy import MOMENTUM, K
from derivations.lie_algebra import MOMENTUM_MATRIX, A, Algebra, M, R, from_quaternion
from rigidsym.proof.algebra import (
    LedgerBuilder,
    Part,
    Proofs,
    equal,
    half_angle,
    named,
    sign,
    unit_quaternion,
)
from rigidsym.proof.algebra._computation import ordered
from rigidsym.proof.steps import Scope, matrix, multiply
from rigidsym.proof.steps._names import symbols

HALF_ANGLE = "y* is the tangent or the cotangent of half of phi3"
cos_half, sin_half, side, rho, y, y_star = symbols("cos_half sin_half side rho y y_star")
S1, S2, S3, S4, phi3 = symbols("S1 S2 S3 S4 phi3")
COS = cos_phi2, cos_phi3 = symbols("cos_phi2 cos_phi3")
SIN = sin_phi2, sin_phi3 = symbols("sin_phi2 sin_phi3")
c1, c2, c3 = symbols("cos_half_phi1 cos_half_phi2 cos_half_phi3")
s1, s2, s3 = symbols("sin_half_phi1 sin_half_phi2 sin_half_phi3")
F, Q, (M1, M2, M3) = symbols("F1 F2 F3 F4"), symbols("q0 q1 q2 q3"), symbols("M1 M2 M3")
ACROSS = K * sin_phi2

# cos(phi3) = side * rho with rho = 1/sqrt(1 + y^2) > 0: side tells the half plane phi3 is in.
WHOLE = cos_half**2 - sin_half**2
TANGENT = Part(
    {
        cos_half: cos(phi3 / 2),
        sin_half: sin(phi3 / 2),
        side: "the sign of cos(phi3), that is of c3 Omega3",
    },
    units=(side, WHOLE, 1 + side * WHOLE),
    relations=("sin_half**2 + cos_half**2 - 1", "side**2 - 1"),
    definitions={
        cos_phi3: WHOLE,
        sin_phi3: "2*sin_half*cos_half",
        rho: side * cos_phi3,
        y: sin_phi3 / cos_phi3,
        y_star: "y/(1 + 1/rho)",
    },
    nonnegative=(rho,),
    reading={rho: 1 / sqrt(1 + y**2)},
)


def by_18(c: Any, s: Any, F1: Any, F2: Any, F3: Any, F4: Any) -> list[str]:
    """Return (18) by the cosine and sine of phi1/2 and F1 to F4, as texts.

    SymPy would move the minus signs of what is put in.
    """
    return [
        f"{F1}*({c}*{F3} - {s}*{F4})",
        f"{F1}*({s}*{F3} + {c}*{F4})",
        f"{F2}*({c}*{F3} + {s}*{F4})",
        f"{F2}*({s}*{F3} - {c}*{F4})",
    ]


# F1 to F4 as (19) makes them: phi2 in [0, pi] from x, phi3 in (-pi/2, pi/2) from y.
FACTORS = (
    MOMENTUM,
    sign("side", "the sign of c3 Omega3"),
    *(sign(f"S{k}", f"the sign S_{k} of (19)") for k in (1, 3, 2, 4)),
    *(half_angle(f"phi{k}") for k in (1, 2, 3)),
    Part(
        definitions={
            **named(F, (S1 * c2, S2 * s2, S3 * c3, S4 * s3)),
            **named(Q, by_18(c1, s1, *F)),
            M1: K * cos_phi2,
            **ordered("side", {M2: side * ACROSS * sin_phi3, M3: side * ACROSS * cos_phi3}),
        },
        nonnegative=(sin_phi2, cos_phi3),
    ),
)


def derive(builder: LedgerBuilder) -> None:
    """Prove (19) on both sides of Omega3 = 0, its signs, and Remarks 2 and 3."""
    _inner_halves(builder)
    _signs(builder)
    _crossing(builder)
    _pull_back(builder)


def _inner_halves(builder: LedgerBuilder) -> None:
    """Prove y* = tan(phi3/2) for c3 Omega3 > 0, and y* = -cot(phi3/2) for c3 Omega3 < 0."""

    def case(name: str, *relations: Any) -> Proofs:
        more = Part(units=() if relations else (cos_half,), relations=relations)
        return Proofs.open(builder, name, TANGENT, more, static=True)

    def squares(cosine: Symbol, sine: Symbol, tangent: Any) -> dict[Any, Any]:
        return {cosine**2 * (1 + tangent**2): 1, sine**2 * (1 + tangent**2): tangent**2}

    here, mended = case("half_angle_step"), UnevaluatedExpr(y / (1 + side / rho))
    claims = {"y/(1 + side/rho)*cos_half": sin_half, **squares(cos_half, sin_half, mended)}
    here.claim("mended", claims, 19, "Remark 2", why=HALF_ANGLE)
    here.claim("rho", {rho**2 * (1 + y**2): 1}, 19, why="rho is 1/sqrt(1 + y^2)")
    case("half_turn", cos_half).evaluate("denominator", ["rho + side"], 19, "Remark 2")
    right = case("half_angle_right", "side - 1")
    right.claim("tangent", {"y_star*cos_half": sin_half}, 19, why=HALF_ANGLE)
    right.claim("squares", squares(cos_half, sin_half, y_star), 19, why=HALF_ANGLE)
    left = case("half_angle_left", "side + 1")
    left.claim("cotangent", {"y_star*sin_half": -cos_half}, 19, why=HALF_ANGLE)
    left.claim("squares", squares(sin_half, cos_half, y_star), 19, "Remark 2", why=HALF_ANGLE)


def _signs(builder: LedgerBuilder) -> None:
    """Prove that (18) has the momentum M if S1 S2 is the sign of c3 Omega3 and S3 S4 = 1."""
    matrices = {
        **builder.result(Algebra).basis,
        "R": from_quaternion("q"),
        **MOMENTUM_MATRIX,
    }
    scope = Scope.open(builder, "signed", *FACTORS, matrices=matrices, static=True)
    # A reflected frame would have the determinant -1.
    Proofs(builder, "signed").evaluate("frame", scope.determinant(R)[:1], "footnote 3")
    matched = Part(relations=("S2 - side*S1", S4 - S3))
    scope = Scope.open(builder, "matched_signs", *FACTORS, matched, matrices=matrices, static=True)
    why = "The momentum of (18), if S1 S2 is the sign of M3 and S3 S4 is 1"
    multiply(scope, "momentum", K * (R.I * A[0] * R), M, why, [19, 24, "Remark 2"])
    tilt, why = {S1 * S2 * M3: ACROSS * cos_phi3}, "(29), where S1 S2 is the sign of Omega3"
    here = Proofs(builder, "matched_signs")
    here.claim("side", tilt, 19, "Remark 2", "footnote 3", why=why)


def _crossing(builder: LedgerBuilder) -> None:
    """Prove that at zeros of Omega3, where y* changes its sign, phi1 has to jump by pi."""
    jump = Part({"h": "F3 at the zero of Omega3, there |F4| = F3"})
    angles = (half_angle(f"phi{k}", f"phi{k}_rate") for k in (1, 2))
    here = Proofs.open(builder, "crossing", *angles, jump, static=True)
    before = by_18(c1, s1, c2, s2, "h", "h")
    turned = by_18(f"(-{s1})", c1, c2, f"-{s2}", "h", "(-h)")
    why = "(18) is the same with F2 and F4 negative and phi1 larger by pi"
    here.claim("turned", equal(before, turned), 19, "Remark 2", why=why)


def _pull_back(builder: LedgerBuilder) -> None:
    """Prove that (37) is R_int at t = 0, so that R_int = R(0)."""
    both = unit_quaternion("p", "R_int"), unit_quaternion("r", "Rbar(0)")
    matrices = {"R_int": from_quaternion("p"), "Rbar": from_quaternion("r")}
    scope = Scope.open(builder, "pulled_back", *both, matrices=matrices, static=True)
    R_int, Rbar = map(matrix, matrices)
    start = MatMul(R_int, Adjoint(Rbar), Rbar)
    multiply(scope, "start", start, R_int, "(37) at t = 0", [37, "Remark 3"])
