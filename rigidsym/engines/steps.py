"""Steps of many bodies, by NumPy or by C compiled here: the modules of the form `step`; and by C
their steps and kicks in turn.
"""

import ctypes
import struct
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import ModuleType
from typing import Protocol

import numpy as np

from rigidsym.engines import threads
from rigidsym.engines.library import Library
from rigidsym.engines.protocol import EngineError, Outputs, States
from rigidsym.generated import torque_free_step

_DOUBLE = ctypes.sizeof(ctypes.c_double)
# A step takes as long as this many states.
_STEP = 16
# Bodies that a thread takes at a time.
_SOME = 64
# Bodies whose constants are kept for their next step, when they step alone.
_KEPT = 256
Moments = tuple[float, ...]


class _Torque(ctypes.Structure):
    """torque_free_torque."""

    _fields_ = (
        ("coefficients", ctypes.c_void_p),
        ("coefficients_stride", ctypes.c_size_t),
        ("vector", ctypes.c_void_p),
        ("vector_stride", ctypes.c_size_t),
        ("orbit", ctypes.c_void_p),
        ("more", ctypes.c_void_p),
        ("data", ctypes.c_void_p),
    )


class _Splitting(ctypes.Structure):
    """torque_free_splitting."""

    _fields_ = (
        ("count", ctypes.c_size_t),
        ("drifts", ctypes.c_void_p),
        ("kicks", ctypes.c_void_p),
    )


@dataclass(frozen=True, slots=True)
class Kicks:
    """Bodies and what pushes them, in steps of a splitting method; float64, each in one piece.

    inertia (B, 3), coefficients (B, 13) and vector (B, 3), or one row for all; orbit (11,), which
    takes the vector's place: as in torque_free_step.h.  drifts (S + 1,), kicks (S,).  more: the
    addresses of a function that adds to the torque, and of what it is handed.
    """

    inertia: np.ndarray
    coefficients: np.ndarray
    vector: np.ndarray | None
    orbit: np.ndarray | None
    drifts: np.ndarray
    kicks: np.ndarray
    more: tuple[int | None, int | None] = (None, None)

    def torque(self, first: int) -> _Torque:
        """For torque_free_integrate, of bodies from one on."""
        coefficients = _from(self.coefficients, first)
        vector = (None, 0) if self.vector is None else _from(self.vector, first)
        orbit = None if self.orbit is None else self.orbit.ctypes.data
        return _Torque(*coefficients, *vector, orbit, *self.more)

    def splitting(self) -> _Splitting:
        """For torque_free_integrate."""
        return _Splitting(len(self.kicks), self.drifts.ctypes.data, self.kicks.ctypes.data)


def _from(rows: np.ndarray, first: int) -> tuple[int, int]:
    """The address of a row and the numbers from one to the next: 0 where one serves all."""
    stride = rows.shape[1] if len(rows) > 1 else 0
    return rows.ctypes.data + first * stride * _DOUBLE, stride


class Stepper(Protocol):
    """What makes steps."""

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """The motion of B bodies after dt, to out, which may be (q, omega).

        inertia (B, 3) or (1, 3), q (B, 4), omega (B, 3), dt (B,) or (1,), each float64 in one piece
        of memory.  Raises EngineError with the index of the first body that is refused.
        """
        ...

    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """Return q (4,) and omega (3,) of one body of Python's floats, with the bits of `step`.

        They are new arrays, or those of out.  Return None, and write nothing, for a body that
        `step` refuses or that leaves binary64 on the way.
        """
        ...


class NumpyStepper:
    """`rigidsym.generated.torque_free_step`, or a module like it, as a `Stepper`."""

    __slots__ = ("_body", "_module")

    def __init__(self, module: ModuleType = torque_free_step) -> None:
        self._module = module
        self._body = lru_cache(_KEPT)(module.prepare)

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """See `Stepper`."""
        if len(q) == 1 and _step_one(self, inertia, q, omega, dt, out):
            return
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
        """See `Stepper`."""
        try:
            after = self._module.step_one(self._body(inertia), q, omega, dt)
        except (ValueError, ArithmeticError):
            return None
        if out is None:
            return np.array(after[0]), np.array(after[1])
        out[0][...], out[1][...] = after
        return out


def _step_one(
    stepper: "Stepper",
    inertia: np.ndarray,
    q: np.ndarray,
    omega: np.ndarray,
    dt: np.ndarray,
    out: States,
) -> States | None:
    """Step one row by `one`."""
    given = tuple(inertia[0].tolist()), q[0].tolist(), omega[0].tolist(), float(dt[0])
    return stepper.one(*given, (out[0][0], out[1][0]))


class _Room(threading.local):
    """A state in memory that each thread has of its own, the addresses of q and omega, and both as
    arrays."""

    def __init__(self) -> None:
        state = (ctypes.c_double * 7)()
        place, numbers = ctypes.addressof(state), np.frombuffer(memoryview(state), float)
        self.state = state, place, place + 4 * _DOUBLE, numbers[:4], numbers[4:]


class CStepper:
    """torque_free_step.c as a `Stepper`; threads share the bodies."""

    __slots__ = ("_body", "_library", "_put", "_room", "_step")

    def __init__(self, library: Library) -> None:
        self._library = library.raw
        self._step = self._library.step
        self._body = lru_cache(_KEPT)(self._prepared)
        self._room, self._put = _Room(), struct.Struct("7d").pack_into

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """See `Stepper`."""
        if len(q) == 1 and _step_one(self, inertia, q, omega, dt, out):
            return
        if not len(q):
            return
        count, parts = len(q), threads.threads(len(q) * _STEP)
        part = self._part(inertia, q, omega, dt, out)
        for refused in threads.in_parts(part, count, parts, threads.PIECE // _STEP):
            if refused:
                raise self._refused(*refused)

    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """See `Stepper`."""
        body = self._body(inertia)
        state, place, omega_place, q_after, omega_after = self._room.state
        self._put(state, 0, *q, *omega)
        if body is None or self._step(body, place, omega_place, dt):
            return None
        if out is None:
            return q_after.copy(), omega_after.copy()
        out[0][...] = q_after
        out[1][...] = omega_after
        return out

    def _prepared(self, inertia: Moments) -> ctypes.Array[ctypes.c_double] | None:
        """The constants of a body, or None for one that is refused."""
        body = (ctypes.c_double * -(-self._library.body_size() // _DOUBLE))()
        return None if self._library.body_init(body, (ctypes.c_double * 3)(*inertia)) else body

    def _part(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> Callable[[int, int], tuple[int, int] | None]:
        """The steps of bodies begin to end: the code and the number of one that is refused."""
        arrays = (inertia, q, omega, dt, *out)
        strides = tuple(x[0].size if len(x) == len(q) else 0 for x in arrays)
        if len(q) == 1:
            strides = (3, 4, 3, 1, 4, 3)
        places = [x.ctypes.data for x in arrays]

        def part(begin: int, end: int) -> tuple[int, int] | None:
            moved = [
                place + begin * stride * _DOUBLE
                for place, stride in zip(places, strides, strict=True)
            ]
            failed = ctypes.c_size_t(0)
            given = (moved[0], strides[0], moved[1], moved[2], moved[3], strides[3])
            last = (moved[4], moved[5], ctypes.addressof(failed))
            code = self._library.steps(end - begin, *given, *last)
            return (code, begin + failed.value) if code else None

        return part

    def integrate(
        self, kicks: Kicks, span: tuple[float, float, int, int], q: np.ndarray, omega: np.ndarray
    ) -> None:
        """Steps of B bodies q (B, 4), omega (B, 3), in place; threads share the bodies.

        span: the time begin (s), the step, and between which numbers of steps from there.  Raises
        EngineError for the first body that is refused; states are undefined then.
        """
        begin, step, first, last = span
        splitting = kicks.splitting()

        def part(start: int, end: int) -> tuple[int, int] | None:
            failed, torque = ctypes.c_size_t(0), kicks.torque(start)
            code = self._library.integrate(
                *(end - start, *_from(kicks.inertia, start)),
                *(ctypes.addressof(splitting), ctypes.addressof(torque)),
                *(begin, step, first, last),
                *(q[start:end].ctypes.data, omega[start:end].ctypes.data),
                ctypes.addressof(failed),
            )
            return (code, start + failed.value) if code else None

        work = len(q) * _STEP * (last - first) * len(kicks.kicks)
        parts = threads.threads(work) if len(q) > _SOME else 1
        for refused in threads.in_parts(part, len(q), parts, _SOME):
            if refused:
                raise self._refused(*refused)

    def _refused(self, code: int, body: int) -> EngineError:
        field, rule = self._library.field(code).decode(), self._library.rule(code).decode()
        return EngineError(field or "omega", rule, body)
