"""Injection of faults into generated modules, to test that the validation detects them."""

from rigidsym.validate.faults._drawn import all_faults
from rigidsym.validate.faults._fault import BY_HAND, KINDS, Fault, StaleFaultError
from rigidsym.validate.faults._injection import FaultReport, Outcome, inject

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
