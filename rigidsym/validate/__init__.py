"""Validation of the generated modules, and of a user's integrator.

Strata of cases, oracles, error measures, and reports.
"""

from rigidsym.validate.bounds import BOUNDS, MEANINGS
from rigidsym.validate.finding import Finding, measure_case
from rigidsym.validate.implementations import check_target
from rigidsym.validate.measure import Errors
from rigidsym.validate.peers import PEERS, Peer
from rigidsym.validate.report import Failure, ValidationReport, Worst
from rigidsym.validate.strata import STRATA, Sample, Stratum, draw
from rigidsym.validate.validation import examine, validate

__all__ = [
    "BOUNDS",
    "MEANINGS",
    "PEERS",
    "STRATA",
    "Errors",
    "Failure",
    "Finding",
    "Peer",
    "Sample",
    "Stratum",
    "ValidationReport",
    "Worst",
    "check_target",
    "draw",
    "examine",
    "measure_case",
    "validate",
]
