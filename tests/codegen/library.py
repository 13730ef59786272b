"""A build of the C target, loaded as a library."""

import ctypes
from collections.abc import Sequence
from pathlib import Path

import numpy as np

ROOM = 8192
_NUMBERS = ctypes.POINTER(ctypes.c_double)


def numbers(values: Sequence[float] | np.ndarray) -> np.ndarray:
    """An array of doubles."""
    return np.ascontiguousarray(values, dtype=float)


def _pointer(array: np.ndarray) -> ctypes.Array:
    return array.ctypes.data_as(_NUMBERS)


class Library:
    """The functions of a build, on arrays."""

    def __init__(self, path: Path) -> None:
        self._c = ctypes.CDLL(str(path))
        self._c.torque_free_message.restype = ctypes.c_char_p
        self._c.torque_free_motion_size.restype = ctypes.c_size_t
        assert self._c.torque_free_motion_size() <= ROOM

    def prepare(self, inertia, omega0, attitude0) -> tuple[int, ctypes.Array]:
        """A code, and the prepared."""
        prepared = ctypes.create_string_buffer(ROOM)
        given = [numbers(values) for values in (inertia, omega0, attitude0)]
        return self._c.torque_free_motion_init(prepared, *map(_pointer, given)), prepared

    def plan_of_pairs(self, *pairs, unit) -> tuple[int, ctypes.Array]:
        """The same for numbers of two doubles."""
        prepared = ctypes.create_string_buffer(ROOM)
        given = [numbers(values) for values in pairs]
        code = self._c.torque_free_motion_init_double_doubles(
            prepared, *map(_pointer, given), ctypes.c_double(unit)
        )
        return code, prepared

    def states(self, prepared, times) -> tuple[int, np.ndarray]:
        """A code, and the states: rows of seven, NaN where nothing was written."""
        t = numbers(times)
        q, omega = np.full((len(t), 4), np.nan), np.full((len(t), 3), np.nan)
        code = self._c.torque_free_states_at(
            prepared, ctypes.c_size_t(len(t)), _pointer(t), _pointer(q), _pointer(omega)
        )
        return code, np.hstack([q, omega])

    def grid(self, prepared, start, step, n, first=0) -> tuple[int, np.ndarray]:
        """The same at start + k step, k = first, first + 1, ..."""
        q, omega = np.full((n, 4), np.nan), np.full((n, 3), np.nan)
        code = self._c.torque_free_states_on_grid(
            prepared,
            ctypes.c_double(start),
            ctypes.c_double(step),
            ctypes.c_size_t(first),
            ctypes.c_size_t(n),
            _pointer(q),
            _pointer(omega),
        )
        return code, np.hstack([q, omega])

    def message(self, code: int) -> str:
        """What a code means."""
        return self._c.torque_free_message(code).decode()
