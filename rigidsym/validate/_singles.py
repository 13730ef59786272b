"""C in single precision as an implementation that is measured."""

import ctypes
from collections.abc import Callable, Iterator
from ctypes import c_float
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import States
from rigidsym.errors import InputError

TARGETS = ("c_single", "c_single-step")
# More floats than the constants of a motion or a body take.
ROOM = 512
Prepared = ctypes.Array[c_float]
# Inertia (3,) as constants, q (4,) and omega (3,).
Start = tuple[Prepared, np.ndarray, np.ndarray]


@dataclass(frozen=True, slots=True)
class Singles:
    """States of motions in single precision, at times that are sums of two floats."""

    library: Any

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Compute the constants of one motion.

        Raises ValueError for inputs that are refused.
        """
        motion, given = (c_float * ROOM)(), [_floats(x) for x in (inertia, omega0, attitude0)]
        _checked(self.library.motion_init(motion, *(x.ctypes.data for x in given)))
        return motion

    def states(self, prepared: Prepared, t: ArrayLike) -> States:
        """Compute states at times, q (N, 4) and omega (N, 3).

        Raises ValueError for times that are refused.
        """
        times = np.atleast_1d(np.asarray(t, float))
        high = times.astype(np.float32)
        low = (times - high).astype(np.float32)

        def state(k: int, q: int, omega: int) -> int:
            return self.library.state_at_sum(prepared, high[k], low[k], q, omega)

        return _filled(len(times), state)

    def ways(self, prepared: Prepared, times: np.ndarray) -> Iterator[tuple[States, States]]:
        """Call the C functions in several ways, and yield computed and expected states."""
        t = _floats(times)
        expected = self.states(prepared, t)

        def state(k: int, q: int, omega: int) -> int:
            return self.library.state_at(prepared, t[k], q, omega)

        yield _filled(len(t), state), expected
        q, omega = np.empty((len(t), 4), np.float32), np.empty((len(t), 3), np.float32)
        addresses = (x.ctypes.data for x in (t, q, omega))
        _checked(self.library.states_at(prepared, len(t), *addresses))
        yield (q.astype(float), omega.astype(float)), expected


@dataclass(frozen=True, slots=True)
class SingleSteps:
    """States after one step from the start in single precision."""

    library: Any

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Start:
        """Compute the constants of a body, and copy the start.

        Raises ValueError for inputs that are refused.
        """
        body = (c_float * ROOM)()
        _checked(self.library.body_init(body, _floats(inertia).ctypes.data))
        return body, _floats(attitude0), _floats(omega0)

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """Compute the states after steps of t (N,) s, q (N, 4) and omega (N, 3).

        Raises ValueError for a step that is refused.
        """
        body, q0, omega0 = prepared
        times = np.atleast_1d(_floats(t))

        def step(k: int, q: int, omega: int) -> int:
            ctypes.memmove(q, q0.ctypes.data, q0.nbytes)
            ctypes.memmove(omega, omega0.ctypes.data, omega0.nbytes)
            return self.library.step(body, q, omega, times[k])

        return _filled(len(times), step)

    def ways(self, prepared: Start, times: np.ndarray) -> Iterator[tuple[States, States]]:
        """Take the steps in another order, and yield computed and expected states."""
        q, omega = self.states(prepared, times[::-1])
        yield (q[::-1], omega[::-1]), self.states(prepared, times)


@cache
def single(target: str) -> Singles | SingleSteps:
    """Return the implementation of a target, one of TARGETS.

    Raises InputError where it cannot be compiled.
    """
    # Here, because other targets need nothing of it.
    from rigidsym._engines.build import CompilerError, library
    from rigidsym._engines.library import LibraryError

    try:
        found = library([], target).raw
    except (CompilerError, LibraryError) as error:
        raise InputError("target", target, str(error)) from None
    return Singles(found) if target == TARGETS[0] else SingleSteps(found)


def _floats(values: ArrayLike) -> np.ndarray:
    with np.errstate(all="ignore"):
        return np.array(values, np.float32)


def _filled(count: int, state: Callable[[int, int, int], int]) -> States:
    """Return states that a function writes, given a number and two addresses."""
    q, omega = np.empty((count, 4), np.float32), np.empty((count, 3), np.float32)
    for k in range(count):
        _checked(state(k, q[k].ctypes.data, omega[k].ctypes.data))
    return q.astype(float), omega.astype(float)


def _checked(code: int) -> None:
    if code:
        raise ValueError(f"code {code}")
