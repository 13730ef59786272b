"""Fits: which free motion do observations show, how well, and which others?"""

from importlib import import_module
from typing import TYPE_CHECKING

from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.fitting.estimate import fit
    from rigidsym.fitting.found import Alternative, Fit, Prediction
    from rigidsym.fitting.observations import Attitudes, Directions, Modelled, Rates
    from rigidsym.fitting.tumbling import Periods, periods

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

# Imported at first use: the command line's help is cheap.
_HOMES = {
    "Alternative": "rigidsym.fitting.found",
    "Attitudes": "rigidsym.fitting.observations",
    "Directions": "rigidsym.fitting.observations",
    "Fit": "rigidsym.fitting.found",
    "Modelled": "rigidsym.fitting.observations",
    "Periods": "rigidsym.fitting.tumbling",
    "Prediction": "rigidsym.fitting.found",
    "Rates": "rigidsym.fitting.observations",
    "fit": "rigidsym.fitting.estimate",
    "periods": "rigidsym.fitting.tumbling",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'rigidsym.fitting' has no attribute {name!r}")
    require("rigidsym.fitting", "scipy")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
