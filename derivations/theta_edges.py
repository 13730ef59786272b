"""The edges of the theta forms, elementary and without assumptions: k_1 = 1 and k_1 = 0.

On the separatrix the thetas of the complementary nome, divided by 2 q^(1/4), are

    T_4 = cos(z),    T_1 = -i sin(z),    z = rho beta + i u_1,

and there they are a model of the theta form.  On a symmetric body the shift is infinite, but with
h = 2 Y = B_d/(K + B_a), where r = 4, those of the theta form are

    T_4 = 1,    T_1 = h (sin(u_1) - i rho cos(u_1)),    Lambda = psi_0/2.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from derivations.attitude import MOMENTUM
from derivations.descended_form import MOTION
from derivations.theta_form import CLASSICAL, COMPONENTS, FORM, NORM, PHASE, TURNING
from rigidsym.proof.algebra import LedgerBuilder, Part, join

# What elementary values have to satisfy is shown, not assumed.
SHOWN = (
    "root_k**2 - k_1",
    "C_b**2 - (1 + k_1)**2*B_d**2 - 4*k_1*B_a**2",
    "R**2 - T4_re**2 - T4_im**2",
    "d**2 + (k_1**2)*s**2 - 1",
)
# x is tan(beta), and y and z are both sec(beta).
SEPARATRIX = Part(
    witness={"K": "25", "B_a": "7", "B_d": "24", "w": "40", "Y": "40", "root": "1"},
    definitions={
        "k_1": "1",
        "root_k": "1",
        "C_b": "2*K",
        "d": "c",
        "zeta": "x",
        "Z_u": "s",
        "T4_re": "1/(y*c)",
        "T4_im": "-rho*x*s/(y*c)",
        "R": "s_0*root/c",
    },
    relations=("root**2 - s**2 - 1",),
    rates={"root": "mu*s*c**2/root"},
    nonnegative=("c", "root"),
    reading={
        "s": "tanh(u_1)",
        "c": "1/cosh(u_1)",
        "beta": "arctan(x)",
        "root": "sqrt(1 + s**2)",
    },
)
HYPERBOLIC = {"T1_re": "s/(y*c)", "T1_im": "-rho*x/(y*c)", "W": "(1 + s**2)/c**2"}
SYMMETRIC = Part(
    definitions={
        "k_1": "0",
        "C_b": "B_d",
        "d": "1",
        "h": "B_d/(K + B_a)",
        "Lambda": "psi_0/2",
        "T4_re": "1",
        "T4_im": "0",
        "T1_re": "h*s",
        "T1_im": "-rho*h*c",
        "R": "1",
        **NORM,
    },
    nonnegative=("B_d",),
    reading={"s": "sin(u_1)", "c": "cos(u_1)"},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that both edges solve (3)."""
    divisors = Part(units=("c", "root"))
    parts = given((*FORM, CLASSICAL), SEPARATRIX.definitions, SHOWN)
    builder.open(join("separatrix_form", divisors, *parts, SEPARATRIX))
    for name, form in HYPERBOLIC.items():
        builder.claim(f"separatrix_form.{name}", {name: form}, ["18"])
    builder.model("separatrix_form", "theta_form")
    builder.carry("separatrix_form", [f"theta_form.{name}" for name in ("solution", *COMPONENTS)])
    parts = given((*MOTION, TURNING, PHASE), SYMMETRIC.definitions, SHOWN)
    builder.open(join("symmetric_form", *parts, SYMMETRIC))
    for name, form in COMPONENTS.items():
        builder.claim(f"symmetric_form.{name}", {name: form}, ["18", "25"])
    builder.root("symmetric_form.N_of_W", "N", "W", ["1"])
    builder.model("symmetric_form", "descended")
    carried = ("solution", *(f"{name}_of_attitude" for name in MOMENTUM))
    builder.carry("symmetric_form", [f"descended.{name}" for name in carried])


def given(parts: Iterable[Part], values: Iterable[str], shown: Iterable[str]) -> list[Part]:
    """Return parts with values for some generators, without the relations that these satisfy."""

    def rest(column: Mapping[str, str]) -> dict[str, str]:
        return {name: text for name, text in column.items() if name not in {*values}}

    return [
        replace(
            part,
            witness=rest(part.witness),
            rates=rest(part.rates),
            reading=rest(part.reading),
            relations=tuple(text for text in part.relations if text not in {*shown}),
        )
        for part in parts
    ]
