"""The motion from any state, by functions of the elapsed time alone: addition theorems at work.

Let alpha be the coefficients of Euler's equations, Omega_a' = alpha_a Omega_b Omega_d and so on,
and S_t, C_t, D_t the functions of time with

    S_t' = C_t D_t,    C_t' = -p S_t D_t,    D_t' = -r S_t C_t,    starting at 0, 1, 1.

With p = lambda^2 and r = m lambda^2 they are sn(lambda t | m)/lambda, cn and dn; but p and r are
polynomials in the rates at t = 0, and nothing divides by a modulus, an amplitude or a difference of
moments.  So neither phase nor regime is asked for: symmetric bodies, the separatrix and constant
rates are points like others.  Axes a, b, d may be in any order; in that of the regular form, where
b is the middle one, 0 <= r <= p.  The integrals of Omega^2, which the attitude's changes need,
follow from that of S_t^2.
"""

from collections.abc import Iterable
from typing import Any

from sympy import Symbol

from derivations.attitude import EULER as RATES_OF_BODY
from derivations.attitude import HANDEDNESS, INERTIA, MOMENTS, OMEGA, Omega_a, Omega_b, Omega_d
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, jacobi, named
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import rate_of
from rigidsym.proof.steps._names import symbols

Omega_a0, Omega_b0, Omega_d0 = OMEGA_0 = symbols("Omega_a0 Omega_b0 Omega_d0")
alpha_a, alpha_b, alpha_d = ALPHA = symbols("alpha_a alpha_b alpha_d")
t, S_t, C_t, D_t, E_t, F_t, p, r = symbols("t S_t C_t D_t E_t F_t p r")
g_a, g_d, below, lambda_, m, sn, cn, dn = symbols("g_a g_d below lambda_ m sn cn dn")
A_a, A_d, S_0, C_0, D_0, I_a, I_b, I_d = symbols("A_a A_d S_0 C_0 D_0 I_a I_b I_d")
OTHERS = {"a": ("b", "d"), "b": ("d", "a"), "d": ("a", "b")}
FORCES = {
    str(alpha): (RATES_OF_BODY[w] * w / (Omega_a * Omega_b * Omega_d)).cancel().factor()
    for alpha, w in zip(ALPHA, OMEGA, strict=True)
}
EULER = {
    f"D({w})": (RATES_OF_BODY[w] * alpha / FORCES[str(alpha)])
    .cancel()
    .ordered(f"{alpha} Omega_{first} Omega_{second}")
    for w, alpha, (first, second) in zip(OMEGA, ALPHA, OTHERS.values(), strict=True)
}
MEANING = {f"alpha_{x}": f"the coefficient of Omega_{x}' in Euler's equations" for x in "abd"}

# From an instant where Omega_b = 0 the rates are A_a D_t, alpha_b A_a A_d S_t and A_d C_t; their
# equations say what p and r are.  g_a = alpha_a Omega_b^2 - alpha_b Omega_a^2 is constant, as g_d.
NODE = {Omega_a: A_a * D_t, Omega_b: alpha_b * A_a * A_d * S_t, Omega_d: A_d * C_t}
MODULI = {
    p: compute(alpha_d * Omega_a * Omega_b + A_d * p * S_t * D_t).subs(NODE).solve_for(p),
    r: compute(alpha_a * Omega_b * Omega_d + A_a * r * S_t * C_t).subs(NODE).solve_for(r),
}
SQUARED_AMPLITUDES = compute([g_a + alpha_b * A_a**2, g_d + alpha_b * A_d**2]).solve_for(
    A_a**2, A_d**2
)
# From any instant they go on by the addition theorems (DLMF 22.8.1 to 22.8.3).
ADDED = {
    Omega_a: A_a * (D_t * D_0 - r * S_t * S_0 * C_t * C_0),
    Omega_b: alpha_b * A_a * A_d * (S_t * C_0 * D_0 + S_0 * C_t * D_t),
    Omega_d: A_d * (C_t * C_0 - p * S_t * S_0 * D_t * D_0),
}
PHASE = {D_0: Omega_a0 / A_a, S_0: Omega_b0 / (alpha_b * A_a * A_d), C_0: Omega_d0 / A_d}

BODY = Part(definitions=FORCES, reading=MEANING)
# The same by themselves, whatever they are.
COEFFICIENTS = Part((alpha_a, alpha_b, alpha_d), reading=MEANING)
GIVEN = Part(
    (Omega_a0, Omega_b0, Omega_d0),
    definitions={
        g_a: alpha_a * Omega_b0**2 - alpha_b * Omega_a0**2,
        g_d: alpha_d * Omega_b0**2 - alpha_b * Omega_d0**2,
        **{name: form.subs(SQUARED_AMPLITUDES) for name, form in MODULI.items()},
    },
    reading={f"Omega_{x}0": f"body rate about axis {x} at t = 0, rad/s" for x in "abd"},
)
FUNCTIONS = Part(
    {
        S_t: "sn(lambda t | m)/lambda with p = lambda^2 and r = m lambda^2, or its limit",
        C_t: "cn(lambda t | m)",
        D_t: "dn(lambda t | m)",
    },
    relations=(C_t**2 + p * S_t**2 - 1, D_t**2 + r * S_t**2 - 1),
    rates={S_t: C_t * D_t, C_t: -p * S_t * D_t, D_t: -r * S_t * C_t},
)
TIME = Part({t: "time, s"}, rates={t: "1"})
SQUARED = Part(
    {E_t: "the integral of S_t^2 from 0 to t"},
    rates={E_t: S_t**2},
)
OVER_SQUARE = Part(
    {F_t: "the integral of S_t^2/D_t^2 from 0 to t"},
    units=(D_t,),
    rates={F_t: S_t**2 / D_t**2},
)
RATES = Part(
    units=(below,),
    definitions={
        below: compute(1 - p * r * S_t**2 * S_0**2).subs(MODULI).subs(PHASE),
        **{w: compute(x).subs(MODULI).subs(PHASE).expand() / below for w, x in ADDED.items()},
    },
)
# Where p is not zero they are Jacobi's.
BY_JACOBI = Part(
    {lambda_: "sqrt(p)", m: "r/p"},
    units=(lambda_,),
    definitions={p: lambda_**2, r: m * lambda_**2, S_t: sn / lambda_, C_t: cn, D_t: dn},
)
# The integrals of Omega_b^2, and of the others where b is not an axis of symmetry.
INTEGRALS = Part(
    units=(alpha_b,),
    definitions={
        I_b: g_a * g_d * E_t + Omega_b0 * Omega_b * S_t,
        I_a: Omega_a0**2 * t + alpha_a / alpha_b * (I_b - Omega_b0**2 * t),
        I_d: Omega_d0**2 * t + alpha_d / alpha_b * (I_b - Omega_b0**2 * t),
    },
)
INTEGRANDS = "an integral has its integrand as rate"
START = Part(relations=(t, S_t, C_t - 1, D_t - 1, E_t))


def _moment(n: int, rates: Iterable[Symbol]) -> Any:
    return sum(c**n * w**2 for c, w in zip(MOMENTS, rates, strict=True))


def derive(builder: LedgerBuilder) -> None:
    """Prove Euler's equations, the functions, the integrals of squared rates, and the start."""
    parts = (GIVEN, FUNCTIONS, TIME, SQUARED, RATES)
    here = Proofs.open(builder, "addition", HANDEDNESS, INERTIA, BODY, *parts)
    here.claim("euler", EULER, 5, 10)
    energy, size = (
        (_moment(1, OMEGA), _moment(1, OMEGA_0)),
        (_moment(2, OMEGA), _moment(2, OMEGA_0)),
    )
    law = "the energy and the square of the momentum stay what they are at t = 0"
    here.claim("invariants", [energy, size], 6, 15, law=law)
    here = Proofs.open(
        builder, "addition_by_jacobi", BY_JACOBI, jacobi("sn", "cn", "dn", "u", "m", "lambda_")
    )
    rates = {rate_of(name): rate for name, rate in FUNCTIONS.rates.items()}
    curves = dict.fromkeys(FUNCTIONS.relations, 0)
    law = "equations that S_t, C_t and D_t are the solutions of"
    here.claim("functions", rates | curves, 10, "DLMF 22.13", law=law)
    here = Proofs.open(builder, "addition_integrals", COEFFICIENTS, *parts, INTEGRALS)
    squares = named(map(rate_of, (I_a, I_b, I_d)), (w**2 for w in OMEGA))
    here.claim("squares", squares, 10, law=INTEGRANDS)
    still = [Part(part.names, reading=part.reading) for part in (FUNCTIONS, TIME, SQUARED)]
    parts = (COEFFICIENTS, GIVEN, *still, RATES, INTEGRALS, START)
    here = Proofs.open(builder, "addition_start", *parts, static=True)
    here.evaluate("rates", [*OMEGA, I_a, I_b, I_d], 12)
