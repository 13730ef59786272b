"""Interface of peer programs, and checks of their inputs."""

import math
from dataclasses import dataclass
from importlib import import_module, metadata
from types import ModuleType
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._engines import EngineError, Prepared, States
from rigidsym.errors import InputError

Floats = tuple[float, ...]


class Solver(Protocol):
    """Interface of a program that computes the states of a motion.

    Conventions and units are those of `rigidsym._engines.Engine`.
    """

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Prepare one motion from its inputs.

        They are moments (3,), rates (3,) and a quaternion (4,) of any length.
        """
        ...

    def states(self, prepared: Prepared, t: ArrayLike) -> States:
        """Compute the states of a prepared motion at times.

        They are q (N, 4) and omega (N, 3) at t (N,), in any order and of any sign.
        """
        ...


class Peer(Solver, Protocol):
    """Interface of a peer, an independent program that computes states.

    It computes the states of a motion.  Nothing is rescaled or corrected on the way, but the
    attitude at t = 0 is normalised.  Both methods raise EngineError for what the peer refuses; a
    state that it fails to reach is NaN. One thread at a time.

    name: as in PEERS.  version: of its package.  reach: the largest |omega0 t| (rad) at which it is
    measured, since more takes too long.  double_cover_sign: True if q is continuous from attitude0
    on, its sign included; if False, q is a rotation by either sign, and the smaller error counts.
    """

    name: str
    version: str
    reach: float
    double_cover_sign: bool


def needed(peer: str, module: str, package: str) -> tuple[ModuleType, str]:
    """Import a module that a peer needs, and return it with its package's version.

    Raises InputError if it is missing.
    """
    try:
        return import_module(module), metadata.version(package)
    except ImportError:
        raise InputError("peer", peer, f"needs the package {package} (extra bench)") from None


@dataclass(frozen=True, slots=True)
class Start:
    """Checked inputs of a motion for a peer.

    They are moments (3), rates (3) and a unit quaternion (4) at t = 0.
    """

    inertia: Floats
    omega0: Floats
    attitude0: Floats

    @classmethod
    def of(cls, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> "Start":
        """Check the inputs of a motion, and normalise its quaternion.

        Raises EngineError if they are no motion.
        """
        moments, rates = _vector("inertia", inertia, 3), _vector("omega0", omega0, 3)
        quaternion = _vector("attitude0", attitude0, 4)
        if min(moments) <= 0:
            raise EngineError("inertia", "principal moments must be positive")
        largest = max(map(abs, quaternion))
        if largest == 0:
            raise EngineError("attitude0", "must not be zero")
        # Scaled by a power of two first, so that no square leaves the range.
        exponent = math.frexp(largest)[1]
        scaled = [math.ldexp(x, -exponent) for x in quaternion]
        length = math.hypot(*scaled)
        return cls(moments, rates, tuple(x / length for x in scaled))

    @property
    def state(self) -> Floats:
        """The initial state, with the attitude before the rates.

        It has 7 numbers.
        """
        return (*self.attitude0, *self.omega0)


def checked(t: ArrayLike) -> np.ndarray:
    """Convert times to a one-dimensional array of finite numbers.

    Raises EngineError for others.
    """
    times = _numbers("t", t)
    if times.ndim != 1:
        raise EngineError("t", f"shape {times.shape}: must be (N,)")
    return times


def _vector(field: str, values: ArrayLike, size: int) -> Floats:
    array = _numbers(field, values)
    if array.shape != (size,):
        raise EngineError(field, f"shape {array.shape}: one body's must be ({size},)")
    return tuple(array.tolist())


def _numbers(field: str, values: ArrayLike) -> np.ndarray:
    try:
        array = np.asarray(values, float)
    except (TypeError, ValueError, OverflowError):
        raise EngineError(field, "must be numbers") from None
    if not np.all(np.isfinite(array)):
        raise EngineError(field, "every number must be finite")
    return array
