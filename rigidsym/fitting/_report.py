"""The fit as users see it: tables, JSON of the schema rigidsym.fit/1, files, and pictures."""

import json
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

Rows = list[tuple[str, ...]]
Table = tuple[str, tuple[str, ...], Rows]


@dataclass(frozen=True, repr=False, eq=False)
class Fit(Estimate):
    """The motion that observations show; see `Estimate` for its attributes."""

    @property
    def title(self) -> str:
        """Return one line: goodness of fit, what is observable, and the alternatives."""
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
        """Return the tables of the report: a title, columns and rows each."""
        motions = ("", "chi2", "mode", "rotation", "precession", "moments")
        observations = ("kind", "number", "chi2", "root mean square", "outliers")
        return [
            ("motion", ("", "best"), self._motion_rows()),
            ("parameters at t = 0", _COLUMNS, self._parameter_rows()),
            ("motions by chi2", motions, self._minimum_rows()),
            ("observations", observations, self._observation_rows()),
            ("correlations", ("", *self.names), self._correlation_rows()),
        ]

    def _motion_rows(self) -> Rows:
        scale = "given" if self.scaled else "not observable: the largest is 1"
        return [
            ("regime", str(self.motion.regime)),
            ("mode", str(self.mode or "none")),
            ("rotation period", _duration(self.periods.rotation)),
            ("precession period", _duration(self.periods.precession)),
            ("probability of chi2", f"{self.probability:.3g}"),
            ("scale of the moments", scale),
            ("loss", self.loss),
            ("search", self.reason),
        ]

    def _parameter_rows(self) -> Rows:
        point = self.motion.exact
        values = [*np.zeros(3), *point["omega0"], *point["inertia"], *np.zeros(3)]
        unit = dict(_UNITS) if self.scaled else {**_UNITS, "moment": "the largest"}
        ends = self.intervals() - np.array(values, float)[: len(self.names), None]
        rows = [
            (name, f"{float(value):.9g}", _deviation(s), _interval(*end), unit[name.split()[0]])
            for name, value, s, end in zip(self.names, values, self.sigma, ends, strict=False)
        ]
        attitude = ", ".join(f"{float(x):.9g}" for x in point["attitude0"])
        return [("attitude0", f"[{attitude}]", "", "", ""), *rows]

    def _minimum_rows(self) -> Rows:
        return [
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

    def _observation_rows(self) -> Rows:
        rows = []
        for k, (one, found) in enumerate(zip(self.problem.sets, self.residuals, strict=True)):
            named = [f"{index} (t = {one.t[index]:.9g} s)" for index in self._outliers_of(k)]
            size = f"{np.sqrt(np.mean(found**2)):.3g}"
            chi2 = f"{np.sum(found**2):.6g}"
            rows.append((one.kind, str(one.count), chi2, size, ", ".join(named) or "none"))
        return rows

    def _outliers_of(self, place: int) -> list[int]:
        """Return the indices of the outliers of a set."""
        return [index for other, index in self.outliers if other == place]

    def _correlation_rows(self) -> Rows:
        """Return correlations; empty for quantities that are fixed or not observable."""
        with np.errstate(invalid="ignore", divide="ignore"):
            found = self.covariance / np.outer(self.sigma, self.sigma)
        found[~np.isfinite(self.sigma) | (self.sigma == 0)] = np.nan
        return [
            (name, *("" if np.isnan(x) else f"{x:.2f}" for x in row))
            for name, row in zip(self.names, found, strict=True)
        ]

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
            "chi2": _finite(self.chi2),
            "degrees_of_freedom": self.degrees_of_freedom,
            "probability": self.probability,
            "agreement": {**asdict(self.agreement), "scale": _finite(self.agreement.scale)},
            "nonlinearity": {
                "flagged": self.nonlinearity.flagged,
                "message": self.nonlinearity.message,
                **nonlinearity,
            },
            "spin": self.spinning,
            "scale_known": self.scaled,
            "names": list(self.names),
            "covariance": _matrix(self.covariance),
            "intervals": _matrix(self.intervals()),
            "unobservable": list(self.unobservable),
            "parameters": list(self.problem.parameters.names),
            "null_directions": _matrix(self.null_directions),
            "best": _minimum(self),
            "delta_chi2": self.delta_chi2,
            "alternatives": [_minimum(one) for one in self.alternatives],
            "observations": [
                {
                    "kind": one.kind,
                    "times": one.t.tolist(),
                    "residuals": _matrix(self.residuals[k]),
                    "against_others": [_finite(x) for x in self.against_others[k].tolist()],
                    "outliers": self._outliers_of(k),
                }
                for k, one in enumerate(self.problem.sets)
            ],
        }
        return json.dumps(data, indent=1) + "\n"

    def case(self) -> str:
        """Return a case file of the motion over the times observed, for `rigidsym propagate`."""
        lines = []
        for name, values in self.motion.exact.items():
            texts = ", ".join(repr(inputs.exact_text(x)) for x in values)
            lines.append(f"{name} = [{texts}]".replace("'", '"'))
        ends = (("start", self.problem.times[0]), ("stop", self.problem.times[-1]))
        table = [f"{name} = {float(value)!r}" for name, value in ends]
        return "\n".join([*lines, "", "[times]", *table, f"count = {_SAMPLES}", ""])

    def plot(self) -> "Figure":
        """Plot the residuals, in units of their errors (needs matplotlib)."""
        from rigidsym.view._plots.motion import Residuals, residuals

        whole = zip(self.problem.sets, self.residuals, strict=True)
        return residuals(
            [
                Residuals(x.kind, x.t, found, self._outliers_of(k))
                for k, (x, found) in enumerate(whole)
            ]
        )

    def write(self, directory: Path) -> list[Path]:
        """Write fit.json, motion.toml, fit.html, and pictures.

        Parameters
        ----------
        directory : Path
            Where to write; it is made if needed.

        Returns
        -------
        list of Path
            The files.
        """
        pictures = self._pictures()
        drawn = [(title, files["svg"].decode()) for title, files in pictures.values()]
        return [
            write_text(directory / "fit.json", self.to_json()),
            write_text(directory / "motion.toml", self.case()),
            write_text(directory / "fit.html", fit_page(self.title, self.tables(), drawn)),
            *(
                write_bytes(directory / f"{name}.{suffix}", data)
                for name, (_, files) in pictures.items()
                for suffix, data in files.items()
            ),
        ]

    def _pictures(self) -> dict[str, tuple[str, dict[str, bytes]]]:
        """Return titles, and files by suffix, of pictures by name."""
        from rigidsym.view._plots.figure import rendered

        drawn = {"residuals": ("Residuals", self.plot())}
        if any(self.motion.exact["omega0"]):
            ends = self.problem.times[[0, -1]]
            drawn["motion"] = ("The motion", self.motion.plot(np.linspace(*ends, 801)))
        return {name: (title, rendered(figure)) for name, (title, figure) in drawn.items()}

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
    """Return the ends relative to the estimate; empty where there is no interval."""
    if np.isnan(lower) or lower == upper or (np.isinf(lower) and np.isinf(upper)):
        return ""
    return ", ".join("no end" if np.isinf(x) else f"{x:+.2g}" for x in (lower, upper))


def _duration(seconds: float | None) -> str:
    """Return a duration in days, hours or seconds, by its size."""
    if seconds is None:
        return "none"
    if seconds >= _DAY:
        return f"{seconds / _DAY:.6g} d"
    return f"{seconds / _HOUR:.6g} h" if seconds >= _HOUR else f"{seconds:.6g} s"


def _minimum(one: Alternative) -> dict[str, Any]:
    return {
        **{name: [float(x) for x in values] for name, values in one.motion.exact.items()},
        "mount": one.mount.tolist(),
        "chi2": _finite(one.chi2),
        "mode": one.mode and str(one.mode),
        "rotation_period": _finite(one.periods.rotation),
        "precession_period": _finite(one.periods.precession),
    }


def _matrix(values: np.ndarray) -> list[list[float | None]]:
    return [[_finite(x) for x in row] for row in values.tolist()]


def _finite(value: float | None) -> float | None:
    return value if value is not None and np.isfinite(value) else None
