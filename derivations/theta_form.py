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

from sympy import Expr, I, UnevaluatedExpr, factor_terms, powdenest, sqrt

from derivations.attitude import HANDEDNESS, MOMENTUM, SENSE, TURN
from derivations.descended_form import MOTION, SECULAR
from derivations.regular_form import AMPLITUDES, HALF
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named, text
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps._names import expressions, symbol, symbols, unfold

k_1, root_k, K, B_a, B_d, C_b, Y, W = symbols("k_1 root_k K B_a B_d C_b Y W")
A_a, A_d, c_a, c_d = symbols("A_a A_d c_a c_d")
s, c, d, x, y, z, n, r, t, p = symbols("s c d x y z n r t p")
s_beta, c_beta, d_beta, cos_half_psi, sin_half_psi = symbols(
    "s_beta c_beta d_beta cos_half_psi sin_half_psi"
)
epsilon, sigma, rho, chi, s_0, R, N = symbols("epsilon sigma rho chi s_0 R N")
Lambda, psi_rate, psi_0, kappa, mu, zeta = symbols("Lambda psi_rate psi_0 kappa mu zeta")
Z_u, Z_re, Z_im, SN_re, SN_im = symbols("Z_u Z_re Z_im SN_re SN_im")
X_re, X_im, T4_re, T4_im, T1_re, T1_im = symbols("X_re X_im T4_re T4_im T1_re T1_im")
ORDER = "root_k n X_re X_im SN_re SN_im Z_re Z_im s y z rho x c d"


def whole(name: str) -> Expr:
    """Return a complex quantity by the names of its parts."""
    real, imaginary = symbols(f"{name}_re {name}_im")
    return real + I * imaginary


def parts(name: str, value: Expr | Computation) -> dict[str, Computation]:
    """Return definitions of the real and imaginary part of a complex quantity."""
    expanded = compute(value).expand()
    real, imaginary = (
        expanded.coeff(I, k).apply(factor_terms, sign=False).ordered(ORDER) for k in (0, 1)
    )
    return {f"{name}_re": real, f"{name}_im": imaginary}


def times(one: str, other: str) -> dict[str, str]:
    """Return real and imaginary part of a product as texts."""
    names = " ".join(f"{name}_{part}" for name in (one, other) for part in ("re", "im"))
    product = parts("", whole(one) * whole(other)).values()
    sides = (text(side.ordered(names), ()) for side in product)
    return named(("re", "im"), sides)


# sn, cn, dn of (i beta | k_1^2) are i x, y, z; those of -i rho beta follow by parity.
S, C, D = symbols("S C D")
SHIFTED = {S: -I * rho * x, C: y, D: z}
# The addition theorems for sn (DLMF 22.8.1) and Z (DLMF 22.16(ii)), with n = k_1^2 S^2.
ADDITION = {
    **parts("SN", compute((s * C * D + S * c * d) / (1 - n * s**2)).subs(SHIFTED)),
    **parts("Z", compute(Z_u - I * rho * zeta - k_1**2 * s * S * whole("SN")).subs(SHIFTED)),
}
POLE = compute(k_1**2 * S**2).subs(SHIFTED).subs(rho**2, 1)
# Half the rate of psi is the imaginary part of mu Z and a constant: kappa and Lambda.
J, psi = symbols("J psi")
PSI = expressions(SECULAR.definitions)[psi]
RATE = PSI.diff(t) + PSI.diff(J) * expressions(SECULAR.rates)[J]
MOVING = unfold(Z_im, Part(definitions=ADDITION))
KAPPA = (2 * (MOVING + rho * zeta) * (1 - n * s**2) / s**2).cancel()
MEAN = (RATE / 2 - mu * MOVING).subs(kappa, KAPPA).cancel()
# x is positive, n is -(k_1 x)^2, and K^2 - B_a^2 is B_d^2.
SQUARE = unfold(-n / k_1**2, SECULAR).subs(K - B_a, B_d**2 / (K + B_a)).subs(k_1, root_k**2)
BETA = SQUARE.apply(sqrt).apply(powdenest, force=True)

# Y is y root_k (K + B_a), whose square is a polynomial.
SHIFT = Part(
    (root_k, Y, zeta),
    units=(root_k, Y),
    witness={B_a: 161, B_d: 240, k_1: "49/676"},
    definitions={
        x: BETA.ordered("B_d root_k K"),
        y: Y / (root_k * (K + B_a)),
        z: C_b / Y,
        s_beta: x / y,
        c_beta: 1 / y,
        d_beta: z / y,
        Lambda: MEAN.ordered("psi_0 rho mu zeta"),
    },
    relations=(root_k**2 - k_1, Y**2 - (K + B_a) * (K - B_a + k_1 * (K + B_a))),
    nonnegative=(root_k, Y, B_a, C_b),
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
# Jacobi's zeta function on the real line, theta_4 off it, and its modulus.
VALUES = Part(
    {
        Z_u: "g*dtheta4(g*u_1, nome_1)/theta4(g*u_1, nome_1)",
        T4_re: "re(theta4(g*(u_1 - rho*I*beta), nome_1))",
        T4_im: "im(theta4(g*(u_1 - rho*I*beta), nome_1))",
        R: "sqrt(T4_re**2 + T4_im**2)",
    },
    units=(R,),
    relations=(R**2 - T4_re**2 - T4_im**2,),
    rates={Z_u: "?"},
    definitions=ADDITION,
    nonnegative=(R,),
)
TURNING = Part(
    {X_re: "cos(Lambda*t)", X_im: "sin(Lambda*t)"},
    relations=(X_re**2 + X_im**2 - 1,),
    rates=parts("X", I * Lambda * whole("X")),
)
QUOTIENT = parts("T1", root_k * whole("SN") * whole("T4"))
# Watson's identities make the sum of the squares a product of two real thetas.
NORM = {W: T4_re**2 + T4_im**2 + T1_re**2 + T1_im**2}
CLASSICAL = Part(
    definitions={**QUOTIENT, **NORM},
    rates={**parts("T4", mu * whole("Z") * whole("T4")), R: mu * Z_re * R},
    reading={
        "T1_re": "re(theta1(g*(u_1 - rho*I*beta), nome_1))",
        "T1_im": "im(theta1(g*(u_1 - rho*I*beta), nome_1))",
        "W": "theta4(g*u_1, nome_m)*re(theta3(g*I*beta, nome_m))",
    },
)
# e^(i psi/2) is e^(i Lambda t) theta_4 over its modulus: psi up to a constant, which the constant
# unit quaternion of (37) takes up.
PRODUCTS = {
    **parts("P4", whole("X") * whole("T4")),
    **parts("P1", whole("X") * whole("T1")),
}
P4_re, P4_im, P1_re, P1_im = symbols("P4_re P4_im P1_re P1_im")
DOUBLED = parts("psi", (cos_half_psi + I * sin_half_psi) ** 2)
PHASE = Part(
    definitions={
        **PRODUCTS,
        N: R / s_0,
        cos_half_psi: P4_re / R,
        sin_half_psi: P4_im / R,
        "cos_psi": DOUBLED["psi_re"],
        "sin_psi": DOUBLED["psi_im"],
    },
)
FORM = (*MOTION, SHIFT, VALUES, TURNING, PHASE)


def components() -> dict[str, Computation]:
    """Return the attitude by P_4 = X T_4 and P_1 = X T_1, from the turn by psi/2.

    With e^(i psi/2) = X T_4/R, they are the parts of e^(i psi/2) s_0 and e^(i psi/2) (s_b + i
    epsilon sigma s_d), where s_b + i epsilon sigma s_d is -i chi root_k sn s_0.
    """
    X, T4, T1, SN = symbols("X T4 T1 SN")
    turn = X * T4 / R
    sn, modulus = T1 / (root_k * T4), N * s_0
    axis = compute(turn * s_0).subs(R, modulus)
    across = compute(-I * chi * root_k * SN * s_0 * turn).subs(SN, sn).subs(R, modulus)
    about = parts("", axis.subs(X * T4, whole("P4")))
    other = parts("", across.subs(X * T1, whole("P1")))
    return {
        "qbar_0": about["_re"],
        "qbar_a": sigma * about["_im"],
        "qbar_b": other["_re"],
        "qbar_d": epsilon * sigma * other["_im"],
    }


COMPONENTS = components()
SIGNS = {sign**2: 1 for sign in (epsilon, sigma, chi)}
# N^2 is what makes the sum of the squares 1; W is N^2 without the factor |X|^2 = 1.
NORM_SQUARED = (N**2 * sum(q**2 for q in COMPONENTS.values())).expand().subs(SIGNS)
ON_CIRCLE = unfold(NORM_SQUARED, Part(definitions=PRODUCTS)).factor().subs(X_im**2, 1 - X_re**2)
NORM_OF_W = ON_CIRCLE.subs(NORM[W], W)


def derive(builder: LedgerBuilder) -> None:
    """Prove that the form solves (3) for all functions with these rates."""
    here = Proofs.open(builder, "theta_form", *FORM, CLASSICAL)
    _shift(here)
    _form(here)
    _truncation(builder)


def _shift(here: Proofs) -> None:
    """Prove dn = K/B_a at i beta, and that beta is below K'/2."""
    at_beta = {S: I * x}
    cn_squared = compute(1 - S**2).subs(at_beta)
    dn_squared = compute(1 - k_1**2 * S**2).subs(at_beta)
    shift = {y**2: cn_squared, z**2: dn_squared, n: POLE}
    here.claim("shift", shift, "DLMF 22.6.1")
    # Landen's dn at i beta is the second of these over the first.
    k_1_x_squared = (
        compute(k_1 * x**2).subs(x, BETA).subs(k_1, root_k**2).subs(B_d**2, K**2 - B_a**2)
    )
    above, below = ((1 + sign * k_1_x_squared).cancel() for sign in (1, -1))
    here.claim("shifted_dn", {1 + k_1 * x**2: above}, "DLMF 22.7.4")
    here.sign("inside", {1 - k_1 * x**2: below}, "DLMF 22.5(i)")
    here.formulas({kappa: KAPPA}, 34)
    square = compute(SHIFT.relations[0]).solve_for(root_k**2)
    here.root(root_k, square, 27)
    for A, B, source in ((A_a, B_a, 27), (A_d, B_d, 28)):
        here.formulas({B: (unfold(A, AMPLITUDES) - A).solve_for(B)}, source)
    here.root(y, cn_squared, "DLMF 22.6.1")
    radicand = dn_squared.subs((k_1 * x) ** 2, UnevaluatedExpr(k_1 * x) ** 2)
    here.root(z, radicand, "DLMF 22.6.1")
    _complementary(here, cn_squared, dn_squared)


def _complementary(here: Proofs, y_squared: Computation, z_squared: Computation) -> None:
    """Prove what sn, cn, dn of (beta | 1 - k_1^2) satisfy."""
    ratio = compute(x / y).subs(1 / y, c_beta)
    circle = (
        compute(s_beta**2 + c_beta**2).subs({s_beta: x / y, c_beta: 1 / y}).subs(y**2, y_squared)
    )
    ellipse = (z_squared / y_squared).subs(x**2, s_beta**2 / (1 - s_beta**2))
    laws = {s_beta: ratio, s_beta**2 + c_beta**2: circle.cancel(), d_beta**2: ellipse.cancel()}
    here.claim("complementary", laws, "DLMF 22.6.1")


def _form(form: Proofs) -> None:
    """Prove that phase and psi/2 have equal rates; then the components, by their quotient alone."""
    form.claim("phase", {psi_rate / 2 - mu * Z_im: MEAN}, 33, 34)
    form.model("descended")
    form.carry("descended", "solution", *(f"{name}_of_attitude" for name in MOMENTUM))
    given = Part(
        (s_0, root_k, SN_re, SN_im),
        units=(s_0, N),
        nonnegative=(s_0, R),
        definitions={
            "s_b": chi * root_k * SN_im * s_0,
            "s_d": -epsilon * sigma * chi * root_k * SN_re * s_0,
            **QUOTIENT,
            **NORM,
            **{name: form for name, form in TURN.definitions.items() if name in COMPONENTS},
        },
        relations=(s_0**2 * (1 + root_k**2 * (SN_re**2 + SN_im**2)) - 1,),
    )
    values = Part(VALUES.names, VALUES.units, {}, VALUES.relations)
    signs = (HANDEDNESS, SENSE, HALF)
    here = Proofs.open(form.builder, "quotient", *signs, values, TURNING, given, PHASE, static=True)
    here.root(N, NORM_SQUARED, 1)
    here.root(N, NORM_OF_W, 1, fact="N_of_W")
    here.formulas(COMPONENTS, 18, 25)
    form.model("quotient")
    form.carry("quotient", N, "N_of_W", *COMPONENTS)


def _truncation(builder: LedgerBuilder) -> None:
    """Prove that the rest of a theta series is at most 2 t/(1 - r), by induction.

    The terms q^(2 n^2) e^(2 i n z), n whole for theta_4 and half odd for theta_1, are bounded by t,
    the first one left out, times ratios that start with r and fall by p = q^4 each time; two terms
    go with each n.  With `inside`, e^(2 |Im z|) is below 1/q and r below q^(4 n + 1).
    """
    tail = Part(
        {
            t: "the first term left out, q**(2*n**2)*exp(2*n*|Im z|)",
            r: "the next over this one, q**(4*n + 2)*exp(2*|Im z|)",
            p: "q**4",
        },
        units=(1 - r, 1 - p * r),
        nonnegative=(t, r, p, 1 - r, 1 - p),
    )
    here = Proofs.open(builder, "theta_tail", tail, static=True)
    surplus = 2 * t / (1 - r) - 2 * t - 2 * t * r / (1 - p * r)
    # By r and 1 - p, 1 - p r is a sum of nonnegative terms.
    one_less_p = symbol("one_less_p")
    below = (1 - r) * (1 - r + r * one_less_p)
    form = (compute(surplus).subs(p, 1 - one_less_p) * below).factor() / below
    here.sign("bound", {surplus: form.subs(one_less_p, 1 - p)}, "DLMF 20.2.4")
