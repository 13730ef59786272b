"""One step of Landen's descent, with inverse formulas free of cancellation, and its end.

With k_next = (1 - kc)/(1 + kc), sn, cn, dn of (u | k^2) are rational in those of
(u/(1 + k_next) | k_next^2) (DLMF 22.7.2 to 22.7.4).  So is x = sc(beta | 1 - k^2), since sn of
i beta is i x.  Solved for the new functions, all is made of sums of positive terms.  Moduli are
measured by r = k/w^2 and shifts by Y = w x, with one scale w for all steps.  With w^2 = Q, the nome
of m, r and Y of the top have limits where k_1 vanishes.  At the bottom x = sinh(b), and

    h_plus = w e^b,     h_minus = w e^(-b),     h_plus - h_minus = 2 Y_b,     h_plus h_minus = Q

are what the theta series of the shifted argument are made of.
"""

from sympy import Expr, I, Poly, Symbol, cancel, factor, prod

from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps._names import symbols

k, kc, root_kc, k_next, kc_next, K, K_next = symbols("k kc root_kc k_next kc_next K K_next")
s, c, d, v, s_next, c_next, d_next = symbols("s c d v s_next c_next d_next")
x, x_next, inside, S, w, r, r_next, Y, Y_next = symbols("x x_next inside S w r r_next Y Y_next")
h_plus, h_minus, Q, root_Q, Y_b, root_h = symbols("h_plus h_minus Q root_Q Y_b root_h")
root_r, root_k, k_1, B_a, B_d = symbols("root_r root_k k_1 B_a B_d")
exp_b, exp_minus_b, square, below = symbols("exp_b exp_minus_b square below")


def _root(power: Expr) -> Expr:
    """Return the root of a product of squares that is positive at u = 0."""
    root = prod(base ** (n / 2) for base, n in factor(power).as_powers_dict().items())
    start = {s_next: 0, c_next: 1, d_next: 1}
    return cancel(root / root.subs(start)) if root.has(s_next) else root


# Landen's modulus and his sn, by which cn^2 = 1 - sn^2 and dn^2 = 1 - k^2 sn^2 are squares, too.
DESCENDED = (1 - kc) / (1 + kc)
BELOW = 1 + k_next * s_next**2
SN = (1 + k_next) * s_next / BELOW
KC = compute(DESCENDED - k_next).solve_for(kc)
CN = compute(1 - SN**2).subs(s_next**2, square).factor()
CN = CN.subs({square - 1: -(c_next**2), k_next**2 * square - 1: -(d_next**2)})
CN = CN.subs(square, s_next**2).apply(_root)
DN = (1 - (1 - KC**2) * SN**2).apply(_root)
# At u = 0 both arguments grow as their sn.
GROWTH = compute(SN).diff(s_next).subs(s_next, 0)
# The denominator by d; v is what d_next is over it, but for the 2 that 1 + d has.
BY_D = (DN.subs(k_next * s_next**2, below - 1) - d).solve_for(below)
V = (d_next * (1 + DN)).factor()
# For u = i beta sn is i x: a quadratic equation for x_next, whose slope at the root is S.
IMAGINARY = compute(SN).subs(s_next, I * x_next) / I
INSIDE = compute(BELOW).subs(s_next, I * x_next)
SHIFTED = (IMAGINARY - x).together().as_numer_denom()[0]
SLOPE = SHIFTED.diff(x_next)

# The only rational points of the modulus are the ends: 1 - kc^2 and kc are squares nowhere else.
MODULUS = Part(
    (root_kc, k, K_next),
    units=(1 + root_kc**2,),
    relations=(k**2 + root_kc**4 - 1,),
    definitions={
        kc: root_kc**2,
        k_next: DESCENDED,
        kc_next: compute(1 - DESCENDED**2).subs(kc, root_kc**2).apply(_root).subs(root_kc**2, kc),
        K: GROWTH * K_next,
    },
    nonnegative=(root_kc, k_next),
    reading={
        k: "modulus",
        kc: "complementary modulus",
        K: "quarter period of modulus k",
        k_next: "modulus after one step",
        kc_next: "complementary modulus after one step",
        K_next: "quarter period of modulus k_next",
    },
)
ARGUMENT = Part(
    (s_next, c_next, d_next),
    units=(d_next, BELOW),
    relations=(c_next**2 + s_next**2 - 1, d_next**2 + k_next**2 * s_next**2 - 1),
    definitions={s: SN, c: CN, d: DN, v: V},
    nonnegative=(d_next,),
    reading={
        **{x: f"{x}n of (u | k^2)" for x in (s, c, d)},
        **{f"{x}_next": f"{x}n of (u/(1 + k_next) | k_next^2)" for x in (s, c, d)},
    },
)
SHIFT = Part(
    {
        x_next: "sc of (beta/(1 + k_next) | 1 - k_next^2)",
        w: "scale of the shifts, the same at every step",
    },
    units=(w, inside),
    definitions={
        inside: INSIDE,
        x: IMAGINARY.subs(INSIDE, inside),
        S: SLOPE.subs(x, IMAGINARY).factor().xreplace({-INSIDE: -inside}),
        r: k / w**2,
        r_next: k_next / w**2,
        Y: w * x,
        Y_next: w * x_next,
    },
    nonnegative=(inside,),
    reading={
        inside: "positive for beta below half of the quarter period",
        x: "sc of (beta | 1 - k^2)",
    },
)
# The shift at the top: where dn is K/B_a.
TOP = B_d / (root_k * (K + B_a))
# What the scale is at the top, and the exponentials of the bottom.
SCALING = Part(
    (h_plus, h_minus, root_Q, root_r),
    units=(root_r,),
    relations=(root_Q**2 - h_plus * h_minus,),
    definitions={
        Q: h_plus * h_minus,
        Y_b: (h_plus - h_minus) / 2,
        root_h: (h_plus + h_minus) / 2,
        r: root_r**2,
        root_k: root_r * root_Q,
        k_1: root_k**2,
    },
    nonnegative=(h_plus, h_minus, root_Q, root_r),
    reading={
        Q: "sqrt(nome(1 - m_c))",
        root_k: "sqrt(k_1)",
        r: "k_1/Q",
        h_plus: "root_Q*exp(b)",
        h_minus: "root_Q*exp(-b)",
    },
)
MOMENTUM = Part(
    (K, B_a, B_d),
    units=(K + B_a,),
    relations=(K**2 - B_a**2 - B_d**2,),
    definitions={Y: compute(root_Q * TOP).subs(root_k, root_r * root_Q)},
)
# Where the modulus is not zero, the scale can be taken out again.
UNSCALED = Part(
    units=(root_Q,),
    definitions={x: TOP, exp_b: h_plus / root_Q, exp_minus_b: h_minus / root_Q},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the step, then the scale, where it is chosen and where it is used."""
    here = Proofs.open(builder, "landen", MODULUS, ARGUMENT, SHIFT, static=True)
    for claims in (_modulus, _argument, _shift):
        claims(here)
    _scale(builder)


def _modulus(here: Proofs) -> None:
    """Prove the new modulus and its complement, each without cancellation."""
    smaller = compute((1 - kc) * (1 + kc)).expand().subs(kc**2, 1 - k**2) / (1 + kc) ** 2
    here.formulas({k_next: smaller}, "DLMF 22.7.1")
    here.root(root_kc, _named(root_kc, kc), "DLMF 22.7.1")
    square = compute(k_next**2 + kc_next**2 - 1).solve_for(kc_next**2)
    here.root(kc_next, square, "DLMF 22.7.1", fact="complement")


def _named(root: Symbol, name: Symbol) -> Computation:
    """Return the square of a root by its name."""
    return compute(root**2).subs(root**2, name)


def _argument(here: Proofs) -> None:
    """Prove that the new functions satisfy the equations of Jacobi's, and find them by the old."""
    old = {s**2 + c**2: 1, d**2 + k**2 * s**2: 1}
    curves = "the curves of sn, cn and dn"
    here.claim("functions", old, "DLMF 22.7.2 to 22.7.4", law=curves)
    # d_next (1 + d) is a root of what d says; s and c are linear.
    s_squared = (DN - d).solve_for(s_next**2)
    v_squared = ((1 + d) ** 2 * (1 - k_next**2 * s_squared)).subs(k_next, DESCENDED).factor()
    v_squared = v_squared.xreplace({1 + kc: (1 + KC).factor()}).factor()
    here.root(v, v_squared, "DLMF 22.7.4")
    by_d = {
        s_next: s * BY_D / GROWTH,
        c_next: (CN.subs(d_next, (V - v).solve_for(d_next)) - c).solve_for(c_next),
        d_next: (V.subs(BELOW, BY_D) - v).solve_for(d_next),
    }
    here.formulas(by_d, "DLMF 22.7.2 to 22.7.4")
    # s = 1 where s_next is: the quarter periods K and (1 + k_next) K_next are the same u.
    here.claim("quarter", {1 - s: compute(1 - SN).factor()}, "DLMF 19.8.12")


def _shift(here: Proofs) -> None:
    """Find the step for an imaginary argument from its quadratic equation."""
    smaller = compute(k**2 / (1 + kc) ** 2 / w**2).subs(k / w**2, r)
    here.formulas({r_next: smaller}, "DLMF 22.7.1")
    first, second, third = SHIFTED.apply(Poly, x_next).all_coeffs()
    discriminant = (second**2 - 4 * first * third).subs(x, Y / w).subs(k_next / w**2, r_next)
    here.root(S, discriminant, "DLMF 22.7.2")
    # S eliminates the square of x_next: what is left is linear.
    scaled = (SHIFTED - x_next / 2 * (SLOPE - S)).subs({x: Y / w, x_next: Y_next / w})
    here.formulas({Y_next: scaled.solve_for(Y_next)}, "DLMF 22.7.2")


def _scale(builder: LedgerBuilder) -> None:
    """Find the scale, its square and scaled quantities; k_1 = 0 is a regular point."""
    here = Proofs.open(builder, "scaling", SCALING, MOMENTUM, static=True)
    here.root(root_r, _named(root_r, r), 27)
    modulus = compute(root_k**2).subs(root_k, root_r * root_Q).subs({root_r**2: r, root_Q**2: Q})
    here.formulas({Q: (modulus - k_1).solve_for(Q)}, 27)
    sum_, difference = (h_plus + h_minus) / 2, (h_plus - h_minus) / 2
    square = compute(sum_**2 - difference**2).expand().subs(h_plus * h_minus, Q)
    here.root(root_h, Y_b**2 + square, 28)
    found = compute([sum_ - root_h, difference - Y_b]).solve_for(h_plus, h_minus)
    here.formulas(found, 28)
    here = Proofs.open(builder, "unscaled", SCALING, MOMENTUM, UNSCALED, static=True)
    scales = "how Y, r and the exponentials were chosen: the scale taken out"
    here.claim("top", {Y: root_Q * x, k_1: root_Q**2 * r}, 28, why=scales)
    sinh = {Y_b: root_Q * (exp_b - exp_minus_b) / 2, exp_b * exp_minus_b: 1}
    here.claim("bottom", sinh, 28, why=scales)
