"""Injection of faults into generated modules, to test that the validation detects them."""

from rigidsym.validate.faults._by_hand import by_hand
from rigidsym.validate.faults._drawn import all_faults
from rigidsym.validate.faults._fault import KINDS, TARGETS, Fault, StaleFaultError
from rigidsym.validate.faults._injection import FaultReport, Outcome, inject

__all__ = [
    "KINDS",
    "TARGETS",
    "Fault",
    "FaultReport",
    "Outcome",
    "StaleFaultError",
    "all_faults",
    "by_hand",
    "inject",
]
