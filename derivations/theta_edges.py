"""The edges of the theta forms, elementary and without assumptions: k_1 = 1 and k_1 = 0.

On the separatrix the thetas of the complementary nome, divided by 2 q^(1/4), are

    T_4 = cos(z),    T_1 = -i sin(z),    z = rho beta + i u_1,

and there they are a model of the theta form.  On a symmetric body the shift is infinite, but with
h = 2 Y = B_d/(K + B_a), where r = 4, those of the theta form are

    T_4 = 1,    T_1 = h (sin(u_1) - i rho cos(u_1)),    Lambda = psi_0/2.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from sympy import Expr, I, cos, cosh, expand, sin, sinh

from derivations.attitude import MOMENTUM
from derivations.descended_form import MOTION
from derivations.theta_form import (
    ADDITION,
    CLASSICAL,
    COMPONENTS,
    FORM,
    NORM,
    NORM_OF_W,
    PHASE,
    SHIFT,
    TURNING,
    B_a,
    B_d,
    C_b,
    K,
    Lambda,
    R,
    T4_im,
    T4_re,
    W,
    Y,
    Z_u,
    c,
    d,
    k_1,
    mu,
    n,
    parts,
    psi_0,
    rho,
    root_k,
    s,
    s_0,
    whole,
    x,
    y,
    zeta,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs
from rigidsym.proof.algebra._computation import compute, plain
from rigidsym.proof.steps._names import read, symbols, unfold

root, h, beta, u_1 = symbols("root h beta u_1")
# What elementary values have to satisfy is shown, not assumed.
SHOWN = (
    root_k**2 - k_1,
    C_b**2 - (1 + k_1) ** 2 * B_d**2 - 4 * k_1 * B_a**2,
    R**2 - T4_re**2 - T4_im**2,
    d**2 + k_1**2 * s**2 - 1,
)
# x is tan(beta), and y and z are both sec(beta); s is tanh(u_1), and c and d are 1/cosh(u_1).
ELEMENTARY = {
    sin(rho * beta): rho * x / y,
    cos(rho * beta): 1 / y,
    sinh(u_1): s / c,
    cosh(u_1): 1 / c,
}
TURNED = rho * beta + I * u_1
T4 = parts("T4", compute(cos(TURNED)).expand(trig=True).subs(ELEMENTARY))
T1 = parts("T1", compute(-I * sin(TURNED)).expand(trig=True).subs(ELEMENTARY))
SQUARES = unfold(NORM[W], Part(definitions={**T4, **T1})).subs(rho**2, 1).subs(x**2, y**2 - 1)
HYPERBOLIC = {**T1, W: SQUARES.cancel()}
SEPARATRIX = Part(
    (K, B_a, B_d, "w", Y, root),
    definitions={
        k_1: 1,
        root_k: 1,
        C_b: 2 * K,
        d: c,
        zeta: x,
        Z_u: s,
        **T4,
        R: s_0 * root / c,
    },
    relations=(root**2 - s**2 - 1,),
    rates={root: mu * s * c**2 / root},
    nonnegative=(c, root),
    reading={
        "s": "tanh(u_1)",
        "c": "1/cosh(u_1)",
        "beta": "arctan(x)",
        "root": "sqrt(1 + s**2)",
    },
)
# Where k_1 is 0, so is n, and Y and C_b are B_d.
ROUND = {k_1: 0, n: 0, Y: B_d, C_b: B_d, d: 1}
QUOTIENT = unfold(root_k * whole("SN"), Part(definitions=ADDITION)).subs(n, 0)
SYMMETRIC = Part(
    definitions={
        **{name: ROUND[name] for name in (k_1, C_b, d)},
        h: B_d / (K + B_a),
        Lambda: psi_0 / 2,
        T4_re: 1,
        T4_im: 0,
        **parts("T1", unfold(QUOTIENT, SHIFT).subs(ROUND).subs(K + B_a, B_d / h)),
        R: 1,
        **NORM,
    },
    nonnegative=(B_d,),
    reading={"s": "sin(u_1)", "c": "cos(u_1)"},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that both edges solve (3)."""
    divisors = Part(units=(c, root))
    motion = given((*FORM, CLASSICAL), SEPARATRIX.definitions, SHOWN)
    here = Proofs.open(builder, "separatrix_form", divisors, *motion, SEPARATRIX)
    here.formulas(HYPERBOLIC, 18)
    here.model("theta_form")
    here.carry("theta_form", *("solution", *COMPONENTS))
    motion = given((*MOTION, TURNING, PHASE), SYMMETRIC.definitions, SHOWN)
    here = Proofs.open(builder, "symmetric_form", *motion, SYMMETRIC)
    here.formulas(COMPONENTS, 18, 25)
    here.root("N", NORM_OF_W, 1, fact="N_of_W")
    here.model("descended")
    carried = ("solution", *(f"{name}_of_attitude" for name in MOMENTUM))
    here.carry("descended", *carried)


def given(parts: Iterable[Part], values: Iterable[Any], shown: Iterable[Any]) -> list[Part]:
    """Return parts with values for some generators, without the relations that these satisfy."""

    def rest(column: Mapping[Any, Any]) -> dict[Any, Any]:
        return {name: side for name, side in column.items() if str(name) not in known}

    def relation(side: Any) -> Expr:
        return expand(read(side if isinstance(side, str) else str(plain(side))))

    known, satisfied = {*map(str, values)}, {*map(relation, shown)}
    return [
        replace(
            part,
            names=tuple(x for x in part.names if str(x) not in known),
            witness=rest(part.witness),
            rates=rest(part.rates),
            reading=rest(part.reading),
            relations=tuple(x for x in part.relations if relation(x) not in satisfied),
        )
        for part in parts
    ]
