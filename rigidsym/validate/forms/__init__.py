"""What the forms of the solution cost as flown: theta functions, the third kind, Fourier series."""

from rigidsym.validate.forms.compare import COLUMNS, FormCosts, compare_forms

__all__ = ["COLUMNS", "FormCosts", "compare_forms"]
