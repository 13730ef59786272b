"""States with what they change by: by the modules of the theta form, NumPy's or C's."""

import ctypes
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, NoReturn, Protocol, TypeAlias, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import arrays, threads
from rigidsym.engines.c_engine import PREPARATION, CEngine, offset
from rigidsym.engines.numpy_engine import Module, NumpyEngine, in_blocks
from rigidsym.engines.protocol import EngineError, Prepared, Sensitivities

# Names of columns; all where None.
Columns: TypeAlias = Iterable[str] | None
# A state with its sensitivities takes as long as so many states.
_STATES = 8
_DOUBLE = ctypes.sizeof(ctypes.c_double)


@dataclass(frozen=True, slots=True)
class _Asked:
    """Columns as C is asked for them, and where their numbers are."""

    flags: int
    shapes: tuple[tuple[int, ...], ...]
    # Doubles of each array in a state.
    sizes: tuple[int, ...]
    # Of one time before all arrays, each after the other: the type, and where they begin, in bytes.
    numbers: type[ctypes.Array[ctypes.c_double]]
    begins: tuple[int, ...]


@cache
def _asked(columns: tuple[str, ...]) -> _Asked:
    shapes = arrays.sensitivity_shapes(columns)
    sizes = tuple(map(math.prod, shapes))
    begins = tuple(_DOUBLE * sum((1, *sizes[:k])) for k in range(len(sizes)))
    flags = sum(1 << arrays.COLUMNS.index(name) for name in columns)
    return _Asked(flags, shapes, sizes, ctypes.c_double * (1 + sum(sizes)), begins)


class Sensitive(Protocol):
    """What finds `Sensitivities`; times, errors and what is raised are those of an `Engine`."""

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Columns = None,
    ) -> Sensitivities:
        """Of one motion; of these columns alone, some of `arrays.COLUMNS`, where any are named."""
        ...

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
        columns: Columns = None,
    ) -> Sensitivities:
        """Of many bodies, whose leading shapes broadcast as in `Engine.propagate`."""
        ...


def sensitive(engine: object) -> Sensitive:
    """What goes with an engine's prepared motions; raises EngineError where nothing does."""
    # Modules of the theta form alone have them.
    if isinstance(engine, CEngine) and hasattr(engine.library, "states_with_columns"):
        return _C(engine)
    if isinstance(engine, NumpyEngine) and _offers(engine.module):
        return _Numpy(engine.module)
    raise EngineError("engine", "its module has no sensitivities")


def by_exact_moments(found: Sensitivities, inertia: Sequence[Fraction]) -> None:
    """Make sensitivities of a motion prepared exactly those by moments in kg m^2, their last three
    columns: these were divided by a power of two."""
    # Here, because doubles need nothing of it.
    from rigidsym.engines.exact_inputs import moment_unit

    for changes in found[2:4]:
        changes[..., -3:] /= moment_unit(inertia)


class _Module(Module, Protocol):
    """What the generated module of the theta form offers beyond states."""

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = ...,
        columns: tuple[str, ...] = ...,
    ) -> Sensitivities:
        """States and what they change by."""
        ...


def _offers(module: Module) -> TypeGuard[_Module]:
    return hasattr(module, "sensitivities")


@dataclass(frozen=True, slots=True)
class _Numpy:
    module: _Module

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Columns = None,
    ) -> Sensitivities:
        """States at times and what they change by, of prepared motions."""
        return self.module.sensitivities(prepared, t, errors, arrays.columns(columns))

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
        columns: Columns = None,
    ) -> Sensitivities:
        """The same of many bodies, whose leading shapes broadcast as in `Engine.propagate`."""
        given = arrays.named(inertia, omega0, attitude0)
        arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        asked = arrays.columns(columns)
        found = arrays.sensitivities((*shape, *t.shape[-1:]), asked)
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        rows = [
            x.reshape(count, t.shape[1], *last)
            for x, last in zip(found, arrays.sensitivity_shapes(asked), strict=True)
        ]

        def run(prepared: Prepared, times: np.ndarray, some: slice) -> None:
            block = self.module.sensitivities(prepared, times, errors, asked)
            for row, values in zip(rows, block, strict=True):
                row[some] = values

        in_blocks(self.module, given, t, shape, errors, run)
        return found


class _C:
    __slots__ = ("engine", "many", "one")

    def __init__(self, engine: CEngine) -> None:
        self.engine, self.one = engine, engine.library.states_with_columns
        self.many = engine.library.propagate_with_columns

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Columns = None,
    ) -> Sensitivities:
        """See `Sensitive`."""
        lenient, named = arrays.is_lenient(errors), arrays.columns(columns)
        if isinstance(t, float) and not lenient:
            return self._at(prepared, t, _asked(named))
        times = arrays.times(t)
        found = arrays.sensitivities(times.shape, named)
        self._fill(prepared, times, found, lenient, _asked(named))
        return found

    def _at(self, prepared: Prepared, t: float, asked: _Asked) -> Sensitivities:
        """At one time, by a shorter way from Python to C and back."""
        # NumPy's types do not know that arrays of ctypes are buffers.
        numbers: Any = asked.numbers(t)
        place = ctypes.addressof(numbers)
        places = (place + begin for begin in asked.begins)
        code = self.one(prepared, 1, place, asked.flags, *places)
        q, omega, attitude, rates, attitude_t, rates_t = (
            np.ndarray(shape, float, numbers, begin if math.prod(shape) else 0)
            for shape, begin in zip(asked.shapes, asked.begins, strict=True)
        )
        found = q, omega, attitude, rates, attitude_t, rates_t
        self._check(code, prepared, np.array(t), found)
        return found

    def _fill(
        self,
        prepared: Prepared,
        t: np.ndarray,
        found: Sensitivities,
        lenient: bool,
        asked: _Asked,
    ) -> None:
        if lenient:
            near = np.isfinite(t) & (np.abs(t) <= self.engine.library.last_time(prepared))
            self._compute(prepared, np.where(near, t, 0.0), found, asked)
            for x in found:
                x[~near] = np.nan
        else:
            self._check(self._compute(prepared, t, found, asked), prepared, t, found)

    def _check(self, code: int, prepared: Prepared, t: np.ndarray, found: Sensitivities) -> None:
        """Raise EngineError for what a code says of times."""
        if code == self.engine.library.GROWTH:
            lost = [np.isnan(x).reshape(t.size, -1).any(axis=1) for x in found]
            rule = self.engine.library.rule(code).decode()
            raise EngineError("t", rule, time=int(np.argmax(np.any(lost, axis=0))))
        if code:
            raise self.engine.refused_times(code, prepared, t)

    def _compute(
        self, prepared: Prepared, t: np.ndarray, found: Sensitivities, asked: _Asked
    ) -> int:
        """Threads share the times; the code, that of a time which is refused before any other."""
        places = [x.ctypes.data for x in (t, *found)]

        def part(begin: int, end: int) -> int:
            first, *rows = offset(places, begin, (1, *asked.sizes))
            return self.one(prepared, end - begin, first, asked.flags, *rows)

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
        columns: Columns = None,
    ) -> Sensitivities:
        """See `Sensitive`; threads share the bodies."""
        given, lenient = arrays.named(inertia, omega0, attitude0), arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        named = arrays.columns(columns)
        asked, found = _asked(named), arrays.sensitivities((*shape, *t.shape[-1:]), named)
        bodies = {name: arrays.rows(array, shape) for name, array in given.items()}
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        times = t.shape[1]
        codes = np.empty(count if lenient else 0, np.intc)
        places = [x.ctypes.data for x in (*bodies.values(), t, *found)]
        own = times if len(t) > 1 else 0
        sizes = 3, 3, 4, own, *(times * size for size in asked.sizes)

        def part(begin: int, end: int) -> int | None:
            failed = ctypes.c_size_t(0)
            inertia, omega0, attitude0, at, *rows = offset(places, begin, sizes)
            told = codes[begin:].ctypes.data if lenient else None
            last = asked.flags, *rows, told, ctypes.addressof(failed)
            code = self.many(end - begin, inertia, omega0, attitude0, times, at, own, *last)
            return begin + failed.value if code else None

        work = _STATES * times + PREPARATION
        parts = min(threads.threads(count * work), max(1, count))
        refused = threads.in_parts(part, count, parts, max(1, threads.PIECE // work))
        for body in refused:
            if body is not None:
                self._refuse(body, bodies, t[body if own else 0], named)
        return found

    def _refuse(
        self, body: int, bodies: Mapping[str, np.ndarray], t: np.ndarray, columns: Columns
    ) -> NoReturn:
        """Once more, by the way that says what is refused."""
        try:
            prepared = self.engine.prepare(*(array[body] for array in bodies.values()))
            self.sensitivities(prepared, t, columns=columns)
        except EngineError as error:
            raise EngineError(error.field, error.rule, body, error.time) from None
        raise AssertionError("a body that was refused is not")
