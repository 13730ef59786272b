"""The form for numbers: Landen's descent, after which no difference loses digits.

With k' = sqrt(1 - m) and k_1 = (1 - k')/(1 + k'), sn, cn and dn of (u | m) are rational in s, c, d
of (u_1 | k_1^2), u = (1 + k_1) u_1 (DLMF 22.7(i)).  In the new functions psi' of the attitude is
psi_0 and a multiple of s^2/(1 - n s^2), so that

    psi = psi_0 t + kappa (J(u_1, n | k_1^2) - J_0),      n = -k_1 (K - c_a A_a)/(K + c_a A_a),

J being the integral of sn^2/(1 - n sn^2) (Fukushima 2012) with -1 < n <= 0: all terms have one
sign, and the limits (separatrix k_1 = 1, symmetric body k_1 = 0) are regular points.  This context
is a model of the regular form and of the attitude at once, so whatever was proved there holds here.
"""

from typing import Any

from sympy import Expr, Function, Mul, UnevaluatedExpr, factor
from sympy.integrals.manualintegrate import manualintegrate

from derivations.attitude import MOMENTUM as MOMENTUM_OF
from derivations.attitude import PSI_RATE, PULL_BACK, SHORTEST, TURN, K, M_a, nu, sigma
from derivations.regular_form import (
    AMPLITUDES,
    ANSATZ,
    BODY,
    INVARIANTS,
    RELATION,
    ROTATING,
    A_a,
    A_d,
    B_a,
    B_b,
    B_d,
    Delta,
    c_a,
    c_d,
    cn,
    dn,
    i_a,
    lambda_,
    m,
    m_1,
    named,
    rho,
    sn,
    u,
    unsigned,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle, jacobi
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbols

k_c, k_1, m_c, C_b, mu, u_1, t, phase, w = symbols("k_c k_1 m_c C_b mu u_1 t phase w")
s, c, d, n, psi, psi_0, kappa, J, J_0 = symbols("s c d n psi psi_0 kappa J J_0")
K_SQUARED = B_a**2 + B_d**2
# k' is k_c: m = 1 - k'^2, and k_1 is what Landen makes of it.
DESCENDED = (1 - k_c) / (1 + k_c)
COMPLEMENT = compute(k_1 - DESCENDED).solve_for(k_c).together()
MODULUS = (1 - COMPLEMENT**2).factor()
BELOW = 1 + k_1 * s**2
SN = (1 + k_1) * s / BELOW


def root(square: Expr) -> Expr:
    """Return the square root that is 1 at s = 0."""
    found = Mul(*(base ** (power / 2) for base, power in factor(square).as_powers_dict().items()))
    return found / found.subs(s, 0)


def by_k_c(expression: Any) -> Computation:
    """Put in the complementary modulus for k_1, which leaves no difference."""
    return compute(expression).subs(k_1, DESCENDED).factor()


CN = ((1 - compute(sn**2).subs(sn, SN)) / ((1 - s**2) * (1 - k_1**2 * s**2))).apply(root) * c * d
DN = compute(1 - m * sn**2).subs(m, MODULUS).subs(sn, SN).apply(root)
DN = (DN * BELOW).cancel() / BELOW
# psi' as a fraction in s^2: a constant, and kappa mu s^2/(1 - n s^2).
RATE = unsigned(PSI_RATE.subs(ANSATZ).subs(M_a, sigma * B_a * dn)).subs(dn, DN)
PSI_0 = RATE.subs(s, 0).factor()
REST = ((RATE - PSI_0) / s**2).factor()
N = ((1 - REST.subs(s, 0) / REST) / s**2).cancel().factor()
KAPPA = (REST.subs(s, 0) / mu).factor()
SLOPE = mu * s**2 / (1 - n * s**2)
FUNCTION: Any = Function("J")
J_OF_T = FUNCTION(t)
PSI = (psi_0 + kappa * compute(SLOPE).subs(SLOPE, J_OF_T.diff(t))).apply(manualintegrate, t)
# B by the amplitudes of the rates.
BY_RATES = {B_a: c_a * A_a, B_d: UnevaluatedExpr(c_d * A_d)}
MU = compute((1 + k_1) * mu - lambda_).solve_for(mu)
U_1 = compute(mu * t + phase)

POLHODE = (RELATION.subs({m: MODULUS, B_b: C_b / (1 + k_1)}) * (1 + k_1) ** 2).factor().expand()
INSIDE = C_b**2 - POLHODE
DESCENT = Part(
    {"k_1": "modulus after one descent", "C_b": "(1 + k_1) B_b"},
    units=(1 + k_1, C_b, INSIDE, i_a * INSIDE + rho * Delta * (1 + k_1) ** 2 * B_d**2),
    relations=("C_b**2 - (1 + k_1)**2*B_d**2 - 4*k_1*B_a**2",),  # POLHODE, factored
    definitions={m: MODULUS, B_b: C_b / (1 + k_1), k_c: COMPLEMENT, m_c: 1 - k_1**2},
    nonnegative=(B_b, k_c, K, nu),
    reading={
        "k_c": "complementary modulus k' of (u | m)",
        "m_c": "complementary parameter of (u_1 | k_1^2)",
    },
)
ARGUMENT = Part(
    {"t": "time, s", "phase": "u_1 at t = 0"},
    definitions={mu: MU, u_1: U_1, u: (1 + k_1) * u_1},
    rates={"t": "1"},
    reading={"u": "jacobi_argument(sn, cn, dn)"},
)
LANDEN = Part(
    units=(BELOW,),
    reading={f"{x}": f"jacobi_{x}n(u_1, 1 - m_c)" for x in "scd"},
    definitions={sn: SN, cn: CN, dn: DN},
)
# w is nu (1 + k_1 s^2), whose square is a polynomial.
TILTED = K * BELOW + B_a * (1 - k_1 * s**2)
MOMENTUM = Part(
    ("K", "w"),
    units=(K, w, K + B_a, TILTED),
    relations=("K**2 - B_a**2 - B_d**2", w**2 - 2 * K * TILTED * BELOW),
    definitions={nu: w / BELOW, **SHORTEST.definitions},
    rates={
        "w": "w*k_1*s*mu*c*d*((K - B_a)/(K*(1 + k_1*s**2) + B_a*(1 - k_1*s**2)) + 1/(1 + k_1*s**2))"
    },
    reading={**SHORTEST.reading, "w": "nu (1 + k_1 s^2)"},
)
SECULAR = Part(
    {"J": "elliptic_j(u_1, n, 1 - m_c)", "J_0": "elliptic_j(phase, n, 1 - m_c)"},
    definitions={
        n: N,
        psi_0: PSI_0,
        kappa: named(KAPPA.subs(B_a, c_a * A_a)),
        psi: PSI.subs(J_OF_T, J - J_0).ordered("psi_0 t kappa"),
    },
    rates={J: SLOPE},
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
    here = Proofs.open(builder, "descended", *MOTION, half_angle("psi", "psi_rate"))
    for claims in (_descent, _argument, _secular):
        claims(here)
    here.model("regular")
    here.model("attitude")
    builder.carry("descended", ["regular.euler", "attitude.solution"])
    here.carry("attitude", *(f"{name}_of_attitude" for name in MOMENTUM_OF))
    start = here.begin(
        ("t", "J - J_0", "cos_half_psi - 1", "sin_half_psi"), "", (u_1, psi), 20, 21, 33, 34
    )
    start.model("rates_start")
    start.model("attitude_begun")


def _descent(here: Proofs) -> None:
    """Prove the modulus, its complement and Landen's dn, all without differences."""
    complement = compute(1 - m_1 - m).solve_for(m)
    here.root(k_c, (1 - complement).expand(), "DLMF 22.7.1")
    above = compute((1 - k_c) * (1 + k_c)).expand().subs(k_c**2, 1 - m)
    here.formulas({k_1: above / (1 + k_c) ** 2}, "DLMF 22.7.1")
    here.formulas({m_c: by_k_c(1 - k_1**2)}, "DLMF 22.7.1")
    # 1 - k_1 s^2 is c^2 + (1 - k_1) s^2
    grown = c**2 + by_k_c((DN * BELOW).cancel().expand().coeff(s, 2) + 1).held() * s**2
    here.formulas({dn: (grown / BELOW).ordered("c s")}, "DLMF 22.7.4")


def _argument(here: Proofs) -> None:
    """Prove u_1 and its rate."""
    here.formulas({mu: by_k_c(MU)}, "DLMF 22.7.2")
    argument = compute(u - (1 + k_1) * u_1).solve_for(u_1)
    here.claim("u_1_of_u", {u_1: by_k_c(argument)}, "DLMF 22.7.2")
    start = (u_1 - U_1).solve_for(phase).ordered("mu t")
    here.formulas({phase: start}, 20, 21)
    here.claim("u_1_is_the_argument", {rate_of(u_1): U_1.diff(t)}, 20, 21)


def _secular(here: Proofs) -> None:
    """Prove that the derivative of psi is psi_rate of the attitude."""
    # K^2 - B_a^2 is B_d^2
    above = (N * (K + B_a) ** 2).cancel().expand().subs(K**2, K_SQUARED).expand()
    here.formulas({n: (above / (K + B_a) ** 2).subs(BY_RATES)}, 34)
    here.formulas({psi_0: PSI_0.subs(BY_RATES)}, 33, 34)
    step = named(KAPPA.subs(BY_RATES)).ordered("E_a c_a A_a k_1")
    here.formulas({kappa: step}, 34)
    here.claim("psi_is_the_angle", {rate_of(psi): PSI_RATE}, 33, 34)
