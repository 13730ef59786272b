"""Nonlinearity of a fit: profile-likelihood intervals, and where its covariance is overconfident.

The observations allow a quantity up to where the least chi2 with that value is larger than the
best by the quantile of chi2 of one degree of freedom.  Each end of such an interval is the extreme
of the quantity on that level of chi2.  Steps of Gauss and Newton find it: each goes to the end of
the linearised problem.  All ends of a fit advance in one batch.

Source: Venzon and Moolgavkar, Applied Statistics 37 (1988), 87-94.
"""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2 as chi2_law

from rigidsym.fitting._minimise import blocks
from rigidsym.fitting._observability import Errors, Quantities
from rigidsym.fitting._parameters import Point
from rigidsym.fitting._problem import Problem

LEVEL = 0.95
_MOST_STEPS = 40
# An end has converged if the next step changes it by less, relative to the interval, and chi2 is as
# near to its level.
_NEAR, _ON_LEVEL = 0.02, 0.05
# Relative step that ends a search where bodies end before chi2 reaches the level.
_STALLED = 1e-3
# The longest step, in units of errors, and how far chi2 may exceed its prediction.
_LONGEST, _BEYOND = 8.0, 2.0
# Flagged are ends that differ by a larger factor, and more than a share of directions in which the
# distances by covariance and by chi2 differ by a larger part.
_OFF, _MANY, _APART = 1.25, 0.15, 0.5
_DIRECTIONS = 64
# Least eigenvalue of a correlation matrix, and least part of a direction that is named, relative to
# the largest.
_RANK, _PART = 1e-11, 0.5

Ends = tuple[np.ndarray, ...]


@dataclass(frozen=True, slots=True)
class Nonlinearity:
    """Comparison of a covariance with the likelihood.

    ratios (k, 2): distance of both ends of each 95 % interval from the estimate, over that by the
    standard deviation; NaN where there is none. beyond: share of directions in which the covariance
    excludes motions that the observations allow; off: share in which chi2 differs from its linear
    prediction; both on the edge of the 95 % region. single: quantities whose interval differs from
    that of the standard deviation. joint: quantities in the combination of which the covariance as
    a whole is most overconfident.
    """

    ratios: np.ndarray
    beyond: float
    off: float
    single: tuple[str, ...]
    joint: tuple[str, ...]

    @property
    def flagged(self) -> bool:
        """Return whether covariance and standard deviations must not be used as errors."""
        return bool(self.single) or max(self.beyond, self.off) > _MANY

    @property
    def message(self) -> str:
        """Return one line on what is wrong and what to use instead; empty where nothing is."""
        said = []
        if self.single:
            said.append(f"the standard deviation misleads for {', '.join(self.single)}")
        if self.beyond > _MANY:
            said.append(f"the covariance is overconfident along {' with '.join(self.joint)}")
        elif self.off > _MANY:
            said.append("the covariance is overconfident as a whole")
        return f"{'; '.join(said)}: use the intervals" if said else ""


NONE = Nonlinearity(np.empty((0, 2)), 0.0, 0.0, (), ())
"The nonlinearity of a fit without errors, and of a spin."


@dataclass(frozen=True, slots=True)
class Likelihood:
    """Function chi2 of motions less that of the best.

    offset (M,): subtracted from all residuals first.
    """

    quantities: Quantities
    offset: np.ndarray

    @property
    def problem(self) -> Problem:
        """Return the observations and parameters."""
        return self.quantities.problem

    @property
    def best(self) -> Point:
        """Return the point at which chi2 is least."""
        return self.problem.parameters.inner(self.quantities.best)

    def rise(self, points: Point) -> np.ndarray:
        """Return chi2 of motions (B,) less that of the best; NaN where there are no states."""
        every = [points, self.quantities.best.repeated()]
        *found, least = (
            np.sum((self.problem.residuals(some) - self.offset) ** 2, axis=-1)
            for one in every
            for some in blocks(self.problem, one)
        )
        return np.concatenate(found) - least

    def normal(self, points: Point) -> Ends:
        """Return the normal equations and the quantities at motions (B,).

        These are chi2 (B,), half its first and second derivatives (B, p) and (B, p, p), and the
        quantities (B, k) with their derivatives (B, k, p).
        """
        found = []
        for some in blocks(self.problem, points):
            own = self.problem.parameters.derivatives(some)
            residuals, slopes = self.problem.linearised(some, own)
            residuals = residuals - self.offset
            transposed = np.swapaxes(slopes, 1, 2)
            slope = (transposed @ residuals[..., None])[..., 0]
            chi2 = np.sum(residuals**2, axis=-1)
            found.append((chi2, slope, transposed @ slopes, *self.quantities.near(some, own)))
        return tuple(np.concatenate(x) for x in zip(*found, strict=True))


def profile(likelihood: Likelihood, which: np.ndarray, level: float = LEVEL) -> np.ndarray:
    """Return the ends (n, 2) of the intervals of quantities `which` (n,), less their estimates.

    An end is infinite where no level of chi2 bounds the quantity.
    """
    parameters, best = likelihood.problem.parameters, likelihood.best
    quantity, sign = np.repeat(which, 2), np.tile([-1.0, 1.0], len(which))
    floor = np.diag(1 / parameters.natural_sizes(best, likelihood.problem.span) ** 2)
    state = tuple(np.repeat(x, len(sign), axis=0) for x in likelihood.normal(best.repeated()))
    level = state[0] + chi2_law.ppf(level, 1)
    points = best.repeated(len(sign))
    longest = np.full(len(sign), _LONGEST)
    ends = np.inf * sign
    going = np.arange(len(sign))
    for _ in range(_MOST_STEPS):
        cost, slope, matrix, apart, rows = (x[going] for x in state)
        every = np.arange(len(going)), quantity[going]
        left = level[going] - cost
        step, gain, reach = _step(left, slope, matrix + floor, sign[going, None] * rows[every])
        value, allowed = np.abs(apart[every]), chi2_law.ppf(LEVEL, 1)
        more = np.abs(gain)
        ended = (more < _NEAR * np.maximum(reach, value)) & (np.abs(left) < _ON_LEVEL * allowed)
        ended |= (more < _STALLED * value) & (left > 0)
        ends[going[ended]] = (apart[every] + sign[going] * gain)[ended]
        going, step = going[~ended], step[~ended]
        if not going.size:
            break
        cost, slope, matrix = cost[~ended], slope[~ended], matrix[~ended]
        size = np.sqrt(_product(step, matrix + floor))
        step *= np.minimum(1, longest[going] / size)[:, None]
        tried = parameters.moved(points[going], step)
        new = likelihood.normal(tried)
        rise = 2 * np.sum(slope * step, axis=-1) + _product(step, matrix)
        good = new[0] - cost - rise < _BEYOND + np.abs(rise) / 2
        for x in new[1:]:
            good &= np.isfinite(x.reshape(len(x), -1)).all(axis=1)
        own = np.where(good, 2 * longest[going], np.minimum(longest[going], size) / 4)
        longest[going] = np.minimum(own, _LONGEST)
        for old, x in zip((*state, *points.parts), (*new, *tried.parts), strict=True):
            old[going[good]] = x[good]
    return ends.reshape(-1, 2)


def _step(
    left: np.ndarray, slope: np.ndarray, metric: np.ndarray, ways: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the steps (B, p) to the ends of linearised problems, with gains and half widths.

    Gains (B,) are of quantities that change along `ways` (B, p).  The step is the largest w.d with
    2 s.d + d.A d = left, by one multiplier: d = l A^-1 w - A^-1 s.
    """
    both = np.linalg.solve(metric, np.stack([slope, ways], axis=-1))
    back, along = both[..., 0], both[..., 1]
    width = np.sum(ways * along, axis=-1)
    radius = np.sqrt(np.maximum(left + np.sum(slope * back, axis=-1), 0))
    with np.errstate(divide="ignore", invalid="ignore"):
        step = np.nan_to_num(radius / np.sqrt(width))[:, None] * along - back
    return step, np.sum(ways * step, axis=-1), radius * np.sqrt(width)


def _product(step: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    return np.sum(step * (matrix @ step[..., None])[..., 0], axis=-1)


def nonlinearity(
    likelihood: Likelihood, here: Errors, covariance: np.ndarray, ends: np.ndarray
) -> Nonlinearity:
    """Compare a covariance (k, k) with the likelihood.

    It is compared with the `ends` (k, 2) of intervals, and in directions spread evenly over the
    linear errors `here`.  Each direction is followed to the edge of the region that holds 95 % of
    the truths.  There the Mahalanobis distance of the quantities and chi2 are compared with their
    linear predictions.
    """
    quantities, names = likelihood.quantities, likelihood.quantities.names
    sigma = np.sqrt(np.diag(covariance))
    determined: np.ndarray = ~np.isnan(ends[:, 0])
    ratios = np.full(ends.shape, np.nan)
    ratios[determined] = np.abs(ends[determined]) / (
        np.sqrt(chi2_law.ppf(LEVEL, 1)) * sigma[determined, None]
    )
    right = ((ratios > 1 / _OFF) & (ratios < _OFF)).all(axis=1)
    single = tuple(names[k] for k in np.flatnonzero(determined & ~right))
    count = here.determined.shape[1]
    # Every fit takes the same directions, so that its verdict does not depend on chance.
    z = np.random.default_rng(0).normal(size=(_DIRECTIONS, count))
    square = float(chi2_law.ppf(LEVEL, count))
    z *= np.sqrt(square) / np.linalg.norm(z, axis=1)[:, None]
    parameters, best = likelihood.problem.parameters, quantities.best
    points = parameters.stepped(best.repeated(_DIRECTIONS), z @ here.determined.T)
    linear = z @ (quantities.rows(best, parameters.linear_derivatives(best)) @ here.determined).T
    axes = _axes(covariance, determined)
    said, true = ((x[:, determined] @ axes) ** 2 for x in (linear, quantities.apart(points)))
    excess = np.nan_to_num(true - said, nan=np.inf)
    beyond = float(np.mean(~(np.sum(excess, axis=1) <= _APART * square)))
    off = float(np.mean(~(np.abs(likelihood.rise(points) - square) <= _APART * square)))
    joint: tuple[str, ...] = ()
    if beyond > _MANY:
        worst = axes[:, np.argmax(np.median(excess, axis=0))] * sigma[determined]
        part = np.abs(worst) >= _PART * np.max(np.abs(worst))
        joint = tuple(np.array(names)[determined][part].tolist())
    return Nonlinearity(ratios, beyond, off, single, joint)


def _axes(covariance: np.ndarray, determined: np.ndarray) -> np.ndarray:
    """Return columns (n, r) that make quantities (..., n) independent and of unit variance."""
    own = covariance[np.ix_(determined, determined)]
    sigma = np.sqrt(np.diag(own))
    sizes, vectors = np.linalg.eigh(own / np.outer(sigma, sigma))
    kept = sizes > _RANK * np.max(sizes)
    return vectors[:, kept] / np.sqrt(sizes[kept]) / sigma[:, None]
