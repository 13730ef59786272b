"""SU(2) or SO(3), its Lie algebra, and the unit quaternions: from the basis (4) to (1), (2), (3).

A matrix of the form (1) is unitary with determinant one.  The map F of (2) turns the matrix product
into a product of quaternions, which is read off; so are the brackets of the basis and, from
R' = R Omega, the rates of a quaternion.  The rotation matrix of a unit quaternion takes the place
of (1) in a derivation with matrices of SO(3).
"""

from dataclasses import dataclass

import sympy
from sympy import ImmutableMatrix, MatAdd, MatrixExpr, Symbol

from derivations.setting import AXES, MOMENTA, RATES, Setting, su2
from rigidsym.proof.algebra import LedgerBuilder, Part, named, unit_quaternion
from rigidsym.proof.algebra._quaternion import product
from rigidsym.proof.steps import SIZE, Scope, coordinates, determinant, matrix, multiply
from rigidsym.proof.steps._names import symbols

UNIT_QUATERNION = unit_quaternion("q", "a unit quaternion")
PAIR = Part(
    {
        **{f"{name}{k}": f"component {k} of a quaternion" for name in "qp" for k in range(4)},
        **{rate: f"body rate about axis {k}" for k, rate in zip(AXES, RATES, strict=True)},
    }
)
# 1, i, j, k as matrices, by (1) and (2).
UNITS = {f"e{k}": su2(unit) for k, unit in enumerate(sympy.eye(4).tolist())}
e = tuple(map(matrix, UNITS))
A = A1, A2, A3 = tuple(map(matrix, ("A1", "A2", "A3")))
R, M, Omega, P, Q, S = map(matrix, ("R", "M", "Omega", "P", "Q", "S"))


@dataclass(frozen=True, slots=True)
class Algebra:
    """Results of this chapter: [A_i, A_j] = sum f_ijk A_k, and the rates of a quaternion."""

    setting: Setting
    constants: tuple[tuple[tuple[sympy.Expr, ...], ...], ...]
    kinematics: tuple[sympy.Expr, ...]

    @property
    def basis(self) -> dict[str, ImmutableMatrix]:
        """The basis A1, A2, A3 by name."""
        return named(map(str, A), self.setting.basis())

    @property
    def attitude(self) -> Part:
        """The rates of an attitude that moves by (3)."""
        return Part(rates={f"q{k}": str(rate) for k, rate in enumerate(self.kinematics)})


def from_quaternion(name: str) -> ImmutableMatrix:
    """Return F of (1) and (2): q0 + q1 i + q2 j + q3 k -> ((z1, z2), (-z2*, z1*))."""
    return Setting().element(name)


def combination(x1: Symbol, x2: Symbol, x3: Symbol) -> MatrixExpr:
    """Return x1 A1 + x2 A2 + x3 A3, the paper's (8)."""
    return x1 * A1 + x2 * A2 + x3 * A3


# The momentum and the velocity as matrices.
MOMENTUM_MATRIX = {"M": combination(*MOMENTA)}
VELOCITY = {"Omega": combination(*RATES)}


def commutator(x: MatrixExpr, y: MatrixExpr) -> MatrixExpr:
    """Return the commutator [x, y] = x y - y x."""
    return MatAdd(x * y, -y * x, evaluate=False)


def derive(builder: LedgerBuilder) -> None:
    """Prove (1), (2), (4) and (3)."""
    setting = builder.result(Setting) if Setting in builder else Setting()
    group, form = setting.group, {"R": setting.element("q")}
    scope = Scope.open(builder, group, UNIT_QUATERNION, matrices=form, static=True)
    one = sympy.Identity(SIZE)
    why = "R of the form (1) is unitary" if group == "SU2" else "a rotation matrix is orthogonal"
    multiply(scope, f"{group}.unitary", R * R.adjoint(), one, why, [1])
    determinant(scope, f"{group}.special", R, "and its determinant is one", [1])
    builder.keep((_unitary if group == "SU2" else _orthogonal)(builder, setting))


def _unitary(builder: LedgerBuilder, setting: Setting) -> Algebra:
    """Read off the product of two quaternions, the brackets, and the rates of a quaternion."""
    pair = {"P": setting.element("p"), "Q": setting.element("q")}
    matrices = {**pair, **UNITS, **named(map(str, A), setting.basis()), **VELOCITY}
    scope = Scope.open(builder, "quaternions", PAIR, matrices=matrices, static=True)
    coordinates(scope, "product", P * Q, e, "the product of two quaternions", [2])
    constants = _brackets(scope)
    why = "R' = R Omega in the components of a quaternion"
    rates = coordinates(scope, "kinematics", Q * Omega, e, why, [3])
    return Algebra(setting, constants, rates.value)


def _orthogonal(builder: LedgerBuilder, setting: Setting) -> Algebra:
    """Prove that rotation matrices multiply as quaternions do, and read off the brackets.

    By that product R' = R Omega is q' = q omega, where Omega is the derivative of the rotation
    matrix at the identity along omega; euler_lax decides it (moving_body.kinematics).
    """
    p, q, s = (symbols(f"{x}0 {x}1 {x}2 {x}3") for x in "pqs")
    both = Part(definitions=named(s, product(p, q)))
    elements = {x.upper(): setting.element(x) for x in "pqs"}
    matrices = {**elements, **named(map(str, A), setting.basis())}
    scope = Scope.open(builder, "quaternions", PAIR, both, matrices=matrices, static=True)
    why = "two rotations are one by the product of their quaternions"
    multiply(scope, "product", P * Q, S, why, [2])
    rates = named(setting.order, RATES)
    omega = [setting.sign * setting.factor * rates[axis] for axis in AXES]
    turning = product(q, (sympy.S.Zero, *omega))
    return Algebra(setting, _brackets(scope), turning)


def _brackets(scope: Scope) -> tuple[tuple[tuple[sympy.Expr, ...], ...], ...]:
    """Return the structure constants: three brackets are decided, the others follow by signs."""
    found = {}
    for i, j in ((0, 1), (1, 2), (0, 2)):
        fact = f"quaternions.bracket_{i + 1}{j + 1}"
        why = f"the bracket of A{i + 1} and A{j + 1}, read off"
        step = coordinates(scope, fact, commutator(A[i], A[j]), A, why, [4])
        found[i, j] = step.value
        found[j, i] = tuple(-x for x in step.value)
    zero = (sympy.S.Zero,) * 3
    return tuple(tuple(found.get((i, j), zero) for j in range(3)) for i in range(3))
