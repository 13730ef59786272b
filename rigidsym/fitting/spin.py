"""Do the observations show more than spin about an axis of the body?

Where they do not, nothing tells its ratios of inertia: small motions that a fit finds beside a spin
are those of the errors, and their periods mean nothing.
"""

from dataclasses import replace

import numpy as np
from scipy.stats import chi2

from rigidsym.fitting.alignment import aligned
from rigidsym.fitting.local import Local, local
from rigidsym.fitting.parameters import IDENTITY, Point
from rigidsym.fitting.problem import Problem
from rigidsym.quaternions import product

# That errors alone look like more than a spin.
_CHANCE = 1e-3


def spin(problem: Problem, best: Local, loss: str) -> Local | None:
    """The best spin, where errors explain what it leaves; else None.

    A spin has fewer parameters by those of shape and the rates across the axis.  What errors gain
    by these is chi2 of so many degrees of freedom, at the best of as many periods as can be told
    apart in the span of the observations.
    """
    if not np.isfinite(best.cost):
        return None
    names = problem.parameters.names
    axis = int(np.argmax(np.abs(best.point.omega)))
    across = [3 + k for k in range(3) if k != axis]
    kept = [k for k, x in enumerate(names) if not x.startswith("shape") and k not in across]
    start = _about(axis, best.point, problem.parameters.axes)
    start = aligned(problem, start.repeated())[0]
    found = local(problem, start, loss, np.eye(len(names))[:, kept])
    free = len(names) - len(kept) - (2 if problem.parameters.axes else 0)
    trials = max(1.0, float(np.linalg.norm(start.omega)) * problem.span / np.pi)
    gain = float(chi2.isf(_CHANCE / trials, max(free, 1)))
    return found if found.converged and found.cost <= best.cost + gain else None


def _about(axis: int, point: Point, anywhere: bool) -> Point:
    """The spin about one of the principal axes; which lies where the rates are if it may."""
    omega = np.where(np.arange(3) == axis, point.omega, 0.0)
    if not anywhere:
        return replace(point, omega=omega)
    size = np.linalg.norm(point.omega)
    omega *= size / max(np.linalg.norm(omega), 1e-300)
    # The shortest rotation from one to the other, whose cosine is at least 1/sqrt(3).
    across = np.concatenate([[size**2 + omega @ point.omega], np.cross(omega, point.omega)])
    turn = across / max(np.linalg.norm(across), 1e-300)
    mount = product(point.mount, turn if size else IDENTITY)
    return replace(point, omega=omega, mount=mount)
