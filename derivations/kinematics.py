"""From the kinematics to phi1: R^-1 R' solved for the rates of the angles, (30) to (33).

R^-1 R' = Omega is linear in the rates of the angles.  With the momentum in the place of phi2 and
phi3, phi1' is (32); with H and K in the place of two rates it is (33), a function of one rate.
Conversely, angles that move so carry a motion: R' = R Omega, and M' = [M, Omega].
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from derivations.conjugacy import MOMENTUM, PHI, TURNING, K, Reduction, by_angles
from derivations.conjugacy import PHI_RATES as UNKNOWN
from derivations.euler_lax import BODY_RATES, MOMENTA, RATES, Dynamics, H
from derivations.lie_algebra import MOMENTUM_MATRIX, VELOCITY, A, Algebra, M, Omega, R, commutator
from rigidsym.proof.algebra import LedgerBuilder, Part, named
from rigidsym.proof.algebra._computation import Computation
from rigidsym.proof.steps import Rate, Scope, coordinates, eliminate, multiply, rewrite, solve
from rigidsym.proof.steps._names import read

ANY_RATES = Part(BODY_RATES, rates=dict.fromkeys(RATES, "?"))


@dataclass(frozen=True, slots=True)
class Phi1:
    """Results of this chapter: phi1' by a rate, H and K, and by the angles, with divisors."""

    by_invariants: sympy.Expr
    by_angles: sympy.Expr
    divisors: tuple[sympy.Expr, ...]


def derive(builder: LedgerBuilder) -> None:
    """Prove R^-1 R', (30) to (33), and that all together is a motion."""
    reduction = builder.result(Reduction)
    parts = (MOMENTUM, TURNING, ANY_RATES, *reduction.angles)
    scope = Scope.open(builder, "turning", *parts, matrices=reduction.matrices)
    why = "the velocity in the body, multiplied out"
    velocity = coordinates(scope, "velocity", R.I * Rate(R), A, why, ["R^-1 dR/dt"])
    unknown = Part(UNKNOWN, reading=TURNING.reading)
    scope = Scope.open(builder, "velocity", ANY_RATES, unknown, *reduction.circles, static=True)
    equations = list(zip(RATES, velocity.value, strict=True))
    why = "R' = R Omega, solved for the rates of the angles"
    rates = solve(scope, "rates.angles", equations, UNKNOWN, why, [3, 30, 31])
    found = _phi1(builder, reduction, rates.found[UNKNOWN[0]])
    builder.keep(found)
    setting = builder.result(Algebra).setting
    along = setting.sequence[2] - 1
    why = "phi3' without a denominator"
    last = solve(scope, "phi3", [equations[along]], UNKNOWN[2:], why, [3])
    _motion(builder, reduction, found, rates[UNKNOWN[1]], last[UNKNOWN[2]])


def _phi1(builder: LedgerBuilder, reduction: Reduction, rate: Computation) -> Phi1:
    """Prove phi1' by the momentum, (32), and by H and K, (33)."""
    dynamics = builder.result(Dynamics)
    parts = (dynamics.parameters, MOMENTUM, *reduction.circles)
    base = Scope.open(
        builder, "on_momentum", *parts, by_angles(builder, reduction, *parts), static=True
    )
    momenta: Any = named(MOMENTA, dynamics.momenta)
    put_in: Any = {rate: base.read(base.context.definitions[str(rate)]) for rate in RATES}
    by_phi = rate.subs(put_in).apply(base.reduced)
    why = "phi1' with the momentum put in"
    units = Part(units=tuple(map(base.text, base.divisors(rate.value))))
    known = Part(definitions={UNKNOWN[0]: base.text(rate)})
    body = by_angles(builder, reduction, *parts)
    line = Scope.open(builder, "line32", *parts, units, body, known, static=True)
    rewrite(line, "by_angles", UNKNOWN[0], by_phi, why, [32], "substitute")
    by_momentum = _by_momentum(builder, reduction, rate)
    quotient = by_momentum.subs(momenta).apply(base.reduced)
    why = "phi1' with the momentum in the place of the angles"
    found = rewrite(line, "rate", UNKNOWN[0], quotient, why, [32], "substitute")
    if not found.value.has(*RATES):  # equal moments across the last axis
        return Phi1(found.value, by_phi.value, base.divisors(by_phi.value))
    setting = builder.result(Algebra).setting
    _, middle, third = (axis - 1 for axis in setting.axes)
    given, unknown = found.value, [RATES[middle] ** 2, RATES[third] ** 2]
    equations = [2 * H - 2 * read(dynamics.body.definitions[H]), K**2 - _square(dynamics.momenta)]
    why = "two rates eliminated by H and K"
    if not setting.about_principal_axes or setting.alike(middle + 1, third + 1):
        given, unknown = by_momentum.value, [MOMENTA[middle] * RATES[middle], MOMENTA[middle] ** 2]
        triples = zip(MOMENTA, setting.wheel(), RATES, strict=True)
        equations = [2 * H - sum((m - h) * w for m, h, w in triples), K**2 - _square(MOMENTA)]
        why = "the momentum across the last axis eliminated by H and K"
    eliminated = eliminate(line, "by_invariants", given, equations, unknown, why, [33], UNKNOWN[0])
    return Phi1(eliminated.value, by_phi.value, base.divisors(by_phi.value))


def _square(vector: Sequence[sympy.Expr]) -> sympy.Expr:
    return sympy.Add(*(x**2 for x in vector))


def _by_momentum(builder: LedgerBuilder, reduction: Reduction, rate: Computation) -> Computation:
    """Substitute phi3, and phi2 by the square of the momentum across the last axis, into phi1'."""
    setting = builder.result(Algebra).setting
    _, middle, third = (axis - 1 for axis in setting.axes)
    _, across = setting.nutation(PHI[1])
    last = [f(2 * setting.factor * PHI[2]) for f in (sympy.cos, sympy.sin)]
    gaps = [MOMENTA[k] - K * reduction.direction[k] for k in (middle, third)]
    angles = sympy.solve(gaps, last, dict=True)[0]
    square = (MOMENTA[middle] ** 2 + MOMENTA[third] ** 2) / K**2
    above, below = rate.subs(angles).together().apply(sympy.fraction)
    return (above / below.subs(across**2, square)).cancel()


def _motion(
    builder: LedgerBuilder, reduction: Reduction, found: Phi1, phi2: sympy.Expr, phi3: sympy.Expr
) -> None:
    """Prove that angles with these rates carry a solution of (3) and (5)."""
    dynamics = builder.result(Dynamics)
    parts = (dynamics.parameters, MOMENTUM, *reduction.angles)
    body = by_angles(builder, reduction, *parts)
    text = Scope(builder, builder.ledger.contexts["turning"], {}).text
    rates = Part(definitions=named(UNKNOWN, map(text, (found.by_angles, phi2, phi3))))
    matrices = {**reduction.matrices, **MOMENTUM_MATRIX, **VELOCITY}
    units = Part(units=tuple(map(text, found.divisors)))
    scope = Scope.open(builder, "three_angle_motion", *parts, units, body, rates, matrices=matrices)
    why = "angles that move so carry a motion"
    multiply(scope, "kinematics", Rate(R), R * Omega, why, [3, 25])
    why = "whose rates satisfy Euler's equations"
    multiply(scope, "euler", Rate(M), commutator(M, Omega), why, [5, 7])
