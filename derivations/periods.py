"""Periods and phases: when the rates come back, and how far the attitude has turned by then.

The rates have the period T = 4 K(m)/lambda = 4 K_1/mu, dn half of it.  In half a period psi grows
by the same amount each time, so that its mean rate is, with the complete integral J_c of J,

    psi_mean = psi_0 + kappa mu J_c/K_1 = 2 Lambda.

Of the rates that about the circulation axis has a mean, the other two have none: dn is the rate of
Jacobi's amplitude over lambda, which is a whole turn more after each period.

Hence in one period, when the momentum is back where it was in the body, the attitude has turned
about it by psi_mean T.  Montgomery's formula is the integral of the last claim here: psi' is 2 H/K
less the rate at which the momentum, seen from the body, sweeps solid angle around sigma e_a.

As in the theta form, 0 < k_1 < 1: neither the separatrix nor a symmetric body.
"""

from derivations.attitude import ATTITUDE, M_a, M_b, M_d, Omega_a
from derivations.descended_form import LANDEN, MOTION
from derivations.pi_form import FACTOR, J_0, K_1, H, J, psi
from derivations.regular_form import ROTATING
from derivations.theta_edges import given
from derivations.theta_form import (
    KAPPA,
    SHIFT,
    K,
    c,
    d,
    epsilon,
    k_1,
    kappa,
    mu,
    n,
    psi_0,
    psi_rate,
    s,
    sigma,
    t,
    x,
    y,
    z,
    zeta,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, half_angle
from rigidsym.proof.algebra._computation import compute, guess
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import expressions, symbols, unfold

J_c, J_later, s_later, c_later, d_later = symbols("J_c J_later s_later c_later d_later")
quarter, period, psi_mean, psi_later = symbols("quarter period psi_mean psi_later")
am, am_later, turn, Omega_mean = symbols("am am_later turn Omega_mean")
sn, cn, dn, sn_later, cn_later, dn_later = symbols("sn cn dn sn_later cn_later dn_later")
A_a, A_b, A_d, chi, tau, lambda_ = symbols("A_a A_b A_d chi tau lambda_")
swept_rate, across = symbols("swept_rate across")

# What is meant by half a period later: 2 K_1 is where s is 0 again, and 2 J_c is J there.  The
# addition theorems (DLMF 22.8(i)) with S, C, D for sn, cn, dn of it.
S, C, D = symbols("S C D")
HALF = {S: 0, C: -1, D: 1}
BELOW = 1 - k_1**2 * s**2 * S**2
LATER = Part(
    definitions={
        s_later: compute((s * C * D + S * c * d) / BELOW).subs(HALF),
        c_later: compute((c * C - s * S * d * D) / BELOW).subs(HALF),
        d_later: compute((d * D - k_1**2 * s * S * c * C) / BELOW).subs(HALF),
        J_later: J + compute(J_later - J).subs({J: 0, J_later: 2 * J_c}),  # it is constant
    },
)
AFTER = {s: s_later, c: c_later, d: d_later}
JACOBI = {name: side.subs(AFTER) for name, side in expressions(LANDEN.definitions).items()}
PSI = psi_0 * t + kappa * (J - J_0)
PSI_LATER = compute(PSI).subs({t: t + period / 2, J: J_later})
# s is as before after 4 K_1.
PERIOD = compute(mu * period - 4 * K_1).solve_for(period)
GAIN = (PSI_LATER - PSI).subs(J_later, J + 2 * J_c) / (period / 2)
PSI_MEAN = GAIN.expand().subs(period, PERIOD)
# dn is the rate of Jacobi's amplitude.
OMEGA_MEAN = compute(sigma * A_a / lambda_ * (am_later - am) / period).subs(am_later, am + turn)
COMPLETE = Part(
    {K_1: "elliptic_k(1 - m_c)", J_c: "(elliptic_pi(n, 1 - m_c) - K_1)/n"},
    units=(K_1, k_1),
    definitions={
        quarter: (1 + k_1) * K_1,
        period: PERIOD,
        psi_mean: PSI_MEAN.ordered("psi_0 kappa mu J_c K_1"),
        sn_later: JACOBI[sn],
        cn_later: JACOBI[cn],
        dn_later: JACOBI[dn],
        psi_later: PSI_LATER,
    },
    reading={"quarter": "elliptic_k(m)"},
)
# It grows by a whole turn in a period.
AMPLITUDE = Part(
    {am: "jacobi_am(u, m)", turn: "2*pi"},
    units=(lambda_,),
    definitions={
        am_later: am + turn,
        Omega_mean: OMEGA_MEAN.ordered("sigma A_a turn lambda_ period"),
    },
    rates={am: lambda_ * dn},
)
# The functions at u_1 + 2 K_1; it starts where u_1 is 0.
FUNCTIONS = Part(
    (s_later, c_later, d_later, J_later),
    units=(1 + k_1 * s_later**2, 1 - n * s_later**2),
    rates={
        s_later: mu * c_later * d_later,
        c_later: -mu * s_later * d_later,
        d_later: -mu * k_1**2 * s_later * c_later,
        J_later: mu * FACTOR.subs(s, s_later),
    },
    start=(s, c - 1, d - 1, J, s_later, c_later + 1, d_later - 1, J_later - 2 * J_c),
    reading={
        **{f"{x}_later": f"jacobi_{x}n(u_1 + 2*K_1, 1 - m_c)" for x in "scd"},
        "J_later": "elliptic_j(u_1 + 2*K_1, n, 1 - m_c)",
    },
)
INTERCHANGE = zeta * K_1 / (k_1**2 * x * y * z)
REFERENCE = "Legendre's reduction; Byrd and Friedman 1971, formulas from 400 on"
# Both circulations, moduli small and near one, momenta near the circulation axis and far from it.
POINTS = [
    {"k_1": k_1, "K": K, "B_a": B_a, "B_d": B_d, "rho": rho, "phase": u_1, "Delta": "1", "t": "0"}
    for k_1, u_1 in (("1/100", "1/3"), ("2/5", "-7/5"), ("9/10", "2"))
    for (K, B_a, B_d), rho in ((("5", "3", "4"), "1"), (("25", "24", "7"), "-1"))
]


def derive(builder: LedgerBuilder) -> None:
    """Prove the periods of rates and psi, its mean rate, and the solid angle."""
    motion = (*MOTION, half_angle("psi", "psi_rate"), COMPLETE)
    here = Proofs.open(builder, "period", *motion, AMPLITUDE, LATER)
    here.model("descended")
    here.carry("descended", "solution")
    duration = PERIOD.subs(mu, lambda_ / (1 + k_1)).subs(K_1, quarter / (1 + k_1))
    here.claim("duration", {period: duration}, 10)
    # With s, c and d of before, these are sn, cn and dn of before but for signs, and so the rates.
    known = [
        {side: name for name, side in expressions(part.definitions).items()}
        for part in (LANDEN, ROTATING)
    ]
    rates = {
        side: unfold(side, COMPLETE, LATER).subs(known[0]).subs(known[1])
        for side in (sigma * A_a * dn_later, chi * A_b * sn_later, chi * tau * A_d * cn_later)
    }
    here.claim("rates", rates, 10)
    gain = (OMEGA_MEAN * period).subs(OMEGA_MEAN, Omega_mean)
    scale = sigma * A_a / lambda_
    slope = (scale * compute(am)).diff(am) * lambda_ * dn
    mean = {
        scale * rate_of(am): slope.subs(sigma * A_a * dn, Omega_a),
        scale * (am_later - am): gain,
    }
    here.claim("mean", mean, 10)
    grown = PSI_MEAN * period / 2
    here.claim("psi", {psi_later - psi: grown}, 33, 34)
    _functions(builder, (*motion, SHIFT, AMPLITUDE))
    _mean_rate(builder, (*motion, SHIFT))
    _solid_angle(builder)


def _functions(builder: LedgerBuilder, motion: tuple[Part, ...]) -> None:
    """Prove the functions half a period later."""
    here = Proofs.open(builder, "period_functions", *motion, FUNCTIONS)
    here.start("later", LATER.definitions, "DLMF 22.4(iii)")
    here.model("period", "later")
    here.carry("period", *("duration", "rates", "psi"))


def _mean_rate(builder: LedgerBuilder, motion: tuple[Part, ...]) -> None:
    """Prove that 2 Lambda is the mean rate, by the interchange of argument and parameter."""
    interchange = guess("zeta*K_1/(k_1**2*x*y*z)", "Legendre's interchange, which is cited")
    builder.assume("period_functions.complete", {J_c: interchange}, REFERENCE, POINTS)
    complete = Part(definitions={J_c: interchange})
    here = Proofs.open(
        builder, "mean_rate", *given(motion, complete.definitions, ()), complete, LATER
    )
    mean = PSI_MEAN.subs(kappa, KAPPA).subs(J_c, INTERCHANGE)
    here.claim("Lambda", {psi_mean: mean}, 34)


def _solid_angle(builder: LedgerBuilder) -> None:
    """Prove psi' = 2 H/K - (1 - cos(theta)) phi' for the momentum's polar angles.

    cos(theta) = sigma M_a/K, and (M_b^2 + M_d^2) phi' = +-(M_b M_d' - M_d M_b').
    """
    turned = sigma * epsilon * (M_b * rate_of(M_d) - M_d * rate_of(M_b))
    swept = turned / (K * (K + sigma * M_a))
    here = Proofs.open(builder, "solid_angle", *ATTITUDE, Part(definitions={swept_rate: swept}))
    # M_b^2 + M_d^2 is K^2 - M_a^2.
    along = sigma * M_a
    circle = (compute(swept).subs(along, across) * (K**2 - across**2)).cancel().factor()
    sweep = {swept_rate * (M_b**2 + M_d**2): circle.subs(across, along)}
    here.claim("swept", sweep, 27)
    gap = psi_rate + swept_rate - 2 * H / K
    here.evaluate("rate", [gap], 32, 33)
