"""The closed-form solution in SymPy, with free symbols or with a motion's numbers."""

from rigidsym.solution._symbolic.forms import FORMS, of_motion, symbolic
from rigidsym.solution._symbolic.value import Symbolic

__all__ = ["FORMS", "Symbolic", "of_motion", "symbolic"]
