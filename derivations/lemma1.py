"""Lemma 1: one rate by itself, from Euler's equations to (10), (12), (13), (14) and (17).

(i, j, k) is any cyclic order of the axes, so each claim stands for all three.  With H and K in the
place of the other two rates, the square of Omega_i' is a quadratic in Omega_i^2; its coefficients
are read off (14), its roots (13) need no square root.  An ansatz zeta sn(xi t + C | mu) matches it
in two ways: one is (10), the other (11).
"""

from dataclasses import dataclass, replace
from typing import Any

import sympy

from derivations.euler_lax import Dynamics
from derivations.gyrostat import gyrostat
from derivations.lie_algebra import Algebra
from derivations.symmetric import symmetric
from rigidsym.language.functions._jacobi import jacobi_sn
from rigidsym.proof.algebra import LedgerBuilder, Part, jacobi
from rigidsym.proof.algebra._computation import Computation, compute, plain
from rigidsym.proof.steps import (
    Scope,
    coefficients,
    differentiate,
    eliminate,
    match,
    rate_of,
    rewrite,
    roots,
)
from rigidsym.proof.steps._names import read, symbol, symbols

INERTIA = Part(
    ("c_i", "c_j", "c_k"),
    units=("c_i", "c_j", "c_k"),
    reading={f"c_{x}": f"moment of inertia about axis {x}, kg m^2" for x in "ijk"},
)
MOMENTS = symbols("c_i c_j c_k")
FUNCTIONS_OF_JACOBI = "equations that sn, cn and dn are the solutions of (DLMF 22.13)"
RATE, *OTHERS = symbols("Omega_i Omega_j Omega_k")
H, K_SQUARED = symbols("H K_squared")
# s_i = zeta^2 and s_j are the roots, xi = sqrt(alpha s_j).
SINE = Part(
    ("zeta", "s_j", "xi", "c_i", "alpha"),
    units=("s_j", "c_i"),
    definitions={"s_i": "zeta**2"},
    relations=("xi**2 - alpha*s_j",),
    reading={"zeta": "sqrt(s_i)", "xi": "sqrt(alpha*s_j)", "s_j": "the root that is not s_i"},
)
SN = jacobi_sn(symbol("xi") * symbol("t") + symbol("C_i"), symbol("mu"))
# dn^2 = 1 - mu sn^2 has the fraction mu = s_i/s_j: w = sqrt(s_j) dn keeps it polynomial.
SCALED = Part(
    ("sn", "cn", "w", "root_s"),
    units=("root_s",),
    definitions={"dn": "w/root_s"},
    relations=("cn**2 + sn**2 - 1", "root_s**2 - s_j", "w**2 + s_i*sn**2 - s_j"),
    rates={"sn": "xi*cn*dn", "cn": "-xi*sn*dn", "w": "-xi*s_i/root_s*sn*cn"},
    reading=jacobi("sn", "cn", "dn", "xi*t + C_i", "mu", "xi").reading,
)


@dataclass(frozen=True, slots=True)
class Lemma1:
    """Results of this chapter: a body on axes i, j, k, the quadratic of a rate, and its roots.

    `quadratic` is the square of a rate's rate by its roots s_i and s_j, and `parameter` is mu where
    zeta^2 is s_i.
    """

    moving: Part
    quartic: Part
    roots: Part
    quadratic: Computation
    parameter: Computation


def derive(builder: LedgerBuilder) -> None:
    """Prove (17), (14), (13), (10), (11), (16), (12), footnote 1; or what
    replaces them with wheels, in general axes and for equal moments."""
    setting = builder.result(Algebra).setting
    if any(h != 0 for h in setting.wheel()) or not setting.about_principal_axes:
        gyrostat(builder)
        return
    if setting.symmetry_axis is not None:
        symmetric(builder, setting.symmetry_axis)
        return
    moving = _on_axes(builder)
    scope = Scope.open(builder, "polhode", INERTIA, moving)
    rate, squared = scope.rate(RATE), rate_of(RATE) ** 2
    squares = [other**2 for other in OTHERS]
    why = "the square of a rate's rate, two rates eliminated by H and K"
    found = eliminate(
        scope,
        "eliminated.square",
        rate**2,
        _invariants(moving),
        squares,
        why,
        [14, 17],
        squared,
    )
    names = ("alpha", "beta", "chi")
    texts = map(scope.text, found.found.apply(coefficients, RATE**2))
    quartic = Part(definitions=dict(zip(names, texts, strict=True)))
    scope = Scope.open(builder, "axis", INERTIA, moving, quartic)
    alpha, beta, chi = map(symbol, quartic.definitions)
    polynomial = alpha * RATE**4 + beta * RATE**2 + chi
    why = "a quadratic in the square of the rate"
    named = "the same as `eliminated.square`, with names for its coefficients"
    rewrite(scope, "axis.quartic", squared, polynomial, why, [14], law=named)
    there = Scope(builder, builder.ledger.contexts["eliminated"], {})
    factored = _roots(there, found.value)
    _distinct(builder, moving, quartic, factored)
    builder.keep(Lemma1(moving, quartic, factored, *_matched(builder)))
    _reciprocal(builder)


def _on_axes(builder: LedgerBuilder) -> Part:
    """Open the body of `euler_lax` with its axes called i, j, k."""
    body = builder.result(Dynamics).body
    numbered, lettered = symbols("c1 c2 c3 Omega1 Omega2 Omega3"), (*MOMENTS, RATE, *OTHERS)
    axes = dict(zip(numbered, lettered, strict=True))
    known = {
        name: compute(read(side)).xreplace(axes)
        for name, side in {**body.definitions, **body.rates}.items()
    }
    momenta = {symbol(f"M{k}"): known[f"M{k}"] for k in (1, 2, 3)}
    return Part(
        lettered[3:],
        definitions={
            H: known["H"].factor(),
            K_SQUARED: known["K_squared"].subs(momenta),
            "delta_i": known["Omega1"] / OTHERS[0] / OTHERS[1],
        },
        rates={axes[symbol(name)]: known[name] for name in body.rates},
    )


def _invariants(moving: Part) -> list[sympy.Expr]:
    """Return 2 H and K^2 less their expressions in the rates."""
    known = plain(moving.definitions)
    return [2 * (H - known[H]), K_SQUARED - known[K_SQUARED]]


def _roots(scope: Scope, polynomial: sympy.Expr) -> Part:
    """Prove (13): both roots in Omega_i^2, each with one of the other moments."""
    why = "its roots, where no other moment is that of the axis"
    found = roots(scope, "factored.roots", polynomial, RATE**2, why, [13])
    named = {
        f"root_{x}": next(r for r in found.found if symbol(f"c_{x}") in r.free_symbols)
        for x in "jk"
    }
    return Part(
        units=tuple(map(scope.text, found.conditions)),
        definitions={name: scope.text(value) for name, value in named.items()},
        reading={"root_j": "one root in Omega_i^2", "root_k": "the other root in Omega_i^2"},
    )


def _distinct(builder: LedgerBuilder, *axis: Part) -> None:
    """Prove that the discriminant under the root of (13) is a square."""
    scope = Scope.open(builder, "distinct_axis", INERTIA, *axis)
    alpha, beta, chi, one, two = symbols("alpha beta chi root_j root_k")
    by_roots = {beta: -alpha * (one + two), chi: alpha * one * two}
    discriminant = beta**2 - 4 * alpha * chi
    square = compute(discriminant).subs(by_roots).factor()
    why = "what is under the root of (13) is a square"
    rewrite(scope, "distinct_axis.discriminant", discriminant, square, why, [13])


def _matched(builder: LedgerBuilder) -> tuple[Computation, Computation]:
    """Prove zeta sn(xi t + C | mu) for either root as zeta^2; then (10), (16) and (12).

    Return the quadratic and mu.
    """
    gap = Part(
        ("alpha", "s_i", "s_j", "v"),
        units=("s_i", "s_j"),
        reading={"s_i": "a root in Omega_i^2", "s_j": "the other one", "v": "the square of sn"},
    )
    scope = Scope.open(builder, "matched", gap, static=True)
    zeta, xi, mu = symbols("zeta_squared xi_squared mu")
    alpha, s_i, s_j, v = symbols("alpha s_i s_j v")
    speed = zeta * xi * (1 - v) * (1 - mu * v)
    quadratic = alpha * (s_i - zeta * v) * (s_j - zeta * v)
    why = "zeta sn(xi t + C) put in, coefficients compared: two choices"
    unknown = (zeta, xi, mu)
    both = match(scope, "matched.amplitude", speed, quadratic, v, unknown, why, [10, 11, "Lemma 1"])
    first = both.found[0]
    scale = replace(SINE, relations=(f"xi**2 - ({scope.text(first[xi])})",))
    body = (scale, Part(definitions={"mu": scope.text(first[mu])}), SCALED)
    by_rate = compute(quadratic).subs(v, RATE**2 / zeta)
    rotating = Part(definitions={"Omega_i": "zeta*sn", "quartic": by_rate})
    scope = Scope.open(builder, "sine", *body, rotating)
    squared = rate_of(RATE) ** 2
    why = "the first choice of the two solves it"
    rewrite(scope, "sine.solves", squared, by_rate, why, [10])
    differentiate(scope, "sine.slope", RATE, "its slope", [16])
    scope = Scope.open(builder, "initial", *body, rotating, Part(units=("zeta",)))
    value = compute(RATE - symbol("zeta") * SN).solve_for(SN)
    rewrite(scope, "initial.value", SN, value, "where it starts", [12], "solve")
    return by_rate, first[mu]


def _reciprocal(builder: LedgerBuilder) -> None:
    """Prove the reciprocal modulus: sqrt(mu) sn, dn, cn are sn, cn, dn of (sqrt(mu) u | 1/mu)."""
    modulus = Part(
        ("sqrt_mu", "nu"),
        units=("sqrt_mu",),
        definitions={"mu": "sqrt_mu**2"},
        reading={"nu": "rate of the argument u"},
    )
    functions = jacobi("sn", "cn", "dn", "u", "sqrt_mu**2", "nu")
    other = Part(definitions={"S": "sqrt_mu*sn", "C": "dn", "E": "cn"})
    scope = Scope.open(builder, "reciprocal", modulus, functions, other)
    S, C, E, root, mu = symbols("S C E sqrt_mu mu")
    back: Any = dict(zip(map(scope.read, ("sn", "dn", "cn")), (S / root, C, E), strict=True))
    for name in (S, C, E):
        value = compute(scope.read(other.definitions[str(name)])).apply(scope.rate).subs(back)
        slope = rate_of(name)
        why = "footnote 1: both sides have the same derivatives"
        rewrite(
            scope,
            f"reciprocal.rate_{name}",
            slope,
            value,
            why,
            ["footnote 1", 11],
            "differentiate",
        )
    for fact, one in (("circle", C**2 + S**2), ("parameter", E**2 + S**2 / mu)):
        why = "and are on the same curves"
        source = ["footnote 1", 11]
        rewrite(scope, f"reciprocal.{fact}", one, sympy.S.One, why, source, law=FUNCTIONS_OF_JACOBI)
