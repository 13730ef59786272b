"""The attitude without sign functions: a turn about the momentum, then the shortest rotation.

Axes are named by what they do: a is the axis the rates circulate about, b the middle axis, d the
third; epsilon = +1 when (a, b, d) is right-handed, -1 when not, and sigma is the sign of Omega_a.
R = exp(psi sigma A_a) S, where S is the shortest rotation that takes M/K to sigma e_a.  psi' has a
denominator that never falls below K, so nothing here has an edge: whatever the motion, and
whatever the order of the axes, this R satisfies (3).  It is the regular form of Theorem 1.
"""

from rigidsym.proof.algebra import Book, Part, half_angle, join, sign

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
    rates={"nu": "sigma*epsilon*(c_b - c_d)*Omega_b*Omega_d*nu/(2*(K + sigma*M_a))"},
    nonnegative=("K", "nu"),
    reading={"K": "|M|, kg m^2 rad/s", "nu": "length of (K + sigma M_a, M x sigma e_a)"},
)
TURN = Part(
    definitions={
        "psi_rate": "(2*H + K*sigma*Omega_a)/(K + sigma*M_a)",
        "qbar_0": "cos_half_psi*s_0",
        "qbar_a": "sigma*sin_half_psi*s_0",
        "qbar_b": "cos_half_psi*s_b - epsilon*sigma*sin_half_psi*s_d",
        "qbar_d": "cos_half_psi*s_d + epsilon*sigma*sin_half_psi*s_b",
    },
)
# (37): a constant unit quaternion in front of the particular solution.
PULL_BACK = Part(
    witness={"p_0": "1", "p_a": "0", "p_b": "0", "p_d": "0"},
    definitions={
        "q_0": "p_0*qbar_0 - p_a*qbar_a - p_b*qbar_b - p_d*qbar_d",
        "q_a": "p_0*qbar_a + p_a*qbar_0 + epsilon*(p_b*qbar_d - p_d*qbar_b)",
        "q_b": "p_0*qbar_b + p_b*qbar_0 + epsilon*(p_d*qbar_a - p_a*qbar_d)",
        "q_d": "p_0*qbar_d + p_d*qbar_0 + epsilon*(p_a*qbar_b - p_b*qbar_a)",
    },
    relations=("p_d**2 + p_b**2 + p_a**2 + p_0**2 - 1",),
    reading={f"p_{x}": f"component {x} of R(0) Rbar(0)^-1, constant" for x in "0abd"},
)
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


# (24): the momentum in the body, R^-1 (K sigma e_a).
MOMENTUM = {
    "M_a": "sigma*K*(qbar_0**2 + qbar_a**2 - qbar_b**2 - qbar_d**2)",
    "M_b": "2*sigma*K*(qbar_a*qbar_b - epsilon*qbar_0*qbar_d)",
    "M_d": "2*sigma*K*(qbar_a*qbar_d + epsilon*qbar_0*qbar_b)",
}


def kinematics(q: str) -> dict[str, str]:
    """|q| = 1 and q' = (1/2) q (0, Omega) on the axes (a, b, d) of either handedness."""
    return {
        f"{q}_0**2 + {q}_a**2 + {q}_b**2 + {q}_d**2": "1",
        f"D({q}_0)": f"(-{q}_a*Omega_a - {q}_b*Omega_b - {q}_d*Omega_d)/2",
        f"D({q}_a)": f"({q}_0*Omega_a + epsilon*({q}_b*Omega_d - {q}_d*Omega_b))/2",
        f"D({q}_b)": f"({q}_0*Omega_b + epsilon*({q}_d*Omega_a - {q}_a*Omega_d))/2",
        f"D({q}_d)": f"({q}_0*Omega_d + epsilon*({q}_a*Omega_b - {q}_b*Omega_a))/2",
    }


def derive(book: Book) -> None:
    """Invariants in the form without cancellation, the attitude, and the pull-back (37)."""
    book.open(join("attitude", *ATTITUDE))
    book.claim("attitude.conserved", {"D(H)": "0", "D(K**2)": "0"}, ["6"])
    book.root("attitude.K", "K", "M_a**2 + M_b**2 + M_d**2", ["6", "15"])
    for x in "abd":
        book.claim(f"attitude.Omega_{x}", {f"Omega_{x}": f"M_{x}/c_{x}"}, ["8"])
    book.root("attitude.nu", "nu", "2*K*(K + sigma*M_a)", ["27"])

    book.claim("attitude.p_0", {"p_0": "q_0*qbar_0 + q_a*qbar_a + q_b*qbar_b + q_d*qbar_d"}, ["37"])
    for x, y, z in ("abd", "bda", "dab"):
        form = f"q_{x}*qbar_0 - q_0*qbar_{x} + epsilon*(q_{z}*qbar_{y} - q_{y}*qbar_{z})"
        book.claim(f"attitude.p_{x}", {f"p_{x}": form}, ["37"])
    book.claim("attitude.particular", kinematics("qbar"), ["3", "23"])
    for name, form in MOMENTUM.items():
        book.claim(f"attitude.{name}_of_attitude", {name: form}, ["24"])
    book.claim("attitude.solution", kinematics("q"), ["3", "37"])
