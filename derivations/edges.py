"""The edges of the regular form: closed forms for the separatrix and for symmetric bodies.

At m = 1 Jacobi's functions are tanh and sech, at m = 0 they are sin, cos and 1 (DLMF 22.5(ii)).
Both are models of the regular form, so everything proved there holds; nothing is a limit that would
have to be taken.  The integral J of the descended form is elementary on the separatrix, and on a
symmetric body the circulation rate is constant.  Motions with constant rates are the next chapter.
"""

from derivations.regular_form import AMPLITUDES, BODY, INVARIANTS, ROTATING
from rigidsym.proof.algebra import LedgerBuilder, Part, join

SEPARATRIX = Part(
    witness={"B_b": "25"},
    units=("B_b", "B_d**2 + B_a**2", "i_a*(B_d**2 + B_a**2) + rho*Delta*B_d**2"),
    definitions={"m": "1"},
    relations=("B_b**2 - B_d**2 - B_a**2",),
    nonnegative=("B_b",),
    reading={"B_b": "amplitude of c_b |Omega_b|"},
)
HYPERBOLIC = Part(
    witness={"sech": "1", "tanh": "0"},
    definitions={"sn": "tanh", "cn": "sech", "dn": "sech"},
    relations=("tanh**2 + sech**2 - 1",),
    rates={"tanh": "lambda_*sech**2", "sech": "-lambda_*tanh*sech"},
    reading={"tanh": "tanh(u)", "sech": "1/cosh(u)"},
)
SYMMETRIC = Part(
    units=("i_a*B_d**2 + rho*Delta*B_d**2",),
    definitions={"m": "0", "B_b": "B_d"},
    nonnegative=("B_b",),
)
CIRCULAR = Part(
    witness={"cosine": "1", "sine": "0"},
    definitions={"sn": "sine", "cn": "cosine", "dn": "1"},
    relations=("sine**2 + cosine**2 - 1",),
    rates={"sine": "lambda_*cosine", "cosine": "-lambda_*sine"},
    reading={"sine": "sin(u)", "cosine": "cos(u)"},
)
# J at k_1 = 1: x stands for sqrt(-n), A for arctan(x tanh u_1).
ELEMENTARY = Part(
    witness={"x": "1/2", "mu": "1", "u_1": "0", "sech": "1", "tanh": "0", "A": "0"},
    units=("x", "1 + x**2", "1 + x**2*tanh**2"),
    definitions={"n": "-x**2", "J": "(u_1 - A/x)/(1 - n)"},
    relations=("tanh**2 + sech**2 - 1",),
    rates={
        "u_1": "mu",
        "tanh": "mu*sech**2",
        "sech": "-mu*tanh*sech",
        "A": "x*mu*sech**2/(1 + x**2*tanh**2)",
    },
    reading={"A": "atan(x*tanh)", "J": "elliptic_j(u_1, n, 1)"},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that both edges are models of the regular form, with closed forms of rates and psi."""
    builder.open(
        join("separatrix", *BODY, SEPARATRIX, AMPLITUDES, HYPERBOLIC, ROTATING, INVARIANTS)
    )
    builder.model("separatrix", "regular")
    builder.carry("separatrix", ["regular.euler"])
    builder.claim("separatrix.middle_axis", {"E_b": "0", "m_1": "0"}, ["10"])
    builder.open(join("separatrix_integral", ELEMENTARY))
    builder.claim("separatrix_integral.j", {"D(J)": "mu*tanh**2/(1 - n*tanh**2)"}, ["36"])

    builder.open(join("symmetric", *BODY, SYMMETRIC, AMPLITUDES, CIRCULAR, ROTATING, INVARIANTS))
    builder.model("symmetric", "regular")
    builder.carry("symmetric", ["regular.euler"])
    builder.claim("symmetric.body", {"c_b": "c_d", "A_b": "A_d", "D(Omega_a)": "0"}, ["5"])
    builder.claim("symmetric.rate", {"lambda_": "rho*(c_a - c_d)*A_a/c_d"}, ["10"])
