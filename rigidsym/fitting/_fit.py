"""The result of a fit, with its errors, predictions and reports."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2 as chi2_law

from rigidsym import _containers as containers
from rigidsym import _inputs as inputs
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
from rigidsym.fitting._result import Alternative, Periods, Prediction, periods
from rigidsym.io._files import write_bytes, write_text
from rigidsym.quaternions import matrices
from rigidsym.view._pages import fit_card, fit_page
from rigidsym.view._tables import columns

if TYPE_CHECKING:
    from rigidsym.view._plots.figure import Figure

SCHEMA = "rigidsym.fit/1"
_DAY, _HOUR = 86400.0, 3600.0
_COLUMNS = ("", "estimate", "standard deviation", f"{LEVEL:.0%} interval", "unit")
_UNITS = {"attitude": "rad", "omega": "rad/s", "moment": "kg m^2", "axes": "rad"}
# Number of tables that `repr` shows.
_FIRST = 3
# Times in the case file.
_SAMPLES = 401

Table = tuple[str, tuple[str, ...], Sequence[tuple[str, ...]]]
# Step of the derivatives of periods, in errors.
_SMALL = 0.1
# Excess in the triangle inequality, relative to the largest moment, below which a body is flat.
_THIN = 1e-4


@dataclass(frozen=True, repr=False, eq=False)
class Fit(Alternative):
    """The best-fitting motion, with its errors, alternatives and reports.

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
        """Return the verdict on whether the observations agree with the model.

        It has conventions of the data that fit better.

        A normal fit costs nothing more; where model and data disagree, each convention is searched.
        """
        return agreement(self.problem, self.point, self.degrees_of_freedom, self.search)

    @cached_property
    def observability(self) -> Observability:
        """Return the linear errors of the parameters and the unobservable directions."""
        return observability(self.problem, self.point)

    @cached_property
    def _quantities(self) -> Quantities:
        # Away from a minimum of chi2 the observations are replaced by their computed values.
        least = self.converged and self.loss == "linear"
        return Quantities(self.problem, self.point, self.observability.residuals * (not least))

    @cached_property
    def periods_sigma(self) -> Periods:
        """Return the linearised standard deviations of the periods, in s.

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
        """Return the covariance matrix of the quantities in `names`.

        Its shape is (9, 9), or (12, 12) with axes.

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
        """Return the standard deviations of the quantities in `names`."""
        return np.sqrt(np.diag(self.covariance))

    def intervals(self, level: float = LEVEL) -> np.ndarray:
        """Return profile-likelihood intervals of the quantities in `names`.

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
        """Return the ends (k, 2) of the intervals, relative to the estimates."""
        wide = np.sqrt(chi2_law.ppf(level, 1)) * self.sigma
        ends = wide[:, None] * np.array([-1.0, 1.0])
        determined = np.flatnonzero(self._determined)
        if determined.size and not self.spinning:
            ends[determined] = profile(self._quantities, determined, level)
        return ends

    @property
    def _determined(self) -> np.ndarray:
        """Return for each quantity whether it has a finite standard deviation that is not zero."""
        return np.isfinite(self.sigma) & (self.sigma > 0)

    @cached_property
    def nonlinearity(self) -> Nonlinearity:
        """Return how far the likelihood departs from what the covariance implies.

        `Nonlinearity` explains how far the covariance can then be trusted.
        """
        if self.spinning or not self._determined.any():
            return NONE
        ends = np.where(self._determined[:, None], self._ends(LEVEL), np.nan)
        return nonlinearity(self._quantities, self.observability.here, self.covariance, ends)

    @property
    def unobservable(self) -> tuple[str, ...]:
        """Return the names of the unobservable quantities."""
        return tuple(x for x, s in zip(self.names, self.sigma, strict=True) if np.isinf(s))

    @property
    def null_directions(self) -> np.ndarray:
        """Return the directions (k, p) in parameter space that change no observation.

        They are in units of 1 rad, of the size of the rates, and of that of the moments; the names
        of the parameters are `problem.parameters.names`, of the state at `problem.epoch`, s.
        """
        return self.observability.null

    @property
    def degrees_of_freedom(self) -> int:
        """Return the degrees of freedom of chi2.

        They are the number of residuals less that of the parameters that the residuals determine.
        """
        return self.problem.count - self.observability.basis.shape[1]

    @property
    def probability(self) -> float:
        """Return the probability that errors alone make chi2 at least this large."""
        return float(chi2_law.sf(self.chi2, max(self.degrees_of_freedom, 1)))

    @cached_property
    def residuals(self) -> tuple[np.ndarray, ...]:
        """Return the whitened residuals (N, k) of each set of observations.

        They are computed less observed values, in units of the errors.
        """
        return tuple(self.observability.residuals[rows] for rows in self.problem.rows)

    @cached_property
    def against_others(self) -> tuple[np.ndarray, ...]:
        """Return the chi2 of each observation against its prediction from all others.

        There is an array (N,) for each set of observations.

        It has as many degrees of freedom as the observation has numbers; NaN where the others
        predict nothing.
        """
        found = self.observability
        return tuple(against_others(self.problem.rows, found.residuals, found.basis))

    @cached_property
    def outliers(self) -> tuple[tuple[int, int], ...]:
        """Return the outliers at 1 % significance, as pairs of set and observation indices.

        The significance is that of all observations together.
        """
        return outliers(self.problem, self.observability)

    def predict(self, t: ArrayLike) -> Prediction:
        """Predict attitudes and rates of the observed axes, with their covariance.

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
        containers.refuse_dates("t", t)
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
        found = *seen, covariance * (np.nan if self.agreement.hopeless else 1.0), every
        return Prediction(*(x[0] if times.ndim == 0 else x for x in found))

    @property
    def axes(self) -> np.ndarray:
        """Return the principal axes in the observed axes, as columns of a matrix (3, 3).

        `principal_axes` returns them in the same form.
        """
        return matrices(self.mount)

    @property
    def tensor(self) -> np.ndarray:
        """Return the inertia tensor (3, 3) in the observed axes."""
        return self.axes @ np.diag(self.moments) @ self.axes.T

    @property
    def thin(self) -> bool:
        """Return True if the body is flat: one moment is the sum of the other two.

        The observations then prefer a flatter one, which cannot exist, and errors of the moments
        are those along that edge.
        """
        largest = np.max(self.moments)
        return bool(np.sum(self.moments) - 2 * largest < _THIN * largest)

    @property
    def title(self) -> str:
        """Return a one-line summary of the fit.

        It has the goodness of fit, warnings, and the number of alternatives.
        """
        said = [f"chi2 {self.chi2:.6g} of {self.degrees_of_freedom} degrees of freedom"]
        if not self.converged:
            said.append(f"NOT CONVERGED: {self.reason}")
        if self.agreement.hopeless:
            said.append(f"MODEL AND DATA DISAGREE: {self.agreement.message}")
        elif self.agreement.message:
            said.append(self.agreement.message)
        if self.nonlinearity.flagged:
            said.append(f"NONLINEAR: {self.nonlinearity.message}")
        if self.spinning:
            said.append("no more than a spin is seen")
        if self.unobservable:
            said.append(f"not observable: {', '.join(self.unobservable)}")
        if self.thin:
            said.append("no body is flatter than this one")
        if self.alternatives:
            count = len(self.alternatives)
            said.append(f"{count} alternative{'s' * (count > 1)} within {self.delta_chi2:g}")
        return f"rigidsym fit: {'; '.join(said)}"

    def tables(self) -> list[Table]:
        """Return the tables of the report, each with a title, columns and rows."""
        scale = "given" if self.scaled else "not observable: the largest is 1"
        motion = [
            ("regime", str(self.motion.regime)),
            ("mode", str(self.mode or "none")),
            ("rotation period", _duration(self.periods.rotation)),
            ("precession period", _duration(self.periods.precession)),
            ("probability of chi2", f"{self.probability:.3g}"),
            ("scale of the moments", scale),
            ("loss", self.loss),
            ("search", self.reason),
        ]
        point = self.motion.exact
        values = [*np.zeros(3), *point["omega0"], *point["inertia"], *np.zeros(3)]
        unit = dict(_UNITS) if self.scaled else {**_UNITS, "moment": "the largest"}
        ends = self.intervals() - np.array(values, float)[: len(self.names), None]
        attitude = ", ".join(f"{float(x):.9g}" for x in point["attitude0"])
        parameters = [("attitude0", f"[{attitude}]", "", "", "")]
        parameters += [
            (name, f"{float(value):.9g}", _deviation(s), _interval(*end), unit[name.split()[0]])
            for name, value, s, end in zip(self.names, values, self.sigma, ends, strict=False)
        ]
        minima = [
            (
                str(k or "best"),
                f"{one.chi2:.6g}",
                str(one.mode),
                _duration(one.periods.rotation),
                _duration(one.periods.precession),
                ", ".join(f"{x:.6g}" for x in one.moments),
            )
            for k, one in enumerate((self, *self.alternatives))
        ]
        observations = []
        for k, (one, found) in enumerate(zip(self.problem.sets, self.residuals, strict=True)):
            named = [f"{index} (t = {one.t[index]:.9g} s)" for index in self._outliers_of(k)]
            size, chi2 = f"{np.sqrt(np.mean(found**2)):.3g}", f"{np.sum(found**2):.6g}"
            observations.append((one.kind, str(one.count), chi2, size, ", ".join(named) or "none"))
        with np.errstate(invalid="ignore", divide="ignore"):
            correlations = self.covariance / np.outer(self.sigma, self.sigma)
        correlations[~np.isfinite(self.sigma) | (self.sigma == 0)] = np.nan
        # A parameter that is fixed, or not observed, has none.
        free = np.flatnonzero(~np.isnan(np.diag(correlations)))
        found = [self.names[k] for k in free]
        listed = [
            (name, *(f"{x:.2f}" for x in correlations[k, free]))
            for name, k in zip(found, free, strict=True)
        ]
        by_chi2 = ("", "chi2", "mode", "rotation", "precession", "moments")
        by_set = ("kind", "number", "chi2", "root mean square", "outliers")
        return [
            ("motion", ("", "best"), motion),
            ("parameters at t = 0", _COLUMNS, parameters),
            ("motions by chi2", by_chi2, minima),
            ("observations", by_set, observations),
            ("correlations", ("", *found), listed),
        ]

    def _outliers_of(self, place: int) -> list[int]:
        """Return the indices of the outliers in one set of observations."""
        return [index for other, index in self.outliers if other == place]

    def to_json(self) -> str:
        """Return the fit as JSON in the schema rigidsym.fit/1.

        Numbers are doubles, and null where there is none or it is infinite.
        """
        nonlinearity = asdict(self.nonlinearity)
        del nonlinearity["ratios"]
        data = {
            "schema": SCHEMA,
            "converged": self.converged,
            "reason": self.reason,
            "chi2": self.chi2,
            "degrees_of_freedom": self.degrees_of_freedom,
            "probability": self.probability,
            "agreement": asdict(self.agreement),
            "nonlinearity": {
                "flagged": self.nonlinearity.flagged,
                "message": self.nonlinearity.message,
                **nonlinearity,
            },
            "spin": self.spinning,
            "scale_known": self.scaled,
            "names": self.names,
            "covariance": self.covariance,
            "intervals": self.intervals(),
            "unobservable": self.unobservable,
            "parameters": self.problem.parameters.names,
            "null_directions": self.null_directions,
            "best": _minimum(self),
            "delta_chi2": self.delta_chi2,
            "alternatives": [_minimum(one) for one in self.alternatives],
            "observations": [
                {
                    "kind": one.kind,
                    "times": one.t,
                    "residuals": self.residuals[k],
                    "against_others": self.against_others[k],
                    "outliers": self._outliers_of(k),
                }
                for k, one in enumerate(self.problem.sets)
            ],
        }
        return json.dumps(_plain(data), indent=1) + "\n"

    def case(self) -> str:
        """Return the motion as the text of a case file for `rigidsym propagate`.

        The times are those of the observations.
        """
        lines = []
        for name, values in self.motion.exact.items():
            texts = ", ".join(repr(inputs.exact_text(x)) for x in values)
            lines.append(f"{name} = [{texts}]".replace("'", '"'))
        ends = (("start", self.problem.times[0]), ("stop", self.problem.times[-1]))
        table = [f"{name} = {float(value)!r}" for name, value in ends]
        return "\n".join([*lines, "", "[times]", *table, f"count = {_SAMPLES}", ""])

    def plot(self) -> "Figure":
        """Plot the residuals in units of their errors.

        Needs Matplotlib.
        """
        from rigidsym.view._plots.charts import residuals

        whole = enumerate(zip(self.problem.sets, self.residuals, strict=True))
        return residuals([(x.kind, x.t, found, self._outliers_of(k)) for k, (x, found) in whole])

    def write(self, directory: Path) -> list[Path]:
        """Write fit.json, motion.toml, fit.html and the pictures to a directory.

        Parameters
        ----------
        directory : Path
            Where to write; it is made if needed.

        Returns
        -------
        list of Path
            The files.
        """
        from rigidsym.view._plots.figure import rendered

        pictures = {"residuals": ("Residuals", rendered(self.plot()))}
        if any(self.motion.exact["omega0"]):
            drawn = self.motion.plot(np.linspace(*self.problem.times[[0, -1]], 801))
            pictures["motion"] = ("The motion", rendered(drawn))
        shown = [(title, files["svg"].decode()) for title, files in pictures.values()]
        return [
            write_text(directory / "fit.json", self.to_json()),
            write_text(directory / "motion.toml", self.case()),
            write_text(directory / "fit.html", fit_page(self.title, self.tables(), shown)),
            *(
                write_bytes(directory / f"{name}.{suffix}", data)
                for name, (_, files) in pictures.items()
                for suffix, data in files.items()
            ),
        ]

    def __repr__(self) -> str:
        return "\n\n".join([self.title, *(columns(*one) for one in self.tables()[:_FIRST])])

    def _repr_html_(self) -> str:
        return fit_card(self.title, self.tables()[:_FIRST])


def _spread(ends: list[list[float | None]]) -> float | None:
    """Estimate a quantity's standard deviation from its values on both sides of the best fit."""
    both = [(one, other) for one, other in ends if one is not None and other is not None]
    if len(both) < len(ends) or not both:
        return None
    return float(np.linalg.norm([one - other for one, other in both]) / (2 * _SMALL))


def _deviation(sigma: float) -> str:
    if np.isnan(sigma):
        return "not known"
    if np.isinf(sigma):
        return "not observable"
    return f"{sigma:.3g}" if sigma else "fixed"


def _interval(lower: float, upper: float) -> str:
    """Format both ends of an interval as text.

    The text is empty where there is no interval.
    """
    if np.isnan(lower) or lower == upper or (np.isinf(lower) and np.isinf(upper)):
        return ""
    return ", ".join("no end" if np.isinf(x) else f"{x:+.2g}" for x in (lower, upper))


def _duration(seconds: float | None) -> str:
    """Format a duration in days, hours or seconds, whichever suits its size."""
    if seconds is None:
        return "none"
    if seconds >= _DAY:
        return f"{seconds / _DAY:.6g} d"
    return f"{seconds / _HOUR:.6g} h" if seconds >= _HOUR else f"{seconds:.6g} s"


def _minimum(one: Alternative) -> dict[str, Any]:
    return {
        **{name: [float(x) for x in values] for name, values in one.motion.exact.items()},
        "mount": one.mount,
        "chi2": one.chi2,
        "mode": one.mode and str(one.mode),
        "rotation_period": one.periods.rotation,
        "precession_period": one.periods.precession,
    }


def _plain(value: Any) -> Any:
    """Convert a value to plain JSON data.

    Arrays and tuples become lists, and numbers that are not finite become None.
    """
    if isinstance(value, dict):
        return {key: _plain(x) for key, x in value.items()}
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(x) for x in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
