"""The attitude without sign functions: a turn about the momentum, then the shortest rotation.

Axes are named by what they do: a is the axis the rates circulate about, b the middle axis, d the
third; epsilon = +1 when (a, b, d) is right-handed, -1 when not, and sigma is the sign of Omega_a.
R = exp(psi sigma A_a) S, where S is the shortest rotation that takes M/K to sigma e_a.  psi' has a
denominator that never falls below K, so nothing here has an edge: whatever the motion, and
whatever the order of the axes, this R satisfies (3).  It is the regular form of Theorem 1.
"""

from collections.abc import Iterable

from sympy import Expr, Symbol, factor_terms, rem

from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join, sign
from rigidsym.proof.algebra._printing import printed
from rigidsym.proof.algebra._quaternion import conjugate, product, rotated
from rigidsym.proof.algebra._quaternion import kinematics as turning

INERTIA = Part(
    witness={"c_a": "3", "c_b": "2", "c_d": "1"},
    units=("c_a", "c_b", "c_d"),
    reading={
        "c_a": "moment of inertia about the circulation axis, kg m^2",
        "c_b": "the middle moment of inertia, kg m^2",
        "c_d": "the remaining moment of inertia, kg m^2",
    },
)
HANDEDNESS = sign("epsilon", "+1 when the axes (a, b, d) are right-handed, -1 when not")
SENSE = sign("sigma", "the sign of Omega_a")
RATES = Part(
    witness={"Omega_a": "1", "Omega_b": "0", "Omega_d": "0"},
    definitions={
        "M_a": "c_a*Omega_a",
        "M_b": "c_b*Omega_b",
        "M_d": "c_d*Omega_d",
        "H": "(c_a*Omega_a**2 + c_b*Omega_b**2 + c_d*Omega_d**2)/2",
    },
    rates={
        "Omega_a": "epsilon*(c_b - c_d)/c_a*Omega_b*Omega_d",
        "Omega_b": "epsilon*(c_d - c_a)/c_b*Omega_d*Omega_a",
        "Omega_d": "epsilon*(c_a - c_b)/c_d*Omega_a*Omega_b",
    },
    reading={f"Omega_{x}": f"body rate about axis {x}, rad/s" for x in "abd"},
)
# nu is the length of the unnormalised shortest rotation (K + sigma M_a, M x sigma e_a).
SHORTEST = Part(
    witness={"K": "3", "nu": "6"},
    units=("K", "K + sigma*c_a*Omega_a", "nu"),
    definitions={
        "s_0": "nu/(2*K)",
        "s_b": "sigma*epsilon*M_d/nu",
        "s_d": "-sigma*epsilon*M_b/nu",
    },
    relations=(
        "K**2 - M_a**2 - M_b**2 - M_d**2",
        "nu**2 - 2*K*(K + sigma*M_a)",
    ),
    rates={"nu": "sigma*epsilon*(c_b - c_d)*Omega_b*Omega_d*K/nu"},
    nonnegative=("K", "nu"),
    reading={"K": "|M|, kg m^2 rad/s", "nu": "length of (K + sigma M_a, M x sigma e_a)"},
)
EPSILON = Symbol("epsilon")
# Names in the order of evaluation that numbers follow.
NAMES = "epsilon sigma K cos_half_psi sin_half_psi s_0 s_b s_d " + " ".join(
    f"{q}_{x}" for q in ("p", "q", "qbar") for x in "0abd"
)


def quaternion(name: str) -> tuple[Symbol, ...]:
    """Return the components of a quaternion on the axes (a, b, d)."""
    return tuple(Symbol(f"{name}_{x}") for x in "0abd")


def components(name: str, sides: Iterable[Expr]) -> dict[str, str]:
    """Return definitions of the components of a quaternion."""
    texts = (printed(side, NAMES) for side in sides)
    return {str(x): text for x, text in zip(quaternion(name), texts, strict=True)}


# exp(psi sigma A_a), and the shortest rotation, which is about an axis across e_a.
ABOUT_A = (Symbol("cos_half_psi"), Symbol("sigma") * Symbol("sin_half_psi"), 0, 0)
SHORTEST_TURN = (Symbol("s_0"), 0, Symbol("s_b"), Symbol("s_d"))
TURN = Part(
    definitions={
        "psi_rate": "(2*H + K*sigma*Omega_a)/(K + sigma*M_a)",
        **components("qbar", product(ABOUT_A, SHORTEST_TURN, EPSILON)),
    },
)
# (37): a constant unit quaternion in front of the particular solution.
PULL_BACK = Part(
    witness={"p_0": "1", "p_a": "0", "p_b": "0", "p_d": "0"},
    definitions=components("q", product(quaternion("p"), quaternion("qbar"), EPSILON)),
    relations=("p_d**2 + p_b**2 + p_a**2 + p_0**2 - 1",),
    reading={f"p_{x}": f"component {x} of R(0) Rbar(0)^-1, constant" for x in "0abd"},
)
# At the start psi is zero.
UNTURNED = Part(relations=("cos_half_psi - 1", "sin_half_psi"))
ATTITUDE = (
    HANDEDNESS,
    SENSE,
    INERTIA,
    RATES,
    SHORTEST,
    half_angle("psi", "psi_rate"),
    TURN,
    PULL_BACK,
)


def momentum() -> dict[str, str]:
    """Return the momentum in the body by (24), R^-1 (K sigma e_a) R, for either handedness."""
    along = Symbol("sigma") * Symbol("K")
    turned = rotated(conjugate(quaternion("qbar")), (along, 0, 0), EPSILON)
    reduced = (rem(side, EPSILON**2 - 1, EPSILON) for side in turned)
    sides = [factor_terms(side, sign=False) for side in reduced]
    return {f"M_{x}": printed(side, NAMES) for x, side in zip("abd", sides, strict=True)}


MOMENTUM = momentum()


def kinematics(q: str) -> dict[str, str | Expr]:
    """Prove |q| = 1 and q' = q (0, Omega)/2 on axes (a, b, d) of either handedness."""
    names, rates = " ".join(map(str, quaternion(q))), "Omega_a Omega_b Omega_d"
    return {
        " + ".join(f"{name}**2" for name in names.split()): "1",
        **turning(names, rates, EPSILON),
    }


def derive(builder: LedgerBuilder) -> None:
    """Prove the invariants without cancellation, the attitude, and the pull-back (37)."""
    builder.open(join("attitude", *ATTITUDE))
    builder.claim("attitude.conserved", {"D(H)": "0", "D(K**2)": "0"}, ["6"])
    builder.root("attitude.K", "K", "M_a**2 + M_b**2 + M_d**2", ["6", "15"])
    for x in "abd":
        builder.claim(f"attitude.Omega_{x}", {f"Omega_{x}": f"M_{x}/c_{x}"}, ["8"])
    builder.root("attitude.nu", "nu", "2*K*(K + sigma*M_a)", ["27"])

    inverse = product(quaternion("q"), conjugate(quaternion("qbar")), EPSILON)
    for name, form in components("p", inverse).items():
        builder.claim(f"attitude.{name}", {name: form}, ["37"])
    builder.claim("attitude.particular", kinematics("qbar"), ["3", "23"])
    for name, form in MOMENTUM.items():
        builder.claim(f"attitude.{name}_of_attitude", {name: form}, ["24"])
    builder.claim("attitude.solution", kinematics("q"), ["3", "37"])
    _start(builder, components("p", inverse))


def _start(builder: LedgerBuilder, inverse: dict[str, str]) -> None:
    """Prove that with p by (37) q starts at the given attitude, and that p is a unit quaternion."""
    units = {q: " + ".join(f"{x}**2" for x in quaternion(q)) for q in ("q", "qbar", "p")}
    given = Part(
        witness={f"{q}_{x}": str(int(x == "0")) for q in ("q", "qbar") for x in "0abd"},
        definitions=inverse,
        relations=(f"{units['q']} - 1", f"{units['qbar']} - 1"),
    )
    builder.open(join("attitude_start", HANDEDNESS, given, static=True))
    builder.claim("attitude_start.attitude", PULL_BACK.definitions, ["37"])
    builder.claim("attitude_start.turn", {units["p"]: "1"}, ["37"])
    builder.open(join("attitude_begun", *ATTITUDE, UNTURNED, static=True))
    builder.claim("attitude_begun.units", {units[q]: "1" for q in ("q", "qbar")}, ["37"])
    for name, form in inverse.items():
        builder.claim(f"attitude_begun.{name}", {name: form}, ["37"])
    premises = [f"attitude_begun.{name}" for name in ("units", *inverse)]
    builder.model("attitude_begun", "attitude_start", premises)
