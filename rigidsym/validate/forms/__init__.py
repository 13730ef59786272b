"""What the forms of the solution cost as flown: theta functions, the third kind, Fourier series."""

from rigidsym.validate.forms import strata
from rigidsym.validate.forms.compare import COLUMNS, FormCosts, compare_forms

STRATA_COLUMNS = strata.COLUMNS
__all__ = ["COLUMNS", "STRATA_COLUMNS", "FormCosts", "compare_forms"]
