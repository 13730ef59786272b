"""The theta forms by the theta functions themselves: none of their properties is assumed.

T_4 and T_1 are declared to be theta functions of v - i rho b, and the kernel knows their rates.
By `theta_laws` they satisfy what the theta forms ask of T_4 and T_1.  A motion is given by the
nome, by b and by a factor, which make the modulus and the amplitudes of the momentum:

    k_1 = null_c^2/null_d^2,    B_d/(K + B_a) = b_s/b_n

Which nome and which b belong to a body is said by the readings: nome(1 - m_c) and g beta.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from derivations.attitude import MOMENTUM
from derivations.descended_form import MOMENTUM as SHORTEST
from derivations.hyperbolic_form import READING
from derivations.theta_edges import given
from derivations.theta_form import CLASSICAL, COMPONENTS, FORM
from derivations.theta_laws import (
    CIRCULAR,
    HYPERBOLIC,
    JACOBI,
    LAWS,
    NAMES,
    UNITS,
    Family,
    prove,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, join

BODY = {
    "K": "K_factor*(b_n**2 + b_s**2)",
    "B_a": "K_factor*(b_n**2 - b_s**2)",
    "B_d": "2*K_factor*b_s*b_n",
    "Y": "2*K_factor*b_n*b_c*null_n/null_d",
    "C_b": "2*K_factor*b_c*b_d*(null_n/null_d)**2",
}
SHIFTED_TIME = {
    "v": "g*u_1",
    "T4_re": "N_re",
    "T4_im": "rho*N_im",
    "T1_re": "S_re",
    "T1_im": "rho*S_im",
    "s_rate": "mu*g*null_d*(dv_s*v_n - v_s*dv_n)/(null_c*v_n**2)",
}
SHOWN = (
    "root_k**2 - k_1",
    "Y**2 - (K + B_a)*(K - B_a + k_1*(K + B_a))",
    "C_b**2 - (1 + k_1)**2*B_d**2 - 4*k_1*B_a**2",
    "K**2 - B_a**2 - B_d**2",
    "c**2 + s**2 - 1",
    "d**2 + (k_1**2)*s**2 - 1",
)
# The factors of what the theta form divides by.
DIVISORS = (
    *("i_a", "i_a + rho*Delta", "Delta", "rho", "w", "R", "K_factor", "b_s", "b_c", "b_d"),
    *("b_n**2 + b_s**2", "b_n**2 - b_s**2", "null_c**2 + null_d**2", "v_n**2 + v_s**2"),
    *("null_c**2*b_n**2 + null_d**2*b_s**2", "null_d**2*b_n**2 + null_c**2*b_s**2"),
    "i_a*(null_c**2*b_n**2 + null_d**2*b_s**2)*(null_d**2*b_n**2 + null_c**2*b_s**2)"
    " + rho*Delta*(b_s*b_n*(null_c**2 + null_d**2))**2",
    "i_a*(b_c*b_d*null_n**2)**2 + rho*Delta*(b_s*b_n*(null_c**2 + null_d**2))**2",
)
RATES = {
    **{f"v_{role}": f"mu*g*dv_{role}" for role in "scdn"},
    **{f"N_{x}": f"mu*g*dN_{x}" for x in ("re", "im")},
    **dict.fromkeys([*(f"dv_{x}" for x in "scdn"), "S_re", "S_im", "dN_re", "dN_im", "W_v"], "?"),
    "R": "mu*g*(N_re*dN_re + N_im*dN_im)/R",
    # as in `descended_form`, D(s) for mu c d
    "w": SHORTEST.rates["w"].replace("mu*c*d", "s_rate"),
}
WITNESS = {
    **{"b": "0", "K_factor": "1", "W_v": "1", "W_b": "1"},
    **dict.fromkeys(NAMES, "1"),
    **{"null_d": "2", "b_n": "4", "b_s": "3", "v_s": "0", "N_im": "0"},
}
READINGS = {"K_factor": "K/(b_n**2 + b_s**2)", "b": "g*beta", "v": "the argument of thetas"}


@dataclass(frozen=True, slots=True)
class Norm:
    """W as a product of two thetas, and as a sum of squares for all a and c."""

    family: Family
    declared: Mapping[str, str]
    form: str
    product: str
    arguments: Mapping[str, str]

    def identity(self) -> str:
        """Prove Watson's identity, DLMF 20.7.13 and 20.7.14."""
        squares = (f"{self.family.of(x, 'a + c')}*{self.family.of(x, 'a - c')}" for x in "ns")
        return " + ".join(squares) + f" - {self.product}"


NORMS = {
    "theta_functions": Norm(
        CIRCULAR,
        {"W_v": "re(theta4(v, nome_m))", "W_b": "re(theta3(I*b, nome_m))"},
        "W_v*W_b",
        "theta4(a, nome_m)*theta3(c, nome_m)",
        {"a": "v", "c": "-I*b"},
    ),
    "hyperbolic_functions": Norm(
        HYPERBOLIC,
        {"W_v": "re(theta2(2*I*v, nome_c**2))", "W_b": "re(theta3(2*b, nome_c**2))"},
        "2*W_v*W_b",
        "2*theta2(2*c, nome_c**2)*theta3(2*a, nome_c**2)",
        {"a": "b", "c": "I*v"},
    ),
}


def derive(builder: LedgerBuilder) -> None:
    """Prove the norm in the squared nome of m, and in the complementary nome."""
    for context, norm in NORMS.items():
        _motion(builder, context, norm)
        prove(builder, context, norm.family)
        squares = "N_re**2 + N_im**2 + S_re**2 + S_im**2"
        builder.theta(f"{context}.norm", {"W": squares}, norm.identity(), norm.arguments)
        premises = (*LAWS, "norm")
        builder.model(context, "theta_form", [f"{context}.{name}" for name in premises])
        carried = ("solution", "N_of_W", *COMPONENTS, *(f"{name}_of_attitude" for name in MOMENTUM))
        builder.carry(context, [f"theta_form.{name}" for name in carried])


def _motion(builder: LedgerBuilder, context: str, norm: Norm) -> None:
    """Open the theta form's context with declared functions."""
    nome = norm.family.nome.partition("*")[0]
    values = {*JACOBI, *BODY, *SHIFTED_TIME}
    functions = Part(
        witness={nome: "1/2", **WITNESS},
        units=(*UNITS, *DIVISORS),
        definitions=JACOBI,
        thetas={**norm.family.declared(), **norm.declared},
    )
    made = Part(
        {"w": "40"},
        definitions={**BODY, **SHIFTED_TIME, "W": norm.form},
        rates=RATES,
        reading=READINGS,
    )
    reading = READING if norm.family is HYPERBOLIC else Part()
    parts = given((*FORM, CLASSICAL), values, SHOWN)
    builder.open(join(context, functions, *parts, made, reading))
