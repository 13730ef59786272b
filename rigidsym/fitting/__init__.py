"""Fits of torque-free motions to observations."""

from typing import TYPE_CHECKING

from rigidsym._lazy import lazily
from rigidsym.errors import require

if TYPE_CHECKING:
    from rigidsym.fitting._estimate import fit
    from rigidsym.fitting._files import ObservationFile, load
    from rigidsym.fitting._fit import Fit
    from rigidsym.fitting._observations import Attitudes, Directions, Modelled, Rates
    from rigidsym.fitting._result import Alternative, Periods, Prediction, periods

__all__ = [
    "Alternative",
    "Attitudes",
    "Directions",
    "Fit",
    "Modelled",
    "ObservationFile",
    "Periods",
    "Prediction",
    "Rates",
    "fit",
    "load",
    "periods",
]

# At first use, which keeps the command's help fast.
__getattr__, __dir__ = lazily(
    __name__,
    {
        "fit": "._estimate",
        "Fit": "._fit",
        **dict.fromkeys(("ObservationFile", "load"), "._files"),
        **dict.fromkeys(("Attitudes", "Directions", "Modelled", "Rates"), "._observations"),
        **dict.fromkeys(("Alternative", "Periods", "Prediction", "periods"), "._result"),
    },
    lambda: require("rigidsym.fitting", "scipy"),
)
