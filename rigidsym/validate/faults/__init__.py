"""Faults put into the generated modules on purpose, to see that the validation notices them."""

from rigidsym.validate.faults.drawn import all_faults
from rigidsym.validate.faults.fault import BY_HAND, KINDS, Fault, StaleFaultError
from rigidsym.validate.faults.injection import FaultReport, Outcome, inject

__all__ = [
    "BY_HAND",
    "KINDS",
    "Fault",
    "FaultReport",
    "Outcome",
    "StaleFaultError",
    "all_faults",
    "inject",
]
