"""Exact torque-free motion of rigid bodies, derived symbolically and verified.

Quaternions are scalar first, unit, body to inertial: q' = q (0, omega) / 2 with omega in body axes
(rad/s), inertia in kg m^2 about principal axes, time in s.
"""

from typing import TYPE_CHECKING

from rigidsym._lazy import lazily
from rigidsym._version import __version__

if TYPE_CHECKING:
    from rigidsym._codegen import Generated, generate
    from rigidsym.errors import InputError, PrecisionError
    from rigidsym.fitting import fit
    from rigidsym.manoeuvre import plan
    from rigidsym.motion import TorqueFreeMotion, propagate
    from rigidsym.principal import PrincipalAxes, TensorMotion, principal_axes
    from rigidsym.solution._polhode import Regime
    from rigidsym.solution._symbolic import Symbolic, symbolic
    from rigidsym.splitting import Trajectory, integrate
    from rigidsym.steps import step

__all__ = [
    "Generated",
    "InputError",
    "PrecisionError",
    "PrincipalAxes",
    "Regime",
    "Symbolic",
    "TensorMotion",
    "TorqueFreeMotion",
    "Trajectory",
    "__version__",
    "fit",
    "generate",
    "integrate",
    "plan",
    "principal_axes",
    "propagate",
    "step",
    "symbolic",
]

# Modules are imported at first use too: `import rigidsym` and the help of the command are fast.
__getattr__, __dir__ = lazily(
    __name__,
    {
        "Generated": "rigidsym._codegen",
        "InputError": "rigidsym.errors",
        "PrecisionError": "rigidsym.errors",
        "PrincipalAxes": "rigidsym.principal",
        "Regime": "rigidsym.solution._polhode",
        "Symbolic": "rigidsym.solution._symbolic",
        "TensorMotion": "rigidsym.principal",
        "TorqueFreeMotion": "rigidsym.motion",
        "Trajectory": "rigidsym.splitting",
        "fit": "rigidsym.fitting",
        "generate": "rigidsym._codegen",
        "integrate": "rigidsym.splitting",
        "plan": "rigidsym.manoeuvre",
        "principal_axes": "rigidsym.principal",
        "propagate": "rigidsym.motion",
        "step": "rigidsym.steps",
        "symbolic": "rigidsym.solution._symbolic",
    },
)
