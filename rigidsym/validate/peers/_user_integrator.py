"""Adapter that measures a user's integrator as a peer.

Exceptions of the integrator become results of the report.
"""

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import EVERY, STEPPERS, EngineError, Prepared, States
from rigidsym.errors import InputError
from rigidsym.validate.peers import PEERS
from rigidsym.validate.peers._integrators import Integrator
from rigidsym.validate.peers._protocol import Solver, Start

# (inertia (3,), omega0 (3,), attitude0 (4,), times (N,)) -> (q (N, 4), omega (N, 3)).
Function = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], tuple[ArrayLike, ArrayLike]]
Given = TypeVar("Given")

# An integrator by steps would never return from the farthest times: as far as short strata go, rad.
REACH = 300.0
VERSION = "not numbered"
_RULE = "must be a function of (inertia, omega0, attitude0, times), or have prepare and states"
_NAME = re.compile(r"[\w.+-]+( [\w.+-]+)*")


@dataclass(slots=True)
class UserIntegrator:
    """Peer that calls a user's integrator.

    Exceptions of the integrator are refusals with a message in `said`.
    """

    peer: Solver
    name: str
    version: str
    reach: float
    double_cover_sign: bool
    said: list[str] = field(default_factory=list)

    @classmethod
    def of(
        cls,
        integrator: Function | Solver,
        name: str | None = None,
        reach: float | None = None,
        double_cover_sign: bool | None = None,
    ) -> "UserIntegrator":
        """Create a peer from a function or from an object with the methods of `Peer`.

        An argument that is None is taken from the object where it has it.  Raises InputError for
        other objects, and for names and reaches that a peer cannot have.
        """
        said: list[str] = []
        peer: Any = integrator
        if not all(callable(getattr(peer, method, None)) for method in ("prepare", "states")):
            if not callable(peer):
                raise InputError("integrator", repr(peer), _RULE)
            peer = _OfFunction(peer, said)

        def chosen(given: Given | None, field: str, default: Given) -> Given:
            values = given, getattr(integrator, field, None), default
            return next(value for value in values if value is not None)

        called = getattr(integrator, "__name__", type(integrator).__name__).strip("<>")
        return cls(
            peer,
            _checked_name(chosen(name, "name", called)),
            str(getattr(integrator, "version", VERSION)),
            _checked_reach(chosen(reach, "reach", REACH)),
            bool(chosen(double_cover_sign, "double_cover_sign", True)),
            said,
        )

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Prepare one motion by the user's integrator."""
        return _tried(self.said, lambda: self.peer.prepare(inertia, omega0, attitude0))

    def states(self, prepared: Prepared, t: ArrayLike) -> States:
        """Compute states by the user's integrator, and check their shapes."""
        return _tried(self.said, lambda: shaped(self.peer.states(prepared, t), np.size(t)))


@dataclass(frozen=True, slots=True)
class _OfFunction(Integrator):
    """Solver that calls a user's function once for each direction of time.

    A state at t = 0 is the given one.  Where the function fails on one side, its states are NaN.
    """

    function: Function
    said: list[str]

    def follow(self, start: Start, times: np.ndarray) -> np.ndarray:
        """Integrate a motion by the user's function.

        The function is given arrays of its own, which it may overwrite.
        """
        given = [np.array(x) for x in (start.inertia, start.omega0, start.attitude0, times)]
        return np.hstack(_tried(self.said, lambda: shaped(self.function(*given), times.size)))


def shaped(states: object, count: int) -> States:
    """Convert a user's result to float64 arrays of attitudes and rates.

    Their shapes are (N, 4) and (N, 3).  Raises EngineError for all else.
    """
    if not isinstance(states, Sequence | np.ndarray) or len(states) != 2:
        raise EngineError("integrator", f"gives {type(states).__name__}: must be (q, omega)")
    return _rows("q", states[0], (count, 4)), _rows("omega", states[1], (count, 3))


def _rows(field: str, values: object, shape: tuple[int, int]) -> np.ndarray:
    try:
        found = np.asarray(values)
        # Complex numbers would silently lose a part.
        rows = found.astype(float, casting="same_kind" if found.dtype.kind == "c" else "unsafe")
    except (TypeError, ValueError, OverflowError):
        raise EngineError(field, "must be real numbers") from None
    if rows.shape != shape:
        raise EngineError(field, f"shape {rows.shape}: must be {shape}")
    return rows


def _tried(said: list[str], work: Callable[[], Given]) -> Given:
    """Run a user's code, and convert its exceptions to EngineError.

    The message of an exception is kept in `said`.
    """
    try:
        return work()
    except Exception as error:
        text = " ".join(str(error).split())
        line = text if isinstance(error, EngineError) else f"{type(error).__name__}: {text}"
        said.append(line.removesuffix(": "))
        raise EngineError("integrator", said[-1]) from None


def _checked_name(name: str) -> str:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise InputError("name", repr(name), "must be words of letters, digits and . + - _")
    if name in (*PEERS, *EVERY, *STEPPERS):
        raise InputError("name", name, "is measured by that name already: choose another")
    return name


def _checked_reach(reach: float) -> float:
    try:
        found = math.nan if isinstance(reach, bool) else float(reach)
    except (TypeError, ValueError):
        found = math.nan
    if not found > 0:
        raise InputError("reach", repr(reach), "must be a number above zero (rad), or infinite")
    return found
