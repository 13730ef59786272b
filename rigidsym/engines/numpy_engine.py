"""The engine on the generated NumPy module: works everywhere, one compiler less to trust."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import arrays
from rigidsym.engines.protocol import EngineError, Outputs, States
from rigidsym.generated import torque_free

# Bodies at a time: a prepared motion takes 4 KB of memory for each while it is made.
_BODIES = 4096


class Prepared(TypedDict):
    """What the module prepares: constants of B motions, in units of `unit` (B,), rad/s.

    `groups` are a branch, the indices of its motions, and their constants by name.
    """

    shape: tuple[int, ...]
    unit: np.ndarray
    max_angle: np.ndarray
    blurred: np.ndarray
    axes: np.ndarray
    q0: np.ndarray
    omega0: np.ndarray
    moment_unit: np.ndarray
    groups: list[tuple[str, np.ndarray, dict[str, np.ndarray]]]


class Module(Protocol):
    """What the generated module offers."""

    def prepare(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike = ...,
        errors: str = ...,
    ) -> Prepared:
        """Constants of motions whose leading shapes broadcast."""
        ...

    def prepare_from_double_doubles(
        self,
        inertia: ArrayLike,
        differences: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        discriminant: ArrayLike,
        unit: float,
    ) -> Prepared:
        """Constants of one motion, from sums of two doubles."""
        ...

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = ...
    ) -> States:
        """(q, omega) of them all at each time."""
        ...


@dataclass(frozen=True, slots=True)
class NumpyEngine:
    """`rigidsym.generated.torque_free`, or a module like it, as an `Engine`."""

    module: Module = torque_free

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """See `Engine`."""
        return self.module.prepare(inertia, omega0, attitude0)

    def prepare_exactly(
        self,
        inertia: Sequence[Fraction],
        omega0: Sequence[Fraction],
        attitude0: Sequence[Fraction],
    ) -> Prepared:
        """See `Engine`."""
        # Here, because doubles need nothing of it.
        from rigidsym.engines.exact_inputs import exact_inputs

        return self.module.prepare_from_double_doubles(*exact_inputs(inertia, omega0, attitude0))

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """See `Engine`."""
        if out is not None:
            times = np.asarray(t, float)
            arrays.outputs(out, (*prepared["shape"], *times.shape), times)
        return self.module.states(prepared, t, out, errors)

    def grid(
        self,
        prepared: Prepared,
        start: float,
        step: float,
        count: int,
        out: Outputs = None,
    ) -> States:
        """See `Engine`; at the doubles nearest to these times."""
        return self.states(prepared, start + step * np.arange(arrays.count(count)), out)

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        out: Outputs = None,
        errors: str = "raise",
    ) -> States:
        """See `Engine`; prepared motions are made for a block of bodies at a time."""
        given = arrays.named(inertia, omega0, attitude0)
        arrays.is_lenient(errors)
        t = np.asarray(t, float)
        shape = arrays.batch(given, t)
        q, omega = arrays.outputs(out, (*shape, *t.shape[-1:]), t, *given.values())
        t, count = arrays.row_or_rows(t, shape), math.prod(shape)
        rows = q.reshape(count, t.shape[1], 4), omega.reshape(count, t.shape[1], 3)

        def run(prepared: Prepared, times: np.ndarray, some: slice) -> None:
            self.module.states(prepared, times, (rows[0][some], rows[1][some]), errors)

        in_blocks(self.module, given, t, shape, errors, run)
        return q, omega


def in_blocks(
    module: Any,
    given: Mapping[str, np.ndarray],
    t: np.ndarray,
    shape: tuple[int, ...],
    errors: str,
    run: Callable[[Prepared, np.ndarray, slice], None],
) -> None:
    """Prepare a block of bodies at a time, and run it at its times."""
    whole = [np.broadcast_to(x, (*shape, x.shape[-1])) for x in given.values()]
    for first in range(0, math.prod(shape), _BODIES):
        some = slice(first, first + _BODIES)
        index = np.unravel_index(range(math.prod(shape))[some], shape) if shape else ()
        bodies = [x[index].reshape(-1, x.shape[-1]) for x in whole]
        try:
            prepared = module.prepare(*bodies, errors)
            run(prepared, t[some] if len(t) > 1 else t[0], some)
        except module._RefusedError as error:
            body = None if error.body is None else first + error.body
            raise EngineError(error.field, error.rule, body, error.time) from None
