"""How wrong states are, by every measure, in units of 2^-53 and against the documented bounds."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from rigidsym.engines import EngineError, States
from rigidsym.validate.arcs import arc, residual
from rigidsym.validate.oracle import Reference, lengths
from rigidsym.validate.strata import Sample

ULP = 2.0**-53
# The documented bound on angle (rad) and rates (relative), of bodies that can exist, at all times.
BOUND = 2e-15
BOUNDS = {
    "angle": BOUND,
    "omega": BOUND,
    "norm": 1e-15,
    # Times the condition of H and K^2: what an error of BOUND in the rates makes of them.
    "energy": BOUND,
    "momentum": BOUND,
    # Two states are in these, each with an error of half the angle.
    "residual": 2 * BOUND,
    "jump": BOUND,
}
MEASURES = tuple(BOUNDS)
MEANINGS = {
    "angle": "rotation angle from the true attitude, on the right sheet (rad)",
    "omega": "|difference from the true rates| / |omega|",
    "norm": "| |q| - 1 |",
    "energy": "relative drift of H",
    "momentum": "relative drift of K^2",
    "residual": "|q(t2) - q(t1) - integral of q (0, omega)/2| over half a radian",
    "jump": "|q(t+) - q(t)| for the next double t+, beyond what |omega| explains",
}


@dataclass(frozen=True, slots=True)
class Errors:
    """One measure at some times (N,): units of 2^-53, the condition, and the part of the bound."""

    times: np.ndarray
    units: np.ndarray
    condition: np.ndarray
    share: np.ndarray


def measure(reference: Reference, engine: Any) -> dict[str, Errors]:
    """Run an engine, or a peer, on a sample; what it refuses is infinitely wrong."""
    sample = reference.sample
    times = np.array(sample.times, dtype=float)
    begins, later = times[[len(times) // 2, -1]], np.nextafter(times, np.inf)
    rate = float(lengths(np.array([sample.omega0], dtype=float))[0])
    paths = [arc(float(begin), rate) for begin in begins]
    asked = [times, later, *(path.nodes for path in paths)]
    q, omega = _states(sample, engine, np.concatenate(asked))
    (q_at, q_later, *q_paths), (omega_at, _, *omega_paths) = (
        np.split(x, np.cumsum([len(part) for part in asked])[:-1]) for x in (q, omega)
    )
    residuals = np.array(list(map(residual, paths, q_paths, omega_paths)))
    turning = reference.condition
    found = {
        "angle": _errors("angle", times, _angle(q_at, reference, engine), turning["angle"]),
        "omega": _errors("omega", times, _relative(omega_at, reference), turning["omega"]),
        "norm": _errors("norm", times, np.abs(np.linalg.norm(q_at, axis=-1) - 1)),
        "residual": _errors("residual", np.array([p.nodes[0] for p in paths]), residuals),
        "jump": _errors("jump", times, _jump(q_at, q_later, omega_at, later - times)),
    }
    return found | _drifts(sample, times, omega_at)


def _states(sample: Sample, engine: Any, times: np.ndarray) -> States:
    """(q, omega) by the engine, from exact numbers where doubles do not say them."""
    state = (sample.inertia, sample.omega0, sample.attitude0)
    try:
        with np.errstate(all="ignore"):
            numbers = [x for values in state for x in values]
            # Peers take doubles only.
            if hasattr(engine, "exact_plan") and any(isinstance(x, Fraction) for x in numbers):
                plan = engine.exact_plan(*(tuple(map(Fraction, values)) for values in state))
            else:
                plan = engine.plan(*(np.array(values) for values in state))
            return engine.states(plan, times)
    except EngineError:
        return np.full((len(times), 4), np.nan), np.full((len(times), 3), np.nan)


def _angle(q: np.ndarray, reference: Reference, engine: Any) -> np.ndarray:
    """The angle of the turn between, up to 2 pi: the difference is taken before it is rounded."""
    chord = _apart(q, reference.q)
    if not getattr(engine, "sheets", True):
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
    name: str, times: np.ndarray, values: np.ndarray, condition: Any = 1.0, allowance: Any = 1.0
) -> Errors:
    """Errors of a measure; what is no number is infinitely wrong."""
    values = np.where(np.isnan(values), np.inf, values)
    condition = np.where(np.isnan(condition), 1.0, np.broadcast_to(condition, values.shape))
    share = values / (BOUNDS[name] * allowance)
    return Errors(times, values / ULP, condition, np.where(np.isinf(values), np.inf, share))
