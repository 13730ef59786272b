"""The engine on the generated C module, as the system's compiler built it."""

import ctypes
import math
from collections.abc import Callable, Mapping, Sequence
from ctypes import addressof, c_double
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import arrays, threads
from rigidsym.engines.library import Library
from rigidsym.engines.protocol import EngineError, Outputs, States

# Doubles, whose memory the caller owns; nobody writes to it once it is made.
Prepared = ctypes.Array[c_double]
_DOUBLE = ctypes.sizeof(c_double)
# One state, q before omega.
_State, _OMEGA = c_double * 7, 4 * _DOUBLE
# A prepared motion takes as long as this many states.
PREPARATION = 256


class CEngine:
    """torque_free.c as an `Engine`; prepared motions and the engine may be shared by threads."""

    __slots__ = ("_prepared_type", "_state_at", "library")

    def __init__(self, library: Library) -> None:
        self.library = library.raw
        self._state_at = library.raw.state_at
        # An array of doubles is aligned as a prepared motion has to be.
        self._prepared_type = c_double * -(-self.library.motion_size() // _DOUBLE)

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """See `Engine`."""
        given = arrays.named(inertia, omega0, attitude0)
        return self._made(self.library.motion_init, _vectors(given, ()))

    def prepare_from_double_doubles(
        self,
        inertia: ArrayLike,
        differences: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        discriminant: ArrayLike,
        unit: float,
    ) -> Prepared:
        """Constants of one motion from sums of two doubles: (3, 2) thrice, (4, 2) and (2,).

        Scaled as torque_free.h says, rates times `unit` rad/s; discriminant is K^2 - 2 H c_b.
        """
        named = {"inertia": inertia, "differences": differences, "omega0": omega0}
        named |= {"attitude0": attitude0, "discriminant": discriminant}
        given = _vectors({name: np.asarray(value, float) for name, value in named.items()}, (2,))
        return self._made(self.library.motion_init_double_doubles, given, unit)

    def prepare_exactly(
        self,
        inertia: Sequence[Fraction],
        omega0: Sequence[Fraction],
        attitude0: Sequence[Fraction],
    ) -> Prepared:
        """See `Engine`."""
        # Here, because doubles need nothing of it.
        from rigidsym.engines.exact_inputs import exact_inputs

        return self.prepare_from_double_doubles(*exact_inputs(inertia, omega0, attitude0))

    def blank(self) -> Prepared:
        """Room for a prepared motion."""
        return self._prepared_type()

    def _made(
        self, init: Callable[..., int], given: Mapping[str, np.ndarray], *unit: float
    ) -> Prepared:
        prepared = self.blank()
        if code := init(prepared, *(array.ctypes.data for array in given.values()), *unit):
            raise self._refused(code, given)
        return prepared

    def _refused(
        self, code: int, given: Mapping[str, np.ndarray], body: int | None = None
    ) -> EngineError:
        """What a code of torque_free.h means for these inputs."""
        endless = [name for name, array in given.items() if not np.all(np.isfinite(array))]
        if code == self.library.NOT_FINITE and endless:
            return EngineError(endless[0], "every number must be finite", body)
        field, rule = self.library.field(code).decode(), self.library.rule(code).decode()
        return EngineError(field or "engine", rule, body)

    def refused_times(self, code: int, prepared: Prepared, t: np.ndarray) -> EngineError:
        """What a code means for these times, with the index of the first that it is meant by."""
        last, flat = self.library.last_time(prepared), t.reshape(-1)
        endless, late = np.flatnonzero(~np.isfinite(flat)), np.flatnonzero(np.abs(flat) > last)
        if endless.size:
            return EngineError("t", arrays.BAD_TIMES, time=int(endless[0]))
        rule = self.library.rule(code).decode()
        if code == self.library.SEPARATRIX:
            rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
        return EngineError("t", rule, time=int(late[0]) if late.size else None)

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """See `Engine`."""
        if arrays.is_lenient(errors):
            return self._lenient(prepared, arrays.times(t), out)
        if out is None and isinstance(t, float):
            return self._state(prepared, t)
        t = arrays.times(t)
        q, omega = arrays.outputs(out, t.shape, t)
        inputs = t.ctypes.data, q.ctypes.data, omega.ctypes.data

        def part(begin: int, end: int) -> int:
            places = offset(inputs, begin, (1, 4, 3))
            return self.library.states_at(prepared, end - begin, *places)

        if code := max(_shared(part, t.size)):
            raise self.refused_times(code, prepared, t)
        return q, omega

    def _lenient(self, prepared: Prepared, t: np.ndarray, out: Outputs) -> States:
        """States where there are any, else NaN."""
        q, omega = arrays.outputs(out, t.shape, t)
        near = np.isfinite(t) & (np.abs(t) <= self.library.last_time(prepared))
        self.states(prepared, np.where(near, t, 0.0), (q, omega))
        q[~near] = omega[~near] = np.nan
        return q, omega

    def _state(self, prepared: Prepared, t: float) -> States:
        """The state at one time, by the shortest way there is from Python to C and back."""
        # NumPy's types do not know that arrays of ctypes are buffers.
        state: Any = _State()
        place = addressof(state)
        if code := self._state_at(prepared, t, place, place + _OMEGA):
            raise self.refused_times(code, prepared, np.array(t))
        return np.ndarray(4, float, state), np.ndarray(3, float, state, _OMEGA)

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """See `Engine`."""
        q, omega = arrays.outputs(out, (arrays.count(count),))
        outputs = q.ctypes.data, omega.ctypes.data

        def part(begin: int, end: int) -> int:
            places = offset(outputs, begin, (4, 3))
            return self.library.states_on_grid(prepared, start, step, begin, end - begin, *places)

        if code := max(_shared(part, count)):
            first = _first_beyond(start, step, self.library.last_time(prepared))
            refused = self.refused_times(code, prepared, np.array(start + first * step))
            raise EngineError(refused.field, refused.rule, time=min(first, count - 1))
        return q, omega

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        out: Outputs = None,
        errors: str = "raise",
    ) -> States:
        """See `Engine`; errors have the index of the body, counted through all leading axes."""
        given, lenient = arrays.named(inertia, omega0, attitude0), arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        states = arrays.outputs(out, (*shape, *t.shape[-1:]), t, *given.values())
        bodies = {name: arrays.rows(array, shape) for name, array in given.items()}
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        parts = threads.threads(count * (t.shape[1] + PREPARATION))
        if count < parts and not lenient:
            self._one_by_one(bodies, t, states)
        else:
            self._bodies(bodies, t, states, min(parts, max(1, count)), lenient)
        return states

    def _one_by_one(self, bodies: Mapping[str, np.ndarray], t: np.ndarray, states: States) -> None:
        """Few bodies at many times: threads share the times."""
        sizes = len(bodies["inertia"]), t.shape[1]
        q, omega = states[0].reshape(*sizes, 4), states[1].reshape(*sizes, 3)
        for k in range(sizes[0]):
            self._one(k, bodies, t, (q[k], omega[k]))

    def _one(
        self, k: int, bodies: Mapping[str, np.ndarray], t: np.ndarray, out: Outputs = None
    ) -> None:
        """Body k of a batch by itself, at its row of times; errors have its index."""
        try:
            prepared = self.prepare(*(array[k] for array in bodies.values()))
            self.states(prepared, t[k if len(t) > 1 else 0], out)
        except EngineError as error:
            raise EngineError(error.field, error.rule, k, error.time) from None

    def _bodies(
        self,
        bodies: Mapping[str, np.ndarray],
        t: np.ndarray,
        states: States,
        parts: int,
        lenient: bool,
    ) -> None:
        """Many bodies: threads share the bodies."""
        count = len(bodies["inertia"])
        codes = np.empty(count if lenient else 0, np.intc)
        rows = [array.ctypes.data for array in (*bodies.values(), t, *states)]
        times = t.shape[1]
        stride = times if len(t) > 1 else 0
        sizes = (3, 3, 4, stride, 4 * times, 3 * times)

        def part(begin: int, end: int) -> int | None:
            failed = ctypes.c_size_t(0)
            *given, own, q, omega = offset(rows, begin, sizes)
            told = codes[begin:].ctypes.data if lenient else None
            code = self.library.propagate(
                end - begin, *given, times, own, stride, q, omega, told, addressof(failed)
            )
            return begin + failed.value if code else None

        piece = max(1, threads.PIECE // (times + PREPARATION))
        for body in threads.in_parts(part, count, parts, piece):
            if body is not None:
                # Once more, because a prepared motion knows which times are too late.
                self._one(body, bodies, t)


def _first_beyond(start: float, step: float, last: float) -> int:
    """The number of the first time start + k step that is beyond `last`, where one is."""
    if not abs(start) <= last:
        return 0
    share = (math.copysign(last, step) - start) / step if math.isfinite(step) else 0.0
    return 1 + math.floor(share)


def _vectors(given: Mapping[str, np.ndarray], tail: tuple[int, ...]) -> dict[str, np.ndarray]:
    """The arrays of one body, in one piece of memory each: (3, *tail) or (4, *tail)."""
    for name, array in given.items():
        shape = (arrays.SIZES[name], *tail) if name in arrays.SIZES else tail
        if array.shape != shape:
            raise EngineError(name, f"shape {array.shape}: one body's must be {shape}")
    return {name: arrays.in_one_piece(array) for name, array in given.items()}


def _shared(part: Callable[[int, int], int], states: int) -> list[int]:
    """The codes of all parts of so many states."""
    return threads.in_parts(part, states, threads.threads(states), threads.PIECE)


def offset(places: Sequence[int], begin: int, sizes: Sequence[int]) -> list[int]:
    """Addresses of row `begin` where rows have `sizes` doubles."""
    return [place + begin * size * _DOUBLE for place, size in zip(places, sizes, strict=True)]
