"""Principal axes of inertia, conversion to and from them, and motions in the axes of a tensor."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _containers as containers
from rigidsym import _inputs as inputs
from rigidsym import _layers as layers
from rigidsym._frames import Sampled
from rigidsym.errors import InputError
from rigidsym.quaternions import conjugate, matrices, of_matrix, product
from rigidsym.sensitivity import Sensitivity

# The tolerance of symmetry, relative to the largest entry: both entries of a pair are copies.
SYMMETRY = 1e-9
# The rounding error of an eigenvalue, relative to the largest moment.
ROUNDING = 4 * float(np.finfo(float).eps)

# The entries of a tensor: xx, yy, zz, xy, xz, yz.
_ENTRIES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


@dataclass(frozen=True, slots=True, eq=False)
class PrincipalAxes:
    """Principal moments and principal axes of a rigid body.

    Parameters
    ----------
    moments : array (3,)
        Principal moments, ascending, kg m^2.
    matrix : array (3, 3)
        Its columns are the axes, right-handed: tensor = matrix diag(moments) matrix^T, and
        v = matrix v' where v' are components along the principal axes and v along the given ones.
    quaternion : array (4,)
        The same rotation, principal to given axes, scalar first, scalar part not negative: a body
        whose given axes have the attitude q has q' = q quaternion along the principal ones.
    """

    moments: np.ndarray
    matrix: np.ndarray
    quaternion: np.ndarray

    def to_principal(self, omega: ArrayLike, attitude: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Convert body rates and attitudes from the body's given axes to its principal axes.

        Their shapes are (..., 3) and (..., 4).  Returns omega0 and attitude0 of a motion.  Raises
        InputError for other shapes.
        """
        rates, q = _array("omega", omega, 3), _array("attitude", attitude, 4)
        return rates @ self.matrix, product(q, self.quaternion)

    def from_principal(self, q: ArrayLike, omega: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Convert attitudes and body rates from the principal axes to the body's given axes.

        Their shapes are (..., 4) and (..., 3).  Returns both in this order.  Raises InputError for
        other shapes.
        """
        attitude, rates = _array("q", q, 4), _array("omega", omega, 3)
        return product(attitude, conjugate(self.quaternion)), rates @ self.matrix.T

    def sensitivity(
        self,
        start: tuple[ArrayLike, ArrayLike],
        q: ArrayLike,
        omega: ArrayLike,
        found: Sensitivity,
    ) -> Sensitivity:
        """Convert derivatives of states from principal axes to given axes and the inertia tensor.

        Digits are lost where two moments are nearly equal.

        Parameters
        ----------
        start : pair of array_like (4,) and (3,)
            q and omega at t = 0, for the principal axes as the others.
        q, omega, found
            The results of `motion.sensitivity`.

        Returns
        -------
        Sensitivity
            With attitude and rates (..., 3, 12): by the small rotation in space, omega0 along the
            given axes, and the entries Ixx, Iyy, Izz, Ixy, Ixz, Iyz of the tensor, an entry and its
            mirror image together.

        Raises
        ------
        InputError
            Where two moments are equal: then the axes have no derivative.

        Examples
        --------
        >>> from rigidsym import TorqueFreeMotion
        >>> body = principal_axes([[2, 0, 0.1], [0, 3, 0], [0.1, 0, 4]])
        >>> rates, attitude = body.to_principal([0.1, 0.2, 0.3], [1, 0, 0, 0])
        >>> motion = TorqueFreeMotion(body.moments, rates, attitude)
        >>> body.sensitivity(motion(0.0), *motion.sensitivity([0.0, 5.0])).attitude.shape
        (2, 3, 12)
        """
        if len(found.columns) < 4:
            raise InputError("columns", ", ".join(found.columns), "a tensor's need all of them")
        turns, moments = self._by_tensor()
        q0, omega0 = _array("start[0]", start[0], 4), _array("start[1]", start[1], 3)
        rates = _array("omega", omega, 3)
        here = matrices(_array("q", q, 4))
        # Derivatives of inputs along the principal axes by those along the given ones.
        inputs_by = np.zeros((9, 12))
        inputs_by[:3, :3], inputs_by[3:6, 3:6] = np.eye(3), self.matrix.T
        inputs_by[:3, 6:] = matrices(q0) @ turns
        inputs_by[3:6, 6:] = -np.cross(turns, omega0[:, None], axis=0)
        inputs_by[6:, 6:] = moments
        attitude, faster = found.attitude @ inputs_by, found.rates @ inputs_by
        attitude[..., 6:] -= here @ turns
        faster[..., 6:] += np.cross(turns, rates[..., :, None], axis=-2)
        return Sensitivity(
            attitude, self.matrix @ faster, found.attitude_t, found.rates_t @ self.matrix.T
        )

    def _by_tensor(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the derivatives of axes and moments with respect to the tensor's entries.

        Both have the shape (3, 6).
        """
        m, axes = self.moments, self.matrix
        for i, j in ((0, 1), (1, 2)):
            if m[i] == m[j]:
                rule = "two are equal: their axes are any in a plane, and have no derivative"
                raise InputError("moments", _shown(m), rule)
        turns, moments = np.empty((3, 6)), np.empty((3, 6))
        for k, (i, j) in enumerate(_ENTRIES):
            change = np.zeros((3, 3))
            change[i, j] = change[j, i] = 1.0
            seen = axes.T @ change @ axes
            moments[:, k] = np.diag(seen)
            for x in range(3):
                y, z = (x + 1) % 3, (x + 2) % 3
                turns[x, k] = seen[z, y] / (m[y] - m[z])
        return turns, moments


# Properties of a motion that do not depend on the axes of the body.
_INVARIANT = (
    *("regime", "mode", "energy", "momentum", "parameter", "modulus", "period", "nutation"),
    *("circulation_rate", "precession_rate", "phase_per_period", "engine", "allow_nonphysical"),
)


@dataclass(frozen=True, eq=False, repr=False)
class TensorMotion(Sampled):
    """The motion of a torque-free rigid body, with states along the axes of its inertia tensor.

    `TorqueFreeMotion.from_tensor` makes it.  The principal axes are eigenvectors in float64: the
    states are those of a tensor that differs from the given one by rounding, a few 1e-16 of its
    largest entry.  They differ from those of the given tensor by 1e-15 rad, and by some 2e-16 rad
    more for each radian that the body turns, where the moments are well apart and the motion is not
    beside the separatrix.  Diagonal tensors have no such error.

    The regime and the other properties that do not depend on axes are those of `principal`:
    regime, mode, energy, momentum, parameter, modulus, period, nutation, circulation_rate,
    precession_rate, phase_per_period.  The regime is decided exactly for the rounded principal
    moments.  Whatever needs exact axes (precise, enclose, symbolic) is of `principal` alone.

    Attributes
    ----------
    principal : TorqueFreeMotion
        The motion along the principal axes.
    axes : PrincipalAxes
        The principal axes, which convert states.
    """

    principal: Any
    axes: PrincipalAxes

    def __call__(self, t: ArrayLike, errors: str = "raise") -> tuple[np.ndarray, np.ndarray]:
        """Return the attitude of the tensor's axes and the rates along them at times.

        Parameters, shapes and errors are those of a call of `TorqueFreeMotion`.
        """
        if layers.is_layered(t):
            return layers.called(self, {"t": t}, errors=errors)
        return self.axes.from_principal(*self.principal(t, errors=errors))

    def grid(self, start: float, step: float, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the states at the times start + k step, as `TorqueFreeMotion.grid` does."""
        return self.axes.from_principal(*self.principal.grid(start, step, count))

    def sensitivity(
        self, t: ArrayLike, errors: str = "raise"
    ) -> tuple[np.ndarray, np.ndarray, Sensitivity]:
        """Return the states at times, and their derivatives with respect to all inputs.

        Columns are by the small rotation at t = 0, omega0 along the tensor's axes, and the six
        entries of the tensor, as `PrincipalAxes.sensitivity` describes.  Raises InputError as a
        call does, and where two moments are equal.
        """
        q, omega, found = self.principal.sensitivity(t, errors)
        found = self.axes.sensitivity(self.principal(0.0), q, omega, found)
        return *self.axes.from_principal(q, omega), found

    def state_transition(self, t0: float, t: ArrayLike) -> np.ndarray:
        """Return the state transition matrices from t0 to each time.

        They are those of `TorqueFreeMotion.state_transition`, with rates along the tensor's axes.
        """
        turned = np.eye(6)
        turned[3:, 3:] = self.axes.matrix
        return turned @ self.principal.state_transition(t0, t) @ turned.T

    @property
    def mean_rates(self) -> tuple[float, ...]:
        """The rates along the tensor's axes, averaged over a period, in rad/s."""
        return tuple((self.axes.matrix @ self.principal.mean_rates).tolist())

    def __getattr__(self, name: str) -> Any:
        if name in _INVARIANT:
            return getattr(self.principal, name)
        if (
            name[:1] != "_"
            and name not in ("principal", "axes")
            and hasattr(type(self.principal), name)
        ):
            rule = "is along the principal axes only"
            raise AttributeError(
                f"{name}: {rule}: motion.principal.{name}, converted by motion.axes"
            )
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __repr__(self) -> str:
        return f"{self.principal!r}, with states along the axes of its tensor"


def principal_axes(tensor: ArrayLike) -> PrincipalAxes:
    """Return the principal moments and axes of an inertia tensor.

    The first two axes point to the side of their largest component; axes of equal moments are
    arbitrary.  Diagonal tensors are only put in order, without rounding.  `TorqueFreeMotion` checks
    that a body can have such moments.

    Parameters
    ----------
    tensor : array_like (3, 3)
        The inertia tensor, kg m^2; its products of inertia have the signs of -integral xy dm.  It
        has to be symmetric to 1e-9 of its largest entry, and is then made so.

    Raises
    ------
    InputError
        For a tensor that is not symmetric, finite and positive definite.

    Examples
    --------
    >>> body = principal_axes([[2, 0, 0], [0, 5, 1], [0, 1, 5]])
    >>> body.moments
    array([2., 4., 6.])
    >>> rates, attitude = body.to_principal([0.1, 0.2, 0.3], [1, 0, 0, 0])
    """
    rows = inputs.sequence("tensor", tensor, ndim=2, next_step="3 rows of 3 numbers")
    if len(rows) != 3:
        raise InputError("tensor", f"{len(rows)} rows", "must have 3 rows of 3 numbers")
    named = {f"tensor[{i}]": row for i, row in enumerate(rows)}
    exact = {n: inputs.certain(n, inputs.vector(n, row, 3)) for n, row in named.items()}
    given = np.array([inputs.doubles(n, x) for n, x in exact.items()])
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
    # Two axes point to the side of their largest component, the third makes them right-handed.
    first, second = (x * np.copysign(1.0, x[np.argmax(np.abs(x))]) for x in axes.T[:2])
    matrix = np.stack([first, second, np.cross(first, second)], axis=1)
    return PrincipalAxes(moments, matrix, of_matrix(matrix))


def _solved(tensor: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the eigenvalues of an inertia tensor in ascending order, and its eigenvectors.

    Eigenvalues that are rounding errors are set to zero.  Eigenvectors are columns.
    """
    if np.array_equal(tensor, np.diag(np.diag(tensor))):
        order = np.argsort(np.diag(tensor), kind="stable")
        return np.diag(tensor)[order], np.eye(3)[:, order]
    # Scaling by a power of two keeps squares in range, and rounds nothing.
    scale = np.exp2(np.floor(np.log2(np.max(np.abs(tensor)))))
    moments, axes = np.linalg.eigh(tensor / scale)
    small = np.abs(moments) < ROUNDING * np.max(moments)
    return np.where(small, 0.0, moments) * scale, axes


def _array(field: str, values: ArrayLike, size: int) -> np.ndarray:
    try:
        array = np.asarray(containers.plain(field, values), dtype=float)
    except (TypeError, ValueError):
        raise InputError(field, repr(values), "must be numbers") from None
    if array.shape[-1:] != (size,):
        raise InputError(field, f"shape {array.shape}", f"must be (..., {size})")
    return array


def _shown(moments: np.ndarray) -> str:
    return f"[{', '.join(f'{x:g}' for x in moments)}]"
