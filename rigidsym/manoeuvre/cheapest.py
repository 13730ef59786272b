"""The cheapest motions within the limits."""

import numpy as np

from rigidsym.manoeuvre import one_parameter_families
from rigidsym.manoeuvre.bursts import Bursts
from rigidsym.manoeuvre.families import families, least

_GROWTH = 1.5
_ROUNDING = 1e-12


def cheapest(bursts: Bursts, duration: float, count: int) -> np.ndarray:
    """The cheapest motions within the limits, rates (N, 3), N at most `count`.

    From rest to rest a motion costs twice its momentum (facts manoeuvre.first_burst,
    manoeuvre.last_burst), and never less than that less what the spins before and after can save;
    so all those up to a cost are known when all those up to a momentum are.
    """
    spins = bursts.spin * duration
    most = bursts.most(duration)
    bound = min(least(bursts.problem) + spins, most)
    while True:
        known = families(bursts.problem, bound)
        if one_parameter_families.matter(bursts):
            known = one_parameter_families.cheapest(bursts, known, duration)
        allowed = known[bursts.allowed(known, duration)]
        costs = bursts.sizes(allowed, duration).sum(axis=1)
        order = np.argsort(costs, kind="stable")[:count]
        found = costs[order]
        needed = (found[-1] + spins) / 2 if len(found) == count else np.inf
        if min(needed, most) <= bound * (1 + _ROUNDING):
            return allowed[order]
        larger = _GROWTH * bound + bursts.problem.inertia.min()
        bound = min(needed, most) if needed < np.inf else min(larger, most)
