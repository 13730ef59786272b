"""Validation of the generated modules: strata of cases, oracles, error measures, reports."""

from rigidsym.validate.contestants import check_target
from rigidsym.validate.report import ValidationReport
from rigidsym.validate.validation import validate

__all__ = ["ValidationReport", "check_target", "validate"]
