"""Result of a fit: the best motion with its errors, the alternatives, periods, and predictions."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2 as chi2_law

from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting._agreement import Agreement, Search, against_others, agreement, outliers
from rigidsym.fitting._nonlinearity import (
    LEVEL,
    NONE,
    Nonlinearity,
    Quantities,
    nonlinearity,
    profile,
)
from rigidsym.fitting._observability import Observability, is_bent, lose, observability
from rigidsym.fitting._parameters import Point, motion, observed_derivatives, sensitivities, states
from rigidsym.fitting._problem import Problem
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import matrices
from rigidsym.solution._polhode import Mode


@dataclass(frozen=True, slots=True)
class Periods:
    """Periods of a tumbling body as astronomers define them, s; None where there is none.

    Attributes
    ----------
    rotation : float or None
        Period of the rates, in which a long-axis mode turns once about the long axis, and in which
        the long axis of a short-axis mode rolls to and fro.
    precession : float or None
        Mean period in which the circulation axis goes round the momentum.
    """

    rotation: float | None
    precession: float | None


def periods(motion: TorqueFreeMotion) -> Periods:
    """Return the periods of rotation and precession of a motion.

    Constant rates have one period, that of the turn, which is returned as the precession.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion.

    Returns
    -------
    Periods
        Rotation and precession, s.
    """
    rotation, mean = motion.period, motion.precession_rate
    if mean is None or mean == 0:
        return Periods(None, None)
    if rotation is None or not math.isfinite(rotation) or motion.mode is None:
        return Periods(None, 2 * math.pi / abs(mean))
    # The body turns about its momentum by psi and about its circulation axis by phi: in one period
    # of the rates they differ by a whole turn, in opposite senses for the two modes.
    turn = 2 * math.pi / rotation
    rate = mean - turn if motion.mode is Mode.LONG_AXIS else mean + turn
    return Periods(rotation, 2 * math.pi / abs(rate) if rate else math.inf)


# Step of the derivatives of periods, in errors.
_SMALL = 0.1
# Excess in the triangle inequality, relative to the largest moment, below which a body is flat.
_THIN = 1e-4


@dataclass(frozen=True, slots=True)
class Prediction:
    """Predicted states of the observed axes, with their covariance.

    Attributes
    ----------
    q : (..., 4)
        Attitudes.
    omega : (..., 3)
        Rates, rad/s.
    covariance : (..., 6, 6)
        Covariance of a small turn along inertial axes, rad, and of the rates, rad/s.
    """

    q: np.ndarray
    omega: np.ndarray
    covariance: np.ndarray

    @property
    def attitude_sigma(self) -> np.ndarray:
        """Return the standard deviation (...) of the turn about its most uncertain axis, rad."""
        return np.sqrt(np.linalg.eigvalsh(self.covariance[..., :3, :3])[..., -1])


@dataclass(frozen=True, eq=False)
class Alternative:
    """A motion that fits the observations, with chi2 and its state at the problem's epoch."""

    motion: TorqueFreeMotion
    point: Point
    chi2: float

    @property
    def mount(self) -> np.ndarray:
        """Return the rotation (4,) from the principal axes to the observed axes."""
        return self.point.mount

    @property
    def mode(self) -> Mode | None:
        """Return the mode; see `TorqueFreeMotion.mode`."""
        return self.motion.mode

    @cached_property
    def periods(self) -> Periods:
        """Return the periods of rotation and precession, s."""
        return periods(self.motion)

    @property
    def moments(self) -> np.ndarray:
        """Return the moments (3,), kg m^2, or with the largest as unit."""
        return np.array(self.motion.exact["inertia"], float)


@dataclass(frozen=True, repr=False, eq=False)
class Estimate(Alternative):
    """The best motion, its errors, and the alternatives.

    motion: from t = 0 of the times observed, along the principal axes. moments have the largest as
    unit, unless a prior or `scale` determines it: without torque their scale is unobservable.
    alternatives: other minima, by chi2, within `delta_chi2` of the best. converged, reason: whether
    this is a minimum, and why not. spinning: whether the observations show no more than a spin
    about an axis of the body, whatever its moments. search: finds minima of other conventions of
    the observations.
    """

    problem: Problem
    loss: str
    delta_chi2: float
    scaled: bool
    converged: bool
    reason: str
    spinning: bool
    alternatives: tuple[Alternative, ...]
    search: Search

    @cached_property
    def agreement(self) -> Agreement:
        """Return the verdict on the residuals, with conventions of the data that fit better.

        A normal fit costs nothing more; where model and data disagree, each convention is searched.
        """
        return agreement(self.problem, self.point, self.degrees_of_freedom, self.search)

    @cached_property
    def observability(self) -> Observability:
        """Return the linear errors, and what is unobservable."""
        return observability(self.problem, self.point)

    @cached_property
    def _quantities(self) -> Quantities:
        # Away from a minimum of chi2 the observations are replaced by their computed values.
        least = self.converged and self.loss == "linear"
        return Quantities(self.problem, self.point, self.observability.residuals * (not least))

    @cached_property
    def periods_sigma(self) -> Periods:
        """Return linear standard deviations of the periods, s.

        None where there are no periods, and where model and data disagree.
        """
        if self.agreement.hopeless:
            return Periods(None, None)
        stepped = self.problem.parameters.stepped
        ends = [
            [periods(motion(stepped(self.point, side * _SMALL * one))) for side in (1, -1)]
            for one in self.observability.here.determined.T
        ]
        return Periods(
            _spread([[x.rotation for x in two] for two in ends]),
            _spread([[x.precession for x in two] for two in ends]),
        )

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the rows of `covariance`."""
        return self._quantities.names

    @cached_property
    def covariance(self) -> np.ndarray:
        """Return the covariance (9, 9) or (12, 12) of the quantities in `names`.

        These are a turn at t = 0 along inertial axes, rad; omega0, rad/s; the moments; and, where
        they are estimated, the axes, rad.  The variance of an unobservable quantity is infinite,
        and its covariances are NaN.  All is NaN where model and data disagree: see `agreement`.
        """
        linear = self.problem.parameters.linear_derivatives
        if self.agreement.hopeless:
            return np.full((len(self.names),) * 2, np.nan)
        found = self.observability.covariance(lambda at: self._quantities.rows(at, linear(at)))
        if self.problem.parameters.axes:
            lose(found, is_bent(np.sqrt(np.diag(found)), self.point.omega))
        return found

    @property
    def sigma(self) -> np.ndarray:
        """Return standard deviations, in the order of `names`."""
        return np.sqrt(np.diag(self.covariance))

    def intervals(self, level: float = LEVEL) -> np.ndarray:
        """Return profile-likelihood intervals (k, 2) of the quantities in `names`.

        Parameters
        ----------
        level : float
            The chance that an interval holds the true value, between 0 and 1.

        Returns
        -------
        array, (k, 2)
            Lower and upper ends: turns from the estimate, rad, rates and moments themselves.
            Infinite where the observations do not bound a quantity; NaN where model and data
            disagree.  Linear for a spin.

        Raises
        ------
        InputError
            For a level that is not between 0 and 1.
        """
        if not 0 < level < 1:
            raise InputError("level", level, "must be between 0 and 1, as 0.95 is")
        values = np.zeros(len(self.names))
        values[3:9] = *map(float, self.motion.exact["omega0"]), *self.moments
        return values[:, None] + self._ends(level)

    def _ends(self, level: float) -> np.ndarray:
        """Return the ends of intervals (k, 2), less the estimates."""
        wide = np.sqrt(chi2_law.ppf(level, 1)) * self.sigma
        ends = wide[:, None] * np.array([-1.0, 1.0])
        determined = np.flatnonzero(self._determined)
        if determined.size and not self.spinning:
            ends[determined] = profile(self._quantities, determined, level)
        return ends

    @property
    def _determined(self) -> np.ndarray:
        """Return which of the quantities have standard deviations and are not fixed."""
        return np.isfinite(self.sigma) & (self.sigma > 0)

    @cached_property
    def nonlinearity(self) -> Nonlinearity:
        """Return how far the covariance can be trusted; see `Nonlinearity`."""
        if self.spinning or not self._determined.any():
            return NONE
        ends = np.where(self._determined[:, None], self._ends(LEVEL), np.nan)
        return nonlinearity(self._quantities, self.observability.here, self.covariance, ends)

    @property
    def unobservable(self) -> tuple[str, ...]:
        """Return the names of unobservable quantities."""
        return tuple(x for x, s in zip(self.names, self.sigma, strict=True) if np.isinf(s))

    @property
    def null_directions(self) -> np.ndarray:
        """Return unit directions (k, p) of the problem's parameters that change nothing observed.

        They are in units of 1 rad, of the size of the rates, and of that of the moments; the names
        of the parameters are `problem.parameters.names`, of the state at `problem.epoch`, s.
        """
        return self.observability.null

    @property
    def degrees_of_freedom(self) -> int:
        """Return the number of residuals less that of the parameters they determine."""
        return self.problem.count - self.observability.basis.shape[1]

    @property
    def probability(self) -> float:
        """Return the probability that errors alone make chi2 as large as this."""
        return float(chi2_law.sf(self.chi2, max(self.degrees_of_freedom, 1)))

    @cached_property
    def residuals(self) -> tuple[np.ndarray, ...]:
        """Return residuals (N, k) of each set: computed less observed, whitened by the errors."""
        return tuple(self.observability.residuals[rows] for rows in self.problem.rows)

    @cached_property
    def against_others(self) -> tuple[np.ndarray, ...]:
        """Return for each set the chi2 (N,) of observations against predictions from the rest.

        It has as many degrees of freedom as the observation has numbers; NaN where the others
        predict nothing.
        """
        found = self.observability
        return tuple(against_others(self.problem.rows, found.residuals, found.basis))

    @cached_property
    def outliers(self) -> tuple[tuple[int, int], ...]:
        """Return the set and the index of each outlier, at 1 % significance for all together."""
        return outliers(self.problem, self.observability)

    def predict(self, t: ArrayLike) -> Prediction:
        """Return states of the observed axes at times, with their covariance.

        The covariance follows from the sensitivities at the minimum: the error along the momentum
        grows linearly in time.  Unobservable directions have their natural size as error: 1 rad,
        the size of the rates, and that of the moments.

        Parameters
        ----------
        t : number or (N,)
            Times, s.

        Returns
        -------
        Prediction
            q (..., 4), omega (..., 3), covariance (..., 6, 6).

        Raises
        ------
        InputError
            As a motion does, for times that it does not reach.
        """
        times = batches.array("t", t)
        if times.ndim > 1:
            raise InputError("t", f"an array of shape {times.shape}", "must be one-dimensional")
        self.motion(times)
        every = np.atleast_1d(times)
        since = every - self.problem.epoch
        seen = self.point.in_observed_axes(*states(self.point, since, self.problem.engine))

        def rows(point: Point) -> np.ndarray:
            q, omega, sensitivity = sensitivities(point, since, self.problem.engine)
            own = self.problem.parameters.linear_derivatives(point)
            return observed_derivatives(point, *point.in_observed_axes(q, omega), sensitivity, own)

        covariance = self.observability.widest(rows)
        found = *seen, covariance * (np.nan if self.agreement.hopeless else 1.0)
        return Prediction(*(x[0] if times.ndim == 0 else x for x in found))

    @property
    def axes(self) -> np.ndarray:
        """Return the principal axes as columns (3, 3), as `principal_axes` does."""
        return matrices(self.mount)

    @property
    def tensor(self) -> np.ndarray:
        """Return the inertia tensor (3, 3) about the observed axes."""
        return self.axes @ np.diag(self.moments) @ self.axes.T

    @property
    def thin(self) -> bool:
        """Return whether the body is the flattest that can exist.

        The observations then prefer a flatter one, and errors of the moments are those along that
        edge.
        """
        largest = np.max(self.moments)
        return bool(np.sum(self.moments) - 2 * largest < _THIN * largest)


def _spread(ends: list[list[float | None]]) -> float | None:
    """Return a standard deviation from values of a quantity on both sides of each error."""
    both = [(one, other) for one, other in ends if one is not None and other is not None]
    if len(both) < len(ends) or not both:
        return None
    return float(np.linalg.norm([one - other for one, other in both]) / (2 * _SMALL))
