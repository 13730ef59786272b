"""A torque that is a function of C: of the user's own, compiled by whatever compiles."""

import ctypes
from typing import Any

import numpy as np

from rigidsym.errors import InputError
from rigidsym.splitting.torques import DirectionTorque

_DOUBLES = ctypes.POINTER(ctypes.c_double)
SIGNATURE = ctypes.CFUNCTYPE(None, ctypes.c_double, _DOUBLES, _DOUBLES, ctypes.c_void_p)
"""void (double t, const double q[4], double torque[3], void *data)"""


class TorqueInC(DirectionTorque):
    """What a function adds to the torque on a body: N m in body axes, of time (s) and attitude.

    function: `void (double t, const double q[4], double torque[3], void *data)`, one of ctypes or
    an address, such as `numba.cfunc(...).address`; data: the address of what it is handed.  It is
    called from several threads where there are many bodies, and has to live as long as this does.
    """

    def __init__(self, function: Any, data: int | None = None) -> None:
        super().__init__(np.zeros(3), np.zeros(13))
        self._given = function
        self.more = _address(function), _whole("data", data)
        self._function = SIGNATURE(self.more[0])

    def __call__(self, t: float, q: np.ndarray, omega: np.ndarray) -> np.ndarray:
        """N m, (..., 3)."""
        found = np.zeros(omega.shape)
        attitudes = np.ascontiguousarray(q, float).reshape(-1, 4)
        for attitude, torque in zip(attitudes, found.reshape(-1, 3), strict=True):
            self._function(
                t, *(x.ctypes.data_as(_DOUBLES) for x in (attitude, torque)), self.more[1]
            )
        return found


def _address(function: Any) -> int:
    if hasattr(function, "argtypes"):
        function = ctypes.cast(function, ctypes.c_void_p).value
    rule = "must be a function of ctypes, or the address of one"
    if not (address := _whole("function", function, rule)):
        raise InputError("function", function, rule)
    return address


def _whole(field: str, value: Any, rule: str = "must be an address, or None") -> int | None:
    if value is not None and (isinstance(value, bool) or not isinstance(value, int) or value < 0):
        raise InputError(field, repr(value), rule)
    return value
