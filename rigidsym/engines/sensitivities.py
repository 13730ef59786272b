"""States with what they change by: by the modules of the theta form, NumPy's or C's."""

import ctypes
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NoReturn, Protocol, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import arrays, threads
from rigidsym.engines.c_engine import PREPARATION, CEngine, offset
from rigidsym.engines.numpy_engine import Module, NumpyEngine, in_blocks
from rigidsym.engines.protocol import EngineError, Prepared, Sensitivities

# A time at which squares of changes leave binary64, in torque_free.h.
_GROWTH = 9
# Doubles of each array in a state with its sensitivities, which takes as long as so many states.
_SIZES = tuple(map(math.prod, arrays.SENSITIVITIES))
_STATES = 8
# One time before all arrays, each after the other, by the byte.
_Numbers = ctypes.c_double * (1 + sum(_SIZES))
_DOUBLE = ctypes.sizeof(ctypes.c_double)
_BEGINS = tuple(_DOUBLE * sum((1, *_SIZES[:k])) for k in range(len(_SIZES)))


class Sensitive(Protocol):
    """What finds `Sensitivities`; times, errors and what is raised are those of an `Engine`."""

    def sensitivities(
        self, prepared: Prepared, t: ArrayLike, errors: str = "raise"
    ) -> Sensitivities:
        """Of one motion, by the unit that inner moments are times."""
        ...

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
    ) -> Sensitivities:
        """Of many bodies, whose leading shapes broadcast as in `Engine.propagate`."""
        ...


def sensitive(engine: object) -> Sensitive:
    """What goes with an engine's prepared motions; raises EngineError where nothing does."""
    if isinstance(engine, CEngine):
        one = engine.library.states_with_sensitivity
        many = engine.library.propagate_with_sensitivity
        if one and many:
            return _C(engine, one, many)
    if isinstance(engine, NumpyEngine) and _offers(engine.module):
        return _Numpy(engine.module)
    raise EngineError("engine", "its module has no sensitivities")


def by_exact_moments(found: Sensitivities, inertia: Sequence[Fraction]) -> None:
    """Make sensitivities of a motion prepared exactly those by moments in kg m^2: these were
    divided by a power of two."""
    # Here, because doubles need nothing of it.
    from rigidsym.engines.exact_inputs import moment_unit

    for columns in found[2:4]:
        columns[..., 6:] /= moment_unit(inertia)


class _Module(Module, Protocol):
    """What the generated module of the theta form offers beyond states."""

    def sensitivities(self, prepared: Prepared, t: ArrayLike, errors: str = ...) -> Sensitivities:
        """States and what they change by."""
        ...


def _offers(module: Module) -> TypeGuard[_Module]:
    return hasattr(module, "sensitivities")


@dataclass(frozen=True, slots=True)
class _Numpy:
    module: _Module

    def sensitivities(
        self, prepared: Prepared, t: ArrayLike, errors: str = "raise"
    ) -> Sensitivities:
        """States at times and what they change by, of prepared motions."""
        return self.module.sensitivities(prepared, t, errors)

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
    ) -> Sensitivities:
        """The same of many bodies, whose leading shapes broadcast as in `Engine.propagate`."""
        given = arrays.named(inertia, omega0, attitude0)
        arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        found = arrays.sensitivities((*shape, *t.shape[-1:]))
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        rows = [
            x.reshape(count, t.shape[1], *last)
            for x, last in zip(found, arrays.SENSITIVITIES, strict=True)
        ]

        def run(prepared: Prepared, times: np.ndarray, some: slice) -> None:
            block = self.module.sensitivities(prepared, times, errors)
            for row, values in zip(rows, block, strict=True):
                row[some] = values

        in_blocks(self.module, given, t, shape, errors, run)
        return found


class _C:
    __slots__ = ("engine", "many", "one")

    def __init__(self, engine: CEngine, one: Callable[..., int], many: Callable[..., int]) -> None:
        self.engine, self.one, self.many = engine, one, many

    def sensitivities(
        self, prepared: Prepared, t: ArrayLike, errors: str = "raise"
    ) -> Sensitivities:
        """See `Sensitive`."""
        lenient = arrays.is_lenient(errors)
        if isinstance(t, float) and not lenient:
            return self._at(prepared, t)
        times = arrays.times(t)
        found = arrays.sensitivities(times.shape)
        self._fill(prepared, times, found, lenient)
        return found

    def _at(self, prepared: Prepared, t: float) -> Sensitivities:
        """At one time, by a shorter way from Python to C and back."""
        # NumPy's types do not know that arrays of ctypes are buffers.
        numbers: Any = _Numbers(t)
        place = ctypes.addressof(numbers)
        code = self.one(prepared, 1, place, *(place + begin for begin in _BEGINS))
        q, omega, attitude, rates, attitude_t, rates_t = (
            np.ndarray(shape, float, numbers, begin)
            for shape, begin in zip(arrays.SENSITIVITIES, _BEGINS, strict=True)
        )
        found = q, omega, attitude, rates, attitude_t, rates_t
        self._check(code, prepared, np.array(t), found)
        return found

    def _fill(self, prepared: Prepared, t: np.ndarray, found: Sensitivities, lenient: bool) -> None:
        if lenient:
            near = np.isfinite(t) & (np.abs(t) <= self.engine.library.last_time(prepared))
            self._compute(prepared, np.where(near, t, 0.0), found)
            for x in found:
                x[~near] = np.nan
        else:
            self._check(self._compute(prepared, t, found), prepared, t, found)

    def _check(self, code: int, prepared: Prepared, t: np.ndarray, found: Sensitivities) -> None:
        """Raise EngineError for what a code says of times."""
        if code == _GROWTH:
            lost = [np.isnan(x).reshape(t.size, -1).any(axis=1) for x in found]
            rule = self.engine.library.message(code).decode().partition(": ")[2]
            raise EngineError("t", rule, time=int(np.argmax(np.any(lost, axis=0))))
        if code:
            raise self.engine.refused_times(code, prepared, t)

    def _compute(self, prepared: Prepared, t: np.ndarray, found: Sensitivities) -> int:
        """Threads share the times; the code, that of a time which is refused before any other."""
        places = [x.ctypes.data for x in (t, *found)]

        def part(begin: int, end: int) -> int:
            rows = offset(places, begin, (1, *_SIZES))
            return self.one(prepared, end - begin, *rows)

        parts = threads.threads(_STATES * t.size)
        codes = threads.in_parts(part, t.size, parts, threads.PIECE // _STATES)
        return min(filter(None, codes), default=0)

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
    ) -> Sensitivities:
        """See `Sensitive`; threads share the bodies."""
        given, lenient = arrays.named(inertia, omega0, attitude0), arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        found = arrays.sensitivities((*shape, *t.shape[-1:]))
        bodies = {name: arrays.rows(array, shape) for name, array in given.items()}
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        times = t.shape[1]
        codes = np.empty(count if lenient else 0, np.intc)
        places = [x.ctypes.data for x in (*bodies.values(), t, *found)]
        own = times if len(t) > 1 else 0
        sizes = 3, 3, 4, own, *(times * size for size in _SIZES)

        def part(begin: int, end: int) -> int | None:
            failed = ctypes.c_size_t(0)
            *body, at, q, omega, turns, rates, turns_t, rates_t = offset(places, begin, sizes)
            told = codes[begin:].ctypes.data if lenient else None
            rows = q, omega, turns, rates, turns_t, rates_t
            code = self.many(
                end - begin, *body, times, at, own, *rows, told, ctypes.addressof(failed)
            )
            return begin + failed.value if code else None

        work = _STATES * times + PREPARATION
        parts = min(threads.threads(count * work), max(1, count))
        refused = threads.in_parts(part, count, parts, max(1, threads.PIECE // work))
        for body in refused:
            if body is not None:
                self._refuse(body, bodies, t[body if own else 0])
        return found

    def _refuse(self, body: int, bodies: Mapping[str, np.ndarray], t: np.ndarray) -> NoReturn:
        """Once more, by the way that says what is refused."""
        try:
            prepared = self.engine.prepare(*(array[body] for array in bodies.values()))
            self.sensitivities(prepared, t)
        except EngineError as error:
            raise EngineError(error.field, error.rule, body, error.time) from None
        raise AssertionError("a body that was refused is not")
