"""Costs of the forms of the solution: theta functions, the third kind, Fourier series."""

from rigidsym.validate._forms.compare import COLUMNS, STRATA_COLUMNS, FormCosts, compare_forms

__all__ = ["COLUMNS", "STRATA_COLUMNS", "FormCosts", "compare_forms"]
