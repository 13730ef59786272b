"""Attitude manoeuvres along torque-free motions: planning, simulated flight, comparison."""

from typing import TYPE_CHECKING

from rigidsym._lazy import lazily
from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.manoeuvre._manoeuvre import Limits, Manoeuvre
    from rigidsym.manoeuvre._planning import Plan, directions_of, plan, solve
    from rigidsym.manoeuvre._transfer import Transfer

__all__ = ["Limits", "Manoeuvre", "Plan", "Transfer", "directions_of", "plan", "solve"]

# At first use: the command line imports this package for its help, which is to be quick.
__getattr__, __dir__ = lazily(
    __name__,
    {
        **dict.fromkeys(("Limits", "Manoeuvre"), "._manoeuvre"),
        **dict.fromkeys(("Plan", "directions_of", "plan", "solve"), "._planning"),
        "Transfer": "._transfer",
    },
    lambda: require("rigidsym.manoeuvre", "scipy"),
)
