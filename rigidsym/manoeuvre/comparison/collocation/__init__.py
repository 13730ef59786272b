"""Time-fixed optimal control of a rigid body by direct collocation, solved by CasADi and IPOPT.

Units: time 1 for the duration, moments of inertia over the largest, so that rates are in 1 over
the duration, impulses in the largest moment over the duration; attitudes from the start's axes.
"""

from rigidsym.errors import require

require("optimal control", "casadi", extra="optimal")

from rigidsym.manoeuvre.comparison.collocation.guess import Guess, guessed  # noqa: E402
from rigidsym.manoeuvre.comparison.collocation.solver import (  # noqa: E402
    Optimum,
    Posed,
    optimum,
)
from rigidsym.manoeuvre.comparison.collocation.task import Cost, Model, Task  # noqa: E402

__all__ = ["Cost", "Guess", "Model", "Optimum", "Posed", "Task", "guessed", "optimum"]
