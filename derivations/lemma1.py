"""Lemma 1: one rate by itself, from Euler's equations to (10), (12), (13), (14) and (17).

(i, j, k) is any cyclic order of the axes, so each claim stands for all three.  With H and K in the
place of the other two rates, the square of Omega_i' is a quadratic in Omega_i^2; its coefficients
are read off (14), its roots (13) need no square root.  An ansatz zeta sn(xi t + C | mu) matches it
in two ways: one is (10), the other (11).
"""

from dataclasses import dataclass, replace
from typing import Any

import sympy

from derivations.euler_lax import MOMENTA, RATES, Dynamics, H, K_squared
from derivations.gyrostat import gyrostat
from derivations.lie_algebra import Algebra
from derivations.setting import MOMENTS as NUMBERED
from derivations.symmetric import symmetric
from rigidsym.language.functions._jacobi import jacobi_sn
from rigidsym.proof.algebra import LedgerBuilder, Part, jacobi, named
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
from rigidsym.proof.steps._names import expressions, symbols

MOMENTS = c_i, c_j, c_k = symbols("c_i c_j c_k")
INERTIA = Part(
    {f"c_{x}": f"moment of inertia about axis {x}, kg m^2" for x in "ijk"}, units=MOMENTS
)
FUNCTIONS_OF_JACOBI = "equations that sn, cn and dn are the solutions of (DLMF 22.13)"
RATE, *OTHERS = symbols("Omega_i Omega_j Omega_k")
alpha, beta, chi, zeta, xi, mu, t, C_i = symbols("alpha beta chi zeta xi mu t C_i")
s_i, s_j, root_j, root_k, root_s, sn, cn, dn, w = symbols("s_i s_j root_j root_k root_s sn cn dn w")
# s_i = zeta^2 and s_j are the roots, xi = sqrt(alpha s_j).
SINE = Part(
    (zeta, s_j, xi, c_i, alpha),
    units=(s_j, c_i),
    definitions={s_i: zeta**2},
    relations=("xi**2 - alpha*s_j",),
    reading={zeta: sympy.sqrt(s_i), xi: "sqrt(alpha*s_j)", s_j: "the root that is not s_i"},
)
SN = jacobi_sn(xi * t + C_i, mu)
# dn^2 = 1 - mu sn^2 has the fraction mu = s_i/s_j: w = sqrt(s_j) dn keeps it polynomial.
SCALED = Part(
    (sn, cn, w, root_s),
    units=(root_s,),
    definitions={dn: w / root_s},
    relations=("cn**2 + sn**2 - 1", "root_s**2 - s_j", "w**2 + s_i*sn**2 - s_j"),
    rates={sn: xi * cn * dn, cn: -xi * sn * dn, w: "-xi*s_i/root_s*sn*cn"},
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
    fact, square, name = "eliminated.square", scope.rate(RATE) ** 2, rate_of(RATE) ** 2
    gaps, others = _invariants(moving), [other**2 for other in OTHERS]
    why = "the square of a rate's rate, two rates eliminated by H and K"
    found = eliminate(scope, fact, square, gaps, others, why, [14, 17], name)
    texts = map(scope.text, found.found.apply(coefficients, RATE**2))
    quartic = Part(definitions=named((alpha, beta, chi), texts))
    scope = Scope.open(builder, "axis", INERTIA, moving, quartic)
    polynomial = sympy.Poly.from_list([*quartic.definitions], RATE**2).as_expr()
    why = "a quadratic in the square of the rate"
    law = "the same as `eliminated.square`, with names for its coefficients"
    rewrite(scope, "quartic", name, polynomial, why, [14], law=law)
    there = Scope(builder, builder.ledger.contexts["eliminated"], {})
    factored = _roots(there, found.value)
    _distinct(builder, moving, quartic, factored)
    builder.keep(Lemma1(moving, quartic, factored, *_matched(builder)))
    _reciprocal(builder)


def _on_axes(builder: LedgerBuilder) -> Part:
    """Open the body of `euler_lax` with its axes called i, j, k."""
    body = builder.result(Dynamics).body
    axes = named((*NUMBERED, *RATES), (*MOMENTS, RATE, *OTHERS))
    known = expressions({**body.definitions, **body.rates})
    known = {name: side.xreplace(axes) for name, side in known.items()}
    momenta = {m: known[m] for m in MOMENTA}
    return Part(
        (RATE, *OTHERS),
        definitions={
            H: known[H].factor(),
            K_squared: known[K_squared].subs(momenta),
            "delta_i": known[RATES[0]] / OTHERS[0] / OTHERS[1],
        },
        rates={axes[w]: known[w] for w in RATES},
    )


def _invariants(moving: Part) -> list[sympy.Expr]:
    """Return 2 H and K^2 less their expressions in the rates."""
    known = plain(moving.definitions)
    return [2 * (H - known[H]), K_squared - known[K_squared]]


def _roots(scope: Scope, polynomial: sympy.Expr) -> Part:
    """Prove (13): both roots in Omega_i^2, each with one of the other moments."""
    why = "its roots, where no other moment is that of the axis"
    found = roots(scope, "factored.roots", polynomial, RATE**2, why, [13])
    with_other = {
        root: next(r for r in found.found if c in r.free_symbols)
        for root, c in ((root_j, c_j), (root_k, c_k))
    }
    return Part(
        units=tuple(map(scope.text, found.conditions)),
        definitions={root: scope.text(value) for root, value in with_other.items()},
        reading={root_j: "one root in Omega_i^2", root_k: "the other root in Omega_i^2"},
    )


def _distinct(builder: LedgerBuilder, *axis: Part) -> None:
    """Prove that the discriminant under the root of (13) is a square."""
    scope = Scope.open(builder, "distinct_axis", INERTIA, *axis)
    by_roots = {beta: -alpha * (root_j + root_k), chi: alpha * root_j * root_k}
    discriminant = beta**2 - 4 * alpha * chi
    square = compute(discriminant).subs(by_roots).factor()
    why = "what is under the root of (13) is a square"
    rewrite(scope, "discriminant", discriminant, square, why, [13])


def _matched(builder: LedgerBuilder) -> tuple[Computation, Computation]:
    """Prove zeta sn(xi t + C | mu) for either root as zeta^2; then (10), (16) and (12).

    Return the quadratic and mu.
    """
    zeta_squared, xi_squared, v = symbols("zeta_squared xi_squared v")
    gap = Part(
        (alpha, s_i, s_j, v),
        units=(s_i, s_j),
        reading={s_i: "a root in Omega_i^2", s_j: "the other one", v: "the square of sn"},
    )
    scope = Scope.open(builder, "matched", gap, static=True)
    speed = zeta_squared * xi_squared * (1 - v) * (1 - mu * v)
    quadratic = alpha * (s_i - zeta_squared * v) * (s_j - zeta_squared * v)
    why = "zeta sn(xi t + C) put in, coefficients compared: two choices"
    unknown = (zeta_squared, xi_squared, mu)
    both = match(scope, "amplitude", speed, quadratic, v, unknown, why, [10, 11, "Lemma 1"])
    first = both.found[0]
    scale = replace(SINE, relations=(f"xi**2 - ({scope.text(first[xi_squared])})",))
    body = (scale, Part(definitions={mu: scope.text(first[mu])}), SCALED)
    by_rate = compute(quadratic).subs(v, RATE**2 / zeta_squared)
    rotating = Part(definitions={RATE: zeta * sn, "quartic": by_rate})
    scope = Scope.open(builder, "sine", *body, rotating)
    squared = rate_of(RATE) ** 2
    why = "the first choice of the two solves it"
    rewrite(scope, "solves", squared, by_rate, why, [10])
    differentiate(scope, "slope", RATE, "its slope", [16])
    scope = Scope.open(builder, "initial", *body, rotating, Part(units=(zeta,)))
    value = compute(RATE - zeta * SN).solve_for(SN)
    rewrite(scope, "value", SN, value, "where it starts", [12], "solve")
    return by_rate, first[mu]


def _reciprocal(builder: LedgerBuilder) -> None:
    """Prove the reciprocal modulus: sqrt(mu) sn, dn, cn are sn, cn, dn of (sqrt(mu) u | 1/mu)."""
    S, C, E, root, nu = symbols("S C E sqrt_mu nu")
    modulus = Part(
        (root, nu), (root,), definitions={mu: root**2}, reading={nu: "rate of the argument u"}
    )
    functions = jacobi("sn", "cn", "dn", "u", "sqrt_mu**2", "nu")
    other = {S: root * sn, C: dn, E: cn}
    scope = Scope.open(builder, "reciprocal", modulus, functions, Part(definitions=other))
    back: Any = named(map(scope.dictionary.meant, (sn, dn, cn)), (S / root, C, E))
    source, why = ["footnote 1", 11], "footnote 1: both sides have the same derivatives"
    for name, form in other.items():
        value = compute(scope.dictionary.meant(form)).apply(scope.rate).subs(back)
        rewrite(scope, f"rate_{name}", rate_of(name), value, why, source, "differentiate")
    why = "and are on the same curves"
    for fact, curve in (("circle", C**2 + S**2), ("parameter", E**2 + S**2 / mu)):
        rewrite(scope, fact, curve, sympy.S.One, why, source, law=FUNCTIONS_OF_JACOBI)
