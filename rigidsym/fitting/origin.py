"""From the state at a problem's epoch to the motion from t = 0 that users have."""

from dataclasses import replace

import numpy as np

from rigidsym.errors import InputError
from rigidsym.fitting.found import Alternative
from rigidsym.fitting.parameters import Point
from rigidsym.fitting.problem import Problem
from rigidsym.fitting.states import motion
from rigidsym.motion import TorqueFreeMotion

# Of the state at t = 0 beyond doubles, next to a separatrix: the first that is enough, or the last.
_DIGITS = (30, 60)
# Of a residual, in units of its error: what the way to t = 0 and back may change.
_SLIGHT = 1e-3


def solved(posed: Problem, point: Point, size: float | None) -> Alternative:
    """The motion of a point, its largest moment of a size where nothing tells it, and chi2."""
    if posed.parameters.shape and posed.prior is None:
        point = replace(point, moments=point.moments / point.moments.max() * (size or 1.0))
    residuals = posed.residuals(point)
    chi2 = float(np.sum(residuals**2)) if np.isfinite(residuals).all() else np.inf
    return Alternative(_from_zero(posed, point, residuals), point, chi2)


def _from_zero(posed: Problem, point: Point, residuals: np.ndarray) -> TorqueFreeMotion:
    """With t = 0 instead of the epoch, in as many digits as the observations can tell.

    Next to a separatrix doubles at t = 0 are other motions by then.
    """
    amid = motion(point)
    if posed.epoch == 0 or not np.isfinite(residuals).all():
        return amid
    found = _in_doubles(amid, posed.epoch)
    for digits in _DIGITS:
        if found is not None and _shows(posed, point, found, residuals):
            break
        q, omega = amid.precise(-posed.epoch, digits)
        found = amid.replace(omega0=tuple(omega), attitude0=tuple(q))
    return found or amid


def _in_doubles(amid: TorqueFreeMotion, epoch: float) -> TorqueFreeMotion | None:
    """None where doubles do not reach t = 0."""
    try:
        q, omega = amid(-epoch)
    except InputError:
        return None
    return amid.replace(omega0=omega.tolist(), attitude0=q.tolist())


def _shows(posed: Problem, point: Point, found: TorqueFreeMotion, residuals: np.ndarray) -> bool:
    """Whether the motion has the residuals of the point."""
    try:
        missed = posed.missed(point, *found(posed.times))
    except InputError:
        return False
    return bool(np.max(np.abs(missed - residuals)) < _SLIGHT)
