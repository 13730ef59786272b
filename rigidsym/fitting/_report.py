"""Reports of a fit: tables, JSON of the schema rigidsym.fit/1, files, and pictures."""

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.fitting._nonlinearity import LEVEL
from rigidsym.fitting._result import Alternative, Estimate
from rigidsym.io._files import write_bytes, write_text
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


@dataclass(frozen=True, repr=False, eq=False)
class Fit(Estimate):
    """The motion that observations show; see `Estimate` for its attributes."""

    @property
    def title(self) -> str:
        """Return one line with the goodness of fit, warnings, and the number of alternatives."""
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
        named = zip(self.names, correlations, strict=True)
        listed = [(name, *("" if np.isnan(x) else f"{x:.2f}" for x in row)) for name, row in named]
        by_chi2 = ("", "chi2", "mode", "rotation", "precession", "moments")
        by_set = ("kind", "number", "chi2", "root mean square", "outliers")
        return [
            ("motion", ("", "best"), motion),
            ("parameters at t = 0", _COLUMNS, parameters),
            ("motions by chi2", by_chi2, minima),
            ("observations", by_set, observations),
            ("correlations", ("", *self.names), listed),
        ]

    def _outliers_of(self, place: int) -> list[int]:
        """Return the indices of the outliers of a set."""
        return [index for other, index in self.outliers if other == place]

    def to_json(self) -> str:
        """Return JSON of the schema rigidsym.fit/1.

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
        """Return a case file for `rigidsym propagate` with the motion and the times observed."""
        lines = []
        for name, values in self.motion.exact.items():
            texts = ", ".join(repr(inputs.exact_text(x)) for x in values)
            lines.append(f"{name} = [{texts}]".replace("'", '"'))
        ends = (("start", self.problem.times[0]), ("stop", self.problem.times[-1]))
        table = [f"{name} = {float(value)!r}" for name, value in ends]
        return "\n".join([*lines, "", "[times]", *table, f"count = {_SAMPLES}", ""])

    def plot(self) -> "Figure":
        """Plot the residuals, in units of their errors (needs matplotlib)."""
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


def _deviation(sigma: float) -> str:
    if np.isnan(sigma):
        return "not known"
    if np.isinf(sigma):
        return "not observable"
    return f"{sigma:.3g}" if sigma else "fixed"


def _interval(lower: float, upper: float) -> str:
    """Return both ends of an interval as text; an empty text where there is no interval."""
    if np.isnan(lower) or lower == upper or (np.isinf(lower) and np.isinf(upper)):
        return ""
    return ", ".join("no end" if np.isinf(x) else f"{x:+.2g}" for x in (lower, upper))


def _duration(seconds: float | None) -> str:
    """Return a duration as text in days, hours or seconds, whichever suits its size."""
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
    """Replace arrays and tuples by lists, and numbers that are not finite by None."""
    if isinstance(value, dict):
        return {key: _plain(x) for key, x in value.items()}
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(x) for x in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
