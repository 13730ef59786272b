"""Implementations under test: generated modules, step functions and peer programs."""

import json
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _engines as engines
from rigidsym._engines import Engine, Prepared, States, Stepper
from rigidsym.errors import InputError, unknown
from rigidsym.validate._singles import TARGETS as SINGLES
from rigidsym.validate._singles import Singles, SingleSteps, single
from rigidsym.validate.peers import Peer, peer

# Inertia (1, 3) in kg m^2, q (1, 4) and omega (1, 3) in rad/s.
Start = tuple[np.ndarray, np.ndarray, np.ndarray]
# Bodies of other kinds, as moments, attitude and rates over some size: a symmetric one, a sphere,
# one on the separatrix, one that spins, and one at rest.
_OTHERS = np.array(
    [
        [2, 2, 1, 0.5, 0.5, -0.5, 0.5, 0.6, -0.64, 0.48],
        [1, 1, 1, 1, 0, 0, 0, 0.6, -0.64, 0.48],
        [3, 4, 6, 0, 1, 0, 0, 1, 0.5, 0.5],
        [1, 2, 2.5, 0, 0, 0, -1, 0, 0.5, 0],
        [1, 2, 2.5, 1, 1, 1, 1, 0, 0, 0],
    ]
)


@dataclass(frozen=True, slots=True)
class Steps:
    """Engine that computes each state by a single time step from the start."""

    stepper: Stepper

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Prepare one motion by copying its inputs.

        They are moments (3,), rates (3,) and a quaternion (4,) of any length.
        """
        inertia, q, omega = (np.array([x], float) for x in (inertia, attitude0, omega0))
        return inertia, q, omega

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """Compute the states after steps of different durations from the start.

        These are q (N, 4) and omega (N, 3) after steps of t (N,) s.
        """
        inertia, q, omega = prepared
        times = np.atleast_1d(np.asarray(t, float))
        return self._after(inertia, _rows(q, times), _rows(omega, times), times)

    def ways(self, prepared: Start, times: np.ndarray) -> Iterator[tuple[States, States]]:
        """Call the step function in several ways, and yield computed and expected states."""
        expected = self.states(prepared, times)
        # A call for each step.
        alone = [self._after(*prepared, times[k : k + 1]) for k in range(len(times))]
        q, omega = (np.concatenate([x[k] for x in alone]) for k in (0, 1))
        yield (q, omega), expected
        # Outputs that are the inputs, of bodies that have moments each.
        inertia, q, omega = (_rows(x, times) for x in prepared)
        self.stepper.step(inertia, q, omega, times, (q, omega))
        yield (q, omega), expected
        yield self._among_others(prepared, times), expected
        # The last of several bodies that have one time.
        few = np.full(3, times[-1])
        q, omega = self._after(*(_rows(x, few) for x in prepared), few[:1])
        yield (q[-1:], omega[-1:]), self.states(prepared, times[-1])

    def _after(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray
    ) -> States:
        # New memory may hold numbers of an earlier call.
        out = np.full_like(q, 99.0), np.full_like(omega, 99.0)
        self.stepper.step(inertia, q, omega, dt, out)
        return out

    def _among_others(self, prepared: Start, times: np.ndarray) -> States:
        """Compute states in a batch where every second row is a different body."""
        # Powers of two near the sizes, of which quarters are doubles of full length.
        sizes = [np.frexp(np.max(np.abs(x)) or 1.0)[1] - 4 for x in prepared]
        scales = 2.0 ** np.clip(np.array(sizes, float), -1000, 1000)
        other = np.resize(_OTHERS, (len(times), 10)) * np.repeat(scales, (3, 4, 3))
        pairs = np.stack([other, np.hstack([_rows(x, times) for x in prepared])], axis=1)
        mixed = np.hsplit(pairs.reshape(-1, 10), [3, 7])
        inertia, q, omega = map(np.ascontiguousarray, mixed)
        q, omega = self._after(inertia, q, omega, np.repeat(times, 2))
        return q[1::2], omega[1::2]


def _rows(one: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Repeat a one-row array so that it has a row for each time."""
    return np.repeat(one, len(times), axis=0)


PEER = "peer "
TARGETS = (*engines.EVERY, *engines.STEPPERS, *SINGLES)
Implementation = Engine | Peer | Steps | Singles | SingleSteps


def check_target(target: str) -> None:
    """Check that a target can be measured on this machine.

    Parameters
    ----------
    target : a name such as "numpy", "c", "c-pi" or "numpy-step"

    Raises
    ------
    InputError
        If there is no module of this name, or it does not compile here.
    """
    if target not in TARGETS:
        raise unknown("target", target, TARGETS, plain=True)
    try:
        implementation(target)
    except InputError as error:
        raise InputError("target", target, error.rule) from None


def missing(targets: Sequence[str] = engines.ENGINES) -> dict[str, str]:
    """Return the reasons why targets cannot be measured on this machine, by target.

    The reason is "" for a target that can be measured.
    """
    found = {}
    for target in targets:
        try:
            check_target(target)
            found[target] = ""
        except InputError as error:
            found[target] = error.rule
    return found


def implementation(name: str) -> Implementation:
    """Return the implementation of a given name, such as "c" or "peer heyoka".

    Raises InputError where there is none.
    """
    if name.startswith(PEER):
        return own_peer(name.removeprefix(PEER))
    if name in SINGLES:
        return single(name)
    if name in engines.STEPPERS:
        return Steps(engines.exact_stepper(name))
    return engines.exactly(name)


def own_peer(name: str) -> Peer:
    """Return this thread's instance of a peer program.

    Raises InputError where there is none.
    """
    # Peers serve one thread at a time, and workers of a cluster have several.
    return _peer(name, threading.get_ident())


@cache
def _peer(name: str, thread: int) -> Peer:
    return peer(name)


def digest(target: str) -> str:
    """Return the digest of an installed generated module."""
    package = resources.files("rigidsym.generated")
    text = package.joinpath(f"{target}.map.json").read_text(encoding="utf-8")
    return json.loads(text)["manifest"]["digest"]
