"""Validation of the generated modules: strata of cases, error measures, reports."""

from rigidsym.validate.report import ValidationReport, check_target, validate

__all__ = ["ValidationReport", "check_target", "validate"]
