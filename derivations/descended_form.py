"""The form for numbers: Landen's descent, after which no difference loses digits.

With k' = sqrt(1 - m) and k_1 = (1 - k')/(1 + k'), sn, cn and dn of (u | m) are rational in s, c, d
of (u_1 | k_1^2), u = (1 + k_1) u_1 (DLMF 22.7(i)).  In the new functions psi of the attitude is

    psi = psi_0 t + kappa (J(u_1, n | k_1^2) - J_0),      n = -k_1 (K - c_a A_a)/(K + c_a A_a),

J being the integral of sn^2/(1 - n sn^2) (Fukushima 2012) with -1 < n <= 0: all terms have one
sign, and the limits (separatrix k_1 = 1, symmetric body k_1 = 0) are regular points.  This context
is a model of the regular form and of the attitude at once, so whatever was proved there holds here.
"""

from derivations.attitude import MOMENTUM as MOMENTUM_OF
from derivations.attitude import PULL_BACK, SHORTEST, TURN
from derivations.regular_form import AMPLITUDES, BODY, INVARIANTS, ROTATING
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, jacobi, join

DESCENT = Part(
    witness={"k_1": "1", "C_b": "50"},
    units=(
        "1 + k_1",
        "C_b",
        "(1 + k_1)**2*B_d**2 + 4*k_1*B_a**2",
        "i_a*((1 + k_1)**2*B_d**2 + 4*k_1*B_a**2) + rho*Delta*(1 + k_1)**2*B_d**2",
    ),
    relations=("C_b**2 - (1 + k_1)**2*B_d**2 - 4*k_1*B_a**2",),
    definitions={
        "m": "4*k_1/(1 + k_1)**2",
        "B_b": "C_b/(1 + k_1)",
        "k_c": "(1 - k_1)/(1 + k_1)",
        "m_c": "1 - k_1**2",
    },
    nonnegative=("B_b", "k_c", "K", "nu"),
    reading={
        "k_1": "modulus after one descent",
        "C_b": "(1 + k_1) B_b",
        "k_c": "complementary modulus k' of (u | m)",
        "m_c": "complementary parameter of (u_1 | k_1^2)",
    },
)
ARGUMENT = Part(
    witness={"t": "0", "phase": "0"},
    definitions={"mu": "lambda_/(1 + k_1)", "u_1": "mu*t + phase", "u": "(1 + k_1)*u_1"},
    rates={"t": "1"},
    reading={
        "t": "time, s",
        "phase": "u_1 at t = 0",
        "u": "jacobi_argument(sn, cn, dn)",
    },
)
LANDEN = Part(
    units=("1 + k_1*s**2",),
    reading={f"{x}": f"jacobi_{x}n(u_1, 1 - m_c)" for x in "scd"},
    definitions={
        "sn": "(1 + k_1)*s/(1 + k_1*s**2)",
        "cn": "c*d/(1 + k_1*s**2)",
        "dn": "(1 - k_1*s**2)/(1 + k_1*s**2)",
    },
)
# w is nu (1 + k_1 s^2), whose square is a polynomial.
MOMENTUM = Part(
    witness={"K": "25", "w": "40"},
    units=("K", "w", "K + B_a", "K*(1 + k_1*s**2) + B_a*(1 - k_1*s**2)"),
    relations=(
        "K**2 - B_a**2 - B_d**2",
        "w**2 - 2*K*(K*(1 + k_1*s**2) + B_a*(1 - k_1*s**2))*(1 + k_1*s**2)",
    ),
    definitions={"nu": "w/(1 + k_1*s**2)"} | dict(SHORTEST.definitions),
    rates={
        "w": "w*k_1*s*mu*c*d*((K - B_a)/(K*(1 + k_1*s**2) + B_a*(1 - k_1*s**2)) + 1/(1 + k_1*s**2))"
    },
    reading={**SHORTEST.reading, "w": "nu (1 + k_1 s^2)"},
)
SECULAR = Part(
    witness={"J": "0", "J_0": "0"},
    definitions={
        "n": "-k_1*(K - B_a)/(K + B_a)",
        "psi_0": "(2*H + K*A_a)/(K + B_a)",
        "kappa": "2*E_a*A_a*k_1/((K + B_a)**2*mu)",
        "psi": "psi_0*t + kappa*(J - J_0)",
    },
    rates={"J": "mu*s**2/(1 - n*s**2)"},
    reading={
        "J": "elliptic_j(u_1, n, 1 - m_c)",
        "J_0": "elliptic_j(phase, n, 1 - m_c)",
    },
)
MOTION = (
    *BODY,
    DESCENT,
    AMPLITUDES,
    ARGUMENT,
    jacobi("s", "c", "d", "u_1", "k_1**2", "mu"),
    LANDEN,
    ROTATING,
    INVARIANTS,
    MOMENTUM,
    SECULAR,
    TURN,
    PULL_BACK,
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the descent is a model of the regular form; then each stable formula."""
    builder.open(join("descended", *MOTION, half_angle("psi", "psi_rate")))
    for claim in (_descent, _argument, _secular):
        claim(builder)
    builder.model("descended", "regular")
    builder.model("descended", "attitude")
    builder.carry("descended", ["regular.euler", "attitude.solution"])
    builder.carry("descended", [f"attitude.{name}_of_attitude" for name in MOMENTUM_OF])
    start = ("t", "J - J_0", "cos_half_psi - 1", "sin_half_psi")
    builder.begin("descended", start, "", {"u_1": "phase", "psi": "0"}, "20", "21", "33", "34")
    builder.model("descended_start", "rates_start")
    builder.model("descended_start", "attitude_begun")


def _descent(builder: LedgerBuilder) -> None:
    """Prove the modulus, its complement and Landen's dn, all without differences."""
    builder.root("descended.k_c", "k_c", "m_1", ["DLMF 22.7.1"])
    builder.claim("descended.k_1", {"k_1": "m/(1 + k_c)**2"}, ["DLMF 22.7.1"])
    builder.claim("descended.m_c", {"m_c": "4*k_c/(1 + k_c)**2"}, ["DLMF 22.7.1"])
    builder.claim(
        "descended.dn", {"dn": "(c**2 + 2*k_c/(1 + k_c)*s**2)/(1 + k_1*s**2)"}, ["DLMF 22.7.4"]
    )


def _argument(builder: LedgerBuilder) -> None:
    """Prove u_1 and its rate."""
    builder.claim("descended.mu", {"mu": "lambda_*(1 + k_c)/2"}, ["DLMF 22.7.2"])
    builder.claim("descended.u_1_of_u", {"u_1": "u*(1 + k_c)/2"}, ["DLMF 22.7.2"])
    builder.claim("descended.phase", {"phase": "u_1 - mu*t"}, ["20", "21"])
    builder.claim("descended.u_1_is_the_argument", {"D(u_1)": "mu"}, ["20", "21"])


def _secular(builder: LedgerBuilder) -> None:
    """Prove that the derivative of psi is psi_rate of the attitude."""
    builder.claim("descended.n", {"n": "-k_1*(c_d*A_d)**2/(K + c_a*A_a)**2"}, ["34"])
    builder.claim("descended.psi_0", {"psi_0": "(2*H + K*A_a)/(K + c_a*A_a)"}, ["33", "34"])
    builder.claim("descended.kappa", {"kappa": "2*E_a*A_a*k_1/((K + c_a*A_a)**2*mu)"}, ["34"])
    builder.claim("descended.psi_is_the_angle", {"D(psi)": "psi_rate"}, ["33", "34"])
