"""Comparison of the cost and the errors of three forms of the solution."""

from rigidsym.validate._forms.compare import COLUMNS, STRATA_COLUMNS, FormCosts, compare_forms

__all__ = ["COLUMNS", "STRATA_COLUMNS", "FormCosts", "compare_forms"]
