"""Trajectories of bodies under a torque, evaluated at any time."""

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _containers as containers
from rigidsym._engines import batches
from rigidsym._frames import dataframe, dataset
from rigidsym.errors import InputError
from rigidsym.splitting._stepping import Splitting, State

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

# Relative distance from the end of a step below which a time is that end, because of rounding.
_NEAR = 4 * float(np.finfo(float).eps)


@dataclass(slots=True, eq=False)
class Mesh:
    """Time mesh of intervals, each of which is divided into equal steps.

    edges (P,): where pieces begin, s, rising; steps (P,), s.  The last piece has no end.  Steps are
    counted from the edge, and the last one of a piece is shorter where they do not fit.
    """

    edges: list[float]
    steps: list[float]

    def interval(self, t: float, state: State) -> tuple[float, float]:
        """Return the end and the step size, in s, of the interval that contains t."""
        k = bisect_right(self.edges, t)
        end = self.edges[k] if k < len(self.edges) else np.inf
        return end, self.steps[max(k, 1) - 1]

    @property
    def halved(self) -> "Mesh":
        """The mesh with all steps halved.

        Intervals with equal steps are joined.
        """
        found = Mesh([], [])
        for edge, step in zip(self.edges, self.steps, strict=True):
            half = step / 2 or step  # the least double has no half
            if not found.steps or abs(found.steps[-1] - half) > _NEAR * step:
                found.edges.append(edge)
                found.steps.append(half)
        return found


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """Trajectory of bodies, with their states at given times and a function for other times.

    `q, omega = trajectory` unpacks the states.

    Attributes
    ----------
    times : (N,)
        Times, s.
    q : (..., N, 4)
        Attitudes.
    omega : (..., N, 3)
        Rates, rad/s.
    mesh : Mesh
        The steps taken.
    evaluations : int
        Calls of the torque in steps, each for all bodies.
    error : float or None
        With `step=None` the estimated error, rad.
    order : float or None
        With `step=None` the observed order of convergence, at most the method's.
    rough : tuple of float
        With `step=None` times, s, around which the torque is not smooth.
    probes : int
        With `step=None` calls of the torque between kicks, in search of jumps and pulses.
    """

    times: np.ndarray
    q: np.ndarray
    omega: np.ndarray
    mesh: Mesh
    evaluations: int
    splitting: Splitting
    error: float | None = None
    order: float | None = None
    rough: tuple[float, ...] = ()
    probes: int = 0

    @property
    def step(self) -> float:
        """The length of the longest step, in s."""
        return max(self.mesh.steps, default=np.nan)

    def __iter__(self) -> Iterator[np.ndarray]:
        yield self.q
        yield self.omega

    def __call__(self, t: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Return the attitudes and rates at any times within the trajectory.

        Parameters
        ----------
        t : number or (M,)
            Times within `times`, s.

        Returns
        -------
        q, omega : arrays
            (..., 4), (..., 3) for a number; (..., M, 4), (..., M, 3) for M of them.  The method
            itself continues from the last of `times` before each, with a shorter step at the end,
            so that no accuracy is lost between steps.

        Raises
        ------
        InputError
            For times outside of `times`.
        """
        containers.refuse_dates("t", t)
        given = batches.times(t)
        wanted = np.atleast_1d(given)
        inside, reach = np.zeros(wanted.shape, bool), "none"
        if self.times.size:
            inside = (self.times[0] <= wanted) & (wanted <= self.times[-1])
            reach = f"{self.times[0]:.17g} to {self.times[-1]:.17g} s"
        for k in np.flatnonzero(~inside)[:1]:
            raise InputError(f"t[{k}]", wanted[k], f"is not among the times reached, {reach}")
        q, omega = (np.empty((*x.shape[:-2], wanted.size, x.shape[-1])) for x in self)
        intervals = np.searchsorted(self.times, wanted, side="right") - 1
        for k in np.unique(intervals):
            places = np.flatnonzero(intervals == k)
            places = places[np.argsort(wanted[places], kind="stable")]
            known = State(self.q[..., k, :], self.omega[..., k, :])
            found = states(self.splitting, known, self.times[k], wanted[places], self.mesh)
            for place, state in zip(places, found, strict=True):
                q[..., place, :], omega[..., place, :] = state.q, state.omega
        return (q, omega) if np.ndim(given) else (q[..., 0, :], omega[..., 0, :])

    def to_dataframe(self, *, degrees: bool = False) -> "DataFrame":
        """Return the states at `times` as a pandas DataFrame.

        Its index is the time, s, for several bodies after their number.  Rates are in rad/s, or in
        deg/s with degrees=True.  Needs pandas.
        """
        return dataframe(self.times, self.q, self.omega, degrees)

    def to_xarray(self, *, degrees: bool = False) -> "Dataset":
        """Return the states at `times` as an xarray Dataset.

        Its variables are q (..., t, component) and omega (..., t, axis).  Rates are in rad/s, or in
        deg/s with degrees=True.  Needs xarray.
        """
        return dataset(self.times, self.q, self.omega, degrees)


def states(
    splitting: Splitting, state: State, begin: float, times: np.ndarray, mesh: Mesh
) -> Iterator[State]:
    """Yield the states at non-decreasing times, starting from `state` at `begin`.

    The times do not influence the steps: each is reached by a shorter step aside.
    """
    end, step, done = begin, 0.0, 0
    for t in times.tolist():
        while t > end:
            if step:
                state = _reach(splitting, state, begin, end, step, done)
                begin, done = end, 0
            end, step = mesh.interval(begin, state)
        if t == begin and not done:
            yield state
            continue
        count, _ = _steps(t, begin, step)
        state = splitting.advance(state, begin, step, done, count)
        done = count
        yield _reach(splitting, state, begin, t, step, done)


def _reach(
    splitting: Splitting, state: State, begin: float, t: float, step: float, done: int
) -> State:
    """Return the state at t after whole steps and a shorter last one."""
    count, rest = _steps(t, begin, step)
    state = splitting.advance(state, begin, step, done, count)
    return splitting.advance(state, begin + count * step, rest, 0, 1) if rest else state


def _steps(t: float, begin: float, step: float) -> tuple[int, float]:
    """Return the number of whole steps from `begin` to t, and the remaining time, in s."""
    count = int((t - begin) / step + 0.5)
    rest = t - (begin + count * step)
    if abs(rest) <= _NEAR * max(abs(t), abs(begin)):
        return count, 0.0
    return (count, rest) if rest > 0 else (count - 1, rest + step)


def run(splitting: Splitting, start: State, times: np.ndarray, mesh: Mesh) -> Trajectory:
    """Integrate over a list of times, and return the trajectory.

    An exception that stops it keeps the states until then as its attribute `trajectory`.
    """
    q, omega = (np.empty((*x.shape[:-1], times.size, x.shape[-1])) for x in (start.q, start.omega))
    reached = 0

    def trajectory() -> Trajectory:
        found = times[:reached], q[..., :reached, :], omega[..., :reached, :]
        steps = Mesh(mesh.edges, mesh.steps)
        return Trajectory(*found, steps, splitting.evaluations, splitting, probes=splitting.probes)

    try:
        for state in states(splitting, start, float(times[0]), times, mesh):
            q[..., reached, :], omega[..., reached, :] = state.q, state.omega
            reached += 1
    except BaseException as stop:
        vars(stop)["trajectory"] = trajectory()
        raise
    return trajectory()
