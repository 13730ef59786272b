"""From the kinetic energy to Euler's equations, the Lax pair and the conserved momentum.

The variation of the Lagrangian gives M', where M is its gradient in the rates; solved for their
rates these are Euler's equations (5).  The equation M' = [M, B] is solved for B: Omega, up to a
multiple of M.  So the spectrum of M, that is K, cannot change (6), (7), (15).  With R' = R Omega
the matrix R M R^-1 is constant, (9) and (22); the gradient of H in the momenta is Omega (8).
"""

from collections.abc import Mapping
from dataclasses import dataclass

import sympy

from derivations.lie_algebra import (
    MOMENTUM_MATRIX,
    UNIT_QUATERNION,
    VELOCITY,
    A,
    Algebra,
    M,
    Omega,
    R,
    combination,
    commutator,
)
from derivations.setting import AXES, MOMENTA, MOMENTS, PRODUCTS, RATES, Setting
from rigidsym.proof.algebra import LedgerBuilder, Part, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import (
    SIZE,
    Rate,
    Scope,
    coordinates,
    determinant,
    differentiate,
    matrix,
    multiply,
    solve,
    solve_family,
    vary,
)
from rigidsym.proof.steps._names import symbol, symbols

H, K_squared, b_free, B = *symbols("H K_squared b_free"), matrix("B")
INERTIA = Part(
    {c: f"principal moment of inertia {k}, kg m^2" for k, c in zip(AXES, MOMENTS, strict=True)},
    units=MOMENTS,
)
FREE_MOMENTUM = Part(
    {m: f"body momentum along axis {k}" for k, m in zip(AXES, MOMENTA, strict=True)}
)
BODY_RATES = {w: f"body rate about axis {k}, rad/s" for k, w in zip(AXES, RATES, strict=True)}


@dataclass(frozen=True, slots=True)
class Dynamics:
    """Results of this chapter: the body's parameters and its equations of motion.

    `momenta` are M1, M2, M3 of the rates, `velocities` the rates of the momenta.
    """

    parameters: Part
    body: Part
    momenta: tuple[sympy.Expr, ...]
    velocities: Mapping[sympy.Symbol, sympy.Expr]


def parameters(setting: Setting) -> Part:
    """Return the moments and products of inertia, and the wheels' momenta, that there are."""
    tensor = setting.inertia()
    moments = [str(x) for x in MOMENTS if tensor.has(x)]
    products = [str(x) for x in PRODUCTS if tensor.has(x)]
    wheels = sorted({str(h) for linear in setting.wheel() for h in linear.free_symbols})
    factors = sympy.factor_list(tensor.det(method="berkowitz"))[1]
    return Part(
        {
            **{x: INERTIA.reading[symbol(x)] for x in moments},
            **{x: f"product of inertia of axes {x[1]} and {x[2]}, kg m^2" for x in products},
            **{x: f"momentum of wheel {x[1]}, kg m^2 rad/s" for x in wheels},
        },
        units=tuple(dict.fromkeys((*moments, *(str(x) for x, _ in factors)))),
    )


def derive(builder: LedgerBuilder) -> None:
    """(5) to (9), (15) and (22)."""
    algebra = builder.result(Algebra)
    given = parameters(algebra.setting)
    lagrangian = algebra.setting.energy()
    why = "vary the attitude in the Lagrangian: M' by the momenta and the rates"
    varied = vary(builder, "variation", lagrangian, algebra.constants, given, why, [5, 7])
    unknown = [symbol(f"{w}_rate") for w in RATES]
    why = "Euler's equations: solve for the rates of the rates"
    euler = solve(varied.scope, "euler", varied.equations, unknown, why, [5])
    body = _body(builder, algebra, varied.momenta, euler.found)
    gaps = [m - value for m, value in zip(MOMENTA, varied.momenta, strict=True)]
    dynamics = Dynamics(given, body, varied.momenta, sympy.solve(gaps, RATES))
    builder.keep(dynamics)
    _lax_pair(builder, algebra, dynamics)
    _gradient(builder, algebra, dynamics)
    _conjugation(builder, algebra, dynamics)


def _body(
    builder: LedgerBuilder, algebra: Algebra, momenta: tuple[sympy.Expr, ...], euler: Computation
) -> Part:
    """Prove Euler's equations, H by Legendre's transform, and K^2 from the spectrum of M."""
    matrices = {**algebra.basis, **MOMENTUM_MATRIX}
    scope = Scope.open(builder, "spectrum", FREE_MOMENTUM, matrices=matrices, static=True)
    square = (_spectrum(scope, algebra.setting) / algebra.setting.frequency**2).expand()
    gradient = Computation(momenta, ("vary",))
    lagrangian = compute(algebra.setting.energy())
    energy = sum((m * w for m, w in zip(gradient, RATES, strict=True)), -lagrangian)
    definitions = {**named(MOMENTA, gradient), H: energy.expand().factor(), K_squared: square}
    return Part(
        RATES,
        definitions={name: scope.text(value) for name, value in definitions.items()},
        rates={w: scope.text(euler[symbol(f"{w}_rate")]) for w in RATES},
        reading=BODY_RATES,
    )


def _spectrum(scope: Scope, setting: Setting) -> Computation:
    """Return w^2 K^2, the square of the frequency of exp(t M), by the spectrum of M."""
    if setting.group == "SU2":
        why = "the spectrum of M, whose trace is zero, is in its determinant"
        return determinant(scope, "determinant", M, why, [6, 7]).found
    why = "the spectrum of M is zero and the roots of x^2 by M^3 = x^2 M"
    return -coordinates(scope, "cube", M**3, [M], why, [6, 7]).found[0]


def _lax_pair(builder: LedgerBuilder, algebra: Algebra, dynamics: Dynamics) -> None:
    """Solve M' = [M, B] for B, and prove what it conserves."""
    given = (dynamics.parameters, dynamics.body)
    matrices = {**algebra.basis, **MOMENTUM_MATRIX, **VELOCITY}
    scope = Scope.open(builder, "body", *given, matrices=matrices)
    why = "the bracket of M with the velocity"
    bracket = coordinates(scope, "euler", commutator(M, Omega), A, why, [5, 7])
    multiply(scope, "lax", Rate(M), commutator(M, Omega), "M and Omega are a Lax pair", [7])
    differentiate(scope, "energy", H, "energy is conserved", [6, 15])
    differentiate(scope, "momentum", K_squared, "and so is the spectrum of M", [6, 7, 15])

    unknown = symbols("b1 b2 b3")
    meaning = "coordinate {} of a matrix B with M' = [M, B]".format
    ansatz = Part((*unknown, b_free), reading=named(unknown, map(meaning, AXES)))
    partner = {**matrices, "B": combination(*unknown)}
    scope = Scope.open(builder, "partner", *given, ansatz, matrices=partner)
    why = "which matrices B have M' = [M, B]?"
    wanted = coordinates(scope, "bracket", commutator(M, B), A, why, [7])
    equations = list(zip(wanted.value, bracket.value, strict=True))
    solve_family(scope, "found", equations, unknown, b_free, "Omega, up to a multiple of M", [7])


def _gradient(builder: LedgerBuilder, algebra: Algebra, dynamics: Dynamics) -> None:
    """Prove (8): dH/dM_i = Omega_i, with D as the derivative along one momentum."""
    energy = sum(m * w for m, w in zip(MOMENTA, RATES, strict=True)) - algebra.setting.energy()
    by_momenta = str(sympy.factor(sympy.expand(energy.subs(dynamics.velocities))))
    given = (dynamics.parameters, FREE_MOMENTUM, Part(definitions={H: by_momenta}))
    for k, momentum in zip(AXES, MOMENTA, strict=True):
        scope = Scope.open(builder, f"gradient{k}", *given, Part(rates={momentum: 1}))
        differentiate(scope, "rate", H, f"the slope of H along M{k} is Omega{k}", [7, 8])


def _conjugation(builder: LedgerBuilder, algebra: Algebra, dynamics: Dynamics) -> None:
    """Prove (9) and (22): R M R^-1 is constant."""
    rotation = {"R": algebra.setting.element("q")}
    matrices = {**algebra.basis, **MOMENTUM_MATRIX, **VELOCITY, **rotation}
    parts = (dynamics.parameters, dynamics.body, UNIT_QUATERNION, algebra.attitude)
    scope = Scope.open(builder, "moving_body", *parts, matrices=matrices)
    multiply(scope, "kinematics", Rate(R), R * Omega, "the attitude turns with the body", [3])
    seen, nothing = Rate(R * M * R.I), sympy.ZeroMatrix(SIZE, SIZE)
    why = "the momentum in space is constant"
    multiply(scope, "momentum_is_constant", seen, nothing, why, [9, 22])
