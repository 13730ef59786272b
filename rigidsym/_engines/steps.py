"""Single time steps of many bodies by NumPy or C, and integration under torques by C."""

import ctypes
import struct
import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import ModuleType

import numpy as np

from rigidsym._engines import threads
from rigidsym._engines.arrays import Outputs, States
from rigidsym._engines.library import Library
from rigidsym.errors import EngineError
from rigidsym.generated import torque_free_step

_DOUBLE = ctypes.sizeof(ctypes.c_double)
# A step takes as long as this many states.
STEP = 16
# Bodies that a thread takes at a time.
_SOME = 64
# Bodies whose constants are kept for their next step, when they step alone.
_KEPT = 256
Moments = tuple[float, ...]


class _Torque(ctypes.Structure):
    """The C struct torque_free_torque."""

    _fields_ = (
        *(("coefficients", ctypes.c_void_p), ("coefficients_stride", ctypes.c_size_t)),
        *(("vector", ctypes.c_void_p), ("vector_stride", ctypes.c_size_t)),
        *((name, ctypes.c_void_p) for name in ("orbit", "more", "data")),
    )


class _Splitting(ctypes.Structure):
    """The C struct torque_free_splitting."""

    _fields_ = (
        ("count", ctypes.c_size_t),
        *((name, ctypes.c_void_p) for name in ("drifts", "kicks")),
    )


@dataclass(frozen=True, slots=True)
class KickInputs:
    """Inputs of an integration in C: bodies, torque and splitting method.

    Arrays are contiguous and float64.

    inertia (B, 3), coefficients (B, 13) and vector (B, 3), or one row for all; orbit (11,), which
    takes the vector's place: as in torque_free_step.h.  drifts (S + 1,), kicks (S,).  more: the
    addresses of a function that adds to the torque, and of its data.
    """

    inertia: np.ndarray
    coefficients: np.ndarray
    vector: np.ndarray | None
    orbit: np.ndarray | None
    drifts: np.ndarray
    kicks: np.ndarray
    more: tuple[int | None, int | None] = (None, None)


def _from(rows: np.ndarray, first: int) -> tuple[int, int]:
    """Return the memory address of a row, and the stride between rows.

    The stride is 0 if all bodies share one row.
    """
    stride = rows.size // len(rows) if len(rows) > 1 else 0
    return rows.ctypes.data + first * stride * _DOUBLE, stride


class Stepper(ABC):
    """Abstract engine that advances torque-free bodies by one time step.

    It uses a generated module of the form `step`.
    """

    __slots__ = ()

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """Compute the states of many bodies after a time step, and write them to arrays.

        out: the arrays, which may be (q, omega) themselves; B: the number of bodies.  inertia (B,
        3) or (1, 3), q (B, 4), omega (B, 3), dt (B,) or (1,), each float64 in one piece of memory.
        Raises EngineError with the index of the first body that is refused.
        """
        if len(q) == 1:
            moments, start = tuple(inertia[0].tolist()), (q[0].tolist(), omega[0].tolist())
            if self.one(moments, *start, float(dt[0]), (out[0][0], out[1][0])):
                return
        if len(q):
            self._steps(inertia, q, omega, dt, out)

    @abstractmethod
    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """Return the state of one body after a time step.

        It is q (4,) and omega (3,) after dt, with the same bits as `step`.  They are new arrays, or
        those of out.  Return None, and write nothing, for a body that `step` refuses or that leaves
        binary64 on the way.
        """

    @abstractmethod
    def _steps(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """Compute the states of many bodies after a time step.

        Raises EngineError for the first body that is refused.
        """


class NumpyStepper(Stepper):
    """Stepper that calls a generated NumPy module.

    By default this is `rigidsym.generated.torque_free_step`.
    """

    __slots__ = ("_body", "_module")

    def __init__(self, module: ModuleType = torque_free_step) -> None:
        self._module = module
        self._body = lru_cache(_KEPT)(module.prepare)

    def _steps(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        try:
            self._module.step(self._module.prepare(inertia), q, omega, dt, out)
        except self._module._RefusedError as error:
            raise EngineError(error.field, error.rule, error.body) from None

    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """Advance one body by one time step, using the NumPy module.

        Returns None for a body that the module refuses.
        """
        try:
            after = self._module.step_one(self._body(inertia), q, omega, dt)
        except (ValueError, ArithmeticError):
            return None
        if out is None:
            return np.array(after[0]), np.array(after[1])
        out[0][...], out[1][...] = after
        return out


class _Memory(threading.local):
    """Thread-local memory for one state, with its addresses and arrays."""

    def __init__(self) -> None:
        state = (ctypes.c_double * 7)()
        address, numbers = ctypes.addressof(state), np.frombuffer(memoryview(state), float)
        self.state = state, address, address + 4 * _DOUBLE, numbers[:4], numbers[4:]


class CStepper(Stepper):
    """Stepper that calls the compiled C module.

    The module is torque_free_step.c.  Threads share the bodies.
    """

    __slots__ = ("_body", "_memory", "_put", "_step", "library")

    def __init__(self, library: Library) -> None:
        raw = self.library = library.raw
        self._step = raw.step
        size = -(-raw.body_size() // _DOUBLE)

        @lru_cache(_KEPT)
        def prepared(inertia: Moments) -> ctypes.Array[ctypes.c_double] | None:
            """Return the constants of a body, or None if the C library refuses the body."""
            body = (ctypes.c_double * size)()
            return None if raw.body_init(body, (ctypes.c_double * 3)(*inertia)) else body

        self._body = prepared
        self._memory, self._put = _Memory(), struct.Struct("7d").pack_into

    def _steps(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        def piece(begin: int, end: int) -> tuple[int, int] | None:
            rows = [_from(x, begin) for x in (inertia, q, omega, dt, *out)]
            failed = ctypes.c_size_t(0)
            before = (*rows[0], rows[1][0], rows[2][0], *rows[3])
            after = (rows[4][0], rows[5][0], ctypes.addressof(failed))
            code = self.library.steps(end - begin, *before, *after)
            return (code, begin + failed.value) if code else None

        parts = threads.threads(len(q) * STEP)
        self._run(piece, len(q), parts, threads.PIECE // STEP)

    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """Advance one body by one time step, using the C library.

        Returns None for a body that the library refuses.
        """
        body = self._body(inertia)
        state, at_q, at_omega, q_after, omega_after = self._memory.state
        self._put(state, 0, *q, *omega)
        if body is None or self._step(body, at_q, at_omega, dt):
            return None
        if out is None:
            return q_after.copy(), omega_after.copy()
        out[0][...] = q_after
        out[1][...] = omega_after
        return out

    def integrate(
        self,
        kicks: KickInputs,
        span: tuple[float, float, int, int],
        q: np.ndarray,
        omega: np.ndarray,
    ) -> None:
        """Integrate the motion of bodies under a torque, in place.

        q (B, 4), omega (B, 3): the states, which are overwritten.  Threads share the bodies.  span:
        the time begin (s), the step (s), and the first and last number of steps.  Raises
        EngineError for the first body that is refused; states are undefined then.
        """
        begin, step, first, last = span
        splitting = _Splitting(len(kicks.kicks), kicks.drifts.ctypes.data, kicks.kicks.ctypes.data)
        orbit = None if kicks.orbit is None else kicks.orbit.ctypes.data

        def piece(start: int, end: int) -> tuple[int, int] | None:
            vector = (None, 0) if kicks.vector is None else _from(kicks.vector, start)
            torque = _Torque(*_from(kicks.coefficients, start), *vector, orbit, *kicks.more)
            failed = ctypes.c_size_t(0)
            code = self.library.integrate(
                *(end - start, *_from(kicks.inertia, start)),
                *(ctypes.addressof(splitting), ctypes.addressof(torque)),
                *(begin, step, first, last),
                *(q[start:end].ctypes.data, omega[start:end].ctypes.data),
                ctypes.addressof(failed),
            )
            return (code, start + failed.value) if code else None

        work = len(q) * STEP * (last - first) * len(kicks.kicks)
        self._run(piece, len(q), threads.threads(work) if len(q) > _SOME else 1, _SOME)

    def _run(
        self, piece: Callable[[int, int], tuple[int, int] | None], count: int, parts: int, some: int
    ) -> None:
        """Divide the computation of many bodies among threads.

        Raises EngineError for the first refused body.
        """
        for refused in threads.in_parts(piece, count, parts, some):
            if refused:
                code, body = refused
                field, rule = (x(code).decode() for x in (self.library.field, self.library.rule))
                raise EngineError(field or "omega", rule, body)
