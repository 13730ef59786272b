"""States of a pushed body at the times asked for, and between them."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.splitting.state import State
from rigidsym.splitting.stepping import Splitting

# Of what a time is rounded by: nearer to the end of a step, it is that end.
_NEAR = 4 * float(np.finfo(float).eps)


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """What `integrate` returns: `q, omega = trajectory`, or a function of time.

    times (N,), s; q (..., N, 4); omega (..., N, 3), rad/s; step, s; evaluations: calls of the
    torque, each for all bodies; error: what `step=None` estimates, rad, else None.
    """

    times: np.ndarray
    q: np.ndarray
    omega: np.ndarray
    step: float
    evaluations: int
    splitting: Splitting
    error: float | None = None

    def __iter__(self) -> Iterator[np.ndarray]:
        yield self.q
        yield self.omega

    def __call__(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Attitudes and rates at t (s): (..., 4), (..., 3) for a number, (..., M, 4), (..., M, 3)
        for M of them.

        By the method itself, from the last of `times` before each and with a shorter step at the
        end, so that nothing is lost between steps.  Raises InputError outside of `times`.
        """
        given = batches.array("t", t)
        if given.ndim > 1:
            raise InputError("t", f"an array of shape {given.shape}", "must be one-dimensional")
        wanted = np.atleast_1d(given)
        self._refuse_beyond(wanted)
        q, omega = (np.empty((*x.shape[:-2], wanted.size, x.shape[-1])) for x in self)
        for place, state in self._between(wanted):
            q[..., place, :], omega[..., place, :] = state.q, state.omega
        return (q, omega) if given.ndim else (q[..., 0, :], omega[..., 0, :])

    def _between(self, wanted: np.ndarray) -> Iterator[tuple[int, State]]:
        """Places in `wanted` and their states, interval by interval."""
        intervals = np.searchsorted(self.times, wanted, side="right") - 1
        for k in np.unique(intervals):
            places = np.flatnonzero(intervals == k)
            places = places[np.argsort(wanted[places], kind="stable")]
            known = State(self.q[..., k, :], self.omega[..., k, :])
            found = states(self.splitting, known, self.times[k], wanted[places], self.step)
            yield from zip(places, found, strict=True)

    def _refuse_beyond(self, wanted: np.ndarray) -> None:
        for k in np.flatnonzero(~self._reached(wanted))[:1]:
            reach = (
                f"{self.times[0]:.17g} to {self.times[-1]:.17g} s" if self.times.size else "none"
            )
            raise InputError(f"t[{k}]", wanted[k], f"is not among the times reached, {reach}")

    def _reached(self, wanted: np.ndarray) -> np.ndarray:
        if not self.times.size:
            return np.zeros(wanted.shape, bool)
        return (self.times[0] <= wanted) & (wanted <= self.times[-1])


def states(
    splitting: Splitting, state: State, begin: float, times: np.ndarray, step: float
) -> Iterator[State]:
    """States at times that do not fall, from one at `begin`, by equal steps from there.

    Which times are asked for changes no step: each is reached by a shorter one aside.
    """
    done = 0
    for t in times:
        count, rest = _steps(float(t), begin, step)
        state = splitting.advance(state, begin, step, done, count)
        done = count
        yield splitting.advance(state, begin + count * step, rest, 0, 1) if rest else state


def _steps(t: float, begin: float, step: float) -> tuple[int, float]:
    """How many whole steps lie between, and what remains, s."""
    count = int((t - begin) / step + 0.5)
    rest = t - (begin + count * step)
    if abs(rest) <= _NEAR * max(abs(t), abs(begin)):
        return count, 0.0
    return (count, rest) if rest > 0 else (count - 1, rest + step)
