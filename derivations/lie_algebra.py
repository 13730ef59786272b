"""SU(2), its Lie algebra, and the unit quaternions: from the basis (4) to (1), (2), (3).

A matrix of the form (1) is unitary with determinant one.  The map F of (2) turns the matrix product
into a product of quaternions, which is read off; so are the brackets of the basis and, from
R' = R Omega, the rates of a quaternion.
"""

from dataclasses import dataclass

import sympy
from sympy import ImmutableMatrix, MatAdd, MatrixExpr

from derivations.setting import Setting
from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.steps import Scope, coordinates, determinant, matrix, multiply
from rigidsym.proof.steps._names import symbols

UNIT_QUATERNION = Part(
    ("q0", "q1", "q2", "q3"),
    relations=("q3**2 + q2**2 + q1**2 + q0**2 - 1",),
    reading={f"q{k}": f"component {k} of a unit quaternion" for k in range(4)},
)
PAIR = Part(
    (
        "q0",
        "q1",
        "q2",
        "q3",
        "p0",
        "p1",
        "p2",
        "p3",
        "Omega1",
        "Omega2",
        "Omega3",
    ),
    reading={
        **{f"{name}{k}": f"component {k} of a quaternion" for name in "qp" for k in range(4)},
        **{f"Omega{k}": f"body rate about axis {k}" for k in (1, 2, 3)},
    },
)
# 1, i, j, k as matrices, by (1) and (2).
UNITS = {
    f"e{k}": ImmutableMatrix(rows)
    for k, rows in enumerate(
        (
            ((1, 0), (0, 1)),
            ((sympy.I, 0), (0, -sympy.I)),
            ((0, 1), (-1, 0)),
            ((0, sympy.I), (sympy.I, 0)),
        )
    )
}
e = tuple(map(matrix, UNITS))
A = tuple(map(matrix, ("A1", "A2", "A3")))
R, M, Omega = map(matrix, ("R", "M", "Omega"))


@dataclass(frozen=True, slots=True)
class Algebra:
    """Results of this chapter: [A_i, A_j] = sum f_ijk A_k, and the rates of a quaternion."""

    setting: Setting
    constants: tuple[tuple[tuple[sympy.Expr, ...], ...], ...]
    kinematics: tuple[sympy.Expr, ...]

    @property
    def basis(self) -> dict[str, ImmutableMatrix]:
        """The basis A1, A2, A3 by name."""
        return dict(zip(("A1", "A2", "A3"), self.setting.basis(), strict=True))

    @property
    def attitude(self) -> Part:
        """The rates of an attitude that moves by (3)."""
        rates = {f"q{k}": str(rate) for k, rate in enumerate(self.kinematics)}
        return Part(rates=rates)


def from_quaternion(name: str) -> ImmutableMatrix:
    """Return F of (1) and (2): q0 + q1 i + q2 j + q3 k -> ((z1, z2), (-z2*, z1*))."""
    q0, q1, q2, q3 = symbols(f"{name}0 {name}1 {name}2 {name}3")
    z1, z2 = q0 + sympy.I * q1, q2 + sympy.I * q3
    return ImmutableMatrix(((z1, z2), (-z2.conjugate(), z1.conjugate())))


def combination(names: str) -> MatrixExpr:
    """Return x1 A1 + x2 A2 + x3 A3, the paper's (8)."""
    x1, x2, x3 = symbols(names)
    return x1 * A[0] + x2 * A[1] + x3 * A[2]


def commutator(x: MatrixExpr, y: MatrixExpr) -> MatrixExpr:
    """Return the commutator [x, y] = x y - y x."""
    return MatAdd(x * y, -y * x, evaluate=False)


def derive(builder: LedgerBuilder) -> None:
    """Prove (1), (2), (4) and (3)."""
    setting = builder.result(Setting) if Setting in builder else Setting()
    scope = Scope.open(
        builder, "SU2", UNIT_QUATERNION, matrices={"R": from_quaternion("q")}, static=True
    )
    multiply(
        scope,
        "SU2.unitary",
        R * R.adjoint(),
        sympy.Identity(2),
        "R of the form (1) is unitary",
        ["1"],
    )
    determinant(scope, "SU2.special", R, "and its determinant is one", ["1"])

    P, Q = map(matrix, "PQ")
    basis = dict(zip(("A1", "A2", "A3"), setting.basis(), strict=True))
    pair = {"P": from_quaternion("p"), "Q": from_quaternion("q"), **UNITS, **basis}
    matrices = {**pair, "Omega": combination("Omega1 Omega2 Omega3")}
    scope = Scope.open(builder, "quaternions", PAIR, matrices=matrices, static=True)
    coordinates(scope, "quaternions.product", P * Q, e, "the product of two quaternions", ["2"])
    constants = _brackets(scope)
    why = "R' = R Omega in the components of a quaternion"
    rates = coordinates(scope, "quaternions.kinematics", Q * Omega, e, why, ["3"])
    builder.keep(Algebra(setting, constants, rates.value))


def _brackets(scope: Scope) -> tuple[tuple[tuple[sympy.Expr, ...], ...], ...]:
    """Return the structure constants: three brackets are decided, the others follow by signs."""
    found = {}
    for i, j in ((0, 1), (1, 2), (0, 2)):
        fact = f"quaternions.bracket_{i + 1}{j + 1}"
        why = f"the bracket of A{i + 1} and A{j + 1}, read off"
        step = coordinates(scope, fact, commutator(A[i], A[j]), A, why, ["4"])
        found[i, j] = step.value
        found[j, i] = tuple(-x for x in step.value)
    zero = (sympy.S.Zero,) * 3
    return tuple(tuple(found.get((i, j), zero) for j in range(3)) for i in range(3))
