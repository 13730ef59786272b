"""How wrong states are, by every measure, in units of 2^-53 and against the documented bounds."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TypeGuard

import numpy as np
from numpy.typing import ArrayLike

from rigidsym.engines import Engine, Prepared
from rigidsym.validate import entry_points
from rigidsym.validate.bounds import BOUNDS, MEASURES, ULP
from rigidsym.validate.callers import Body
from rigidsym.validate.oracle import Reference, lengths
from rigidsym.validate.peers.protocol import Solver
from rigidsym.validate.quadrature_residual import Quadrature, residual
from rigidsym.validate.steps import Steps
from rigidsym.validate.strata import Sample


@dataclass(frozen=True, slots=True)
class Errors:
    """One measure at some times (N,): units of 2^-53, the condition, and the part of the bound."""

    times: np.ndarray
    units: np.ndarray
    condition: np.ndarray
    share: np.ndarray

    @property
    def values(self) -> np.ndarray:
        """The errors as MEANINGS has them, in rad or relative (N,)."""
        return self.units * ULP


def measure(
    reference: Reference, engine: Engine | Solver, bounds: Mapping[str, float] = BOUNDS
) -> dict[str, Errors]:
    """Run an engine, or a peer, on a sample; what it refuses is infinitely wrong."""
    times = np.array(reference.sample.times, dtype=float)
    try:
        with np.errstate(all="ignore"):
            found = _measured(reference, engine, times)
        return {
            name: replace(errors, share=errors.share * (BOUNDS[name] / bounds[name]))
            for name, errors in found.items()
        }
    # Engines refuse by the first; the second is a fault of theirs, and as wrong.
    except (ValueError, ArithmeticError):
        return {name: _errors(name, times, np.full(len(times), np.inf)) for name in MEASURES}


def _measured(
    reference: Reference, engine: Engine | Solver, times: np.ndarray
) -> dict[str, Errors]:
    sample, rate = reference.sample, reference.rate or 1.0
    later = np.nextafter(times, np.inf)
    paths = [Quadrature.over(float(begin), rate) for begin in times[[len(times) // 2, -1]]]
    asked = [times, later, *(path.nodes for path in paths)]
    prepared, body = prepare(sample, engine)
    states = engine.states(prepared, np.concatenate(asked))
    (q, q_later, *q_paths), (omega, _, *omega_paths) = (
        np.split(x, np.cumsum([len(part) for part in asked])[:-1]) for x in states
    )
    angle, rates = _angle(q, reference, engine), _relative(omega, reference)
    start, residuals = times == 0, list(map(residual, paths, q_paths, omega_paths))
    found = {
        "angle": _errors("angle", times, angle, reference.condition["angle"]),
        "omega": _errors("omega", times, rates, reference.condition["omega"]),
        "norm": _errors("norm", times, np.abs(np.linalg.norm(q, axis=-1) - 1)),
        "residual": _errors("residual", [path.nodes[0] for path in paths], residuals),
        "jump": _errors("jump", times, _jump(q, q_later, omega, later - times)),
        "start": _errors("start", times[start], np.maximum(angle, rates)[start]),
    }
    # Peers have one entry point only.
    if entry_points.is_due(sample.index) and (isinstance(engine, Steps) or _offers(engine, "grid")):
        apart = entry_points.differences(engine, prepared, body, times, rate)
        found["entry_points"] = _errors("entry_points", [0.0] * len(apart), apart)
    found |= _drifts(sample, times, omega)
    # Where t = 0 is not asked for there is no start.
    return {name: errors for name, errors in found.items() if len(errors.times)}


def prepare(sample: Sample, engine: Engine | Solver) -> tuple[Prepared, Body | None]:
    """A prepared motion, and the doubles it is made from where they say all of the sample."""
    state = (sample.inertia, sample.omega0, sample.attitude0)
    inertia, omega0, attitude0 = (np.array(values, dtype=float) for values in state)
    # Peers take doubles only.
    if not sample.in_doubles and _offers(engine, "prepare_exactly"):
        return engine.prepare_exactly(*sample.exact), None
    return engine.prepare(inertia, omega0, attitude0), (inertia, omega0, attitude0)


def _offers(engine: Engine | Solver, method: str) -> TypeGuard[Engine]:
    """Whether it has what peers may do without."""
    return hasattr(engine, method)


def _angle(q: np.ndarray, reference: Reference, engine: Engine | Solver) -> np.ndarray:
    """The angle of the turn between, up to 2 pi: the difference is taken before it is rounded."""
    chord = _apart(q, reference.q)
    if not getattr(engine, "double_cover_sign", True):
        chord = np.minimum(chord, _apart(-q, reference.q))
    return 4 * np.arcsin(np.minimum(chord / 2, 1)) + 2 * reference.radius


def _relative(omega: np.ndarray, reference: Reference) -> np.ndarray:
    size = lengths(reference.omega[0])
    return _apart(omega, reference.omega) / size + reference.radius


def _apart(given: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Distances of rows from sums of two doubles."""
    return lengths((given - exact[0]) - exact[1], 0.0)


def _jump(before: np.ndarray, after: np.ndarray, omega: np.ndarray, dt: np.ndarray) -> np.ndarray:
    """Beyond |omega| dt/2, and beyond what |omega'| <= |omega|^2 can add to that."""
    turned = lengths(omega, 0.0) * dt
    return np.maximum(lengths(after - before, 0.0) - (turned + turned**2) / 2, 0.0)


def _drifts(sample: Sample, times: np.ndarray, omega: np.ndarray) -> dict[str, Errors]:
    """Relative drift of H and K^2 from their values at t = 0, free of scale, with the condition:
    |omega| times the gradient over the value."""
    inertia, omega0 = (np.array(x, dtype=float) for x in (sample.inertia, sample.omega0))
    c, largest = inertia / np.max(inertia), np.max(np.abs(omega0)) or 1.0
    w, w0 = omega / largest, omega0 / largest
    found = {}
    for name, weight in (("energy", c), ("momentum", c * c)):
        before, after = weight @ (w0 * w0), (w * w) @ weight
        size = before or 1.0
        condition = 2 * lengths(w, 0.0) * lengths(weight * w, 0.0) / size
        drift = np.abs(after - before) / size
        found[name] = _errors(name, times, drift, condition, np.maximum(condition, 1.0))
    return found


def _errors(
    name: str,
    times: ArrayLike,
    values: ArrayLike,
    condition: ArrayLike = 1.0,
    allowance: float | np.ndarray = 1.0,
) -> Errors:
    """Errors of a measure; what is no number is infinitely wrong."""
    times, values = np.array(times, dtype=float), np.array(values, dtype=float)
    values = np.where(np.isnan(values), np.inf, values)
    condition = np.where(np.isnan(condition), 1.0, np.broadcast_to(condition, values.shape))
    share = values / (BOUNDS[name] * allowance)
    return Errors(times, values / ULP, condition, np.where(np.isinf(values), np.inf, share))
