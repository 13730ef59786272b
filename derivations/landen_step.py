"""One step of Landen's descent, with inverse formulas free of cancellation, and its end.

With k_next = (1 - kc)/(1 + kc), sn, cn, dn of (u | k^2) are rational in those of
(u/(1 + k_next) | k_next^2) (DLMF 22.7.2 to 22.7.4).  So is x = sc(beta | 1 - k^2), since sn of
i beta is i x.  Solved for the new functions, all is made of sums of positive terms.  Moduli are
measured by r = k/w^2 and shifts by Y = w x, with one scale w for all steps.  With w^2 = Q, the nome
of m, r and Y of the top have limits where k_1 vanishes.  At the bottom x = sinh(b), and

    h_plus = w e^b,     h_minus = w e^(-b),     h_plus - h_minus = 2 Y_b,     h_plus h_minus = Q

are what the theta series of the shifted argument are made of.
"""

from rigidsym.proof.algebra import LedgerBuilder, Part, join

# The only rational points of the modulus are the ends: 1 - kc^2 and kc are squares nowhere else.
MODULUS = Part(
    witness={"root_kc": "0", "k": "1", "K_next": "2"},
    units=("1 + root_kc**2",),
    relations=("k**2 + root_kc**4 - 1",),
    definitions={
        "kc": "root_kc**2",
        "k_next": "(1 - kc)/(1 + kc)",
        "kc_next": "2*root_kc/(1 + kc)",
        "K": "(1 + k_next)*K_next",
    },
    nonnegative=("root_kc", "k_next"),
    reading={
        "k": "modulus",
        "kc": "complementary modulus",
        "K": "quarter period of modulus k",
        "k_next": "modulus after one step",
        "kc_next": "complementary modulus after one step",
        "K_next": "quarter period of modulus k_next",
    },
)
ARGUMENT = Part(
    witness={"s_next": "0", "c_next": "1", "d_next": "1"},
    units=("d_next", "1 + k_next*s_next**2"),
    relations=("c_next**2 + s_next**2 - 1", "d_next**2 + k_next**2*s_next**2 - 1"),
    definitions={
        "s": "(1 + k_next)*s_next/(1 + k_next*s_next**2)",
        "c": "c_next*d_next/(1 + k_next*s_next**2)",
        "d": "(1 - k_next*s_next**2)/(1 + k_next*s_next**2)",
        "v": "2*d_next/(1 + k_next*s_next**2)",
    },
    nonnegative=("d_next",),
    reading={
        **{x: f"{x}n of (u | k^2)" for x in "scd"},
        **{f"{x}_next": f"{x}n of (u/(1 + k_next) | k_next^2)" for x in "scd"},
    },
)
SHIFT = Part(
    witness={"x_next": "1/2", "w": "2"},
    units=("w", "inside"),
    definitions={
        "inside": "1 - k_next*x_next**2",
        "x": "(1 + k_next)*x_next/inside",
        "S": "(1 + k_next)*(1 + k_next*x_next**2)/inside",
        "r": "k/w**2",
        "r_next": "k_next/w**2",
        "Y": "w*x",
        "Y_next": "w*x_next",
    },
    nonnegative=("inside",),
    reading={
        "inside": "positive for beta below half of the quarter period",
        "x": "sc of (beta | 1 - k^2)",
        "x_next": "sc of (beta/(1 + k_next) | 1 - k_next^2)",
        "w": "scale of the shifts, the same at every step",
    },
)
# What the scale is at the top, and the exponentials of the bottom.
SCALING = Part(
    witness={"h_plus": "4", "h_minus": "1", "root_Q": "2", "root_r": "1/2"},
    units=("root_r",),
    relations=("root_Q**2 - h_plus*h_minus",),
    definitions={
        "Q": "h_plus*h_minus",
        "Y_b": "(h_plus - h_minus)/2",
        "root_h": "(h_plus + h_minus)/2",
        "r": "root_r**2",
        "root_k": "root_r*root_Q",
        "k_1": "root_k**2",
    },
    nonnegative=("h_plus", "h_minus", "root_Q", "root_r"),
    reading={
        "Q": "sqrt(nome(1 - m_c))",
        "root_k": "sqrt(k_1)",
        "r": "k_1/Q",
        "h_plus": "root_Q*exp(b)",
        "h_minus": "root_Q*exp(-b)",
    },
)
MOMENTUM = Part(
    witness={"K": "25", "B_a": "7", "B_d": "24"},
    units=("K + B_a",),
    relations=("K**2 - B_a**2 - B_d**2",),
    definitions={"Y": "B_d/((K + B_a)*root_r)"},
)
# Where the modulus is not zero, the scale can be taken out again.
UNSCALED = Part(
    units=("root_Q",),
    definitions={
        "x": "B_d/(root_k*(K + B_a))",
        "exp_b": "h_plus/root_Q",
        "exp_minus_b": "h_minus/root_Q",
    },
)
FUNCTIONS = {
    "s_next": "2*s/((1 + k_next)*(1 + d))",
    "c_next": "2*c/v",
    "d_next": "v/(1 + d)",
}


def derive(builder: LedgerBuilder) -> None:
    """Prove the step, then the scale, where it is chosen and where it is used."""
    builder.open(join("landen", MODULUS, ARGUMENT, SHIFT, static=True))
    for claim in (_modulus, _argument, _shift, _scale):
        claim(builder)


def _modulus(builder: LedgerBuilder) -> None:
    """Prove the new modulus and its complement, each without cancellation."""
    builder.claim("landen.k_next", {"k_next": "(k/(1 + kc))**2"}, ["DLMF 22.7.1"])
    builder.root("landen.root_kc", "root_kc", "kc", ["DLMF 22.7.1"])
    builder.root("landen.complement", "kc_next", "1 - k_next**2", ["DLMF 22.7.1"])


def _argument(builder: LedgerBuilder) -> None:
    """Prove that the new functions satisfy the equations of Jacobi's."""
    old = {"s**2 + c**2": "1", "d**2 + k**2*s**2": "1"}
    builder.claim("landen.functions", old, ["DLMF 22.7.2 to 22.7.4"])
    builder.root("landen.v", "v", "(1 + k_next)*(1 + d)*(d + kc)", ["DLMF 22.7.4"])
    for name, form in FUNCTIONS.items():
        builder.claim(f"landen.{name}", {name: form}, ["DLMF 22.7.2 to 22.7.4"])
    # s = 1 where s_next is: the quarter periods K and (1 + k_next) K_next are the same u.
    quarter = "(1 - s_next)*(1 - k_next*s_next)/(1 + k_next*s_next**2)"
    builder.claim("landen.quarter", {"1 - s": quarter}, ["DLMF 19.8.12"])


def _shift(builder: LedgerBuilder) -> None:
    """Prove the step for an imaginary argument, where squares have the other sign."""
    builder.claim("landen.r_next", {"r_next": "r*k/(1 + kc)**2"}, ["DLMF 22.7.1"])
    builder.root("landen.S", "S", "(1 + k_next)**2 + 4*r_next*Y**2", ["DLMF 22.7.2"])
    builder.claim("landen.Y_next", {"Y_next": "2*Y/(1 + k_next + S)"}, ["DLMF 22.7.2"])


def _scale(builder: LedgerBuilder) -> None:
    """Prove the scale, its square and scaled quantities; k_1 = 0 is a regular point."""
    builder.open(join("scaling", SCALING, MOMENTUM, static=True))
    builder.root("scaling.root_r", "root_r", "r", ["27"])
    builder.claim("scaling.Q", {"Q": "k_1/r"}, ["27"])
    builder.root("scaling.root_h", "root_h", "Y_b**2 + Q", ["28"])
    builder.claim("scaling.h_plus", {"h_plus": "root_h + Y_b"}, ["28"])
    builder.claim("scaling.h_minus", {"h_minus": "root_h - Y_b"}, ["28"])
    builder.open(join("unscaled", SCALING, MOMENTUM, UNSCALED, static=True))
    builder.claim("unscaled.top", {"Y": "root_Q*x", "k_1": "root_Q**2*r"}, ["28"])
    sinh = {"Y_b": "root_Q*(exp_b - exp_minus_b)/2", "exp_b*exp_minus_b": "1"}
    builder.claim("unscaled.bottom", sinh, ["28"])
