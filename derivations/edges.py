"""The edges of the regular form: closed forms for the separatrix and for symmetric bodies.

At m = 1 Jacobi's functions are tanh and sech, at m = 0 they are sin, cos and 1 (DLMF 22.5(ii)).
Both are models of the regular form, so everything proved there holds; nothing is a limit that would
have to be taken.  The integral J of the descended form is elementary on the separatrix, and on a
symmetric body the circulation rate is constant.  Motions with constant rates are the next chapter.
"""

from sympy import symbols

from derivations.regular_form import AMPLITUDES, BODY, INVARIANTS, ROTATING
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import rate_of

sn, cn, dn, m, m_1, n = symbols("sn cn dn m m_1 n")
rho, Delta, lambda_, i_a = symbols("rho Delta lambda_ i_a")
c_a, c_b, c_d, c_ab, Omega_a, Omega_b, Omega_d = symbols("c_a c_b c_d c_ab Omega_a Omega_b Omega_d")
A_a, A_b, A_d, B_a, B_b, B_d, E_b = symbols("A_a A_b A_d B_a B_b B_d E_b")
sech, tanh, cosine, sine, x, mu, u_1, A, J = symbols("sech tanh cosine sine x mu u_1 A J")
SEPARATRIX = Part(
    {B_b: "amplitude of c_b |Omega_b|"},
    units=(B_b, B_d**2 + B_a**2, i_a * (B_d**2 + B_a**2) + rho * Delta * B_d**2),
    definitions={m: 1},
    relations=(B_b**2 - B_d**2 - B_a**2,),
    nonnegative=(B_b,),
)
HYPERBOLIC = Part(
    {sech: "1/cosh(u)", tanh: "tanh(u)"},
    definitions={sn: tanh, cn: sech, dn: sech},
    relations=(tanh**2 + sech**2 - 1,),
    rates={tanh: lambda_ * sech**2, sech: -lambda_ * tanh * sech},
)
SYMMETRIC = Part(
    units=(i_a * B_d**2 + rho * Delta * B_d**2,),
    definitions={m: 0, B_b: B_d},
    nonnegative=(B_b,),
)
CIRCULAR = Part(
    {cosine: "cos(u)", sine: "sin(u)"},
    definitions={sn: sine, cn: cosine, dn: 1},
    relations=(sine**2 + cosine**2 - 1,),
    rates={sine: lambda_ * cosine, cosine: -lambda_ * sine},
)
# J at k_1 = 1: x stands for sqrt(-n), A for arctan(x tanh u_1).
ELEMENTARY = Part(
    (x, mu, u_1, sech, tanh, A),
    units=(x, 1 + x**2, 1 + x**2 * tanh**2),
    definitions={n: -(x**2), J: (u_1 - A / x) / (1 - n)},
    relations=(tanh**2 + sech**2 - 1,),
    rates={
        u_1: mu,
        tanh: mu * sech**2,
        sech: -mu * tanh * sech,
        A: x * mu * sech**2 / (1 + x**2 * tanh**2),
    },
    reading={A: "atan(x*tanh)", J: "elliptic_j(u_1, n, 1)"},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that both edges are models of the regular form, with closed forms of rates and psi."""
    here = Proofs.open(
        builder, "separatrix", *BODY, SEPARATRIX, AMPLITUDES, HYPERBOLIC, ROTATING, INVARIANTS
    )
    here.model("regular")
    here.carry("regular", "euler")
    complement = compute(1 - m).subs(m, 1)
    about_b = compute(c_a * c_ab * A_a**2 * m_1).subs(m_1, complement)
    here.claim("middle_axis", {E_b: about_b, m_1: complement}, 10)
    here = Proofs.open(builder, "separatrix_integral", ELEMENTARY)
    integral = compute(ELEMENTARY.definitions[J])
    slope = sum(integral.diff(name) * rate for name, rate in ELEMENTARY.rates.items())
    slope = slope.subs({sech**2: 1 - tanh**2, x**2: -n}).factor()
    here.claim("j", {rate_of(J): slope}, 36)

    here = Proofs.open(
        builder, "symmetric", *BODY, SYMMETRIC, AMPLITUDES, CIRCULAR, ROTATING, INVARIANTS
    )
    here.model("regular")
    here.carry("regular", "euler")
    moment = compute(1 / (i_a + rho * Delta * B_d**2 / B_b**2)).subs(B_b, B_d)
    body = {
        c_b: moment.subs(i_a + rho * Delta, 1 / c_d),
        A_b: compute(B_b / c_b).subs({B_b: A_d * c_d, c_b: c_d}),
        rate_of(Omega_a): compute((c_b - c_d) * Omega_b * Omega_d).subs(c_b, c_d),
    }
    here.claim("body", body, 5)
    rate = compute(Delta * B_a * B_d / B_b).subs(B_b, B_d)
    rate = rate.subs({B_a: A_a * c_a, Delta: rho * (1 / c_d - 1 / c_a)}).factor()
    here.claim("rate", {lambda_: rate}, 10)
