"""Search for all minima of chi2, from many starts.

Starts are refined in batch, and the best of them by SciPy.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from rigidsym.fitting import _minimise as minimise
from rigidsym.fitting._minimise import Minimum
from rigidsym.fitting._observations import middle
from rigidsym.fitting._parameters import Point, joined, states
from rigidsym.fitting._problem import Problem
from rigidsym.fitting._starts import aligned, fastest_rate, starts

Progress = Callable[[int, int], None]

# Observations of each kind in the first arc, and the factor by which an arc is extended.
_ENOUGH, _MORE = 48, 4
# Rounds of refinement: steps, and how many motions are kept after them.
_ROUNDS = ((3, 250), (6, 60), (20, 30))
# The most motions that SciPy refines in the end.
_POLISHED = 24
# One in so many starts is refined, but no fewer than _FEW.
_PART, _FEW = 4, 250
# Margin of chi2 above the best for motions that SciPy refines, relative to the range wanted.
_MARGIN = 2.0
# Motions are equal if their rates differ by less, relative to the largest.
_SAME = 1e-3


def search(
    problem: Problem,
    known: np.ndarray | None,
    count: int,
    fastest: float | None,
    within: float,
    loss: str,
    progress: Progress = lambda done, total: None,
) -> list[Minimum]:
    """Search for the distinct minima of chi2, and return them in the order of cost.

    There is at least one.

    count: of starts. fastest: the largest rate, rad/s; derived from the observations where None.
    within: the largest cost above the best.
    """
    robust = loss != "linear"
    stages = list(_stages(problem, count, fastest))
    first = stages[0]
    limit = fastest_rate(first.sets) if fastest is None else fastest
    points = aligned(first, starts(first, known, count, limit))
    order = np.argsort(minimise.chi2(first, points, robust=True), kind="stable")
    points = points[order[: max(_FEW, points.count // _PART)]]
    total = len(_ROUNDS) + len(stages) + 1
    cost = np.full(points.count, np.inf)
    for k, (rounds, kept) in enumerate(_ROUNDS, 1):
        points, cost = minimise.refine(first, points, rounds, robust)
        points, cost = _best(first, points, cost, kept)
        progress(k, total)
    for k, (before, stage) in enumerate(pairwise(stages), len(_ROUNDS) + 1):
        since = np.array([stage.epoch - before.epoch])
        q, omega = states(points, since, problem.engine)
        points = replace(points, attitude=q[:, 0], omega=omega[:, 0])
        points, cost = minimise.refine(stage, points, _ROUNDS[-1][0], robust)
        points, cost = _best(stage, points, cost, _ROUNDS[-1][1])
        progress(k, total)
    polished = points[cost <= np.min(cost) + _MARGIN * (1 + within)][:_POLISHED]
    found = [minimise.minimise(problem, polished[k], loss) for k in range(polished.count)]
    progress(total, total)
    return distinct(problem, found, within)


def distinct(problem: Problem, found: list[Minimum], within: float) -> list[Minimum]:
    """Select the distinct minima within a range of the best, in the order of cost."""
    order = sorted(found, key=lambda one: (not one.converged, one.cost))
    best, *others = order
    near = [x for x in others if x.converged and x.cost <= best.cost + within]
    listed = [best, *near]
    points = joined(x.point.repeated() for x in listed)
    return [listed[k] for k in _different(problem, points)]


def _best(
    problem: Problem, points: Point, cost: np.ndarray, count: int
) -> tuple[Point, np.ndarray]:
    """Select the `count` best distinct motions and return them with their costs."""
    order = np.argsort(cost, kind="stable")
    order = order[np.isfinite(cost[order])]
    if not order.size:
        return points[:1], cost[:1]
    points, cost = points[order], cost[order]
    kept: list[int] = []
    # In blocks, because most of a grid's starts have gone elsewhere.
    for begin in range(0, points.count, 4 * count):
        some = np.concatenate([kept, np.arange(begin, min(begin + 4 * count, points.count))])
        index = some.astype(int)
        kept = [int(index[k]) for k in _different(problem, points[index])][:count]
        if len(kept) == count:
            break
    return points[np.array(kept)], cost[kept]


def _different(problem: Problem, points: Point) -> list[int]:
    """Return the indices of motions whose rates differ from those of all earlier motions."""
    _, omega = points.in_observed_axes(*states(points, problem.since, problem.engine))
    rates = omega.reshape(points.count, -1)
    kept: list[int] = []
    for k, one in enumerate(rates):
        apart = np.max(np.abs(rates[kept] - one), axis=-1, initial=0.0)
        if np.all(apart > _SAME * np.max(np.abs(one), initial=0.0)):
            kept.append(k)
    return kept


def _stages(problem: Problem, count: int, fastest: float | None) -> Iterator[Problem]:
    """Yield fit problems of growing arcs of time, from a short arc to all observations.

    In the first arc, starts resolve the periods.
    """
    limit = fastest_rate(problem.sets) if fastest is None else fastest
    length = np.sqrt(count / 6) * np.pi / max(limit, 1e-300)
    first = problem.times[0]
    begin = max(problem.times, key=lambda t: _within(problem, t, length).sum())
    while True:
        chosen = _within(problem, begin, length)
        yield _some(problem, begin, length, _ENOUGH)
        if chosen.all():
            break
        length, begin = _MORE * length, max(first, begin - length)
    yield problem


def _within(problem: Problem, begin: float, length: float) -> np.ndarray:
    return (problem.times >= begin) & (problem.times <= begin + length)


def _some(problem: Problem, begin: float, length: float, most: int) -> Problem:
    """Restrict a problem to an arc of time and at most `most` observations of each set."""
    sets = []
    for one in problem.sets:
        index = np.flatnonzero((one.t >= begin) & (one.t <= begin + length))
        if index.size:
            index = index[np.unique(np.linspace(0, index.size - 1, most).round().astype(int))]
            sets.append(one.some(index))
    return replace(problem, sets=tuple(sets), epoch=middle(sets))
