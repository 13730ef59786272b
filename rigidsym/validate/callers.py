"""What callers do: they reuse arrays, have outputs that are inputs, and mix bodies of all kinds.

None of it may change a state.
"""

from collections.abc import Iterator

import numpy as np

from rigidsym.engines import Engine, States, batches

# Moments and rates, over some power of two, of what else may be in a batch.
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
# Inertia (3,), rates (3,) and attitude (4,) as float64.
Body = tuple[np.ndarray, np.ndarray, np.ndarray]
# The largest exponent by which all of these may grow, or shrink.
LARGEST = 1020


def differing(engine: Engine, body: Body, times: np.ndarray) -> Iterator[tuple[States, States]]:
    """For each thing that callers do, the states they get, and the states at the same times."""
    asked = np.append(times, 0.0)
    prepared = engine.prepare(*body)
    yield _overwritten(engine, body, asked), engine.states(prepared, asked)
    for name in range(len(body)):
        if states := _aliased(engine, body, asked[-2:], name):
            yield states, engine.states(prepared, asked[-2:])
    yield _mixed(engine, body, times)


def _overwritten(engine: Engine, body: Body, times: np.ndarray) -> States:
    """The states of a prepared motion whose caller writes over what it was made from."""
    given = [array.copy() for array in body]
    prepared = engine.prepare(*given)
    for array in given:
        array[:] = 99.0
    return engine.states(prepared, times)


def _aliased(engine: Engine, body: Body, times: np.ndarray, name: int) -> States | None:
    """The states of the last of some bodies, whose output begins with their input number `name`;
    None where that is refused."""
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
    """The states of a body among others, and its own; NaN on both sides where they are refused."""
    inertia, omega0, attitude0 = body
    moments, rates = (COMPANY[:, k] * _size(x) for k, x in enumerate((inertia, omega0)))
    moments = np.vstack([batches.possible(moments, False, lenient=True), inertia])
    rates = np.vstack([rates, omega0])
    out = _written(len(moments), len(times))
    q, omega = engine.propagate(moments, rates, attitude0, times, out, errors="nan")
    none = np.isnan(q).all(axis=(1, 2)) & np.isnan(omega).all(axis=(1, 2))
    wanted = [k in REFUSED for k in range(len(moments))]
    alone = engine.states(engine.prepare(*body), times)
    if none.tolist() != wanted:
        return (np.full_like(alone[0], np.nan), alone[1]), alone
    others = [k for k, refused in enumerate(wanted) if not refused]
    expected = [
        engine.states(engine.prepare(moments[k], rates[k], attitude0), times) for k in others
    ]
    found = [(q[k], omega[k]) for k in others]
    return _joined(found), _joined(expected)


def _size(values: np.ndarray) -> float:
    """A power of two, so that regimes stay what they are: that of the largest of these numbers, or
    the nearest that COMPANY times it is no infinity and has all of its digits."""
    exponent = int(np.frexp(np.max(np.abs(values)))[1]) - 1
    return 2.0 ** max(-LARGEST, min(exponent, LARGEST))


def _written(bodies: int, times: int) -> States:
    """Outputs full of numbers: memory anew may hold the NaN of an earlier call, or none."""
    return np.ones((bodies, times, 4)), np.ones((bodies, times, 3))


def _joined(states: list[States]) -> States:
    return np.concatenate([q for q, _ in states]), np.concatenate([omega for _, omega in states])
