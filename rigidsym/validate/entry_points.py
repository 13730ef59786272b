"""The other ways to states: one time alone, a grid, a batch of bodies, many times at once; and what
callers do on the way.

All that an engine offers has to give what its states at given times are, within their errors.
"""

import math

import numpy as np

from rigidsym.engines import Engine, Prepared, States
from rigidsym.validate import callers
from rigidsym.validate.callers import Body
from rigidsym.validate.oracle import lengths
from rigidsym.validate.steps import Steps

# Two cases in so many are measured so, the first two of each stratum among them: its ends.
SHARE = 16
# Samples of a grid: engines begin anew within as many.
GRID = 130
# Times at once: engines work in blocks of fewer.
MANY = 10_000
# A body of no stratum, to be computed beside one.
OTHER_BODY, OTHER_RATES = np.array([1.0, 0.4, 0.8]), np.array([0.6, -0.64, 0.48])


def is_due(index: int) -> bool:
    """Whether a case of a stratum is measured so."""
    return index % SHARE in (0, 1)


def differences(
    engine: Engine | Steps, prepared: Prepared, body: Body | None, times: np.ndarray, rate: float
) -> np.ndarray:
    """For each way, the largest difference from the states at given times: of angle, and of rates
    over their size.

    body: inertia, rates and attitude as float64 arrays, or None where doubles do not say them.
    """
    if isinstance(engine, Steps):
        return np.array([_apart(*both) for both in engine.ways(prepared, times)])
    found = [
        _apart(_alone(engine, prepared, times), engine.states(prepared, times)),
        _apart(_grid(engine, prepared, rate), engine.states(prepared, _grid_times(rate))),
        _apart(_many(engine, prepared, times), engine.states(prepared, times)),
    ]
    if body is not None:
        found.append(_apart(_batch(engine, body, times), engine.states(prepared, times)))
        found += [_apart(*both) for both in callers.differing(engine, body, times)]
    return np.array(found)


def _alone(engine: Engine, prepared: Prepared, times: np.ndarray) -> States:
    states = [engine.states(prepared, float(t)) for t in times]
    return np.array([q for q, _ in states]), np.array([omega for _, omega in states])


def _grid_times(rate: float) -> np.ndarray:
    """About a radian apart, and exact: the step is a power of two."""
    return _step(rate) * np.arange(-1.0, GRID - 1)


def _grid(engine: Engine, prepared: Prepared, rate: float) -> States:
    return engine.grid(prepared, -_step(rate), _step(rate), GRID)


def _step(rate: float) -> float:
    return 2.0 ** -math.floor(math.log2(rate))


def _many(engine: Engine, prepared: Prepared, times: np.ndarray) -> States:
    """The first and the last of as many times as it takes."""
    copies = MANY // len(times) + 1
    q, omega = engine.states(prepared, np.tile(times, copies))
    return q[-len(times) :], omega[-len(times) :]


def _batch(engine: Engine, body: Body, times: np.ndarray) -> States:
    """The middle one of three bodies, between another one and itself at rest; at times that are
    not those of the others."""
    inertia, omega0, attitude0 = body
    moments = np.array([np.max(inertia) * OTHER_BODY, inertia, inertia])
    rates = np.array([np.max(np.abs(omega0)) * OTHER_RATES, omega0, 0 * omega0])
    attitudes = np.array([np.roll(attitude0, 1), attitude0, attitude0])
    own = np.array([times[::-1], times, 0 * times])
    q, omega = engine.propagate(moments, rates, attitudes, own)
    return q[1], omega[1]


def _apart(found: States, expected: States) -> float:
    """Angle between attitudes, and difference of rates over their size, the larger."""
    (q, omega), (q_there, omega_there) = found, expected
    angle = 2 * lengths(q - q_there, 0.0)
    relative = lengths(omega - omega_there, 0.0) / lengths(omega_there)
    return float(np.max(np.maximum(angle, relative)))
