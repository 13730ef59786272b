"""Search for all motions to the target, by sampling arcs of momentum directions.

A motion from a direction on an arc brings the momentum to its place at the target after a known
time, and again after each period of its polhode.  The attitude then differs from the target by a
turn about the momentum, by one angle (facts arrival.gap, arrival.angle).  The motion arrives where
half of that angle is a multiple of pi: these are the zeros of functions of one variable.
"""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from functools import reduce
from operator import add

import numpy as np

from rigidsym.manoeuvre._directions import Arcs, arcs
from rigidsym.manoeuvre._problem import Problem
from rigidsym.manoeuvre._transit import transits

# Coordinates of the first samples of an arc; they leave out 1e-14 of it at either end.
_GRID = np.arange(-32.0, 32.1, 0.75)
# Steps are halved until half angles, and rates as angles in time 1, change by no more (rad).
_HALF_STEP, _RATE_STEP = 0.8, 1.2
_ROUNDS = 24
_LEAST_STEP = 1e-7
# Over such a step a time changes by half a period only if it jumps by a whole one, at the axis of
# the turn or within rounding of it.
_JUMP_STEP = 0.05
# A smaller sine that does not change its sign may have a double zero beside it.
_TANGENT = 0.02
_CLOSER = 3
# Times may dip between samples.
_MARGIN = 1.02
_FAR = 4.0
# Most motions and starts: more would take longer than a second.
_MOST, _MOST_STARTS = 150_000, 10_000


class TooManyError(ArithmeticError):
    """Error for a search among too many motions."""


@dataclass(frozen=True, slots=True)
class Samples:
    """Sampled motions whose initial momentum directions lie on arcs, with arrival data.

    All fields are arrays with N rows.

    turns: whole turns of the momentum round its polhode, which take `period` each.  time: momentum
    times duration.  half: half of the angle about the momentum that is left, rad.
    """

    arc: np.ndarray
    x: np.ndarray
    turns: np.ndarray
    period: np.ndarray
    time: np.ndarray
    rates: np.ndarray
    half: np.ndarray

    def __getitem__(self, rows: np.ndarray) -> "Samples":
        return Samples(*(getattr(self, field.name)[rows] for field in fields(self)))

    def __add__(self, other: "Samples") -> "Samples":
        pairs = ((getattr(self, f.name), getattr(other, f.name)) for f in fields(self))
        return Samples(*map(np.concatenate, pairs))


def starts(problem: Problem, bound: float) -> np.ndarray:
    """Estimate the initial rates (N, 3) of all motions to the target with momentum <= bound.

    Raises TooManyError where there are too many motions of that momentum.
    """
    curves = arcs(problem)
    if not len(curves.ends):
        return np.empty((0, 3))
    search = Search(problem, curves, bound)
    begin, end = (reduce(add, side) for side in zip(*search.steps(), strict=True))
    found = search.zeros(begin, end)
    _check(len(found), _MOST_STARTS)
    return found[np.isfinite(found).all(axis=1)]


def _check(count: float, most: int) -> None:
    """Raise TooManyError if a count exceeds its limit."""
    if not count <= most:
        raise TooManyError


@dataclass(frozen=True, slots=True)
class Search:
    """A search along arcs of momentum directions for all motions to the target."""

    problem: Problem
    curves: Arcs
    bound: float

    def steps(self) -> Iterator[tuple[Samples, Samples]]:
        """Halve steps along arcs until they are fine, and yield the samples at both ends."""
        samples, left, right = self._first()
        for _ in range(_ROUNDS):
            begin, end = samples[left], samples[right]
            coarse = self._coarse(begin, end)
            yield begin[~coarse], end[~coarse]
            if not coarse.any():
                break
            left, right, begin, end = left[coarse], right[coarse], begin[coarse], end[coarse]
            middle = self.sample(begin.arc, (begin.x + end.x) / 2, begin.turns)
            new = len(samples.x) + np.arange(len(middle.x))
            _check(len(samples.x) + len(new), _MOST)
            samples = samples + middle
            left, right = np.concatenate([left, new]), np.concatenate([new, right])

    def _first(self) -> tuple[Samples, np.ndarray, np.ndarray]:
        """Return the samples of the initial grid, and the indices of each step's two samples."""
        count, grid = len(self.curves.ends), len(_GRID)
        arc, x = np.repeat(np.arange(count), grid), np.tile(_GRID, count)
        momenta = self.curves.at(arc, x)
        times, periods = transits(self.problem, momenta)
        least = np.fmin(times[:-1], times[1:])
        shortest = np.fmin(periods[:-1], periods[1:])
        whole = np.floor((self.bound * _MARGIN - least) / shortest) + 1
        whole[(arc[:-1] != arc[1:]) | np.isnan(times[:-1] + times[1:]) | ~(whole > 0)] = 0
        _check(whole.sum(), _MOST)
        step = np.repeat(np.arange(len(whole)), whole.astype(int))
        turns = np.arange(len(step)) - np.searchsorted(step, step)
        # Neighbouring steps share a sample.
        nodes, place = np.unique(
            np.concatenate([step, step + 1]) + len(x) * np.tile(turns, 2), return_inverse=True
        )
        at, turns = nodes % len(x), nodes // len(x)
        samples = self._arriving(arc[at], x[at], turns, momenta[at], times[at], periods[at])
        return samples, place[: len(step)], place[len(step) :]

    def sample(self, arc: np.ndarray, x: np.ndarray, turns: np.ndarray) -> Samples:
        """Return the samples at given points of the arcs.

        Arrivals long after `bound` have no half angle.
        """
        momenta = self.curves.at(arc, x)
        return self._arriving(arc, x, turns, momenta, *transits(self.problem, momenta))

    def _arriving(
        self,
        arc: np.ndarray,
        x: np.ndarray,
        turns: np.ndarray,
        momenta: np.ndarray,
        first: np.ndarray,
        period: np.ndarray,
    ) -> Samples:
        """Return the samples for unit momenta (N, 3) with known transit times."""
        # Zero turns take no time, also on the separatrix, where one takes for ever.
        time = first + np.multiply(turns, period, out=np.zeros(len(first)), where=turns > 0)
        near = time <= _FAR * self.bound
        rates = np.where(near, time, np.nan)[:, None] * momenta / self.problem.inertia
        arrived = self.problem.arrivals(np.nan_to_num(rates))
        half = np.arctan2(np.sum(arrived[:, 1:] * momenta, axis=1), arrived[:, 0])
        return Samples(arc, x, turns, period, time, rates, np.where(near, half, np.nan))

    def _coarse(self, begin: Samples, end: Samples) -> np.ndarray:
        """Return for each step whether it has to be halved."""
        apart = np.linalg.norm(end.rates - begin.rates, axis=1)
        fine = (np.abs(_turned(begin, end)) <= _HALF_STEP) & (apart <= _RATE_STEP)
        matters = np.minimum(begin.time, end.time) <= self.bound * _MARGIN
        step = end.x - begin.x
        jumps = np.abs(end.time - begin.time) > np.minimum(begin.period, end.period) / 2
        return ~fine & matters & np.where(jumps, step > _JUMP_STEP, step > _LEAST_STEP)

    def zeros(self, begin: Samples, end: Samples) -> np.ndarray:
        """Return the initial rates of motions that miss the target by whole turns only.

        Those at which it comes close to one are returned as well.
        """
        step = _turned(begin, end)
        low, high = np.minimum(0, step), np.maximum(0, step)
        whole = np.ceil((begin.half + low) / np.pi) * np.pi - begin.half
        crossed = (whole <= high) & (step != 0)
        at = self._crossings(begin[crossed], end[crossed], whole[crossed] / step[crossed])
        first, last = np.abs(np.sin(begin.half)), np.abs(np.sin(end.half))
        close = ~crossed & (np.minimum(first, last) < _TANGENT)
        nearer = np.where((first < last)[:, None], begin.rates, end.rates)
        return np.concatenate([at, nearer[close]])

    def _crossings(self, begin: Samples, end: Samples, wanted: np.ndarray) -> np.ndarray:
        """Find the initial rates (N, 3) between samples at which half angles take given values.

        wanted: the fractions of the change of the half angle from sample to sample.

        The zero is found by regula falsi, in its Illinois variant.
        """
        step, rates = _turned(begin, end), begin.rates
        x, far = begin.x, end.x
        off, far_off = -wanted, 1 - wanted
        for _ in range(_CLOSER):
            tried = x + (far - x) * off / np.where(off == far_off, 1.0, off - far_off)
            found = self.sample(begin.arc, tried, begin.turns)
            now = _turned(begin, found) / step - wanted
            passed = now * off < 0
            far, far_off = np.where(passed, x, far), np.where(passed, off, far_off / 2)
            x, off, rates = tried, now, found.rates
        return rates


def _turned(begin: Samples, end: Samples) -> np.ndarray:
    """Return the changes of the half angles between samples, reduced to [-pi, pi)."""
    return np.mod(end.half - begin.half + np.pi, 2 * np.pi) - np.pi
