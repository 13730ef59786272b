"""The theta forms by the theta functions themselves: none of their properties is assumed.

T_4 and T_1 are declared to be theta functions of v - i rho b, and the kernel knows their rates.
By `theta_laws` they satisfy what the theta forms ask of T_4 and T_1.  A motion is given by the
nome, by b and by a factor, which make the modulus and the amplitudes of the momentum:

    k_1 = null_c^2/null_d^2,    B_d/(K + B_a) = b_s/b_n

Which nome and which b belong to a body is said by the readings: nome(1 - m_c) and g beta.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from sympy import Add, Expr, Function, Symbol

from derivations.attitude import MOMENTUM
from derivations.descended_form import DESCENT
from derivations.descended_form import MOMENTUM as SHORTEST
from derivations.hyperbolic_form import READING
from derivations.theta_edges import given
from derivations.theta_form import (
    CLASSICAL,
    COMPONENTS,
    FORM,
    SHIFT,
    B_a,
    B_d,
    C_b,
    K,
    R,
    Y,
    k_1,
    mu,
    rho,
)
from derivations.theta_form import c as cn
from derivations.theta_form import d as dn
from derivations.theta_form import s as sn
from derivations.theta_laws import (
    AT_B,
    AT_V,
    CIRCULAR,
    HYPERBOLIC,
    JACOBI,
    LAWS,
    NAMES,
    NULLS,
    SHIFTED,
    SLOPES,
    UNITS,
    Family,
    a,
    c,
    g,
    prove,
    u,
    v,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.steps._names import expressions, symbols

_, null_c, null_d, null_n = NULLS
b_s, b_c, b_d, b_n = AT_B
v_s, _, _, v_n = AT_V
dv_s, _, _, dv_n = SLOPES
S_re, S_im, N_re, N_im, dN_re, dN_im = SHIFTED
K_factor, i_a, Delta, w, u_1, s_rate = symbols("K_factor i_a Delta w u_1 s_rate")
BODY = {
    K: K_factor * (b_n**2 + b_s**2),
    B_a: K_factor * (b_n**2 - b_s**2),
    B_d: 2 * K_factor * b_s * b_n,
    Y: 2 * K_factor * b_n * b_c * null_n / null_d,
    C_b: 2 * K_factor * b_c * b_d * (null_n / null_d) ** 2,
}
SHIFTED_TIME = {
    "v": g * u_1,
    "T4_re": N_re,
    "T4_im": rho * N_im,
    "T1_re": S_re,
    "T1_im": rho * S_im,
    s_rate: mu * g * null_d * (dv_s * v_n - v_s * dv_n) / (null_c * v_n**2),
}
# What theta functions satisfy by their laws.
SHOWN = (
    *SHIFT.relations,
    *DESCENT.relations,
    *(K**2 - B_a**2 - B_d**2, cn**2 + sn**2 - 1, dn**2 + k_1**2 * sn**2 - 1),
)
# The factors of what the theta form divides by.
SIDES = (null_c**2 * b_n**2 + null_d**2 * b_s**2, null_d**2 * b_n**2 + null_c**2 * b_s**2)
ACROSS = rho * Delta * (b_s * b_n * (null_c**2 + null_d**2)) ** 2
DIVISORS = (
    *(i_a, i_a + rho * Delta, Delta, rho, w, R, K_factor, b_s, b_c, b_d),
    *(b_n**2 + b_s**2, b_n**2 - b_s**2, null_c**2 + null_d**2, v_n**2 + v_s**2, *SIDES),
    *(i_a * SIDES[0] * SIDES[1] + ACROSS, i_a * (b_c * b_d * null_n**2) ** 2 + ACROSS),
)
RATES = {
    **{name: mu * g * slope for name, slope in zip(AT_V, SLOPES, strict=True)},
    "N_re": mu * g * dN_re,
    "N_im": mu * g * dN_im,
    **dict.fromkeys([*SLOPES, "S_re", "S_im", "dN_re", "dN_im", "W_v"], "?"),
    R: mu * g * (N_re * dN_re + N_im * dN_im) / R,
    # as in `descended_form`, D(s) for mu c d
    w: expressions(SHORTEST.rates)[w].subs(mu * cn * dn, s_rate),
}
WITNESS = {
    **{"b": "0", "K_factor": "1", "W_v": "1", "W_b": "1"},
    **dict.fromkeys(NAMES, "1"),
    **{"null_d": "2", "b_n": "4", "b_s": "3", "v_s": "0", "N_im": "0"},
}
READINGS = {"K_factor": "K/(b_n**2 + b_s**2)", "b": "g*beta", "v": "the argument of thetas"}


theta: list[Any] = [Function(f"theta{k}") for k in range(5)]
nome_m, nome_c = symbols("nome_m nome_c")
W_v, W_b = symbols("W_v W_b")


@dataclass(frozen=True, slots=True)
class Norm:
    """W as a product of two thetas, by Watson's identity (DLMF 20.7.13 and 20.7.14).

    `product` is the sum of n n and s s at a + c and a - c, for all a and c.
    """

    family: Family
    declared: Mapping[str, str]
    form: Expr
    product: Expr
    at: Mapping[Symbol, Symbol]

    @property
    def squares(self) -> Expr:
        """The sum of the products of two functions."""
        return Add(*(self.family.of(x, a + c) * self.family.of(x, a - c) for x in "ns"))


NORMS = {
    "theta_functions": Norm(
        CIRCULAR,
        {"W_v": "re(theta4(v, nome_m))", "W_b": "re(theta3(I*b, nome_m))"},
        W_v * W_b,
        theta[4](a, nome_m) * theta[3](c, nome_m),
        {a: v, c: u},
    ),
    "hyperbolic_functions": Norm(
        HYPERBOLIC,
        {"W_v": "re(theta2(2*I*v, nome_c**2))", "W_b": "re(theta3(2*b, nome_c**2))"},
        2 * W_v * W_b,
        2 * theta[2](2 * c, nome_c**2) * theta[3](2 * a, nome_c**2),
        {a: u, c: v},
    ),
}


def derive(builder: LedgerBuilder) -> None:
    """Prove the norm in the squared nome of m, and in the complementary nome."""
    for context, norm in NORMS.items():
        here = _motion(builder, context, norm)
        prove(builder, context, norm.family)
        squares = norm.family.named(norm.squares, norm.at)
        identity = str(norm.squares - norm.product)
        builder.theta(f"{context}.norm", {"W": squares}, identity, norm.family.texts(norm.at))
        here.model("theta_form", *LAWS, "norm")
        momentum = (f"{name}_of_attitude" for name in MOMENTUM)
        here.carry("theta_form", "solution", "N_of_W", *COMPONENTS, *momentum)


def _motion(builder: LedgerBuilder, context: str, norm: Norm) -> Proofs:
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
        ("w",),
        definitions={**BODY, **SHIFTED_TIME, "W": norm.form},
        rates=RATES,
        reading=READINGS,
    )
    reading = READING if norm.family is HYPERBOLIC else Part()
    parts = given((*FORM, CLASSICAL), values, SHOWN)
    return Proofs.open(builder, context, functions, *parts, made, reading)
