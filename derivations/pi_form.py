"""The Pi form: psi/2 as a rate times time and a periodic rest, with one integral of the third kind.

J of the descended form grows without end.  Its mean slope j = J_c/K_1 goes into the rate,

    psi/2 = Lambda t + rest - rest_0,    Lambda = (psi_0 + kappa mu j)/2

and rest = kappa (J - j u_1)/2 has the period 2 K_1 (period_functions.later), so that a state needs
J for |u_1| <= K_1.  That is for moduli that are not near one.

On the separatrix K_1 is infinite, and near it the rest is a small difference.  So psi/2 is measured
from what it is on the saddle, H t/K: with x, y, z of the theta form

    psi/2 = (H/K) t - rho (arctan(k_1^2 (x y/z) s c/d) + g_1 u_1 + g_2 L) + constant        (near)
    psi/2 = (H/K) t + rho (g_1 v + h_2 L(v)) + constant,    v = K_1 - u_1                   (far)

where L is the integral of s^2/(1 - n_2 s^2), that is of s^2/(c^2 + delta s^2).  The first is J
after a change of its parameter (DLMF 19.21.12), the second the same from the other end of the
quarter period.  g_1, g_2 and h_2 vanish on the separatrix, and no term is the difference of others.
"""

from derivations.descended_form import MOTION
from derivations.theta_form import SHIFT, times
from rigidsym.proof.algebra import LedgerBuilder, Part, half_angle, join

# What J gains in 2 K_1, over 2 K_1.
MEAN = Part(
    witness={"j": "0"},
    definitions={
        "Lambda": "(psi_0 + kappa*mu*j)/2",
        "rest": "kappa*(J - j*u_1)/2",
        "rest_0": "kappa*(J_0 - j*phase)/2",
    },
    reading={"j": "(elliptic_pi(n, 1 - m_c)/elliptic_k(1 - m_c) - 1)/n"},
)
# Coefficients by the shift of the theta form; g mu is what the saddle's rate differs by.
SADDLE = Part(
    units=("z", "1 + k_1", "1 + k_1*x**2"),
    definitions={
        "delta": "m_c/z**2",
        "n_2": "1 - delta",
        "g": "k_1*x*y*z/(1 + k_1*x**2)",
        "g_1": "g*m_c/((1 + k_1)*z**2)",
        "g_2": "k_1**2*x*y*m_c/z**3",
        "h_2": "g_1*(k_1 + n_2)",
        "slope": "k_1**2*x*y",
    },
)
# The shift, psi and its rate without what they are made of, so that little has to be reduced.
ABSTRACT = Part(
    witness={
        **{"rho": "1", "k_1": "1", "x": "3/4", "y": "5/4", "z": "5/4", "psi_0": "1", "mu": "1"},
        **{"t": "0", "s": "0", "c": "1", "d": "1"},
    },
    units=("1 - n*s**2",),
    relations=(
        *("rho**2 - 1", "y**2 - 1 - x**2", "z**2 - 1 - (k_1*x)**2"),
        *("c**2 + s**2 - 1", "d**2 + (k_1**2)*s**2 - 1"),
    ),
    definitions={
        "m_c": "1 - k_1**2",
        "n": "-(k_1*x)**2",
        "kappa": "2*rho*k_1**2*x*y*z",
        "psi_rate": "psi_0 + kappa*mu*s**2/(1 - n*s**2)",
        "Lambda": "psi_0/2 + rho*g*mu",
    },
    rates={"t": "1", "s": "(mu)*c*d", "c": "-(mu)*s*d", "d": "-(mu)*(k_1**2)*s*c"},
)
# T is the unit vector whose angle is the arctangent's, but for the sign -rho.
NEAR = Part(
    units=("1 - n_2*s**2",),
    witness={"L": "0"},
    definitions={
        "T_rate": "-rho*mu*slope*((c**2 - s**2)*d**2 + k_1**2*s**2*c**2)"
        "/(z*(1 - n*s**2)*(1 - n_2*s**2))",
    },
    rates={"L": "mu*s**2/(1 - n_2*s**2)"},
    reading={"L": "elliptic_j(u_1, n_2, 1 - m_c)"},
)
ARCTANGENT = Part(
    witness={"T_size": "5/4"},
    units=("T_size",),
    relations=("T_size**2 - z**2*d**2 - slope**2*s**2*c**2",),
    definitions={"T_re": "z*d/T_size", "T_im": "-rho*slope*s*c/T_size"},
    rates={
        "T_size": "-mu*(z**2*d*k_1**2*s*c - slope**2*s*c*(c**2 - s**2)*d)/T_size",
    },
    nonnegative=("T_size",),
)
# The same in a motion, R and V being T_size and its parts without denominators.
SCALED = Part(
    witness={"R": "20655450/169"},
    units=("R",),
    relations=("R**2 - V_re**2 - V_im**2",),
    definitions={
        "V_re": "C_b*(K + B_a)*d",
        "V_im": "-rho*k_1*B_d*(K - B_a + k_1*(K + B_a))*s*c",
        "T_re": "V_re/R",
        "T_im": "V_im/R",
        "T_size": "R/(Y*(K + B_a))",
    },
    rates={
        "R": "-mu*(V_re*C_b*(K + B_a)*k_1**2*s*c"
        " + V_im*rho*k_1*B_d*(K - B_a + k_1*(K + B_a))*(c**2 - s**2)*d)/R",
    },
    nonnegative=("R", "T_size"),
)
# alpha is what the arctangent and the rest of it add up to where u_1 = K_1.
COMPLETE = Part(
    witness={"K_1": "1", "j": "0"},
    definitions={"alpha": "g*K_1*(1 - (k_1 - n)*j)"},
    reading={"K_1": "elliptic_k(1 - m_c)", **MEAN.reading},
)
BETWEEN = {"k_1": "3/5", "x": "0", "y": "1", "z": "1"}
# s, c and d of v = K_1 - u_1 (DLMF 22.4(iii)), the last two by their squares; L is of v.
FAR = Part(
    witness={"L": "0"},
    units=("d", "1 - k_1"),
    definitions={"s_v": "c/d", "c_v_squared": "m_c*s**2/d**2", "d_v_squared": "m_c/d**2"},
    rates={"L": "-mu*z**2*c**2/(m_c*(1 - n*s**2))"},
    reading={"L": "elliptic_j(elliptic_k(1 - m_c) - u_1, n_2, 1 - m_c)"},
)


def turning(rate: str) -> Part:
    """Return a point X on the unit circle that turns at a rate."""
    return Part(
        witness={"X_re": "1", "X_im": "0"},
        relations=("X_im**2 + X_re**2 - 1",),
        rates={"X_re": f"-({rate})*X_im", "X_im": f"({rate})*X_re"},
    )


def half_turned(real: str, imaginary: str) -> Part:
    """Return definitions of cos and sin of psi/2, and the rate H/K on the saddle."""
    return Part(
        definitions={
            "Lambda": "H/K",
            "cos_half_psi": real,
            "sin_half_psi": imaginary,
            "cos_psi": "cos_half_psi**2 - sin_half_psi**2",
            "sin_psi": "2*sin_half_psi*cos_half_psi",
        }
    )


def derive(builder: LedgerBuilder) -> None:
    """Prove the rest, then psi from the saddle and from both ends of a quarter period."""
    builder.open(join("pi_form", *MOTION, half_angle("psi", "psi_rate"), MEAN))
    builder.model("pi_form", "descended")
    builder.claim("pi_form.psi", {"psi/2": "Lambda*t + rest - rest_0"}, ["33", "34", "36"])
    for claims in (_abstract, _near, _far):
        claims(builder)


def _abstract(builder: LedgerBuilder) -> None:
    """Open a context on the rate of psi with few names."""
    builder.open(join("arctangent", ABSTRACT, SADDLE, NEAR, ARCTANGENT))
    saddle = "Lambda - rho*g*(mu - (k_1 - n)*mu*s**2/(1 - n*s**2))"
    builder.claim("arctangent.saddle", {"psi_rate/2": saddle}, ["33", "34", "36"])
    square = "z**2*(1 - n*s**2)*(c**2 + delta*s**2)"
    builder.root("arctangent.T_size", "T_size", square, ["36"])
    turn = {"D(T_re)": "-T_rate*T_im", "D(T_im)": "T_rate*T_re"}
    builder.claim("arctangent.turn", turn, ["36"])
    phase = "Lambda + T_rate - rho*(g_1*mu + g_2*D(L))"
    builder.claim("arctangent.phase", {"psi_rate/2": phase}, ["33", "34", "36"])
    builder.open(join("other_end", ABSTRACT, Part(witness=BETWEEN), SADDLE, FAR))
    path = {"D(L)*(c_v_squared + delta*s_v**2)": "-mu*s_v**2"}
    builder.claim("other_end.path", path, ["36"])
    phase = "Lambda - rho*(g_1*mu - h_2*D(L))"
    builder.claim("other_end.phase", {"psi_rate/2": phase}, ["33", "34", "36"])


def _near(builder: LedgerBuilder) -> None:
    """Prove the motion with psi/2 by an angle X and the arctangent."""
    product = times("X", "T")
    half = half_turned(product["re"], product["im"])
    turn = turning("psi_rate/2 - T_rate")
    builder.open(join("pi_near", *MOTION, SHIFT, SADDLE, NEAR, SCALED, COMPLETE, turn, half))
    builder.model("pi_near", "arctangent")
    builder.carry(
        "pi_near", [f"arctangent.{name}" for name in ("saddle", "T_size", "turn", "phase")]
    )
    builder.model("pi_near", "descended", ["pi_near.turn"])
    builder.carry("pi_near", ["descended.solution"])
    # After every K_1 of u_1 it is alpha more, J being j K_1 there; the rest is periodic.
    grown = {"K_1*g*(u_1 - (k_1 - n)*J)": "alpha*u_1 - K_1*g*(k_1 - n)*(J - j*u_1)"}
    builder.claim("pi_near.grown", grown, ["36"])
    slope = {"D(g*(u_1 - (k_1 - n)*J))": "rho*(Lambda - psi_rate/2)"}
    builder.claim("pi_near.slope", slope, ["33", "34", "36"])


def _far(builder: LedgerBuilder) -> None:
    """Prove the motion with psi/2 by an angle X alone."""
    half = half_turned("X_re", "X_im")
    builder.open(join("pi_far", *MOTION, SHIFT, SADDLE, FAR, turning("psi_rate/2"), half))
    builder.model("pi_far", "other_end")
    builder.carry("pi_far", ["other_end.path", "other_end.phase"])
    builder.model("pi_far", "descended")
    builder.carry("pi_far", ["descended.solution"])
