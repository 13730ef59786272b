"""Common torques for `integrate`, each for many bodies at once.

A torque is any callable of the time (s), attitudes (..., 4) and rates (..., 3) that returns torques
(..., 3), N m in body axes.
"""

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.generated.torque_free_step import torque as by_direction
from rigidsym.quaternions import conjugate, product, rotated
from rigidsym.splitting._orbits import KeplerOrbit, tidal

Torque = Callable[[float, np.ndarray, np.ndarray], np.ndarray]
_NO_TURN = np.array([1.0, 0.0, 0.0, 0.0])


class DirectionTorque:
    """Torque that is a quadratic function of a vector's components in body axes.

    It is b + k v + v x (Q v - m), where v are the body components of a vector in space.

    source: the vector, (..., 3), or an orbit, on which it is `KeplerOrbit.tide`; coefficients (...,
    13): b, k, m, and Q11, Q22, Q33, Q23, Q13, Q12.  The ledger proves (`kick`) that the last two
    terms are the torque of v Q v / 2 - m v.  The C engine integrates these without Python in
    between.
    """

    more: tuple[int | None, int | None] = (None, None)
    "Addresses of a C function that adds to the torque, and of the data it receives."

    def __init__(self, source: np.ndarray | KeplerOrbit, coefficients: np.ndarray) -> None:
        self.source, self.coefficients = source, coefficients

    @property
    def is_steady(self) -> bool:
        """True if the torque is a smooth function of the attitude alone."""
        return isinstance(self.source, np.ndarray) and self.more == (None, None)

    def vector(self, t: float) -> np.ndarray:
        """Return the vector on which the torque depends, in inertial axes.

        It has the shape (..., 3).
        """
        return self.source.tide(t) if isinstance(self.source, KeplerOrbit) else self.source

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the torque in body axes, in N m.

        It has the shape (..., 3).
        """
        return by_direction(q, self.vector(t), self.coefficients)


class ConstantInBody(DirectionTorque):
    """Torque that is constant in body axes, such as that of a thruster.

    Parameters
    ----------
    torque : (..., 3)
        Torque, N m.
    """

    def __init__(self, torque: ArrayLike) -> None:
        self.torque = batches.array("torque", torque, last=(3,))
        super().__init__(np.zeros(3), _coefficients(b=self.torque))


class ConstantInSpace(DirectionTorque):
    """Torque that is constant in inertial axes.

    Parameters
    ----------
    torque : (..., 3)
        Torque, N m.
    """

    def __init__(self, torque: ArrayLike) -> None:
        self.torque = batches.array("torque", torque, last=(3,))
        super().__init__(self.torque, _coefficients(k=1.0))


class FieldPotential(DirectionTorque):
    """Torque on a dipole and a quadrupole in a constant field.

    The potential energy is v Q v / 2 - m v.  v are the field's components in body axes.

    Parameters
    ----------
    field : (..., 3)
        The field, in inertial axes.
    linear : (..., 3)
        m: the moment of a dipole in a magnetic field, or the mass times the lever from the pivot in
        a field of gravity.
    quadratic : (..., 3, 3)
        Q, symmetric.
    """

    def __init__(
        self,
        field: ArrayLike,
        *,
        linear: ArrayLike = (0, 0, 0),
        quadratic: ArrayLike = ((0, 0, 0),) * 3,
    ) -> None:
        self.field = batches.array("field", field, last=(3,))
        self.linear = batches.array("linear", linear, last=(3,))
        self.quadratic = batches.array("quadratic", quadratic, last=(3, 3))
        if not np.array_equal(self.quadratic, np.swapaxes(self.quadratic, -1, -2)):
            raise InputError("quadratic", self.quadratic.tolist(), "must be symmetric")
        super().__init__(self.field, _coefficients(m=self.linear, Q=self.quadratic))

    def energy(self, t: float, q: np.ndarray) -> np.ndarray:
        """Return the potential energy of the bodies, in J."""
        v = _in_body(q, self.field)
        quadratic = np.sum(v * np.squeeze(self.quadratic @ v[..., None], -1), axis=-1)
        return quadratic / 2 - np.sum(self.linear * v, axis=-1)


class Tide:
    """Gravity gradient torque on a body at a given position relative to a mass point.

    It is 3 mu / r^5 r x I r.

    Parameters
    ----------
    mu : float
        Gravitational parameter, m^3/s^2.
    inertia : (3,)
        Principal moments, kg m^2.
    """

    def __init__(self, mu: float, inertia: np.ndarray) -> None:
        self.mu, self.inertia = mu, inertia
        self._coefficients = _coefficients(Q=_differences(inertia))

    def __call__(self, position: np.ndarray) -> np.ndarray:
        """Return the torque at a position, N m in body axes.

        The position (3,), m, is in body axes as well.  The position is relative to the mass point.
        """
        return by_direction(_NO_TURN, tidal(self.mu, position), self._coefficients)


class GravityGradient(DirectionTorque):
    """Gravity gradient torque on bodies that follow one Kepler orbit.

    It is 3 mu / r^5 r x I r.  Source: Hughes, Spacecraft Attitude Dynamics, 8.1.

    Parameters
    ----------
    inertia : (..., 3)
        Principal moments, kg m^2.
    orbit : KeplerOrbit
        The orbit of all bodies.
    """

    def __init__(self, inertia: ArrayLike, orbit: KeplerOrbit) -> None:
        self.inertia, self.orbit = batches.array("inertia", inertia, last=(3,)), orbit
        super().__init__(orbit, _coefficients(Q=_differences(self.inertia)))

    def energy(self, t: float, q: np.ndarray) -> np.ndarray:
        """Return the part of the potential energy that depends on the attitude, in J.

        It is of second order in the size of the body (MacCullagh's formula).
        """
        return np.sum(self.inertia * _in_body(q, self.vector(t)) ** 2, axis=-1) / 2


@dataclass(frozen=True, slots=True)
class Potential:
    """Torque of a potential energy that depends on attitude and time.

    Only the change of the energy along rotations counts: the torque is -1/2 of the vector of
    conj(q) gradient, as q' = q (0, omega) / 2.

    Parameters
    ----------
    gradient : function
        Computes the energy's derivatives by the components of the quaternion, J, (..., 4), from the
        time (s) and attitudes (..., 4).
    """

    gradient: Callable[[float, np.ndarray], np.ndarray]

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the torque in body axes, in N m.

        It has the shape (..., 3).
        """
        return -0.5 * product(conjugate(q), np.asarray(self.gradient(t, q)))[..., 1:]


def _coefficients(
    b: ArrayLike = (0, 0, 0),
    k: float = 0.0,
    m: ArrayLike = (0, 0, 0),
    Q: ArrayLike = ((0, 0, 0),) * 3,
) -> np.ndarray:
    matrix = np.asarray(Q)
    # Of a symmetric matrix, in the order that the ledger's names have in the generated code.
    parts = matrix[..., [0, 1, 2, 1, 0, 0], [0, 1, 2, 2, 2, 1]]
    given = [np.asarray(x, float) for x in (b, [k], m)] + [parts]
    shape = np.broadcast_shapes(*(x.shape[:-1] for x in given))
    return np.concatenate([np.broadcast_to(x, (*shape, x.shape[-1])) for x in given], axis=-1)


def _differences(inertia: np.ndarray) -> np.ndarray:
    """Return diagonal matrices of the principal moments minus the smallest one.

    Their shape is (..., 3, 3).  The same moment about all axes exerts no torque.
    """
    return (inertia - np.min(inertia, axis=-1, keepdims=True))[..., None] * np.eye(3)


def _in_body(q: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Convert the components of a vector from inertial to body axes."""
    shape = np.broadcast_shapes(q.shape[:-1], vector.shape[:-1])
    return rotated(conjugate(q), np.broadcast_to(vector, (*shape, 3)))


_DOUBLES = ctypes.POINTER(ctypes.c_double)
SIGNATURE = ctypes.CFUNCTYPE(None, ctypes.c_double, _DOUBLES, _DOUBLES, ctypes.c_void_p)
"""void (double t, const double q[4], double torque[3], void *data)"""


class TorqueInC(DirectionTorque):
    """Torque that a compiled C function computes from time and attitude.

    It is in N m, in body axes.  The function is called from several threads where there are many
    bodies, and has to live as long as this object.  You compile it, by a C compiler or by numba:
    the package brings none.

    Parameters
    ----------
    function : ctypes function or int
        `void (double t, const double q[4], double torque[3], void *data)`, or its address, such as
        `numba.cfunc(...).address`.
    data : int
        Address of data that the function receives.
    """

    def __init__(self, function: Any, data: int | None = None) -> None:
        super().__init__(np.zeros(3), np.zeros(13))
        self._kept = function  # ctypes frees its memory with it
        if hasattr(function, "argtypes"):
            function = ctypes.cast(function, ctypes.c_void_p).value
        of_function = "must be a function of ctypes, or the address of one"
        if not _is_address(function) or not function:
            raise InputError("function", repr(function), of_function)
        if data is not None and not _is_address(data):
            raise InputError("data", repr(data), "must be an address, or None")
        self.more = function, data
        self._function = SIGNATURE(function)

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """Return the torque in body axes, in N m.

        It has the shape (..., 3).
        """
        found = np.zeros(omega.shape)
        attitudes = np.ascontiguousarray(q, float).reshape(-1, 4)
        for attitude, torque in zip(attitudes, found.reshape(-1, 3), strict=True):
            self._function(
                t, *(x.ctypes.data_as(_DOUBLES) for x in (attitude, torque)), self.more[1]
            )
        return found


def _is_address(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0
