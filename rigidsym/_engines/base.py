"""Abstract base class of the engines."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

from numpy.typing import ArrayLike

from rigidsym._engines import arrays, blocks
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym.errors import EngineError

if TYPE_CHECKING:
    from rigidsym._engines.exact_inputs import ExactInputs

# The constants of one motion, in a form that only their engine reads.
Prepared: TypeAlias = Any


class Engine(ABC):
    """Abstract engine, which computes states of motions and their derivatives in float64.

    Times in s, rates in rad/s, inertia in kg m^2, quaternions scalar first.  With `out`, a pair of
    C-contiguous arrays of exactly the shapes named that share no memory with each other or an
    input, these are filled and returned; after an error their contents are undefined.  Prepared
    motions share no memory with inputs.  All methods raise EngineError; with errors="nan" bodies
    and times that are refused have states of NaN instead.
    """

    __slots__ = ()

    @property
    @abstractmethod
    def has_sensitivities(self) -> bool:
        """True if the engine can compute derivatives of states.

        Only modules of the theta form have these sensitivities.
        """

    @abstractmethod
    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Compute the constants of one motion from float64 inputs.

        The shapes are (3,), (3,) and (4,).
        """

    def prepare_exactly(
        self,
        inertia: Sequence[Fraction],
        omega0: Sequence[Fraction],
        attitude0: Sequence[Fraction],
    ) -> Prepared:
        """Compute the constants of one motion from exact inputs.

        These are not rounded to float64.
        """
        # Here, because doubles need nothing of it.
        from rigidsym._engines.exact_inputs import exact_inputs

        return self._prepare_pairs(exact_inputs(inertia, omega0, attitude0))

    @abstractmethod
    def _prepare_pairs(self, given: "ExactInputs") -> Prepared:
        """Compute the constants of one motion from inputs that are sums of two doubles."""

    @abstractmethod
    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """Return the states of a prepared motion at times.

        These are q (4,) and omega (3,) at a scalar t, or (N, 4) and (N, 3) at t (N,).
        """

    @abstractmethod
    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """Return the states of a prepared motion at times, and their derivatives.

        columns: names of the inputs to differentiate by, all by default.
        """

    @abstractmethod
    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """Return the states of a prepared motion at equally spaced times.

        These are q (count, 4) and omega (count, 3) at the times start + k step.  C takes these
        times exactly, NumPy the doubles nearest to them.
        """

    def propagate(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        out: Outputs = None,
        errors: str = "raise",
    ) -> States:
        """Return the states of many bodies at times.

        These are q (..., N, 4) and omega (..., N, 3).  Leading shapes broadcast, those of t (...,
        N) among them: (N,) are times of all bodies, (B, N) a row for each; a scalar t has no N.
        Errors have the index of the body, counted through all leading axes.
        """
        batch = arrays.batch(inertia, omega0, attitude0, t)
        return self.batch_states(batch, arrays.is_lenient(errors), out)

    def propagate_sensitivities(
        self,
        inertia: ArrayLike,
        omega0: ArrayLike,
        attitude0: ArrayLike,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """Return the states of many bodies at times, and their derivatives."""
        batch, names = arrays.batch(inertia, omega0, attitude0, t), arrays.columns(columns)
        return self.batch_sensitivities(batch, arrays.is_lenient(errors), names)

    def batch_states(self, batch: Batch, lenient: bool, out: Outputs = None) -> States:
        """Return the states of a batch of bodies.

        With `lenient`, bodies and times that are refused have states of NaN.
        """
        if blocks.are_streams(out):

            def compute(part: blocks.Part, states: States) -> None:
                self._fill(batch.part(part), states, lenient, None)

            given = (batch.t, *batch.bodies.values())
            return blocks.fill(out, batch.shape, given, compute, len(batch.leading))
        states = arrays.outputs(out, batch.shape, batch.t, *batch.bodies.values())
        self._fill(batch, states, lenient, None)
        return states

    def batch_sensitivities(
        self, batch: Batch, lenient: bool, columns: tuple[str, ...]
    ) -> Sensitivities:
        """Return the states of a batch of bodies, and their derivatives."""
        self._check_has_sensitivities()
        found = arrays.sensitivities(batch.shape, columns)
        self._fill(batch, found, lenient, columns)
        return found

    @abstractmethod
    def _fill(
        self,
        batch: Batch,
        found: States | Sensitivities,
        lenient: bool,
        columns: tuple[str, ...] | None,
    ) -> None:
        """Compute the states of a batch and their derivatives, and write them to arrays.

        Without derivatives `columns` is None.
        """

    def _check_has_sensitivities(self) -> None:
        if not self.has_sensitivities:
            raise EngineError("engine", "its module has no sensitivities")
