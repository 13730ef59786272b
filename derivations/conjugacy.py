"""Turning the momentum onto one axis: from R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1) to (29).

The momentum in space is constant, so there is an R with R M R^-1 = K A1.  Multiplied out,
K R^-1 A1 R does not see phi1: compared with M it gives phi2 and phi3, and no integration was
needed.  The axes of the turns, and the one that the momentum is turned onto, can be chosen.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy import ImmutableMatrix, MatrixExpr

from derivations.euler_lax import MOMENTA, RATES, Dynamics, H
from derivations.lie_algebra import MOMENTUM_MATRIX, A, Algebra, M, R
from derivations.setting import Setting
from rigidsym.proof.algebra import (
    LedgerBuilder,
    Part,
    circle,
    double_angle,
    half_angle,
    join,
    named,
)
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import (
    SIZE,
    Rate,
    Scope,
    coordinates,
    matrix,
    multiply,
    rewrite,
    solve,
)
from rigidsym.proof.steps._names import Dictionary, symbol, symbols

MOMENTUM = Part({"K": "|M|, kg m^2 rad/s"}, units=("K",))
K, PHI, PHI_RATES = symbol("K"), symbols("phi1 phi2 phi3"), symbols("phi1_rate phi2_rate phi3_rate")
TURNING = Part(
    {rate: f"d {phi}/dt, rad/s" for rate, phi in zip(PHI_RATES, PHI, strict=True)},
    rates=dict.fromkeys(PHI_RATES, "?"),
)
E1, E2, E3 = map(matrix, ("E1", "E2", "E3"))


@dataclass(frozen=True, slots=True)
class Reduction:
    """Results of this chapter: M = K * direction, with its matrices and angles.

    `angles` has half of each angle, or what exp(phi A) has; `circles` the whole phi2 and phi3.
    """

    direction: tuple[sympy.Expr, ...]
    momenta: tuple[sympy.Expr, ...]
    matrices: dict[str, ImmutableMatrix | MatrixExpr]
    angles: tuple[Part, ...]
    circles: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class Angles:
    """Results of this chapter: a function of phi2 and the tangent of phi3, by the rates.

    `by_momentum` has that function, and the cosine and sine of phi3.
    """

    along: Computation
    tangent: Computation
    by_momentum: Mapping[sympy.Expr, Computation]


def turns(setting: Setting) -> tuple[Part, ...]:
    """Return the three angles by the cosine and sine in exp(phi A)."""
    if setting.group == "SO3":
        return _whole(setting, 1), *circles(setting)
    angle = half_angle if setting.factor < 1 else double_angle
    return tuple(angle(f"phi{k}", f"phi{k}_rate") for k in (1, 2, 3))


def circles(setting: Setting) -> tuple[Part, Part]:
    """Return the whole angles phi2 and phi3 by their cosines and sines.

    Squares of phi2's function along the last axis are reduced to those of the one across it, by
    which the chapters divide.
    """
    phi2, phi3 = (_whole(setting, k) for k in (2, 3))
    along, across = (f"{x.func}_phi2" for x in setting.nutation(PHI[1]))
    return replace(phi2, names=(across, along)), phi3


def _whole(setting: Setting, k: int) -> Part:
    """Return the angle by which exp(phi A) turns vectors, by its cosine and sine."""
    double = 2 * setting.factor
    angle, rate = str(double * PHI[k - 1]), str(double * symbol(f"phi{k}_rate"))
    return circle(f"cos_phi{k}", f"sin_phi{k}", angle, rate)


def exponential(setting: Setting, axis: int, angle: sympy.Symbol) -> ImmutableMatrix:
    """Return exp(angle A) for one axis."""
    return _exponential(setting.basis()[axis - 1], setting.frequency, angle)


def _exponential(A: ImmutableMatrix, w: sympy.Expr, angle: sympy.Expr) -> ImmutableMatrix:
    """Return Rodrigues' 1 + sin(w angle)/w A + (1 - cos(w angle))/w^2 A^2, for A^3 = -w^2 A."""
    sine, rest = sympy.sin(w * angle) / w, (1 - sympy.cos(w * angle)) / w**2
    return (ImmutableMatrix.eye(A.rows) + sine * A + rest * A**2).applyfunc(sympy.expand)


def rotation(setting: Setting) -> dict[str, ImmutableMatrix | MatrixExpr]:
    """Return the rotation (25): three turns after a constant one onto the outer axis."""
    pairs = zip(setting.sequence, PHI, strict=True)
    factors = {f"E{k}": exponential(setting, *pair) for k, pair in enumerate(pairs, 1)}
    front = _front(setting)
    constant = {} if front is None else {"T": front}
    product = E1 * E2 * E3 if front is None else matrix("T") * E1 * E2 * E3
    return {**constant, **factors, "R": product}


def _front(setting: Setting) -> ImmutableMatrix | None:
    """Return the constant turn of the outer axis to the target, by a third about A1 + A2 + A3."""
    if setting.target == setting.sequence[0]:
        return None
    basis, size = setting.basis(), sympy.sqrt(3)
    diagonal, third = basis[0] + basis[1] + basis[2], sympy.pi / (3 * size * setting.factor)
    for angle in (third, -third):
        T = _exponential(diagonal, size * setting.frequency, angle)
        turned = T * basis[setting.sequence[0] - 1] * T.H
        if (turned - basis[setting.target - 1]).applyfunc(sympy.expand).is_zero_matrix:
            return T
    raise AssertionError("one of the two turns takes any axis to any other")


def derive(builder: LedgerBuilder) -> None:
    """(22) to (29)."""
    algebra = builder.result(Algebra)
    setting = algebra.setting
    parts, target = turns(setting), A[setting.target - 1]
    matrices = {**algebra.basis, **rotation(setting)}
    scope = Scope.open(builder, "three_angles", MOMENTUM, TURNING, *parts, matrices=matrices)
    first, turned = A[setting.sequence[0] - 1], "a turn about a fixed axis"
    multiply(scope, "exponential", Rate(E1), PHI_RATES[0] * first * E1, turned, [25])
    one, why = sympy.Identity(SIZE), "R is unitary"
    multiply(scope, "inverse", R * R.adjoint(), one, why, [1, 25])
    why = "the first turn leaves its own axis where it is"
    multiply(scope, "stabiliser", E1 * first * E1.I, first, why, [25])
    why = "the momentum that is turned onto the axis, seen in the body: phi1 has gone"
    seen = coordinates(scope, "momentum", R.I * target * R, A, why, [24, 26])
    momenta = builder.result(Dynamics).momenta
    reduction = Reduction(seen.value, momenta, matrices, parts, circles(setting))
    builder.keep(reduction)
    _reduced(builder, reduction)
    _angles(builder, reduction)


def _reduced(builder: LedgerBuilder, reduction: Reduction) -> None:
    """Prove that R M R^-1 = K A for M = K times the direction."""
    setting, given = builder.result(Algebra).setting, builder.result(Dynamics).parameters
    parts = (given, MOMENTUM, *reduction.angles)
    body = by_angles(builder, reduction, *parts)
    matrices = {**reduction.matrices, **MOMENTUM_MATRIX}
    scope = Scope.open(builder, "reduced", *parts, body, matrices=matrices, static=True)
    target = A[setting.target - 1]
    why = "with these components of M, R turns M onto the axis"
    multiply(scope, "conjugate", R * M * R.I, K * target, why, [23])
    multiply(scope, "momentum", M, K * (R.I * target * R), "and back", [24])


def by_angles(builder: LedgerBuilder, reduction: Reduction, *parts: Part) -> Part:
    """Return the body whose momentum is K times the direction."""
    dynamics = builder.result(Dynamics)
    text = Dictionary(join("by_angles", *parts, static=True)).text
    seen: Any = named(MOMENTA, (K * x for x in reduction.direction))
    rates = {rate: text(compute(dynamics.velocities[rate]).subs(seen)) for rate in RATES}
    known = {name: dynamics.body.definitions[name] for name in (*MOMENTA, H)}
    return Part(definitions={**rates, **known})


def _angles(builder: LedgerBuilder, reduction: Reduction) -> None:
    """Solve the components of M for the angles: (27) to (29)."""
    setting = builder.result(Algebra).setting
    axes = [axis - 1 for axis in setting.axes]
    last, middle, third = (reduction.direction[axis] for axis in axes)
    along, across = setting.nutation(PHI[1])
    name = f"{across.func}_phi2"
    free = Part((*MOMENTA, name), units=(name,), reading={name: str(across)})
    unknown: list[sympy.Expr] = [along]
    unknown += [f(2 * setting.factor * PHI[2]) for f in (sympy.cos, sympy.sin)]
    names = (f"{along.func}_phi2", "cos_phi3", "sin_phi3")
    angles = Part(names, reading=named(names, map(str, unknown)))
    scope = Scope.open(builder, "compared", MOMENTUM, free, angles, static=True)
    M_last, M_middle, M_third = (MOMENTA[axis] for axis in axes)
    why = "the component along the last axis gives phi2"
    nutation = solve(scope, "phi2", [(M_last, K * last)], unknown[:1], why, [27])
    equations, why = [(M_middle, K * middle), (M_third, K * third)], "the other two give phi3"
    found = solve(scope, "phi3", equations, unknown[1:], why, [28])
    cosine, sine = unknown[1:]
    momenta = named(MOMENTA, reduction.momenta)
    quotient = (found.found[sine] / found.found[cosine]).cancel().subs(momenta)
    by_momentum = {along: nutation.found[along], **{x: found.found[x] for x in (cosine, sine)}}
    builder.keep(Angles(by_momentum[along].subs(momenta), quotient, by_momentum))
    parts = (builder.result(Dynamics).parameters, MOMENTUM, *reduction.circles)
    body = by_angles(builder, reduction, *parts)
    tangent = Scope.open(builder, "phi3", *parts, body, static=True)
    why = "their quotient, where it is one; it gives phi3 up to half a turn"
    rewrite(tangent, "tangent.phi3", sine / cosine, quotient, why, [29], "quotient")
