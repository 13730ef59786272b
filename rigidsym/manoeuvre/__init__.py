"""Attitude manoeuvres along torque-free motions: planning, simulated flight, comparison."""

from importlib import import_module
from typing import TYPE_CHECKING

from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.manoeuvre._manoeuvre import Limits, Manoeuvre
    from rigidsym.manoeuvre._planning import Plan, directions_of, plan, solve
    from rigidsym.manoeuvre._transfer import Transfer

__all__ = ["Limits", "Manoeuvre", "Plan", "Transfer", "directions_of", "plan", "solve"]

# Imported at first use: the command line imports this package for its help, which is to be quick.
_HOMES = {
    "Limits": "rigidsym.manoeuvre._manoeuvre",
    "Manoeuvre": "rigidsym.manoeuvre._manoeuvre",
    "Plan": "rigidsym.manoeuvre._planning",
    "Transfer": "rigidsym.manoeuvre._transfer",
    "directions_of": "rigidsym.manoeuvre._planning",
    "plan": "rigidsym.manoeuvre._planning",
    "solve": "rigidsym.manoeuvre._planning",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'rigidsym.manoeuvre' has no attribute {name!r}")
    require("rigidsym.manoeuvre", "scipy")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
