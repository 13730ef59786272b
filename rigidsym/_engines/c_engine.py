"""The engine on the generated C module, as the system's compiler built it."""

import ctypes
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from ctypes import addressof, c_double
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import arrays, threads
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym._engines.base import Engine
from rigidsym._engines.library import Library
from rigidsym.errors import EngineError

# Doubles in memory of the caller, which nothing writes to after the motion is prepared.
Prepared = ctypes.Array[c_double]
_DOUBLE = ctypes.sizeof(c_double)
# One state, q before omega.
_State, _OMEGA = c_double * 7, 4 * _DOUBLE
# Preparing a motion takes as long as this many states, a state with its sensitivities as so many.
PREPARATION, _SENSITIVITY = 256, 8


@dataclass(frozen=True, slots=True)
class _Columns:
    """Columns of sensitivities as C takes them, and the layout of one time with all its arrays."""

    flags: int
    shapes: tuple[tuple[int, ...], ...]
    # The doubles of each array in a state.
    sizes: tuple[int, ...]
    # Memory for a time before all arrays, one after the other, and their offsets in bytes.
    numbers: type[ctypes.Array[c_double]]
    offsets: tuple[int, ...]


@cache
def _columns(names: tuple[str, ...]) -> _Columns:
    shapes = arrays.sensitivity_shapes(names)
    sizes = tuple(map(math.prod, shapes))
    offsets = tuple(_DOUBLE * sum((1, *sizes[:k])) for k in range(len(sizes)))
    flags = sum(1 << arrays.COLUMNS.index(name) for name in names)
    return _Columns(flags, shapes, sizes, c_double * (1 + sum(sizes)), offsets)


class CEngine(Engine):
    """The engine on torque_free.c; threads may share it and its prepared motions."""

    __slots__ = ("_prepared_type", "_state_at", "library")

    def __init__(self, library: Library) -> None:
        self.library = library.raw
        self._state_at = library.raw.state_at
        # An array of doubles is aligned as a prepared motion has to be.
        self._prepared_type = c_double * -(-self.library.motion_size() // _DOUBLE)

    @property
    def has_sensitivities(self) -> bool:
        """True if the module has sensitivities."""
        return hasattr(self.library, "states_with_columns")

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """See `Engine`."""
        given = _one_body({"inertia": inertia, "omega0": omega0, "attitude0": attitude0}, ())
        return self._prepared(self.library.motion_init, given)

    def prepare_from_double_doubles(
        self,
        inertia: ArrayLike,
        differences: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        discriminant: ArrayLike,
        unit: float,
    ) -> Prepared:
        """See `Engine`."""
        named = {"inertia": inertia, "differences": differences, "omega0": omega0}
        named |= {"attitude0": attitude0, "discriminant": discriminant}
        init = self.library.motion_init_double_doubles
        return self._prepared(init, _one_body(named, (2,)), unit)

    def blank(self) -> Prepared:
        """Return memory for a prepared motion."""
        return self._prepared_type()

    def _prepared(
        self, init: Callable[..., int], given: Mapping[str, np.ndarray], *unit: float
    ) -> Prepared:
        prepared = self.blank()
        code = init(prepared, *(array.ctypes.data for array in given.values()), *unit)
        if not code:
            return prepared
        infinite = [name for name, array in given.items() if not np.all(np.isfinite(array))]
        if code == self.library.NOT_FINITE and infinite:
            raise EngineError(infinite[0], "every number must be finite")
        field, rule = self.library.field(code).decode(), self.library.rule(code).decode()
        raise EngineError(field or "engine", rule)

    def _refused_times(self, code: int, prepared: Prepared, t: np.ndarray) -> EngineError:
        """Return the error of a code for these times, with the index of the first it is for."""
        last, flat = self.library.last_time(prepared), t.reshape(-1)
        infinite, late = np.flatnonzero(~np.isfinite(flat)), np.flatnonzero(np.abs(flat) > last)
        if infinite.size:
            return EngineError("t", arrays.BAD_TIMES, time=int(infinite[0]))
        rule = self.library.rule(code).decode()
        if code == self.library.SEPARATRIX:
            rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
        return EngineError("t", rule, time=int(late[0]) if late.size else None)

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """See `Engine`."""
        if arrays.is_lenient(errors):
            return self._lenient_states(prepared, arrays.times(t), out)
        if out is None and isinstance(t, float):
            # NumPy's types do not know that arrays of ctypes are buffers.
            state: Any = _State()
            address = addressof(state)
            if code := self._state_at(prepared, t, address, address + _OMEGA):
                raise self._refused_times(code, prepared, np.array(t))
            return np.ndarray(4, float, state), np.ndarray(3, float, state, _OMEGA)
        t = arrays.times(t)
        q, omega = arrays.outputs(out, t.shape, t)
        addresses = t.ctypes.data, q.ctypes.data, omega.ctypes.data

        def piece(begin: int, end: int) -> int:
            rows = _rows_from(begin, addresses, (1, 4, 3))
            return self.library.states_at(prepared, end - begin, *rows)

        if code := max(_shared(piece, t.size)):
            raise self._refused_times(code, prepared, t)
        return q, omega

    def _lenient_states(self, prepared: Prepared, t: np.ndarray, out: Outputs) -> States:
        """Return states, of NaN at times that are refused."""
        q, omega = arrays.outputs(out, t.shape, t)
        near = self._are_near(prepared, t)
        self.states(prepared, np.where(near, t, 0.0), (q, omega))
        q[~near] = omega[~near] = np.nan
        return q, omega

    def _are_near(self, prepared: Prepared, t: np.ndarray) -> np.ndarray:
        """Return which times are finite and not too late."""
        return np.isfinite(t) & (np.abs(t) <= self.library.last_time(prepared))

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """See `Engine`."""
        q, omega = arrays.outputs(out, (arrays.count(count),))
        addresses = q.ctypes.data, omega.ctypes.data

        def piece(begin: int, end: int) -> int:
            rows = _rows_from(begin, addresses, (4, 3))
            return self.library.states_on_grid(prepared, start, step, begin, end - begin, *rows)

        if code := max(_shared(piece, count)):
            last, first = self.library.last_time(prepared), 0
            if abs(start) <= last:
                far = (math.copysign(last, step) - start) / step if math.isfinite(step) else 0.0
                first = 1 + math.floor(far)
            refused = self._refused_times(code, prepared, np.array(start + first * step))
            raise EngineError(refused.field, refused.rule, time=min(first, count - 1))
        return q, omega

    def _fill_states(self, batch: Batch, states: States, lenient: bool) -> None:
        t, bodies = batch.times, self._rows(batch)
        count, times = batch.number, t.shape[1]
        if lenient or count >= threads.threads(count * (times + PREPARATION)):
            function = self.library.propagate
            self._fill(function, (), bodies, t, states, lenient, times, self.states)
            return
        # Few bodies at many times: threads share the times.
        q, omega = (x.reshape(count, times, x.shape[-1]) for x in states)
        for k in range(count):
            self._alone(k, bodies, t, partial(self.states, out=(q[k], omega[k])))

    def _rows(self, batch: Batch) -> list[np.ndarray]:
        """Return inertia, omega0 and attitude0 of a batch, a row for each body."""
        return [arrays.rows(array, batch.leading) for array in batch.bodies.values()]

    def _fill(
        self,
        function: Callable[..., int],
        flags: tuple[int, ...],
        bodies: Sequence[np.ndarray],
        t: np.ndarray,
        found: Sequence[np.ndarray],
        lenient: bool,
        cost: int,
        compute: Callable[[Prepared, np.ndarray], object],
    ) -> None:
        """Fill arrays by a function of C for many bodies; threads share the bodies.

        flags: arguments before the outputs.  cost: that of a body after preparing it, in states.
        compute: does the same for one prepared motion, and finds the time that is refused.
        """
        count, times = len(bodies[0]), t.shape[1]
        own = times if len(t) > 1 else 0
        codes = np.empty(count if lenient else 0, np.intc)
        addresses = [x.ctypes.data for x in (*bodies, t, *found)]
        sizes = 3, 3, 4, own, *(x.size // max(1, count) for x in found)

        def piece(begin: int, end: int) -> int | None:
            failed = ctypes.c_size_t(0)
            rows = _rows_from(begin, addresses, sizes)
            body_codes = codes[begin:].ctypes.data if lenient else None
            given = (end - begin, *rows[:3], times, rows[3], own, *flags, *rows[4:])
            code = function(*given, body_codes, addressof(failed))
            return begin + failed.value if code else None

        work = cost + PREPARATION
        parts = min(threads.threads(count * work), max(1, count))
        for body in threads.in_parts(piece, count, parts, max(1, threads.PIECE // work)):
            if body is not None:
                self._alone(body, bodies, t, compute)
                raise AssertionError("a body that was refused is not")

    def _alone(
        self,
        k: int,
        bodies: Sequence[np.ndarray],
        t: np.ndarray,
        compute: Callable[[Prepared, np.ndarray], object],
    ) -> None:
        """Prepare body k and compute at its times; errors have its index."""
        try:
            compute(self.prepare(*(array[k] for array in bodies)), t[k if len(t) > 1 else 0])
        except EngineError as error:
            raise EngineError(error.field, error.rule, k, error.time) from None

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """See `Engine`."""
        self._check_has_sensitivities()
        lenient, names = arrays.is_lenient(errors), arrays.columns(columns)
        chosen = _columns(names)
        if isinstance(t, float) and not lenient:
            return self._sensitivities_at(prepared, t, chosen)
        t = arrays.times(t)
        found = arrays.sensitivities(t.shape, names)
        if lenient:
            near = self._are_near(prepared, t)
            self._compute_sensitivities(prepared, np.where(near, t, 0.0), found, chosen)
            for x in found:
                x[~near] = np.nan
        elif code := self._compute_sensitivities(prepared, t, found, chosen):
            raise self._refused_sensitivities(code, prepared, t, found)
        return found

    def _sensitivities_at(self, prepared: Prepared, t: float, chosen: _Columns) -> Sensitivities:
        """Return sensitivities at one time, by a shorter way from Python to C and back."""
        numbers: Any = chosen.numbers(t)
        address = addressof(numbers)
        rows = (address + offset for offset in chosen.offsets)
        code = self.library.states_with_columns(prepared, 1, address, chosen.flags, *rows)
        q, omega, attitude, rates, attitude_t, rates_t = (
            np.ndarray(shape, float, numbers, offset if math.prod(shape) else 0)
            for shape, offset in zip(chosen.shapes, chosen.offsets, strict=True)
        )
        found = q, omega, attitude, rates, attitude_t, rates_t
        if code:
            raise self._refused_sensitivities(code, prepared, np.array(t), found)
        return found

    def _compute_sensitivities(
        self, prepared: Prepared, t: np.ndarray, found: Sensitivities, chosen: _Columns
    ) -> int:
        """Fill the arrays and return a code, that of a refused time before any other.

        Threads share the times.
        """
        addresses = [x.ctypes.data for x in (t, *found)]

        def piece(begin: int, end: int) -> int:
            first, *rows = _rows_from(begin, addresses, (1, *chosen.sizes))
            counted = prepared, end - begin, first
            return self.library.states_with_columns(*counted, chosen.flags, *rows)

        return min(filter(None, _shared(piece, t.size, _SENSITIVITY)), default=0)

    def _refused_sensitivities(
        self, code: int, prepared: Prepared, t: np.ndarray, found: Sensitivities
    ) -> EngineError:
        if code != self.library.GROWTH:
            return self._refused_times(code, prepared, t)
        lost = [np.isnan(x).reshape(t.size, -1).any(axis=1) for x in found]
        first = int(np.argmax(np.any(lost, axis=0)))
        return EngineError("t", self.library.rule(code).decode(), time=first)

    def _fill_sensitivities(
        self, batch: Batch, found: Sensitivities, columns: tuple[str, ...], lenient: bool
    ) -> None:
        t, bodies = batch.times, self._rows(batch)
        function, flags = self.library.propagate_with_columns, (_columns(columns).flags,)
        compute, cost = partial(self.sensitivities, columns=columns), _SENSITIVITY * t.shape[1]
        self._fill(function, flags, bodies, t, found, lenient, cost, compute)


def _one_body(given: Mapping[str, ArrayLike], tail: tuple[int, ...]) -> dict[str, np.ndarray]:
    """Return the arrays of one body, each contiguous: (3, *tail) or (4, *tail)."""
    found = {}
    for name, value in given.items():
        array = np.asarray(value, float)
        shape = (arrays.SIZES[name], *tail) if name in arrays.SIZES else tail
        if array.shape != shape:
            raise EngineError(name, f"shape {array.shape}: one body's must be {shape}")
        found[name] = arrays.in_one_piece(array)
    return found


def _shared(piece: Callable[[int, int], int], states: int, cost: int = 1) -> list[int]:
    """Return the codes of all pieces of so many states, each at the cost of some plain ones."""
    return threads.in_parts(piece, states, threads.threads(cost * states), threads.PIECE // cost)


def _rows_from(begin: int, addresses: Sequence[int], sizes: Sequence[int]) -> list[int]:
    """Return the addresses of row `begin` of arrays whose rows have `sizes` doubles."""
    return [x + begin * size * _DOUBLE for x, size in zip(addresses, sizes, strict=True)]
