"""Hamilton's quaternions over any commutative ring, scalar part first."""

from collections.abc import Sequence
from typing import Any

from sympy import Expr, expand, symbols


def product(p: Sequence[Any], q: Sequence[Any], handedness: Any = 1) -> tuple[Any, Any, Any, Any]:
    """Return the Hamilton product of two quaternions.

    For handedness 1, i j = k; for handedness -1, i j = -k.
    """
    p0, p1, p2, p3 = p
    q0, q1, q2, q3 = q
    return (
        p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
        p0 * q1 + p1 * q0 + handedness * (p2 * q3 - p3 * q2),
        p0 * q2 + p2 * q0 + handedness * (p3 * q1 - p1 * q3),
        p0 * q3 + p3 * q0 + handedness * (p1 * q2 - p2 * q1),
    )


def kinematics(q: str, rates: str, handedness: Any = 1) -> dict[str, Expr]:
    """Return the kinematic equations q' = q (0, Omega)/2 of a quaternion.

    For example: `kinematics("q0 q1 q2 q3", "O1 O2 O3")`.
    """
    turned = product(symbols(q), (0, *symbols(rates)), handedness)
    return {f"D({name})": side / 2 for name, side in zip(q.split(), turned, strict=True)}


def rotated(q: Sequence[Expr], vector: Sequence[Any], handedness: Any = 1) -> list[Expr]:
    """Return the rotated vector q v q^-1 for a unit quaternion q.

    The components are expanded.
    """
    turned = product(product(q, (0, *vector), handedness), conjugate(q), handedness)
    return [expand(component) for component in turned[1:]]


def conjugate(q: Sequence[Any]) -> tuple[Any, Any, Any, Any]:
    """Return the conjugate of a quaternion.

    It is the inverse of a unit quaternion.
    """
    return q[0], -1 * q[1], -1 * q[2], -1 * q[3]
