"""Theorem 1: R of (25) as a quaternion (18), its factors from x and y (19), and phi1 (20), (36).

The product of three turns is read off as a quaternion.  Its factors are halves of angles: of phi2
by its cosine x, of phi3 by its tangent y, where a quadratic equation leaves a choice that is the
sign of cos(phi3).  phi1 is the integral of the third kind, in the amplitude as variable.  In SO(3)
the product is a rotation matrix by the whole angles, and so by the momentum and phi1: it needs no
half angles with their signs.
"""

from dataclasses import dataclass

import sympy

from derivations.conjugacy import MOMENTUM, PHI, Angles, Reduction, by_angles
from derivations.euler_lax import Dynamics
from derivations.lie_algebra import UNITS, Algebra, R, e
from derivations.phi1_integral import AMPLITUDE, DN, SN, XI, ThirdKind
from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps import Scope, coordinates, eliminate, multiply, rate_of, rewrite
from rigidsym.proof.steps._names import symbol, symbols

Y, TAU, ROOT = symbols("y tau root")


@dataclass(frozen=True, slots=True)
class Theorem1:
    """Results of this chapter: the quaternion (18), and tan(phi3/2) by y and `root`."""

    quaternion: Computation
    half_tangent: Computation


def derive(builder: LedgerBuilder) -> None:
    """Prove (18), (19), (20), (21) and (36)."""
    algebra, reduction = builder.result(Algebra), builder.result(Reduction)
    if algebra.setting.group == "SU2":
        matrices = {**reduction.matrices, **UNITS}
        scope = Scope.open(builder, "theorem1", *reduction.angles, matrices=matrices, static=True)
        why = "the three turns as a quaternion"
        turned = coordinates(scope, "quaternion", R, e, why, [18, "Theorem 1"])
        _outer_halves(scope, algebra)
        builder.keep(Theorem1(turned.found, _inner_half(builder)))
    else:
        _rotation_matrix(builder, algebra, reduction)
    if ThirdKind in builder:
        _third_kind(builder)


def _rotation_matrix(builder: LedgerBuilder, algebra: Algebra, reduction: Reduction) -> None:
    """Prove the rotation matrix by the three angles, and by the momentum and phi1."""
    _, across = algebra.setting.nutation(PHI[1])
    parts = (builder.result(Dynamics).parameters, MOMENTUM, *reduction.angles)
    body = (by_angles(builder, reduction, *parts), Part(units=(f"{across.func}_phi2",)))
    matrices = reduction.matrices
    scope = Scope.open(builder, "theorem1", *parts, *body, matrices=matrices, static=True)
    turned, why = compute(scope.explicit(R)), "the three turns as a rotation matrix"
    multiply(scope, "matrix", R, turned, why, [18, "Theorem 1"])
    value = turned.subs(builder.result(Angles).by_momentum)
    why = "and with the momentum in the place of phi2 and phi3"
    multiply(scope, "by_momentum", R, value, why, [19, "Theorem 1"])


def _outer_halves(scope: Scope, algebra: Algebra) -> None:
    """Prove cos^2 and sin^2 of phi2/2 by cos(phi2), and cos^2(phi2) where x is sin(phi2)."""
    angle = algebra.setting.factor * PHI[1]
    cosine, sine, whole = sympy.cos(angle), sympy.sin(angle), sympy.cos(2 * angle)
    double = [cosine**2 + sine**2 - 1, cosine**2 - sine**2 - whole]
    for name, half in (("cosine", cosine), ("sine", sine)):
        why = f"its {name} by the cosine of the whole angle"
        squares = [cosine**2, sine**2]
        eliminate(scope, f"theorem1.outer_{name}", half**2, double, squares, why, [19])
    x, root = algebra.setting.nutation(PHI[1])
    if x != whole:
        why = "and the cosine by the sine, up to its sign"
        eliminate(scope, "theorem1.outer_whole", root**2, [x**2 + root**2 - 1], [root**2], why)


def _inner_half(builder: LedgerBuilder) -> Computation:
    """Prove tan(phi3/2) by tan(phi3): cos(phi3) decides between two roots.

    Return one of them, free of cancellation: the equation is solved for the cotangent.
    """
    free = Part(
        {"y": "tan(phi3)", "root": "sqrt(1 + y**2) or less that", "tau": "tan(phi3/2)"},
        units=("y",),
        relations=("root**2 - y**2 - 1",),
    )
    scope = Scope.open(builder, "half_tangent", free, static=True)
    quadratic = sympy.numer(sympy.together(2 * TAU / (1 - TAU**2) - Y))
    quadratic = sympy.expand(quadratic * (-1 if quadratic.coeff(TAU) < 0 else 1))
    root = sympy.sqrt(Y**2 + 1)
    found = [x.subs(root, ROOT) for x in compute(quadratic).apply(sympy.solve, TAU)]
    leading = sympy.Poly(quadratic, TAU).LC()
    product = compute(found).apply(_product, leading)
    why = "a quadratic for tau, the tangent of half of phi3, and its two roots"
    rewrite(scope, "roots", quadratic, product, why, [19], "roots")
    _, cotangent = compute(quadratic).subs(TAU, 1 / TAU).apply(sympy.solve, TAU)
    return 1 / cotangent.subs(root, ROOT).together()


def _product(roots: list[sympy.Expr], leading: sympy.Expr) -> sympy.Expr:
    """Return the polynomial in tau with these roots, as a product."""
    return sympy.Mul(leading, *(TAU - x for x in roots), evaluate=False)


def _third_kind(builder: LedgerBuilder) -> None:
    """Prove (36): the integrand with the amplitude as variable."""
    third = builder.result(ThirdKind)
    scope = Scope.open(builder, "theorem1_amplitude", *third.parts, AMPLITUDE, Part(units=("dn",)))
    slope, theta = third.rate, rate_of(symbol("theta"))
    constant = slope.as_independent(SN)[0]
    changed = constant + (slope - constant) / (XI * DN) * theta
    why = "with the amplitude theta as variable of the integral"
    rate = rate_of(symbol("phi1"))
    rewrite(scope, "integrand", rate, changed, why, [36], "substitute")
