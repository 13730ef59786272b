"""What ways would cost if bursts took no time and nothing disturbed: impulses, N m s."""

from collections.abc import Mapping

import numpy as np

from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre.comparison.cases import Case
from rigidsym.manoeuvre.comparison.collocation import Model
from rigidsym.manoeuvre.transfer import Transfer

FAMILIES = 10
"Natural motions among which that of the least sum over axes is looked for."
_SAMPLES = 2001


def ideal(case: Case, model: Model, transfer: Transfer) -> Mapping[str, float]:
    """Integrals of |torque|, summed over the axes, N m s, by way."""
    several = solve(case.manoeuvre, FAMILIES).transfers
    return {
        "natural": _natural(case, model, transfer),
        f"natural, best of {FAMILIES}": min(_natural(case, model, one) for one in several),
        "eigenaxis": _eigenaxis(case, model),
    }


def _natural(case: Case, model: Model, transfer: Transfer) -> float:
    """Two bursts; wheels have to make the gyroscopic torque of the motion, too."""
    bursts = float(np.abs(transfer.bursts).sum())
    if model is Model.THRUSTERS:
        return bursts
    t = np.linspace(0, case.duration, _SAMPLES)
    _, omega = transfer.motion(t)
    return bursts + float(np.trapezoid(_gyroscopic(case.inertia, omega), t))


def _eigenaxis(case: Case, model: Model) -> float:
    """Two bursts at constant rate; thrusters have to cancel its gyroscopic torque."""
    omega = case.rotation_vector / case.duration
    bursts = 2 * float(np.abs(case.inertia * omega).sum())
    if model is Model.WHEELS:
        return bursts
    return bursts + case.duration * float(_gyroscopic(case.inertia, omega))


def _gyroscopic(inertia: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """|omega x I omega| (...), N m, summed over the axes."""
    return np.abs(np.cross(omega, inertia * omega)).sum(axis=-1)
