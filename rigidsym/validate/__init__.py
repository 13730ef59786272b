"""Validation of the generated modules: strata of cases, error measures, reports."""

from rigidsym.validate.report import ValidationReport, validate

__all__ = ["ValidationReport", "validate"]
