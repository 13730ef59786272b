"""What a fit says, as tables to read and as data."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from rigidsym import inputs
from rigidsym.fitting.nonlinearity import LEVEL

if TYPE_CHECKING:
    from rigidsym.fitting.found import Alternative, Found

SCHEMA = "rigidsym.fit/1"
_DAY, _HOUR = 86400.0, 3600.0

_COLUMNS = ("", "estimate", "standard deviation", f"{LEVEL:.0%} interval", "unit")

Rows = list[tuple[str, ...]]
Table = tuple[str, tuple[str, ...], Rows]
_UNITS = {"attitude": "rad", "omega": "rad/s", "moment": "kg m^2", "axes": "rad"}


def title(fit: "Found") -> str:
    """In one line: how well it fits, what it shows, and whether that is all there is."""
    said = [f"chi2 {fit.chi2:.6g} of {fit.degrees_of_freedom} degrees of freedom"]
    if not fit.converged:
        said.append(f"NOT CONVERGED: {fit.reason}")
    if fit.agreement.hopeless:
        said.append(f"MODEL AND DATA DISAGREE: {fit.agreement.message}")
    elif fit.agreement.message:
        said.append(fit.agreement.message)
    if fit.nonlinearity.flagged:
        said.append(f"NONLINEAR: {fit.nonlinearity.message}")
    if fit.spinning:
        said.append("no more than a spin is seen")
    if fit.unobservable:
        said.append(f"not observable: {', '.join(fit.unobservable)}")
    if fit.thin:
        said.append("no body is flatter than this one")
    if fit.alternatives:
        count = len(fit.alternatives)
        said.append(f"{count} alternative{'s' * (count > 1)} within {fit.delta_chi2:g}")
    return f"rigidsym fit: {'; '.join(said)}"


def tables(fit: "Found") -> list[Table]:
    """The motion, its parameters, the motions that are left, the observations, correlations."""
    return [
        ("motion", ("", "best"), _motion(fit)),
        ("parameters at t = 0", _COLUMNS, _parameters(fit)),
        (
            "motions by chi2",
            ("", "chi2", "mode", "rotation", "precession", "moments"),
            [_minimum(k, one) for k, one in enumerate((fit, *fit.alternatives))],
        ),
        ("observations", ("kind", "number", "chi2", "root mean square", "outliers"), _sets(fit)),
        ("correlations", ("", *fit.names), _correlations(fit)),
    ]


def _motion(fit: "Found") -> Rows:
    return [
        ("regime", str(fit.motion.regime)),
        ("mode", str(fit.mode or "none")),
        ("rotation period", duration(fit.periods.rotation)),
        ("precession period", duration(fit.periods.precession)),
        ("probability of chi2", f"{fit.probability:.3g}"),
        ("scale of the moments", "given" if fit.scaled else "not observable: the largest is 1"),
        ("loss", fit.loss),
        ("search", fit.reason),
    ]


def _parameters(fit: "Found") -> Rows:
    point = fit.motion.exact
    values = [*np.zeros(3), *point["omega0"], *point["inertia"], *np.zeros(3)]
    unit = dict(_UNITS) if fit.scaled else {**_UNITS, "moment": "the largest"}
    ends = fit.intervals() - np.array(values, float)[: len(fit.names), None]
    rows = [
        (name, f"{float(value):.9g}", _deviation(s), _interval(*end), unit[name.split()[0]])
        for name, value, s, end in zip(fit.names, values, fit.sigma, ends, strict=False)
    ]
    attitude = ", ".join(f"{float(x):.9g}" for x in point["attitude0"])
    return [("attitude0", f"[{attitude}]", "", "", ""), *rows]


def _deviation(sigma: float) -> str:
    if np.isnan(sigma):
        return "not known"
    if np.isinf(sigma):
        return "not observable"
    return f"{sigma:.3g}" if sigma else "fixed"


def _interval(lower: float, upper: float) -> str:
    """About the estimate; empty where there is none."""
    if np.isnan(lower) or lower == upper or (np.isinf(lower) and np.isinf(upper)):
        return ""
    return ", ".join("no end" if np.isinf(x) else f"{x:+.2g}" for x in (lower, upper))


def _minimum(place: int, one: "Alternative") -> tuple[str, ...]:
    moments = ", ".join(f"{x:.6g}" for x in one.moments)
    found = one.periods
    ways = (duration(found.rotation), duration(found.precession))
    return ("best" if not place else str(place), f"{one.chi2:.6g}", str(one.mode), *ways, moments)


def _sets(fit: "Found") -> Rows:
    named: dict[int, list[int]] = {}
    for k, index in fit.outliers:
        named.setdefault(k, []).append(index)
    return [
        (
            one.kind,
            str(one.count),
            f"{np.sum(found**2):.6g}",
            f"{np.sqrt(np.mean(found**2)):.3g}",
            ", ".join(f"{index} (t = {one.t[index]:.9g} s)" for index in named.get(k, []))
            or "none",
        )
        for k, (one, found) in enumerate(zip(fit.problem.sets, fit.residuals, strict=True))
    ]


def correlations(fit: "Found") -> np.ndarray:
    """(9, 9) or (12, 12): NaN for what is fixed or not observable."""
    sigma = fit.sigma
    with np.errstate(invalid="ignore", divide="ignore"):
        found = fit.covariance / np.outer(sigma, sigma)
    found[~np.isfinite(sigma) | (sigma == 0)] = np.nan
    return found


def _correlations(fit: "Found") -> Rows:
    found = correlations(fit)
    return [
        (name, *("" if np.isnan(x) else f"{x:.2f}" for x in row))
        for name, row in zip(fit.names, found, strict=True)
    ]


def duration(seconds: float | None) -> str:
    """In the unit that it is read in best."""
    if seconds is None:
        return "none"
    if seconds >= _DAY:
        return f"{seconds / _DAY:.6g} d"
    return f"{seconds / _HOUR:.6g} h" if seconds >= _HOUR else f"{seconds:.6g} s"


def to_json(fit: "Found") -> str:
    """Schema rigidsym.fit/1: numbers are doubles, null where there is none or it is infinite."""
    data = {
        "schema": SCHEMA,
        "converged": fit.converged,
        "reason": fit.reason,
        "chi2": _finite(fit.chi2),
        "degrees_of_freedom": fit.degrees_of_freedom,
        "probability": fit.probability,
        "agreement": {**asdict(fit.agreement), "scale": _finite(fit.agreement.scale)},
        "nonlinearity": {
            "flagged": fit.nonlinearity.flagged,
            "message": fit.nonlinearity.message,
            "beyond": fit.nonlinearity.beyond,
            "off": fit.nonlinearity.off,
            "single": list(fit.nonlinearity.single),
            "joint": list(fit.nonlinearity.joint),
        },
        "spin": fit.spinning,
        "scale_known": fit.scaled,
        "names": list(fit.names),
        "covariance": _matrix(fit.covariance),
        "intervals": _matrix(fit.intervals()),
        "unobservable": list(fit.unobservable),
        "parameters": list(fit.problem.parameters.names),
        "null_directions": _matrix(fit.null_directions),
        "best": _minimum_data(fit),
        "delta_chi2": fit.delta_chi2,
        "alternatives": [_minimum_data(one) for one in fit.alternatives],
        "observations": list(_observations(fit)),
    }
    return json.dumps(data, indent=1) + "\n"


def _minimum_data(one: "Alternative") -> dict[str, Any]:
    return {
        **{name: [float(x) for x in values] for name, values in one.motion.exact.items()},
        "mount": one.mount.tolist(),
        "chi2": _finite(one.chi2),
        "mode": one.mode and str(one.mode),
        "rotation_period": _finite(one.periods.rotation),
        "precession_period": _finite(one.periods.precession),
    }


def _observations(fit: "Found") -> Iterator[dict[str, Any]]:
    whole = zip(fit.problem.sets, fit.residuals, fit.against_others, strict=True)
    for k, (one, found, missed) in enumerate(whole):
        yield {
            "kind": one.kind,
            "times": one.t.tolist(),
            "residuals": _matrix(found),
            "against_others": [_finite(x) for x in missed.tolist()],
            "outliers": [index for place, index in fit.outliers if place == k],
        }


def _matrix(values: np.ndarray) -> list[list[float | None]]:
    return [[_finite(x) for x in row] for row in values.tolist()]


def _finite(value: float | None) -> float | None:
    return value if value is not None and np.isfinite(value) else None


def case(fit: "Found", samples: int = 401) -> str:
    """A case file of the motion over the times observed, for `rigidsym propagate`."""
    lines = [f"{name} = {_texts(values)}" for name, values in fit.motion.exact.items()]
    times = fit.problem.times
    ends = (("start", times[0]), ("stop", times[-1]))
    table = [f"{name} = {float(value)!r}" for name, value in ends]
    return "\n".join([*lines, "", "[times]", *table, f"count = {samples}", ""])


def _texts(values: Sequence[Any]) -> str:
    return f"[{', '.join(repr(inputs.exact_text(x)) for x in values)}]".replace("'", '"')
