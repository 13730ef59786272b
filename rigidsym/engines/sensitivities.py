"""States with what they change by: by the modules of the theta form, NumPy's or C's."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Protocol, TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import arrays
from rigidsym.engines.c_engine import CEngine, offset
from rigidsym.engines.numpy_engine import Module, NumpyEngine, in_blocks
from rigidsym.engines.protocol import Engine, EngineError, Prepared, Sensitivities

# A time at which squares of changes leave binary64, in torque_free.h.
_GROWTH = 9


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


def sensitive(engine: Engine) -> Sensitive:
    """What goes with an engine's prepared motions; raises EngineError where nothing does."""
    if isinstance(engine, CEngine) and engine.library.states_with_sensitivity:
        return _C(engine, engine.library.states_with_sensitivity)
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
        t, count = arrays.rows_of_times(t, shape), math.prod(shape)
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


@dataclass(frozen=True, slots=True)
class _C:
    engine: CEngine
    compute: Callable[..., int]

    def sensitivities(
        self, prepared: Prepared, t: ArrayLike, errors: str = "raise"
    ) -> Sensitivities:
        """See `Sensitive`."""
        times, lenient = arrays.times(t), arrays.is_lenient(errors)
        found = arrays.sensitivities(times.shape)
        self._fill(prepared, times, found, lenient)
        return found

    def _fill(self, prepared: Prepared, t: np.ndarray, found: Sensitivities, lenient: bool) -> None:
        library = self.engine.library
        near = np.isfinite(t) & (np.abs(t) <= library.last_time(prepared))
        given = np.where(near, t, 0.0) if lenient else t
        places = (x.ctypes.data for x in (given, *found))
        code = self.compute(prepared, t.size, *places)
        if lenient:
            for x in found:
                x[~near] = np.nan
        elif code == _GROWTH:
            lost = [np.isnan(x).reshape(t.size, -1).any(axis=1) for x in found]
            rule = library.message(code).decode().partition(": ")[2]
            raise EngineError("t", rule, time=int(np.argmax(np.any(lost, axis=0))))
        elif code:
            raise self.engine.refused_times(code, prepared, t)

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
    ) -> Sensitivities:
        """See `Sensitive`; a body after the other."""
        given, lenient = arrays.named(inertia, omega0, attitude0), arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        found = arrays.sensitivities((*shape, *t.shape[-1:]))
        bodies = {name: arrays.rows(array, shape) for name, array in given.items()}
        t, count = arrays.rows_of_times(t, shape), math.prod(shape)
        rows = [
            x.reshape(count, t.shape[1], *last)
            for x, last in zip(found, arrays.SENSITIVITIES, strict=True)
        ]
        places = [x.ctypes.data for x in (*bodies.values(), t, *rows)]
        own = t.shape[1] if len(t) > 1 else 0
        sizes = 3, 3, 4, own, *(t.shape[1] * math.prod(x) for x in arrays.SENSITIVITIES)
        init, prepared = self.engine.library.motion_init, self.engine.blank()
        for k in range(count):
            place = offset(places, k, sizes)
            if init(prepared, *place[:3]) or self.compute(prepared, t.shape[1], *place[3:]):
                # Once more, by the way that says what is refused.
                q, omega, attitude, rates, attitude_t, rates_t = (x[k] for x in rows)
                one = q, omega, attitude, rates, attitude_t, rates_t
                self._one(k, bodies, t[k if own else 0], one, lenient)
        return found

    def _one(
        self,
        k: int,
        bodies: Mapping[str, np.ndarray],
        t: np.ndarray,
        found: Sensitivities,
        lenient: bool,
    ) -> None:
        try:
            prepared = self.engine.prepare(*(array[k] for array in bodies.values()))
            self._fill(prepared, t, found, lenient)
        except EngineError as error:
            if not lenient:
                raise EngineError(error.field, error.rule, k, error.time) from None
            for x in found:
                x[...] = np.nan
