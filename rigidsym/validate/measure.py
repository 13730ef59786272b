"""How wrong the generated module is on one sample, against the derivation at many digits."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from rigidsym.engines import Engine
from rigidsym.motion import TorqueFreeMotion
from rigidsym.validate.strata import Sample

ULP = 2.0**-53
# The documented bound on angle (rad) and rates (relative), of bodies that can exist, at all times.
BOUND = 2e-15


@dataclass(frozen=True, slots=True)
class Measurement:
    """The worst errors of one sample, in units of 2^-53, and the largest part of the bound used.

    angle: rotation angle error with the sign of q; omega: |difference| / |omega|; norm: of q;
    energy and momentum: relative drift of H and K^2.  share: angle or omega over BOUND.
    """

    sample: Sample
    states: int
    angle: float
    omega: float
    norm: float
    energy: float
    momentum: float
    share: float
    worst_time: float


def measure(sample: Sample, digits: int, engine: Engine) -> Measurement:
    """Run a generated module and the derivation on a sample and compare."""
    state = (sample.inertia, sample.omega0, sample.attitude0)
    motion = TorqueFreeMotion(*state, allow_nonphysical=True)
    exact = any(isinstance(x, Fraction) for x in (*sample.inertia, *sample.omega0))
    plan = engine.exact_plan(*motion.exact.values()) if exact else engine.plan(*state)
    q, omega = engine.states(plan, np.array(sample.times))
    exact_q, exact_omega = motion.precise(list(map(Fraction, sample.times)), digits)
    angle = np.array([_distance(a, b) * 2 for a, b in zip(q, exact_q, strict=True)])
    size = [float(math.hypot(*map(float, row))) or 1.0 for row in exact_omega]
    rate = np.array([_distance(a, b) for a, b in zip(omega, exact_omega, strict=True)]) / size
    both = np.maximum(angle, rate) / BOUND
    worst = int(np.argmax(both))
    energy, momentum = _drift(sample, omega)
    return Measurement(
        sample,
        len(sample.times),
        _units(angle),
        _units(rate),
        _units(np.abs(np.linalg.norm(q, axis=-1) - 1)),
        energy,
        momentum,
        float(both[worst]),
        sample.times[worst],
    )


def _distance(given: Sequence[float], exact: Sequence[Any]) -> float:
    """|given - exact|, the difference taken before rounding; infinite where given is no number."""
    if not np.all(np.isfinite(given)):
        return math.inf
    return math.hypot(*(float(float(a) - b) for a, b in zip(given, exact, strict=True)))


def _units(errors: np.ndarray) -> float:
    return float(np.max(errors, initial=0.0)) / ULP


def _drift(sample: Sample, omega: np.ndarray) -> tuple[float, float]:
    """Relative drift of H and K^2 from their values at t = 0, free of scale."""
    inertia, omega0 = (np.array(x, dtype=float) for x in (sample.inertia, sample.omega0))
    c, largest = inertia / np.max(inertia), np.max(np.abs(omega0)) or 1.0
    w, w0 = omega / largest, omega0 / largest
    drifts = []
    for weight in (c, c * c):
        before, after = float(weight @ (w0 * w0)), (w * w) @ weight
        drifts.append(_units(np.abs(after - before) / (before or 1.0)))
    return drifts[0], drifts[1]
