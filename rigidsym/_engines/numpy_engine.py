"""The engine that computes states by the generated NumPy module."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import arrays
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym._engines.base import Engine, Prepared
from rigidsym.errors import EngineError
from rigidsym.generated import torque_free

if TYPE_CHECKING:
    from rigidsym._engines.exact_inputs import ExactInputs

# Bodies at a time: preparing takes 4 KB of memory for each.
_BODIES = 4096


@dataclass(frozen=True, slots=True)
class NumpyEngine(Engine):
    """Engine that calls a generated NumPy module.

    By default this is `rigidsym.generated.torque_free`.
    """

    module: Any = torque_free

    @property
    def has_sensitivities(self) -> bool:
        """True if the NumPy module can compute derivatives of states."""
        return hasattr(self.module, "sensitivities")

    def _called(self, function: Callable[..., Any], *given: Any) -> Any:
        """Call a function of the NumPy module.

        Raises EngineError if the module refuses the arguments.
        """
        try:
            return function(*given)
        except self.module._RefusedError as error:
            raise EngineError(error.field, error.rule, error.body, error.time) from None

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Compute the constants of one motion by the NumPy module."""
        return self._called(self.module.prepare, inertia, omega0, attitude0)

    def _prepare_pairs(self, given: "ExactInputs") -> Prepared:
        return self._called(self.module.prepare_from_double_doubles, *given)

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """Compute states at times by the NumPy module."""
        if out is not None:
            times = np.asarray(t, float)
            arrays.outputs(out, (*prepared["shape"], *times.shape), times)
        return self._called(self.module.states, prepared, t, out, errors)

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """Compute states and their derivatives at times by the NumPy module."""
        self._check_has_sensitivities()
        names = arrays.columns(columns)
        return self._called(self.module.sensitivities, prepared, t, errors, names)

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """Compute states at the doubles nearest to the times start + k step."""
        return self.states(prepared, start + step * np.arange(count), out)

    def _fill(
        self,
        batch: Batch,
        found: States | Sensitivities,
        lenient: bool,
        columns: tuple[str, ...] | None,
    ) -> None:
        t, errors = batch.times, "nan" if lenient else "raise"
        ends = arrays.shapes(columns)
        rows = [x.reshape(batch.number, t.shape[1], *y) for x, y in zip(found, ends, strict=True)]
        for some, bodies in _blocks(batch):
            own = [x[some] for x in rows]
            try:
                prepared = self.module.prepare(*bodies, errors)
                times = t[some] if len(t) > 1 else t[0]
                if columns is None:
                    self.module.states(prepared, times, (own[0], own[1]), errors)
                    continue
                values = self.module.sensitivities(prepared, times, errors, columns)
            except self.module._RefusedError as error:
                body = None if error.body is None else some.start + error.body
                raise EngineError(error.field, error.rule, body, error.time) from None
            for row, value in zip(own, values, strict=True):
                row[...] = value


def _blocks(batch: Batch) -> Iterator[tuple[slice, list[np.ndarray]]]:
    """Divide a batch into blocks of bodies, and yield their slices and inputs.

    Inputs are rows (B, 3), (B, 3) and (B, 4).
    """
    leading = batch.leading
    whole = [np.broadcast_to(x, (*leading, x.shape[-1])) for x in batch.bodies.values()]
    for first in range(0, batch.number, _BODIES):
        some = slice(first, first + _BODIES)
        index = np.unravel_index(range(batch.number)[some], leading) if leading else ()
        yield some, [x[index].reshape(-1, x.shape[-1]) for x in whole]
