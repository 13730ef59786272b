"""Changes of the integrals of the addition form: derivatives for bounds over a box.

E_t = int S_t^2 and F_t = int S_t^2/D_t^2 change along two directions, as S_t, C_t and D_t do: `_k`,
where p and r grow alike, and `_r`, where r does.  What that takes is the integrals of fourth powers

    U_t = int S_t^4,    V_t = int S_t^4/D_t^2,    W_t = int S_t^4/D_t^4,

which lie between 0 and the largest S_t^2, or S_t^2/D_t^2, times E_t or F_t, and are elementary in
them where p, r and p - r are not small.  Each integral is a combination of a few functions, whose
coefficients follow from its derivative.
"""

from typing import Any

from derivations.addition_form import FUNCTIONS, INTEGRANDS, START
from derivations.rate_sensitivities import (
    ALONG_K,
    ALONG_R,
    FUNCTION_PARTS,
    MODULI,
    MOVING,
    C,
    D,
    E,
    F,
    S,
    at_start,
    change,
    integral,
    moving,
    p,
    r,
    still,
)
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, named
from rigidsym.proof.steps._names import symbol, symbols

t, U, V, W = symbols("t U_t V_t W_t")
FOURTHS = Part(
    (U, V, W),
    rates={U: S**4, V: S**4 / D**2, W: S**4 / D**4},
    reading={
        U: "the integral of S_t^4 from 0 to t",
        V: "the integral of S_t^4/D_t^2 from 0 to t",
        W: "the integral of S_t^4/D_t^4 from 0 to t",
    },
)
RATES = {**MOVING, **moving(MODULI, FUNCTIONS, FOURTHS)}
# The directions, by what p and r change in them.
WAYS = {"k": {p: 1, r: 1}, "r": {r: 1}}


def _along(way: str) -> dict[str, Any]:
    """Return the changes of the functions and of both integrals in a direction."""
    functions = {"k": ALONG_K, "r": ALONG_R}[way]
    by = {**WAYS[way], **named((S, C, D), functions)}
    one, (inner, outer) = {"k": (E, (U, V)), "r": (F, (V, W))}[way]
    integrals = {
        E: integral(change(RATES[E], by), S**2 * one, inner, rates=RATES),
        F: integral(change(RATES[F], by), S**2 * one / D**2, outer, rates=RATES),
    }
    return {f"{str(x)[0]}_{way}": y for x, y in (by | integrals).items() if x not in (p, r)}


SLOPES = Part(definitions={**_along("k"), **_along("r")})
ELEMENTARY = Part(
    units=(p, r, p - r),
    definitions={
        U: integral(RATES[U], S * C * D, t, E),
        V: integral(RATES[V], F, E),
        W: integral(RATES[W], t, S * C / D**3, F),
    },
)


def derive(builder: LedgerBuilder) -> None:
    """Prove the changes along both directions, and the integrals of fourth powers."""
    here = Proofs.open(builder, "varied_integrals", MODULI, *FUNCTION_PARTS, FOURTHS, SLOPES)
    for way, grow in WAYS.items():
        by = {**grow, **{x: symbol(f"{str(x)[0]}_{way}") for x in (S, C, D)}}
        varied = {f"D({str(x)[0]}_{way})": change(RATES[x], by) for x in (S, C, D, E, F)}
        here.claim(f"along_{way}", varied, 10)
    here = Proofs.open(builder, "fourth_powers", MODULI, *FUNCTION_PARTS, ELEMENTARY)
    rates = {f"D({x})": RATES[x] for x in (U, V, W)}
    here.claim("rates", rates, 10, law=INTEGRANDS)
    _start(builder)


def _start(builder: LedgerBuilder) -> None:
    """Prove that all changes are zero at t = 0."""
    zero = Part(relations=(*START.relations, F))
    begun = Part(relations=(*zero.relations, U, V, W))
    parts = (MODULI, *still(*FUNCTION_PARTS, FOURTHS), SLOPES, begun)
    here = Proofs.open(builder, "varied_integrals_start", *parts, static=True)
    here.claim("functions", at_start(SLOPES), 12)
    parts = (MODULI, *still(*FUNCTION_PARTS), ELEMENTARY, zero)
    here = Proofs.open(builder, "fourth_powers_start", *parts, static=True)
    here.claim("integrals", at_start(ELEMENTARY), 12)
