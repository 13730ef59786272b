"""A user's own integrator as a peer: what it does wrong is a finding, never a traceback."""

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeGuard, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import EVERY, STEPPERS, EngineError, Prepared, States
from rigidsym.errors import InputError
from rigidsym.validate.peers import PEERS
from rigidsym.validate.peers.initial_state import Start, both_ways
from rigidsym.validate.peers.protocol import Solver

# (inertia (3,), omega0 (3,), attitude0 (4,), times (N,)) -> (q (N, 4), omega (N, 3)).
Integrator = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], tuple[ArrayLike, ArrayLike]]
Given = TypeVar("Given")

# What goes in steps would never return from the farthest times: as far as short strata go, rad.
REACH = 300.0
VERSION = "not numbered"
_RULE = "must be a function of (inertia, omega0, attitude0, times), or have prepare and states"
_NAME = re.compile(r"[\w.+-]+( [\w.+-]+)*")


@dataclass(frozen=True, slots=True)
class UserIntegrator:
    """A peer whose failures, of whatever kind, are refusals; `said` keeps what they were."""

    peer: Solver
    name: str
    version: str
    reach: float
    double_cover_sign: bool
    said: list[str] = field(default_factory=list)

    @classmethod
    def of(
        cls,
        integrator: Integrator | Solver,
        name: str | None = None,
        reach: float | None = None,
        double_cover_sign: bool | None = None,
    ) -> "UserIntegrator":
        """A callable, or an object with the methods of `Peer`, as a peer; what is None is taken
        from the object where it has it.  Raises InputError where it is neither, or cannot be called
        so."""
        said: list[str] = []
        if _is_solver(integrator):
            peer: Solver = integrator
        elif _is_function(integrator):
            peer = Follower(integrator, said)
        else:
            raise InputError("integrator", repr(integrator), _RULE)
        return cls(
            peer,
            _name(_first(name, getattr(integrator, "name", None), _called(integrator))),
            str(getattr(integrator, "version", VERSION)),
            _reach(_first(reach, getattr(integrator, "reach", None), REACH)),
            bool(_first(double_cover_sign, getattr(integrator, "double_cover_sign", None), True)),
            said,
        )

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """See `Peer`."""
        return _tried(self.said, lambda: self.peer.prepare(inertia, omega0, attitude0))

    def states(self, prepared: Prepared, t: ArrayLike) -> States:
        """See `Peer`."""
        return _tried(self.said, lambda: shaped(self.peer.states(prepared, t), np.size(t)))


@dataclass(frozen=True, slots=True)
class Follower:
    """The methods of a peer, by a function of body, rates, attitude and times.

    It is asked for times that leave zero on one side, each farther than the one before; a state at
    t = 0 is the given one.  Where it fails on one side, its states there are NaN.
    """

    integrator: Integrator
    said: list[str]

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Start:
        """See `Peer`."""
        return Start.of(inertia, omega0, attitude0)

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """See `Peer`."""
        return both_ways(prepared, t, lambda times: self._followed(prepared, times))

    def _followed(self, prepared: Start, times: np.ndarray) -> np.ndarray:
        # Arrays of its own, which it may overwrite.
        given = [
            np.array(x) for x in (prepared.inertia, prepared.omega0, prepared.attitude0, times)
        ]
        states = _tried(self.said, lambda: shaped(self.integrator(*given), times.size))
        return np.hstack(states)


def _is_solver(integrator: object) -> TypeGuard[Solver]:
    return all(callable(getattr(integrator, method, None)) for method in ("prepare", "states"))


def _is_function(integrator: object) -> TypeGuard[Integrator]:
    return callable(integrator)


def shaped(states: object, count: int) -> States:
    """(q, omega) as arrays of float64, (N, 4) and (N, 3); raises EngineError for anything else."""
    if not isinstance(states, Sequence | np.ndarray) or len(states) != 2:
        raise EngineError("integrator", f"gives {type(states).__name__}: must be (q, omega)")
    return _rows("q", states[0], (count, 4)), _rows("omega", states[1], (count, 3))


def _rows(field: str, values: object, shape: tuple[int, int]) -> np.ndarray:
    try:
        found = np.asarray(values)
        # Complex numbers would lose a part without a word.
        rows = found.astype(float, casting="same_kind" if found.dtype.kind == "c" else "unsafe")
    except (TypeError, ValueError, OverflowError):
        raise EngineError(field, "must be real numbers") from None
    if rows.shape != shape:
        raise EngineError(field, f"shape {rows.shape}: must be {shape}")
    return rows


def _tried(said: list[str], work: Callable[[], Given]) -> Given:
    """What the user's code gives; raises EngineError for whatever it raises, once it is noted."""
    try:
        return work()
    except Exception as error:
        text = " ".join(str(error).split())
        line = text if isinstance(error, EngineError) else f"{type(error).__name__}: {text}"
        said.append(line.removesuffix(": "))
        raise EngineError("integrator", said[-1]) from None


def _first(*values: Given | None) -> Given:
    return next(value for value in values if value is not None)


def _called(integrator: object) -> str:
    """What a function is called, or what an object is."""
    return getattr(integrator, "__name__", type(integrator).__name__).strip("<>")


def _name(name: str) -> str:
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise InputError("name", repr(name), "must be words of letters, digits and . + - _")
    if name in (*PEERS, *EVERY, *STEPPERS):
        raise InputError("name", name, "is measured by that name already: choose another")
    return name


def _reach(reach: float) -> float:
    try:
        found = math.nan if isinstance(reach, bool) else float(reach)
    except (TypeError, ValueError):
        found = math.nan
    if not found > 0:
        raise InputError("reach", repr(reach), "must be a number above zero (rad), or infinite")
    return found
