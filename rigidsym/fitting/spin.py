"""Do the observations show more than spin about an axis of the body?

Where they do not, nothing tells its ratios of inertia: small motions that a fit finds beside a spin
are those of the errors, and their periods mean nothing.
"""

from dataclasses import replace

import numpy as np
from scipy.stats import chi2

from rigidsym.fitting.alignment import aligned
from rigidsym.fitting.local import Local, local
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem

# That errors alone look like more than a spin.
_CHANCE = 1e-3


def spin(problem: Problem, best: Local, loss: str) -> Local | None:
    """The best spin, where errors explain what it leaves; else None.

    A spin has fewer parameters by those of shape and the rates across the axis.  What errors gain
    by these is chi2 of so many degrees of freedom, at the best of as many periods as can be told
    apart in the span of the observations.
    """
    names = problem.parameters.names
    axis = int(np.argmax(np.abs(best.point.omega)))
    across = [3 + k for k in range(3) if k != axis]
    kept = [k for k, x in enumerate(names) if not x.startswith("shape") and k not in across]
    omega = np.where(np.arange(3) == axis, best.point.omega, 0.0)
    one = Point(*(x[None] for x in (best.point.attitude, omega, best.point.moments,
                                    best.point.mount)))  # fmt: skip
    start = replace(aligned(problem, one)[0])
    found = local(problem, start, loss, np.eye(len(names))[:, kept])
    free = len(names) - len(kept) - (2 if problem.parameters.axes else 0)
    trials = max(1.0, float(np.linalg.norm(omega)) * problem.span / np.pi)
    gain = float(chi2.isf(_CHANCE / trials, max(free, 1)))
    return found if found.converged and found.cost <= best.cost + gain else None
