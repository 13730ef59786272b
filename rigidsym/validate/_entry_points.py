"""Checks that all ways to call an engine return the same states.

Entry points are single times, grids, batches, and many times at once.  Callers also reuse
arrays, pass outputs that are inputs, and mix bodies of all kinds.  All ways have to give the states
at given times, within their errors.
"""

import math
from collections.abc import Iterator

import numpy as np

from rigidsym._engines import Engine, Prepared, States, batches
from rigidsym.validate._implementations import Steps
from rigidsym.validate._oracle import lengths
from rigidsym.validate._singles import Singles, SingleSteps

# Inertia (3,), rates (3,) and attitude (4,) as float64.
Body = tuple[np.ndarray, np.ndarray, np.ndarray]
# Two cases in so many are measured, the first two of each stratum, its ends, among them.
SHARE = 16
# Samples of a grid: engines restart their recurrences within as many.
GRID = 130
# Times at once: engines work in blocks of fewer.
MANY = 10_000
# A body of no stratum, as the neighbour of one in a batch.
OTHER_BODY, OTHER_RATES = np.array([1.0, 0.4, 0.8]), np.array([0.6, -0.64, 0.48])
# Moments and rates, over some power of two, of other bodies in a batch.
COMPANY = np.array(
    [
        # A flat body, but for rounding, one that cannot exist, and one whose moment is negative.
        [[1, 2, 3.0000000000000004], [0.6, -0.64, 0.48]],
        [[1, 1, 5], [0.6, -0.64, 0.48]],
        [[1, -2, 2], [0.6, -0.64, 0.48]],
        # Sphere, symmetric body, spin, rest, separatrix, and rates that are no numbers.
        [[1, 1, 1], [0.6, -0.64, 0.48]],
        [[2, 2, 1], [0.6, -0.64, 0.48]],
        [[1, 2, 2.5], [0, 0.5, 0]],
        [[1, 2, 2.5], [0, 0, 0]],
        [[3, 4, 6], [1, 0.5, 0.5]],
        [[1, 2, 2.5], [np.nan, 0.5, 0]],
    ]
)
REFUSED = (1, 2, 8)
# The largest exponent by which all of these may grow, or shrink.
LARGEST = 1020


def is_due(index: int) -> bool:
    """Return True if an engine's entry points are compared in the case with a given index."""
    return index % SHARE in (0, 1)


def differences(
    engine: Engine | Steps | Singles | SingleSteps,
    prepared: Prepared,
    body: Body | None,
    times: np.ndarray,
    rate: float,
) -> np.ndarray:
    """Return, for each way to call an engine, the largest difference from the expected states.

    Differences are of angle, and of rates over their size.  body: inertia, rates and attitude as
    float64 arrays, or None where doubles are not exact.
    """
    if isinstance(engine, Steps | Singles | SingleSteps):
        return np.array([_apart(*both) for both in engine.ways(prepared, times)])
    expected = engine.states(prepared, times)
    alone = [engine.states(prepared, float(t)) for t in times]
    # About a radian apart, and exact: the step is a power of two.
    step = 2.0 ** -math.floor(math.log2(rate))
    copies = MANY // len(times) + 1
    many = engine.states(prepared, np.tile(times, copies))
    ways = [
        ((np.array([q for q, _ in alone]), np.array([omega for _, omega in alone])), expected),
        (
            engine.grid(prepared, -step, step, GRID),
            engine.states(prepared, step * np.arange(-1.0, GRID - 1)),
        ),
        ((many[0][-len(times) :], many[1][-len(times) :]), expected),
    ]
    if body is not None:
        ways.append((_batch(engine, body, times), expected))
        ways += by_callers(engine, body, times)
    return np.array([_apart(*both) for both in ways])


def _batch(engine: Engine, body: Body, times: np.ndarray) -> States:
    """Compute the states of a body in a batch of three bodies with different times.

    The others are another body, and the body itself at rest.
    """
    inertia, omega0, attitude0 = body
    moments = np.array([np.max(inertia) * OTHER_BODY, inertia, inertia])
    rates = np.array([np.max(np.abs(omega0)) * OTHER_RATES, omega0, 0 * omega0])
    attitudes = np.array([np.roll(attitude0, 1), attitude0, attitude0])
    own = np.array([times[::-1], times, 0 * times])
    q, omega = engine.propagate(moments, rates, attitudes, own)
    return q[1], omega[1]


def _apart(found: States, expected: States) -> float:
    """Return the largest difference between two arrays of states.

    It is an angle between attitudes, or a relative difference of rates.
    """
    (q, omega), (q_there, omega_there) = found, expected
    angle = 2 * lengths(q - q_there, 0.0)
    relative = lengths(omega - omega_there, 0.0) / lengths(omega_there)
    return float(np.max(np.maximum(angle, relative)))


def by_callers(engine: Engine, body: Body, times: np.ndarray) -> Iterator[tuple[States, States]]:
    """Call an engine in several ways, and yield pairs of computed and expected states."""
    asked = np.append(times, 0.0)
    prepared = engine.prepare(*body)
    # The caller overwrites the arrays that it passed.
    given = [array.copy() for array in body]
    kept = engine.prepare(*given)
    for array in given:
        array[:] = 99.0
    yield engine.states(kept, asked), engine.states(prepared, asked)
    for name in range(len(body)):
        if states := _aliased(engine, body, asked[-2:], name):
            yield states, engine.states(prepared, asked[-2:])
    yield _mixed(engine, body, times)


def _aliased(engine: Engine, body: Body, times: np.ndarray, name: int) -> States | None:
    """Compute states into an output array that shares memory with an input.

    Returns None where that is refused.
    """
    count = 5
    given = [np.tile(array, (count, 1)) for array in body]
    q, omega = np.zeros((count, len(times), 4)), np.zeros((count, len(times), 3))
    shared = (q if given[name].shape[1] == 4 else omega).reshape(-1, given[name].shape[1])[:count]
    shared[:], given[name] = given[name], shared
    try:
        engine.propagate(given[0], given[1], given[2], times, (q, omega))
    except ValueError:
        return None
    return q[-1], omega[-1]


def _mixed(engine: Engine, body: Body, times: np.ndarray) -> tuple[States, States]:
    """Compute states in a batch with invalid bodies, and again for each valid body alone."""
    inertia, omega0, attitude0 = body
    moments, rates = (COMPANY[:, k] * _size(x) for k, x in enumerate((inertia, omega0)))
    moments = np.vstack([batches.possible(moments, False, lenient=True), inertia])
    rates = np.vstack([rates, omega0])
    # Outputs full of numbers: new memory may hold the NaN of an earlier call.
    shape = len(moments), len(times)
    out = np.ones((*shape, 4)), np.ones((*shape, 3))
    q, omega = engine.propagate(moments, rates, attitude0, times, out, errors="nan")
    none = np.isnan(q).all(axis=(1, 2)) & np.isnan(omega).all(axis=(1, 2))
    wanted = [k in REFUSED for k in range(len(moments))]
    alone = engine.states(engine.prepare(*body), times)
    if none.tolist() != wanted:
        return (np.full_like(alone[0], np.nan), alone[1]), alone
    others = [k for k, refused in enumerate(wanted) if not refused]
    found = [(q[k], omega[k]) for k in others]
    expected = [
        engine.states(engine.prepare(moments[k], rates[k], attitude0), times) for k in others
    ]
    return _joined(found), _joined(expected)


def _size(values: np.ndarray) -> float:
    """Return a power of two near the largest of several numbers.

    Scaling by it does not change regimes.  COMPANY times it is finite and has all of its digits.
    """
    exponent = int(np.frexp(np.max(np.abs(values)))[1]) - 1
    return 2.0 ** max(-LARGEST, min(exponent, LARGEST))


def _joined(states: list[States]) -> States:
    return np.concatenate([q for q, _ in states]), np.concatenate([omega for _, omega in states])
