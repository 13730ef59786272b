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
    UNIT_QUATERNION,
    A,
    Algebra,
    M,
    Omega,
    R,
    combination,
    commutator,
)
from derivations.setting import MOMENTS, PRODUCTS, Setting
from rigidsym.proof.algebra import LedgerBuilder, Part
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
from rigidsym.proof.steps._variation import MOMENTA, RATES

INERTIA = Part(
    {f"c{k}": f"principal moment of inertia {k}, kg m^2" for k in (1, 2, 3)},
    units=("c1", "c2", "c3"),
)


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
            **{x: INERTIA.reading[x] for x in moments},
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
    unknown = symbols("Omega1_rate Omega2_rate Omega3_rate")
    equations, why = varied.equations, "Euler's equations: solve for the rates of the rates"
    euler = solve(varied.scope, "variation.euler", equations, unknown, why, [5])
    body = _body(builder, algebra, given, varied.momenta, euler.value)
    gaps = [m - value for m, value in zip(MOMENTA, varied.momenta, strict=True)]
    velocities = sympy.solve(gaps, RATES)
    builder.keep(Dynamics(given, body, varied.momenta, velocities))
    _lax_pair(builder, algebra, given, body)
    _gradient(builder, algebra, given, velocities)
    _conjugation(builder, algebra, given, body)


def _body(
    builder: LedgerBuilder,
    algebra: Algebra,
    given: Part,
    momenta: tuple[sympy.Expr, ...],
    rates: Mapping[sympy.Symbol, sympy.Expr],
) -> Part:
    """Prove Euler's equations, H by Legendre's transform, and K^2 from the spectrum of M."""
    free = Part(
        (*map(str, MOMENTA),),
        reading={f"M{k}": f"body momentum along axis {k}" for k in (1, 2, 3)},
    )
    matrices = {**algebra.basis, "M": combination("M1 M2 M3")}
    scope = Scope.open(builder, "spectrum", free, matrices=matrices, static=True)
    square = (_spectrum(scope, algebra.setting) / algebra.setting.frequency**2).expand()
    gradient = Computation(momenta, ("vary",))
    lagrangian = compute(algebra.setting.energy())
    energy = sum((m * w for m, w in zip(gradient, RATES, strict=True)), -lagrangian)
    return Part(
        ("Omega1", "Omega2", "Omega3"),
        definitions={
            **{str(name): scope.text(m) for name, m in zip(MOMENTA, gradient, strict=True)},
            "H": scope.text(energy.expand().factor()),
            "K_squared": scope.text(square),
        },
        rates={
            str(w): scope.text(Computation(rates[symbol(f"{w}_rate")], ("solve",))) for w in RATES
        },
        reading={f"Omega{k}": f"body rate about axis {k}, rad/s" for k in (1, 2, 3)},
    )


def _spectrum(scope: Scope, setting: Setting) -> Computation:
    """Return w^2 K^2, the square of the frequency of exp(t M), by the spectrum of M."""
    if setting.group == "SU2":
        why = "the spectrum of M, whose trace is zero, is in its determinant"
        return determinant(scope, "spectrum.determinant", M, why, [6, 7]).found
    why = "the spectrum of M is zero and the roots of x^2 by M^3 = x^2 M"
    return -coordinates(scope, "spectrum.cube", M**3, [M], why, [6, 7]).found[0]


def _lax_pair(builder: LedgerBuilder, algebra: Algebra, given: Part, body: Part) -> None:
    """Solve M' = [M, B] for B, and prove what it conserves."""
    matrices = {
        **algebra.basis,
        "M": combination("M1 M2 M3"),
        "Omega": combination("Omega1 Omega2 Omega3"),
    }
    scope = Scope.open(builder, "body", given, body, matrices=matrices)
    why = "the bracket of M with the velocity"
    bracket = coordinates(scope, "body.euler", commutator(M, Omega), A, why, [5, 7])
    multiply(scope, "body.lax", Rate(M), commutator(M, Omega), "M and Omega are a Lax pair", [7])
    differentiate(scope, "body.energy", symbol("H"), "energy is conserved", [6, 15])
    why = "and so is the spectrum of M"
    differentiate(scope, "body.momentum", symbol("K_squared"), why, [6, 7, 15])

    unknown = symbols("b1 b2 b3")
    ansatz = Part(
        (*map(str, unknown), "b_free"),
        reading={f"b{k}": f"coordinate {k} of a matrix B with M' = [M, B]" for k in (1, 2, 3)},
    )
    B = matrix("B")
    partner = {**matrices, "B": combination("b1 b2 b3")}
    scope = Scope.open(builder, "partner", given, body, ansatz, matrices=partner)
    why = "which matrices B have M' = [M, B]?"
    wanted = coordinates(scope, "partner.bracket", commutator(M, B), A, why, [7])
    equations = list(zip(wanted.value, bracket.value, strict=True))
    why = "Omega, up to a multiple of M"
    solve_family(scope, "partner.found", equations, unknown, symbol("b_free"), why, [7])


def _gradient(
    builder: LedgerBuilder,
    algebra: Algebra,
    given: Part,
    velocities: Mapping[sympy.Symbol, sympy.Expr],
) -> None:
    """Prove (8): dH/dM_i = Omega_i, with D as the derivative along one momentum."""
    energy = sum(m * w for m, w in zip(MOMENTA, RATES, strict=True)) - algebra.setting.energy()
    momenta = Part(
        ("M1", "M2", "M3"),
        definitions={"H": str(sympy.factor(sympy.expand(energy.subs(velocities))))},
        reading={f"M{k}": f"body momentum along axis {k}" for k in (1, 2, 3)},
    )
    for k in (1, 2, 3):
        scope = Scope.open(builder, f"gradient{k}", given, momenta, Part(rates={f"M{k}": "1"}))
        why = f"the slope of H along M{k} is Omega{k}"
        differentiate(scope, f"gradient{k}.rate", symbol("H"), why, [7, 8])


def _conjugation(builder: LedgerBuilder, algebra: Algebra, given: Part, body: Part) -> None:
    """Prove (9) and (22): R M R^-1 is constant."""
    matrices = {
        **algebra.basis,
        "M": combination("M1 M2 M3"),
        "Omega": combination("Omega1 Omega2 Omega3"),
        "R": algebra.setting.element("q"),
    }
    parts = (given, body, UNIT_QUATERNION, algebra.attitude)
    scope = Scope.open(builder, "moving_body", *parts, matrices=matrices)
    why = "the attitude turns with the body"
    multiply(scope, "moving_body.kinematics", Rate(R), R * Omega, why, [3])
    why = "the momentum in space is constant"
    nothing = sympy.ZeroMatrix(SIZE, SIZE)
    multiply(scope, "moving_body.momentum_is_constant", Rate(R * M * R.I), nothing, why, [9, 22])
