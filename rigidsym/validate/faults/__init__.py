"""Faults put into the generated modules on purpose, to see that the validation notices them."""

from rigidsym.validate.faults.fault import KINDS, Fault, StaleFaultError
from rigidsym.validate.faults.injection import inject
from rigidsym.validate.faults.report import FaultReport, Outcome
from rigidsym.validate.faults.tables import all_faults

__all__ = [
    "KINDS",
    "Fault",
    "FaultReport",
    "Outcome",
    "StaleFaultError",
    "all_faults",
    "inject",
]
