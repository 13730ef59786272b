"""Principal axes of a body: from its inertia tensor to what `TorqueFreeMotion` takes, and back."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import inputs
from rigidsym.errors import InputError
from rigidsym.quaternions import conjugate, of_matrix, product

# Of the largest entry: tensors are often known to a few digits, but these are the same ones twice.
SYMMETRY = 1e-9
# Of the largest moment: what rounding makes of an eigenvalue.
ROUNDING = 4 * float(np.finfo(float).eps)


@dataclass(frozen=True, slots=True, eq=False)
class PrincipalAxes:
    """Principal moments (3,), ascending, in kg m^2, and where their axes lie in the body.

    matrix (3, 3): its columns are the axes, right-handed: tensor = matrix diag(moments) matrix^T,
    and v = matrix v' where v' are components along the principal axes and v along the given ones.
    quaternion (4,): the same rotation, principal to given axes, scalar first, scalar part not
    negative: a body whose given axes have the attitude q has q' = q quaternion along the others.
    """

    moments: np.ndarray
    matrix: np.ndarray
    quaternion: np.ndarray

    def to_principal(self, omega: ArrayLike, attitude: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Rates (..., 3) and attitudes (..., 4) of the principal axes, from those of the given
        ones: `omega0` and `attitude0` of a motion.  Raises InputError for other shapes."""
        rates, q = _array("omega", omega, 3), _array("attitude", attitude, 4)
        return rates @ self.matrix, product(q, self.quaternion)

    def from_principal(self, q: ArrayLike, omega: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Attitudes (..., 4) and rates (..., 3) of the given axes, from what a motion returns for
        the principal ones.  Raises InputError for other shapes."""
        attitude, rates = _array("q", q, 4), _array("omega", omega, 3)
        return product(attitude, conjugate(self.quaternion)), rates @ self.matrix.T


def principal_axes(tensor: ArrayLike) -> PrincipalAxes:
    """The principal moments and axes of an inertia tensor (3, 3) in kg m^2.

    The tensor has to be symmetric to 1e-9 of its largest entry, and is then made so; the signs of
    its products of inertia are those of -integral xy dm.  The first two axes point to the side of
    their largest component; axes of equal moments are any.  Diagonal tensors are only put in order,
    without rounding.  Raises InputError for what is not symmetric, finite and positive definite;
    whether a body can have such moments, `TorqueFreeMotion` asks.

    >>> body = principal_axes([[2, 0, 0], [0, 5, 1], [0, 1, 5]])
    >>> body.moments
    array([2., 4., 6.])
    >>> rates, attitude = body.to_principal([0.1, 0.2, 0.3], [1, 0, 0, 0])
    """
    given = _entries(tensor)
    size = float(np.max(np.abs(given)))
    apart = np.abs(given - given.T)
    i, j = (int(k) for k in np.unravel_index(np.argmax(apart), apart.shape))
    if apart[i, j] > SYMMETRY * size:
        rule = f"but tensor[{j}][{i}] = {given[j, i]:g}: an inertia tensor is symmetric"
        raise InputError(f"tensor[{i}][{j}]", f"{given[i, j]:g}", rule)
    moments, axes = _solved(given / 2 + given.T / 2)
    if not moments[0] > 0:
        value = f"one of principal moments {_shown(moments)}"
        raise InputError("tensor", value, "principal moments must be positive")
    matrix = _right_handed(axes)
    return PrincipalAxes(moments, matrix, of_matrix(matrix))


def _entries(tensor: ArrayLike) -> np.ndarray:
    rows = inputs.sequence("tensor", tensor, ndim=2)
    if len(rows) != 3:
        raise InputError("tensor", f"{len(rows)} rows", "must have 3 rows of 3 numbers")
    names = [f"tensor[{i}]" for i in range(3)]
    exact = [
        inputs.certain(name, inputs.vector(name, row, 3))
        for name, row in zip(names, rows, strict=True)
    ]
    return np.array([inputs.doubles(name, row) for name, row in zip(names, exact, strict=True)])


def _solved(tensor: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Moments, ascending, zero where rounding may have made them, and axes as columns."""
    if np.array_equal(tensor, np.diag(np.diag(tensor))):
        order = np.argsort(np.diag(tensor), kind="stable")
        return np.diag(tensor)[order], np.eye(3)[:, order]
    # A power of two keeps squares in the range and rounds nothing.
    scale = np.exp2(np.floor(np.log2(np.max(np.abs(tensor)))))
    moments, axes = np.linalg.eigh(tensor / scale)
    small = np.abs(moments) < ROUNDING * np.max(moments)
    return np.where(small, 0.0, moments) * scale, axes


def _right_handed(axes: np.ndarray) -> np.ndarray:
    """The same axes: two point to the side of their largest component, the third as it has to."""
    first, second = (x * np.copysign(1.0, x[np.argmax(np.abs(x))]) for x in axes.T[:2])
    return np.stack([first, second, np.cross(first, second)], axis=1)


def _array(field: str, values: ArrayLike, size: int) -> np.ndarray:
    try:
        array = np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError(field, repr(values), "must be numbers") from None
    if array.shape[-1:] != (size,):
        raise InputError(field, f"shape {array.shape}", f"must be (..., {size})")
    return array


def _shown(moments: np.ndarray) -> str:
    return f"[{', '.join(f'{x:g}' for x in moments)}]"
