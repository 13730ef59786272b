"""Steps of many bodies, by NumPy or by C compiled here: the modules of the form `step`."""

import ctypes
from collections.abc import Callable
from types import ModuleType
from typing import Protocol

import numpy as np

from rigidsym.engines import threads
from rigidsym.engines.library import StepLibrary
from rigidsym.engines.protocol import EngineError, States
from rigidsym.generated import torque_free_step

_DOUBLE = ctypes.sizeof(ctypes.c_double)
# A step takes as long as this many states.
_STEP = 16


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


class NumpyStepper:
    """`rigidsym.generated.torque_free_step`, or a module like it, as a `Stepper`."""

    __slots__ = ("_module",)

    def __init__(self, module: ModuleType = torque_free_step) -> None:
        self._module = module

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """See `Stepper`."""
        try:
            self._module.step(self._module.prepare(inertia), q, omega, dt, out)
        except ValueError as error:
            field, _, rule = str(error).partition(": ")
            raise EngineError(field, rule, getattr(error, "body", None)) from None


class CStepper:
    """torque_free_step.c as a `Stepper`; threads share the bodies."""

    __slots__ = ("_library",)

    def __init__(self, library: StepLibrary) -> None:
        self._library = library

    def step(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        """See `Stepper`."""
        count, parts = len(q), threads.threads(len(q) * _STEP)
        part = self._part(inertia, q, omega, dt, out)
        for refused in threads.in_parts(part, count, parts, threads.PIECE // _STEP):
            if refused:
                raise self._refused(*refused)

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

    def _refused(self, code: int, body: int) -> EngineError:
        field, _, rule = self._library.message(code).decode().rpartition(": ")
        return EngineError(field or "omega", rule, body)
