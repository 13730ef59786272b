"""The engine that computes states by the generated and compiled C module."""

import ctypes
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from ctypes import addressof, c_double
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import arrays, threads
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym._engines.base import Engine
from rigidsym._engines.library import Library
from rigidsym.errors import EngineError

if TYPE_CHECKING:
    from rigidsym._engines.exact_inputs import ExactInputs

# Doubles in memory of the caller, which nothing writes to after the motion is prepared.
Prepared = ctypes.Array[c_double]
_DOUBLE = ctypes.sizeof(c_double)
# One state, q before omega.
_State, _OMEGA = c_double * 7, 4 * _DOUBLE
# Preparing a motion takes as long as this many states, a state with its sensitivities as so many.
PREPARATION, SENSITIVITY = 256, 8


@dataclass(frozen=True, slots=True)
class _Layout:
    """Memory layout of states and derivatives, with the C functions' arguments for it.

    flags: arguments of C before the outputs; cost: of a time, in plain states; shapes and sizes: of
    each array at one time; rows: 1 for the time, then sizes; offsets: in bytes, where a time and
    all arrays follow each other.
    """

    flags: tuple[int, ...]
    cost: int
    shapes: tuple[tuple[int, ...], ...]
    sizes: tuple[int, ...]
    rows: tuple[int, ...]
    offsets: tuple[int, ...]
    memory: type[ctypes.Array[c_double]]


@cache
def _layout(names: tuple[str, ...] | None) -> _Layout:
    """Return the memory layout of states with the named columns of derivatives.

    None stands for states without derivatives.
    """
    shapes = arrays.shapes(names)
    sizes = tuple(map(math.prod, shapes))
    offsets = tuple(_DOUBLE * sum((1, *sizes[:k])) for k in range(len(sizes)))
    flags = () if names is None else (sum(1 << arrays.COLUMNS.index(name) for name in names),)
    cost = SENSITIVITY if flags else 1
    return _Layout(flags, cost, shapes, sizes, (1, *sizes), offsets, c_double * (1 + sum(sizes)))


_STATES = _layout(None)


class CEngine(Engine):
    """Engine that calls the compiled C module.

    The module is torque_free.c.  Threads may share the engine and its prepared motions.
    """

    __slots__ = ("_prepared_type", "_state_at", "library")

    def __init__(self, library: Library) -> None:
        self.library = library.raw
        self._state_at = library.raw.state_at
        # An array of doubles is aligned as a prepared motion has to be.
        self._prepared_type = c_double * -(-self.library.motion_size() // _DOUBLE)

    @property
    def has_sensitivities(self) -> bool:
        """True if the C library can compute derivatives of states."""
        return hasattr(self.library, "states_with_columns")

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Compute the constants of one motion by the C library."""
        given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
        return self._prepared(self.library.motion_init, given, ())

    def _prepare_pairs(self, given: "ExactInputs") -> Prepared:
        *pairs, unit = given
        init = self.library.motion_init_double_doubles
        return self._prepared(init, dict(zip(given._fields, pairs, strict=False)), (2,), unit)

    def _prepared(
        self,
        init: Callable[..., int],
        given: Mapping[str, ArrayLike],
        tail: tuple[int, ...],
        *unit: float,
    ) -> Prepared:
        """Compute the constants of a motion by a given C function.

        Inputs have the shapes (3, *tail) or (4, *tail).
        """
        bodies = {}
        for name, value in given.items():
            array = np.asarray(value, float)
            shape = (arrays.SIZES[name], *tail) if name in arrays.SIZES else tail
            if array.shape != shape:
                raise EngineError(name, f"shape {array.shape}: one body's must be {shape}")
            bodies[name] = arrays.in_one_piece(array)
        prepared = self._prepared_type()
        code = init(prepared, *(array.ctypes.data for array in bodies.values()), *unit)
        if not code:
            return prepared
        infinite = [name for name, array in bodies.items() if not np.all(np.isfinite(array))]
        if code == self.library.NOT_FINITE and infinite:
            raise EngineError(infinite[0], "every number must be finite")
        field, rule = self.library.field(code).decode(), self.library.rule(code).decode()
        raise EngineError(field or "engine", rule)

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """Compute states at times by the C library."""
        lenient = errors != "raise" and arrays.is_lenient(errors)
        if out is None and isinstance(t, float) and not lenient:
            # NumPy's types do not know that arrays of ctypes are buffers.
            state: Any = _State()
            address = addressof(state)
            if code := self._state_at(prepared, t, address, address + _OMEGA):
                raise self._refused(code, prepared, np.array(t))
            return np.ndarray(4, float, state), np.ndarray(3, float, state, _OMEGA)
        times = arrays.times(t)
        found = arrays.outputs(out, times.shape, times)
        self._compute(prepared, times, found, lenient, _STATES)
        return found

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """Compute states and their derivatives at times by the C library."""
        self._check_has_sensitivities()
        lenient, names = arrays.is_lenient(errors), arrays.columns(columns)
        layout = _layout(names)
        if isinstance(t, float) and not lenient:
            return self._sensitivities_at(prepared, t, layout)
        times = arrays.times(t)
        found = arrays.sensitivities(times.shape, names)
        self._compute(prepared, times, found, lenient, layout)
        return found

    def _sensitivities_at(self, prepared: Prepared, t: float, layout: _Layout) -> Sensitivities:
        """Compute a state and its derivatives at one time by a single call of C."""
        numbers: Any = layout.memory(t)
        address = addressof(numbers)
        rows = (address + offset for offset in layout.offsets)
        code = self.library.states_with_columns(prepared, 1, address, *layout.flags, *rows)
        q, omega, attitude, rates, attitude_t, rates_t = (
            np.ndarray(shape, float, numbers, offset if math.prod(shape) else 0)
            for shape, offset in zip(layout.shapes, layout.offsets, strict=True)
        )
        found = q, omega, attitude, rates, attitude_t, rates_t
        if code:
            raise self._refused(code, prepared, np.array(t), found)
        return found

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """Compute states at the exact times start + k step by the C library."""
        q, omega = arrays.outputs(out, (count,))
        addresses = q.ctypes.data, omega.ctypes.data

        def piece(begin: int, end: int) -> int:
            rows = _rows_from(begin, addresses, (4, 3))
            return self.library.states_on_grid(prepared, start, step, begin, end - begin, *rows)

        if code := max(_shared(piece, count)):
            last, first = self.library.last_time(prepared), 0
            if abs(start) <= last:
                far = (math.copysign(last, step) - start) / step if math.isfinite(step) else 0.0
                first = 1 + math.floor(far)
            refused = self._refused(code, prepared, np.array(start + first * step))
            raise EngineError(refused.field, refused.rule, time=min(first, count - 1))
        return q, omega

    def _compute(
        self,
        prepared: Prepared,
        t: np.ndarray,
        found: Sequence[np.ndarray],
        lenient: bool,
        layout: _Layout,
    ) -> None:
        """Compute the states of one motion, and write them to arrays.

        Threads share the times t.
        """
        function = self.library.states_with_columns if layout.flags else self.library.states_at
        near = None
        if lenient:
            near = np.isfinite(t) & (np.abs(t) <= self.library.last_time(prepared))
            t = np.where(near, t, 0.0)
        addresses, sizes, flags = [x.ctypes.data for x in (t, *found)], layout.rows, layout.flags

        def piece(begin: int, end: int) -> int:
            first, *rows = _rows_from(begin, addresses, sizes)
            return function(prepared, end - begin, first, *flags, *rows)

        codes = _shared(piece, t.size, layout.cost)
        if near is not None:
            for x in found:
                x[~near] = np.nan
        # The code of a refused time comes before that of a derivative.
        elif any(codes):
            code = min(filter(None, codes))
            raise self._refused(code, prepared, t, found)

    def _refused(
        self, code: int, prepared: Prepared, t: np.ndarray, found: Sequence[np.ndarray] = ()
    ) -> EngineError:
        """Return the exception for an error code, with the index of the first refused time."""
        flat, rule = t.reshape(-1), self.library.rule(code).decode()
        if len(found) > 2 and code == self.library.GROWTH:
            lost = [np.isnan(x).reshape(t.size, -1).any(axis=1) for x in found]
            return EngineError("t", rule, time=int(np.argmax(np.any(lost, axis=0))))
        last = self.library.last_time(prepared)
        infinite, late = np.flatnonzero(~np.isfinite(flat)), np.flatnonzero(np.abs(flat) > last)
        if infinite.size:
            return EngineError("t", arrays.BAD_TIMES, time=int(infinite[0]))
        if code == self.library.SEPARATRIX:
            rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
        return EngineError("t", rule, time=int(late[0]) if late.size else None)

    def _fill(
        self,
        batch: Batch,
        found: States | Sensitivities,
        lenient: bool,
        columns: tuple[str, ...] | None,
    ) -> None:
        t, layout, count = batch.times, _layout(columns), batch.number
        bodies = [arrays.rows(array, batch.leading) for array in batch.bodies.values()]
        times, own = t.shape[1], t.shape[1] if len(t) > 1 else 0
        work = layout.cost * times + PREPARATION

        def alone(k: int) -> None:
            """Compute the states of body k alone.

            Errors have the index k.
            """
            rows = [
                x.reshape(count, times, *y)[k] for x, y in zip(found, layout.shapes, strict=True)
            ]
            try:
                prepared = self.prepare(*(array[k] for array in bodies))
                self._compute(prepared, t[k if own else 0], rows, False, layout)
            except EngineError as error:
                raise EngineError(error.field, error.rule, k, error.time) from None

        if columns is None and not lenient and count < threads.threads(count * work):
            # Few bodies at many times: threads share the times.
            for k in range(count):
                alone(k)
            return
        function = self.library.propagate_with_columns if columns else self.library.propagate
        codes = np.empty(count if lenient else 0, np.intc)
        addresses = [x.ctypes.data for x in (*bodies, t, *found)]
        sizes = 3, 3, 4, own, *(times * size for size in layout.sizes)

        def piece(begin: int, end: int) -> int | None:
            failed = ctypes.c_size_t(0)
            rows = _rows_from(begin, addresses, sizes)
            body_codes = codes[begin:].ctypes.data if lenient else None
            given = end - begin, *rows[:3], times, rows[3], own, *layout.flags, *rows[4:]
            code = function(*given, body_codes, addressof(failed))
            return begin + failed.value if code else None

        parts = min(threads.threads(count * work), max(1, count))
        for body in threads.in_parts(piece, count, parts, max(1, threads.PIECE // work)):
            if body is not None:
                alone(body)
                raise AssertionError("a body that was refused is not")


def _shared(piece: Callable[[int, int], int], states: int, cost: int = 1) -> list[int]:
    """Divide the computation of states among threads, and return their error codes.

    cost: the cost of each state in plain states.
    """
    return threads.in_parts(piece, states, threads.threads(cost * states), threads.PIECE // cost)


def _rows_from(begin: int, addresses: Sequence[int], sizes: Sequence[int]) -> Sequence[int]:
    """Return the memory addresses of one row in each of several arrays.

    begin: the number of the row; sizes: the numbers of doubles in a row.
    """
    if not begin:
        return addresses
    return [x + begin * size * _DOUBLE for x, size in zip(addresses, sizes, strict=True)]
