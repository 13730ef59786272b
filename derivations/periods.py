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

from derivations.attitude import ATTITUDE
from derivations.descended_form import MOTION
from derivations.theta_edges import given
from derivations.theta_form import SHIFT
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join

# What is meant by half a period later: 2 K_1 is where s is 0 again, and 2 J_c is J there.
LATER = Part(
    definitions={"s_later": "-s", "c_later": "-c", "d_later": "d", "J_later": "J + 2*J_c"},
)
COMPLETE = Part(
    witness={"K_1": "1", "J_c": "0"},
    units=("K_1", "k_1"),
    definitions={
        "quarter": "(1 + k_1)*K_1",
        "period": "4*K_1/mu",
        "psi_mean": "psi_0 + kappa*mu*J_c/K_1",
        "sn_later": "(1 + k_1)*s_later/(1 + k_1*s_later**2)",
        "cn_later": "c_later*d_later/(1 + k_1*s_later**2)",
        "dn_later": "(1 - k_1*s_later**2)/(1 + k_1*s_later**2)",
        "psi_later": "psi_0*(t + period/2) + kappa*(J_later - J_0)",
    },
    reading={
        "K_1": "elliptic_k(1 - m_c)",
        "J_c": "(elliptic_pi(n, 1 - m_c) - K_1)/n",
        "quarter": "elliptic_k(m)",
    },
)
# dn is the rate of Jacobi's amplitude, which grows by a whole turn in a period.
AMPLITUDE = Part(
    witness={"am": "0", "turn": "6"},
    units=("lambda_",),
    definitions={
        "am_later": "am + turn",
        "Omega_mean": "sigma*A_a*turn/(lambda_*period)",
    },
    rates={"am": "lambda_*dn"},
    reading={"am": "jacobi_am(u, m)", "turn": "2*pi"},
)
# The functions at u_1 + 2 K_1; it starts where u_1 is 0.
FUNCTIONS = Part(
    witness={"s_later": "0", "c_later": "-1", "d_later": "1", "J_later": "0"},
    units=("1 + k_1*s_later**2", "1 - n*s_later**2"),
    rates={
        "s_later": "mu*c_later*d_later",
        "c_later": "-mu*s_later*d_later",
        "d_later": "-mu*k_1**2*s_later*c_later",
        "J_later": "mu*s_later**2/(1 - n*s_later**2)",
    },
    start=("s", "c - 1", "d - 1", "J", "s_later", "c_later + 1", "d_later - 1", "J_later - 2*J_c"),
    reading={
        **{f"{x}_later": f"jacobi_{x}n(u_1 + 2*K_1, 1 - m_c)" for x in "scd"},
        "J_later": "elliptic_j(u_1 + 2*K_1, n, 1 - m_c)",
    },
)
INTERCHANGE = "zeta*K_1/(k_1**2*x*y*z)"
# Both circulations, moduli small and near one, momenta near the circulation axis and far from it.
POINTS = [
    {"k_1": k_1, "K": K, "B_a": B_a, "B_d": B_d, "rho": rho, "phase": u_1, "Delta": "1", "t": "0"}
    for k_1, u_1 in (("1/100", "1/3"), ("2/5", "-7/5"), ("9/10", "2"))
    for (K, B_a, B_d), rho in ((("5", "3", "4"), "1"), (("25", "24", "7"), "-1"))
]


def derive(builder: LedgerBuilder) -> None:
    """Prove the periods of rates and psi, its mean rate, and the solid angle."""
    motion = (*MOTION, half_angle("psi", "psi_rate"), COMPLETE)
    builder.open(join("period", *motion, AMPLITUDE, LATER))
    builder.model("period", "descended")
    builder.carry("period", ["descended.solution"])
    builder.claim("period.duration", {"period": "4*quarter/lambda_"}, ["10"])
    rates = {
        "sigma*A_a*dn_later": "Omega_a",
        "chi*A_b*sn_later": "-Omega_b",
        "chi*tau*A_d*cn_later": "-Omega_d",
    }
    builder.claim("period.rates", rates, ["10"])
    mean = {
        "sigma*A_a/lambda_*D(am)": "Omega_a",
        "sigma*A_a/lambda_*(am_later - am)": "Omega_mean*period",
    }
    builder.claim("period.mean", mean, ["10"])
    builder.claim("period.psi", {"psi_later - psi": "psi_mean*period/2"}, ["33", "34"])
    _functions(builder, (*motion, SHIFT, AMPLITUDE))
    _mean_rate(builder, (*motion, SHIFT))
    _solid_angle(builder)


def _functions(builder: LedgerBuilder, motion: tuple[Part, ...]) -> None:
    """Prove the functions half a period later."""
    builder.open(join("period_functions", *motion, FUNCTIONS))
    builder.start("period_functions.later", LATER.definitions, ["DLMF 22.4(iii)"])
    builder.model("period_functions", "period", ["period_functions.later"])
    builder.carry("period_functions", [f"period.{name}" for name in ("duration", "rates", "psi")])


def _mean_rate(builder: LedgerBuilder, motion: tuple[Part, ...]) -> None:
    """Prove that 2 Lambda is the mean rate, by the interchange of argument and parameter."""
    reference = "Legendre's reduction; Byrd and Friedman 1971, formulas from 400 on"
    builder.assume("period_functions.complete", {"J_c": INTERCHANGE}, reference, POINTS)
    complete = Part(definitions={"J_c": INTERCHANGE})
    builder.open(join("mean_rate", *given(motion, complete.definitions, ()), complete, LATER))
    builder.claim("mean_rate.Lambda", {"psi_mean": "2*Lambda"}, ["34"])


def _solid_angle(builder: LedgerBuilder) -> None:
    """Prove psi' = 2 H/K - (1 - cos(theta)) phi' for the momentum's polar angles.

    cos(theta) = sigma M_a/K, and (M_b^2 + M_d^2) phi' = +-(M_b M_d' - M_d M_b').
    """
    sweep = Part(
        definitions={
            "swept_rate": "sigma*epsilon*(M_b*D(M_d) - M_d*D(M_b))/(K*(K + sigma*M_a))",
        }
    )
    builder.open(join("solid_angle", *ATTITUDE, sweep))
    builder.claim(
        "solid_angle.swept",
        {
            "swept_rate*(M_b**2 + M_d**2)": "sigma*epsilon*(M_b*D(M_d) - M_d*D(M_b))"
            "*(1 - sigma*M_a/K)"
        },
        ["27"],
    )
    builder.claim("solid_angle.rate", {"psi_rate": "2*H/K - swept_rate"}, ["32", "33"])
