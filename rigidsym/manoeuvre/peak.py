"""The largest body rate of a motion, from the few times at which it can be."""

import numpy as np

from rigidsym.manoeuvre.problem import IDENTITY, Problem
from rigidsym.manoeuvre.transit import phases


def peaks(problem: Problem, rates: np.ndarray) -> np.ndarray:
    """Largest |omega| (N,) in time 1 of motions that begin with rates (N, 3) and arrive.

    On a polhode |omega|^2 is linear in sn^2, so that its extremes are at the ends of the motion
    and where the argument of Jacobi's functions passes a multiple of K(m) (facts regular.speed,
    regular.speed_rate).
    """
    sizes = problem.momenta(rates)
    momenta = problem.inertia * rates / np.where(sizes > 0, sizes, 1.0)[:, None]
    where = phases(problem, momenta)
    with np.errstate(divide="ignore", invalid="ignore"):
        passed = np.ceil(where.u / where.quarter)[:, None] + np.arange(2)
        times = (passed * where.quarter[:, None] - where.u[:, None]) / (where.speed * sizes)[
            :, None
        ]
    # Times 1 stand for those that never come, or come too late.
    times = np.concatenate([times, np.ones((len(rates), 1))], axis=1)
    times = np.where((times > 0) & (times < 1), times, 1.0)
    _, later = problem.engine.propagate(
        problem.inertia, rates[:, None] * times[..., None], IDENTITY, np.ones(1)
    )
    reached = np.linalg.norm(later[..., 0, :], axis=-1) / times
    return np.maximum(np.linalg.norm(rates, axis=1), reached.max(axis=1))
