"""Nonlinearity of a fit: intervals by profile likelihood, and where the covariance is overconfident.

The observations allow a quantity g up to where chi2, at its least for that g, is larger than at the
best by the quantile of chi2 of one degree of freedom (profile likelihood; Venzon and Moolgavkar,
Applied Statistics 37 (1988), 87-94).  Each end is the largest or smallest g on that level, and is
found by steps of Gauss and Newton: along the level of the linearised problem to its own end.  All
ends go on together, in one batch.
"""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2 as chi2_law

from rigidsym.fitting.batch import blocks
from rigidsym.fitting.parameters import Point, joined
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.quantities import Quantities

LEVEL = 0.95
_MOST_STEPS = 25
# Of an end: what the next step may still change; of chi2: how near the level it has to be.
_NEAR, _ON_LEVEL = 0.02, 0.05
# Of the length of a step in units of errors: at first that of the level, later this at most.
_LONGEST = 8.0
# Of chi2 beyond what is predicted of a step, from which on it is cut.
_BEYOND = 2.0


@dataclass(frozen=True)
class Likelihood:
    """chi2 of motions above that of the best, once `missed` (M,) is taken off the residuals."""

    problem: Problem
    best: Point
    missed: np.ndarray

    def at(self, points: Point) -> np.ndarray:
        """Of motions (B,); NaN where there are no states."""
        found = [np.sum((self.problem.residuals(x) - self.missed) ** 2, axis=-1)
                 for x in blocks(self.problem, points)]
        return np.concatenate(found) - self._least

    def normal(self, points: Point, own: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The same, half its gradient (B, p), and half its second derivatives (B, p, p)."""
        found, first = [], 0
        for some in blocks(self.problem, points):
            residuals, slopes = self.problem.linearised(some, own[first : first + some.count])
            first += some.count
            residuals = residuals - self.missed
            transposed = np.swapaxes(slopes, 1, 2)
            found.append((np.sum(residuals**2, axis=-1) - self._least,
                          (transposed @ residuals[..., None])[..., 0], transposed @ slopes))
        return tuple(np.concatenate(x) for x in zip(*found, strict=True))

    @property
    def _least(self) -> float:
        return float(np.sum((self.problem.residuals(self.best) - self.missed) ** 2))


def profile(likelihood: Likelihood, quantities: Quantities, which, level):
    problem, best = likelihood.problem, likelihood.best
    rise = float(chi2_law.ppf(level, 1))
    parameters = problem.parameters
    place = np.repeat(which, 2)
    sign = np.tile([-1.0, 1.0], len(which))
    every = np.arange(len(place))
    best = parameters.inner(best)
    floor = np.diag(1 / parameters.natural(best, problem.span) ** 2)
    one = best.repeated()
    own = parameters.own(one)
    state = [np.repeat(x, len(place), axis=0) for x in (*likelihood.normal(one, own), *quantities.near(one, own))]
    points = best.repeated(len(place))
    limit = np.full(len(place), np.sqrt(rise))
    ends = np.full(len(place), np.nan)
    going = every
    count = 0
    for _ in range(_MOST_STEPS):
        cost, slope, matrix, apart, rows = (x[going] for x in state)
        ways = sign[going, None] * rows[np.arange(len(going)), place[going]]
        metric = matrix + floor
        both = np.linalg.solve(metric, np.stack([slope, ways], axis=-1))
        back, along = both[..., 0], both[..., 1]
        left = rise - cost + np.sum(slope * back, axis=-1)
        length = np.sqrt(np.maximum(left, 0) / np.sum(ways * along, axis=-1))
        step = length[:, None] * along - back
        size = np.sqrt(np.sum(step * (metric @ step[..., None])[..., 0], axis=-1))
        gain = np.abs(np.sum(ways * step, axis=-1))
        reach = np.sqrt(rise * np.sum(ways * along, axis=-1))
        scale = np.maximum(reach, np.abs(apart[np.arange(len(going)), place[going]]))
        still = (gain < _NEAR * scale) & (np.abs(cost - rise) < _ON_LEVEL * rise)
        ends[going[still]] = apart[still, place[going[still]]]
        keep = ~still
        going, step, size, cost, slope, matrix = (x[keep] for x in (going, step, size, cost, slope, matrix))
        if not len(going): break
        count += len(going)
        step *= np.minimum(1, limit[going] / size)[:, None]
        tried = parameters.moved(points[going], step)
        own = parameters.own(tried)
        new = (*likelihood.normal(tried, own), *quantities.near(tried, own))
        expected = cost + 2 * np.sum(slope * step, axis=-1) + np.sum(step * (matrix @ step[..., None])[..., 0], axis=-1)
        good = new[0] <= expected + _BEYOND + 0.5 * np.abs(expected)
        for x in new[1:]:
            good &= np.isfinite(x).reshape(len(x), -1).all(axis=1)
        limit[going] = np.where(good, np.minimum(2 * limit[going], _LONGEST), limit[going] / 4)
        row = going[good]
        for old, x in zip(state, new): old[row] = x[good]
        for name in ("attitude", "omega", "moments", "mount"):
            getattr(points, name)[row] = getattr(tried, name)[good]
    ends[going] = np.inf * sign[going]
    profile.count = count
    return ends.reshape(-1, 2)
