"""What a fit finds: the best motion with its errors, the other motions, and predictions."""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2 as chi2_law

from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting.agreement import Agreement, Search, agreement
from rigidsym.fitting.nonlinearity import (
    LEVEL,
    NONE,
    Likelihood,
    Nonlinearity,
    nonlinearity,
    profile,
)
from rigidsym.fitting.observability import Observability, lose, observability
from rigidsym.fitting.outliers import against_others, outliers
from rigidsym.fitting.parameters import Point, observed
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.quantities import Quantities
from rigidsym.fitting.states import motion, sensitivities, states
from rigidsym.fitting.tumbling import Periods, periods
from rigidsym.fitting.turned import is_bent
from rigidsym.motion import TorqueFreeMotion
from rigidsym.quaternions import matrices

if TYPE_CHECKING:
    from rigidsym.solution.polhode import Mode

# Of errors: over which periods are straight.
_SMALL = 0.1
# Of the largest moment: what is left to the triangle inequality of a flat body.
_THIN = 1e-4


@dataclass(frozen=True, slots=True)
class Prediction:
    """States at times: q (..., 4), omega (..., 3), of the axes that observations speak of.

    covariance (..., 6, 6): of a small turn along inertial axes, rad, and of the rates, rad/s.
    """

    q: np.ndarray
    omega: np.ndarray
    covariance: np.ndarray

    @property
    def attitude_sigma(self) -> np.ndarray:
        """The standard deviation of the turn about the axis that is known least (...), rad."""
        return np.sqrt(np.linalg.eigvalsh(self.covariance[..., :3, :3])[..., -1])


@dataclass(frozen=True, eq=False)
class Alternative:
    """A motion that fits about as well: its chi2, and its state at the problem's epoch."""

    motion: TorqueFreeMotion
    point: Point
    chi2: float

    @property
    def mount(self) -> np.ndarray:
        """(4,): the rotation from the principal axes to those observed."""
        return self.point.mount

    @property
    def mode(self) -> "Mode | None":
        """See `TorqueFreeMotion.mode`."""
        return self.motion.mode

    @cached_property
    def periods(self) -> Periods:
        """Of rotation and precession, s."""
        return periods(self.motion)

    @property
    def moments(self) -> np.ndarray:
        """(3,), kg m^2, or with the largest as unit."""
        return np.array(self.motion.exact["inertia"], float)


@dataclass(frozen=True, repr=False, eq=False)
class Found(Alternative):
    """The best motion, what is known of it, and what else there may be.

    motion: from t = 0 of the times observed, along the principal axes.  moments have the largest as
    unit, unless a prior or `scale` says more: without torque their scale is unobservable.
    alternatives: other minima, by chi2, within `delta_chi2` of the best.  converged, reason:
    whether this is a minimum, and why not.  spinning: whether the observations show no more than a
    spin about an axis of the body, whatever its moments.  search: minima of other readings of the
    observations.
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
        """Whether residuals are errors; other readings of the data that fit where they are not.

        A normal fit costs nothing more; where model and data disagree, each reading is searched.
        """
        return agreement(self.problem, self.point, self.degrees_of_freedom, self.search)

    @cached_property
    def observability(self) -> Observability:
        """What the observations tell, and what they do not."""
        return observability(self.problem, self.point)

    @cached_property
    def _quantities(self) -> Quantities:
        return Quantities(self.problem, self.point)

    @cached_property
    def periods_sigma(self) -> Periods:
        """Linear standard deviations of the periods, s; None where there are no periods, and where
        model and data disagree."""
        if self.agreement.hopeless:
            return Periods(None, None)
        ends = [
            [self._periods(side * _SMALL * one) for side in (1, -1)]
            for one in self.observability.here.told.T
        ]
        return Periods(*(_spread([[x[k] for x in two] for two in ends]) for k in (0, 1)))

    def _periods(self, step: np.ndarray) -> tuple[float | None, float | None]:
        """Of the motion a step of the parameters away."""
        found = periods(motion(self.problem.parameters.stepped(self.point, step)))
        return found.rotation, found.precession

    @property
    def names(self) -> tuple[str, ...]:
        """Of the rows of `covariance`."""
        return self._quantities.names

    @cached_property
    def covariance(self) -> np.ndarray:
        """Of a turn at t = 0 along inertial axes, rad; omega0, rad/s; the moments; and, where they
        are estimated, of the axes, rad: (9, 9) or (12, 12), in the order of `names`.

        The variance of what the observations do not tell is infinite, and its covariances are NaN.
        All is NaN where model and data disagree: see `agreement`.
        """
        linear = self.problem.parameters.linear
        if self.agreement.hopeless:
            return np.full((len(self.names),) * 2, np.nan)
        found = self.observability.covariance(lambda at: self._quantities.rows(at, linear(at)))
        if self.problem.parameters.axes:
            bent = is_bent(np.sqrt(np.diag(found)), self.point.omega)
            lose(found, bent)
        return found

    @property
    def sigma(self) -> np.ndarray:
        """Standard deviations, in the order of `names`."""
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
        """Ends of intervals, less the estimates."""
        wide = np.sqrt(chi2_law.ppf(level, 1)) * self.sigma
        ends = wide[:, None] * np.array([-1.0, 1.0])
        told = np.flatnonzero(self._told)
        if told.size and not self.spinning:
            ends[told] = profile(self._likelihood, told, level)
        return ends

    @property
    def _told(self) -> np.ndarray:
        """Which of the quantities have standard deviations, and are not fixed."""
        return np.isfinite(self.sigma) & (self.sigma > 0)

    @property
    def _likelihood(self) -> Likelihood:
        residuals = self.observability.residuals
        # Elsewhere than at a minimum of chi2 observations are taken as they are computed there.
        least = self.converged and self.loss == "linear"
        return Likelihood(self._quantities, residuals * (not least))

    @cached_property
    def nonlinearity(self) -> Nonlinearity:
        """How far the covariance can be trusted; see `Nonlinearity`."""
        if self.spinning or not self._told.any():
            return NONE
        ends = np.where(self._told[:, None], self._ends(LEVEL), np.nan)
        return nonlinearity(self._likelihood, self.observability.here, self.covariance, ends)

    @property
    def unobservable(self) -> tuple[str, ...]:
        """The names of what the observations do not tell."""
        return tuple(x for x, s in zip(self.names, self.sigma, strict=True) if np.isinf(s))

    @property
    def null_directions(self) -> np.ndarray:
        """Unit directions (k, p) of the problem's parameters that change nothing observed.

        In units of 1 rad, of the size of the rates, and of that of the moments; the names of the
        parameters are `problem.parameters.names`, of the state at `problem.epoch`, s.
        """
        return self.observability.null

    @property
    def degrees_of_freedom(self) -> int:
        """Numbers observed, less the parameters that they tell."""
        return self.problem.count - self.observability.moved.shape[1]

    @property
    def probability(self) -> float:
        """That errors alone make chi2 as large as this."""
        return float(chi2_law.sf(self.chi2, max(self.degrees_of_freedom, 1)))

    @cached_property
    def residuals(self) -> tuple[np.ndarray, ...]:
        """Of each set, (N, k): computed less observed, in units of the errors, independent."""
        return tuple(self.observability.residuals[rows] for rows in self.problem.rows)

    @cached_property
    def against_others(self) -> tuple[np.ndarray, ...]:
        """Of each set, (N,): chi2 by which each observation misses what the others predict of it.

        It has as many degrees of freedom as the observation has numbers; NaN where the others
        predict nothing.
        """
        return tuple(against_others(self.problem, self.observability))

    @cached_property
    def outliers(self) -> tuple[tuple[int, int], ...]:
        """Set and index of each observation that the others do not allow, at 1 % for all."""
        return outliers(self.problem, self.observability)

    def predict(self, t: ArrayLike) -> Prediction:
        """States at t (s), a number or (N,), with covariance, of the axes observed.

        By the sensitivities at the minimum: the error along the momentum grows as the time does.
        What the observations do not tell is taken to be as uncertain as it can be: 1 rad, the size
        of the rates, and that of the moments.  Raises InputError as a motion does.
        """
        times = batches.array("t", t)
        if times.ndim > 1:
            raise InputError("t", f"an array of shape {times.shape}", "must be one-dimensional")
        self.motion(times)
        every = np.atleast_1d(times)
        since = every - self.problem.epoch
        seen = self.point.seen(*states(self.point, since, self.problem.engine))
        covariance = self.observability.widest(lambda point: self._rows(point, since))
        found = *seen, covariance * (np.nan if self.agreement.hopeless else 1.0)
        return Prediction(*(x[0] if times.ndim == 0 else x for x in found))

    def _rows(self, point: Point, since: np.ndarray) -> np.ndarray:
        """How states of the axes observed go with the parameters at a point: (N, 6, p)."""
        q, omega, sensitivity = sensitivities(point, since, self.problem.engine)
        own = self.problem.parameters.linear(point)
        return observed(point, *point.seen(q, omega), sensitivity, own)

    @property
    def axes(self) -> np.ndarray:
        """(3, 3): its columns are the principal axes along those observed; see `principal_axes`."""
        return matrices(self.mount)

    @property
    def tensor(self) -> np.ndarray:
        """The inertia tensor (3, 3) about the axes observed."""
        return self.axes @ np.diag(self.moments) @ self.axes.T

    @property
    def thin(self) -> bool:
        """Whether the body is the flattest there can be: the observations ask for a flatter one,
        and the errors of its moments are those along that edge."""
        largest = np.max(self.moments)
        return bool(np.sum(self.moments) - 2 * largest < _THIN * largest)


def _spread(ends: list[list[float | None]]) -> float | None:
    """What independent errors make of a quantity, by its values a small part of each away."""
    told = [(one, other) for one, other in ends if one is not None and other is not None]
    if len(told) < len(ends) or not told:
        return None
    return float(np.linalg.norm([one - other for one, other in told]) / (2 * _SMALL))
