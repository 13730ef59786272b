"""Steps as an implementation: each state is one step from the start."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import Prepared, States, Stepper

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
    """What makes steps, with the methods that `measure` asks for."""

    stepper: Stepper

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """One motion from float64 numbers: (3,), (3,) and (4,), the last of any length but zero."""
        inertia, q, omega = (np.array([x], float) for x in (inertia, attitude0, omega0))
        return inertia, q, omega

    def states(self, prepared: Start, t: ArrayLike) -> States:
        """(q, omega), (N, 4) and (N, 3), after steps of t (N,) s."""
        inertia, q, omega = prepared
        times = np.atleast_1d(np.asarray(t, float))
        return self._after(inertia, _rows(q, times), _rows(omega, times), times)

    def ways(self, prepared: Start, times: np.ndarray) -> Iterator[tuple[States, States]]:
        """What callers do with a step: the states they get, and the states at the same times."""
        expected = self.states(prepared, times)
        yield self._alone(prepared, times), expected
        yield self._in_place(prepared, times), expected
        yield self._among_others(prepared, times), expected
        yield self._with_one_time(prepared, times[-1]), self.states(prepared, times[-1])

    def _after(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray
    ) -> States:
        # Memory anew may hold numbers of an earlier call.
        out = np.full_like(q, 99.0), np.full_like(omega, 99.0)
        self.stepper.step(inertia, q, omega, dt, out)
        return out

    def _alone(self, prepared: Start, times: np.ndarray) -> States:
        """A call for each step."""
        states = [self._after(*prepared, times[k : k + 1]) for k in range(len(times))]
        return np.concatenate([q for q, _ in states]), np.concatenate([w for _, w in states])

    def _in_place(self, prepared: Start, times: np.ndarray) -> States:
        """Outputs that are the inputs, of bodies that have moments each."""
        inertia, q, omega = (_rows(x, times) for x in prepared)
        self.stepper.step(inertia, q, omega, times, (q, omega))
        return q, omega

    def _among_others(self, prepared: Start, times: np.ndarray) -> States:
        """Each step behind others of bodies of other kinds, one after the other."""
        sizes = [np.max(np.abs(x)) or 1.0 for x in prepared]
        other = np.resize(_OTHERS, (len(times), 10)) * np.repeat(
            list(map(_power, sizes)), (3, 4, 3)
        )
        pairs = np.stack([other, np.hstack([_rows(x, times) for x in prepared])], axis=1)
        mixed = np.hsplit(pairs.reshape(-1, 10), [3, 7])
        inertia, q, omega = map(np.ascontiguousarray, mixed)
        q, omega = self._after(inertia, q, omega, np.repeat(times, 2))
        return q[1::2], omega[1::2]

    def _with_one_time(self, prepared: Start, time: float) -> States:
        """The last of several bodies that have one time."""
        few = np.full(3, time)
        q, omega = self._after(*(_rows(x, few) for x in prepared), few[:1])
        return q[-1:], omega[-1:]


def _rows(one: np.ndarray, times: np.ndarray) -> np.ndarray:
    """A row for each time."""
    return np.repeat(one, len(times), axis=0)


def _power(size: float) -> float:
    """A power of two near a size, of which quarters are doubles of full length."""
    return 2.0 ** float(np.clip(np.frexp(size)[1] - 4, -1000, 1000))
