"""The engine on the generated NumPy module: it works everywhere, without a compiler."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import arrays
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym._engines.base import Engine, Prepared
from rigidsym.errors import EngineError
from rigidsym.generated import torque_free

# Bodies at a time: preparing takes 4 KB of memory for each.
_BODIES = 4096


@dataclass(frozen=True, slots=True)
class NumpyEngine(Engine):
    """The engine on `rigidsym.generated.torque_free` or a module like it."""

    module: Any = torque_free

    @property
    def has_sensitivities(self) -> bool:
        """True if the module has sensitivities."""
        return hasattr(self.module, "sensitivities")

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """See `Engine`."""
        try:
            return self.module.prepare(inertia, omega0, attitude0)
        except self.module._RefusedError as error:
            raise _refused(error) from None

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
        given = inertia, differences, omega0, attitude0, discriminant, unit
        try:
            return self.module.prepare_from_double_doubles(*given)
        except self.module._RefusedError as error:
            raise _refused(error) from None

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """See `Engine`."""
        if out is not None:
            times = np.asarray(t, float)
            arrays.outputs(out, (*prepared["shape"], *times.shape), times)
        try:
            return self.module.states(prepared, t, out, errors)
        except self.module._RefusedError as error:
            raise _refused(error) from None

    def grid(
        self,
        prepared: Prepared,
        start: float,
        step: float,
        count: int,
        out: Outputs = None,
    ) -> States:
        """See `Engine`."""
        return self.states(prepared, start + step * np.arange(arrays.count(count)), out)

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """See `Engine`."""
        self._check_has_sensitivities()
        try:
            return self.module.sensitivities(prepared, t, errors, arrays.columns(columns))
        except self.module._RefusedError as error:
            raise _refused(error) from None

    def _fill_states(self, batch: Batch, states: States, lenient: bool) -> None:
        t = batch.times
        rows = [x.reshape(batch.number, t.shape[1], x.shape[-1]) for x in states]

        def run(prepared: Prepared, times: np.ndarray, some: slice, errors: str) -> None:
            self.module.states(prepared, times, (rows[0][some], rows[1][some]), errors)

        self._in_blocks(batch, t, run, lenient)

    def _fill_sensitivities(
        self, batch: Batch, found: Sensitivities, columns: tuple[str, ...], lenient: bool
    ) -> None:
        t, lasts = batch.times, arrays.sensitivity_shapes(columns)
        rows = [x.reshape(batch.number, t.shape[1], *y) for x, y in zip(found, lasts, strict=True)]

        def run(prepared: Prepared, times: np.ndarray, some: slice, errors: str) -> None:
            block = self.module.sensitivities(prepared, times, errors, columns)
            for row, values in zip(rows, block, strict=True):
                row[some] = values

        self._in_blocks(batch, t, run, lenient)

    def _in_blocks(
        self,
        batch: Batch,
        t: np.ndarray,
        run: Callable[[Prepared, np.ndarray, slice, str], None],
        lenient: bool,
    ) -> None:
        """Prepare a block of bodies at a time, and run it at its times."""
        errors = "nan" if lenient else "raise"
        for some, bodies in _blocks(batch):
            try:
                prepared = self.module.prepare(*bodies, errors)
                run(prepared, t[some] if len(t) > 1 else t[0], some, errors)
            except self.module._RefusedError as error:
                raise _refused(error, some.start) from None


def _blocks(batch: Batch) -> Iterator[tuple[slice, list[np.ndarray]]]:
    """Yield blocks of bodies as slices of all of them, with their rows (B, 3), (B, 3), (B, 4)."""
    leading = batch.leading
    whole = [np.broadcast_to(x, (*leading, x.shape[-1])) for x in batch.bodies.values()]
    for first in range(0, batch.number, _BODIES):
        some = slice(first, first + _BODIES)
        index = np.unravel_index(range(batch.number)[some], leading) if leading else ()
        yield some, [x[index].reshape(-1, x.shape[-1]) for x in whole]


def _refused(error: Any, first: int = 0) -> EngineError:
    """Return the error of the generated module for a block of bodies that begins with `first`."""
    body = None if error.body is None else first + error.body
    return EngineError(error.field, error.rule, body, error.time)
