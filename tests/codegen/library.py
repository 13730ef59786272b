"""A build of the C target, loaded as a library."""

import ctypes
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rigidsym._engines.library import load

ROOM = 8192


def numbers(values: Sequence[float] | np.ndarray) -> np.ndarray:
    """An array of doubles."""
    return np.ascontiguousarray(values, dtype=float)


class Library:
    """The functions of a build, on arrays; its header lies beside it."""

    def __init__(self, path: Path) -> None:
        name = "torque_free.h"
        self.c = load(path, {name: path.with_name(name).read_text("utf-8")})
        assert self.c.motion_size() <= ROOM

    def prepare(self, inertia, omega0, attitude0) -> tuple[int, ctypes.Array]:
        """A code, and the prepared."""
        prepared = ctypes.create_string_buffer(ROOM)
        given = [numbers(values) for values in (inertia, omega0, attitude0)]
        return self.c.motion_init(prepared, *given), prepared

    def plan_of_pairs(self, *pairs, unit) -> tuple[int, ctypes.Array]:
        """The same for numbers of two doubles."""
        prepared = ctypes.create_string_buffer(ROOM)
        given = [numbers(values) for values in pairs]
        return self.c.motion_init_double_doubles(prepared, *given, unit), prepared

    def states(self, prepared, times) -> tuple[int, np.ndarray]:
        """A code, and the states: rows of seven, NaN where nothing was written."""
        t = numbers(times)
        q, omega = np.full((len(t), 4), np.nan), np.full((len(t), 3), np.nan)
        code = self.c.states_at(prepared, len(t), t, q, omega)
        return code, np.hstack([q, omega])

    def grid(self, prepared, start, step, n, first=0) -> tuple[int, np.ndarray]:
        """The same at start + k step, k = first, first + 1, ..."""
        q, omega = np.full((n, 4), np.nan), np.full((n, 3), np.nan)
        code = self.c.states_on_grid(prepared, start, step, first, n, q, omega)
        return code, np.hstack([q, omega])

    def message(self, code: int) -> str:
        """What a code means."""
        return self.c.message(code).decode()
