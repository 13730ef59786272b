"""The elliptic curve of a body with wheels, or in general axes: M = I Omega + h.

With one wheel, along principal axis a, the square of Omega_a' is a quartic in Omega_a.  With any
wheels, the rates move on the intersection of two quadrics, 2 H and K^2, and the determinant of
their pencil is the quartic whose square root has the same periods.  The quartic of one rate has
half of one of them: two values of the other rates and their negatives share it.  With products of
inertia and no wheel, the determinant has the characteristic polynomial of the inertia tensor I as
a factor: its roots are the principal moments.
"""

import sympy

from derivations.euler_lax import RATES, Dynamics, H
from derivations.lie_algebra import Algebra
from derivations.setting import AXES
from rigidsym.proof.algebra import LedgerBuilder, Part, part_of
from rigidsym.proof.algebra._computation import compute
from rigidsym.proof.steps import Scope, eliminate, rate_of, rewrite
from rigidsym.proof.steps._names import read, symbol, symbols

K_SQUARED, X = symbols("K_squared x")


def gyrostat(builder: LedgerBuilder) -> None:
    """Prove the quartic of the pencil, and that of the axis of one wheel."""
    dynamics, setting = builder.result(Dynamics), builder.result(Algebra).setting
    turning = [axis for axis, h in zip(AXES, setting.wheel(), strict=True) if h != 0]
    if len(turning) == 1 and setting.about_principal_axes:
        across = {*AXES} - {*turning}
        if not setting.alike(*across):  # else the rate along the wheel is constant
            _along(builder, dynamics, turning[0] - 1)
    _pencil(builder, dynamics)


def _quadrics(dynamics: Dynamics) -> tuple[sympy.Expr, sympy.Expr]:
    """Return 2 H and K^2 as quadrics in the rates."""
    return 2 * read(dynamics.body.definitions[H]), sympy.Add(*(m**2 for m in dynamics.momenta))


def _along(builder: LedgerBuilder, dynamics: Dynamics, axis: int) -> None:
    body = builder.ledger.contexts["body"]
    names = (*map(str, RATES), *map(str, dynamics.body.definitions))
    parts = (dynamics.parameters, part_of(body, *names))
    scope = Scope.open(builder, "gyrostat", *parts)
    rate = scope.rate(RATES[axis])
    energy, momentum = _quadrics(dynamics)
    squares = [other**2 for k, other in enumerate(RATES) if k != axis]
    why = "the rate along the wheel, squared, two rates eliminated by H and K: a quartic"
    equations = [2 * H - energy, K_SQUARED - momentum]
    squared = rate_of(RATES[axis]) ** 2
    eliminate(scope, "quartic", rate**2, equations, squares, why, [14], squared)


def _pencil(builder: LedgerBuilder, dynamics: Dynamics) -> None:
    variable = Part(
        ("x", "H", "K_squared"),
        reading={"x": "the parameter of the pencil x (2 H - ...) - (K^2 - ...)"},
    )
    scope = Scope.open(builder, "pencil", dynamics.parameters, variable, static=True)
    matrix = X * _matrix(_quadrics(dynamics)[0], 2 * H) - _matrix(_quadrics(dynamics)[1], K_SQUARED)
    leibniz = matrix.applyfunc(sympy.factor).det(method="berkowitz")
    why = "the determinant of the pencil of both quadrics: the quartic of the elliptic curve"
    rewrite(scope, "quartic", leibniz, compute(leibniz).factor(), why, [14])


def _matrix(quadric: sympy.Expr, value: sympy.Expr) -> sympy.Matrix:
    """Return the symmetric matrix of quadric - value in (Omega1, Omega2, Omega3, 1)."""
    one = symbol("one")
    homogeneous = sympy.Poly(sympy.expand(quadric - value), *RATES).homogenize(one)
    return sympy.hessian(homogeneous.as_expr(), [*RATES, one]) / 2
