"""The signs of Theorem 1: where (19) is right, which signs match, and where no signs do.

The step to y* is the half-angle step only where c3 Omega3 > 0.  Where it is negative, S1 S2 = -1
makes up for it: R still has the momentum M.  But no constant signs do for a motion in which Omega3
changes sign, and when S1 S2 follows it phi1 has to jump by pi.  The sign of c3 Omega3 before the
square root in y* mends all of that.
"""

from sympy import MatMul
from sympy.matrices.expressions.adjoint import Adjoint

from derivations.conjugacy import MOMENTUM
from derivations.lie_algebra import A, Algebra, M, R, combination, from_quaternion
from rigidsym.proof.algebra import LedgerBuilder, Part, equal, half_angle, join, sign
from rigidsym.proof.steps import Scope, matrix
from rigidsym.proof.steps._names import symbol

HALF_ANGLE = "y* is the tangent or the cotangent of half of phi3"
ANGLES = tuple(half_angle(f"phi{k}", f"phi{k}_rate") for k in (1, 2, 3))

# cos(phi3) = side * rho with rho = 1/sqrt(1 + y^2) > 0: side tells the half plane phi3 is in.
TANGENT = Part(
    {
        "cos_half": "cos(phi3/2)",
        "sin_half": "sin(phi3/2)",
        "side": "the sign of cos(phi3), that is of c3 Omega3",
    },
    units=("side", "cos_half**2 - sin_half**2", "1 + side*(cos_half**2 - sin_half**2)"),
    relations=("sin_half**2 + cos_half**2 - 1", "side**2 - 1"),
    definitions={
        "cos_phi3": "cos_half**2 - sin_half**2",
        "sin_phi3": "2*sin_half*cos_half",
        "rho": "side*cos_phi3",
        "y": "sin_phi3/cos_phi3",
        "y_star": "y/(1 + 1/rho)",
    },
    nonnegative=("rho",),
    reading={"rho": "1/sqrt(1 + y**2)"},
)

# F1 to F4 as (19) makes them: phi2 in [0, pi] from x, phi3 in (-pi/2, pi/2) from y.
FACTORS = (
    MOMENTUM,
    sign("side", "the sign of c3 Omega3"),
    *(sign(f"S{k}", f"the sign S_{k} of (19)") for k in (1, 3, 2, 4)),
    *(half_angle(f"phi{k}") for k in (1, 2, 3)),
    Part(
        definitions={
            "F1": "S1*cos_half_phi2",
            "F2": "S2*sin_half_phi2",
            "F3": "S3*cos_half_phi3",
            "F4": "S4*sin_half_phi3",
            "q0": "F1*(cos_half_phi1*F3 - sin_half_phi1*F4)",
            "q1": "F1*(sin_half_phi1*F3 + cos_half_phi1*F4)",
            "q2": "F2*(cos_half_phi1*F3 + sin_half_phi1*F4)",
            "q3": "F2*(sin_half_phi1*F3 - cos_half_phi1*F4)",
            "M1": "K*cos_phi2",
            "M2": "side*K*sin_phi2*sin_phi3",
            "M3": "side*K*sin_phi2*cos_phi3",
        },
        nonnegative=("sin_phi2", "cos_phi3"),
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
    builder.open(join("half_angle_step", TANGENT, Part(units=("cos_half",)), static=True))
    tangent = {"y_star*cos_half": "sin_half"}
    mended = "y/(1 + side/rho)"
    builder.claim(
        "half_angle_step.mended",
        {
            f"{mended}*cos_half": "sin_half",
            f"cos_half**2*(1 + ({mended})**2)": "1",
            f"sin_half**2*(1 + ({mended})**2)": f"({mended})**2",
        },
        ["19", "Remark 2"],
        why=HALF_ANGLE,
    )
    rho = {"rho**2*(1 + y**2)": "1"}
    builder.claim("half_angle_step.rho", rho, ["19"], why="rho is 1/sqrt(1 + y^2)")
    half_turn = Part(relations=("cos_half",))
    builder.open(join("half_turn", TANGENT, half_turn, static=True))
    builder.evaluate("half_turn.denominator", ["rho + side"], ["19", "Remark 2"])
    right = Part(relations=("side - 1",))
    builder.open(join("half_angle_right", TANGENT, right, static=True))
    builder.claim("half_angle_right.tangent", tangent, ["19"], why=HALF_ANGLE)
    builder.claim(
        "half_angle_right.squares",
        {
            "cos_half**2*(1 + y_star**2)": "1",
            "sin_half**2*(1 + y_star**2)": "y_star**2",
        },
        ["19"],
        why=HALF_ANGLE,
    )
    left = Part(relations=("side + 1",))
    builder.open(join("half_angle_left", TANGENT, left, static=True))
    cotangent = {"y_star*sin_half": "-cos_half"}
    builder.claim("half_angle_left.cotangent", cotangent, ["19"], why=HALF_ANGLE)
    builder.claim(
        "half_angle_left.squares",
        {
            "sin_half**2*(1 + y_star**2)": "1",
            "cos_half**2*(1 + y_star**2)": "y_star**2",
        },
        ["19", "Remark 2"],
        why=HALF_ANGLE,
    )


def _signs(builder: LedgerBuilder) -> None:
    """Prove that (18) has the momentum M if S1 S2 is the sign of c3 Omega3 and S3 S4 = 1."""
    matrices = {
        **builder.result(Algebra).basis,
        "R": from_quaternion("q"),
        "M": combination("M1 M2 M3"),
    }
    found = symbol("K") * (R.I * A[0] * R)
    scope = Scope.open(builder, "signed", *FACTORS, matrices=matrices, static=True)
    # A reflected frame would have the determinant -1.
    size = scope.determinant(R)[0]
    builder.evaluate("signed.frame", [size], ["footnote 3"])

    matched = Part(relations=("S2 - side*S1", "S4 - S3"))
    scope = Scope.open(builder, "matched_signs", *FACTORS, matched, matrices=matrices, static=True)
    source = ["19", "24", "Remark 2"]
    scope.decide_matrices("matched_signs.momentum", found, M, source)
    side, why = {"S1*S2*M3": "K*sin_phi2*cos_phi3"}, "(29), where S1 S2 is the sign of Omega3"
    builder.claim("matched_signs.side", side, ["19", "Remark 2", "footnote 3"], why=why)


def _crossing(builder: LedgerBuilder) -> None:
    """Prove that at zeros of Omega3, where y* changes its sign, phi1 has to jump by pi."""
    jump = Part({"h": "F3 at the zero of Omega3, there |F4| = F3"})
    builder.open(join("crossing", *ANGLES[:2], jump, static=True))
    c, s, F1, F2 = "cos_half_phi1", "sin_half_phi1", "cos_half_phi2", "sin_half_phi2"
    before = _by_18(c, s, F1, F2, "h", "h")
    turned = _by_18(f"(-{s})", c, F1, f"-{F2}", "h", "(-h)")
    why = "(18) is the same with F2 and F4 negative and phi1 larger by pi"
    builder.claim("crossing.turned", equal(before, turned), ["19", "Remark 2"], why=why)


def _by_18(c: str, s: str, F1: str, F2: str, F3: str, F4: str) -> tuple[str, ...]:
    """Return (18) by the cosine and sine of phi1/2 and F1 to F4."""
    return (
        f"{F1}*({c}*{F3} - {s}*{F4})",
        f"{F1}*({s}*{F3} + {c}*{F4})",
        f"{F2}*({c}*{F3} + {s}*{F4})",
        f"{F2}*({s}*{F3} - {c}*{F4})",
    )


def _pull_back(builder: LedgerBuilder) -> None:
    """Prove that (37) is R_int at t = 0, so that R_int = R(0)."""
    three = {"p": "R_int", "r": "Rbar(0)"}
    quaternions = [
        Part(
            {f"{x}{k}": f"component {k} of {name}" for k in range(4)},
            relations=(f"{x}3**2 + {x}2**2 + {x}1**2 + {x}0**2 - 1",),
        )
        for x, name in three.items()
    ]
    matrices = {"R_int": from_quaternion("p"), "Rbar": from_quaternion("r")}
    scope = Scope.open(builder, "pulled_back", *quaternions, matrices=matrices, static=True)
    R_int, Rbar = map(matrix, matrices)
    start = MatMul(R_int, Adjoint(Rbar), Rbar)
    scope.decide_matrices("pulled_back.start", start, R_int, ["37", "Remark 3"])
