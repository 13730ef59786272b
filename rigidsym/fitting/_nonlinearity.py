"""Nonlinearity of a fit: profile-likelihood intervals and overconfident covariances.

The observations allow a quantity up to where the least chi2 with that value is larger than the
best by the quantile of chi2 of one degree of freedom.  Each end of such an interval is the extreme
of the quantity on that level of chi2.  Steps of Gauss and Newton find it: each goes to the end of
the linearised problem.  All ends of a fit advance in one batch.

Source: Venzon and Moolgavkar, Applied Statistics 37 (1988), 87-94.
"""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2 as chi2_law

from rigidsym.fitting._minimise import blocks, squared
from rigidsym.fitting._observability import Errors
from rigidsym.fitting._parameters import Point, sensitivities, states
from rigidsym.fitting._problem import Problem
from rigidsym.quaternions import conjugate, inverse_left_jacobian, product, rotation_vectors

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


@dataclass(frozen=True, slots=True)
class Nonlinearity:
    """Departure of a fit's likelihood from the one that its covariance implies.

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
        """Return True if covariance and standard deviations must not be used as errors."""
        return bool(self.single) or max(self.beyond, self.off) > _MANY

    @property
    def message(self) -> str:
        """Return a one-line warning about the covariance.

        It is empty where nothing is wrong.
        """
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


NAMES = (
    *("attitude 1", "attitude 2", "attitude 3", "omega 1", "omega 2", "omega 3"),
    *("moment 1", "moment 2", "moment 3", "axes 1", "axes 2", "axes 3"),
)


@dataclass(frozen=True, slots=True)
class Quantities:
    """The quantities that a fit reports, as functions of nearby motions.

    The chi2 of these motions is computed as well.

    These are a turn at t = 0 along inertial axes, rad; omega0, rad/s; the moments; and, where they
    are estimated, the turn of the axes, rad.  Without a prior the scale of the moments is
    unobservable: their unit is then the largest moment of the best point. offset: subtracted from
    all residuals (M,).
    """

    problem: Problem
    best: Point
    offset: np.ndarray

    @property
    def names(self) -> tuple[str, ...]:
        """Return the k names of the quantities."""
        return NAMES if self.problem.parameters.axes else NAMES[:9]

    def rows(self, point: Point, own: np.ndarray) -> np.ndarray:
        """Return the derivatives (..., k, p) of the quantities with respect to the parameters.

        own (..., 12, p): see `Parameters.derivatives` and `Parameters.linear_derivatives`.  The
        turns are those at the points themselves.
        """
        _, _, since = sensitivities(point, self._zero, self.problem.engine)
        found = own.copy()
        found[..., :6, :] = since[..., 0, :, :] @ own[..., :9, :]
        if self.problem.prior is None:
            largest, unit = self._unit(point)
            share = (point.moments / point.moments[..., [largest]])[..., None]
            alone = own[..., [6 + largest], :]
            found[..., 6:9, :] = unit[..., None] * (own[..., 6:9, :] - share * alone)
        return found[..., : len(self.names), :]

    def apart(self, points: Point) -> np.ndarray:
        """Return the differences (B, k) between the quantities of motions and those of `best`."""
        q, omega = states(points, self._zero, self.problem.engine)
        best_q, best_omega = states(self.best, self._zero, self.problem.engine)
        moments = points.moments
        if self.problem.prior is None:
            moments = self._unit(points)[1] * moments
        parts = [
            rotation_vectors(product(q[:, 0], conjugate(best_q[0]))),
            omega[:, 0] - best_omega[0],
            moments - self.best.moments,
            rotation_vectors(product(points.mount, conjugate(self.best.mount))),
        ]
        return np.hstack(parts)[:, : len(self.names)]

    def rise(self, points: Point) -> np.ndarray:
        """Return the chi2 (B,) of motions less that of the best motion.

        It is NaN where a motion has no states.
        """
        *found, least = (
            np.sum((self.problem.residuals(some) - self.offset) ** 2, axis=-1)
            for one in (points, self.best.repeated())
            for some in blocks(self.problem, one)
        )
        return np.concatenate(found) - least

    def normal(self, points: Point) -> tuple[np.ndarray, ...]:
        """Return the normal equations and the quantities at motions (B,).

        These are chi2 (B,), half its second and first derivatives (B, p, p) and (B, p), and the
        quantities (B, k) as `apart` returns them, with their derivatives (B, k, p).
        """
        found = []
        for some in blocks(self.problem, points):
            own = self.problem.parameters.derivatives(some)
            residuals, slopes = self.problem.linearised(some, own)
            residuals = residuals - self.offset
            apart, rows = self.apart(some), self.rows(some, own)
            for first in (0, 9)[: 1 + self.problem.parameters.axes]:
                turn = slice(first, first + 3)
                rows[:, turn] = inverse_left_jacobian(apart[:, turn]) @ rows[:, turn]
            found.append((np.sum(residuals**2, axis=-1), *squared(residuals, slopes), apart, rows))
        return tuple(np.concatenate(x) for x in zip(*found, strict=True))

    def _unit(self, point: Point) -> tuple[int, np.ndarray]:
        """Return the index of the largest moment, and factors that equate it to the best motion's.

        The factors (..., 1) scale the moments of points.
        """
        largest = int(np.argmax(self.best.moments))
        return largest, self.best.moments[largest] / point.moments[..., [largest]]

    @property
    def _zero(self) -> np.ndarray:
        """Return the time from the epoch to t = 0, in s, as an array (1,)."""
        return np.array([-self.problem.epoch])


def profile(quantities: Quantities, which: np.ndarray, level: float = LEVEL) -> np.ndarray:
    """Return the ends (n, 2) of profile-likelihood intervals, relative to the estimates.

    which (n,): indices of the quantities. level: the chance that an interval holds the truth.

    An end is infinite where no level of chi2 bounds the quantity.
    """
    problem, parameters = quantities.problem, quantities.problem.parameters
    best = parameters.inner(quantities.best)
    quantity, sign = np.repeat(which, 2), np.tile([-1.0, 1.0], len(which))
    floor = np.diag(1 / parameters.natural_sizes(best, problem.span) ** 2)
    state = tuple(np.repeat(x, len(sign), axis=0) for x in quantities.normal(best.repeated()))
    level = state[0] + chi2_law.ppf(level, 1)
    points = best.repeated(len(sign))
    longest = np.full(len(sign), _LONGEST)
    ends = np.inf * sign
    going = np.arange(len(sign))
    for _ in range(_MOST_STEPS):
        cost, matrix, slope, apart, rows = (x[going] for x in state)
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
        new = quantities.normal(tried)
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
    """Return the steps (B, p) to the ends of linearised intervals.

    Gains and half widths of the intervals are returned as well.

    Gains (B,) are those of quantities that change along `ways` (B, p).  The step d has the largest
    w.d with 2 s.d + d.A d = left, by one multiplier: d = l A^-1 w - A^-1 s.
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
    quantities: Quantities, here: Errors, covariance: np.ndarray, ends: np.ndarray
) -> Nonlinearity:
    """Measure how far the likelihood of a fit departs from what its covariance (k, k) implies.

    The covariance is compared with the `ends` (k, 2) of intervals, and in directions spread evenly
    over the linear errors `here`.  Each direction is followed to the edge of the region that holds
    95 % of the truths.  There the Mahalanobis distance of the quantities and chi2 are compared with
    their linear predictions.
    """
    names = quantities.names
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
    parameters, best = quantities.problem.parameters, quantities.best
    points = parameters.stepped(best.repeated(_DIRECTIONS), z @ here.determined.T)
    linear = z @ (quantities.rows(best, parameters.linear_derivatives(best)) @ here.determined).T
    # Combinations of the quantities that are independent and of unit variance.
    scale = sigma[determined]
    sizes, vectors = np.linalg.eigh(
        covariance[np.ix_(determined, determined)] / np.outer(scale, scale)
    )
    kept = sizes > _RANK * np.max(sizes)
    axes = vectors[:, kept] / np.sqrt(sizes[kept]) / scale[:, None]
    said, true = ((x[:, determined] @ axes) ** 2 for x in (linear, quantities.apart(points)))
    excess = np.nan_to_num(true - said, nan=np.inf)
    beyond = float(np.mean(~(np.sum(excess, axis=1) <= _APART * square)))
    off = float(np.mean(~(np.abs(quantities.rise(points) - square) <= _APART * square)))
    joint: tuple[str, ...] = ()
    if beyond > _MANY:
        worst = axes[:, np.argmax(np.median(excess, axis=0))] * scale
        part = np.abs(worst) >= _PART * np.max(np.abs(worst))
        joint = tuple(np.array(names)[determined][part].tolist())
    return Nonlinearity(ratios, beyond, off, single, joint)
