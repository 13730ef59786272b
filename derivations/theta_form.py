"""The theta form: the attitude is two theta functions of a time shifted off the real line.

With v = pi u_1/(2 K_1), b = pi beta/(2 K_1) and the nome q^2 of k_1^2 (q being that of m),

    qbar_0 + i sigma qbar_a         = e^(i Lambda t) theta_4(v - i rho b | q^2) / N
    qbar_b + i epsilon sigma qbar_d = -i chi e^(i Lambda t) theta_1(v - i rho b | q^2) / N

and N^2 is the sum of the squared moduli of both, theta_4(v | q) theta_3(i b | q).  beta is where
sc(beta | 1 - k_1^2) = x; with Jacobi's zeta function, zeta = Z(i beta)/i, Lambda = psi_0/2 +
rho mu zeta is half the mean rate of psi.  0 < k_1 < 1 here: the separatrix and symmetric bodies
have closed forms of their own.

Of what T_4 and sn of the shifted argument are, `theta_form` uses definitions (sn and the
logarithmic derivative Z of T_4, by their addition theorems, and T_1 as sn times T_4) and the rate
of T_4.  `theta_functions` declares all of them to be theta functions, of which `theta_laws` proves
that, so the attitude solves (3) by these.  Modulus, shift and the momentum are given there by the
nome q, by b and by a factor; their readings say which nome and b belong to a body.
"""

from sympy import I, expand, symbols

from derivations.attitude import HANDEDNESS, MOMENTUM, SENSE, TURN
from derivations.descended_form import MOTION
from derivations.regular_form import HALF
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._printing import printed

# sn, cn, dn of (i beta | k_1^2) are i x, y, z.  Y is y root_k (K + B_a), whose square is a
# polynomial.
SHIFT = Part(
    witness={
        **{"k_1": "49/676", "B_a": "161", "B_d": "240", "C_b": "45901/169", "K": "289", "w": "510"},
        **{"root_k": "7/26", "Y": "3495/13", "zeta": "0"},
    },
    units=("root_k", "Y"),
    definitions={
        "x": "B_d/(root_k*(K + B_a))",
        "y": "Y/(root_k*(K + B_a))",
        "z": "C_b/Y",
        "s_beta": "x/y",
        "c_beta": "1/y",
        "d_beta": "z/y",
        "Lambda": "psi_0/2 + rho*mu*zeta",
    },
    relations=("root_k**2 - k_1", "Y**2 - (K + B_a)*(K - B_a + k_1*(K + B_a))"),
    nonnegative=("root_k", "Y", "B_a", "C_b"),
    reading={
        "root_k": "sqrt(k_1)",
        "C_b": "sqrt((1 + k_1)**2*B_d**2 + 4*k_1*B_a**2)",
        "Y": "sqrt((K + B_a)*(K - B_a + k_1*(K + B_a)))",
        "beta": "arcsc(x, 1 - k_1**2)",
        **{f"{x}_beta": f"{x}n of (beta | 1 - k_1^2)" for x in "scd"},
        "g": "pi/(2*elliptic_k(1 - m_c))",
        "nome_1": "nome(1 - m_c)",
        "nome_m": "sqrt(nome(1 - m_c))",
        "zeta": "g*im(dtheta4(g*I*beta, nome_1)/theta4(g*I*beta, nome_1))",
    },
)
# sn and Z of (u_1 - i rho beta | k_1^2).
ADDITION = {
    "SN_re": "s*y*z/(1 - n*s**2)",
    "SN_im": "-rho*x*c*d/(1 - n*s**2)",
    "Z_re": "Z_u - rho*k_1**2*s*x*SN_im",
    "Z_im": "rho*(k_1**2*s*x*SN_re - zeta)",
}
# Jacobi's zeta function on the real line, theta_4 off it, and its modulus.
VALUES = Part(
    witness={"Z_u": "0", "T4_re": "1", "T4_im": "0", "R": "1"},
    units=("R",),
    relations=("R**2 - T4_re**2 - T4_im**2",),
    rates={"Z_u": "?"},
    definitions=ADDITION,
    nonnegative=("R",),
    reading={
        "Z_u": "g*dtheta4(g*u_1, nome_1)/theta4(g*u_1, nome_1)",
        "T4_re": "re(theta4(g*(u_1 - rho*I*beta), nome_1))",
        "T4_im": "im(theta4(g*(u_1 - rho*I*beta), nome_1))",
        "R": "sqrt(T4_re**2 + T4_im**2)",
    },
)
TURNING = Part(
    witness={"X_re": "1", "X_im": "0"},
    relations=("X_im**2 + X_re**2 - 1",),
    rates={"X_re": "-Lambda*X_im", "X_im": "Lambda*X_re"},
    reading={"X_re": "cos(Lambda*t)", "X_im": "sin(Lambda*t)"},
)


def times(x: str, y: str) -> dict[str, str]:
    """Return real and imaginary part of a product x y."""
    names = f"{x}_re {x}_im {y}_re {y}_im"
    a, b, c, d = symbols(names, real=True)
    parts = expand((a + I * b) * (c + I * d)).as_real_imag()
    return {name: printed(part, names) for name, part in zip(("re", "im"), parts, strict=True)}


QUOTIENT = {f"T1_{part}": f"root_k*({form})" for part, form in times("SN", "T4").items()}
SLOPE = {f"T4_{part}": form for part, form in times("Z", "T4").items()}
# Watson's identities make the sum of the squares a product of two real thetas.
NORM = {"W": "T4_re**2 + T4_im**2 + T1_re**2 + T1_im**2"}
CLASSICAL = Part(
    definitions={**QUOTIENT, **NORM},
    rates={**{name: f"mu*({form})" for name, form in SLOPE.items()}, "R": "mu*Z_re*R"},
    reading={
        "T1_re": "re(theta1(g*(u_1 - rho*I*beta), nome_1))",
        "T1_im": "im(theta1(g*(u_1 - rho*I*beta), nome_1))",
        "W": "theta4(g*u_1, nome_m)*re(theta3(g*I*beta, nome_m))",
    },
)
# e^(i psi/2) is e^(i Lambda t) theta_4 over its modulus: psi up to a constant, which the constant
# unit quaternion of (37) takes up.
PHASE = Part(
    definitions={
        **{f"P4_{part}": form for part, form in times("X", "T4").items()},
        **{f"P1_{part}": form for part, form in times("X", "T1").items()},
        "N": "R/s_0",
        "cos_half_psi": "P4_re/R",
        "sin_half_psi": "P4_im/R",
        "cos_psi": "cos_half_psi**2 - sin_half_psi**2",
        "sin_psi": "2*sin_half_psi*cos_half_psi",
    },
)
COMPONENTS = {
    "qbar_0": "P4_re/N",
    "qbar_a": "sigma*P4_im/N",
    "qbar_b": "chi*P1_im/N",
    "qbar_d": "-epsilon*sigma*chi*P1_re/N",
}
FORM = (*MOTION, SHIFT, VALUES, TURNING, PHASE)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the form solves (3) for all functions with these rates."""
    builder.open(join("theta_form", *FORM, CLASSICAL))
    _shift(builder)
    _form(builder)
    _truncation(builder)


def _shift(builder: LedgerBuilder) -> None:
    """Prove dn = K/B_a at i beta, and that beta is below K'/2."""
    shift = {"y**2": "1 + x**2", "z**2": "1 + k_1**2*x**2", "n": "-(k_1*x)**2"}
    builder.claim("theta_form.shift", shift, ["DLMF 22.6.1"])
    dn = {"B_a*(1 + k_1*x**2)": "K*(1 - k_1*x**2)"}
    builder.claim("theta_form.shifted_dn", dn, ["DLMF 22.7.4"])
    builder.sign("theta_form.inside", {"1 - k_1*x**2": "2*B_a/(K + B_a)"}, ["DLMF 22.5(i)"])
    builder.claim("theta_form.kappa", {"kappa": "2*rho*k_1**2*x*y*z"}, ["34"])
    builder.root("theta_form.root_k", "root_k", "k_1", ["27"])
    builder.claim("theta_form.B_a", {"B_a": "c_a*A_a"}, ["27"])
    builder.claim("theta_form.B_d", {"B_d": "c_d*A_d"}, ["28"])
    builder.root("theta_form.y", "y", "1 + x**2", ["DLMF 22.6.1"])
    builder.root("theta_form.z", "z", "1 + (k_1*x)**2", ["DLMF 22.6.1"])
    beta = {
        "s_beta": "x*c_beta",
        "s_beta**2 + c_beta**2": "1",
        "d_beta**2": "1 - (1 - k_1**2)*s_beta**2",
    }
    builder.claim("theta_form.complementary", beta, ["DLMF 22.6.1"])


def _form(builder: LedgerBuilder) -> None:
    """Prove that phase and psi/2 have equal rates, and the quotient of the components."""
    builder.claim("theta_form.phase", {"psi_rate/2": "Lambda + mu*Z_im"}, ["33", "34"])
    builder.model("theta_form", "descended")
    builder.carry("theta_form", ["descended.solution"])
    builder.carry("theta_form", [f"descended.{name}_of_attitude" for name in MOMENTUM])
    _assemble(builder)


def _assemble(builder: LedgerBuilder) -> None:
    """Prove the components as theta functions, given their quotient alone."""
    given = Part(
        witness={"s_0": "1", "root_k": "1", "SN_re": "0", "SN_im": "0"},
        units=("s_0", "N"),
        nonnegative=("s_0", "R"),
        definitions={
            "s_b": "chi*root_k*SN_im*s_0",
            "s_d": "-epsilon*sigma*chi*root_k*SN_re*s_0",
            **QUOTIENT,
            **NORM,
            **{name: form for name, form in TURN.definitions.items() if name.startswith("qbar")},
        },
        relations=("s_0**2*(1 + root_k**2*(SN_re**2 + SN_im**2)) - 1",),
    )
    values = Part(VALUES.witness, VALUES.units, {}, VALUES.relations)
    signs = (HANDEDNESS, SENSE, HALF)
    builder.open(join("quotient", *signs, values, TURNING, given, PHASE, static=True))
    builder.root("quotient.N", "N", "P4_re**2 + P4_im**2 + P1_re**2 + P1_im**2", ["1"])
    builder.root("quotient.N_of_W", "N", "W", ["1"])
    for name, form in COMPONENTS.items():
        builder.claim(f"quotient.{name}", {name: form}, ["18", "25"])
    builder.model("theta_form", "quotient")
    builder.carry("theta_form", [f"quotient.{name}" for name in ("N", "N_of_W", *COMPONENTS)])


def _truncation(builder: LedgerBuilder) -> None:
    """Prove that the rest of a theta series is at most 2 t/(1 - r), by induction.

    The terms q^(2 n^2) e^(2 i n z), n whole for theta_4 and half odd for theta_1, are bounded by t,
    the first one left out, times ratios that start with r and fall by p = q^4 each time; two terms
    go with each n.  With `inside`, e^(2 |Im z|) is below 1/q and r below q^(4 n + 1).
    """
    tail = Part(
        witness={"t": "1/8", "r": "1/16", "p": "1/4"},
        units=("1 - r", "1 - p*r"),
        nonnegative=("t", "r", "p", "1 - r", "1 - p"),
        reading={
            "t": "the first term left out, q**(2*n**2)*exp(2*n*|Im z|)",
            "r": "the next over this one, q**(4*n + 2)*exp(2*|Im z|)",
            "p": "q**4",
        },
    )
    builder.open(join("theta_tail", tail, static=True))
    rest, next_rest = "2*t/(1 - r)", "2*t*r/(1 - p*r)"
    surplus = "2*t*r**2*(1 - p)/((1 - r)*((1 - r) + r*(1 - p)))"
    builder.sign("theta_tail.bound", {f"{rest} - 2*t - {next_rest}": surplus}, ["DLMF 20.2.4"])
