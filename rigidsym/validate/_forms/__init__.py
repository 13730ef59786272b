"""Comparison of three forms of the solution by cost and error."""

from rigidsym.validate._forms.compare import COLUMNS, STRATA_COLUMNS, FormCosts, compare_forms

__all__ = ["COLUMNS", "STRATA_COLUMNS", "FormCosts", "compare_forms"]
