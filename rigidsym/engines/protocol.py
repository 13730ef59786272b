"""What every engine does, and how it refuses."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

States = tuple[np.ndarray, np.ndarray]
Outputs = States | None
# q (..., 4) and omega (..., 3), then what a small turn and the rates (..., 3, 9) change by with a
# small turn at t = 0, the rates there and the moments, and both (..., 3) with the time.
Sensitivities = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]
# The constants of one motion, in a form that is the engine's own and that nobody else reads.
Prepared: TypeAlias = Any


class EngineError(ValueError):
    """What an engine cannot compute, as "field: rule".

    `body` and `time` are the indices of the first of each.
    """

    def __init__(
        self, field: str, rule: str, body: int | None = None, time: int | None = None
    ) -> None:
        super().__init__(f"{field}: {rule}")
        self.field, self.rule, self.body, self.time = field, rule, body, time


class Engine(Protocol):
    """Plans, states at times, states on grids, and batches, all in float64.

    Times in s, rates in rad/s, inertia in kg m^2, quaternions scalar first.  With `out`, a pair of
    C-contiguous arrays of exactly the shapes named that share no memory with each other or an
    input, these are filled and returned; what they hold after an error is undefined.  Plans share
    no memory with inputs.  All methods raise ValueError with one line, "field: rule"; with
    errors="nan" bodies and times that are refused have states of NaN instead.
    """

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Constants of one motion from float64 numbers: (3,), (3,) and (4,)."""
        ...

    def prepare_exactly(
        self,
        inertia: Sequence[Fraction],
        omega0: Sequence[Fraction],
        attitude0: Sequence[Fraction],
    ) -> Prepared:
        """Constants of one motion from exact numbers, which are not rounded to float64 first."""
        ...

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """(q, omega): (4,) and (3,) at a scalar t, (N, 4) and (N, 3) at t (N,)."""
        ...

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """(q, omega), (count, 4) and (count, 3), at the times start + k step.

        C takes these times exactly, NumPy the doubles nearest to them.
        """
        ...

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        out: Outputs = None,
        errors: str = "raise",
    ) -> States:
        """(q, omega) of many bodies: (..., N, 4) and (..., N, 3).

        Leading shapes broadcast, those of t (..., N) among them: (N,) are times of all bodies,
        (B, N) a row for each; a scalar t has no N.
        """
        ...
