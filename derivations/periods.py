"""Periods and phases: when the rates come back, and how far the attitude has turned by then.

The rates have the period T = 4 K(m)/lambda = 4 K_1/mu, dn half of it.  In half a period psi grows
by the same amount each time, so that its mean rate is, with the complete integral J_c of J,

    psi_mean = psi_0 + kappa mu J_c/K_1 = 2 Lambda.

Hence in one period, when the momentum is back where it was in the body, the attitude has turned
about it by psi_mean T.  Montgomery's formula is the integral of the last claim here: psi' is 2 H/K
less the rate at which the momentum, seen from the body, sweeps solid angle around sigma e_a.

As in the theta form, 0 < k_1 < 1: neither the separatrix nor a symmetric body.
"""

from derivations.attitude import ATTITUDE
from derivations.descended_form import MOTION
from derivations.theta_form import POINTS, SHIFT
from rigidsym.proof.algebra import Book, Part, half_angle, join

# What half a period later means; K_1 and J_c are complete integrals, quarter is K(m).
LATER = Part(
    definitions={
        "J_c": "zeta*K_1/(k_1**2*x*y*z)",
        "s_later": "-s",
        "c_later": "-c",
        "d_later": "d",
        "J_later": "J + 2*J_c",
        "quarter": "(1 + k_1)*K_1",
    },
)
COMPLETE = Part(
    witness={"K_1": "1"},
    units=("K_1", "k_1"),
    definitions={
        "period": "4*K_1/mu",
        "psi_mean": "psi_0 + kappa*mu*J_c/K_1",
        "sn_later": "(1 + k_1)*s_later/(1 + k_1*s_later**2)",
        "cn_later": "c_later*d_later/(1 + k_1*s_later**2)",
        "dn_later": "(1 - k_1*s_later**2)/(1 + k_1*s_later**2)",
        "psi_later": "psi_0*(t + period/2) + kappa*(J_later - J_0)",
    },
    reading={
        "K_1": "elliptic_k(1 - m_c)",
    },
)
FREE = Part(
    witness={**dict.fromkeys(LATER.definitions, "0"), "d_later": "1"},
    units=("1 + k_1*s_later**2",),
    rates=dict.fromkeys(("s_later", "c_later", "d_later", "J_later"), "?"),
    reading={
        **{f"{x}_later": f"jacobi_{x}n(u_1 + 2*K_1, 1 - m_c)" for x in "scd"},
        "J_later": "elliptic_j(u_1 + 2*K_1, n, 1 - m_c)",
        "J_c": "(elliptic_pi(n, 1 - m_c) - K_1)/n",
        "quarter": "elliptic_k(m)",
    },
)
ASSUMED = (
    ("half_period", ("s_later", "c_later", "d_later"), "DLMF 22.4(iii)"),
    ("integral", ("J_later",), "DLMF 19.2.7, whose integrand has the period pi"),
    ("descent", ("quarter",), "DLMF 19.8.12"),
    ("complete", ("J_c",), "Legendre's reduction; Byrd and Friedman 1971, formulas from 400 on"),
)


def derive(book: Book) -> None:
    """The rates, psi and its mean; then the same for the functions; then the solid angle."""
    motion = (*MOTION, half_angle("psi", "psi_rate"), SHIFT, COMPLETE)
    book.open(join("period", *motion, LATER))
    book.claim("period.duration", {"period": "4*quarter/lambda_"}, ["10"])
    rates = {
        "sigma*A_a*dn_later": "Omega_a",
        "chi*A_b*sn_later": "-Omega_b",
        "chi*tau*A_d*cn_later": "-Omega_d",
    }
    book.claim("period.rates", rates, ["10"])
    book.claim("period.psi", {"psi_later - psi": "psi_mean*period/2"}, ["33", "34"])
    book.claim("period.Lambda", {"psi_mean": "2*Lambda"}, ["34"])
    book.open(join("period_functions", *motion, FREE))
    for name, quantities, reference in ASSUMED:
        equations = {quantity: LATER.definitions[quantity] for quantity in quantities}
        book.assume(f"period_functions.{name}", equations, reference, POINTS)
    assumed = [f"period_functions.{name}" for name, *_ in ASSUMED]
    book.model("period_functions", "period", assumed)
    book.carry("period_functions", [f"period.{name}" for name in ("duration", "rates", "psi")])
    book.carry("period_functions", ["period.Lambda"])
    _solid_angle(book)


def _solid_angle(book: Book) -> None:
    """psi' = 2 H/K - (1 - cos(theta)) phi', theta and phi being the momentum's polar angles.

    cos(theta) = sigma M_a/K, and (M_b^2 + M_d^2) phi' = +-(M_b M_d' - M_d M_b').
    """
    sweep = Part(
        definitions={
            "swept_rate": "sigma*epsilon*(M_b*D(M_d) - M_d*D(M_b))/(K*(K + sigma*M_a))",
        }
    )
    book.open(join("solid_angle", *ATTITUDE, sweep))
    book.claim(
        "solid_angle.swept",
        {
            "swept_rate*(M_b**2 + M_d**2)": "sigma*epsilon*(M_b*D(M_d) - M_d*D(M_b))"
            "*(1 - sigma*M_a/K)"
        },
        ["27"],
    )
    book.claim("solid_angle.rate", {"psi_rate": "2*H/K - swept_rate"}, ["32", "33"])
