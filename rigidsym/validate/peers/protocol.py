"""What every peer does, and what it is honest about."""

from importlib import import_module, metadata
from types import ModuleType
from typing import Protocol

from numpy.typing import ArrayLike

from rigidsym.engines import Prepared, States
from rigidsym.errors import InputError


class Solver(Protocol):
    """What finds the states of a motion.

    Conventions and units are those of `rigidsym.engines.Engine`.
    """

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """One motion from float64 numbers: (3,), (3,) and (4,), the last of any length but zero."""
        ...

    def states(self, prepared: Prepared, t: ArrayLike) -> States:
        """(q, omega), (N, 4) and (N, 3), at times t (N,) in any order, of any sign."""
        ...


class Peer(Solver, Protocol):
    """Another program that finds the states of a motion, given the numbers as a user would.

    Nothing is rescaled or mended on the way, but for the attitude at t = 0, which is normalised.
    Both methods raise EngineError for what the peer refuses; a state that it fails to reach is NaN.
    One thread at a time.
    """

    @property
    def name(self) -> str:
        """As in PEERS."""
        ...

    @property
    def version(self) -> str:
        """Of its package."""
        ...

    @property
    def reach(self) -> float:
        """The largest |omega0 t| (rad) it is to be asked for; beyond, it takes too long."""
        ...

    @property
    def double_cover_sign(self) -> bool:
        """Whether q is continuous from attitude0 on, its sign included.

        If not, q is a rotation by either of its signs, and the smaller error of the two is due.
        """
        ...


def needed(peer: str, module: str, package: str) -> tuple[ModuleType, str]:
    """A module and the version of its package; raises InputError where it cannot be imported."""
    try:
        return import_module(module), metadata.version(package)
    except ImportError:
        raise InputError("peer", peer, f"needs the package {package} (extra bench)") from None
