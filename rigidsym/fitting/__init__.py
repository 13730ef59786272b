"""Fits of torque-free motions to observations."""

from importlib import import_module
from typing import TYPE_CHECKING

from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.fitting._estimate import fit
    from rigidsym.fitting._fit import Fit
    from rigidsym.fitting._observations import Attitudes, Directions, Modelled, Rates
    from rigidsym.fitting._result import Alternative, Periods, Prediction, periods

__all__ = [
    "Alternative",
    "Attitudes",
    "Directions",
    "Fit",
    "Modelled",
    "Periods",
    "Prediction",
    "Rates",
    "fit",
    "periods",
]

# Modules by public name; they are imported at first use, which keeps the command's help fast.
_HOMES = {
    "fit": "estimate",
    "Fit": "fit",
    **dict.fromkeys(("Attitudes", "Directions", "Modelled", "Rates"), "observations"),
    **dict.fromkeys(("Alternative", "Periods", "Prediction", "periods"), "result"),
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'rigidsym.fitting' has no attribute {name!r}")
    require("rigidsym.fitting", "scipy")
    return getattr(import_module(f"rigidsym.fitting._{_HOMES[name]}"), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
