"""Many steps in one call of C, for the torques that it knows."""

import numpy as np

from rigidsym import engines
from rigidsym.engines import Kicks, arrays
from rigidsym.splitting.methods import Method
from rigidsym.splitting.orbits import KeplerOrbit
from rigidsym.splitting.state import State
from rigidsym.splitting.torques import DirectionTorque

# Kicks of bodies in one call, some hundredths of a second: Ctrl-C is heard in between.
_AT_ONCE = 1 << 18


def kicks(
    inertia: np.ndarray, torque: DirectionTorque, method: Method, shape: tuple[int, ...]
) -> Kicks:
    """A torque on bodies whose states have a leading shape."""
    source = torque.source
    on_orbit = isinstance(source, KeplerOrbit)
    return Kicks(
        inertia=arrays.row_or_rows(inertia, shape),
        coefficients=arrays.row_or_rows(torque.coefficients, shape),
        vector=None if on_orbit else arrays.row_or_rows(source, shape),
        orbit=source.numbers if on_orbit else None,
        drifts=np.array(method.drifts),
        kicks=np.array(method.kicks),
        more=torque.more,
    )


def advance(
    found: Kicks, state: State, begin: float, step: float, numbers: tuple[int, int]
) -> State:
    """The states after whole steps; raises EngineError where C's engine has none, or refuses."""
    shape, (first, last) = state.omega.shape[:-1], numbers
    q, omega = (np.array(arrays.rows(x, shape)) for x in (state.q, state.omega))
    integrator = engines.integrator("c")
    if integrator is None:
        raise engines.EngineError("engine", "has no compiler")
    some = max(1, _AT_ONCE // (len(q) * len(found.kicks)))
    for start in range(first, last, some):
        span = begin, step, start, min(start + some, last)
        integrator.integrate(found, span, q, omega)
    return State(q.reshape(*shape, 4), omega.reshape(*shape, 3))
