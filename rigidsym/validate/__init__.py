"""Validation of the generated modules and of users' integrators.

Strata of cases, oracles, error measures, and reports.
"""

from rigidsym._lazy import lazily
from rigidsym.validate._bounds import BOUNDS, MEANINGS
from rigidsym.validate._finding import Finding, measure_case
from rigidsym.validate._implementations import check_target
from rigidsym.validate._measure import Errors
from rigidsym.validate._report import Failure, ValidationReport, Worst
from rigidsym.validate._validation import examine, validate
from rigidsym.validate.peers import PEERS, Peer
from rigidsym.validate.strata import STRATA, Sample, Stratum, draw

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

# `faults` is imported at first use.
__getattr__, __dir__ = lazily(__name__, {})
