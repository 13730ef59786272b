"""Sensitivities of the rates: derivatives by the rates at t = 0 and the moments of inertia.

A change of the rates at t = 0 and of the moments is written d; it is the derivative by a parameter
on which all of them depend.  In `perturbed` D is that derivative: the change of each
quantity of the addition form follows by the chain rule.  In `varied` D is the time derivative
again, and the changes satisfy the variation of Euler's equations.  They need those of S_t, C_t and
D_t with p and r, which are elementary in the functions and two integrals, of S_t^2 and S_t^2/D_t^2:
on the separatrix, where p = r, and where both vanish, as everywhere else.
"""

from collections.abc import Mapping
from typing import TypeAlias

import sympy

from derivations.addition_form import (
    COEFFICIENTS,
    EULER,
    FORCES,
    FUNCTIONS,
    GIVEN,
    OTHERS,
    OVER_SQUARE,
    RATES,
    SQUARED,
    START,
    TIME,
)
from derivations.attitude import HANDEDNESS, INERTIA
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.steps._names import Dictionary, read, symbol

Texts: TypeAlias = dict[str, str]

MOVED = (*GIVEN.witness, *FORCES, *FUNCTIONS.witness)
# The variation of S_t' = C_t D_t and the other two, and of the relations between them.
VARIED_FUNCTIONS = Part(
    witness={"dS_t": "0", "dC_t": "0", "dD_t": "0"},
    relations=("2*C_t*dC_t + dp*S_t**2 + 2*p*S_t*dS_t", "2*D_t*dD_t + dr*S_t**2 + 2*r*S_t*dS_t"),
    rates={
        "dS_t": "dC_t*D_t + C_t*dD_t",
        "dC_t": "-dp*S_t*D_t - p*dS_t*D_t - p*S_t*dD_t",
        "dD_t": "-dr*S_t*C_t - r*dS_t*C_t - r*S_t*dC_t",
    },
    reading={f"d{x}": f"the change of {x}" for x in FUNCTIONS.witness},
)
MODULI = Part(witness={"p": "2", "r": "1"}, reading={"p": "lambda^2", "r": "m lambda^2"})
PARAMETERS = Part(
    witness={**MODULI.witness, "dp": "1", "dr": "1"},
    reading={**MODULI.reading, "dp": "a change of p", "dr": "a change of r"},
)
# What S_t, C_t and D_t change by, in every case: nothing divides by p, r or p - r.
REGULAR = Part(
    definitions={
        "dS_t": "-((dr - dp)*C_t*D_t*F_t + dp*(S_t**3 - C_t*D_t*E_t))/2",
        "dC_t": "((dr - dp)*p*S_t*D_t*F_t - dp*S_t*(S_t*C_t + p*D_t*E_t))/2",
        "dD_t": "((dr - dp)*(r*S_t*C_t*F_t - S_t**2/D_t) - dp*S_t*(S_t*D_t + r*C_t*E_t))/2",
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the changes of the rates, and of the functions in them."""
    changes = _changes({**GIVEN.definitions, **RATES.definitions})
    _perturbed(builder, changes)
    _moving(builder, changes)
    _functions(builder)


def _changes(definitions: Mapping[str, str]) -> Texts:
    """Return the change of each definition by the chain rule."""
    texts = Dictionary(join("changes", GIVEN, static=True)).text
    return {f"d{name}": texts(_change(name, text)) for name, text in definitions.items()}


def _change(name: str, text: str) -> sympy.Expr:
    """Return the change of an expression; that of N/d is (dN - (N/d) dd)/d."""
    above, below = sympy.fraction(read(text))
    found = change_of(above)
    return found if below == 1 else (found - symbol(name) * change_of(below)) / below


def change_of(expression: sympy.Expr) -> sympy.Expr:
    """Return the change of an expression by the chain rule; the handedness is constant."""
    names = sorted(expression.free_symbols - {symbol("epsilon")}, key=str)
    return sympy.Add(*(sympy.diff(expression, x) * symbol(f"d{x}") for x in names))


def _perturbed(builder: LedgerBuilder, changes: Texts) -> None:
    """Prove that the changes are derivatives by a parameter D."""
    small = Part(
        witness={f"d{name}": "1" for name in MOVED},
        rates={name: f"d{name}" for name in MOVED},
        definitions=changes,
        reading={f"d{name}": f"the change of {name}" for name in MOVED},
    )
    still = Part(FUNCTIONS.witness, reading=FUNCTIONS.reading)
    builder.open(join("perturbed", COEFFICIENTS, GIVEN, still, RATES, small))
    builder.claim("perturbed.changes", {f"D({name[1:]})": name for name in changes}, ["5"])
    moments = Part(
        witness={f"d{c}": "1" for c in INERTIA.witness},
        rates={c: f"d{c}" for c in INERTIA.witness},
        definitions={**FORCES, **_changes(FORCES)},
    )
    builder.open(join("perturbed_moments", HANDEDNESS, INERTIA, moments))
    by_moments = {f"D({name})": f"d{name}" for name in FORCES}
    builder.claim("perturbed_moments.changes", by_moments, ["5"])


def _moving(builder: LedgerBuilder, changes: Texts) -> None:
    """Prove that the changes satisfy the variation of Euler's equations in time."""
    constant = Part(
        witness={f"d{name}": "1" for name in (*GIVEN.witness, *FORCES)}, definitions=changes
    )
    parts = (COEFFICIENTS, GIVEN, FUNCTIONS, RATES, constant)
    builder.open(join("varied", *parts, VARIED_FUNCTIONS))
    builder.claim("varied.euler", EULER, ["5"])
    varied = {
        f"D(dOmega_{x})": f"dalpha_{x}*Omega_{y}*Omega_{z}"
        f" + alpha_{x}*(dOmega_{y}*Omega_{z} + Omega_{y}*dOmega_{z})"
        for x, (y, z) in OTHERS.items()
    }
    builder.claim("varied.variation", varied, ["5"])
    still = [Part(part.witness, reading=part.reading) for part in (FUNCTIONS, VARIED_FUNCTIONS)]
    start = Part(relations=("S_t", "C_t - 1", "D_t - 1", *VARIED_FUNCTIONS.witness))
    parts = (COEFFICIENTS, GIVEN, *still, RATES, constant, start)
    builder.open(join("varied_start", *parts, static=True))
    builder.claim("varied_start.rates", {f"dOmega_{x}": f"dOmega_{x}0" for x in "abd"}, ["12"])


def _functions(builder: LedgerBuilder) -> None:
    """Prove that changes of S_t, C_t, D_t satisfy the varied equations and start at 0."""
    varied = {f"D({name})": rate for name, rate in VARIED_FUNCTIONS.rates.items()}
    relations = dict.fromkeys(VARIED_FUNCTIONS.relations, "0")
    parts = (FUNCTIONS, TIME, SQUARED, OVER_SQUARE)
    builder.open(join("varied_regular", PARAMETERS, *parts, REGULAR))
    builder.claim("varied_regular.variation", varied | relations, ["5", "10"])
    still = [Part(part.witness, part.units, reading=part.reading) for part in parts]
    start = Part(relations=(*START.relations, "F_t"))
    builder.open(join("varied_regular_start", PARAMETERS, *still, REGULAR, start, static=True))
    begun = dict.fromkeys(VARIED_FUNCTIONS.witness, "0")
    builder.claim("varied_regular_start.functions", begun, ["12"])
