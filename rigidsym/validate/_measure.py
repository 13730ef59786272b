"""Measurement of the errors of computed states.

They are in units of 2^-53, and as ratios to the documented bounds.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import ArrayLike

from rigidsym._engines import Engine, Prepared
from rigidsym.validate import _entry_points as entry_points
from rigidsym.validate._bounds import BOUNDS, MEASURES, ULP
from rigidsym.validate._entry_points import Body
from rigidsym.validate._implementations import Steps
from rigidsym.validate._oracle import Reference, lengths
from rigidsym.validate._singles import Singles, SingleSteps
from rigidsym.validate.peers._protocol import Solver
from rigidsym.validate.strata import Sample

# Nodes of an interval, and its length in radians: what Gauss and Lobatto's rule leaves out is below
# 1e-18 then, since the motion is analytic within 3/2 of a radian or more.  With nodes and weights
# rounded, true states have residuals of 1e-16 at most.
NODES, LENGTH = 10, 0.5
# The ends of [-1, 1] and the zeros of the derivative of Legendre's polynomial.
_LOBATTO = np.array([-1.0, *sorted(legendre.Legendre.basis(NODES - 1).deriv().roots()), 1.0])
# Beyond so many radians doubles are too far apart for nodes.
FARTHEST = 2.0**38


@dataclass(frozen=True, slots=True)
class Errors:
    """Errors of states by one measure at several times.

    units, condition and share (N,) are errors in units of 2^-53, condition numbers, and errors over
    their bound.
    """

    times: np.ndarray
    units: np.ndarray
    condition: np.ndarray
    share: np.ndarray

    @property
    def values(self) -> np.ndarray:
        """The errors at all times, in rad or relative.

        MEANINGS says which.
        """
        return self.units * ULP


def measure(
    reference: Reference, engine: Engine | Solver, bounds: Mapping[str, float] = BOUNDS
) -> dict[str, Errors]:
    """Measure the errors of an engine or a peer on a sample.

    Errors of states that it refuses are infinite.
    """
    times = np.array(reference.sample.times, dtype=float)
    try:
        with np.errstate(all="ignore"):
            found = _measured(reference, engine, times)
        return {
            name: replace(errors, share=errors.share * (BOUNDS[name] / bounds[name]))
            for name, errors in found.items()
        }
    # Engines refuse by a ValueError; an ArithmeticError is a fault, and counts the same.
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
    chord = _apart(q, reference.q)
    if not getattr(engine, "double_cover_sign", True):
        chord = np.minimum(chord, _apart(-q, reference.q))
    # The angle of the turn between, up to 2 pi.
    angle = 4 * np.arcsin(np.minimum(chord / 2, 1)) + 2 * reference.radius
    rates = _apart(omega, reference.omega) / lengths(reference.omega[0]) + reference.radius
    # |omega| dt/2 is allowed, and what |omega'| <= |omega|^2 adds to it.
    turned = lengths(omega, 0.0) * (later - times)
    jump = np.maximum(lengths(q_later - q, 0.0) - (turned + turned**2) / 2, 0.0)
    start, residuals = times == 0, list(map(residual, paths, q_paths, omega_paths))
    found = {
        "angle": _errors("angle", times, angle, reference.condition["angle"]),
        "omega": _errors("omega", times, rates, reference.condition["omega"]),
        "norm": _errors("norm", times, np.abs(np.linalg.norm(q, axis=-1) - 1)),
        "residual": _errors("residual", [path.nodes[0] for path in paths], residuals),
        "jump": _errors("jump", times, jump),
        "start": _errors("start", times[start], np.maximum(angle, rates)[start]),
    }
    # Peers have one entry point only.
    if entry_points.is_due(sample.index) and isinstance(
        engine, Engine | Steps | Singles | SingleSteps
    ):
        apart = entry_points.differences(engine, prepared, body, times, rate)
        found["entry_points"] = _errors("entry_points", [0.0] * len(apart), apart)
    found |= _drifts(sample, times, omega)
    # Without t = 0 among the times there is no start.
    return {name: errors for name, errors in found.items() if len(errors.times)}


def prepare(sample: Sample, engine: Engine | Solver) -> tuple[Prepared, Body | None]:
    """Prepare a sample's motion by an engine, and return it with its inputs as doubles.

    Instead of inputs that are not doubles it returns None.
    """
    state = (sample.inertia, sample.omega0, sample.attitude0)
    inertia, omega0, attitude0 = (np.array(values, dtype=float) for values in state)
    exactly = getattr(engine, "prepare_exactly", None)
    # Peers take doubles only.
    if exactly and not sample.in_doubles:
        return exactly(*sample.exact), None
    return engine.prepare(inertia, omega0, attitude0), (inertia, omega0, attitude0)


def _apart(given: np.ndarray, exact: np.ndarray) -> np.ndarray:
    """Return the distances of vectors from exact vectors given as sums of two doubles."""
    return lengths((given - exact[0]) - exact[1], 0.0)


def _drifts(sample: Sample, times: np.ndarray, omega: np.ndarray) -> dict[str, Errors]:
    """Return the relative drift of energy and squared momentum from their initial values.

    Its condition number is |omega| times the gradient over the value; both are free of scale.
    """
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
    """Return the `Errors` of a measure from the values at some times.

    NaN counts as infinite.
    """
    times, values = np.array(times, dtype=float), np.array(values, dtype=float)
    values = np.where(np.isnan(values), np.inf, values)
    condition = np.where(np.isnan(condition), 1.0, np.broadcast_to(condition, values.shape))
    share = values / (BOUNDS[name] * allowance)
    return Errors(times, values / ULP, condition, np.where(np.isinf(values), np.inf, share))


@dataclass(frozen=True, slots=True)
class Quadrature:
    """Quadrature rule over an interval of time.

    It has the times of the nodes (NODES,) and weights for exactly these times.
    """

    nodes: np.ndarray
    weights: np.ndarray

    @classmethod
    def over(cls, begin: float, rate: float) -> "Quadrature":
        """Create the quadrature rule that begins at a time and covers a given turn of the body.

        The turn is LENGTH rad at `rate` rad/s.  The rule begins earlier where doubles are too far
        apart for nodes.
        """
        begin = float(np.clip(begin, -FARTHEST / rate, FARTHEST / rate))
        nodes = begin + (_LOBATTO + 1) * (LENGTH / rate / 2)
        half = (nodes[-1] - nodes[0]) / 2
        places = (nodes - nodes[0]) / half - 1
        # Times are rounded to doubles: the weights are those of the rounded times.
        moments = np.zeros(NODES)
        moments[0] = 2
        weights = np.linalg.solve(legendre.legvander(places, NODES - 1).T, moments)
        return cls(nodes, weights * half)


def residual(quadrature: Quadrature, q: np.ndarray, omega: np.ndarray) -> float:
    """Return the residual of the integrated kinematic equation over a quadrature's interval.

    It is |q(end) - q(begin) - integral of q (0, omega)/2|, for the states at the nodes.
    """
    v = omega * quadrature.weights[:, None]
    scalar = -np.sum(q[:, 1:] * v, axis=-1, keepdims=True)
    turned = np.hstack([scalar, q[:, :1] * v + np.cross(q[:, 1:], v)])
    return float(np.linalg.norm(q[-1] - q[0] - np.sum(turned, axis=0) / 2))
