"""Manoeuvres along natural motions: planned, flown, compared."""

from importlib import import_module
from typing import TYPE_CHECKING

from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.manoeuvre.manoeuvre import Limits, Manoeuvre
    from rigidsym.manoeuvre.planning import Plan, directions_of, plan, solve
    from rigidsym.manoeuvre.transfer import Transfer

__all__ = ["Limits", "Manoeuvre", "Plan", "Transfer", "directions_of", "plan", "solve"]

# Imported at first use: the command line imports this package for its help, which is to be quick.
_HOMES = {
    "Limits": "rigidsym.manoeuvre.manoeuvre",
    "Manoeuvre": "rigidsym.manoeuvre.manoeuvre",
    "Plan": "rigidsym.manoeuvre.planning",
    "Transfer": "rigidsym.manoeuvre.transfer",
    "directions_of": "rigidsym.manoeuvre.planning",
    "plan": "rigidsym.manoeuvre.planning",
    "solve": "rigidsym.manoeuvre.planning",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'rigidsym.manoeuvre' has no attribute {name!r}")
    require("rigidsym.manoeuvre", "scipy")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
